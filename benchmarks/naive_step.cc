#include "naive_step.h"

#include <Epetra_CrsMatrix.h>

namespace Benchmarks
{
using namespace dealii;
using namespace Continua;

namespace
{
/// Calls function(row, column, value) for every entry of a matrix on one rank.
template <typename Function>
void for_entries(const TrilinosWrappers::SparseMatrix &matrix, const Function &function)
{
  const Epetra_CrsMatrix &epetra = matrix.trilinos_matrix();
  for (int row = 0; row < epetra.NumMyRows(); ++row)
  {
    int n_entries = 0;
    double *values = nullptr;
    int *columns = nullptr;
    epetra.ExtractMyRowView(row, n_entries, values, columns);
    for (int k = 0; k < n_entries; ++k)
      function(row, epetra.GCID(columns[k]), values[k]);
  }
}
} // namespace

template <int dim>
NaiveStep<dim>::NaiveStep(const Space<dim> &space,
                          const std::vector<RegionOperators> &operators,
                          const BoundaryConstraints<dim> &constraints,
                          const SystemCoefficients &coefficients)
{
  const unsigned int n_velocity = space.velocity_dofs.n_dofs();
  const unsigned int n = n_velocity + space.pressure_dofs.n_dofs();
  const auto is_free = [&](const unsigned int index)
  { return !constraints.all().is_constrained(index); };
  // Calls function(row, column, value) for every entry of the system's matrix.
  const auto for_all = [&](const auto &function)
  {
    for (unsigned int region = 0; region < operators.size(); ++region)
    {
      const auto velocity_block = [&](const double factor)
      {
        return [&function, &is_free, factor](const unsigned int i, const unsigned int j,
                                             const double value)
        {
          if (is_free(i) && is_free(j))
            function(i, j, factor * value);
        };
      };
      for_entries(operators[region].mass, velocity_block(coefficients.mass[region]));
      for_entries(operators[region].stiffness, velocity_block(coefficients.stiffness[region]));
      for_entries(operators[region].divergence,
                  [&](const unsigned int k, const unsigned int j, const double value)
                  {
                    if (!is_free(j))
                      return;
                    function(n_velocity + k, j, -value);
                    function(j, n_velocity + k, -value);
                  });
      for_entries(operators[region].pressure_mass,
                  [&](const unsigned int k, const unsigned int l, const double value) {
                    function(n_velocity + k, n_velocity + l,
                             -coefficients.compressibility[region] * value);
                  });
    }
    for (unsigned int i = 0; i < n_velocity; ++i)
      if (!is_free(i))
        function(i, i, 1.);
  };
  std::vector<unsigned int> row_lengths(n, 1);
  for_all([&](const unsigned int i, unsigned int, double) { ++row_lengths[i]; });
  pattern.reinit(n, n, row_lengths);
  for_all([&](const unsigned int i, const unsigned int j, double) { pattern.add(i, j); });
  pattern.compress();
  matrix.reinit(pattern);
  for_all([&](const unsigned int i, const unsigned int j, const double value)
          { matrix.add(i, j, value); });
}

template class NaiveStep<2>;
template class NaiveStep<3>;
} // namespace Benchmarks
