#include <continua/analysis/range_report.h>

#include <continua/continuum/equation_term.h>
#include <continua/theory/korteweg.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <vector>

namespace Continua
{
namespace
{
const char *const strain_name = "largest strain";
const char *const rotation_name = "largest rotation";
const char *const displacement_name = "largest wall displacement";
const char *const over_radius_name = "largest wall displacement over radius";
const char *const speed_name = "largest speed of the liquid";
const char *const over_wave_name = "largest speed over wave speed";
const char *const strength_name = "largest shock strength";
const char *const load_name = "largest change of the stream's load";
const char *const ratio_name = "least volume ratio of the mesh";

struct LiquidLimits
{
  double density = 0.; ///< the largest [kg/m^3]
  double sound = 0.;   ///< the least speed of sound [m/s]; 0 if all are incompressible
  /// The largest (n + 1)/2 over the speed of sound, with the volume exponent n: times a velocity it
  /// is the part by which the wave that has this velocity is faster than sound [s/m].
  double steepening = 0.;

  explicit LiquidLimits(const Problem &problem)
  {
    for (const Material &material : problem.materials)
    {
      if (material.is_solid())
        continue;
      density = std::max(density, material.density);
      if (material.is_incompressible())
        continue;
      const double speed = acoustic_speed(material.density, material.inverse_bulk_modulus());
      sound = sound > 0. ? std::min(sound, speed) : speed;
      steepening = std::max(steepening, 0.5 * (material.volume_exponent + 1.) / speed);
    }
  }
};

bool has_material(const Problem &problem, const bool solid)
{
  return std::any_of(problem.materials.begin(), problem.materials.end(),
                     [solid](const Material &material) { return material.is_solid() == solid; });
}
} // namespace

bool is_of_the_range(const std::string &name)
{
  const auto names = {strain_name,      rotation_name, displacement_name,
                      over_radius_name, speed_name,    over_wave_name,
                      strength_name,    load_name,     ratio_name};
  return std::find(names.begin(), names.end(), name) != names.end();
}

template <int dim>
RangeReport<dim>::RangeReport(Run<dim> &run)
    : run(run),
      has_solids(has_material(run.input.problem, true)),
      has_liquids(has_material(run.input.problem, false))
{
}

template <int dim>
void RangeReport<dim>::Largest::take(const double candidate, const double at_time)
{
  // Round-off, which differs with the ranks, does not choose among equal maxima.
  constexpr double equal = 1e-6;
  if (!(candidate > value * (1. + equal)))
    return;
  value = candidate;
  time = at_time;
}

template <int dim>
void RangeReport<dim>::take(const double time)
{
  SectionTimer::Scope scope(run.log.timer(), "largest values");
  const MotionExtremes extremes = run.solver->motion_extremes();
  strain.take(extremes.strain, time);
  rotation.take(extremes.rotation, time);
  speed.take(extremes.liquid_speed, time);
  compression_of_mesh.take(1. - extremes.mesh_volume_ratio, extremes.mesh_volume_time);
  wall_displacement.take(extremes.wall_displacement, time);
  if (extremes.liquid_radius > 0.)
    displacement_over_radius.take(extremes.wall_displacement / extremes.liquid_radius, time);
  if (has_solids && has_liquids && run.input.problem.convection.is_on)
    change_of_load.take(present_change_of_load(extremes), time);
  // A run that fails has them, too.
  state_values();
}

template <int dim>
double RangeReport<dim>::present_change_of_load(const MotionExtremes &extremes) const
{
  const Problem &problem = run.input.problem;
  const Energy energy = run.solver->energy();
  const std::vector<EquationTermType> types = equation_terms(problem);
  double elastic = 0.;
  for (unsigned int term = 0; term < types.size(); ++term)
    if (types[term].name == "strain" || types[term].name == "compressive")
      for (unsigned int region = 0; region < problem.materials.size(); ++region)
        if (problem.materials[region].is_solid())
          elastic += energy.terms[term][region];
  if (!(elastic > 0.))
    return 0.;
  const double dynamic_pressure =
      LiquidLimits(problem).density * extremes.liquid_speed * extremes.liquid_speed;
  return dynamic_pressure * extremes.rotation * extremes.wall_displacement * extremes.wall_area /
         (2. * elastic);
}

template <int dim>
double RangeReport<dim>::wave_speed() const
{
  // Convection has the stream's effect on the speed of the tube's wave.
  if (tube_speed > 0. && !run.input.problem.convection.is_on)
    return tube_speed;
  return LiquidLimits(run.input.problem).sound;
}

template <int dim>
template <typename Add>
void RangeReport<dim>::for_all(const Add &add) const
{
  const bool has_convection = run.input.problem.convection.is_on;
  if (has_solids)
  {
    add(strain_name, strain.value, strain.time, "1");
    add(rotation_name, rotation.value, rotation.time, "rad");
  }
  if (run.input.problem.some_mesh_moves())
    add(ratio_name, 1. - compression_of_mesh.value, compression_of_mesh.time, "1");
  if (has_solids && has_liquids)
  {
    add(displacement_name, wall_displacement.value, wall_displacement.time, "m");
    add(over_radius_name, displacement_over_radius.value, displacement_over_radius.time, "1");
    if (has_convection)
      add(load_name, change_of_load.value, change_of_load.time, "1");
  }
  if (!has_liquids)
    return;
  add(speed_name, speed.value, speed.time, "m/s");
  if (const double wave = wave_speed(); wave > 0.)
    add(over_wave_name, speed.value / wave, speed.time, "1");
  if (const double steepening = LiquidLimits(run.input.problem).steepening;
      has_convection && run.input.analysis.is_transient() && steepening > 0.)
    add(strength_name, steepening * speed.value, speed.time, "1");
}

template <int dim>
void RangeReport<dim>::state_values()
{
  std::map<std::string, double> values;
  for_all(
      [&](const std::string &name, const double value, const double time, const std::string &unit)
      {
        values[name + " [" + unit + "]"] = value;
        if (run.input.analysis.is_transient())
          values["time of the " + name + " [s]"] = time;
      });
  run.summary.set("largest values", values);
}

template <int dim>
void RangeReport<dim>::finish()
{
  std::map<std::string, double> found;
  for_all(
      [&](const std::string &name, const double value, double, const std::string &unit)
      {
        run.summary.add({name, value, unit, ""});
        found[name] = value;
      });
  const bool is_small = run.input.problem.deformation == Deformation::small,
             has_convection = run.input.problem.convection.is_on;
  std::vector<std::string> passed;
  // A value on the bound itself is within it.
  constexpr double round_off = 1e-9;
  const auto compare =
      [&](const bool counts, const char *const name, const double bound, const std::string &what)
  {
    // What is not stated is 0.
    if (!counts || !(found[name] > bound * (1. + round_off)))
      return;
    std::ostringstream text;
    text.precision(2);
    text << what << ' ' << found[name] << " (bound " << bound << ')';
    passed.push_back(text.str());
  };
  compare(is_small, strain_name, largest_strain, "strain");
  compare(is_small, rotation_name, largest_rotation, "rotation in rad");
  // A mesh that moves goes with the walls.
  const bool mesh_stays = is_small && !run.input.problem.some_mesh_moves();
  compare(mesh_stays, over_radius_name, largest_displacement_over_radius,
          "wall displacement over radius");
  compare(mesh_stays, load_name, largest_change_of_load, "change of the stream's load");
  compare(!has_convection, over_wave_name, largest_speed_over_wave_speed,
          "speed of the liquid over the wave speed");
  compare(true, strength_name, largest_shock_strength, "strength of a shock");
  if (passed.empty())
    return;
  std::string text = "the run leaves the range of its equations: ";
  for (std::size_t i = 0; i < passed.size(); ++i)
    text += (i > 0 ? ", " : "") + passed[i];
  run.log.warning(text + "; the manual's page 'The range of a run' has the errors");
}

template <int dim>
void RangeReport<dim>::name_quantities(const Case<dim> &input, QuantityNames &names)
{
  const bool has_solids = has_material(input.problem, true),
             has_liquids = has_material(input.problem, false);
  if (has_solids)
    for (const char *const name : {strain_name, rotation_name})
      names.add(name);
  if (input.problem.some_mesh_moves())
    names.add(ratio_name);
  if (has_solids && has_liquids)
    for (const char *const name : {displacement_name, over_radius_name})
      names.add(name);
  if (has_solids && has_liquids && input.problem.convection.is_on)
    names.add(load_name);
  if (has_liquids)
    for (const char *const name : {speed_name, over_wave_name})
      names.add(name);
  if (has_liquids && input.problem.convection.is_on)
    names.add(strength_name);
}

template <int dim>
void RangeReport<dim>::save(ArchiveWriter &archive) const
{
  std::vector<double> values;
  for (const Largest *const largest : all)
    values.insert(values.end(), {largest->value, largest->time});
  archive.add("largest values", values);
}

template <int dim>
void RangeReport<dim>::load(const ArchiveReader &archive)
{
  const std::vector<double> values = archive.values("largest values");
  std::size_t next = 0;
  for (Largest *const largest : all)
  {
    largest->value = values.at(next++);
    largest->time = values.at(next++);
  }
}

template class RangeReport<2>;
template class RangeReport<3>;
} // namespace Continua
