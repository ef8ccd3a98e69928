// A run in time: its steps, the rows and states it writes at its intervals, the wave it computes,
// the checkpoint from which it goes on, and a run that diverges.

#include "../parameter_text.h"
#include "../postprocess/text_file.h"
#include "column_text.h"

#include <continua/base/input_error.h>
#include <continua/program/analyses.h>

#include <algorithm>
#include <filesystem>

#include "../unit_test.h"

namespace test_of_transient
{
using namespace Continua;

namespace
{
constexpr double time_step = 20e-6;

std::string entries(const unsigned int n_steps, const std::string &more = "")
{
  return "subsection Initial state\nset Velocity = sin(pi * x / 2), 0\nend\n"
         "subsection Time\nset Scheme = crank nicolson\nset Time step = 20 us\n"
         "set Smooth start = false\nset End time = " +
         std::to_string(20 * n_steps) + " us\n" + more +
         "end\n"
         "subsection Probes\nsubsection end\nset Point = 1 m, 0.05 m\n"
         "set Fields = displacement x\nend\nend\n"
         "subsection Output\nset Probe interval = 40 us\nset Power interval = 80 us\n"
         "set Field interval = 160 us\nset Checkpoint at end = true\nend\n";
}

/// Performs the run and returns the end's displacement [m].
double perform(const std::string &text, const bool restart)
{
  ParameterFile file = parameters_of(text);
  CommandLine command_line;
  command_line.restart = restart;
  const std::unique_ptr<Analysis> analysis = analyses().make(file, command_line, MPI_COMM_WORLD);
  const OutputDirectory directory(
      "transient", restart ? OutputDirectory::Mode::restart : OutputDirectory::Mode::overwrite,
      MPI_COMM_WORLD);
  Log log(MPI_COMM_WORLD, false);
  Summary summary;
  analysis->perform(directory, log, summary);
  return quantity(summary, "final displacement x", "end");
}

double n_rows(const std::string &file)
{
  const std::string text = read_text("transient/" + file);
  return std::count(text.begin(), text.end(), '\n') - 1.;
}
} // namespace

UNIT_TEST(transient)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  // Crank-Nicolson takes the amplitude V/w as it is, and arctan(w h/2)/(h/2) for w.
  const double omega = column_text::wave_speed * M_PI / 2.;
  const auto exact = [omega](const unsigned int n_steps)
  { return std::sin(n_steps * 2. * std::atan(omega * time_step / 2.)) / omega; };
  check::relative("displacement after 16 steps",
                  perform(column_text::column("transient", entries(16)), false), exact(16), 1e-4);
  check::absolute("rows of probes.csv", n_rows("probes.csv"), 9., 0.);
  check::absolute("rows of power.csv", n_rows("power.csv"), 4., 0.);
  const std::string states = read_text("transient/fields.pvd");
  unsigned int n_states = 0;
  for (std::size_t at = states.find("timestep="); at != std::string::npos;
       at = states.find("timestep=", at + 1))
    ++n_states;
  check::absolute("states of fields", n_states, 3., 0.);
  check::is_true("summary", read_text("transient/summary.json").find("\"status\": \"finished\"") !=
                                std::string::npos);

  // A later end: the run goes on from its checkpoint, and its tables grow.
  check::relative("displacement after 24 steps",
                  perform(column_text::column("transient", entries(24)), true), exact(24), 1e-4);
  check::absolute("rows after the restart", n_rows("probes.csv"), 13., 0.);

  // The column moves at 1 m/s at most.
  check::throws<RunError>(
      "a run that is too fast",
      []()
      {
        perform(column_text::column("transient", entries(16, "set Velocity limit = 0.5 m/s\n")),
                false);
      },
      "Velocity limit");
  check::is_true("its summary",
                 read_text("transient/summary.json").find("\"status\": \"failed\"") !=
                     std::string::npos);
}
} // namespace test_of_transient
