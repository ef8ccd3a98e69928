#ifndef continua_laboratory_laboratory_parameters_h
#define continua_laboratory_laboratory_parameters_h

#include <continua/base/words.h>
#include <continua/laboratory/large_strain_parameters.h>

#include <string>
#include <vector>

namespace Continua
{
/// The one element of the simulated tests.
enum class SpecimenShape
{
  cylinder,
  cube
};

const Words<SpecimenShape> &specimen_words();

/// The section Laboratory: what is reported of a material, and the tests that are simulated.
struct LaboratoryParameters
{
  std::vector<std::string> tests; ///< some of test_names(), or of those of large strains
  bool is_large_strain = false;   ///< whether the tests are those of a hyperelastic law
  LargeStrainParameters large_strain;
  SpecimenShape specimen = SpecimenShape::cylinder;
  double lowest_frequency = 0.5; ///< of the table of the modulus [Hz]
  double highest_frequency = 100.;
  unsigned int points_per_decade = 20;
  double fundamental = 0.5;        ///< of the mean modulus [Hz]
  unsigned int n_harmonics = 40;   ///< of it, beside the one of order 0
  double strain = 0.03;            ///< of relaxation, and amplitude of harmonic tests [1]
  double loading_time = 0.;        ///< of relaxation [s]
  double stress = 0.;              ///< of creep [Pa]
  std::vector<double> frequencies; ///< of harmonic tests [Hz]
  unsigned int steps_per_period = 100;
  unsigned int n_periods = 100; ///< at most

  /// At small strains.
  static std::vector<std::string> test_names();
  bool has(const std::string &test) const;

  /// Declares and reads; throws InputError.
  void read(ParameterSection section);
  /// Whether a test has time steps.
  bool has_steps() const;

private:
  void read_small_strain(ParameterSection &section);
  void check_tests(const ParameterSection &section) const;
};
} // namespace Continua

#endif
