#include <continua/finite_element/space/values_at_points.h>

#include <algorithm>
#include <array>

namespace Continua
{
using namespace dealii;

template <int dim>
ValuesAtPoints<dim>::ValuesAtPoints(const QuadratureCells<dim> &cells,
                                    const Field field,
                                    const bool with_slopes)
    : n_functions(field == Field::velocity ? cells.n_functions() : cells.n_pressures()),
      n_rows(with_slopes ? dim + 1 : 1),
      padded((n_rows * cells.n_points() + block - 1) / block * block),
      table(n_functions * padded, 0.),
      values((field == Field::velocity ? dim : 1) * padded, 0.)
{
  for (unsigned int q = 0; q < cells.n_points(); ++q)
  {
    const double *const at_point =
        field == Field::velocity ? cells.table(q) : cells.pressure_table(q);
    for (std::size_t row = 0; row < n_rows; ++row)
      for (std::size_t a = 0; a < n_functions; ++a)
        table[a * padded + n_rows * q + row] = at_point[row * n_functions + a];
  }
}

template <int dim>
void ValuesAtPoints<dim>::set(const Vector<double> &entries)
{
  const double *of_component = entries.begin();
  for (std::size_t first = 0; first < values.size(); first += padded, of_component += n_functions)
    for (std::size_t i = 0; i < padded; i += block)
    {
      std::array<double, block> sums{};
      for (std::size_t a = 0; a < n_functions; ++a)
        for (std::size_t k = 0; k < block; ++k)
          sums[k] += of_component[a] * table[a * padded + i + k];
      std::copy(sums.begin(), sums.end(), values.begin() + first + i);
    }
}

template class ValuesAtPoints<2>;
template class ValuesAtPoints<3>;
} // namespace Continua
