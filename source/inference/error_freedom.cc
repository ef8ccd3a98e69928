#include <continua/inference/error_freedom.h>

#include <continua/inference/least_squares_factor.h>
#include <continua/inference/whitening.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace Continua
{
namespace
{
using FreedomMatrix = dealii::FullMatrix<double>;
using FreedomColumns = std::vector<std::vector<double>>;

FreedomMatrix information_of(const FreedomColumns &columns)
{
  FreedomMatrix result(columns.size(), columns.size());
  for (unsigned int a = 0; a < columns.size(); ++a)
    for (unsigned int b = 0; b < columns.size(); ++b)
      result(a, b) =
          std::inner_product(columns[a].begin(), columns[a].end(), columns[b].begin(), 0.);
  return result;
}

/// d ln C_jj of C = A^-1 = (J^T J)^-1, for a change of A. The change is given in the orthonormal
/// columns of J: as a change of A its errors would be enlarged by the condition of A, and those of
/// a difference are not small then.
std::vector<double> change_of_log_variances(const FreedomMatrix &covariance,
                                            const FreedomColumns &short_columns,
                                            const FreedomMatrix &change)
{
  std::vector<double> result(covariance.m(), 0.);
  for (unsigned int j = 0; j < covariance.m(); ++j)
  {
    std::vector<double> direction(change.m(), 0.);
    for (unsigned int k = 0; k < change.m(); ++k)
      for (unsigned int a = 0; a < covariance.m(); ++a)
        direction[k] += short_columns[a][k] * covariance(a, j);
    for (unsigned int k = 0; k < change.m(); ++k)
      for (unsigned int l = 0; l < change.m(); ++l)
        result[j] -= direction[k] * change(k, l) * direction[l] / covariance(j, j);
  }
  return result;
}

/// Noise with one coefficient changed; the innovations or, if it is known, the standard deviation
/// stay.
NoiseModel with_changed_coefficient(const NoiseModel &noise,
                                    const unsigned int which,
                                    const double by,
                                    const bool deviation_stays,
                                    const double interval)
{
  NoiseModel changed = noise;
  changed.autoregressive[which] += by;
  if (!deviation_stays)
    changed.standard_deviation *= Whitening(noise, interval).innovation_deviation() /
                                  Whitening(changed, interval).innovation_deviation();
  return changed;
}

/// Derivative of the information of a record by one of its coefficients.
FreedomMatrix derivative_of_information(const DataRecord &record,
                                        const FreedomColumns &coloured,
                                        const unsigned int which,
                                        const bool deviation_stays)
{
  const double step = 1e-6;
  FreedomMatrix result(coloured.size(), coloured.size());
  for (const double side : {-1., 1.})
  {
    const Whitening whitening(with_changed_coefficient(record.noise, which, side * step,
                                                       deviation_stays, record.interval),
                              record.interval);
    FreedomColumns white;
    for (const std::vector<double> &column : coloured)
      white.push_back(whitening.apply(column));
    result.add(side / (2. * step), information_of(white));
  }
  return result;
}

/// Covariance of the estimated coefficients: that of p values, inverted, by the whitening of unit
/// vectors.
FreedomMatrix covariance_of_coefficients(const DataRecord &record)
{
  const unsigned int p = record.noise.autoregressive.size();
  const Whitening whitening(record.noise, record.interval);
  FreedomColumns units;
  for (unsigned int j = 0; j < p; ++j)
  {
    std::vector<double> unit(p, 0.);
    unit[j] = 1.;
    units.push_back(whitening.apply(unit));
  }
  FreedomMatrix result = information_of(units);
  const double innovation = whitening.innovation_deviation();
  result *= innovation * innovation / record.size();
  return result;
}

/// Adds what the noise of one record adds to the variances of the ln C_jj. `white`: the record's
/// rows of the orthonormal columns.
void add_record_variance(std::vector<double> &variances,
                         const DataRecord &record,
                         const EstimatedNoise &estimated,
                         const FreedomColumns &white,
                         const FreedomColumns &short_columns,
                         const FreedomMatrix &covariance,
                         const double n_taken)
{
  if (estimated.deviation)
  {
    const std::vector<double> change =
        change_of_log_variances(covariance, short_columns, information_of(white));
    const double n_left = std::max(record.size() - n_taken, 1e-3);
    for (std::size_t j = 0; j < variances.size(); ++j)
      variances[j] += 2. / n_left * change[j] * change[j];
  }
  if (estimated.n_coefficients == 0)
    return;
  FreedomColumns coloured;
  const Whitening whitening(record.noise, record.interval);
  for (const std::vector<double> &column : white)
    coloured.push_back(whitening.undo(column));
  const FreedomMatrix of_coefficients = covariance_of_coefficients(record);
  std::vector<std::vector<double>> changes;
  for (unsigned int k = 0; k < estimated.n_coefficients; ++k)
    changes.push_back(change_of_log_variances(
        covariance, short_columns,
        derivative_of_information(record, coloured, k, !estimated.deviation)));
  for (std::size_t j = 0; j < variances.size(); ++j)
    for (unsigned int k = 0; k < changes.size(); ++k)
      for (unsigned int l = 0; l < changes.size(); ++l)
        variances[j] += changes[k][j] * of_coefficients(k, l) * changes[l][j];
}
} // namespace

std::vector<double> degrees_of_freedom_of_errors(const std::vector<DataRecord> &records,
                                                 const std::vector<EstimatedNoise> &estimated,
                                                 const std::vector<std::vector<double>> &columns,
                                                 const dealii::FullMatrix<double> &covariance)
{
  std::vector<double> variances(columns.size(), 0.);
  const LeastSquaresFactor factor(columns);
  const std::vector<double> leverages = factor.leverages();
  std::ptrdiff_t begin = 0;
  for (std::size_t r = 0; r < records.size(); ++r)
  {
    const std::ptrdiff_t end = begin + static_cast<std::ptrdiff_t>(records[r].size());
    FreedomColumns white;
    for (const std::vector<double> &column : factor.orthonormal_columns())
      white.emplace_back(column.begin() + begin, column.begin() + end);
    add_record_variance(variances, records[r], estimated[r], white, factor.short_columns(),
                        covariance,
                        std::accumulate(leverages.begin() + begin, leverages.begin() + end, 0.));
    begin = end;
  }
  for (double &variance : variances)
    variance =
        variance > 0. ? std::max(1., 2. / variance) : std::numeric_limits<double>::infinity();
  return variances;
}
} // namespace Continua
