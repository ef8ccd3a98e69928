#ifndef continua_case_theory_station_waves_h
#define continua_case_theory_station_waves_h

#include <continua/case/theory/tube_wave_case.h>
#include <continua/postprocess/probes.h>

#include <vector>

namespace Continua
{
/// Values by station, field and time, of the fields of a probe [SI].
using StationHistories = std::vector<std::vector<std::vector<double>>>;

/// What theory says of the fields of a probe.
struct StationWaves
{
  StationHistories histories;
  std::string end; ///< as that of WaveHistory
};

/// At these times [s], from 0 to the theory's end.
StationWaves station_waves(const StationsProbe &probe,
                           const WaveModel &theory,
                           const TubeWaveCase &wave_case,
                           const std::vector<double> &times);
} // namespace Continua

#endif
