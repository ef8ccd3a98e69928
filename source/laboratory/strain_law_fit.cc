#include <continua/laboratory/strain_law_fit.h>

#include <continua/base/input_error.h>
#include <continua/base/quiet_gsl.h>
#include <continua/materials/strain_law_types.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace Continua
{
namespace
{
struct FreeFitWorkspace
{
  void operator()(gsl_multifit_nlinear_workspace *w) const { gsl_multifit_nlinear_free(w); }
};

/// What GSL works on: the search begins at 0 in every unknown.
struct StretchFit
{
  const StrainLawParameters &start;
  double shear_modulus;
  double inverse_bulk_modulus;
  CuttingDirection direction;
  const std::vector<StretchTable> &tables;

  /// The law at these unknowns: the logarithm of the shear modulus, squares of the other constants
  /// and of a share that of a sine, which reach 0 and come back where logarithms would stay there.
  StrainLawFit law(const gsl_vector *unknowns) const
  {
    StrainLawFit fit;
    fit.parameters = start;
    fit.shear_modulus = shear_modulus * std::exp(gsl_vector_get(unknowns, 0));
    std::size_t i = 1;
    for (const StrainLawConstant &constant : strain_law_type(start.type).constants)
    {
      const double change = gsl_vector_get(unknowns, i++);
      double &value = fit.parameters.*constant.member;
      const double first = value > 0. ? value : constant.usual;
      // From an end of the range no direction leads away.
      if (constant.is_share)
        value = std::pow(std::sin(std::asin(std::sqrt(std::min(first, 0.95))) + change), 2);
      else
        value = first * std::pow(1. + change, 2);
    }
    return fit;
  }

  /// One after the other, over the largest of the table. Returns whether the law has a stress in
  /// every row.
  bool set_residuals(const gsl_vector *unknowns, gsl_vector *result) const
  {
    // GSL gives up where a residual is not there; from a large one it turns back.
    constexpr double far_away = 1e6;
    gsl_vector_set_all(result, far_away);
    const StrainLawFit fit = law(unknowns);
    // Poisson's ratio stays.
    const double ratio = fit.shear_modulus / shear_modulus;
    if (!std::isfinite(ratio) || !(ratio > 0.))
      return false;
    const double inverse = inverse_bulk_modulus / ratio;
    const auto strain_law = make_strain_law(fit.parameters, fit.shear_modulus, 1. / inverse);
    const HomogeneousTest specimen(*strain_law, inverse,
                                   fibres_of_specimen(fit.parameters, direction));
    bool is_complete = true;
    std::size_t i = 0;
    for (const StretchTable &table : tables)
    {
      double largest = 0.;
      for (const double stress : table.stresses)
        largest = std::max(largest, std::abs(stress));
      for (std::size_t row = 0; row < table.measures.size(); ++row, ++i)
        try
        {
          const double stress = specimen.at(table.type, table.measures[row]).nominal_stress;
          const double residual = (stress - table.stresses[row]) / largest;
          if (std::abs(residual) < far_away)
            gsl_vector_set(result, i, residual);
          else
            is_complete = false;
        }
        catch (const RunError &)
        {
          is_complete = false;
        }
    }
    return is_complete;
  }
};

int residuals_of_stretch_fit(const gsl_vector *unknowns, void *data, gsl_vector *result)
{
  static_cast<const StretchFit *>(data)->set_residuals(unknowns, result);
  return GSL_SUCCESS;
}
} // namespace

std::vector<dealii::Tensor<1, 3>> fibres_of_specimen(const StrainLawParameters &parameters,
                                                     const CuttingDirection direction)
{
  const dealii::Tensor<1, 3> first({1., 0., 0.}), second({0., 1., 0.});
  return direction == CuttingDirection::axial ? parameters.fibres(first, second)
                                              : parameters.fibres(second, first);
}

StrainLawFit fit_strain_law(const StrainLawParameters &start,
                            const double shear_modulus,
                            const double inverse_bulk_modulus,
                            const CuttingDirection direction,
                            const std::vector<StretchTable> &tables)
{
  StretchFit problem{start, shear_modulus, inverse_bulk_modulus, direction, tables};
  gsl_multifit_nlinear_fdf system{};
  system.f = residuals_of_stretch_fit; // its derivatives are differences
  for (const StretchTable &table : tables)
    system.n += table.measures.size();
  system.p = 1 + strain_law_type(start.type).constants.size();
  system.params = &problem;
  const QuietGsl quiet;
  gsl_multifit_nlinear_parameters settings = gsl_multifit_nlinear_default_parameters();
  settings.fdtype = GSL_MULTIFIT_NLINEAR_CTRDIFF;
  settings.h_df = 1e-5; // of central differences: round-off and error are both about 1e-10
  const std::unique_ptr<gsl_multifit_nlinear_workspace, FreeFitWorkspace> workspace(
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &settings, system.n, system.p));
  const std::vector<double> zero(system.p, 0.);
  const gsl_vector_const_view first = gsl_vector_const_view_array(zero.data(), zero.size());
  std::vector<double> at_start(system.n);
  gsl_vector_view residuals = gsl_vector_view_array(at_start.data(), at_start.size());
  if (!problem.set_residuals(&first.vector, &residuals.vector) || !workspace ||
      gsl_multifit_nlinear_init(&first.vector, &system, workspace.get()) != GSL_SUCCESS)
    throw RunError("the fit of the law cannot begin: with the constants of the parameter file the "
                   "law has no stress in some row of the tables; begin with smaller ones");
  int reason = 0;
  gsl_multifit_nlinear_driver(500, 1e-10, 1e-14, 0., nullptr, nullptr, &reason, workspace.get());
  StrainLawFit fit = problem.law(gsl_multifit_nlinear_position(workspace.get()));
  const gsl_vector *residual = gsl_multifit_nlinear_residual(workspace.get());
  double sum = 0.;
  for (std::size_t i = 0; i < system.n; ++i)
    sum += std::pow(gsl_vector_get(residual, i), 2);
  fit.misfit = std::sqrt(sum / system.n);
  return fit;
}
} // namespace Continua
