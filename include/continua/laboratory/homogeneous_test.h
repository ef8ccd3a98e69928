#ifndef continua_laboratory_homogeneous_test_h
#define continua_laboratory_homogeneous_test_h

#include <continua/base/words.h>
#include <continua/materials/strain_law.h>

#include <array>
#include <string>
#include <vector>

namespace Continua
{
/// A test whose strain is the same everywhere in the specimen. Axis 0 is that of the material (or
/// of the tube), axis 1 its circumference, axis 2 the direction of the thickness.
enum class HomogeneousTestType
{
  uniaxial,    ///< pulled along axis 0, free across
  equibiaxial, ///< pulled alike along axes 0 and 1, free across the thickness
  planar,      ///< pulled along axis 0 and held along axis 1, free across the thickness
  shear        ///< x_0 = X_0 + measure X_1, at constant volume
};

/// Uniaxial, equibiaxial, planar and shear.
const Words<HomogeneousTestType> &homogeneous_test_words();

/// What a test finds at a stretch l [1], or at an amount of shear [1].
struct HomogeneousTestPoint
{
  double strain_measure = 0.;    ///< the stretch or the amount of shear [1]
  double nominal_stress = 0.;    ///< force over undeformed area [Pa]
  double cauchy_stress = 0.;     ///< force over the present area [Pa]
  double tangent_modulus = 0.;   ///< d(nominal stress)/d(measure) [Pa]
  double normal_difference = 0.; ///< sigma_00 - sigma_11 [Pa]
  double volume_ratio = 1.;      ///< J [1]
  double energy = 0.;            ///< per reference volume, without that of the pressure [J/m^3]
  PointStrain strain;
};

/// How far a test goes from rest towards a measure.
struct HomogeneousTestEnd
{
  double strain_measure = 0.; ///< the measure asked for, or the last one with equilibrium [1]
  std::string reason;         ///< a sentence on why there is none beyond it; empty if there is
};

/// Equilibrium at a point: principal stretches some of which are given, the others free of stress.
struct PrincipalState
{
  PointStrain strain;
  double pressure = 0.;                   ///< -tr(sigma)/3 [Pa]
  std::array<double, 3> stress = {};      ///< principal Kirchhoff stresses [Pa]
  std::array<double, 3> stress_rate = {}; ///< d stress/d(measure), stretches changing as asked for
};

/**
 * A specimen of one strain everywhere. Its volume follows from the law itself, or from
 * ln J = -p/K as in a run.
 */
class HomogeneousTest
{
public:
  /// `law` must outlive this; `fibres` as of PointStrain.
  HomogeneousTest(const StrainLaw &law,
                  double inverse_bulk_modulus,
                  const std::vector<dealii::Tensor<1, 3>> &fibres);

  /// At a stretch > 0, or an amount of shear. The states of equilibrium are followed from rest with
  /// Newton's method, up to where the free directions shrink to nothing or lose their stability.
  /// This place belongs to the law: neither the range nor the rows of a curve change it. Throws
  /// RunError beyond.
  HomogeneousTestPoint at(HomogeneousTestType type, double strain_measure) const;

  /// The last state towards a measure.
  HomogeneousTestEnd end(HomogeneousTestType type, double strain_measure) const;

  /// The principal stretches [1] along the axes that are `given` stay, the others are sought; the
  /// rates belong to the `logarithmic_rates` of the given ones, d(ln l)/d(measure). Throws
  /// RunError.
  PrincipalState equilibrium(const std::array<double, 3> &stretches,
                             const std::array<bool, 3> &given,
                             const std::array<double, 3> &logarithmic_rates) const;

private:
  const StrainLaw &law;
  double inverse_bulk_modulus; ///< [1/Pa]
  std::vector<dealii::Tensor<1, 3>> fibres;

  HomogeneousTestPoint sheared(double amount) const;
};
} // namespace Continua

#endif
