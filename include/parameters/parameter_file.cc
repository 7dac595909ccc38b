/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "parameters/parameter_file.h"

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <fstream>

#include "base/errors.h"
#include "base/files.h"
#include "base/string_utilities.h"

namespace Contact
{
  namespace
  {
    using Names = std::vector<std::string>;

    struct Statement
    {
      unsigned int line;
      std::string  text;
    };



    // A backslash at the very end of a line joins it with the next one, and
    // only then a comment is cut off, as ParameterHandler does it.
    std::vector<Statement> read_statements(std::istream &in)
    {
      std::vector<Statement> statements;
      std::string            text;
      bool                   joined = false;
      for (unsigned int line = 1; std::getline(in, text); ++line)
        {
          text = Utilities::trim(text);
          if (!joined)
            statements.push_back({line, ""});
          joined = !text.empty() && text.back() == '\\';
          if (joined)
            text.pop_back();
          statements.back().text += text;
        }
      for (Statement &statement : statements)
        statement.text =
          Utilities::trim(statement.text.substr(0, statement.text.find('#')));
      return statements;
    }
  } // namespace



  ParameterReader::ParameterReader(ParameterHandler  &prm,
                                   const std::string &kind,
                                   const Declare     &declare)
    : prm(prm)
    , kind(kind)
    , declare(declare)
    , entries(declared_entries(prm))
  {
  }



  void ParameterReader::read_file(const std::filesystem::path &file,
                                  const std::string           &asked_by)
  {
    std::ifstream in(file);
    if (!in || std::filesystem::is_directory(file))
      throw InputError("There is no parameter file " +
                         in_quotes(file.string()) + ".",
                       asked_by,
                       "correct the name; an included file is relative to "
                       "the file that includes it");

    const auto path = std::filesystem::weakly_canonical(file);
    for (const OpenFile &open_file : open_files)
      if (open_file.path == path)
        throw InputError(in_quotes(file.string()) + " includes itself.",
                         asked_by,
                         "remove this include");

    if (main_file.empty())
      main_file = file.string();
    open_files.push_back({path, section, {}});
    skip_byte_order_mark(in);
    if (file.extension() == ".json")
      read_json(in, file);
    else
      read_prm(in, file);
    open_files.pop_back();
  }



  void ParameterReader::read_override(const std::string &assignment)
  {
    const Place place = {"--set '" + assignment + "'", ""};
    const auto  slash =
      assignment.substr(0, assignment.find('=')).find_last_of('/');
    if (slash == std::string::npos)
      throw InputError(in_quotes(assignment) + " names no section.",
                       place.name,
                       "write --set 'Section/Entry=value'");

    const auto [in_section, rest] = split_at(assignment, slash);
    read_assignment(with_single_blanks(in_section), rest, place, overrides);
  }



  void ParameterReader::resolve_path(const std::string &in_section,
                                     const std::string &name)
  {
    const auto setting = settings.find(in_section + "/" + name);
    prm.enter_subsection(in_section);
    if (setting != settings.end() && !prm.get(name).empty())
      prm.set(name,
              std::filesystem::absolute(setting->second.directory /
                                        prm.get(name))
                .lexically_normal()
                .string());
    prm.leave_subsection();
  }



  std::string ParameterReader::where(const Names &paths) const
  {
    std::string text;
    bool        is_set = false;
    for (const std::string &path : paths)
      {
        const auto setting = settings.find(path);
        text += (text.empty() ? "" : ", ") + path + " (" +
                (setting == settings.end() ? "default" : setting->second.name) +
                ")";
        is_set = is_set || setting != settings.end();
      }
    // The file that lacks them.
    return is_set ? text : main_file + ", " + text;
  }



  void ParameterReader::read_prm(std::istream                &in,
                                 const std::filesystem::path &file)
  {
    for (const Statement &statement : read_statements(in))
      read_statement(statement.text, place_in(file, statement.line));
    if (section != open_files.back().outer_section)
      throw InputError("Section " + in_quotes(section) + " is not closed.",
                       section_place.name,
                       "add the missing 'end'");
  }



  void ParameterReader::read_statement(const std::string &statement,
                                       const Place       &place)
  {
    const auto [keyword, rest] =
      split_at(statement, statement.find_first_of(" \t"));
    const std::string action = lower_case(keyword);

    if (statement.empty())
      return;
    else if (action == "subsection" && !rest.empty())
      enter_section(with_single_blanks(rest), place);
    else if (action == "end" && rest.empty())
      leave_section(place);
    else if (action == "include" && !rest.empty())
      read_file((place.directory / rest).lexically_normal(), place.name);
    else if (action == "set")
      read_assignment(section, rest, place, open_files.back().settings);
    else
      throw InputError(in_quotes(statement) + " is not understood.",
                       place.name,
                       "a line is 'subsection name', 'set name = value', "
                       "'include file' or 'end'; a comment starts with #");
  }



  void ParameterReader::enter_section(const std::string &name,
                                      const Place       &place)
  {
    if (!section.empty())
      throw InputError("Section " + in_quotes(name) +
                         " starts inside section " + in_quotes(section) + ".",
                       place.name + ", " + section_place.name,
                       "close " + in_quotes(section) + " with 'end' first");
    declare_section(name);
    if (!has_section(name))
      throw InputError("There is no section " + in_quotes(name) + ".",
                       place.name,
                       nearest_section(name));
    section       = name;
    section_place = place;
  }



  void ParameterReader::leave_section(const Place &place)
  {
    // A file closes what it opens, not the section it is included in.
    if (section == open_files.back().outer_section)
      throw InputError("There is no section to end.",
                       place.name,
                       "remove this 'end'");
    section = "";
  }



  void ParameterReader::read_assignment(const std::string &in_section,
                                        const std::string &assignment,
                                        const Place       &place,
                                        Settings          &set_before)
  {
    const auto equal_sign = assignment.find('=');
    if (equal_sign == std::string::npos)
      throw InputError(in_quotes(assignment) + " is given no value.",
                       place.name,
                       "write a '=' between the name and the value");

    const auto [text, value] = split_at(assignment, equal_sign);
    const std::string name   = with_single_blanks(text);
    declare_section(in_section);
    if (!is_retired(in_section, name, place))
      set_once(find_entry(in_section, name, place), value, place, set_before);
  }



  void ParameterReader::set_once(const DeclaredEntry &entry,
                                 const std::string   &value,
                                 const Place         &place,
                                 Settings            &set_before)
  {
    const auto [earlier, is_new] = set_before.insert({entry.path(), place});
    if (!is_new)
      throw InputError(entry.path() + " is set twice.",
                       earlier->second.name + ", " + place.name,
                       "keep one of the two");
    set(entry, value, place);
  }



  void ParameterReader::note(const Place &place, const std::string &text)
  {
    tell({text, /*is_violated=*/false, place.name}, findings);
  }



  bool ParameterReader::is_retired(const std::string &in_section,
                                   const std::string &name,
                                   const Place       &place)
  {
    const std::string compare =
      "results are compared with closed forms by tests/closed_forms";
    const std::string fixed = "its default serves all scenes";
    const std::map<std::string, std::string> retired{
      {"Probes/Hertz", compare},
      {"Probes/Frictional theory", compare},
      {"Probes/Concentric cylinders", compare},
      {"Probes/Halve increments", "compare with a run with twice as many"},
      {"Solution/Max geometry iterations", fixed},
      {"Solution/Max friction iterations", fixed}};
    const std::string path  = in_section + "/" + name;
    const auto        found = retired.find(path);
    if (found != retired.end())
      note(place, path + " is no longer read: " + found->second + ".");
    return found != retired.end();
  }



  void
  ParameterReader::note_idle(const std::map<std::string, std::string> &reasons)
  {
    for (const auto &[path, reason] : reasons)
      if (settings.count(path) > 0 &&
          settings.at(path).name.rfind(main_file, 0) == 0)
        note(settings.at(path), path + " has no effect: " + reason + ".");
  }



  std::string ParameterReader::present_value(const DeclaredEntry &entry,
                                             const std::string   &value,
                                             const Place         &place)
  {
    // A bound that followed from step to step found what Newton's method does.
    static const std::map<std::pair<std::string, std::string>, std::string>
      former{{{"Solution/Friction", "each step"}, "Newton"},
             {{"Solution/Friction", "lagged bound"}, "Newton"},
             {{"Element/Centre node", "bound"}, "serendipity"},
             {{"Solids/Dilatation", "projected"}, "B-bar"}};
    if (entry.path() == "Boundary conditions/Histories")
      return Utilities::replace_in_string(value,
                                          "Spread force ",
                                          "Resultant force ");
    const auto found = former.find({entry.path(), value});
    if (found == former.end())
      return value;
    note(place,
         "'" + value + "' of " + entry.path() + " is now called '" +
           found->second + "'.");
    return found->second;
  }



  void ParameterReader::set(const DeclaredEntry &entry,
                            const std::string   &value,
                            const Place         &place)
  {
    const std::string entry_and_place = entry.path() + " (" + place.name + ")";
    prm.enter_subsection(entry.section);
    try
      {
        prm.set(entry.name, present_value(entry, value, place));
      }
    catch (const ParameterHandler::ExcValueDoesNotMatchPattern &)
      {
        prm.leave_subsection();
        throw InputError(in_quotes(value) + " is not allowed for " +
                           entry.path() + ".",
                         entry_and_place,
                         entry.remedy(value));
      }
    prm.leave_subsection();
    settings[entry.path()] = place;

    // A map keeps the first of two equal keys and forgets the other.
    const std::string key = entry.repeated_key(value);
    if (!key.empty())
      throw InputError(in_quotes(key) + " is given twice in " + entry.path() +
                         ".",
                       entry_and_place,
                       "keep one of the two");
  }



  void ParameterReader::declare_section(const std::string &name)
  {
    const std::string begin = kind + " ";
    if (name.compare(0, begin.size(), begin) != 0 || has_section(name))
      return;
    declare(name.substr(begin.size()));
    entries = declared_entries(prm);
  }



  bool ParameterReader::has_section(const std::string &name) const
  {
    return std::any_of(entries.begin(),
                       entries.end(),
                       [&](const DeclaredEntry &entry) {
                         return entry.section == name;
                       });
  }



  const DeclaredEntry &
  ParameterReader::find_entry(const std::string &in_section,
                              const std::string &name,
                              const Place       &place)
  {
    for (const DeclaredEntry &entry : entries)
      if (entry.section == in_section && entry.name == name)
        {
          if (entry.alias_of.empty())
            return entry;
          note(place,
               "The entry " + entry.path() + " is now called '" +
                 entry.alias_of + "'.");
          return find_entry(in_section, entry.alias_of, place);
        }

    if (!in_section.empty() && !has_section(in_section))
      throw InputError("There is no section " + in_quotes(in_section) + ".",
                       place.name,
                       nearest_section(in_section));
    throw InputError("There is no entry " + in_quotes(name) +
                       (in_section.empty()
                          ? std::string(" outside of the sections.")
                          : " in section " + in_quotes(in_section) + "."),
                     place.name,
                     nearest_entry(in_section, name));
  }



  std::string ParameterReader::nearest_section(const std::string &name) const
  {
    Names sections;
    for (const DeclaredEntry &entry : entries)
      if (sections.empty() || sections.back() != entry.section)
        sections.push_back(entry.section);

    const std::size_t i = nearest(name, sections);
    if (i < sections.size())
      return "did you mean " + in_quotes(sections[i]) + "?";

    std::string all;
    for (const std::string &known : sections)
      all += (all.empty() ? "" : ", ") + known;
    return "the sections are: " + all;
  }



  std::string ParameterReader::nearest_entry(const std::string &in_section,
                                             const std::string &name) const
  {
    // A slip of the pen is more likely than the wrong section.
    Names here, everywhere, paths;
    for (const DeclaredEntry &entry : entries)
      if (entry.alias_of.empty())
        {
          if (entry.section == in_section)
            here.push_back(entry.name);
          everywhere.push_back(entry.name);
          paths.push_back(entry.path());
        }

    std::size_t i = nearest(name, here);
    if (i < here.size())
      return "did you mean " + in_quotes(here[i]) + "?";
    i = nearest(name, everywhere);
    if (i < everywhere.size())
      return "did you mean " + in_quotes(paths[i]) + "?";
    return "'contact --parameters' lists the entries";
  }
} // namespace Contact
