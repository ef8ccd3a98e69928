#include <continua/case/rules/deformation_checks.h>

#include <continua/case/theory/loaded_tube_case.h>
#include <continua/network/network_parameters.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Continua
{
namespace
{
/// A region that is stretched in the shape of the mesh, which is not in balance.
void check_prestretch(const Problem &problem, const unsigned int region, ParameterSection root)
{
  // After the inverse solve the body has the shape of the mesh.
  if (problem.finds_unloaded_shape() || !problem.materials[region].prestretch.exists())
    return;
  for (const BoundaryCondition &condition : problem.conditions)
    if (condition.region_ids.count(region) > 0 &&
        (condition.normal.stiffness > 0. || condition.tangential.stiffness > 0.))
      root.subsection("Boundaries")
          .subsection(condition.name)
          .refuse("Type",
                  "springs of a support count from the shape of the mesh, which a region with a "
                  "prestretch never has",
                  "Give the support dampers and a pressure alone, or remove the prestretch");
}

bool has_network(const BoundaryCondition &condition)
{
  return condition.outlet && condition.outlet->network;
}

/// Whether something acts on a boundary at t = 0, or may act somewhere on it.
bool may_load_at_start(const BoundaryCondition &condition)
{
  const double origin[3] = {0., 0., 0.};
  // Others may act somewhere else than at the origin.
  const bool has_one_value =
      condition.normal.vector.empty() && !condition.normal.along_normal.depends_on_space();
  return condition.is_supported() || !condition.initial_jump(origin).empty() ||
         (has_network(condition) && condition.outlet->network->initial_pressure != 0.) ||
         !condition.tangential.is_zero() || (!has_one_value && !condition.normal.is_zero());
}

/// A mesh that has the shape under the loads of the start.
void check_unloaded_shape(const Problem &problem, ParameterSection root)
{
  if (!problem.interior.body_force.empty() ||
      std::any_of(problem.conditions.begin(), problem.conditions.end(), may_load_at_start))
    return;
  for (const BoundaryCondition &condition : problem.conditions)
  {
    if (has_network(condition))
      root.subsection("Boundaries")
          .subsection(condition.name)
          .refuse("",
                  "at t = 0 nothing flows in and the network has no pressure: the liquid has none "
                  "either, and the shape of the mesh would be the one without load",
                  "Give Network/Initial pressure, the pressure at which the image was taken, or "
                  "set Unloaded shape = mesh");
    if (condition.type == BoundaryType::windkessel && condition.outlet->initial_states.empty())
      root.subsection("Boundaries")
          .subsection(condition.name)
          .refuse("",
                  "at t = 0 nothing flows in and the windkessel has no charge: the liquid has no "
                  "pressure, and the shape of the mesh would be the one without load",
                  "Add 'set Initial pressure = ...', the pressure at which the image was taken, or "
                  "set Unloaded shape = mesh");
  }
}

/// The volume that a boundary encloses in the coarse mesh, see CavityVolumes, over the area of its
/// faces times their largest distance from the origin; 0 without faces.
template <int dim>
double enclosed_share(const Case<dim> &input, const BoundaryCondition &condition)
{
  // High, since a coarse face may stand for a large part of a circle.
  constexpr unsigned int degree = 6;
  const bool is_in_plane = dim == 2 && input.problem.model != Model::axisymmetric;
  const dealii::MappingQ<dim> mapping(degree);
  const dealii::FE_Nothing<dim> element;
  dealii::FEFaceValues<dim> values(mapping, element, dealii::QGauss<dim - 1>(degree + 1),
                                   dealii::update_quadrature_points |
                                       dealii::update_normal_vectors | dealii::update_JxW_values);
  double volume = 0., size = 0.;
  for (const auto &cell : input.triangulation->cell_iterators_on_level(0))
    for (const unsigned int f : cell->face_indices())
    {
      if (!cell->face(f)->at_boundary() || cell->face(f)->boundary_id() != condition.boundary_id ||
          condition.region_ids.count(cell->material_id()) == 0)
        continue;
      values.reinit(cell, f);
      for (const unsigned int q : values.quadrature_point_indices())
        for (unsigned int c = is_in_plane ? 0 : 1; c < dim; ++c)
        {
          const double place = values.quadrature_point(q)[c];
          volume -= place * values.normal_vector(q)[c] * values.JxW(q);
          size += std::abs(place) * values.JxW(q);
        }
    }
  return size > 0. ? volume / size : 0.;
}

/// Where the volume of a cavity cannot be held.
template <int dim>
void check_cavity(const Case<dim> &input, const BoundaryCondition &condition, ParameterSection root)
{
  ParameterSection section = root.subsection("Boundaries").subsection(condition.name);
  constexpr double least_share = 1e-6;
  if (!input.problem.is_filled(condition) && enclosed_share(input, condition) < least_share)
    section.refuse("Type",
                   "the boundary encloses no volume, which counts out of the body and with planes "
                   "that close it: normal to x or through the x axis, in the plane lines through "
                   "the origin",
                   "Give the inner surface of the body, and move the mesh so that such planes "
                   "close it");
  constexpr unsigned int n_times = 1000;
  const bool is_in_time = input.analysis.motion == Motion::in_time;
  const double origin[3] = {0., 0., 0.};
  for (unsigned int i = 0; i <= (is_in_time ? n_times : 0); ++i)
  {
    const double time = input.time.end_time * i / n_times,
                 ratio = condition.volume_ratio(origin, is_in_time ? time : 0.);
    if (ratio > 0.)
      continue;
    std::ostringstream text;
    text << "the volume is " << ratio
         << " of the undeformed one at t = " << (is_in_time ? time : 0.)
         << " s, and has to be positive";
    section.refuse(section.given("Volume ratio") ? "Volume ratio" : "", text.str(),
                   "Give the volume over that in the mesh, such as 1 + 0.5*t");
  }
  if (ParameterSection newton = root.subsection("Newton");
      newton.given("Slow iteration") &&
      input.problem.newton.slow_iteration == SlowIteration::krylov && !input.problem.mesh_moves)
    newton.refuse("Slow iteration", "with a cavity a slow iteration makes a new factor",
                  "Remove the entry, or set Slow iteration = new factor");
}

/// A flow rate without a profile.
void check_free_flow(const Problem &problem,
                     const BoundaryCondition &condition,
                     ParameterSection root)
{
  for (const unsigned int region : condition.region_ids)
    if (problem.materials[region].is_solid())
      root.subsection("Boundaries")
          .subsection(condition.name)
          .refuse("Type", "the boundary belongs to a solid, into which nothing flows",
                  "Name the liquid's 'Region' and give the solid's part a condition of its own");
}

/// Where the mesh follows a motion that is prescribed.
void check_prescribed_motion(const Problem &problem,
                             const BoundaryCondition &condition,
                             const ParameterSection &section)
{
  if (condition.mesh != MeshCondition::follows)
    return;
  if (std::all_of(condition.region_ids.begin(), condition.region_ids.end(),
                  [&problem](const unsigned int region)
                  { return problem.materials[region].is_solid(); }))
    section.refuse("Mesh", "no liquid is at the boundary, and solids move with their own velocity",
                   "Remove the entry");
  if (condition.type == BoundaryType::axis)
    section.refuse("Mesh", "a mesh that leaves the axis would open a hole there",
                   "Remove the entry: on the axis the mesh slides along it");
}

/// On a mesh that moves.
void check_boundary_of_liquid(const BoundaryCondition &condition, const ParameterSection &section)
{
  if (condition.outlet != nullptr && condition.outlet->coupling == Outlet::Coupling::flow &&
      (condition.mesh == MeshCondition::slides || condition.mesh == MeshCondition::follows))
    section.refuse("Mesh",
                   "the velocity of an outlet that holds the flow rate is that of a section that "
                   "keeps its shape",
                   "Set Mesh = fixed, or Coupling = pressure");
  if (condition.mesh == MeshCondition::slides &&
      condition.normal.kind == BoundaryPart::Kind::velocity && !condition.normal.is_fixed())
    section.refuse("Mesh", "the velocity of a boundary is that of a section that keeps its shape",
                   "Set Mesh = fixed, or leave the entry out");
}

/// Liquids whose mesh moves.
void check_moving_liquids(const Problem &problem, ParameterSection root)
{
  if (ParameterSection newton = root.subsection("Newton");
      newton.given("Tangent products") &&
      problem.newton.tangent_products == TangentProducts::assembled)
    newton.refuse("Tangent products",
                  "the integrals of the derivative leave out the motion of the mesh",
                  "Remove the entry, or set Tangent products = differences");
  for (const BoundaryCondition &condition : problem.conditions)
    if (std::any_of(condition.region_ids.begin(), condition.region_ids.end(),
                    [&problem](const unsigned int region)
                    { return !problem.materials[region].is_solid(); }))
      check_boundary_of_liquid(condition, root.subsection("Boundaries").subsection(condition.name));
}

/// Displacement and pressure at the start, which belong together.
void check_initial_state(const InteriorData &interior, const ParameterSection &initial_state)
{
  if (!interior.initial_displacement.empty() && interior.initial_pressure.empty())
    initial_state.refuse("Displacement",
                         "without a pressure the one of a small deformation would be taken",
                         "Give the pressure, too, or set Initial state/Type = steady");
  if (interior.initial_displacement.empty() && !interior.initial_pressure.empty())
    initial_state.refuse(
        "Pressure",
        "a body without displacement has its undeformed volume, and so no pressure of its own",
        "Leave it out, give the displacement to which it belongs (p = -K ln J), or set "
        "Initial state/Type = steady");
}
} // namespace

template <int dim>
void check_deformation(const Case<dim> &input, ParameterSection root)
{
  const Problem &problem = input.problem;
  for (const unsigned int cavity : problem.cavities())
    check_cavity(input, problem.conditions[cavity], root);
  for (const BoundaryCondition &condition : problem.conditions)
  {
    if (condition.free_flow)
      check_free_flow(problem, condition, root);
    check_prescribed_motion(problem, condition,
                            root.subsection("Boundaries").subsection(condition.name));
  }
  const bool is_finite = problem.deformation == Deformation::finite;
  if (is_finite && !input.analysis.has_fields)
    return check_loaded_tube(input, root);
  if (problem.some_mesh_moves())
    check_moving_liquids(problem, root);
  if (!is_finite)
    return;
  if (problem.finds_unloaded_shape())
    check_unloaded_shape(problem, root);
  if (problem.finds_unloaded_shape() ||
      (problem.interior.starts_steady_under_loads && !problem.interior.starts_under_mean_loads))
    check_largest_pressure(input, 0., root);
  if (input.analysis.is_steady())
    check_largest_pressure(input, input.steady.time_of_loads, root);
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
    check_prestretch(problem, region, root);
  check_initial_state(problem.interior, root.subsection("Initial state"));
}

template void check_deformation(const Case<2> &, ParameterSection);
template void check_deformation(const Case<3> &, ParameterSection);
} // namespace Continua
