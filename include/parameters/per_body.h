/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_per_body_h
#define contact_per_body_h

#include <deal.II/base/utilities.h>

#include <map>
#include <string>

#include "parameters/choices.h"

namespace Contact
{
  using namespace dealii;

  namespace Parameters
  {
    /// One of the values of an enum for all bodies, or 'body: value' for each,
    /// separated by ','. Names of values are checked by whoever asks for them.
    template<typename Enum>
    class PerBody
    {
    public:
      PerBody(const Enum value)
        : PerBody(Choice<Enum>(value).name())
      {
      }

      PerBody(const std::string &text)
        : text(text)
      {
        if (text.find(':') == std::string::npos)
          return;
        for (const std::string &item : Utilities::split_string_list(text, ','))
          {
            const auto colon = item.find(':');
            names[Utilities::trim(item.substr(0, colon))] =
              colon == std::string::npos
                ? ""
                : Utilities::trim(item.substr(colon + 1));
          }
      }

      /// As it was set, and by body unless it is for all.
      const std::string &name() const
      {
        return text;
      }
      const std::map<std::string, std::string> &by_body() const
      {
        return names;
      }

      bool is_allowed() const
      {
        const auto is_value = [](const std::string &name) {
          for (const auto &named : named_values(Enum()))
            if (named.first == name)
              return true;
          return false;
        };
        for (const auto &[body, name] : names)
          if (!is_value(name))
            return false;
        return !names.empty() || is_value(text);
      }

      Enum of(const std::string &body) const
      {
        const auto found = names.find(body);
        return Choice<Enum>(found == names.end() ? text : found->second);
      }

      bool all_are(const Enum value) const
      {
        const std::string wanted = Choice<Enum>(value).name();
        for (const auto &[body, name] : names)
          if (name != wanted)
            return false;
        return !names.empty() || text == wanted;
      }

    private:
      std::string                        text;
      std::map<std::string, std::string> names;
    };
  } // namespace Parameters
} // namespace Contact



namespace dealii
{
  namespace Patterns
  {
    namespace Tools
    {
      /// For ParameterHandler::add_parameter().
      template<typename Enum>
      struct Convert<Contact::Parameters::PerBody<Enum>>
      {
        using PerBody = Contact::Parameters::PerBody<Enum>;

        static std::unique_ptr<PatternBase> to_pattern()
        {
          return std::make_unique<Anything>();
        }

        static std::string
        to_string(const PerBody &values,
                  const PatternBase & = *Convert<PerBody>::to_pattern())
        {
          return values.name();
        }

        static PerBody
        to_value(const std::string &text,
                 const PatternBase & = *Convert<PerBody>::to_pattern())
        {
          return PerBody(text);
        }
      };
    } // namespace Tools
  }   // namespace Patterns
} // namespace dealii

#endif
