/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_declared_entry_h
#define contact_declared_entry_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace Contact
{
  using namespace dealii;

  /// An entry as it was declared in a ParameterHandler.
  struct DeclaredEntry
  {
    std::string section;
    std::string name;
    std::string default_value;
    std::string documentation;

    /// The pattern, as ParameterHandler describes it.
    std::string pattern;

    /// The present name, if this one is a former one.
    std::string alias_of = "";

    /// "Section/Name", the way messages and overrides name it.
    std::string path() const;

    /// Whether the value is 'name: item, name: item'.
    bool is_map() const;

    /// Whether the value is 'item, item'; of a map, whether its items are.
    bool is_list() const;

    /// The separator of the elements of a map or of a list.
    std::string separator() const;

    /// The names that a map has to be of, in words; if any.
    std::string choices() const;

    /// The values that the pattern allows, in words.
    std::string allowed_values() const;

    /// The remedy for a @p value that is not allowed.
    std::string remedy(const std::string &value) const;

    /// The key that @p value, which matches the pattern, gives twice; if any.
    std::string repeated_key(const std::string &value) const;
  };

  /// The word behind the first number that has one, as "GPa" in
  /// "Block: 70 GPa"; if any.
  std::string unit_behind_number(const std::string &text);

  /// All entries of @p prm in the order of their declaration.
  std::vector<DeclaredEntry> declared_entries(const ParameterHandler &prm);
} // namespace Contact

#endif
