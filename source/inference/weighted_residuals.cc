#include <continua/inference/weighted_residuals.h>

#include <numeric>

namespace Continua
{
namespace
{
/// Of the coordinate.
double deviation_of_prior(const FitParameter &parameter)
{
  return parameter.prior->standard_deviation /
         parameter.value_per_coordinate(parameter.prior->mean);
}
} // namespace

WeightedResiduals::WeightedResiduals(const std::vector<FitParameter> &parameters,
                                     const std::vector<DataRecord> &records)
    : parameters(parameters), records(records)
{
  for (const DataRecord &record : records)
  {
    whitenings.emplace_back(record.noise, record.interval);
    n_data += record.size();
  }
  for (unsigned int j = 0; j < parameters.size(); ++j)
    if (parameters[j].prior && !parameters[j].is_held())
      priors.push_back(j);
}

std::vector<double> WeightedResiduals::whiten(const std::vector<double> &values) const
{
  const std::vector<std::vector<double>> pieces = by_record(records, values);
  std::vector<double> result;
  result.reserve(n_rows());
  for (std::size_t r = 0; r < records.size(); ++r)
  {
    const std::vector<double> whitened = whitenings[r].apply(pieces[r]);
    result.insert(result.end(), whitened.begin(), whitened.end());
  }
  return result;
}

std::vector<double> WeightedResiduals::rows(const std::vector<double> &set,
                                            const std::vector<double> &prediction) const
{
  std::vector<double> difference = prediction;
  std::size_t i = 0;
  for (const DataRecord &record : records)
    for (const double value : record.values)
      difference[i++] -= value;
  std::vector<double> result = whiten(difference);
  for (const unsigned int j : priors)
  {
    const FitParameter &parameter = parameters[j];
    result.push_back((parameter.coordinate(set[j]) - parameter.coordinate(parameter.prior->mean)) /
                     deviation_of_prior(parameter));
  }
  return result;
}

std::vector<double> WeightedResiduals::with_priors(const unsigned int parameter,
                                                   std::vector<double> whitened) const
{
  for (const unsigned int j : priors)
    whitened.push_back(j == parameter ? 1. / deviation_of_prior(parameters[j]) : 0.);
  return whitened;
}

std::vector<double> WeightedResiduals::column(const unsigned int parameter,
                                              const std::vector<double> &derivative) const
{
  return with_priors(parameter, whiten(derivative));
}

double WeightedResiduals::misfit(const std::vector<double> &set,
                                 const std::vector<double> &prediction) const
{
  const std::vector<double> all = rows(set, prediction);
  return std::inner_product(all.begin(), all.end(), all.begin(), 0.);
}
} // namespace Continua
