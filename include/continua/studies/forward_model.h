#ifndef continua_studies_forward_model_h
#define continua_studies_forward_model_h

#include <continua/base/command_line.h>
#include <continua/case/theory/station_waves.h>

#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/// What a model is asked: the case of a parameter file with some entries set.
struct ForwardQuestion
{
  std::vector<std::pair<std::string, std::string>> settings; ///< "Section/Key" and a value each
  /// [s], increasing, of each probe with stations; none before t = 0, where the body is at rest.
  std::vector<std::vector<double>> times;
};

/// What it says.
struct ForwardAnswer
{
  std::vector<StationHistories> histories; ///< of each probe with stations, at the times asked for
  std::string failure;                     ///< why there are none; empty: there are
};

/// Numbers of a parameter file -> histories at the stations of its probes, without an output folder
/// of its own.
class ForwardModel
{
public:
  virtual ~ForwardModel() = default;
  /// One answer a question; several may be worked out side by side. Throws Interrupted.
  virtual std::vector<ForwardAnswer> answers(const std::vector<ForwardQuestion> &questions) = 0;
  /// "linear wave theory", "simulation".
  virtual std::string name() const = 0;
};

/// The command line whose file has no measurements at stations and no expected values: for runs
/// that are asked for their histories alone. Throws InputError.
CommandLine without_data(const CommandLine &command_line);
} // namespace Continua

#endif
