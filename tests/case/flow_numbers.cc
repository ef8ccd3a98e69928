// The numbers of a flow by hand, for water in a pipe of 10 mm and in a channel, and each of the
// warnings.

#include <continua/case/before_the_run/flow_numbers.h>

#include "../unit_test.h"

#include <cmath>

namespace test_of_flow_numbers
{
using namespace Continua;

namespace
{
/// Water of 0.1 m/s in the mean.
FlowNumbersInput flow_in_a_pipe()
{
  FlowNumbersInput input;
  input.boundary = "inlet";
  input.mean_speed = 0.1;
  input.largest_speed = 0.2;
  input.density = 1000.;
  input.viscosity = 1e-3;
  input.duct = FlowNumbersInput::Duct::pipe;
  input.width = 0.01;
  input.largest_cell = 0.2e-3;
  input.shortest_cell = 0.1e-3;
  input.time_step = 1e-3;
  input.frequency = 1.;
  return input;
}

void one_warning(const std::string &name, const FlowNumbersInput &input, const std::string &pattern)
{
  const FlowNumbers numbers(input);
  check::is_true(name, numbers.warnings().size() == 1 &&
                           check::matches(numbers.warnings().front(), pattern));
}
} // namespace

UNIT_TEST(flow_numbers)
{
  FlowNumbersInput input = flow_in_a_pipe();
  const FlowNumbers pipe(input);
  check::relative("Reynolds number", pipe.value("Reynolds number"), 1000., 1e-12);
  check::relative("cell Reynolds number", pipe.value("cell Reynolds number"), 40., 1e-12);
  check::relative("Courant number", pipe.value("Courant number of the flow"), 2., 1e-12);
  check::relative("Womersley number", pipe.value("Womersley number of the flow"), 12.533141373155,
                  1e-12);
  check::relative("entrance of a pipe", pipe.value("entrance length"), 0.5672572622791926, 1e-9);
  check::is_true("no waves", std::isnan(pipe.value("mean flow over wave speed")));
  check::is_true("nothing to warn of", pipe.warnings().empty());
  check::equal("headline", pipe.headline(),
               "Pre-flight: flow of 0.1 m/s at 'inlet', Reynolds number 1000, cell Reynolds "
               "number 40, Courant number of the flow 2; more in log.txt");
  check::relative("of another speed", pipe.reynolds_number(0.3), 3000., 1e-12);
  check::relative("cells of another speed", pipe.cell_reynolds_number(0.3), 60., 1e-12);
  check::relative("steps of another speed", pipe.courant_number(0.3, 2e-3), 6., 1e-12);

  input.duct = FlowNumbersInput::Duct::channel;
  check::relative("entrance of a channel", FlowNumbers(input).value("entrance length"),
                  0.4423080227916194, 1e-9);
  input.mean_speed = 0.131;
  one_warning("turbulent channel", input, "gap\\) is above 1300.*no turbulence model");
  input.duct = FlowNumbersInput::Duct::pipe;
  check::is_true("which a pipe is not", FlowNumbers(input).warnings().empty());
  input.mean_speed = 0.231;
  one_warning("turbulent pipe", input, "diameter\\) is above 2300");
  input.duct = FlowNumbersInput::Duct::none;
  check::is_true("without walls", FlowNumbers(input).warnings().empty() &&
                                      std::isnan(FlowNumbers(input).value("entrance length")));

  input = flow_in_a_pipe();
  input.largest_cell = 0.26e-3;
  one_warning("long cells", input, "cell Reynolds number is 52, above 50");
  input = flow_in_a_pipe();
  input.time_step = 2.6e-3;
  one_warning("long steps", input, "Courant number of the flow is 5.2, above 5");
  input.time_step = 0.11e-3;
  check::is_true("short steps", FlowNumbers(input).warnings().empty());
  input.convects_explicitly = true;
  one_warning("explicit convection", input,
              "is 0.22, above 0.2: explicit convection may be unstable");
  input.time_step = 0.;
  check::is_true("a steady flow has no steps",
                 std::isnan(FlowNumbers(input).value("Courant number of the flow")) &&
                     FlowNumbers(input).warnings().empty());
  input = flow_in_a_pipe();
  input.wave_speed = 0.9;
  input.wave = "the tube wave";
  check::relative("over the wave", FlowNumbers(input).value("mean flow over wave speed"), 0.1 / 0.9,
                  1e-12);
  check::is_true("ends that do not absorb", FlowNumbers(input).warnings().empty());
  input.has_absorbing_end = true;
  one_warning("ends that absorb", input, "11.11 % of the wave speed");
  input.wave_speed = 1.1;
  check::is_true("of a slow flow", FlowNumbers(input).warnings().empty());

  input = flow_in_a_pipe();
  input.viscosity = 0.;
  check::is_true("without viscosity", std::isnan(FlowNumbers(input).value("Reynolds number")) &&
                                          FlowNumbers(input).reynolds_number(1.) == 0.);
  input = flow_in_a_pipe();
  input.boundary.clear();
  const FlowNumbers driven_by_pressure(input);
  check::is_true("driven by a pressure",
                 driven_by_pressure.entries().empty() && driven_by_pressure.warnings().empty() &&
                     check::matches(driven_by_pressure.headline(), "no velocity is prescribed"));
  check::relative("and its speed afterwards", driven_by_pressure.reynolds_number(0.2), 2000.,
                  1e-12);
}
} // namespace test_of_flow_numbers
