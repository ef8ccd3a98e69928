#include <continua/analysis/loaded_tube_report.h>

#include <continua/base/table_writer.h>
#include <continua/case/theory/loaded_tube_case.h>
#include <continua/case/theory/tube_wave_case.h>
#include <continua/theory/korteweg.h>

#include <sstream>
#include <stdexcept>

namespace Continua
{
namespace
{
constexpr unsigned int n_rows = 101;

/// The tube at one inner radius.
struct LoadedState
{
  double pressure, inner_radius, outer_radius, distensibility, speed;
};

LoadedState state_at(const LoadedTube &tube, const Material &fluid, const double inner_radius)
{
  const double distensibility = tube.distensibility(inner_radius);
  return {tube.pressure(inner_radius), inner_radius, tube.outer_radius(inner_radius),
          distensibility,
          acoustic_speed(fluid.density, fluid.inverse_bulk_modulus() + distensibility)};
}
} // namespace

template <int dim>
void LoadedTubeReport<dim>::name_quantities(const Case<dim> &input, QuantityNames &names)
{
  if (is_about_loaded_state(input))
    for (const char *const name :
         {"inner radius under the mean pressure", "outer radius under the mean pressure",
          "distensibility", "speed of long waves"})
      names.add(name);
}

template <int dim>
void LoadedTubeReport<dim>::add(Run<dim> &run)
{
  const Case<dim> &input = run.input;
  if (!is_about_loaded_state(input))
    return;
  const TubeSection section =
      tube_section_of_mesh(input, input.geometry->branches().front().law, 0.);
  const LoadedTube tube(section);
  const double mean_pressure = input.wave_theory.mean_pressure;
  const LoadedState mean = state_at(tube, section.fluid, tube.inner_radius(mean_pressure));
  std::ostringstream text;
  text << "The tube's inlet under " << mean_pressure << " Pa: inner radius " << mean.inner_radius
       << " m, outer radius " << mean.outer_radius << " m, distensibility " << mean.distensibility
       << " 1/Pa, speed of long waves " << mean.speed << " m/s";
  run.log.line(text.str());
  run.summary.add({"inner radius under the mean pressure", mean.inner_radius, "m", ""});
  run.summary.add({"outer radius under the mean pressure", mean.outer_radius, "m", ""});
  run.summary.add({"distensibility", mean.distensibility, "1/Pa", ""});
  run.summary.add({"speed of long waves", mean.speed, "m/s", ""});
  if (!run.is_writer)
    return;
  TableWriter table(run.directory.file("loaded-tube.csv"),
                    {"pressure [Pa]", "inner radius [m]", "outer radius [m]",
                     "distensibility [1/Pa]", "speed of long waves [m/s]"});
  // To twice the mean pressure, or to the largest that the tube bears.
  double radius = section.inner_radius;
  for (unsigned int i = 0; i < n_rows && (i == 0 || mean_pressure > 0.); ++i)
    try
    {
      const double pressure = 2. * mean_pressure * i / (n_rows - 1.);
      radius = tube.inner_radius(pressure, radius);
      const LoadedState state = state_at(tube, section.fluid, radius);
      table.row(
          {pressure, state.inner_radius, state.outer_radius, state.distensibility, state.speed});
    }
    catch (const std::domain_error &error)
    {
      run.log.note(std::string("loaded-tube.csv ends early: ") + error.what());
      break;
    }
  table.flush();
}

template class LoadedTubeReport<2>;
template class LoadedTubeReport<3>;
} // namespace Continua
