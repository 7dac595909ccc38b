/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_string_utilities_h
#define contact_string_utilities_h

#include <string>
#include <utility>
#include <vector>

namespace Contact
{
  /// For messages; clipped and without control characters, because what a file
  /// has in it may be of any length, or no text at all.
  std::string in_quotes(const std::string &name);

  /// A number in a sentence: three digits of it.
  std::string brief(const double value);

  /// The coordinates of a place, with commas between them.
  template<typename Place>
  auto brief(const Place &place) -> decltype(place[0], std::string())
  {
    std::string text;
    for (unsigned int c = 0; c < Place::dimension; ++c)
      text += (c > 0 ? ", " : "") + brief(static_cast<double>(place[c]));
    return text;
  }

  /// In lower case, as far as it is ASCII.
  std::string lower_case(std::string text);

  /// Names are compared word by word: 'Gauss   points' is 'Gauss points'.
  std::string with_single_blanks(const std::string &text);

  /// The texts before and behind the character at @p position, trimmed; without
  /// one, std::string::npos, the second part is empty.
  std::pair<std::string, std::string> split_at(const std::string &text,
                                               const std::size_t  position);

  /// The position of the nearest word; if all are too far away to be what was
  /// meant, of the first that begins with it; their number if none does.
  std::size_t nearest(const std::string              &word,
                      const std::vector<std::string> &candidates);
} // namespace Contact

#endif
