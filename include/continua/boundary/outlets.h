#ifndef continua_boundary_outlets_h
#define continua_boundary_outlets_h

#include <continua/boundary/boundary_condition.h>
#include <continua/materials/material.h>

#include <deal.II/grid/tria.h>

#include <vector>

namespace Continua
{
/// The part of the section of a boundary that the mesh has [1]: of a disc around the x axis,
/// else 1.
template <int dim>
double fraction_of_section(const BoundaryCondition &condition,
                           const dealii::Triangulation<dim> &coarse_mesh);

/**
 * The outlets of the conditions that name their impedance (resistance, windkessel), for the part of
 * the section that the mesh has: Q of a quarter of a tube is a quarter of the tube's, so that its
 * impedance is four times as large. A section that is no part of a disc around the x axis is taken
 * as whole; in axisymmetry the whole circumference counts. `boundaries` is the section that the
 * conditions were read from. To be called after set_flow_profiles(). Throws InputError for an
 * outlet of a solid.
 */
template <int dim>
std::vector<Outlet> make_outlets(const std::vector<BoundaryCondition> &conditions,
                                 ParameterSection boundaries,
                                 const dealii::Triangulation<dim> &coarse_mesh,
                                 const std::vector<Material> &materials);
} // namespace Continua

#endif
