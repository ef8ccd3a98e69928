#include <continua/case/rules/case_checks.h>

#include <continua/case/rules/deformation_checks.h>
#include <continua/case/rules/liquid_body_checks.h>
#include <continua/case/rules/rule.h>
#include <continua/finite_volume/cell_wise_checks.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
using namespace dealii;

namespace
{
/// The axis of an axisymmetric model: there and only there the radial velocity is zero by symmetry.
template <int dim>
void check_axis(const Case<dim> &input, ParameterSection root)
{
  for (const auto &cell : input.triangulation->cell_iterators_on_level(0))
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary())
      {
        bool on_axis = true;
        for (const unsigned int v : cell->face(f)->vertex_indices())
          on_axis = on_axis && std::abs(cell->face(f)->vertex(v)[1]) < 1e-10 * cell->diameter();
        for (const BoundaryCondition &condition : input.problem.conditions)
          if (condition.boundary_id == cell->face(f)->boundary_id() &&
              condition.region_ids.count(cell->material_id()) > 0)
          {
            ParameterSection section = root.subsection("Boundaries").subsection(condition.name);
            if (on_axis && (condition.normal.kind != BoundaryPart::Kind::velocity ||
                            !condition.normal.is_zero() || condition.outlet != nullptr))
              section.refuse("Type",
                             "on the axis of an axisymmetric model the radial velocity is zero",
                             "Set Type = axis");
            if (!on_axis && condition.type == BoundaryType::axis)
              section.refuse("Type", "this boundary is not on the axis (y = 0)",
                             "Set Type = roller if that is meant");
          }
      }
}

/// A support belongs to a solid.
template <int dim>
void check_supports(const Case<dim> &input, ParameterSection root)
{
  for (const BoundaryCondition &condition : input.problem.conditions)
  {
    if (condition.type != BoundaryType::support)
      continue;
    ParameterSection section = root.subsection("Boundaries").subsection(condition.name);
    if (!condition.is_supported())
      section.refuse("Type", "the support has no stiffness and no damping",
                     "Give 'Normal stiffness' or another one of the four, or set Type = pressure");
    for (const unsigned int region : condition.region_ids)
      if (!input.problem.materials[region].is_solid())
        section.refuse(
            "Type",
            "a support holds a solid, and the region '" + input.problem.regions[region] +
                "' is a liquid",
            "Set Region to that of the wall, and give the liquid a condition of its own");
  }
}

/// An entry of products without a matrix where there are none.
template <int dim>
void check_instruction_set(const Case<dim> &input, ParameterSection root)
{
  const TaylorHoodParameters &taylor_hood = input.discretisation.taylor_hood;
  if (ParameterSection section = root.subsection("Linear solver");
      section.given("Instruction set") &&
      !taylor_hood.linear_solver.is_matrix_free(taylor_hood.space.velocity_degree))
    section.refuse("Instruction set",
                   "products have a stored matrix, since Velocity degree is not 2", "Remove it");
}

/// The equation of state of liquids that are convected.
void check_equations_of_state(const Problem &problem, ParameterSection root)
{
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
  {
    const Material &material = problem.materials[region];
    ParameterSection section = root.subsection("Materials").subsection(problem.regions[region]);
    for (const char *const key : {"Volume exponent", "Reference pressure"})
      if (material.is_incompressible() && section.given(key))
        section.refuse(key, "an incompressible liquid has no such law",
                       "Remove it, or give a Bulk modulus");
    // A body without an initial pressure starts with 0.
    if (!material.is_solid() && problem.interior.initial_pressure.empty() &&
        material.volume_law().stiffening(0.) <= 0.)
      section.refuse(
          "Reference pressure",
          "the bulk modulus K + n (p - p0) is not positive at p = 0, with which the liquid "
          "starts",
          "Give the pressure as the body has it at rest, mostly 0, or set Initial "
          "state/Pressure");
  }
}

void check_inflow_pressures(const Problem &problem, ParameterSection root)
{
  for (const BoundaryCondition &condition : problem.conditions)
    if (ParameterSection boundary = root.subsection("Boundaries").subsection(condition.name);
        boundary.given("Inflow pressure") &&
        std::all_of(condition.region_ids.begin(), condition.region_ids.end(),
                    [&](const unsigned int region)
                    { return problem.materials[region].is_solid(); }))
      boundary.refuse("Inflow pressure",
                      "the boundary belongs to a solid, into which nothing flows", "Remove it");
}

template <int dim>
void check_load_steps(const Case<dim> &input, ParameterSection root)
{
  if (input.steady.load_steps > 1 && input.steady.load_steps >= input.steady.maximum_steps)
    root.subsection("Steady").refuse("Load steps",
                                     "there have to be steps with all loads after the load steps",
                                     "Set Maximum steps to more than Load steps");
}
} // namespace

template <int dim>
void check_case(const Case<dim> &input, ParameterSection root)
{
  check_rules(rules(), input, root);
  check_deformation(input, root);
  check_supports(input, root);
  input.analysis.check(input, root);
  if (!input.analysis.has_fields)
    return;
  check_bodies(input, root);
  check_load_steps(input, root);
  if (input.problem.convection.is_on)
  {
    check_equations_of_state(input.problem, root);
    check_inflow_pressures(input.problem, root);
  }
  if (input.problem.model == Model::axisymmetric)
    check_axis(input, root);
  if (input.discretisation.is_cell_wise())
    check_cell_wise(input.problem, input.discretisation.cell_wise,
                    input.analysis.motion != Motion::in_time, root);
  else
    check_instruction_set(input, root);
}

template void check_case(const Case<2> &, ParameterSection);
template void check_case(const Case<3> &, ParameterSection);
} // namespace Continua
