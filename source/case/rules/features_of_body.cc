#include <continua/case/rules/feature_rows.h>

#include <continua/continuum/stress_free_state.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
namespace
{
template <int dim>
bool is_finite(const Case<dim> &input)
{
  return input.problem.deformation == Deformation::finite;
}

/// One spring that never relaxes, and nothing else.
bool is_hookean(const Material &material)
{
  return material.shear.branches.size() == 1 &&
         std::isinf(material.shear.branches.front().relaxation_time) &&
         material.shear.viscosity == 0. && material.compression.bulk_branches().empty();
}

/// Springs of which none holds: it flows in the end.
bool is_maxwell_fluid(const Material &material)
{
  return material.is_solid() && !material.has_power_law() &&
         material.long_term_shear_modulus() == 0.;
}
} // namespace

template <int dim>
FeatureGroup<dim> liquids_as_features()
{
  using Input = const Case<dim> &;
  return {
      "Liquids",
      {of_region<dim>("liquid", "Materials/<region>/Type = newtonian",
                      [](Input, const Material &material) { return !material.is_solid(); }),
       of_input<dim>("no liquid", "Materials/<region>/Type of solids alone",
                     [](Input input)
                     {
                       return std::all_of(
                           input.problem.materials.begin(), input.problem.materials.end(),
                           [](const Material &material) { return material.is_solid(); });
                     }),
       of_region<dim>("flow curve", "Materials/<region>/Type = carreau-yasuda",
                      [](Input, const Material &material)
                      { return material.shear.flow_curve.has_value(); }),
       of_region<dim>("compressible liquid", "Materials/<region>/Bulk modulus",
                      [](Input, const Material &material)
                      { return !material.is_solid() && !material.is_incompressible(); }),
       of_region<dim>("maxwell liquid", "Materials/<region>/Type = maxwell",
                      [](Input, const Material &material) { return is_maxwell_fluid(material); }),
       of_input<dim>("no convection", "Convection = none",
                     [](Input input) { return !input.problem.convection.is_on; }),
       of_input<dim>("convection", "Convection = navier stokes",
                     [](Input input) { return input.problem.convection.is_on; }),
       of_input<dim>("convection on a mesh that stays", "Convection = navier stokes",
                     [](Input input)
                     { return input.problem.convection.is_on && !input.problem.mesh_moves; }),
       of_input<dim>("explicit convection", "Flow/Time treatment = explicit",
                     [](Input input) { return input.problem.convection.is_explicit(); }),
       of_input<dim>("explicit convection in all steps", "Flow/Time treatment = explicit",
                     [](Input input)
                     {
                       return input.problem.convection.is_explicit() &&
                              !input.problem.interior.starts_steady_under_loads;
                     }),
       of_input<dim>("explicit convection with a factor", "Flow/Time treatment = explicit",
                     [](Input input)
                     {
                       return input.problem.convection.is_explicit() &&
                              !input.problem.interior.starts_steady_under_loads &&
                              input.discretisation.taylor_hood.linear_solver.type !=
                                  LinearSolverType::iterative;
                     }),
       of_input<dim>("supg", "Flow/Convection stabilisation = supg",
                     [](Input input)
                     {
                       return is_taylor_hood(input) && input.problem.convection.is_on &&
                              input.problem.convection.stabilisation ==
                                  ConvectionStabilisation::supg;
                     }),
       of_input<dim>("grad-div by the local speed", "Flow/Convection stabilisation = grad-div",
                     [](Input input)
                     {
                       return is_taylor_hood(input) && input.problem.convection.is_on &&
                              input.problem.convection.stabilisation ==
                                  ConvectionStabilisation::grad_div &&
                              input.problem.convection.stabilisation_viscosity == 0.;
                     }),
       of_input<dim>("linear equations", "Convection = none",
                     [](Input input) { return !input.problem.is_nonlinear(); }),
       of_input<dim>("load steps", "Steady/Load steps",
                     [](Input input) { return input.steady.load_steps > 1; })}};
}

template <int dim>
FeatureGroup<dim> solids_as_features()
{
  using Input = const Case<dim> &;
  return {
      "Solids",
      {of_input<dim>(
           "small deformation", "Deformation = small",
           [](Input input) { return !is_finite(input); }, true),
       of_input<dim>("finite deformation", "Deformation = finite",
                     [](Input input) { return is_finite(input); }),
       of_input<dim>("finite deformation of a solid", "Deformation = finite",
                     [](Input input)
                     { return input.problem.has_regions_of(RegionModel::finite_solid); }),
       of_input<dim>("no solid, and no boundary that moves",
                     "Materials/<region>/Type of liquids alone",
                     [](Input input) { return !input.problem.has_deformed_regions(); }),
       of_input<dim>(
           "unloaded shape", "Unloaded shape = inverse solve",
           [](Input input) { return input.problem.finds_unloaded_shape(); }, true),
       of_region<dim>("prestretch", "Materials/<region>/Axial prestretch",
                      [](Input, const Material &material) { return material.prestretch.exists(); }),
       of_input<dim>("no direction in any material", "Materials/<region>/Strain law without fibres",
                     [](Input input)
                     {
                       return is_finite(input) &&
                              std::none_of(input.problem.materials.begin(),
                                           input.problem.materials.end(), has_directions);
                     }),
       of_region<dim>("solid that relaxes", "Materials/<region>/Type = prony",
                      [](Input, const Material &material)
                      { return material.is_solid() && material.relaxes(); }),
       of_region<dim>("volume that relaxes", "Materials/<region>/Volumetric relaxation",
                      [](Input, const Material &material)
                      {
                        return material.is_solid() && (material.compression.relaxes() ||
                                                       (material.has_power_law() &&
                                                        material.shear.power_law->poissons_ratio));
                      }),
       of_region<dim>("power law", "Materials/<region>/Type = power law",
                      [](Input, const Material &material) { return material.has_power_law(); }),
       of_region<dim>("solid without a spring that holds", "Materials/<region>/Type = maxwell",
                      [](Input, const Material &material) { return is_maxwell_fluid(material); }),
       of_region<dim>("material that is no Hookean solid", "Materials/<region>/Type",
                      [](Input, const Material &material) { return !is_hookean(material); }),
       of_region<dim>("incompressible material", "Materials/<region>/Bulk modulus = none",
                      [](Input, const Material &material) { return material.is_incompressible(); }),
       of_region<dim>("incompressible solid", "Materials/<region>/Poisson's ratio = 0.5",
                      [](Input, const Material &material)
                      { return material.is_solid() && material.is_incompressible(); }),
       of_region<dim>("liquid of a steady flow", "Materials/<region>/Type = newtonian",
                      [](Input input, const Material &material)
                      { return input.analysis.is_steady() && material.shear.branches.empty(); })}};
}

template <int dim>
FeatureGroup<dim> meshes_as_features()
{
  using Input = const Case<dim> &;
  return {
      "Mesh",
      {of_input<dim>(
           "mesh that stays", "Deformation = small",
           [](Input input) { return !is_finite(input) && !input.problem.some_mesh_moves(); }, true),
       of_input<dim>("mesh that moves", "Deformation = finite",
                     [](Input input) { return input.problem.mesh_moves; }),
       of_input<dim>("cell-wise mesh that moves", "Mesh motion",
                     [](Input input) { return input.problem.mesh_moves_between_steps; }),
       of_input<dim>("hyperelastic motion of the mesh", "Mesh motion = hyperelastic",
                     [](Input input)
                     {
                       return input.problem.some_mesh_moves() &&
                              input.problem.mesh_motion != MeshMotionKind::elastic;
                     }),
       of_boundary<dim>("mesh that follows a boundary", "Boundaries/<name>/Mesh = follows",
                        [](Input, const BoundaryCondition &condition)
                        { return condition.mesh == MeshCondition::follows; }),
       of_input<dim>("adaptive mesh", "Adaptivity/Indicator",
                     [](Input input) { return input.adaptation.changes_mesh(); }),
       of_input<dim>("metis", "Mesh/Partitioner = metis",
                     [](Input input) { return input.mesh.partition.is_metis(); })}};
}

template <int dim>
FeatureGroup<dim> boundaries_as_features()
{
  using Input = const Case<dim> &;
  using Condition = const BoundaryCondition &;
  return {
      "Boundaries and loads",
      {of_boundary<dim>("support", "Boundaries/<name>/Type = support",
                        [](Input, Condition condition)
                        { return condition.type == BoundaryType::support; }),
       of_boundary<dim>(
           "cavity", "Boundaries/<name>/Type = cavity",
           [](Input, Condition condition) { return condition.is_cavity(); }, true),
       of_boundary<dim>("outlet", "Boundaries/<name>/Type = resistance or windkessel",
                        [](Input, Condition condition) { return condition.outlet != nullptr; }),
       of_boundary<dim>("windkessel", "Boundaries/<name>/Type = windkessel",
                        [](Input, Condition condition)
                        { return condition.type == BoundaryType::windkessel; }),
       of_boundary<dim>("network at an end", "Boundaries/<name>/Type = network",
                        [](Input, Condition condition)
                        { return condition.type == BoundaryType::network; }),
       of_boundary<dim>("outlet that holds the flow rate", "Boundaries/<name>/Coupling = flow",
                        [](Input, Condition condition) {
                          return condition.outlet != nullptr &&
                                 condition.outlet->coupling == Outlet::Coupling::flow;
                        }),
       of_boundary<dim>("absorbing end", "Boundaries/<name>/Type = absorbing",
                        [](Input, Condition condition)
                        { return condition.type == BoundaryType::absorbing; }),
       of_boundary<dim>("free profile", "Boundaries/<name>/Profile = free",
                        [](Input, Condition condition) { return condition.free_flow.has_value(); }),
       of_boundary<dim>("womersley profile", "Boundaries/<name>/Profile = womersley",
                        [](Input, Condition condition)
                        { return condition.profile == FlowProfile::Shape::womersley; }),
       of_boundary<dim>("womersley profile of a liquid that was at rest",
                        "Boundaries/<name>/Profile = womersley from rest",
                        [](Input, Condition condition)
                        {
                          return condition.profile == FlowProfile::Shape::womersley &&
                                 condition.past == FlowPast::at_rest;
                        }),
       of_input<dim>("weight", "Body force/Acceleration",
                     [](Input input) { return !input.problem.interior.acceleration.empty(); })}};
}

template FeatureGroup<2> liquids_as_features();
template FeatureGroup<3> liquids_as_features();
template FeatureGroup<2> solids_as_features();
template FeatureGroup<3> solids_as_features();
template FeatureGroup<2> meshes_as_features();
template FeatureGroup<3> meshes_as_features();
template FeatureGroup<2> boundaries_as_features();
template FeatureGroup<3> boundaries_as_features();
} // namespace Continua
