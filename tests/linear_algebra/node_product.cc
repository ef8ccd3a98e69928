// Products with M and S in one pass against those of each matrix: a ring of nodes, with one whose
// rows are its diagonal alone, as of a hanging node, and one without rows.

#include <continua/linear_algebra/node_product.h>

#include "dense_systems.h"

#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include "../unit_test.h"

namespace test_of_node_product
{
namespace
{
using namespace Continua;
using namespace dense_systems;
constexpr unsigned int n_nodes = 11, hanging = 4, empty = 7;

unsigned int first_node(const unsigned int rank)
{
  return n_nodes * rank / dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
}

/// Calls entry(node, other) for the entries of the ring.
template <typename Entry>
void for_pairs(const Entry &entry)
{
  for (unsigned int node = 0; node < n_nodes; ++node)
    for (unsigned int step = 0; step < 3; ++step)
    {
      const unsigned int other = (node + n_nodes - 1 + step) % n_nodes;
      const bool is_plain = node != hanging && other != hanging;
      if (node != empty && other != empty && (is_plain || node == other))
        entry(node, other);
    }
}

template <int dim>
void test()
{
  const std::string text = std::to_string(dim) + "-D, ";
  const unsigned int rank = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  dealii::IndexSet owned_rows(dim * n_nodes);
  owned_rows.add_range(dim * first_node(rank), dim * first_node(rank + 1));
  dealii::TrilinosWrappers::SparsityPattern of_mass(owned_rows, owned_rows, MPI_COMM_WORLD),
      of_stiffness(owned_rows, owned_rows, MPI_COMM_WORLD);
  const auto for_entries = [&](const auto &mass_entry, const auto &stiffness_entry)
  {
    for_pairs(
        [&](const unsigned int node, const unsigned int other)
        {
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int d = 0; d < dim; ++d)
            {
              const unsigned int row = dim * node + c, column = dim * other + d;
              if (!owned_rows.is_element(row))
                continue;
              if (c == d)
                mass_entry(row, column, 2. + std::cos(node + 2. * other));
              if (c == d || node != hanging)
                stiffness_entry(row, column, 1. + std::sin(3. * row + 7. * column));
            }
        });
  };
  for_entries([&](const unsigned int i, const unsigned int j, double) { of_mass.add(i, j); },
              [&](const unsigned int i, const unsigned int j, double) { of_stiffness.add(i, j); });
  of_mass.compress();
  of_stiffness.compress();
  Sparse mass, stiffness;
  mass.reinit(of_mass);
  stiffness.reinit(of_stiffness);
  for_entries([&](const unsigned int i, const unsigned int j, const double value)
              { mass.set(i, j, value); },
              [&](const unsigned int i, const unsigned int j, const double value)
              { stiffness.set(i, j, value); });
  mass.compress(dealii::VectorOperation::insert);
  stiffness.compress(dealii::VectorOperation::insert);

  DistributedVector v(owned_rows, MPI_COMM_WORLD);
  DistributedVector w = v;
  for (const auto i : owned_rows)
  {
    v[i] = 1. + 0.3 * i - 0.01 * i * i;
    w[i] = std::sin(1. + i);
  }
  v.compress(dealii::VectorOperation::insert);
  w.compress(dealii::VectorOperation::insert);
  const NodeProduct<dim> product(mass, stiffness);
  check::is_true(text + "nodes in one pass",
                 dealii::Utilities::MPI::sum(product.n_regular_nodes(), MPI_COMM_WORLD) ==
                     n_nodes - 2);
  const std::vector<std::pair<const Sparse *, const DistributedVector *>> factors = {
      {&mass, &v}, {&stiffness, &v}, {&stiffness, &w}};
  double error = 0.;
  bool is_same = true;
  std::vector<DistributedVector> all(3, v);
  product.multiply(v, &w, &all[0], &all[1], &all[2]);
  for (unsigned int which = 0; which < 8; ++which)
  {
    std::vector<DistributedVector> targets(3, v); // of any values before
    const auto target = [&](const unsigned int i)
    { return (which >> i) % 2 == 1 ? &targets[i] : nullptr; };
    product.multiply(v, &w, target(0), target(1), target(2));
    for (unsigned int i = 0; i < 3; ++i)
      if (target(i) != nullptr)
      {
        DistributedVector expected = v;
        factors[i].first->vmult(expected, *factors[i].second);
        expected.add(-1., targets[i]);
        error = std::max(error, expected.linfty_norm());
        targets[i].add(-1., all[i]);
        is_same = is_same && targets[i].linfty_norm() == 0.;
      }
  }
  check::absolute(text + "products", error, 0., 1e-13);
  check::is_true(text + "the same to the last bit with and without the others", is_same);
}
} // namespace

UNIT_TEST(node_product)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  test<2>();
  test<3>();
}
} // namespace test_of_node_product
