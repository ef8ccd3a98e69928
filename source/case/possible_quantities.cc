#include <continua/case/possible_quantities.h>

#include <continua/analysis/wave_report.h>
#include <continua/case/tube_wave_case.h>
#include <continua/continuum/field_list.h>
#include <continua/postprocess/loop_record.h>
#include <continua/postprocess/mesh_record.h>
#include <continua/postprocess/power_record.h>
#include <continua/postprocess/step_record.h>

namespace Continua
{
namespace
{
template <int dim>
void name_waves(const Case<dim> &input, QuantityNames &names)
{
  const bool simulated = input.general.analysis == "transient";
  TubeWaveCase wave_case;
  const bool has_theory =
      (!simulated || input.wave_theory.overlay) && make_tube_wave_case(input, wave_case).empty();
  for (const StationsProbe &probe : input.probes.stations())
  {
    std::set<WaveReport::Source> sources;
    if (simulated)
      sources.insert(WaveReport::Source::simulated);
    if (has_theory)
      sources.insert(WaveReport::Source::theory);
    if (input.measured_waves.count(probe.name) > 0)
      sources.insert(WaveReport::Source::measured);
    // Of the impedances only their presence counts here.
    const bool is_tube = input.geometry->tube_law() != nullptr;
    const WaveStations stations{probe.name,
                                probe.positions,
                                probe.fields,
                                {},
                                std::vector<double>(is_tube ? probe.positions.size() : 0, 1.)};
    WaveReport::name_quantities(stations, sources, names);
  }
}

template <int dim>
void name_modes(const Case<dim> &input, QuantityNames &names)
{
  const bool axisymmetric = input.problem.model == Model::axisymmetric;
  const std::string axes = dim == 2 ? "xy" : "xyz";
  names.add("mass");
  names.add("largest residual");
  for (const char axis : axes)
    names.add(std::string("share of mass along ") + axis);
  for (unsigned int k = 1; k <= input.modal.n_modes; ++k)
  {
    const std::string mode = "mode " + std::to_string(k) + " ";
    names.add(mode + "frequency");
    names.add(mode + "growth rate");
    for (const char axis : axisymmetric ? std::string("x") : axes)
      names.add(mode + "share of mass along " + axis);
    for (const char axis : axisymmetric ? std::string() : dim == 2 ? std::string("z") : axes)
      names.add(mode + "share of inertia about " + axis);
  }
}
} // namespace

template <int dim>
QuantityNames possible_quantities(const Case<dim> &input)
{
  QuantityNames names;
  const std::string &analysis = input.general.analysis;
  const Problem &problem = input.problem;
  input.power_laws.name_quantities(names);
  if (analysis == "modal")
  {
    name_modes(input, names);
    return names;
  }
  if (analysis == "linear wave theory")
  {
    name_waves(input, names);
    return names;
  }
  input.probes.name_quantities(field_names<dim>(problem.model), analysis == "steady", names);
  input.error_norms.name_quantities(names);
  LoopRecord::name_quantities(names);
  if (analysis == "steady")
    return names;

  std::vector<bool> relaxes;
  for (const Material &material : problem.materials)
    relaxes.push_back(material.relaxes() || material.power_law_modulus > 0.);
  PowerRecord<dim>::name_quantities(problem.regions, relaxes, problem.outlets,
                                    input.adaptation.changes_mesh(), names);
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
    if (problem.materials[region].power_law_modulus > 0.)
      names.add("Prony fit error", problem.regions[region]);
  for (const BoundaryCondition &condition : problem.conditions)
    if (condition.type == "absorbing")
      names.add("absorbing end fit error", condition.name);
  if (input.time.is_adaptive())
    StepRecord::name_quantities(names);
  if (input.adaptation.changes_mesh())
    MeshRecord::name_quantities(names);
  names.add("weak divergence at the end");
  name_waves(input, names);
  return names;
}

template QuantityNames possible_quantities(const Case<2> &);
template QuantityNames possible_quantities(const Case<3> &);
} // namespace Continua
