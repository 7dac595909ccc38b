/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_parameter_file_h
#define contact_parameter_file_h

#include <deal.II/base/parameter_handler.h>

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include "base/findings.h"
#include "parameters/declared_entry.h"

namespace Contact
{
  using namespace dealii;

  struct JsonValue;



  /**
   * Reads parameter files into a ParameterHandler. The reader of
   * ParameterHandler itself forgets where an entry was set, which the messages
   * of this program tell. Sections are not nested here. JSON is read by
   * parameter_json.cc.
   */
  class ParameterReader
  {
  public:
    /// The function that declares a section of which there may be several.
    using Declare = std::function<void(const std::string &name)>;

    /// The entries have to be declared in @p prm already, but for those of the
    /// sections "@p kind NAME", which @p declare declares.
    ParameterReader(ParameterHandler  &prm,
                    const std::string &kind,
                    const Declare     &declare);

    /// The notes on statements so far.
    Findings findings;

    /// Read a file and what it includes, JSON if its name ends so. @p asked_by
    /// is the statement that asks for it.
    void read_file(const std::filesystem::path &file,
                   const std::string           &asked_by = "command line");

    /// Set one entry from the command line: "Section/Entry=value".
    void read_override(const std::string &assignment);

    /// Make the path in an entry, if there is one, absolute: it is relative to
    /// the directory of the file that sets it.
    void resolve_path(const std::string &section, const std::string &name);

    /// Entries "Section/Entry" with where they were set, for messages.
    std::string where(const std::vector<std::string> &paths) const;

    /// Note which of these entries the main file itself sets although they
    /// have no effect: by "Section/Entry" why.
    void note_idle(const std::map<std::string, std::string> &reasons);

  private:
    /// The place of a statement, and the directory that paths in it are
    /// relative to.
    struct Place
    {
      std::string           name;
      std::filesystem::path directory;
    };

    /// The entries that were set, and the place.
    using Settings = std::map<std::string, Place>;

    /// A file that is being read: the section it was included in, and what it
    /// sets itself.
    struct OpenFile
    {
      std::filesystem::path path;
      std::string           outer_section;
      Settings              settings;
    };

    static Place place_in(const std::filesystem::path &file,
                          const unsigned int           line)
    {
      return {file.string() + ":" + std::to_string(line), file.parent_path()};
    }

    void read_prm(std::istream &in, const std::filesystem::path &file);
    void read_json(std::istream &in, const std::filesystem::path &file);

    void read_statement(const std::string &statement, const Place &place);
    void enter_section(const std::string &name, const Place &place);
    void leave_section(const Place &place);
    void read_assignment(const std::string &in_section,
                         const std::string &assignment,
                         const Place       &place,
                         Settings          &set_before);
    void read_json_includes(const JsonValue &files, const Place &place);
    void read_json_section(const JsonValue             &value,
                           const std::filesystem::path &file);
    void read_json_entry(const JsonValue &value, const Place &place);
    void set_once(const DeclaredEntry &entry,
                  const std::string   &value,
                  const Place         &place,
                  Settings            &set_before);
    void set(const DeclaredEntry &entry,
             const std::string   &value,
             const Place         &place);

    /// Declare a section if it is one of those there may be several of.
    void declare_section(const std::string &name);

    void note(const Place &place, const std::string &text);

    /// Whether an entry is a former one without a successor, with a note.
    bool is_retired(const std::string &in_section,
                    const std::string &name,
                    const Place       &place);

    /// The name that a value has now.
    std::string present_value(const DeclaredEntry &entry,
                              const std::string   &value,
                              const Place         &place);

    bool                 has_section(const std::string &name) const;
    const DeclaredEntry &find_entry(const std::string &in_section,
                                    const std::string &name,
                                    const Place       &place);
    std::string          nearest_section(const std::string &name) const;
    std::string          nearest_entry(const std::string &in_section,
                                       const std::string &name) const;

    ParameterHandler          &prm;
    const std::string          kind;
    const Declare              declare;
    std::vector<DeclaredEntry> entries;

    std::string           main_file;  // the one that may include others
    std::vector<OpenFile> open_files; // innermost last
    std::string           section;    // the open one, or none
    Place                 section_place;

    Settings settings;
    Settings overrides;
  };
} // namespace Contact

#endif
