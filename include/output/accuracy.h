/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_accuracy_h
#define contact_accuracy_h

#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "output/summary.h"
#include "parameters/parameters.h"

namespace Contact
{
  /// The gain and the price of more unknowns, by the rates of error and time
  /// from level to level.
  struct Forecast
  {
    double n_displacements = 0; // unknowns
    double seconds         = 0; // wall time of that level alone

    /// The errors of the probes by name, in their units.
    std::map<std::string, double> errors;
  };

  /// That of the mesh with @p growth times the unknowns of the last of these
  /// levels; none from a single level, or without estimated errors.
  std::optional<Forecast> forecast(const std::vector<LevelRecord> &levels,
                                   const double                    growth);

  /**
   * The meshes of a run: a number of levels, or as many as it takes for the
   * probes to be as accurate as asked for. Then each level may be the last one.
   */
  class Levels
  {
  public:
    /// The first one.
    explicit Levels(const Parameters::All &parameters)
      : parameters(parameters)
    {
    }

    /// That of the present mesh, from zero.
    unsigned int present() const
    {
      return number;
    }

    void advance()
    {
      ++number;
    }

    /// Whether the present level may be the last one, and has results, and
    /// whether one may follow.
    bool may_be_last() const
    {
      return parameters.asks_for_accuracy() ||
             number == parameters.refinement.n_levels;
    }
    bool may_be_followed() const
    {
      return parameters.asks_for_accuracy() ||
             number < parameters.refinement.n_levels;
    }

    /**
     * Whether a run ends with the last of these levels: the errors are as asked
     * for, or there is a limit. In @p missed why the accuracy is not reached,
     * or nothing. An error that is small may be so by chance, where parts of it
     * cancel: the value with its error put right has to be the same on two
     * levels, to that accuracy, and neither it nor the value may lead further
     * by how they go on over three. Without estimates: error_by_values() on
     * three meshes. A part of a probe that is zero within its error on three
     * meshes is never reached.
     */
    bool end_with(const std::vector<LevelRecord> &levels,
                  std::string                    &missed) const;

  private:
    std::string inaccurate(const std::vector<LevelRecord> &levels) const;
    std::string broken_limit(const std::vector<LevelRecord> &levels) const;

    const Parameters::All &parameters;
    unsigned int           number = 0;
  };



  /// The error of a probe on the mesh of the level @p number, its values alone
  /// being known: the step from the mesh before, which is no less than it if an
  /// error at least halves with that; or where the values of three meshes lead
  /// to. A step that is less than an eighth of the one before is so by chance:
  /// at the edge of contact solutions are no smoother than H^(5/2), and values
  /// gain no more than h^3; behind a step the other way, one that is less than
  /// half. Infinite on the first mesh, and of a value that has been zero on
  /// three, as of plastic strains and pressures where nothing acts yet.
  double error_by_values(const std::vector<LevelRecord> &levels,
                         const unsigned int              number,
                         const std::string              &probe);

  /// The error of a probe on the level @p number that a run believes, by
  /// estimates: twice the estimated error, which is trusted to that factor and
  /// mostly much better; or how far its value on a fine mesh, as estimated on
  /// this level, is from that of the level before, which was less accurate; or
  /// where the values of the last three lead to. Without estimates by the
  /// values: error_by_values().
  double believed_error(const std::vector<LevelRecord> &levels,
                        const unsigned int              number,
                        const std::string              &probe);

  /// Why no estimate of the error on this level is believed, or nothing: a
  /// traction in a zone of contact that the mesh does not resolve, or a value
  /// that has gone on in equal steps over four meshes, as a logarithm.
  std::string doubt(const std::vector<LevelRecord> &levels,
                    const unsigned int              number,
                    const std::string              &probe);

  /// Whether the level before confirms believed_error(): the first one has
  /// none, and at a corner in contact an estimate sees a part of the error.
  bool is_confirmed(const std::vector<LevelRecord> &levels,
                    const unsigned int              number,
                    const std::string              &probe);

  /// Whether the level @p number and the one before it estimate the same limit
  /// of a probe, and the last three lead there, as far as the error of this
  /// level can tell: then errors have a rate; the first one does not, nor at a
  /// corner in contact. Without estimates, whether steps from mesh to mesh at
  /// least halve.
  bool agrees_with_last(const std::vector<LevelRecord> &levels,
                        const unsigned int              number,
                        const std::string              &probe);

  /**
   * Print what the accuracy of each probe has cost: by level the unknowns, the
   * value, its error, estimated or by values, and the wall time so far; and
   * what the next digit would cost. Nothing of a single mesh without estimates.
   */
  void print_accuracy(std::ostream &out, const RunSummary &summary);
} // namespace Contact

#endif
