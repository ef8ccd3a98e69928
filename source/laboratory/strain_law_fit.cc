#include <continua/laboratory/strain_law_fit.h>

#include <continua/base/input_error.h>
#include <continua/base/undefined.h>
#include <continua/inference/least_squares_fit.h>
#include <continua/materials/strain_law_types.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
namespace
{
/// Of a table: what its residuals are divided by [Pa].
double largest_stress(const StretchTable &table)
{
  double largest = 0.;
  for (const double stress : table.stresses)
    largest = std::max(largest, std::abs(stress));
  return largest;
}

/// Shear modulus and constants -> nominal stresses of all tables, one after the other, over the
/// largest of the table [1].
class StretchModel : public FitModel
{
public:
  StretchModel(const StrainLawParameters &start,
               const double shear_modulus,
               const double inverse_bulk_modulus,
               const CuttingDirection direction,
               const std::vector<StretchTable> &tables)
      : start(start),
        shear_modulus(shear_modulus),
        inverse_bulk_modulus(inverse_bulk_modulus),
        direction(direction),
        tables(tables)
  {
  }

  StrainLawParameters parameters(const std::vector<double> &set) const
  {
    StrainLawParameters parameters = start;
    std::size_t i = 1;
    for (const StrainLawConstant &constant : strain_law_type(start.type).constants)
      parameters.*constant.member = set[i++];
    return parameters;
  }

  std::vector<Prediction> predict(const std::vector<std::vector<double>> &sets) override
  {
    std::vector<Prediction> predictions;
    for (const std::vector<double> &set : sets)
    {
      Prediction prediction;
      try
      {
        prediction.values = stresses(set);
      }
      catch (const RunError &error)
      {
        prediction.failure = error.what();
      }
      predictions.push_back(prediction);
    }
    return predictions;
  }

private:
  const StrainLawParameters &start;
  const double shear_modulus, inverse_bulk_modulus;
  const CuttingDirection direction;
  const std::vector<StretchTable> &tables;

  std::vector<double> stresses(const std::vector<double> &set) const
  {
    const StrainLawParameters law_parameters = parameters(set);
    // Poisson's ratio stays.
    const double inverse = inverse_bulk_modulus * shear_modulus / set[0];
    const auto strain_law = make_strain_law(law_parameters, set[0], 1. / inverse);
    const HomogeneousTest specimen(*strain_law, inverse,
                                   fibres_of_specimen(law_parameters, direction));
    std::vector<double> values;
    for (const StretchTable &table : tables)
      for (const double strain_measure : table.strain_measures)
      {
        values.push_back(specimen.at(table.type, strain_measure).nominal_stress /
                         largest_stress(table));
        if (!std::isfinite(values.back()))
          throw RunError("the stress is larger than a number can hold");
      }
    return values;
  }
};

std::vector<FitParameter> constants_sought(const StrainLawParameters &start,
                                           const double shear_modulus)
{
  FitParameter modulus;
  modulus.name = "shear modulus";
  modulus.unit = "Pa";
  modulus.start = shear_modulus;
  modulus.lower = 1e-6 * shear_modulus;
  modulus.upper = 1e6 * shear_modulus;
  modulus.scale = FitParameter::Scale::logarithmic;
  std::vector<FitParameter> sought = {modulus};
  for (const StrainLawConstant &constant : strain_law_type(start.type).constants)
  {
    const double value = start.*constant.member;
    FitParameter parameter;
    parameter.name = constant.key;
    parameter.unit = constant.dimension.unit();
    parameter.start = value > 0. ? value : constant.usual;
    parameter.lower = 0.;
    if (constant.is_share)
      parameter.upper = 1.;
    sought.push_back(parameter);
  }
  return sought;
}

/// All tables as one record, since their noise is the same share of the largest stress.
DataRecord data_of_tables(const std::vector<StretchTable> &tables)
{
  DataRecord record;
  record.name = "stress over the largest of its table";
  record.unit = "1";
  record.noise.standard_deviation = undefined;
  for (const StretchTable &table : tables)
    for (std::size_t row = 0; row < table.strain_measures.size(); ++row)
    {
      record.times.push_back(table.strain_measures[row]);
      record.values.push_back(table.stresses[row] / largest_stress(table));
    }
  return record;
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
  StretchModel model(start, shear_modulus, inverse_bulk_modulus, direction, tables);
  StrainLawFit fit;
  fit.sought = constants_sought(start, shear_modulus);
  std::vector<double> first;
  for (const FitParameter &parameter : fit.sought)
    first.push_back(parameter.start);
  if (!model.predict({first})[0].failure.empty())
    throw RunError("the fit of the law cannot begin: with the constants of the parameter file the "
                   "law has no stress in some row of the tables; begin with smaller ones");
  FitOptions options;
  options.tolerance = 1e-6;
  fit.result = LeastSquaresFit(fit.sought, {data_of_tables(tables)}, model, options).solve();
  fit.parameters = model.parameters(fit.result.estimates);
  fit.shear_modulus = fit.result.estimates[0];
  fit.misfit = fit.result.records[0].root_mean_square;
  return fit;
}
} // namespace Continua
