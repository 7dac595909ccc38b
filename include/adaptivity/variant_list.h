/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_variant_list_h
#define contact_variant_list_h

#include <array>
#include <charconv>
#include <map>
#include <string>
#include <vector>

#include "adaptivity/scene_variants.h"
#include "base/string_utilities.h"

namespace Contact
{
  /// The variants of a scene as they are made.
  class Variants
  {
  public:
    explicit Variants(const Parameters::All &scene)
      : scene(scene)
    {
    }

    /// The scene with other entries; nothing if these contradict each other.
    void add(const std::string              &effect,
             const bool                      is_on,
             const std::vector<std::string> &entries)
    {
      const SceneVariant variant = make(effect, is_on, entries);
      if (variant.unknown.empty())
        all.push_back(variant);
    }

    /// The same, with the contradiction.
    void add_or_tell(const std::string              &effect,
                     const bool                      is_on,
                     const std::vector<std::string> &entries)
    {
      all.push_back(make(effect, is_on, entries));
    }

    const Parameters::All    &scene;
    std::vector<SceneVariant> all;

  private:
    // A handler of the entries sets what they are declared with.
    SceneVariant make(const std::string              &effect,
                      const bool                      is_on,
                      const std::vector<std::string> &entries) const
    {
      SceneVariant     variant{effect, is_on, entries, scene};
      Parameters::All &changed = variant.parameters;
      ParameterHandler prm;
      changed.add_parameters(prm);
      for (const auto &further : scene.further_contacts)
        changed.add_pair(further.first, prm);
      for (const std::string &assignment : entries)
        {
          const auto [path, value] = split_at(assignment, assignment.find('='));
          const auto [section, entry] = split_at(path, path.find('/'));
          prm.enter_subsection(section);
          prm.set(entry, value);
          prm.leave_subsection();
          changed.leave_out_pair(assignment);
        }
      try
        {
          changed.check();
        }
      catch (const EntryError &error)
        {
          variant.unknown = error.problem;
        }
      return variant;
    }
  };



  /// A map as its entry has it: numbers with all of their digits.
  inline std::string entry_of(const std::string                   &name,
                              const std::map<std::string, double> &values)
  {
    std::map<std::string, std::string> texts;
    for (const auto &[key, value] : values)
      {
        std::array<char, 32> text;
        texts[key].assign(
          text.data(),
          std::to_chars(text.data(), text.data() + text.size(), value).ptr);
      }
    return name + "=" + Patterns::Tools::to_string(texts);
  }



  template<typename Value>
  std::string entry_of(const std::string                  &name,
                       const std::map<std::string, Value> &values)
  {
    return name + "=" + Patterns::Tools::to_string(values);
  }



  /// One of formulas, which have commas of their own.
  inline std::string
  entry_of(const std::string                        &name,
           const std::map<std::string, std::string> &formulas)
  {
    std::string entry = name + "=";
    for (const auto &[key, formula] : formulas)
      entry += (entry.back() == '=' ? "" : "; ") + key + ": " + formula;
    return entry;
  }



  /// A map without a key.
  template<typename Value>
  std::map<std::string, Value> without(const std::string           &key,
                                       std::map<std::string, Value> values)
  {
    values.erase(key);
    return values;
  }
} // namespace Contact

#endif
