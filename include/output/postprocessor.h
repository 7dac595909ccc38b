/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_postprocessor_h
#define contact_postprocessor_h

#include "contact/results/contact_results.h"
#include "model/increment_state.h"
#include "output/report.h"
#include "solid/stress_recovery.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The results of a state: probes, the contact zone in numbers, files for
   * ParaView and for curves. Stresses are recovered when one of them asks for
   * it.
   */
  template<int dim>
  class Postprocessor
  {
  public:
    Postprocessor(const Parameters::All   &parameters,
                  const ContactModel<dim> &model,
                  IncrementState<dim>     &state,
                  Report<dim>             &report);

    /// Check that the points of all probes exist, and carry what is asked for.
    /// Throws InputError. Collective.
    void check_probes() const;

    /// The state is another one.
    void clear_stresses()
    {
      stresses.clear();
    }

    /// Cauchy stresses at the vertices [MPa]. Collective.
    const std::vector<SymmetricTensor<2, 3>> &recovered_stresses();

    /// Equivalent plastic strains at the vertices [-] of the last increment
    /// that was accepted; none if no body yields. Collective.
    std::vector<double> recovered_plastic_strains();

    /// Into the record of the present increment.
    void record_increment();

    /// Results at the end of the increment @p k, or, where that is not reached,
    /// of the last state.
    void write_increment(const unsigned int k, const bool is_complete);

    /// The cost of this level, since the level before, its probes and the
    /// estimated @p errors of these, if any; at the last one these are those of
    /// the run.
    void record_level(const unsigned int level,
                      const bool         is_last,
                      const std::string &system,
                      const ProbeErrors &errors);

  private:
    ContactResults results(const ContactPair<dim> &contact_pair) const;
    void           record_rotations();

    /// Those that need stresses recovered, or the others.
    void record_probes(const bool with_recovery);

    double probe(const Parameters::Probes::Definition &definition);
    double value(const Parameters::Quantity quantity, const std::string &point);
    void   report_probes();

    const Parameters::All   &parameters;
    const ContactModel<dim> &model;
    IncrementState<dim>     &state; // which glue is turned in for a time
    Report<dim>             &report;

    std::unique_ptr<StressRecovery<dim>> recovery; // as it is asked for
    std::vector<SymmetricTensor<2, 3>>   stresses; // likewise
  };
} // namespace Contact

#endif
