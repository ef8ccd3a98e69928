#include <continua/continuum/problem.h>

#include <continua/base/words.h>

#include <algorithm>

namespace Continua
{
void InteriorData::read(ParameterSection body_force_section,
                        ParameterSection initial_state,
                        const std::vector<std::string> &regions,
                        const unsigned int n_dimensions)
{
  const auto read_force =
      [&](const std::string &key, const Dimension &dimension, const std::string &text)
  {
    std::vector<Waveform> components =
        Waveform::read_vector(body_force_section, key, n_dimensions, dimension, text, false, key);
    if (std::all_of(components.begin(), components.end(),
                    [](const Waveform &component) { return component.is_zero(); }))
      components.clear();
    return components;
  };
  body_force =
      read_force("Force density", Dimensions::force_density,
                 "Cartesian components of the force per volume rho b on all regions. With "
                 "Deformation = finite at the present place; on solids per undeformed volume.");
  acceleration =
      read_force("Acceleration", Dimensions::acceleration,
                 "Cartesian components of the force per mass b, such as gravity; each "
                 "region's density times it. With Deformation = finite at the present place.");

  enum class Start
  {
    given,
    steady,
    mean
  };
  Start start = Start::given;
  add_choice(initial_state, "Type", start,
             {{"given", Start::given}, {"steady", Start::steady}, {"mean", Start::mean}},
             "Where a run in time starts: given - from rest, or from the fields of this section; "
             "steady - from the steady flow, with all solids at rest, under the loads at t = 0, "
             "which is found first, as the section Steady says; mean - from that under the mean "
             "of the loads over the period of the section Periodic state, so that vessels and "
             "outlets have their mean pressure.");
  starts_steady_under_loads = start != Start::given;
  starts_under_mean_loads = start == Start::mean;

  const auto read_vector =
      [&](const std::string &key, const Dimension &dimension, const std::string &text)
  {
    std::vector<Expression> components(n_dimensions);
    add_expressions(initial_state, key, components, n_dimensions, dimension, text);
    return initial_state.given(key) ? components : std::vector<Expression>();
  };
  initial_velocity = read_vector("Velocity", Dimensions::velocity,
                                 "Cartesian components of the velocity at t = 0.");
  initial_displacement =
      read_vector("Displacement", Dimensions::length,
                  "Cartesian components of the displacement at t = 0 of every spring that does not "
                  "relax; without a pressure the one in equilibrium with it is taken.");
  Expression pressure;
  add_expression(initial_state, "Pressure", pressure, Dimensions::pressure,
                 "Pressure at t = 0 in all regions, but those of the subsection Pressures.");
  if (initial_state.given("Pressure"))
    initial_pressure.assign(regions.size(), pressure);
  ParameterSection by_region = initial_state.subsection("Pressures");
  for (unsigned int region = 0; region < regions.size(); ++region)
  {
    Expression value = pressure;
    add_expression(by_region, regions[region], value, Dimensions::pressure,
                   "Pressure at t = 0 in this region.");
    if (by_region.given(regions[region]))
    {
      initial_pressure.resize(regions.size(), pressure);
      initial_pressure[region] = value;
    }
  }
  if (starts_steady_under_loads)
  {
    for (const char *const key : {"Velocity", "Displacement", "Pressure"})
      if (initial_state.given(key))
        initial_state.refuse(key, "with this Type the state at t = 0 is found from the loads",
                             "Remove the entry, or set Type = given");
    if (!initial_pressure.empty())
      by_region.refuse("", "with this Type the pressure at t = 0 is found from the loads",
                       "Remove the subsection, or set Type = given");
  }
  for (const auto *components : {&initial_velocity, &initial_displacement, &initial_pressure})
    for (const Expression &component : *components)
      if (component.depends_on_time())
        initial_state.refuse("", "an initial value depends on t",
                             "Write it as a function of x, y, z");
}

std::vector<Waveform::Remark> InteriorData::table_remarks(const double end_time) const
{
  std::vector<const Waveform *> waveforms;
  for (const auto *components : {&body_force, &acceleration})
    for (const Waveform &component : *components)
      waveforms.push_back(&component);
  return Waveform::table_remarks(waveforms, "the body force: ", end_time);
}
} // namespace Continua
