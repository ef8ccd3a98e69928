#include <continua/linear_algebra/matrix_product.h>
#include <continua/linear_algebra/node_product.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/exceptions.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_FEVector.h>
#include <Epetra_Import.h>
#include <Epetra_Vector.h>

#include <cstddef>
#include <utility>

namespace Continua
{
using namespace dealii;

namespace
{
/// False where the rows do not stand in one piece. Not collective.
template <typename Rows>
bool take_rows(const Epetra_CrsMatrix &matrix, Rows &rows)
{
  int *offsets = nullptr, *columns = nullptr;
  double *values = nullptr;
  if (!matrix.StorageOptimized() || matrix.ExtractCrsDataPointers(offsets, columns, values) != 0)
    return false;
  rows = {offsets, columns, values};
  return true;
}

/// The entries of a vector that the columns of a matrix refer to.
const double *entries_of_columns(const Epetra_CrsMatrix &matrix,
                                 const DistributedVector &vector,
                                 Epetra_Vector *const complete)
{
  if (complete == nullptr)
    return vector.begin();
  const int status = complete->Import(vector.trilinos_vector(), *matrix.Importer(), Insert);
  AssertThrow(status == 0, LACExceptions::ExcTrilinosError(status));
  return complete->Values();
}

double row_sum(const int *const columns,
               const double *const values,
               const int n,
               const double *const source)
{
  double sum = 0.;
  for (int k = 0; k < n; ++k)
    sum += values[k] * source[columns[k]];
  return sum;
}
} // namespace

template <int dim>
NodeProduct<dim>::NodeProduct(const TrilinosWrappers::SparseMatrix &mass,
                              const TrilinosWrappers::SparseMatrix &stiffness)
    : mass(mass), stiffness(stiffness)
{
  const Epetra_CrsMatrix &of_mass = mass.trilinos_matrix(),
                         &of_stiffness = stiffness.trilinos_matrix();
  const bool have_rows = take_rows(of_mass, mass_rows) && take_rows(of_stiffness, stiffness_rows) &&
                         of_mass.NumMyRows() == of_stiffness.NumMyRows() &&
                         of_mass.NumMyRows() % dim == 0;
  is_one_pass = of_mass.ColMap().SameAs(of_stiffness.ColMap()) &&
                Utilities::MPI::min(have_rows ? 1 : 0, mass.get_mpi_communicator()) == 1;
  if (!is_one_pass)
    return;
  if (of_stiffness.Importer() != nullptr)
    for (std::unique_ptr<Epetra_Vector> *complete : {&complete_velocity, &complete_displacement})
      *complete = std::make_unique<Epetra_Vector>(of_stiffness.ColMap());
  const unsigned int n_nodes = of_mass.NumMyRows() / dim;
  for (unsigned int node = 0; node < n_nodes; ++node)
  {
    if (is_regular(node))
    {
      regular_nodes.push_back(node);
      continue;
    }
    for (unsigned int row = dim * node; row < dim * (node + 1); ++row)
      if (mass_rows.offsets[row] < mass_rows.offsets[row + 1] ||
          stiffness_rows.offsets[row] < stiffness_rows.offsets[row + 1])
        other_rows.push_back(row);
      else
        has_empty_rows = true;
  }
}

template <int dim>
NodeProduct<dim>::~NodeProduct() = default;

template <int dim>
bool NodeProduct<dim>::is_regular(const unsigned int node) const
{
  const unsigned int first = dim * node;
  const int *const of_mass = mass_rows.offsets + first, *const of_stiffness =
                                                            stiffness_rows.offsets + first;
  const int n = of_mass[1] - of_mass[0];
  if (n == 0)
    return false;
  for (unsigned int c = 0; c < dim; ++c)
  {
    if (of_mass[c + 1] - of_mass[c] != n || of_stiffness[c + 1] - of_stiffness[c] != dim * n)
      return false;
    for (int k = 0; k < n; ++k)
    {
      const int column = mass_rows.columns[of_mass[0] + k];
      if (mass_rows.columns[of_mass[c] + k] != column + static_cast<int>(c) ||
          mass_rows.values[of_mass[c] + k] != mass_rows.values[of_mass[0] + k])
        return false;
      for (unsigned int d = 0; d < dim; ++d)
        if (stiffness_rows.columns[of_stiffness[c] + dim * k + d] != column + static_cast<int>(d))
          return false;
    }
  }
  return true;
}

template <int dim>
template <bool with_mass, bool of_velocity, bool of_displacement>
void NodeProduct<dim>::multiply_nodes(const Pass &pass) const
{
  for (const unsigned int node : regular_nodes)
  {
    const int begin = mass_rows.offsets[dim * node];
    const int *const columns = mass_rows.columns + begin;
    const double *const of_mass = mass_rows.values + begin;
    const double *const of_stiffness = stiffness_rows.values + stiffness_rows.offsets[dim * node];
    const std::ptrdiff_t n = mass_rows.offsets[dim * node + 1] - begin, of_row = dim * n;
    double inertia[dim] = {}, strain[dim][dim] = {}, rate[dim][dim] = {};
    for (std::ptrdiff_t k = 0; k < n; ++k)
    {
      const double *const v = pass.velocity + columns[k];
      if constexpr (with_mass)
        for (unsigned int c = 0; c < dim; ++c)
          inertia[c] += of_mass[k] * v[c];
      for (unsigned int c = 0; c < dim; ++c)
      {
        const double *const block = of_stiffness + of_row * c + dim * k;
        if constexpr (of_velocity)
          for (unsigned int d = 0; d < dim; ++d)
            rate[c][d] += block[d] * v[d];
        if constexpr (of_displacement)
        {
          const double *const w = pass.displacement + columns[k];
          for (unsigned int d = 0; d < dim; ++d)
            strain[c][d] += block[d] * w[d];
        }
      }
    }
    for (unsigned int c = 0; c < dim; ++c)
    {
      double sum_of_rate = 0., sum_of_strain = 0.;
      for (unsigned int d = 0; d < dim; ++d)
      {
        sum_of_rate += rate[c][d];
        sum_of_strain += strain[c][d];
      }
      if constexpr (with_mass)
        pass.mass_of_velocity[dim * node + c] = inertia[c];
      if constexpr (of_velocity)
        pass.stiffness_of_velocity[dim * node + c] = sum_of_rate;
      if constexpr (of_displacement)
        pass.stiffness_of_displacement[dim * node + c] = sum_of_strain;
    }
  }
}

template <int dim>
template <bool with_mass>
void NodeProduct<dim>::multiply_with(const Pass &pass) const
{
  const bool of_velocity = pass.stiffness_of_velocity != nullptr,
             of_displacement = pass.stiffness_of_displacement != nullptr;
  if (of_velocity && of_displacement)
    multiply_nodes<with_mass, true, true>(pass);
  else if (of_velocity)
    multiply_nodes<with_mass, true, false>(pass);
  else if (of_displacement)
    multiply_nodes<with_mass, false, true>(pass);
  else
    multiply_nodes<with_mass, false, false>(pass);
}

template <int dim>
void NodeProduct<dim>::multiply_other_rows(const Pass &pass) const
{
  const auto product = [](const Rows &rows, const unsigned int row, const double *const source)
  {
    const int begin = rows.offsets[row];
    return row_sum(rows.columns + begin, rows.values + begin, rows.offsets[row + 1] - begin,
                   source);
  };
  for (const unsigned int row : other_rows)
  {
    if (pass.mass_of_velocity != nullptr)
      pass.mass_of_velocity[row] = product(mass_rows, row, pass.velocity);
    if (pass.stiffness_of_velocity != nullptr)
      pass.stiffness_of_velocity[row] = product(stiffness_rows, row, pass.velocity);
    if (pass.stiffness_of_displacement != nullptr)
      pass.stiffness_of_displacement[row] = product(stiffness_rows, row, pass.displacement);
  }
}

template <int dim>
void NodeProduct<dim>::multiply(const DistributedVector &velocity,
                                const DistributedVector *const displacement,
                                DistributedVector *const mass_of_velocity,
                                DistributedVector *const stiffness_of_velocity,
                                DistributedVector *const stiffness_of_displacement) const
{
  if (!is_one_pass)
  {
    if (mass_of_velocity != nullptr)
      Continua::multiply(mass, *mass_of_velocity, velocity);
    if (stiffness_of_velocity != nullptr)
      Continua::multiply(stiffness, *stiffness_of_velocity, velocity);
    if (stiffness_of_displacement != nullptr)
      Continua::multiply(stiffness, *stiffness_of_displacement, *displacement);
    return;
  }
  Pass pass{};
  pass.velocity =
      entries_of_columns(stiffness.trilinos_matrix(), velocity, complete_velocity.get());
  if (stiffness_of_displacement != nullptr)
    pass.displacement =
        entries_of_columns(stiffness.trilinos_matrix(), *displacement, complete_displacement.get());
  const auto set_target = [this](double *&entries, DistributedVector *const target)
  {
    if (target == nullptr)
      return;
    if (has_empty_rows)
      *target = 0.;
    entries = target->begin();
  };
  set_target(pass.mass_of_velocity, mass_of_velocity);
  set_target(pass.stiffness_of_velocity, stiffness_of_velocity);
  set_target(pass.stiffness_of_displacement, stiffness_of_displacement);
  if (pass.mass_of_velocity != nullptr)
    multiply_with<true>(pass);
  else
    multiply_with<false>(pass);
  multiply_other_rows(pass);
}

template class NodeProduct<2>;
template class NodeProduct<3>;
} // namespace Continua
