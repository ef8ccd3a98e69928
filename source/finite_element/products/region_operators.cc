#include <continua/finite_element/products/region_operators.h>
#include <continua/linear_algebra/matrix_operator.h>

#include <continua/mesh/cells_in_tree_order.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/hp/fe_values.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

namespace Continua
{
using namespace dealii;

namespace
{
/// What is assembled.
template <int dim>
struct Wanted
{
  CellFilter<dim> velocity; ///< the cells of mass and stiffness; empty: of none
  bool pressure;            ///< the other two, of all cells

  bool has_velocity(const typename DoFHandler<dim>::active_cell_iterator &cell) const
  {
    return velocity && velocity(cell);
  }
};

/// Sparsity of the matrices of every region, from that region's cells only.
template <int dim>
void reinit_matrices(const Space<dim> &space,
                     const Wanted<dim> &wanted,
                     std::vector<RegionOperators> &operators)
{
  struct Patterns
  {
    TrilinosWrappers::SparsityPattern mass, stiffness, divergence, pressure_mass;
  };
  std::vector<Patterns> patterns(operators.size());
  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    Patterns &pattern = patterns[region];
    if (wanted.velocity)
      for (TrilinosWrappers::SparsityPattern *const velocity : {&pattern.mass, &pattern.stiffness})
        velocity->reinit(space.velocity_owned, space.velocity_owned, space.velocity_relevant,
                         space.communicator);
    if (!wanted.pressure)
      continue;
    pattern.divergence.reinit(space.pressure_owned, space.velocity_owned, space.pressure_relevant,
                              space.communicator);
    pattern.pressure_mass.reinit(space.pressure_owned, space.pressure_owned,
                                 space.pressure_relevant, space.communicator);
  }
  // Mass couples a component with itself only.
  const unsigned int n_velocity = space.velocity_element.n_dofs_per_cell();
  Table<2, bool> same_component(n_velocity, n_velocity);
  for (unsigned int i = 0; i < n_velocity; ++i)
    for (unsigned int j = 0; j < n_velocity; ++j)
      same_component(i, j) = space.velocity_element.system_to_component_index(i).first ==
                             space.velocity_element.system_to_component_index(j).first;

  std::vector<types::global_dof_index> velocity_indices(n_velocity), pressure_indices;
  for (const auto &cell : cells_in_tree_order(space.velocity_dofs))
    if (cell->is_locally_owned())
    {
      const typename DoFHandler<dim>::active_cell_iterator pressure_cell(
          &space.triangulation, cell->level(), cell->index(), &space.pressure_dofs);
      cell->get_dof_indices(velocity_indices);
      pressure_indices.resize(pressure_cell->get_fe().n_dofs_per_cell());
      pressure_cell->get_dof_indices(pressure_indices);
      Patterns &pattern = patterns[cell->material_id()];
      if (wanted.has_velocity(cell))
      {
        space.velocity_hanging.add_entries_local_to_global(velocity_indices, pattern.mass, false,
                                                           same_component);
        space.velocity_hanging.add_entries_local_to_global(velocity_indices, pattern.stiffness,
                                                           false);
      }
      if (!wanted.pressure)
        continue;
      space.pressure_hanging.add_entries_local_to_global(
          pressure_indices, space.velocity_hanging, velocity_indices, pattern.divergence, false);
      space.pressure_hanging.add_entries_local_to_global(pressure_indices, pattern.pressure_mass,
                                                         false);
    }
  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    Patterns &pattern = patterns[region];
    if (wanted.velocity)
    {
      pattern.mass.compress();
      pattern.stiffness.compress();
      operators[region].mass.reinit(pattern.mass);
      operators[region].stiffness.reinit(pattern.stiffness);
    }
    if (!wanted.pressure)
      continue;
    pattern.divergence.compress();
    pattern.pressure_mass.compress();
    operators[region].divergence.reinit(pattern.divergence);
    operators[region].pressure_mass.reinit(pattern.pressure_mass);
  }
}

/// The four matrices of one cell.
template <int dim>
class CellMatrices
{
public:
  explicit CellMatrices(const Space<dim> &space);
  void integrate(const typename DoFHandler<dim>::active_cell_iterator &velocity_cell,
                 const typename DoFHandler<dim>::active_cell_iterator &pressure_cell,
                 bool with_velocity_products);

  FullMatrix<double> mass, stiffness, divergence, pressure_mass;

private:
  const Space<dim> &space;
  /// The velocity's shape functions are those of one scalar element, once for each component.
  const FiniteElement<dim> &scalar_element;
  const Quadrature<dim> quadrature;
  FEValues<dim> values;
  hp::FEValues<dim> hp_pressure_values;
  /// place[c][a]: the cell's dof of component c and scalar function a.
  std::array<std::vector<unsigned int>, dim> place;
  /// Trace of the strain of each velocity dof at one point, and its hoop part.
  std::vector<double> trace, hoop;

  void set_traces(unsigned int q);
  void add_velocity_products(unsigned int q, double weight);
};

template <int dim>
CellMatrices<dim>::CellMatrices(const Space<dim> &space)
    : space(space),
      scalar_element(space.scalar_element()),
      quadrature(space.quadrature(space.n_quadrature_points())),
      values(space.mapping,
             scalar_element,
             quadrature,
             update_values | update_gradients | update_quadrature_points | update_JxW_values),
      hp_pressure_values(
          space.mappings, space.pressure_elements, hp::QCollection<dim>(quadrature), update_values)
{
  const unsigned int n_velocity = space.velocity_element.n_dofs_per_cell();
  mass.reinit(n_velocity, n_velocity);
  stiffness.reinit(n_velocity, n_velocity);
  trace.resize(n_velocity);
  hoop.resize(n_velocity);
  for (auto &indices : place)
    indices.resize(scalar_element.n_dofs_per_cell());
  for (unsigned int i = 0; i < n_velocity; ++i)
  {
    const auto component = space.velocity_element.system_to_component_index(i);
    place[component.first][component.second] = i;
  }
}

template <int dim>
void CellMatrices<dim>::set_traces(const unsigned int q)
{
  for (unsigned int c = 0; c < dim; ++c)
    for (unsigned int a = 0; a < place[c].size(); ++a)
    {
      const unsigned int i = place[c][a];
      hoop[i] = (space.is_axisymmetric() && c == 1)
                    ? values.shape_value(a, q) / values.quadrature_point(q)[1]
                    : 0.;
      trace[i] = values.shape_grad(a, q)[c] + hoop[i];
    }
}

template <int dim>
void CellMatrices<dim>::add_velocity_products(const unsigned int q, const double weight)
{
  const unsigned int n_scalar = place[0].size();
  for (unsigned int a = 0; a < n_scalar; ++a)
    for (unsigned int b = 0; b < n_scalar; ++b)
    {
      const Tensor<1, dim> &gradient_a = values.shape_grad(a, q);
      const Tensor<1, dim> &gradient_b = values.shape_grad(b, q);
      const double scalar_mass = values.shape_value(a, q) * values.shape_value(b, q) * weight;
      const double scalar_laplacian = gradient_a * gradient_b;
      for (unsigned int c = 0; c < dim; ++c)
      {
        const unsigned int i = place[c][a];
        mass(i, place[c][b]) += scalar_mass;
        for (unsigned int d = 0; d < dim; ++d)
        {
          const unsigned int j = place[d][b];
          stiffness(i, j) +=
              weight * ((c == d ? scalar_laplacian : 0.) + gradient_a[d] * gradient_b[c] +
                        2. * hoop[i] * hoop[j] - 2. / 3. * trace[i] * trace[j]);
        }
      }
    }
}

template <int dim>
void CellMatrices<dim>::integrate(
    const typename DoFHandler<dim>::active_cell_iterator &velocity_cell,
    const typename DoFHandler<dim>::active_cell_iterator &pressure_cell,
    const bool with_velocity_products)
{
  values.reinit(static_cast<typename Triangulation<dim>::active_cell_iterator>(velocity_cell));
  hp_pressure_values.reinit(pressure_cell);
  const FEValues<dim> &pressure_values = hp_pressure_values.get_present_fe_values();
  const unsigned int n_velocity = mass.m(), n_pressure = pressure_cell->get_fe().n_dofs_per_cell();
  mass = 0.;
  stiffness = 0.;
  divergence.reinit(n_pressure, n_velocity);
  pressure_mass.reinit(n_pressure, n_pressure);
  for (unsigned int q = 0; q < quadrature.size(); ++q)
  {
    const double weight = values.JxW(q) * space.circumference(values.quadrature_point(q));
    set_traces(q);
    if (with_velocity_products)
      add_velocity_products(q, weight);
    for (unsigned int k = 0; k < n_pressure; ++k)
    {
      const double shape = pressure_values.shape_value(k, q) * weight;
      for (unsigned int i = 0; i < n_velocity; ++i)
        divergence(k, i) += shape * trace[i];
      for (unsigned int l = 0; l < n_pressure; ++l)
        pressure_mass(k, l) += shape * pressure_values.shape_value(l, q);
    }
  }
}

template <int dim>
void assemble(const Space<dim> &space,
              const Wanted<dim> &wanted,
              std::vector<RegionOperators> &operators)
{
  reinit_matrices(space, wanted, operators);
  CellMatrices<dim> matrices(space);
  std::vector<types::global_dof_index> velocity_indices(space.velocity_element.n_dofs_per_cell()),
      pressure_indices;
  for (const auto &cell : cells_in_tree_order(space.velocity_dofs))
    if (cell->is_locally_owned())
    {
      const bool has_velocity = wanted.has_velocity(cell);
      if (!has_velocity && !wanted.pressure)
        continue;
      const typename DoFHandler<dim>::active_cell_iterator pressure_cell(
          &space.triangulation, cell->level(), cell->index(), &space.pressure_dofs);
      matrices.integrate(cell, pressure_cell, has_velocity);
      cell->get_dof_indices(velocity_indices);
      pressure_indices.resize(pressure_cell->get_fe().n_dofs_per_cell());
      pressure_cell->get_dof_indices(pressure_indices);
      RegionOperators &target = operators[cell->material_id()];
      if (has_velocity)
      {
        space.velocity_hanging.distribute_local_to_global(matrices.mass, velocity_indices,
                                                          target.mass);
        space.velocity_hanging.distribute_local_to_global(matrices.stiffness, velocity_indices,
                                                          target.stiffness);
      }
      if (!wanted.pressure)
        continue;
      space.pressure_hanging.distribute_local_to_global(matrices.divergence, pressure_indices,
                                                        space.velocity_hanging, velocity_indices,
                                                        target.divergence);
      space.pressure_hanging.distribute_local_to_global(matrices.pressure_mass, pressure_indices,
                                                        target.pressure_mass);
    }
  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    RegionOperators &target = operators[region];
    if (wanted.velocity)
    {
      target.mass.compress(VectorOperation::add);
      target.stiffness.compress(VectorOperation::add);
      target.products = nullptr;
    }
    if (!wanted.pressure)
      continue;
    target.divergence.compress(VectorOperation::add);
    target.pressure_mass.compress(VectorOperation::add);
  }
}

DistributedVector diagonal_of(const TrilinosWrappers::SparseMatrix &matrix)
{
  return MatrixOperator(matrix).diagonal();
}
} // namespace

void RegionOperators::multiply_mass(DistributedVector &target,
                                    const DistributedVector &source) const
{
  if (products)
    products->multiply(number, 1., 0., target, source);
  else
    multiply(mass, target, source);
}

void RegionOperators::multiply_stiffness(DistributedVector &target,
                                         const DistributedVector &source) const
{
  if (products)
    products->multiply(number, 0., 1., target, source);
  else
    multiply(stiffness, target, source);
}

DistributedVector RegionOperators::mass_diagonal() const
{
  if (!products)
    return diagonal_of(mass);
  DistributedVector diagonal(divergence.locally_owned_domain_indices(),
                             divergence.get_mpi_communicator());
  products->mass_diagonal(number, diagonal);
  return diagonal;
}

DistributedVector RegionOperators::stiffness_diagonal() const
{
  if (!products)
    return diagonal_of(stiffness);
  DistributedVector diagonal(divergence.locally_owned_domain_indices(),
                             divergence.get_mpi_communicator());
  products->stiffness_diagonal(number, diagonal);
  return diagonal;
}

template <int dim>
void assemble_region_operators(const Space<dim> &space, std::vector<RegionOperators> &operators)
{
  assemble(space, Wanted<dim>{all_cells<dim>, true}, operators);
}

template <int dim>
void assemble_pressure_operators(const Space<dim> &space, std::vector<RegionOperators> &operators)
{
  assemble(space, Wanted<dim>{{}, true}, operators);
  for (RegionOperators &region : operators)
  {
    region.mass.clear();
    region.stiffness.clear();
  }
}

template <int dim>
void assemble_velocity_operators(const Space<dim> &space,
                                 const CellFilter<dim> &cells,
                                 std::vector<RegionOperators> &operators)
{
  assemble(space, Wanted<dim>{cells, false}, operators);
}

template <int dim>
void visit_velocity_matrices(
    const Space<dim> &space,
    const CellFilter<dim> &cells,
    const std::function<void(const typename DoFHandler<dim>::active_cell_iterator &cell,
                             const std::vector<types::global_dof_index> &indices,
                             const FullMatrix<double> &mass,
                             const FullMatrix<double> &stiffness)> &visit)
{
  CellMatrices<dim> matrices(space);
  std::vector<types::global_dof_index> indices(space.velocity_element.n_dofs_per_cell());
  for (const auto &cell : cells_in_tree_order(space.velocity_dofs))
    if (cell->is_locally_owned() && cells(cell))
    {
      matrices.integrate(
          cell, {&space.triangulation, cell->level(), cell->index(), &space.pressure_dofs}, true);
      cell->get_dof_indices(indices);
      visit(cell, indices, matrices.mass, matrices.stiffness);
    }
}

std::vector<std::vector<unsigned int>> velocity_nodes(const std::vector<RegionOperators> &operators)
{
  std::vector<std::vector<unsigned int>> nodes;
  nodes.reserve(operators.size());
  for (const RegionOperators &region : operators)
    nodes.push_back(region.products ? region.products->nodes(region.number)
                                    : rows_with_values(region.stiffness));
  return nodes;
}

std::vector<std::vector<unsigned int>> pressure_nodes(const std::vector<RegionOperators> &operators)
{
  std::vector<std::vector<unsigned int>> nodes;
  nodes.reserve(operators.size());
  for (const RegionOperators &region : operators)
    nodes.push_back(rows_with_values(region.pressure_mass));
  return nodes;
}

template void assemble_region_operators(const Space<2> &, std::vector<RegionOperators> &);
template void assemble_region_operators(const Space<3> &, std::vector<RegionOperators> &);
template void assemble_pressure_operators(const Space<2> &, std::vector<RegionOperators> &);
template void assemble_velocity_operators(const Space<2> &,
                                          const CellFilter<2> &,
                                          std::vector<RegionOperators> &);
template void assemble_pressure_operators(const Space<3> &, std::vector<RegionOperators> &);
template void assemble_velocity_operators(const Space<3> &,
                                          const CellFilter<3> &,
                                          std::vector<RegionOperators> &);
template void
visit_velocity_matrices(const Space<2> &,
                        const CellFilter<2> &,
                        const std::function<void(const DoFHandler<2>::active_cell_iterator &,
                                                 const std::vector<types::global_dof_index> &,
                                                 const FullMatrix<double> &,
                                                 const FullMatrix<double> &)> &);
template void
visit_velocity_matrices(const Space<3> &,
                        const CellFilter<3> &,
                        const std::function<void(const DoFHandler<3>::active_cell_iterator &,
                                                 const std::vector<types::global_dof_index> &,
                                                 const FullMatrix<double> &,
                                                 const FullMatrix<double> &)> &);
} // namespace Continua
