/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "parameters/json_file.h"

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/errors.h"
#include "base/string_utilities.h"

namespace Contact
{
  using namespace dealii;

  namespace
  {
    using nlohmann::json;

    // A section, an entry as ParameterHandler writes it, a map and a list.
    constexpr unsigned int max_depth = 5;



    // Gets the values as they are read, for a tree would know neither the lines
    // nor the first of two equal names.
    class JsonReader : public nlohmann::json_sax<json>
    {
    public:
      JsonReader(const std::string &text, const std::string &file)
        : text(text)
        , file(file)
        , stream(text)
      {
      }

      JsonValue read()
      {
        json::sax_parse(stream, this);
        return root;
      }

      bool null() override
      {
        return add(JsonValue::Type::null);
      }

      bool boolean(const bool value) override
      {
        return add(JsonValue::Type::scalar, value ? "true" : "false");
      }

      bool number_integer(const json::number_integer_t value) override
      {
        return add(JsonValue::Type::scalar, std::to_string(value));
      }

      bool number_unsigned(const json::number_unsigned_t value) override
      {
        return add(JsonValue::Type::scalar, std::to_string(value));
      }

      bool number_float(const json::number_float_t,
                        const std::string &written) override
      {
        return add(JsonValue::Type::scalar, written);
      }

      bool string(std::string &value) override
      {
        return add(JsonValue::Type::scalar, value);
      }

      bool binary(json::binary_t &) override
      {
        return false; // there is none in a text
      }

      bool start_object(const std::size_t) override
      {
        return open(JsonValue::Type::object);
      }

      bool end_object() override
      {
        return close();
      }

      bool start_array(const std::size_t) override
      {
        return open(JsonValue::Type::array);
      }

      bool end_array() override
      {
        return close();
      }

      bool key(std::string &new_name) override
      {
        count_lines();
        name = new_name;

        const auto [earlier, is_new] = lines.back().insert({name, line});
        if (!is_new)
          throw InputError(in_quotes(name) + " is given twice.",
                           place(earlier->second) + ", " + place(line),
                           "keep one of the two");
        return true;
      }

      bool parse_error(const std::size_t n_bytes,
                       const std::string &,
                       const json::exception &error) override
      {
        // The last byte that was read is the wrong one, the end counts as one.
        const auto wrong =
          text.begin() +
          std::min(text.size(), std::max<std::size_t>(n_bytes, 1) - 1);
        const auto wrong_line = 1 + std::count(text.begin(), wrong, '\n');
        const auto begin_of_line =
          std::find(std::make_reverse_iterator(wrong), text.rend(), '\n');
        throw InputError(
          "This is no JSON: " + reason(error.what()) + ".",
          place(wrong_line) + ":" +
            std::to_string(wrong - begin_of_line.base() + 1),
          "names and texts are in double quotes, a ',' is between two "
          "elements only, and there are no comments");
      }

    private:
      bool add(const JsonValue::Type type, const std::string &value = "")
      {
        JsonValue &added =
          opened.empty() ? root : opened.back()->elements.emplace_back();
        added = {type, name, line, value, {}};
        name.clear();
        return true;
      }

      bool open(const JsonValue::Type type)
      {
        if (opened.size() == max_depth)
          {
            count_lines();
            throw InputError("There are " + std::to_string(max_depth + 1) +
                               " brackets inside each other.",
                             place(line),
                             "a file has sections, which have entries, which "
                             "have values, lists of them, or names with those");
          }
        add(type);
        opened.push_back(opened.empty() ? &root
                                        : &opened.back()->elements.back());
        lines.emplace_back();
        return true;
      }

      bool close()
      {
        opened.pop_back();
        lines.pop_back();
        return true;
      }

      // The parser says where it is in an error only, but the stream does.
      void count_lines()
      {
        const std::size_t now = stream.tellg();
        line += std::count(text.begin() + counted, text.begin() + now, '\n');
        counted = now;
      }

      std::string place(const unsigned int in_line) const
      {
        return file + ":" + std::to_string(in_line);
      }

      // The parser's message without its own name and place, and without what
      // was read: that may be long, and it is at this place.
      std::string reason(std::string message) const
      {
        if (dealii::Utilities::trim(text).empty())
          return "it is empty";
        const auto begin = message.find("syntax error");
        message.erase(0,
                      begin != std::string::npos ? begin
                                                 : message.find("] ") + 2);
        const auto token    = message.find("; last read");
        const auto expected = message.rfind("; expected");
        if (token != std::string::npos)
          message.erase(token,
                        expected > token && expected != std::string::npos
                          ? expected - token
                          : std::string::npos);
        return message.substr(0, 200); // a number may be long as well
      }

      const std::string &text;
      const std::string &file;
      std::istringstream stream;

      JsonValue                root;
      std::vector<JsonValue *> opened; // innermost last

      // Of the names of each of them.
      std::vector<std::map<std::string, unsigned int>> lines;

      std::string  name; // of the next value
      unsigned int line    = 1;
      std::size_t  counted = 0; // bytes whose line breaks are in it
    };
  } // namespace



  const JsonValue *JsonValue::find(const std::string &name) const
  {
    for (const JsonValue &element : elements)
      if (element.name == name)
        return &element;
    return nullptr;
  }



  std::string JsonValue::description() const
  {
    switch (type)
      {
        case Type::null:
          return "null";
        case Type::array:
          return "an array";
        case Type::object:
          return "an object";
        default:
          return in_quotes(text);
      }
  }



  JsonValue parse_json(const std::string &text, const std::string &file)
  {
    return JsonReader(text, file).read();
  }
} // namespace Contact
