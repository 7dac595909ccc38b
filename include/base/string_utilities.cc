/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "base/string_utilities.h"

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <numeric>
#include <sstream>

namespace Contact
{
  using namespace dealii;

  namespace
  {
    // Levenshtein's distance: insertions, deletions and replacements that
    // turn one word into the other. Only one row of the table is kept.
    std::size_t edit_distance(const std::string &a, const std::string &b)
    {
      std::vector<std::size_t> row(b.size() + 1);
      std::iota(row.begin(), row.end(), 0);
      for (std::size_t i = 0; i < a.size(); ++i)
        {
          std::size_t diagonal = row[0]++;
          for (std::size_t j = 0; j < b.size(); ++j)
            {
              const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
              diagonal                   = row[j + 1];
              row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
            }
        }
      return row.back();
    }
  } // namespace



  std::string in_quotes(const std::string &name)
  {
    std::string text = name.substr(0, 200);
    for (char &c : text)
      if (std::iscntrl(static_cast<unsigned char>(c)))
        c = '?';
    return "'" + text + (name.size() > text.size() ? "..." : "") + "'";
  }



  std::string brief(const double value)
  {
    std::ostringstream out;
    out.precision(3);
    out << value;
    return out.str();
  }



  std::string lower_case(std::string text)
  {
    for (char &c : text)
      c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
  }



  std::string with_single_blanks(const std::string &text)
  {
    std::istringstream words(text);
    std::string        word, result;
    while (words >> word)
      result += (result.empty() ? "" : " ") + word;
    return result;
  }



  std::pair<std::string, std::string> split_at(const std::string &text,
                                               const std::size_t  position)
  {
    if (position == std::string::npos)
      return {Utilities::trim(text), ""};
    return {Utilities::trim(text.substr(0, position)),
            Utilities::trim(text.substr(position + 1))};
  }



  std::size_t nearest(const std::string              &word,
                      const std::vector<std::string> &candidates)
  {
    std::size_t best = candidates.size();
    // Nobody means a word by that, and comparing takes its length.
    if (word.size() > 1000)
      return best;
    std::size_t shortest = std::max<std::size_t>(2, word.size() / 3) + 1;
    for (std::size_t i = 0; i < candidates.size(); ++i)
      {
        const std::size_t distance =
          edit_distance(lower_case(word), lower_case(candidates[i]));
        if (distance < shortest)
          {
            shortest = distance;
            best     = i;
          }
      }
    if (best < candidates.size() || word.empty())
      return best;
    return std::find_if(candidates.begin(),
                        candidates.end(),
                        [&](const std::string &candidate) {
                          return lower_case(candidate).rfind(lower_case(word),
                                                             0) == 0;
                        }) -
           candidates.begin();
  }
} // namespace Contact
