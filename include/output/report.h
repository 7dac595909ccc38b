/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_report_h
#define contact_report_h

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/timer.h>

#include <memory>
#include <string>

#include "model/contact_model.h"
#include "output/body_results.h"
#include "output/result_files.h"
#include "output/screen.h"
#include "output/summary.h"
#include "verification/invariants.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The report of a run: lines on the screen and in log.txt, the time of its
   * phases, and its summary, which is written after each increment.
   */
  template<int dim>
  class Report
  {
  public:
    Report(const Parameters::All  &parameters,
           const ParameterHandler &prm,
           const MPI_Comm          communicator);

    const MPI_Comm communicator;

  private:
    RunLog run_log;

  public:
    /// The lines of iterations and loops, which the screen has if it is asked
    /// to have everything; and those that it has anyway.
    ConditionalOStream log, screen;

    TimerOutput timer;
    RunSummary  summary;

    /// That of the present increment.
    IncrementRecord &increment()
    {
      return summary.increments.back();
    }

    /// From here on the results of an earlier run are replaced; until this one
    /// ends, its summary says that it has not converged. One that is to go on
    /// replaces them only once it has found that it can.
    void open_files(const Discretization<dim> &discretization);

    /// The log gets the lines that there are already, and those to come.
    void open_log();

    bool has_files() const
    {
      return result_files != nullptr;
    }


    /// Results of a finer mesh replace those of the one before.
    void replace_results(const Discretization<dim> &discretization);

    ResultFiles<dim> &files()
    {
      return *result_files;
    }

    /// The size of the model, new on each mesh.
    void record_size(const ContactModel<dim> &model);

    /// An increment, or the attempt at one, begins; it has converged.
    void begin_increment(const unsigned int level,
                         const unsigned int increment,
                         const double       load_factor);
    void end_increment();

    /// The attempt at an increment has no solution, for this reason.
    void give_up_increment(const std::string &reason);

    /// One line for the increment, once all of its results are known.
    void print_increment();

    /// The effects that the scene switches on.
    void print_scene(const ContactModel<dim> &model, const std::string &system);

    void print_level(const ContactModel<dim> &model,
                     const unsigned int       level,
                     const std::string       &system);

    /// One line for a step of Newton's method.
    void print_step(const ContactModel<dim> &model,
                    const unsigned int       step,
                    const double             residual,
                    const unsigned int       n_changes);

    /// A Newton step was halved, and the residuals of the parts.
    void record_halvings(const std::vector<double> &residuals);

    /// The invariants of the present increment.
    void record(const Invariants &found);

    /// The distances of the bodies from the range of their materials, into the
    /// record of the increment; those of the @p last one are those of the run,
    /// and told, with that of the increment that was farthest beyond.
    void record(const std::map<std::string, BodyResult<dim>> &bodies,
                const bool                                    is_last);

    /// The strains and rotations; a note if they are beyond the range of the
    /// kinematics.
    void record(const StrainRange &range);

    /// The estimated effects, and by probe what the loops leave.
    void record(const std::vector<EffectEstimate>   &effects,
                const std::map<std::string, double> &loop_errors);

    /// Findings on the present increment, or before there is one, on the
    /// scene; see Contact::tell().
    void tell(const Findings &findings);

    void write_summary() const;

    /// Write history.csv, see write_history().
    void write_history() const;

    /// All parameters as a file of them, printed once: that takes as long as
    /// to check an increment.
    const std::string &used_parameters();

    /// The end of the run.
    void finish();

  private:
    HistoryUnits units() const;

    /// The sums at the end of the run.
    void print_end();

    /// The lines of the screen, which are written over the bar.
    std::ostream &lines();

    const Parameters::All            &parameters;
    const ParameterHandler           &prm;
    IncrementTable                    increment_table;
    ProgressBar                       progress;
    Timer                             increment_timer;
    std::string                       last_lines; // of the bodies, at the end
    std::string                       printed_parameters;
    std::unique_ptr<ResultFiles<dim>> result_files;
    const Discretization<dim> *discretization = nullptr; // once files are open
  };
} // namespace Contact

#endif
