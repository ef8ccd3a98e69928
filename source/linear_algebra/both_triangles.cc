#include <continua/linear_algebra/both_triangles.h>

#include <utility>

namespace Continua
{
BothTriangles::BothTriangles(std::unique_ptr<UnsymmetricFactor> factor) : factor(std::move(factor))
{
}

void BothTriangles::factorize(SymmetricTriplets matrix, const std::vector<int> &owned)
{
  matrix.check(owned);
  const std::size_t n_lower = matrix.rows.size();
  Triplets full{matrix.n, std::move(matrix.rows), std::move(matrix.columns),
                std::move(matrix.values)};
  for (std::size_t k = 0; k < n_lower; ++k)
    if (full.rows[k] != full.columns[k])
    {
      full.rows.push_back(full.columns[k]);
      full.columns.push_back(full.rows[k]);
      full.values.push_back(full.values[k]);
    }
  factor->forget_analysis(); // a factor depends on its matrix alone, as after a restart
  factor->factorize(full, owned);
}
} // namespace Continua
