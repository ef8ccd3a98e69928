#ifndef continua_studies_simulation_model_h
#define continua_studies_simulation_model_h

#include <continua/base/output_directory.h>
#include <continua/studies/forward_model.h>

#include <string>
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

/**
 * The run in time of a file as a model: each question is a run of its own, in a process and a folder
 * of its own, as many at a time as there are cores. Its histories are those of probes.csv, between
 * the steps by cubic splines. The folder of a run that has ended well is removed again.
 */
class SimulationModel : public ForwardModel
{
public:
  /// `directory`: of the study, which gets the folders "NAME-1", "NAME-2" ...
  SimulationModel(const CommandLine &command_line,
                  const OutputDirectory &directory,
                  std::vector<ProbeColumns> probes,
                  unsigned int n_parallel,
                  std::string name_of_runs);

  std::vector<ForwardAnswer> answers(const std::vector<ForwardQuestion> &questions) override;
  std::string name() const override { return "simulation"; }

private:
  CommandLine command_line;
  const OutputDirectory &directory;
  std::vector<ProbeColumns> probes;
  unsigned int n_parallel;
  std::string name_of_runs;
  unsigned int n_runs = 0;

  /// Of a run that has ended, from its folder.
  ForwardAnswer read(const std::string &folder, const ForwardQuestion &question) const;
};
} // namespace Continua

#endif
