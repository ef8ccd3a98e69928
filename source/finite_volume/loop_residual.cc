#include <continua/finite_volume/loop_residual.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Continua
{
LoopResidual::LoopResidual(const unsigned int n_components, const MPI_Comm communicator)
    : n_components(n_components), communicator(communicator)
{
  if (n_components == 0 || n_components > most_components)
    throw std::invalid_argument("LoopResidual: one to three components");
}

void LoopResidual::evaluate(const std::size_t n_rows,
                            const double n_rows_global,
                            const double *const residual,
                            const double *const product,
                            const double *const row_sums,
                            const double *const x)
{
  std::array<double, most_components> means = {{0., 0., 0.}};
  for (std::size_t row = 0; row < n_rows; ++row)
    for (unsigned int c = 0; c < n_components; ++c)
      means[c] += x[n_components * row + c];
  MPI_Allreduce(MPI_IN_PLACE, means.data(), most_components, MPI_DOUBLE, MPI_SUM, communicator);

  std::array<double, 2 *most_components> sums = {};
  for (unsigned int c = 0; c < n_components; ++c)
  {
    const double mean = means[c] / n_rows_global;
    for (std::size_t i = c; i < n_components * n_rows; i += n_components)
    {
      const double difference = product[i] - row_sums[i] * mean;
      sums[c] += std::abs(residual[i]);
      sums[most_components + c] += std::abs(difference) + std::abs(difference + residual[i]);
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, sums.data(), 2 * most_components, MPI_DOUBLE, MPI_SUM, communicator);

  const double largest_scale = *std::max_element(sums.begin() + most_components, sums.end());
  constexpr double least_scale = 1e-3;
  largest_residual = 0.;
  sum = 0.;
  for (unsigned int c = 0; c < n_components; ++c)
  {
    const double scale = std::max(sums[most_components + c], least_scale * largest_scale);
    const double of_component = scale == 0. ? 0. : sums[c] / scale;
    // The comparison is false for what is no number, which then stays.
    if (!(of_component <= largest_residual))
      largest_residual = of_component;
    sum += sums[c];
  }
}
} // namespace Continua
