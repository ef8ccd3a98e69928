#ifndef continua_studies_simulation_model_h
#define continua_studies_simulation_model_h

#include <continua/base/output_directory.h>
#include <continua/studies/forward_model.h>
#include <continua/studies/planned_run.h>

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/// What a probe records, for its columns in probes.csv.
struct ProbeColumns
{
  std::string probe;
  unsigned int n_stations;
  std::vector<std::string> fields;
};

/// A table that a run has written.
struct RunColumns
{
  std::vector<std::string> names;
  std::vector<std::vector<double>> values; ///< by column
};

/**
 * The run in time of a file as a model: each set of entries is a run of its own, in a process and a
 * folder of its own, as many at a time as there are cores. Its histories are those of probes.csv,
 * between the steps by cubics. They are kept: other times need no other run. The folder of a run
 * that has ended well is removed again. A run that a signal ends or that has too little memory says
 * nothing of its numbers: RunPool tries it again, alone, and `warn` gets a line on it.
 */
class SimulationModel : public ForwardModel
{
public:
  /// `directory`: of the study, which gets the folders "NAME-1", "NAME-2" ... `memory` [B]: what a
  /// run may need. `program`: its path; another one for tests.
  SimulationModel(const CommandLine &command_line,
                  const OutputDirectory &directory,
                  std::vector<ProbeColumns> probes,
                  unsigned int n_parallel,
                  std::string name_of_runs,
                  double memory,
                  std::function<void(const std::string &)> warn,
                  std::string program = "/proc/self/exe");

  /// Throws RunError if a run that was tried again says nothing of its numbers again.
  std::vector<ForwardAnswer> answers(const std::vector<ForwardQuestion> &questions) override;
  std::string name() const override { return "simulation"; }

private:
  CommandLine command_line;
  const OutputDirectory &directory;
  std::vector<ProbeColumns> probes;
  unsigned int n_parallel;
  std::string name_of_runs;
  double memory; ///< [B]
  std::function<void(const std::string &)> warn;
  std::string program;
  unsigned int n_runs = 0;
  using Settings = std::vector<std::pair<std::string, std::string>>;
  std::map<Settings, RunColumns> histories; ///< of the runs that ended well
  std::map<Settings, std::string> failures; ///< of the others

  /// A run and what it is of.
  struct Plan
  {
    PlannedRun run;
    Settings settings;
  };
  Plan plan(const Settings &settings);
  /// Performs the runs for what is not known.
  void run(const std::vector<Settings> &all);
  ForwardAnswer answer(const RunColumns &table, const ForwardQuestion &question) const;
};
} // namespace Continua

#endif
