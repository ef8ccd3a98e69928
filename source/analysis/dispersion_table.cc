#include <continua/analysis/dispersion_table.h>

#include <continua/base/table_writer.h>
#include <continua/theory/closed_form_waves.h>
#include <continua/theory/dispersion_curves.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

namespace Continua
{
void write_dispersion_table(const std::string &file,
                            const TubeSection &section,
                            const double highest_frequency,
                            const bool only_long_waves)
{
  constexpr double two_pi = 6.28318530717958647692;
  constexpr unsigned int n_rows = 80;
  std::vector<double> frequencies;
  // The first guesses are those of waves that are long beside the radius.
  double lowest = 1e-3 * highest_frequency;
  if (!section.layers.empty())
  {
    const double speed =
        std::sqrt(std::abs(section.hoop_modulus(two_pi)) * section.wall_thickness() /
                  (2. * section.inner_radius * section.fluid.density));
    lowest = std::min(lowest, 0.02 * speed / (two_pi * section.inner_radius));
  }
  for (unsigned int i = 0; i < n_rows; ++i)
    frequencies.push_back(lowest * std::pow(highest_frequency / lowest, i / (n_rows - 1.)));
  // Without any loss families cannot be told apart while they are followed: a millionth of the
  // lowest frequency is taken as growth in time.
  const double shift = 1e-6 * two_pi * frequencies.front();
  std::unique_ptr<DispersionCurves> exact;
  std::unique_ptr<ExactDispersion> dispersion;
  std::vector<ExactDispersion::Family> families;
  if (!only_long_waves)
  {
    exact = std::make_unique<DispersionCurves>(section, shift, frequencies);
    dispersion = std::make_unique<ExactDispersion>(section);
    families = exact->families();
  }

  std::vector<std::string> header = {"frequency [Hz]"};
  for (const ExactDispersion::Family family : families)
    if (family == ExactDispersion::pressure_wave || family == ExactDispersion::axial_wave)
    {
      const std::string name =
          family == ExactDispersion::pressure_wave ? "pressure wave: " : "axial wave: ";
      for (const char *quantity : {"phase speed [m/s]", "group speed [m/s]", "attenuation [1/m]"})
        header.push_back(name + quantity);
    }
    else
    {
      const std::string name =
          family == ExactDispersion::bending_wave ? "bending wave: " : "other bending wave: ";
      for (const char *quantity : {"wave number [1/m]", "attenuation [1/m]"})
        header.push_back(name + quantity);
    }
  const std::vector<WaveLevel> levels =
      only_long_waves ? std::vector<WaveLevel>{WaveLevel::womersley}
                      : std::vector<WaveLevel>{WaveLevel::closed_formula, WaveLevel::membrane,
                                               WaveLevel::womersley};
  for (const WaveLevel level : levels)
    for (const char *quantity : {": phase speed [m/s]", ": attenuation [1/m]"})
      header.push_back(word_of(wave_level_words(), level) + quantity);

  TableWriter table(file, header);
  std::vector<WaveMode> modes, closed;
  for (unsigned int i = 0; i < n_rows; ++i)
  {
    const double frequency = frequencies[i], omega = two_pi * frequency;
    if (exact)
      exact->evaluate(frequency, modes);
    std::vector<double> row = {frequency};
    for (unsigned int m = 0; m < modes.size(); ++m)
    {
      const std::complex<double> k = modes[m].wave_number;
      if (families[m] == ExactDispersion::pressure_wave ||
          families[m] == ExactDispersion::axial_wave)
      {
        row.push_back(omega / k.real());
        row.push_back(dispersion->group_speed({omega, -shift}, k));
      }
      else
        row.push_back(k.real());
      row.push_back(-k.imag());
    }
    for (const WaveLevel level : levels)
    {
      std::complex<double> k = std::numeric_limits<double>::quiet_NaN();
      try
      {
        ClosedFormWaves(section, level, 0.).evaluate(frequency, closed);
        k = closed[0].wave_number;
      }
      catch (const std::domain_error &)
      {
        // Above the ring frequency of the wall there is no such wave.
      }
      row.push_back(omega / k.real());
      row.push_back(-k.imag());
    }
    table.row(row);
  }
  table.flush();
}
} // namespace Continua
