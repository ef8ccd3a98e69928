#ifndef continua_materials_relaxation_test_h
#define continua_materials_relaxation_test_h

#include <continua/base/parameter_section.h>

#include <cstddef>
#include <string>
#include <vector>

namespace Continua
{
/**
 * A tensile test in which a strain is reached and held (section 5.3 of the thesis): stress over the
 * strain that is held, row by row of a table, the loading included.
 */
struct RelaxationTest
{
  std::string file;           ///< of the table; empty: there is none
  std::vector<double> times;  ///< since the start of the loading [s], increasing
  std::vector<double> moduli; ///< [Pa]
  double strain = 0.;         ///< that is held [1]
  double loading_time = 0.;   ///< until it is reached, evenly [s]
  std::size_t first_used = 0; ///< the rows before it are left out of the fit

  /// The time of a row for a law of a sudden strain [s]. A strain that rises evenly within t0 is
  /// felt at t like a sudden one in the middle of the loading, t - t0/2, but for the share
  /// n (n + 1)/24 (t0/(t - t0/2))^2 of the stress.
  double law_time(std::size_t row) const { return times[row] - 0.5 * loading_time; }
};

/// Y(t) = c (t/1 s)^-n (equation 5.2) as a test shows it.
struct RelaxationFit
{
  double modulus = 0.;  ///< c [Pa]
  double exponent = 0.; ///< n [1]
  double misfit = 0.;   ///< root of the mean square of ln(Y/(c t^-n)) over the rows used [1]
};

/// Rows at times below so many loading times are left out of a fit: what law_time() leaves is then
/// below 2e-4 for n up to 0.06, and 0.002 for any n up to 0.6.
constexpr double loading_times_left_out = 5.;

/**
 * Declares `Relaxation table`, `Cross-section`, `Strain` and `Loading time` in the section of a
 * power law, and reads the table: a csv file (CsvTable) with the columns time and force or stress;
 * others are not looked at. It may be called again. Throws InputError, also for fewer than three
 * rows that can be used, for times that do not increase and for stresses that are not positive.
 */
RelaxationTest read_relaxation_test(ParameterSection section);

/// The straight line of least squares through ln Y over ln t: what the thesis looks for by Nelder
/// and Mead's minimisation is linear in the logarithms.
RelaxationFit fit_relaxation_test(const RelaxationTest &test);
} // namespace Continua

#endif
