/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Parameter files in JSON.

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <istream>
#include <iterator>
#include <set>

#include "base/errors.h"
#include "base/string_utilities.h"
#include "parameters/json_file.h"
#include "parameters/parameter_file.h"

namespace Contact
{
  namespace
  {
    using Type = JsonValue::Type;

    bool is_include(const JsonValue &value)
    {
      return lower_case(value.name) == "include";
    }



    // ParameterHandler of other versions writes "Young_27s_20modulus". A name
    // of this program has no '_', unless it has a blank as well.
    std::string demangled(const std::string &name)
    {
      std::string result;
      for (std::size_t i = 0; i < name.size(); ++i)
        if (std::isalnum(static_cast<unsigned char>(name[i])))
          result += name[i];
        else if (name[i] == '_' && i + 2 < name.size() &&
                 std::isxdigit(static_cast<unsigned char>(name[i + 1])) &&
                 std::isxdigit(static_cast<unsigned char>(name[i + 2])))
          {
            result +=
              static_cast<char>(std::stoi(name.substr(i + 1, 2), nullptr, 16));
            i += 2;
          }
        else
          return name;
      return result;
    }



    std::string wrong_type(const JsonValue &value, const std::string &what)
    {
      return "There is " + value.description() + " where " + what +
             " has to be.";
    }



    // ParameterHandler writes an entry as an object with its value and what was
    // declared. A map has other names, unless its only one is "value".
    const JsonValue &value_of(const JsonValue &entry)
    {
      static const std::set<std::string> members = {"value",
                                                    "default_value",
                                                    "documentation",
                                                    "pattern",
                                                    "pattern_description",
                                                    "actions"};

      const JsonValue *value = entry.find("value");
      const bool       is_handlers =
        value != nullptr && std::all_of(entry.elements.begin(),
                                        entry.elements.end(),
                                        [](const JsonValue &member) {
                                          return members.count(member.name) > 0;
                                        });
      return is_handlers ? *value : entry;
    }



    // A value as a .prm file has it; whether it is allowed, its pattern tells.
    class ValueText
    {
    public:
      ValueText(const DeclaredEntry &entry, const std::string &place)
        : entry(entry)
        , place(place)
      {
      }

      std::string operator()(const JsonValue &value) const
      {
        if (value.type == Type::object && entry.is_map())
          return map(value);
        if (value.type == Type::array && entry.is_list() && !entry.is_map())
          return list(value, entry.separator());
        return scalar(value, "", "the value of " + entry.path());
      }

    private:
      std::string map(const JsonValue &value) const
      {
        const std::string separator = entry.separator();
        std::string       text;
        for (const JsonValue &element : value.elements)
          {
            JsonValue key;
            key.type = Type::scalar;
            key.text = element.name;
            text += (text.empty() ? "" : separator + " ") +
                    scalar(key, separator, "a name in " + entry.path()) + ": " +
                    (element.type == Type::array && entry.is_list()
                       ? list(element, separator + ",")
                       : scalar(element,
                                separator,
                                "the value of " + in_quotes(element.name) +
                                  " in " + entry.path()));
          }
        return text;
      }

      std::string list(const JsonValue   &value,
                       const std::string &separators) const
      {
        std::string text;
        for (const JsonValue &element : value.elements)
          text += (text.empty() ? "" : ", ") +
                  scalar(element, separators, "one element of " + entry.path());
        return text;
      }

      // The output printed afterwards has one line per entry, and separators
      // between elements only.
      std::string scalar(const JsonValue   &value,
                         const std::string &separators,
                         const std::string &what) const
      {
        const auto is_wrong = [&](const unsigned char c) {
          return std::iscntrl(c) || separators.find(c) != std::string::npos;
        };
        const std::string &text = value.text;
        if (value.type != Type::scalar ||
            std::any_of(text.begin(), text.end(), is_wrong))
          throw InputError(wrong_type(value, what),
                           entry.path() + " (" + place + ")",
                           "allowed: " + entry.allowed_values());
        return Utilities::trim(text);
      }

      const DeclaredEntry &entry;
      const std::string   &place;
    };
  } // namespace



  void ParameterReader::read_json(std::istream                &in,
                                  const std::filesystem::path &file)
  {
    if (!section.empty())
      throw InputError("A JSON file is included in section " +
                         in_quotes(section) + ".",
                       section_place.name,
                       "include it outside of the sections");

    const std::string text(std::istreambuf_iterator<char>(in), {});
    const JsonValue   tree = parse_json(text, file.string());
    if (tree.type != Type::object)
      throw InputError(wrong_type(tree, "an object of sections"),
                       place_in(file, 1).name,
                       "write {\"Mesh\": {\"File\": \"...\"}, ...}");

    // Elements of an object have no order: what a file includes comes first.
    for (const JsonValue &element : tree.elements)
      if (is_include(element))
        read_json_includes(element, place_in(file, element.line));
    for (const JsonValue &element : tree.elements)
      if (!is_include(element))
        read_json_section(element, file);
  }



  void ParameterReader::read_json_includes(const JsonValue &files,
                                           const Place     &place)
  {
    if (files.type == Type::array)
      for (const JsonValue &file : files.elements)
        read_json_includes(file, place);
    else if (files.type == Type::scalar)
      read_file((place.directory / files.text).lexically_normal(), place.name);
    else
      throw InputError(wrong_type(files, "the name of a file"),
                       place.name,
                       "write \"include\": [\"file\", \"file\"]");
  }



  void ParameterReader::read_json_section(const JsonValue             &value,
                                          const std::filesystem::path &file)
  {
    const std::string name  = with_single_blanks(demangled(value.name));
    const Place       place = place_in(file, value.line);
    if (value.type != Type::object)
      {
        declare_section(name);
        if (!has_section(name))
          find_entry("", name, place); // says that there is none
        throw InputError(wrong_type(value,
                                    "an object with the entries of section " +
                                      in_quotes(name)),
                         place.name,
                         "write {\"entry\": value, ...}");
      }

    enter_section(name, place);
    for (const JsonValue &entry : value.elements)
      read_json_entry(entry, place_in(file, entry.line));
    leave_section(place);
  }



  void ParameterReader::read_json_entry(const JsonValue &value,
                                        const Place     &place)
  {
    const std::string name = with_single_blanks(demangled(value.name));
    // Probes is a section and an entry of it.
    if (value.type == Type::object && has_section(name) && name != section)
      throw InputError("Section " + in_quotes(name) + " is inside section " +
                         in_quotes(section) + ".",
                       place.name,
                       "move it out: sections are not nested");

    // A former name, as ParameterHandler prints it.
    if (value.type == Type::object && value.find("alias") != nullptr)
      return;

    if (is_retired(section, name, place))
      return;
    const DeclaredEntry &entry = find_entry(section, name, place);
    set_once(entry,
             ValueText(entry, place.name)(value_of(value)),
             place,
             open_files.back().settings);
  }
} // namespace Contact
