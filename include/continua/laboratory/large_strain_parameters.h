#ifndef continua_laboratory_large_strain_parameters_h
#define continua_laboratory_large_strain_parameters_h

#include <continua/laboratory/homogeneous_test.h>

#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/// A measured curve of a test.
struct StretchTable
{
  HomogeneousTestType type = HomogeneousTestType::uniaxial;
  std::string file;
  std::vector<double> strain_measures; ///< stretches or amounts of shear [1]
  std::vector<double> stresses;        ///< nominal [Pa]
};

/// The direction in which a specimen of a wall is cut.
enum class CuttingDirection
{
  axial,
  circumferential
};

/// What the section Laboratory has for tests at large strains.
struct LargeStrainParameters
{
  double smallest_stretch = 1.;
  double largest_stretch = 2.;
  double largest_shear = 1.;
  unsigned int n_points = 50; ///< rows of a curve
  CuttingDirection direction = CuttingDirection::axial;
  double axial_stretch = 1.;  ///< of inflation [1]
  double radius = 0.;         ///< of the middle of the undeformed wall [m]
  double wall_thickness = 0.; ///< undeformed [m]
  double held_stretch = 0.;   ///< of stretch relaxation [1]
  double held_shear = 0.;     ///< of shear relaxation [1]
  double loading_time = 0.;   ///< of both [s]
  std::vector<StretchTable> tables;

  static std::vector<std::string> test_names();

  /// Declares and reads; `tests`: those that are asked for. Throws InputError.
  void read(ParameterSection &section, const std::vector<std::string> &tests);
};
} // namespace Continua

#endif
