#include <continua/linear_algebra/both_triangles.h>

#include <utility>

namespace Continua
{
BothTriangles::BothTriangles(std::unique_ptr<UnsymmetricFactor> factor) : factor(std::move(factor))
{
}

void BothTriangles::factorize(const SymmetricTriplets &matrix, const std::vector<int> &owned)
{
  matrix.check(owned);
  Triplets full{matrix.n, matrix.rows, matrix.columns, matrix.values};
  for (std::size_t k = 0; k < matrix.rows.size(); ++k)
    if (matrix.rows[k] != matrix.columns[k])
    {
      full.rows.push_back(matrix.columns[k]);
      full.columns.push_back(matrix.rows[k]);
      full.values.push_back(matrix.values[k]);
    }
  factor->forget_analysis(); // a factor depends on its matrix alone, as after a restart
  factor->factorize(full, owned);
}
} // namespace Continua
