#include "../unit_test.h"
#include "text_file.h"

#include <continua/base/input_error.h>
#include <continua/base/parameter_file.h>
#include <continua/postprocess/output_parameters.h>

namespace test_of_output_parameters
{
using namespace Continua;

namespace
{
OutputParameters read(const std::string &entries)
{
  write_text("output.prm", "subsection Output\n" + entries + "end\n");
  ParameterFile file("output.prm");
  OutputParameters parameters;
  parameters.read(file.root().subsection("Output"));
  file.refuse_unknown();
  return parameters;
}
} // namespace

UNIT_TEST(output_parameters)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const OutputParameters defaults = read("");
  check::is_true("probes every step", defaults.probe_schedule(1.).due(0.013, 0.001));
  check::is_true("power every step", defaults.power_schedule(1.).due(0.013, 0.001));
  check::is_true("no fields", !defaults.field_schedule(1.).due(0.013, 0.001));
  check::is_true("no first fields", !defaults.field_schedule(1.).due(0., 0.));
  check::is_true("final fields", defaults.field_schedule(1.).due(1., 0.001));
  check::is_true("no checkpoints", !defaults.checkpoint_schedule(1.).due(1., 0.001));
  check::absolute("but one after half an hour", defaults.checkpoint_wall_time, 1800., 0.);
  check::absolute("subdivisions as the degree", defaults.subdivisions_for(2), 2., 0.);

  const OutputParameters given = read("  set Probe interval = 2 ms\n"
                                      "  set Field interval = 0.1 s\n"
                                      "  set Final fields = false\n"
                                      "  set Checkpoint interval = 0.5\n"
                                      "  set Checkpoint at end = true\n"
                                      "  set Subdivisions = 3\n"
                                      "  set Higher order cells = true\n");
  check::is_true("probes at 14 ms", given.probe_schedule(1.).due(0.014, 0.001));
  check::is_true("not at 13 ms", !given.probe_schedule(1.).due(0.013, 0.001));
  check::is_true("first fields", given.field_schedule(1.).due(0., 0.));
  check::is_true("fields at 0.3 s", given.field_schedule(1.).due(0.3, 0.001));
  check::is_true("no final fields", !given.field_schedule(1.05).due(1.05, 0.001));
  check::is_true("checkpoint at 0.5 s", given.checkpoint_schedule(1.).due(0.5, 0.001));
  check::is_true("no first checkpoint", !given.checkpoint_schedule(1.).due(0., 0.));
  check::is_true("checkpoint at end", given.checkpoint_schedule(0.7).due(0.7, 0.001));
  check::absolute("subdivisions", given.subdivisions_for(2), 3., 0.);
  check::is_true("higher order cells", given.higher_order_cells);

  check::throws<InputError>(
      "negative interval", []() { read("  set Probe interval = -1 ms\n"); },
      "output.prm:2: 'Output/Probe interval'");
  check::throws<InputError>(
      "wrong unit", []() { read("  set Field interval = 1 mm\n"); }, "output.prm:2");
  check::throws<InputError>(
      "unknown entry", []() { read("  set Fields interval = 1 s\n"); }, "Field interval");
}
} // namespace test_of_output_parameters
