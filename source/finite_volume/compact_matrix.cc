#include <continua/finite_volume/compact_matrix.h>

#include <algorithm>

namespace Continua
{
template <int dim>
void CompactMatrix<dim>::reinit(const unsigned int first_entry, const unsigned int n_components)
{
  first = first_entry;
  components = n_components;
  sums.assign(n_components * mesh.n_owned_cells(), 0.);
  couplings.clear();
}

template <int dim>
void CompactMatrix<dim>::couple(const VolumeFace<dim> &face,
                                const std::array<unsigned int, 2> &places,
                                const double coefficient)
{
  couplings.push_back({places,
                       {{mesh.cells()[face.cell(0)].number, mesh.cells()[face.cell(1)].number}},
                       coefficient});
}

template <int dim>
void CompactMatrix<dim>::factorize(const unsigned int component, SymmetricFactor &factor) const
{
  SymmetricTriplets matrix;
  matrix.n = static_cast<int>(mesh.cell_dofs.n_dofs());
  const auto add = [&](const unsigned int row, const unsigned int column, const double value)
  {
    matrix.rows.push_back(static_cast<int>(std::max(row, column)));
    matrix.columns.push_back(static_cast<int>(std::min(row, column)));
    matrix.values.push_back(value);
  };
  std::vector<int> owned;
  for (unsigned int cell = 0; cell < mesh.n_owned_cells(); ++cell)
  {
    const unsigned int number = mesh.cells()[cell].number;
    owned.push_back(static_cast<int>(number));
    add(number, number, sums[components * cell + component]);
  }
  for (const Coupling &coupling : couplings)
    for (unsigned int side = 0; side < 2; ++side)
      if (is_owned(coupling.places[side]))
      {
        add(coupling.numbers[side], coupling.numbers[side], coupling.coefficient);
        // Between two ranks the first cell's puts it in.
        if (side == 0)
          add(coupling.numbers[0], coupling.numbers[1], -coupling.coefficient);
      }
  factor.factorize(matrix, owned);
}

template <int dim>
void CompactMatrix<dim>::multiply(const Vector &x, Vector &product) const
{
  const double *const u = x.begin();
  double *const y = product.begin();
  for (std::size_t i = 0; i < sums.size(); ++i)
    y[first + i] = sums[i] * u[first + i];
  for (const Coupling &coupling : couplings)
    for (unsigned int side = 0; side < 2; ++side)
      if (is_owned(coupling.places[side]))
        for (unsigned int c = 0; c < components; ++c)
        {
          const unsigned int here = coupling.places[side] + c,
                             there = coupling.places[1 - side] + c;
          y[here] += coupling.coefficient * (u[here] - u[there]);
        }
}

template class CompactMatrix<2>;
template class CompactMatrix<3>;
} // namespace Continua
