/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "parameters/declared_entry.h"

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "base/string_utilities.h"

namespace Contact
{
  namespace
  {
    bool contains(const std::string &text, const std::string &part)
    {
      return text.find(part) != std::string::npos;
    }
  } // namespace



  std::string unit_behind_number(const std::string &text)
  {
    static const std::regex number_and_unit(
      "(?:^|[\\s:,;])[-+]?(?:\\d+[.]?\\d*|[.]\\d+)(?:[eE][-+]?\\d+)?\\s*"
      "([A-Za-z%][^,;]*)");
    std::smatch found;
    return std::regex_search(text, found, number_and_unit)
             ? Utilities::trim(found[1])
             : "";
  }



  std::string DeclaredEntry::path() const
  {
    return section + "/" + name;
  }



  bool DeclaredEntry::is_map() const
  {
    return contains(pattern, "[Map");
  }



  bool DeclaredEntry::is_list() const
  {
    return contains(pattern, "[List");
  }



  std::string DeclaredEntry::separator() const
  {
    // The pattern says so at its end, unless it is a comma; a list inside of a
    // map may have another one.
    const std::string separated = "separated by <";
    const auto        position  = pattern.rfind(separated);
    return position == std::string::npos
             ? ","
             : pattern.substr(position + separated.size(), 1);
  }



  // Of a map that has them, as words: keys, or values.
  std::string DeclaredEntry::choices() const
  {
    const std::string selection = "[Selection ";
    const auto        first     = pattern.find(selection);
    if (first == std::string::npos)
      return "";
    const auto begin = first + selection.size();
    const auto names = pattern.substr(begin, pattern.find(' ', begin) - begin);
    const bool are_keys = contains(pattern.substr(begin), ">:<");
    return std::string("; ") + (are_keys ? "first" : "second") +
           " names: " + Utilities::replace_in_string(names, "|", ", ");
  }



  std::string DeclaredEntry::allowed_values() const
  {
    // ParameterHandler's own words for maps and lists are hard to read.
    const std::string item = contains(pattern, "[Double") ? "number" : "name";
    if (is_map() && is_list())
      return "any number of 'name: " + item + ", " + item +
             ", ...', separated by ';'";
    if (is_map())
      return "any number of 'name: " + (separator() == ";" ? "formula" : item) +
             "', separated by '" + separator() + "'" + choices();
    if (is_list())
      return "any number of " + item + "s, separated by ','";
    if (contains(pattern, "[Anything"))
      return "any text";
    if (contains(pattern, "[Double -MAX"))
      return "any number";

    std::string text = Patterns::pattern_factory(pattern)->description(
      Patterns::PatternBase::Text);
    for (const std::string no_bound : {" <= 2147483647", " <= MAX_DOUBLE"})
      text = Utilities::replace_in_string(text, no_bound, "");
    return lower_case(text.substr(0, 1)) + text.substr(1);
  }



  std::string DeclaredEntry::remedy(const std::string &value) const
  {
    const std::string allowed = "allowed: " + allowed_values();
    if (is_map() && contains(value, "?"))
      return "write if(condition, a, b) instead of 'condition ? a : b'; " +
             allowed;
    const bool is_number =
      contains(pattern, "[Double") || contains(pattern, "[Integer");
    const std::string unit = is_number ? unit_behind_number(value) : "";
    if (unit.empty())
      return allowed;
    const auto begin = documentation.find('[');
    const auto meant =
      documentation.substr(begin + 1,
                           documentation.find(']', begin) - begin - 1);
    return "numbers have no unit here, such as " + in_quotes(unit) +
           (begin == std::string::npos || meant == "-"
              ? std::string()
              : ": they are in " + meant) +
           "; " + allowed;
  }



  std::string DeclaredEntry::repeated_key(const std::string &value) const
  {
    if (!is_map())
      return "";
    std::set<std::string> keys;
    for (const std::string &element :
         Utilities::split_string_list(value, separator()))
      {
        const std::string key = split_at(element, element.find(':')).first;
        if (!keys.insert(key).second)
          return key;
      }
    return "";
  }



  std::vector<DeclaredEntry> declared_entries(const ParameterHandler &prm)
  {
    // The handler tells what it knows in no other form than in print.
    std::stringstream text;
    prm.print_parameters(text,
                         static_cast<ParameterHandler::OutputStyle>(
                           ParameterHandler::JSON |
                           ParameterHandler::KeepDeclarationOrder));

    const auto                 tree = nlohmann::ordered_json::parse(text);
    std::vector<DeclaredEntry> entries;
    for (const auto &section : tree.items())
      for (const auto &entry : section.value().items())
        {
          const auto &field = entry.value();
          if (field.contains("alias"))
            {
              const std::string name = field.at("alias");
              entries.push_back({section.key(), entry.key(), "", "", "", name});
              continue;
            }
          entries.push_back({section.key(),
                             entry.key(),
                             field.at("default_value"),
                             field.at("documentation"),
                             field.at("pattern_description")});
        }
    return entries;
  }
} // namespace Contact
