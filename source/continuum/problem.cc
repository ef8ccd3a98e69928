#include <continua/continuum/problem.h>

namespace Continua
{
void InteriorData::read(ParameterSection body_force_section,
                        ParameterSection initial_state,
                        const std::vector<std::string> &regions,
                        const unsigned int n_dimensions)
{
  std::vector<Expression> force(n_dimensions);
  add_expressions(body_force_section, "Force density", force, n_dimensions,
                  Dimensions::force_density,
                  "Cartesian components of the force per volume rho b on all regions.");
  std::vector<Expression> of_mass(n_dimensions);
  add_expressions(body_force_section, "Acceleration", of_mass, n_dimensions,
                  Dimensions::acceleration,
                  "Cartesian components of the force per mass b, such as gravity; each region's "
                  "density times it.");
  if (body_force_section.given("Acceleration"))
    for (const Expression &component : of_mass)
      acceleration.emplace_back(component);
  if (body_force_section.given("Force density"))
    for (const Expression &component : force)
      body_force.emplace_back(component);

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
  for (const auto *components : {&initial_velocity, &initial_displacement, &initial_pressure})
    for (const Expression &component : *components)
      if (component.depends_on_time())
        initial_state.refuse("", "an initial value depends on t",
                             "Write it as a function of x, y, z");
}
} // namespace Continua
