#include <continua/finite_element/space/point_table.h>

namespace Continua
{
template <int dim>
PointTable<dim>::PointTable(const QuadratureCells<dim> &cells,
                            const Field field,
                            const bool with_slopes)
    : functions(field == Field::velocity ? cells.n_functions() : cells.n_pressures()),
      points(cells.n_points())
{
  const std::size_t numbers_at_point = with_slopes ? dim + 1 : 1;
  row_size = (numbers_at_point * points + sums_block - 1) / sums_block * sums_block;
  table.assign(functions * row_size, 0.);
  for (unsigned int q = 0; q < cells.n_points(); ++q)
  {
    const double *const at_point =
        field == Field::velocity ? cells.table(q) : cells.pressure_table(q);
    for (std::size_t number = 0; number < numbers_at_point; ++number)
      for (std::size_t a = 0; a < functions; ++a)
        table[a * row_size + place(q, number)] = at_point[number * functions + a];
  }
}

template class PointTable<2>;
template class PointTable<3>;
} // namespace Continua
