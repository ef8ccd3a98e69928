#include <continua/boundary/boundary_conditions.h>
#include <continua/case/before_the_run/cost_of_case.h>
#include <continua/case/case.h>
#include <continua/case/rules/case_checks.h>

#include <continua/base/quoted_name.h>
#include <continua/boundary/flow_rates.h>
#include <continua/boundary/outlets.h>
#include <continua/case/before_the_run/preflight_input.h>
#include <continua/case/network_ends.h>
#include <continua/case/periodic_loads.h>
#include <continua/continuum/field_list.h>
#include <continua/mesh/distortion.h>
#include <continua/mesh/regions_of_boundary.h>

#include <algorithm>

namespace Continua
{
using namespace dealii;

namespace
{
/// Coarse cells that are made to check the input alone.
constexpr double most_cells_of_check = 1e5;

/// What the user has measured at the stations of her probes.
template <int dim>
void read_measured_waves(const Probes<dim> &probes,
                         const bool in_time,
                         std::map<std::string, MeasuredWaves> &waves)
{
  for (const StationsProbe &probe : probes.stations())
  {
    MeasuredWavesEntries measured;
    measured.read(probe.section);
    if (measured.file.empty())
      continue;
    if (!in_time)
      probe.section.refuse("Measured", "a state at rest has no wave to compare with",
                           "Remove the entry, or use another analysis");
    waves.emplace(probe.name,
                  MeasuredWaves(measured, probe.section, probe.positions, probe.fields));
  }
}

/// What is asked for beside the fields that are always there.
template <int dim>
void set_further_fields(Case<dim> &input, const ParameterSection &output, const bool in_time)
{
  Problem &problem = input.problem;
  problem.further_fields = input.output.further_fields;
  const bool has_averages = problem.further_fields.wall_shear_averages;
  // A periodic response has one period and no other time.
  if (!input.analysis.is_harmonic())
    problem.wall_shear_window = input.output.wall_shear_window;
  problem.wall_shear_window.is_kept =
      has_averages || input.probes.asks_for_averages(field_names<dim>(problem));
  if (!problem.wall_shear_window.is_kept)
    for (const char *key : {"Averages from", "Averages to"})
      if (output.given(key))
        output.refuse(key, "nothing asks for an average",
                      "Add 'averages of wall shear stress' to Further fields, or a probe with "
                      "'oscillatory shear index'");
  if (problem.wall_shear_window.is_kept && in_time &&
      problem.wall_shear_window.begin >= input.time.end_time)
    output.refuse("Averages from", "the run ends before its averages begin",
                  "Give a time before Time/End time");
}
} // namespace

template <int dim>
Case<dim>::Case(ParameterFile &file,
                const GeneralParameters &general_parameters,
                const AnalysisTraits<dim> &analysis,
                const MPI_Comm communicator,
                const CaseUse use)
    : communicator(communicator),
      restart(use == CaseUse::restart),
      general(general_parameters),
      analysis(analysis),
      probes(communicator)
{
  ParameterSection root = file.root();
  read_body(file);
  read_equations(file);
  read_analysis(root);
  read_results(root);
  make_coarse_mesh(root.subsection("Mesh"), use);
  read_boundaries(root);
  // Before the checks across entries: a misspelt key is the likelier reason for them to fail.
  file.refuse_unknown();
  check_case(*this, root);
  prepare_loads(root);
  prepare_results(root);
  if (analysis.name == "harmonic" && harmonic.sensitivities.is_on)
    prepare_entry_changes(file);
  name_all_quantities(file);
}

template <int dim>
void Case<dim>::read_body(ParameterFile &file)
{
  ParameterSection root = file.root();
  general.analysis = analysis.name;
  problem.communicator = communicator;
  problem.model = model_of(general.model);
  problem.deformation = general.deformation;
  problem.unloaded_shape = general.unloaded_shape;
  problem.mesh_motion = general.mesh_motion;
  geometry = make_geometry<dim>(root.subsection("Geometry"), root.subsection("Mesh"),
                                problem.model == Model::axisymmetric, boundaries_held_across(file));
  mesh = MeshParameters::read(root.subsection("Mesh"));
  problem.regions = geometry->regions();
  problem.boundaries = geometry->boundaries();

  ParameterSection materials = root.subsection("Materials");
  for (const std::string &region : problem.regions)
  {
    if (!materials.has_subsection(region))
    {
      // A misspelt name is the likelier reason.
      materials.refuse_unknown_members(problem.regions, "region");
      materials.refuse_missing("the region '" + region + "' has no material",
                               "Add 'subsection " + quoted_name(region, "#") +
                                   "' with a Type to Materials");
    }
  }
  read_materials(root, problem);
  for (unsigned int region = 0; region < problem.regions.size(); ++region)
    if (const ParameterSection section = materials.subsection(problem.regions[region]);
        problem.materials[region].has_power_law() && section.given("Relaxation table"))
      power_laws.note_table(problem.regions[region], section);
}

template <int dim>
void Case<dim>::read_materials(ParameterSection root, Problem &of_file) const
{
  ParameterSection materials = root.subsection("Materials");
  of_file.materials.clear();
  of_file.plane_stress_factors.clear();
  for (const std::string &region : problem.regions)
  {
    of_file.materials.push_back(read_material(materials.subsection(region), problem.model));
    if (problem.deformation == Deformation::finite)
      read_strain_law(materials.subsection(region), of_file.materials.back());
    if (problem.model == Model::plane_stress)
      of_file.plane_stress_factors.push_back(
          read_plane_stress_factors(materials.subsection(region)));
  }
}

template <int dim>
void Case<dim>::read_equations(ParameterFile &file)
{
  ParameterSection root = file.root();
  discretisation.read(root, general.discretisation);
  const bool some_liquid =
      std::any_of(problem.materials.begin(), problem.materials.end(),
                  [](const Material &material) { return !material.is_solid(); });
  if (discretisation.is_cell_wise())
  {
    // Its solids have small strain: the entry itself asks for a mesh that follows them.
    const bool is_asked_for =
        root.given("Mesh motion") ||
        (problem.deformation == Deformation::finite && some_mesh_follows(file));
    problem.mesh_moves_between_steps = analysis.has_fields && some_liquid && is_asked_for;
    if (!root.given("Mesh motion"))
      problem.mesh_motion = MeshMotionKind::elastic;
  }
  else
    problem.mesh_moves =
        analysis.has_fields && some_liquid && problem.deformation == Deformation::finite &&
        (problem.has_regions_of(RegionModel::finite_solid) || some_mesh_follows(file));
  if (problem.deformation == Deformation::finite || root.has_subsection("Wall directions"))
    problem.wall_directions.read(root.subsection("Wall directions"), problem.boundaries,
                                 problem.model);
  problem.interior.read(root.subsection("Body force"), root.subsection("Initial state"),
                        problem.regions, dim);

  problem.convection.is_on = general.convection != "none";
  if (problem.convection.is_on || root.has_subsection("Flow"))
    problem.convection.read(root.subsection("Flow"));
  if (problem.is_nonlinear() || root.has_subsection("Newton"))
    problem.newton.read(root.subsection("Newton"));
}

template <int dim>
void Case<dim>::read_analysis(ParameterSection root)
{
  const bool in_time = analysis.motion == Motion::in_time;
  if (in_time)
  {
    time.read(root.subsection("Time"));
    if (problem.deformation == Deformation::finite)
      time.take_implicit_update();
  }
  else if (analysis.is_modal())
    modal.read(root.subsection("Modal"));
  else if (analysis.is_harmonic())
  {
    if (analysis.name == "harmonic")
      harmonic.read(root.subsection("Harmonic"));
    else if (analysis.name == "resonances")
      resonances.read(root.subsection("Resonances"));
    else if (analysis.name == "periodic response")
    {
      periodic_response.read(root.subsection("Periodic response"));
      // The rows and the period are those of a run in time.
      time.read(root.subsection("Time"));
      periodic_state.read(root.subsection("Periodic state"));
    }
    else if (analysis.name == "pulse response")
    {
      pulse_response.read(root.subsection("Pulse response"));
      time.read(root.subsection("Time"));
    }
    // Of the state about which the motion is small.
    if (problem.is_nonlinear())
      steady.read(root.subsection("Steady"), true);
    else if (root.sets_in_subsection("Steady"))
      root.subsection("Steady").refuse(
          "",
          "Analysis = " + analysis.name +
              " reads this section in finite deformation only, for the state about which the "
              "motion is small",
          "Remove it, or set Deformation = finite");
  }
  else
    steady.read(root.subsection("Steady"), problem.is_nonlinear());
  if (analysis.is_transient() &&
      (problem.interior.starts_steady_under_loads || problem.finds_unloaded_shape()))
    steady.read(root.subsection("Steady"), problem.is_nonlinear());
  else if (ParameterSection steady = root.subsection("Steady");
           analysis.is_transient() && root.sets_in_subsection("Steady"))
    steady.refuse("",
                  "Analysis = transient reads this section for a start from a steady state or an "
                  "unloaded shape only",
                  "Remove it, or set Initial state/Type = steady or mean, Unloaded shape = inverse "
                  "solve or Analysis = steady");
  if (!analysis.is_modal() && !analysis.is_harmonic())
  {
    ParameterSection section = root.subsection("Adaptivity");
    adaptation.read(section, in_time);
    if (adaptation.uses(Indicator::interface_band) && !has_fluid_and_solid(*this))
      section.refuse("Indicator", "the body has no interface of fluid and solid",
                     "Choose another indicator");
  }
  if (in_time)
    wave_theory.read(root.subsection("Wave theory"));
  if (in_time && root.has_subsection("Periodic state"))
    periodic_state.read(root.subsection("Periodic state"));
}

template <int dim>
void Case<dim>::read_results(ParameterSection root)
{
  const bool in_time = analysis.motion == Motion::in_time;
  output.read(root.subsection("Output"));
  for (const NamedInterface &named : geometry->interfaces())
    if (root.subsection("Boundaries").has_subsection(named.name))
      root.subsection("Boundaries")
          .subsection(named.name)
          .refuse("", "'" + named.name + "' lies between regions, where no condition holds",
                  "Remove the subsection; probes can name it as an Interface");
  probes.read(root.subsection("Probes"), problem.boundaries, problem.regions, geometry->branches(),
              geometry->interfaces());
  read_measured_waves(probes, in_time, measured_waves);
  if (!analysis.is_modal() && !analysis.is_harmonic())
    error_norms.read(root.subsection("Exact solution"));
  expected = read_expected(root.subsection("Expected"));
}

template <int dim>
void Case<dim>::make_coarse_mesh(const ParameterSection &mesh_section, const CaseUse use)
{
  triangulation = make_triangulation<dim>(communicator, mesh.partition, are_regions_solid());
  extent = geometry->extent();
  // Once, since the free memory changes.
  discretisation.taylor_hood.outlook = solver_outlook(*this);
  check_memory(*this, mesh_section);
  if (use == CaseUse::check && extent.n_cells > most_cells_of_check)
    if (std::unique_ptr<Geometry<dim>> coarse = geometry->coarsened(most_cells_of_check))
      geometry = std::move(coarse);
  geometry->create(*triangulation);
  distort_coarse_mesh(*triangulation, mesh.distortion);
}

template <int dim>
void Case<dim>::read_boundaries(ParameterSection root)
{
  for (unsigned int boundary = 0; boundary < problem.boundaries.size(); ++boundary)
    for (const unsigned int region : regions_of_boundary<dim>(*triangulation, boundary))
      boundary_regions.insert({boundary, region});
  problem.conditions =
      read_boundary_conditions(root.subsection("Boundaries"), problem.boundaries, problem.regions,
                               boundary_regions, dim, problem.model == Model::axisymmetric);
  if (analysis.name == "harmonic")
    harmonic.read_phases(root, problem.conditions);
  read_network_of_body(*this, root);
}

template <int dim>
void Case<dim>::prepare_loads(ParameterSection root)
{
  const bool in_time = analysis.motion == Motion::in_time;
  // A start from the mean needs them, too.
  const bool has_beats = analysis.is_harmonic() && periodic_state.is_on;
  if (analysis.is_transient() || has_beats)
    set_periodic_loads(*this, root);
  // Wave theory takes the laws themselves, and a run that goes on has its branches in a checkpoint.
  if (analysis.is_transient() && !restart)
    power_laws.fit(problem, time, root.subsection("Materials"));
  set_flow_profiles(problem.conditions, root.subsection("Boundaries"), *triangulation,
                    problem.materials, {!in_time, time.end_time, time.time_step});
  problem.outlets = make_outlets(problem.conditions, root.subsection("Boundaries"), *triangulation,
                                 problem.materials);
  add_network_outlet(*this);
  absorbing_ends.add(*this, root, restart);
}

template <int dim>
void Case<dim>::prepare_results(ParameterSection root)
{
  const bool in_time = analysis.motion == Motion::in_time;
  probes.check(*triangulation, field_names<dim>(problem), boundary_regions);
  probes.check_limits(problem.conditions,
                      {discretisation.is_cell_wise(), analysis.is_modal() || analysis.is_harmonic(),
                       in_time || analysis.name == "periodic response",
                       problem.deformation == Deformation::finite, are_regions_solid(),
                       problem.some_mesh_moves()},
                      field_names<dim>(problem));
  n_histories = probes.expected_columns(field_names<dim>(problem)).size();
  check_histories(*this, root.subsection("Probes"));
  if (periodic_state.is_on && (analysis.is_transient() || analysis.is_harmonic()))
    check_compared_probes(*this, root.subsection("Periodic state"));
  set_further_fields(*this, root.subsection("Output"), in_time);
}

template <int dim>
void Case<dim>::name_all_quantities(ParameterFile &file)
{
  ParameterSection root = file.root();
  power_laws.name_quantities(quantities);
  analysis.name_quantities(*this, quantities);
  if (analysis.name_quantities_of_others != nullptr)
  {
    QuantityNames others;
    analysis.name_quantities_of_others(*this, others);
    const auto left_out =
        std::stable_partition(expected.begin(), expected.end(),
                              [&](const ExpectedValue &value)
                              { return quantities.states(value) || !others.states(value); });
    for (auto value = left_out; value != expected.end(); ++value)
      expected_of_other_analyses.push_back(value->key);
    expected.erase(left_out, expected.end());
  }
  quantities.refuse_unknown(file, root.subsection("Expected"), expected);
}

template <int dim>
std::vector<bool> Case<dim>::are_regions_solid() const
{
  std::vector<bool> are_solid;
  for (const Material &material : problem.materials)
    are_solid.push_back(material.is_solid());
  return are_solid;
}

template struct Case<2>;
template struct Case<3>;
} // namespace Continua
