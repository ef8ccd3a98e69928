#include <continua/case/theory/station_waves.h>

#include <algorithm>

namespace Continua
{
StationWaves station_waves(const StationsProbe &probe,
                           const WaveModel &theory,
                           const TubeWaveCase &wave_case,
                           const std::vector<double> &times)
{
  // Each station, and the sections of its pair where that is asked for.
  std::vector<double> places = probe.positions;
  if (std::find(probe.fields.begin(), probe.fields.end(), "pressure gradient") !=
      probe.fields.end())
    for (const double position : probe.positions)
      for (const double to_second : {0., probe.pair_distance})
        places.push_back(position + probe.pair_offset + to_second);
  for (double &place : places)
    place = wave_case.place(place);
  std::vector<WaveHistory> waves = theory.histories(places, times, probe.branch);
  for (WaveHistory &wave : waves)
    for (std::vector<double> *const directed : {&wave.flow_rate, &wave.wall_shear_stress})
      for (double &value : *directed)
        value *= wave_case.direction();
  const unsigned int n_stations = probe.positions.size();
  StationWaves result{StationHistories(n_stations), ""};
  StationHistories &histories = result.histories;
  for (unsigned int s = 0; s < n_stations; ++s)
    for (const std::string &field : probe.fields)
    {
      const WaveHistory &wave = waves[s];
      if (field == "pressure gradient")
      {
        const std::vector<double> &first = waves[n_stations + 2 * s].pressure,
                                  &second = waves[n_stations + 2 * s + 1].pressure;
        histories[s].emplace_back();
        for (std::size_t i = 0; i < times.size(); ++i)
          histories[s].back().push_back((second[i] - first[i]) / probe.pair_distance);
      }
      else
        histories[s].push_back(field == "pressure"            ? wave.pressure
                               : field == "axis pressure"     ? wave.axis_pressure
                               : field == "flow rate"         ? wave.flow_rate
                               : field == "velocity integral" ? wave.flow_rate
                               : field == "wall distension"   ? wave.wall_distension
                               : field == "wall shear stress" ? wave.wall_shear_stress
                                                              : wave.hoop_stress);
    }
  for (const WaveHistory &wave : waves)
    if (!wave.end.empty())
      result.end = wave.end + (wave_case.from_outlet && probe.branch == 0
                                   ? ". The vessel starts at the outlet, where the load is"
                                   : "");
  return result;
}
} // namespace Continua
