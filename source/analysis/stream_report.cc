#include <continua/analysis/stream_report.h>

#include <continua/case/theory/stream_case.h>
#include <continua/theory/womersley.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace Continua
{
namespace
{
using StreamDirection = StreamWaves::Direction;

const std::string difference_of_speeds = "wave speed with the stream less that against it";

struct StreamWave
{
  StreamDirection direction;
  StreamWall wall;
  std::string name;
};

const std::vector<StreamWave> &stream_waves()
{
  static const std::vector<StreamWave> waves = {
      {StreamDirection::with_stream, StreamWall::mesh_that_stays,
       "with the stream on the mesh that stays"},
      {StreamDirection::against_stream, StreamWall::mesh_that_stays,
       "against the stream on the mesh that stays"},
      {StreamDirection::with_stream, StreamWall::moving, "with the stream in the moving wall"},
      {StreamDirection::against_stream, StreamWall::moving,
       "against the stream in the moving wall"}};
  return waves;
}

template <int dim>
bool has_stream(const Case<dim> &input)
{
  return input.wave_theory.stream.mean_velocity > 0.;
}

/// The first probe with stations that a pulse passes in this direction; empty if there is none.
template <int dim>
std::string probe_of_direction(const Case<dim> &input, const int direction)
{
  for (const StationsProbe &probe : input.probes.stations())
    if (probe.direction == direction)
      return probe.name;
  return "";
}
} // namespace

template <int dim>
void StreamReport<dim>::check(const Case<dim> &input, ParameterSection root)
{
  if (!has_stream(input))
    return;
  StreamCase stream_case;
  const std::string why_not = make_stream_case(input, stream_case);
  if (!why_not.empty())
    root.subsection("Wave theory")
        .refuse("Mean flow", "the theory of waves on a stream does not cover this case: " + why_not,
                "Leave the entry out, or use a uniform 'tube' with a slower stream");
  // A wave that cannot be found is better known before a run than after it.
  const double frequency = input.wave_theory.stream_frequency;
  for (const StreamWave &wave : stream_waves())
    try
    {
      if (frequency > 0.)
        stream_case.waves->wave_number(2. * dealii::numbers::PI * frequency,
                                       stream_case.distensibility, wave.direction, wave.wall);
    }
    catch (const std::domain_error &error)
    {
      root.subsection("Wave theory")
          .refuse("Mean flow frequency", "there is no wave " + wave.name + ": " + error.what(),
                  "Give a lower frequency, or leave the entry out");
    }
}

template <int dim>
void StreamReport<dim>::name_quantities(const Case<dim> &input, QuantityNames &names)
{
  if (!has_stream(input))
    return;
  for (const StreamWave &wave : stream_waves())
  {
    names.add("long-wave speed " + wave.name);
    if (input.wave_theory.stream_frequency > 0.)
      for (const char *const what : {"speed ", "attenuation "})
        names.add(what + wave.name);
  }
  if (!probe_of_direction(input, 1).empty() && !probe_of_direction(input, -1).empty())
    names.add(difference_of_speeds);
}

template <int dim>
void StreamReport<dim>::add(Run<dim> &run)
{
  if (!has_stream(run.input))
    return;
  StreamCase stream_case;
  const std::string why_not = make_stream_case(run.input, stream_case);
  if (!why_not.empty())
    throw RunError("no waves on the stream: " + why_not);
  const WaveTheoryParameters &parameters = run.input.wave_theory;
  const double omega = 2. * dealii::numbers::PI * parameters.stream_frequency;
  std::ostringstream heading;
  heading << "Waves on a stream of " << parameters.stream.mean_velocity << " m/s";
  run.log.line(heading.str());
  for (const StreamWave &wave : stream_waves())
  {
    const double long_wave = std::abs(stream_case.waves->long_wave_speed(
        stream_case.distensibility.real(), wave.direction, wave.wall));
    run.summary.add({"long-wave speed " + wave.name, long_wave, "m/s", ""});
    std::ostringstream text;
    text << "  " << wave.name << ": long wave " << long_wave << " m/s";
    if (omega > 0.)
      try
      {
        const Complex wave_number = stream_case.waves->wave_number(
            omega, stream_case.distensibility, wave.direction, wave.wall);
        const double speed = std::abs(phase_speed(omega, wave_number)),
                     decay = std::abs(attenuation(wave_number));
        run.summary.add({"speed " + wave.name, speed, "m/s", ""});
        run.summary.add({"attenuation " + wave.name, decay, "1/m", ""});
        text << ", at " << parameters.stream_frequency << " Hz " << speed << " m/s and " << decay
             << " 1/m";
      }
      catch (const std::domain_error &error)
      {
        throw RunError("no wave " + wave.name + ": " + error.what());
      }
    run.log.line(text.str());
  }
}

template <int dim>
void StreamReport<dim>::add_difference(Run<dim> &run)
{
  if (!has_stream(run.input))
    return;
  double speeds[2] = {std::nan(""), std::nan("")};
  for (const Quantity &quantity : run.summary.quantities())
    if (quantity.name == "wave speed by phase")
      for (const int direction : {1, -1})
        if (quantity.probe == probe_of_direction(run.input, direction))
          speeds[direction > 0 ? 0 : 1] = quantity.value;
  if (std::isfinite(speeds[0] - speeds[1]))
    run.summary.add({difference_of_speeds, speeds[0] - speeds[1], "m/s", ""});
}

template class StreamReport<2>;
template class StreamReport<3>;
} // namespace Continua
