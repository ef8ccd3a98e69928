#include <continua/laboratory/amplification_analysis.h>

#include <continua/base/citations.h>
#include <continua/base/interruption.h>
#include <continua/base/joined.h>
#include <continua/base/summary.h>
#include <continua/base/table_writer.h>
#include <continua/laboratory/entries_of_a_body.h>
#include <continua/laboratory/wave_bar.h>
#include <continua/postprocess/writing_rank.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

namespace Continua
{
namespace
{
std::string name_of(const WaveScheme scheme)
{
  return word_of(wave_scheme_words(), scheme);
}

/// What a scheme is like over all waves.
struct Extremes
{
  double smallest_amplitude = std::numeric_limits<double>::infinity();
  double smallest_speed_ratio = std::numeric_limits<double>::infinity();
  double smallest_gain = std::numeric_limits<double>::infinity(); ///< over the first scheme
  double largest_radius = 0., amplitude_difference = 0., speed_ratio_difference = 0.;
};
} // namespace

AmplificationAnalysis::AmplificationAnalysis(const AnalysisInput &input) : Analysis(input)
{
  ParameterSection root = file.root();
  refuse_entries_of_a_body(root, general, "the bar of the amplification is one of plane strain",
                           "the bar of the amplification is cell-wise");
  parameters.read(root.subsection("Amplification"));
  expected = read_expected(root.subsection("Expected"));
  file.refuse_unknown();
  for (const WaveScheme scheme : parameters.schemes)
  {
    for (const char *const quantity :
         {"smallest amplitude", "largest spectral radius", "smallest speed ratio", "ringing angle"})
      quantities.add(quantity, name_of(scheme));
    if (scheme != parameters.schemes.front())
      quantities.add("smallest amplitude over that of " + name_of(parameters.schemes.front()),
                     name_of(scheme));
    if (parameters.runs)
      for (const char *const quantity :
           {"largest difference of amplitude", "largest difference of speed ratio"})
        quantities.add(quantity, name_of(scheme));
  }
  quantities.refuse_unknown(file, root.subsection("Expected"), expected);
}

std::vector<std::string> AmplificationAnalysis::outline() const
{
  std::vector<std::string> lines = Analysis::outline();
  std::vector<std::string> names;
  for (const WaveScheme scheme : parameters.schemes)
    names.push_back(name_of(scheme));
  lines.push_back("schemes: " + joined(names));
  lines.push_back((parameters.runs ? "runs: " : "closed formulas: ") +
                  std::to_string(parameters.schemes.size() * parameters.courant_numbers.size() *
                                 (parameters.most_cells - parameters.fewest_cells + 1)));
  return lines;
}

void AmplificationAnalysis::compute(const OutputDirectory &directory, Log &log, Summary &summary)
{
  summary.set_possible(quantities);
  summary.set("status", "finished");
  compute_waves(directory, log, summary);
  bool all_passed = true;
  for (const std::string &verdict : summary.check(expected, all_passed))
    log.line(verdict);
  if (!is_writing_rank(communicator))
    return;
  summary.write(directory.file("summary.json"));
  Citations().write(directory.file("citation.bib"));
}

void AmplificationAnalysis::compute_waves(const OutputDirectory &directory,
                                          Log &log,
                                          Summary &summary) const
{
  const std::vector<WaveScheme> &schemes = parameters.schemes;
  std::vector<std::string> columns = {"Courant number [1]", "cells in a wavelength [1]",
                                      "angle of a step [rad]"};
  for (const WaveScheme scheme : schemes)
  {
    for (const char *const quantity : {"amplitude", "speed ratio", "spectral radius"})
      columns.push_back(name_of(scheme) + ": " + quantity + " [1]");
    if (parameters.runs)
      for (const char *const quantity : {"amplitude of the run", "speed ratio of the run"})
        columns.push_back(name_of(scheme) + ": " + quantity + " [1]");
  }
  std::unique_ptr<TableWriter> table;
  if (is_writing_rank(communicator))
    table = std::make_unique<TableWriter>(directory.file("amplification.csv"), columns);

  std::vector<Extremes> extremes(schemes.size());
  unsigned int n_done = 0, n_unmeasured = 0;
  const unsigned int n_rows =
      parameters.courant_numbers.size() * (parameters.most_cells - parameters.fewest_cells + 1);
  for (const double courant_number : parameters.courant_numbers)
    for (unsigned int cells = parameters.fewest_cells; cells <= parameters.most_cells; ++cells)
    {
      SignalWatch::stop_if_asked(communicator, "in the amplification of waves");
      const double theta = WaveBar(schemes.front(), cells, courant_number).theta();
      const double of_first = std::abs(amplification_of(schemes.front(), theta).of_wave());
      std::vector<double> row = {courant_number, static_cast<double>(cells), theta};
      for (unsigned int i = 0; i < schemes.size(); ++i)
      {
        const WaveBar bar(schemes[i], cells, courant_number);
        const Amplification amplification = amplification_of(schemes[i], theta);
        const Complex factor = amplification.of_wave();
        const double amplitude = std::abs(factor), speed_ratio = bar.speed_ratio(factor);
        const double radius = amplification.spectral_radius();
        Extremes &of_scheme = extremes[i];
        of_scheme.smallest_amplitude = std::min(of_scheme.smallest_amplitude, amplitude);
        of_scheme.smallest_speed_ratio = std::min(of_scheme.smallest_speed_ratio, speed_ratio);
        of_scheme.smallest_gain = std::min(of_scheme.smallest_gain, amplitude / of_first);
        of_scheme.largest_radius = std::max(of_scheme.largest_radius, radius);
        row.insert(row.end(), {amplitude, speed_ratio, radius});
        if (!parameters.runs)
          continue;
        const std::optional<Complex> measured = bar.measured(factor);
        if (!measured)
        {
          ++n_unmeasured;
          row.insert(row.end(), 2, std::numeric_limits<double>::quiet_NaN());
          continue;
        }
        const double of_run = std::abs(*measured), ratio_of_run = bar.speed_ratio(*measured);
        row.insert(row.end(), {of_run, ratio_of_run});
        of_scheme.amplitude_difference =
            std::max(of_scheme.amplitude_difference, std::abs(of_run - amplitude));
        of_scheme.speed_ratio_difference =
            std::max(of_scheme.speed_ratio_difference, std::abs(ratio_of_run - speed_ratio));
      }
      if (table)
        table->row(row);
      ++n_done;
      log.progress(n_done, n_rows, n_done);
    }
  log.end_progress();
  if (n_unmeasured > 0)
    log.warning("round-off hides the factor of " + std::to_string(n_unmeasured) +
                " runs, since the wave hardly changes or is gone within a few steps; their cells "
                "of the table have no number (nan)");
  if (table)
    table->flush();

  for (unsigned int i = 0; i < schemes.size(); ++i)
  {
    const std::string name = name_of(schemes[i]);
    summary.add({"smallest amplitude", extremes[i].smallest_amplitude, "1", name});
    summary.add({"largest spectral radius", extremes[i].largest_radius, "1", name});
    summary.add({"smallest speed ratio", extremes[i].smallest_speed_ratio, "1", name});
    if (const auto angle = ringing_angle(schemes[i]))
      summary.add({"ringing angle", *angle, "rad", name});
    if (i > 0)
      summary.add({"smallest amplitude over that of " + name_of(schemes.front()),
                   extremes[i].smallest_gain, "1", name});
    if (!parameters.runs)
      continue;
    summary.add({"largest difference of amplitude", extremes[i].amplitude_difference, "1", name});
    summary.add(
        {"largest difference of speed ratio", extremes[i].speed_ratio_difference, "1", name});
  }
}
} // namespace Continua
