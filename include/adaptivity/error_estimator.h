/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_error_estimator_h
#define contact_error_estimator_h

#include <list>

#include "adaptivity/contact_tractions.h"
#include "model/contact_model.h"
#include "solid/elasticity.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The distance of the stress of a cell from the recovered one, and of the
   * recovered one from the tractions on the boundary of the cell: the estimate
   * of Zienkiewicz and Zhu (Int. J. Numer. Methods Engrg. 24, 1987), which
   * estimates the error of the stress s_h by the recovered stress s* in its
   * place,
   *
   *   eta_T^2 = integral over T of (s* - s_h) : D^-1 : (s* - s_h)
   *           + sum over the boundary facets of T of
   *               h/E integral over the facet of |s* n - t|^2,
   *
   * D^-1 the compliance, in the plane that of plane strain, E Young's modulus,
   * h the size of the facet, in 2-D an edge. The traction t is that of
   * contact on slave and master, and zero elsewhere; components that a support
   * holds are left out. The second term is what lets the estimate see contact:
   * s* is an average over the cells of one body and knows nothing of the
   * pressure, which comes from the other.
   *
   * All values are squares, [N mm per mm of thickness; in 3-D N mm]: they add
   * up to eta^2,
   * of which deal.II's GridRefinement takes a fraction by default. eta itself,
   * the square root of the sum, is the error in the norm of the energy. With
   * elements of degree 1 it tends to the true one where the solution is smooth.
   * With degree 2 the recovered stress, linear in a cell, is only of the order
   * of the element's own: eta falls as fast as the error, but is 0.4 (9-node
   * quadrangles) to 0.65 (triangles) of it. It still tells where to refine. In
   * 3-D it is alike.
   *
   * Nodal forces: their energy is infinite, and no mesh
   * resolves them. Cells of the coarse mesh that touch a vertex with a nodal
   * force, and all that they are refined to, have the indicator zero. The
   * facets of a resultant force are left out. The force of a tie is no
   * multiplier: facets with a tied node are left out.
   */
  template<int dim>
  class ErrorEstimator
  {
  public:
    ErrorEstimator(const Discretization<dim> &discretization,
                   const Elasticity<dim>     &elasticity);

    /**
     * eta_T^2 by the index of the active cell, zero for cells of other
     * processes. @p vertex_stresses are those of StressRecovery, @p solution
     * holds the displacement and, unless @p interface is null (no contact), the
     * multipliers behind it.
     */
    Vector<float>
    indicators(const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
               const ContactInterface<dim>              *interface,
               const GhostedVector                      &solution) const;

  private:
    /// Data of facets that the boundary does not hold.
    struct Neighborhood
    {
      /// The cell, or numbers::invalid_unsigned_int if it is of another
      /// process or the facet is left out.
      unsigned int cell = numbers::invalid_unsigned_int;

      /// Vertices of the triangulation, in the order of the facet's nodes.
      std::vector<unsigned int> vertices;
    };

    void find_neighborhoods();

    void
    add_bulk_terms(const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
                   const GhostedVector                      &solution,
                   Vector<double>                           &eta_square) const;

    void add_boundary_terms(
      const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
      const ContactInterface<dim>              *interface,
      const GhostedVector                      &solution,
      Vector<double>                           &eta_square) const;

    double
    boundary_term(const unsigned int                        facet,
                  const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
                  const std::list<ContactTractions<dim>>   &contact,
                  const GhostedVector                      &solution) const;

    /// The traction s* n at a place of the boundary, by undeformed length.
    Tensor<1, dim> stress_traction(const SymmetricTensor<2, dim> &stress,
                                   const FacetPlace<dim>         &place,
                                   const types::material_id       body) const;

    /// What supports do not hold of a traction all over a facet.
    Tensor<1, dim> free_part(const SurfaceFacet<dim> &facet,
                             const Tensor<1, dim>    &traction) const;

    void clear_at_nodal_forces(Vector<double> &eta_square) const;

    const Discretization<dim> &discretization;
    const Elasticity<dim>     &elasticity;

    /// The whole boundary of all bodies.
    const Surface<dim>        boundary;
    std::vector<Neighborhood> neighborhoods; // of its facets
  };



  /**
   * Flag the cells by the indicators of ErrorEstimator, from the stresses at
   * the vertices, see flag_by_indicators().
   */
  template<int dim>
  void flag_by_estimate(const ContactModel<dim>                  &model,
                        const Parameters::All                    &parameters,
                        const std::vector<SymmetricTensor<2, 3>> &stresses,
                        const GhostedVector                      &solution);
} // namespace Contact

#endif
