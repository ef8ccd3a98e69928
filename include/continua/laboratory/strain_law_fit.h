#ifndef continua_laboratory_strain_law_fit_h
#define continua_laboratory_strain_law_fit_h

#include <continua/inference/fit_parameter.h>
#include <continua/inference/fit_result.h>
#include <continua/laboratory/large_strain_parameters.h>
#include <continua/materials/strain_law_parameters.h>

#include <vector>

namespace Continua
{
/// A law whose constants follow measured curves.
struct StrainLawFit
{
  StrainLawParameters parameters;
  double shear_modulus = 0.; ///< [Pa]
  /// Root of the mean square of (law - measured)/(largest measured) over all rows; of each table
  /// its own largest.
  double misfit = 0.;
  std::vector<FitParameter> sought; ///< `shear modulus` and the constants, called as their entries
  FitResult result;                 ///< with standard errors
};

/**
 * The constants of the law that follow all tables most closely, in the sense of the misfit, by
 * nonlinear least squares (LeastSquaresFit): the shear modulus and the constants that the row of
 * the law names, in their ranges. The angle and the dispersion of fibres stay; so does the ratio of
 * shear and bulk modulus. `start` and `shear_modulus` [Pa] are where the search begins. `direction`
 * as of LargeStrainParameters. Throws RunError where no law follows from the start, and
 * std::invalid_argument for no more rows than constants.
 */
StrainLawFit fit_strain_law(const StrainLawParameters &start,
                            double shear_modulus,
                            double inverse_bulk_modulus,
                            CuttingDirection direction,
                            const std::vector<StretchTable> &tables);

/// The fibres of a specimen that is cut in that direction, whose axis 0 is pulled.
std::vector<dealii::Tensor<1, 3>> fibres_of_specimen(const StrainLawParameters &parameters,
                                                     CuttingDirection direction);
} // namespace Continua

#endif
