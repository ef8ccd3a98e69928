#include <continua/case/deformation_checks.h>

#include <continua/case/loaded_tube_case.h>
#include <continua/case/tangent_checks.h>
#include <continua/continuum/rest_state.h>

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
void check_prestretch(const Problem &problem,
                      const unsigned int region,
                      const bool is_in_time,
                      ParameterSection root)
{
  if (is_in_time && !problem.interior.starts_at_rest_under_loads && !problem.finds_unloaded_shape())
    root.subsection("Initial state")
        .refuse("Type",
                "with a prestretch the shape of the mesh is not in balance, and the run would "
                "start with a jump",
                "Set Type = steady: the run then starts from the state at rest under its loads");
  // After the inverse solve the body has the shape of the mesh.
  if (problem.finds_unloaded_shape())
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

/// Whether something acts on a boundary at t = 0, or may act somewhere on it.
bool may_load_at_start(const BoundaryCondition &condition)
{
  const double origin[3] = {0., 0., 0.};
  // Others may act somewhere else than at the origin.
  const bool has_one_value =
      condition.normal.vector.empty() && !condition.normal.along_normal.depends_on_space();
  return condition.is_supported() || !condition.initial_jump(origin).empty() ||
         !condition.tangential.is_zero() || (!has_one_value && !condition.normal.is_zero());
}

/// A mesh that has the shape under the loads of the start.
void check_unloaded_shape(const Problem &problem, ParameterSection root)
{
  ParameterSection initial_state = root.subsection("Initial state");
  if (problem.interior.starts_at_rest_under_loads)
    initial_state.refuse(
        "Type",
        "after the inverse solve for the unloaded shape the run starts in the shape "
        "of the mesh, at rest under the loads at t = 0",
        "Remove the entry, or set Unloaded shape = mesh");
  for (const char *const key : {"Velocity", "Displacement", "Pressure"})
    if (initial_state.given(key))
      initial_state.refuse(key,
                           "the inverse solve for the unloaded shape finds the state at t = 0 from "
                           "the loads",
                           "Remove the entry, or set Unloaded shape = mesh");
  if (!problem.interior.initial_pressure.empty())
    initial_state.subsection("Pressures")
        .refuse("",
                "the inverse solve for the unloaded shape finds the state at t = 0 from the loads",
                "Remove the subsection, or set Unloaded shape = mesh");
  if (!problem.interior.acceleration.empty())
    root.subsection("Body force")
        .refuse("Acceleration",
                "with an unloaded shape that is not the mesh's the mass at a place of the mesh is "
                "not its volume times the density, which the weight would need",
                "Give the weight as a Force density, or set Unloaded shape = mesh");
  for (const unsigned int cavity : problem.cavities())
    root.subsection("Boundaries")
        .subsection(problem.conditions[cavity].name)
        .refuse(
            "Type",
            "the inverse solve for the unloaded shape needs the pressure of the loaded one, and "
            "a cavity has its volume given",
            "Give the boundary Type = pressure, or set Unloaded shape = mesh");
  for (const BoundaryCondition &condition : problem.conditions)
    if (condition.type == BoundaryType::windkessel && condition.outlet->initial_states.empty() &&
        problem.interior.body_force.empty() &&
        std::none_of(problem.conditions.begin(), problem.conditions.end(), may_load_at_start))
      root.subsection("Boundaries")
          .subsection(condition.name)
          .refuse("",
                  "at t = 0 nothing flows in and the windkessel has no charge: the liquid has no "
                  "pressure, and the shape of the mesh would be the one without load",
                  "Add 'set Initial pressure = ...', the pressure at which the image was taken, or "
                  "set Unloaded shape = mesh");
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
  if (input.problem.deformation == Deformation::small)
    section.refuse("Type", "the volume of a cavity is that of the deformed body",
                   "Set Deformation = finite, or give the boundary Type = pressure");
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
    text << "the volume is " << ratio << " of that at rest at t = " << (is_in_time ? time : 0.)
         << " s, and has to be positive";
    section.refuse(section.given("Volume ratio") ? "Volume ratio" : "", text.str(),
                   "Give the volume over that in the mesh, such as 1 + 0.5*t");
  }
  if (is_in_time && input.time.scheme == Scheme::crank_nicolson)
    root.subsection("Time").refuse(
        "Scheme",
        "a volume that is held in the middle of each step lets the pressure of the cavity swing "
        "from step to step",
        "Set Scheme = backward differencing or euler implicit");
  if (ParameterSection newton = root.subsection("Newton");
      newton.given("Slow iteration") &&
      input.problem.newton.slow_iteration == SlowIteration::krylov && !input.problem.mesh_moves)
    newton.refuse("Slow iteration", "with a cavity a slow iteration makes a new factor",
                  "Remove the entry, or set Slow iteration = new factor");
}

/// Where a flow rate has no profile, so that a pressure is unknown.
template <int dim>
void check_free_flow(const Case<dim> &input,
                     const BoundaryCondition &condition,
                     ParameterSection root)
{
  ParameterSection section = root.subsection("Boundaries").subsection(condition.name);
  if (input.analysis.has_fields && !input.problem.mesh_moves)
    section.refuse("Profile",
                   "a free profile is that of a section which moves, and here the mesh stays",
                   "Choose another profile, or set Deformation = finite");
  for (const unsigned int region : condition.region_ids)
    if (input.problem.materials[region].is_solid())
      section.refuse("Type", "the boundary belongs to a solid, into which nothing flows",
                     "Name the liquid's 'Region' and give the solid's part a condition of its own");
}

/// Where the mesh follows a motion that is prescribed.
template <int dim>
void check_prescribed_motion(const Case<dim> &input,
                             const BoundaryCondition &condition,
                             const ParameterSection &section,
                             ParameterSection root)
{
  if (condition.mesh != MeshCondition::follows)
    return;
  if (std::all_of(condition.region_ids.begin(), condition.region_ids.end(),
                  [&input](const unsigned int region)
                  { return input.problem.materials[region].is_solid(); }))
    section.refuse("Mesh", "no liquid is at the boundary, and solids move with their own velocity",
                   "Remove the entry");
  if (condition.type == BoundaryType::axis)
    section.refuse("Mesh", "a mesh that leaves the axis would open a hole there",
                   "Remove the entry: on the axis the mesh slides along it");
  const std::string remedy = "Set Mesh = fixed, or make the run transient from rest or from a "
                             "state that is given";
  if (input.analysis.motion != Motion::in_time)
    section.refuse("Mesh", "a mesh that follows a velocity is never at rest", remedy);
  if (input.problem.interior.starts_at_rest_under_loads)
    root.subsection("Initial state")
        .refuse("Type", "a mesh that follows a velocity is never at rest", remedy);
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
template <int dim>
void check_moving_liquids(const Case<dim> &input, ParameterSection root)
{
  const Problem &problem = input.problem;
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

/// Liquids beside solids in finite deformation, whose mesh moves.
template <int dim>
void check_liquids(const Case<dim> &input, ParameterSection root)
{
  const Problem &problem = input.problem;
  if (!problem.has_deformed_regions())
    root.refuse("Deformation",
                "no region is a solid, and the mesh of the liquids follows no boundary",
                "Set Deformation = small, or Mesh = follows for a boundary that moves");
  if (!problem.some_mesh_moves())
  {
    if (root.given("Mesh motion"))
      root.refuse("Mesh motion", "no region is a liquid, whose mesh would move",
                  "Remove the entry");
    return;
  }
  check_moving_liquids(input, root);
}

/// Materials that have no place in finite deformation.
void check_materials(const Problem &problem, const bool is_in_time, ParameterSection root)
{
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
  {
    const Material &material = problem.materials[region];
    if (!material.is_solid())
      continue;
    ParameterSection section = root.subsection("Materials").subsection(problem.regions[region]);
    if (material.compression.relaxes() ||
        (material.has_power_law() && material.shear.power_law->poissons_ratio))
      section.refuse("Volumetric relaxation",
                     "in finite deformation the volume change does not relax",
                     "Set Volumetric relaxation = none, or Deformation = small");
    if (material.prestretch.exists())
      check_prestretch(problem, region, is_in_time, root);
    if (material.prestretch.exists() && !problem.interior.acceleration.empty())
      root.subsection("Body force")
          .refuse("Acceleration",
                  "with a prestretch the mass at a place of the mesh is not its volume times the "
                  "density, which the weight would need",
                  "Give the weight as a Force density, or remove the prestretch");
    if (!material.has_power_law() && material.long_term_shear_modulus() == 0.)
      section.refuse("Type",
                     "'" + material.type +
                         "' has no spring that holds: such a body flows until its mesh is turned "
                         "inside out",
                     "Take Type = prony with a small Young's modulus, or set Deformation = small");
  }
}

template <int dim>
void check_scheme(const Case<dim> &input, ParameterSection root)
{
  if (input.analysis.motion == Motion::in_time && input.time.update_type() == Update::trapezoidal)
    root.subsection("Time").refuse(
        "Update",
        "finite deformation needs displacement and pressure at the level at which the step "
        "balances, which the trapezoidal update does not have",
        "Set Update = implicit");
  if (input.discretisation.taylor_hood.linear_solver.direct_solver == DirectSolver::cholmod)
    root.subsection("Linear solver")
        .refuse("Direct solver",
                "cholmod is for symmetric matrices, and finite deformation makes the matrix "
                "unsymmetric",
                "Use automatic, umfpack or mumps");
  refuse_what_tangents_leave_idle(input.discretisation.taylor_hood.linear_solver.type, root);
  ParameterSection solver = root.subsection("Linear solver");
  for (const char *const key : {"Refinement steps", "Kept factors"})
    if (solver.given(key))
      solver.refuse(key, "with finite deformation Newton's iteration refines, and keeps one factor",
                    "Remove it, or set Deformation = small");
  if (solver.given("Factor precision"))
    solver.refuse("Factor precision",
                  "finite deformation makes the matrix unsymmetric, whose factor has double "
                  "precision",
                  "Remove it, or set Deformation = small");
}
} // namespace

template <int dim>
void check_deformation(const Case<dim> &input, ParameterSection root)
{
  const Problem &problem = input.problem;
  for (const unsigned int cavity : problem.cavities())
    check_cavity(input, problem.conditions[cavity], root);
  for (const BoundaryCondition &condition : problem.conditions)
    if (condition.free_flow)
      check_free_flow(input, condition, root);
  for (const BoundaryCondition &condition : problem.conditions)
    check_prescribed_motion(input, condition,
                            root.subsection("Boundaries").subsection(condition.name), root);
  for (const BoundaryCondition &condition : problem.conditions)
    if (ParameterSection section = root.subsection("Boundaries").subsection(condition.name);
        section.given("Mesh") && !problem.some_mesh_moves())
      section.refuse("Mesh",
                     problem.deformation == Deformation::finite
                         ? "no region is a liquid, whose mesh would move"
                         : "with small deformation the mesh stays",
                     "Remove the entry, or set Deformation = finite for a mesh that moves");
  if (problem.deformation == Deformation::small)
  {
    if (root.given("Mesh motion") && !problem.mesh_moves_between_steps)
      root.refuse("Mesh motion", "with small deformation the mesh stays",
                  "Remove the entry, or set Deformation = finite");
    if (root.sets_in_subsection("Wall directions"))
      root.subsection("Wall directions")
          .refuse("", "fibres and prestretch are for finite deformation",
                  "Remove the section, or set Deformation = finite");
    if (problem.mesh_moves_between_steps)
      check_moving_liquids(input, root);
    if (ParameterSection theory = root.subsection("Wave theory"); theory.given("Mean pressure"))
      theory.refuse("Mean pressure",
                    "with small deformation a mean pressure does not change the waves",
                    "Leave the entry out, or set Deformation = finite");
    if (problem.finds_unloaded_shape())
      root.refuse("Unloaded shape",
                  "with small deformation the shape of the mesh is also the one without load",
                  "Set Unloaded shape = mesh, or Deformation = finite");
    return;
  }
  if (!input.analysis.has_fields)
    return check_loaded_tube(input, root);
  if (ParameterSection theory = root.subsection("Wave theory"); theory.given("Mean pressure"))
    theory.refuse("Mean pressure", "a run has the pressures that act on the body",
                  "Leave the entry out, or set Analysis = linear wave theory");
  if (input.analysis.is_modal())
    root.refuse("Deformation", "vibrations are linear", "Set Deformation = small");
  if (problem.model == Model::plane_stress)
    root.refuse("Deformation",
                "plane stress with finite deformation would need the strain across the plane as an "
                "unknown",
                "Set Model = plane strain or three-dimensional, or Deformation = small");
  if (input.discretisation.is_cell_wise() &&
      std::any_of(problem.materials.begin(), problem.materials.end(),
                  [](const Material &material) { return material.is_solid(); }))
    root.refuse("Deformation",
                "the solids of the cell-wise path are for small deformation, beside which the mesh "
                "of the liquids may move",
                "Set Discretisation = taylor hood, or Deformation = small, with Mesh motion = "
                "elastic for a mesh that moves");
  if (problem.finds_unloaded_shape())
    check_unloaded_shape(problem, root);
  if (problem.finds_unloaded_shape() ||
      (problem.interior.starts_at_rest_under_loads && !problem.interior.starts_under_mean_loads))
    check_largest_pressure(input, 0., root);
  if (input.analysis.is_steady())
    check_largest_pressure(input, input.rest.time_of_loads, root);
  if (root.sets_in_subsection("Wall directions") &&
      std::none_of(problem.materials.begin(), problem.materials.end(), has_directions))
    root.subsection("Wall directions")
        .refuse("", "no material has fibres or a prestretch, which alone have directions",
                "Remove the section, or give a material a Strain law with fibres");
  check_liquids(input, root);
  check_materials(problem, input.analysis.motion == Motion::in_time, root);
  check_scheme(input, root);
  if (!problem.interior.initial_displacement.empty() && problem.interior.initial_pressure.empty())
    root.subsection("Initial state")
        .refuse("Displacement", "without a pressure the one of a small deformation would be taken",
                "Give the pressure, too, or set Initial state/Type = steady");
  if (problem.interior.initial_displacement.empty() && !problem.interior.initial_pressure.empty())
    root.subsection("Initial state")
        .refuse("Pressure",
                "a body without displacement has the volume of rest, and so no pressure of its own",
                "Leave it out, give the displacement to which it belongs (p = -K ln J), or set "
                "Initial state/Type = steady");
  if (ParameterSection exact = root.subsection("Exact solution"); exact.given("Stress"))
    exact.refuse("Stress", "the error of the stress is that of a small deformation",
                 "Compare the displacement or the pressure");
}

template void check_deformation(const Case<2> &, ParameterSection);
template void check_deformation(const Case<3> &, ParameterSection);
} // namespace Continua
