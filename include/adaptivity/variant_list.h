/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_variant_list_h
#define contact_variant_list_h

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "adaptivity/scene_variants.h"

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

    using Change = std::function<void(Parameters::All &changed)>;

    /// The scene with a change; nothing if its entries then contradict each
    /// other.
    void add(const std::string              &effect,
             const bool                      is_on,
             const std::vector<std::string> &entries,
             const Change                   &change)
    {
      const SceneVariant variant = make(effect, is_on, entries, change);
      if (variant.unknown.empty())
        all.push_back(variant);
    }

    /// The same, with the contradiction.
    void add_or_tell(const std::string              &effect,
                     const bool                      is_on,
                     const std::vector<std::string> &entries,
                     const Change                   &change)
    {
      all.push_back(make(effect, is_on, entries, change));
    }

    const Parameters::All    &scene;
    std::vector<SceneVariant> all;

  private:
    SceneVariant make(const std::string              &effect,
                      const bool                      is_on,
                      const std::vector<std::string> &entries,
                      const Change                   &change) const
    {
      SceneVariant variant{effect, is_on, entries, scene};
      change(variant.parameters);
      try
        {
          variant.parameters.check();
        }
      catch (const EntryError &error)
        {
          variant.unknown = error.problem;
        }
      return variant;
    }
  };



  /// A map as its entry has it.
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
