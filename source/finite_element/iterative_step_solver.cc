#include <continua/finite_element/iterative_step_solver.h>

#include <continua/base/input_error.h>
#include <continua/base/memory_limit.h>
#include <continua/finite_element/block_factor_estimate.h>
#include <continua/finite_element/chebyshev_relaxation.h>
#include <continua/finite_element/condensed_system.h>
#include <continua/finite_element/interface_compliance.h>
#include <continua/finite_element/matrix_free_regions.h>
#include <continua/finite_element/polynomial_multigrid.h>
#include <continua/finite_element/stalled_block.h>
#include <continua/finite_element/velocity_nodes.h>
#include <continua/linear_algebra/convergence_factor.h>
#include <continua/linear_algebra/matrix_product.h>
#include <continua/linear_algebra/matrix_relaxation.h>

#include <deal.II/base/mpi.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Continua
{
using namespace dealii;

namespace
{
/// Coordinates of the owned pressures, one vector for each direction [m]. Where pressures are
/// broken at interfaces, those of each region are shifted away from those of the others.
template <int dim>
SchurComplement::Places places_of_pressures(const Space<dim> &space, const unsigned int n_regions)
{
  SchurComplement::Places places(dim, std::vector<double>(space.pressure_owned.n_elements(), 0.));
  std::vector<unsigned int> components(space.pressure_owned.n_elements(), 0);
  std::vector<bool> is_known(space.pressure_owned.n_elements(), false);
  std::vector<types::global_dof_index> indices;
  double size = 0.;
  for (const auto &cell : space.pressure_dofs.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      const FiniteElement<dim> &element = cell->get_fe();
      indices.resize(element.n_dofs_per_cell());
      cell->get_dof_indices(indices);
      for (unsigned int i = 0; i < indices.size(); ++i)
        if (space.pressure_owned.is_element(indices[i]))
        {
          const unsigned int local = space.pressure_owned.index_within_set(indices[i]);
          if (is_known[local])
            continue;
          is_known[local] = true;
          // Each call maps all support points of the cell.
          const Point<dim> point =
              space.mapping.transform_unit_to_real_cell(cell, element.unit_support_point(i));
          for (unsigned int c = 0; c < dim; ++c)
            places[c][local] = point[c];
          components[local] = space.pressure_component(cell->material_id());
          size = std::max(size, point.norm());
        }
    }
  if (n_regions == 1)
    return places;
  const double shift = 10. * Utilities::MPI::max(size, space.communicator);
  for (std::size_t i = 0; i < components.size(); ++i)
    places[0][i] += shift * components[i];
  return places;
}
} // namespace

template <int dim>
IterativeStepSolver<dim>::IterativeStepSolver(const Space<dim> &space,
                                              const std::vector<RegionOperators> &operators,
                                              const BoundaryConstraints<dim> &constraints,
                                              const LinearSolverParameters &parameters,
                                              MemoryUse *const memory_use)
    : space(space),
      operators(operators),
      constraints(constraints),
      parameters(parameters),
      memory_use(memory_use),
      divergence(space, operators, constraints),
      solver(parameters.restart_length),
      last_velocity(space.velocity_vector()),
      last_pressure(space.pressure_vector())
{
}

template <int dim>
bool IterativeStepSolver<dim>::is_near(const SystemCoefficients &others) const
{
  const auto near = [](const std::vector<double> &a, const std::vector<double> &b)
  {
    for (std::size_t i = 0; i < a.size(); ++i)
      if (a[i] > 2. * b[i] || b[i] > 2. * a[i])
        return false;
    return true;
  };
  return near(coefficients.mass, others.mass) && near(coefficients.stiffness, others.stiffness) &&
         near(coefficients.compressibility, others.compressibility);
}

template <int dim>
bool IterativeStepSolver<dim>::prepare(const SystemCoefficients &wanted)
{
  coefficients = wanted;
  const bool is_first = !matrix_free_velocity && !assembled_velocity;
  if (is_first && parameters.is_matrix_free(space.degree()))
  {
    // The products of regions, if there are any, are of the same object.
    auto regions =
        std::dynamic_pointer_cast<const MatrixFreeRegions<dim>>(operators.front().products);
    if (!regions)
      regions = std::make_shared<MatrixFreeRegions<dim>>(space, constraints, operators.size(),
                                                         parameters.instruction_set);
    matrix_free_velocity = std::make_unique<MatrixFreeVelocity<dim>>(space, operators, constraints,
                                                                     regions->product());
  }
  if (matrix_free_velocity)
    matrix_free_velocity->set(coefficients);
  else
  {
    assemble_velocity_block(space, operators, constraints, coefficients, nullptr, nullptr,
                            velocity_matrix);
    assembled_velocity = std::make_unique<MatrixOperator>(velocity_matrix);
  }
  assemble_pressure_mass(space, operators, coefficients.compressibility, compression);
  solver.reinit(blocks());
  if (is_first)
    mark_memory("blocks of the system");
  if (preconditioner && !preconditioner->is_worn && is_near(preconditioner->coefficients))
    return false;
  make_preconditioner();
  return true;
}

template <int dim>
const VelocityOperator &IterativeStepSolver<dim>::velocity_operator() const
{
  if (matrix_free_velocity)
    return *matrix_free_velocity;
  return *assembled_velocity;
}

template <int dim>
VelocityBlocks IterativeStepSolver<dim>::velocity_blocks(const std::vector<bool> &stiff_regions,
                                                         DistributedVector &mobility,
                                                         double &fluid_ratio) const
{
  VelocityBlocks result;
  result.n_components = dim;
  fluid_ratio = 0.;
  for (const unsigned int i : nodes_in_order(space.velocity_dofs))
  {
    const auto global = space.velocity_owned.nth_index_in_set(i);
    double inertia = 0., stiffness = 0.;
    bool is_stiff = false, is_soft = false;
    // A hanging node has no equation of its own.
    const bool is_hanging = space.velocity_hanging.is_constrained(global);
    if (!is_hanging)
      for (unsigned int region = 0; region < operators.size(); ++region)
        if (is_of_region[region][i])
        {
          inertia += coefficients.mass[region] * mass_diagonals[region].begin()[i];
          stiffness += coefficients.stiffness[region] * stiffness_diagonals[region].begin()[i];
          (stiff_regions[region] ? is_stiff : is_soft) = true;
        }
    if (!is_hanging)
      (is_stiff ? result.stiff : result.fluid).push_back(i);
    if (!is_stiff && inertia > 0.)
      fluid_ratio = std::max(fluid_ratio, stiffness / inertia);
    // What a pressure moves. A soft region feels the interface as stiff as it is.
    const double resistance =
        is_stiff && is_soft ? velocity_operator().diagonal().begin()[i] : inertia;
    mobility.begin()[i] = resistance > 0. ? 1. / resistance : 0.;
  }
  fluid_ratio = Utilities::MPI::max(fluid_ratio, space.communicator);
  return result;
}

template <int dim>
void IterativeStepSolver<dim>::let_walls_yield(const std::vector<bool> &stiff_regions,
                                               VelocityPreconditioner &velocity_inverse,
                                               DistributedVector &mobility) const
{
  DistributedVector load = space.velocity_vector(), of_region = load, inertia = load;
  DistributedVector one = space.pressure_vector(), volumes = one;
  one = 1.;
  double volume = 0.;
  for (unsigned int region = 0; region < operators.size(); ++region)
    if (!stiff_regions[region])
    {
      multiply_transposed(operators[region].divergence, of_region, one);
      load.add(1., of_region);
      multiply(operators[region].pressure_mass, volumes, one);
      volume += volumes * one;
    }
  constraints.restrict_to_free(load);
  for (unsigned int i = 0; i < load.locally_owned_size(); ++i)
  {
    if (load.begin()[i] == 0.)
      continue;
    bool is_stiff = false, is_soft = false;
    for (unsigned int region = 0; region < operators.size(); ++region)
      if (is_of_region[region][i])
      {
        inertia.begin()[i] += coefficients.mass[region] * mass_diagonals[region].begin()[i];
        (stiff_regions[region] ? is_stiff : is_soft) = true;
      }
    if (!is_stiff || !is_soft)
      load.begin()[i] = 0.;
  }
  if (load.linfty_norm() == 0.)
    return;
  const DistributedVector compliance =
      interface_compliance<dim>(space, nodes_in_order(space.velocity_dofs), load, volume,
                                [&](DistributedVector &velocity, const DistributedVector &force)
                                { velocity_inverse.solve_stiff(velocity, force); });
  // A wall that nothing holds moves without bound, or as fast as its inertia lets it.
  for (unsigned int i = 0; i < load.locally_owned_size(); ++i)
    if (compliance.begin()[i] > mobility.begin()[i] && inertia.begin()[i] > 0.)
      mobility.begin()[i] = std::min(compliance.begin()[i], 1. / inertia.begin()[i]);
}

template <int dim>
std::vector<unsigned int>
IterativeStepSolver<dim>::find_stiff_pressures(const std::vector<bool> &stiff_regions) const
{
  std::vector<bool> is_stiff(space.pressure_owned.n_elements(), false);
  const std::vector<std::vector<unsigned int>> nodes = pressure_nodes(operators);
  // The others take back what a continuous pressure shares with them.
  for (const bool of_stiff : {true, false})
    for (unsigned int region = 0; region < operators.size(); ++region)
      if (stiff_regions[region] == of_stiff)
        for (const unsigned int i : nodes[region])
          is_stiff[i] = of_stiff;
  std::vector<unsigned int> result;
  for (unsigned int i = 0; i < is_stiff.size(); ++i)
    if (is_stiff[i] &&
        !space.pressure_hanging.is_constrained(space.pressure_owned.nth_index_in_set(i)))
      result.push_back(i);
  return result;
}

template <int dim>
std::vector<bool> IterativeStepSolver<dim>::find_stiff_regions()
{
  const unsigned int n_regions = operators.size();
  is_of_region.assign(n_regions, std::vector<bool>(space.velocity_owned.n_elements(), false));
  const std::vector<std::vector<unsigned int>> nodes = velocity_nodes(operators);
  for (unsigned int region = 0; region < n_regions; ++region)
    for (const unsigned int i : nodes[region])
      is_of_region[region][i] = true;
  std::vector<double> ratios(n_regions, 0.);
  for (unsigned int region = 0; region < n_regions; ++region)
    for (unsigned int i = 0; i < space.velocity_owned.n_elements(); ++i)
    {
      const auto global = space.velocity_owned.nth_index_in_set(i);
      if (space.velocity_hanging.is_constrained(global) || !is_of_region[region][i])
        continue;
      const double inertia = coefficients.mass[region] * mass_diagonals[region].begin()[i];
      const double stiffness =
          coefficients.stiffness[region] * stiffness_diagonals[region].begin()[i];
      ratios[region] = std::max(ratios[region], inertia > 0. ? stiffness / inertia : 1e300);
    }
  Utilities::MPI::max(ratios, space.communicator, ratios);
  const double largest =
      *std::max_element(coefficients.stiffness.begin(), coefficients.stiffness.end());
  std::vector<bool> stiff_regions(n_regions);
  for (unsigned int region = 0; region < n_regions; ++region)
    stiff_regions[region] =
        ratios[region] > stiff_ratio && coefficients.stiffness[region] >= comparable * largest;
  return stiff_regions;
}

template <int dim>
bool IterativeStepSolver<dim>::relaxes_without_matrix(const std::vector<bool> &stiff_regions,
                                                      const VelocityBlocks &parts) const
{
  if (!matrix_free_velocity || parts.fluid_is_viscous)
    return false;
  // Its products have no supports, and those of stiff regions are in the stiff block.
  if (coefficients.support_stiffness == 0. && coefficients.support_damping == 0.)
    return true;
  for (unsigned int region = 0; region < operators.size(); ++region)
    if (operators[region].is_supported && !stiff_regions[region])
      return false;
  return true;
}

template <int dim>
std::vector<RegionOperators>
IterativeStepSolver<dim>::assembled_at(const std::vector<bool> &rows) const
{
  DistributedVector is_wanted = space.velocity_vector();
  for (unsigned int i = 0; i < rows.size(); ++i)
    is_wanted.begin()[i] = rows[i] ? 1. : 0.;
  DistributedVector ghosted(space.velocity_owned, space.velocity_relevant, space.communicator);
  ghosted = is_wanted;
  std::vector<types::global_dof_index> indices(space.velocity_element.n_dofs_per_cell());
  const auto is_at_row = [&](const typename DoFHandler<dim>::active_cell_iterator &cell)
  {
    cell->get_dof_indices(indices);
    for (const auto index : indices)
    {
      if (ghosted[index] > 0.)
        return true;
      if (space.velocity_hanging.is_constrained(index))
        for (const auto &entry : *space.velocity_hanging.get_constraint_entries(index))
          if (ghosted[entry.first] > 0.)
            return true;
    }
    return false;
  };
  std::vector<RegionOperators> result(operators.size());
  assemble_velocity_operators<dim>(space, is_at_row, result);
  for (unsigned int region = 0; region < operators.size(); ++region)
    if (operators[region].is_supported)
    {
      result[region].is_supported = true;
      result[region].support_stiffness.copy_from(operators[region].support_stiffness);
      result[region].support_damping.copy_from(operators[region].support_damping);
    }
  return result;
}

template <int dim>
void IterativeStepSolver<dim>::add_velocities(SaddlePointBlock &block,
                                              const std::vector<unsigned int> &stiff) const
{
  using Cell = typename DoFHandler<dim>::active_cell_iterator;
  const AffineConstraints<double> &lines = constraints.all();
  std::vector<types::global_dof_index> indices(space.velocity_element.n_dofs_per_cell());

  std::vector<int> of_others;
  for (const auto &cell : space.velocity_dofs.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      cell->get_dof_indices(indices);
      for (const auto index : indices)
        if (lines.is_constrained(index))
          for (const auto &entry : *lines.get_constraint_entries(index))
            of_others.push_back(static_cast<int>(entry.first));
        else if (!space.velocity_owned.is_element(index))
          of_others.push_back(static_cast<int>(index));
    }
  block.learn_numbers(of_others);

  // The rows of the block that each velocity of a cell stands for, with their weights.
  std::vector<std::vector<std::pair<int, double>>> rows(indices.size());
  const auto find_rows = [&]()
  {
    std::size_t n_rows = 0;
    for (unsigned int i = 0; i < indices.size(); ++i)
    {
      rows[i].clear();
      const auto add = [&](const types::global_dof_index velocity, const double weight)
      {
        const int row = block.number(static_cast<int>(velocity));
        if (row >= 0)
          rows[i].emplace_back(row, weight);
      };
      if (!lines.is_constrained(indices[i]))
        add(indices[i], 1.);
      else
        for (const auto &[master, weight] : *lines.get_constraint_entries(indices[i]))
          add(master, weight);
      n_rows += rows[i].size();
    }
    return n_rows;
  };
  std::size_t n_entries = 0;
  std::vector<int> of_cell;
  std::vector<bool> is_of_block(space.triangulation.n_active_cells(), false);
  for (const auto &cell : space.velocity_dofs.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      cell->get_dof_indices(indices);
      const std::size_t n_rows = find_rows();
      is_of_block[cell->active_cell_index()] = n_rows > 0;
      // Half of the pairs, and what a row has with itself, which several velocities may give.
      of_cell.clear();
      for (const auto &of_velocity : rows)
        for (const auto &entry : of_velocity)
          of_cell.push_back(entry.first);
      std::sort(of_cell.begin(), of_cell.end());
      std::size_t n_on_diagonal = 0;
      for (std::size_t k = 0, first = 0; k < n_rows; ++k)
      {
        if (of_cell[k] != of_cell[first])
          first = k;
        n_on_diagonal += 2 * (k - first) + 1; // adds up to the square of how often it is there
      }
      n_entries += (n_rows * n_rows + n_on_diagonal) / 2;
    }
  const TrilinosWrappers::SparseMatrix *const supports = matrix_free_velocity->support_matrix();
  if (supports != nullptr)
    block.add_velocity_entries(supports->trilinos_matrix());
  block.reserve(n_entries + stiff.size());

  visit_velocity_matrices<dim>(
      space, [&](const Cell &cell) { return is_of_block[cell->active_cell_index()]; },
      [&](const Cell &cell, const std::vector<types::global_dof_index> &indices_of_cell,
          const FullMatrix<double> &mass, const FullMatrix<double> &stiffness)
      {
        indices = indices_of_cell;
        find_rows();
        const double of_mass = coefficients.mass[cell->material_id()],
                     of_stiffness = coefficients.stiffness[cell->material_id()];
        for (unsigned int i = 0; i < rows.size(); ++i)
          for (unsigned int j = 0; j < rows.size(); ++j)
          {
            const double value = of_mass * mass(i, j) + of_stiffness * stiffness(i, j);
            for (const auto &[row, of_row] : rows[i])
              for (const auto &[column, of_column] : rows[j])
                if (column <= row)
                  block.add_velocity_entry(row, column, of_row * of_column * value);
          }
      });
  // A constrained velocity has no equation. The supports have a one there, too.
  for (const unsigned int i : stiff)
  {
    const auto index = space.velocity_owned.nth_index_in_set(i);
    const int row = block.number(static_cast<int>(index));
    if (lines.is_constrained(index) && supports == nullptr)
      block.add_velocity_entry(row, row, 1.);
  }
}

template <int dim>
void IterativeStepSolver<dim>::make_velocity_inverse(
    Preconditioner &made,
    const std::vector<bool> &stiff_regions,
    const std::vector<unsigned int> &stiff_pressures,
    const VelocityBlocks &parts,
    const bool has_joint_block)
{
  const bool is_matrix_free = relaxes_without_matrix(stiff_regions, parts);
  // Augmented by a bulk modulus of alpha, or compressible enough for a factor.
  VolumetricStiffness volumetric;
  std::vector<double> compressibility = coefficients.compressibility;
  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    const double alpha = coefficients.stiffness[region];
    if (has_joint_block && stiff_regions[region])
      compressibility[region] = std::max(compressibility[region], least_compressibility / alpha);
    const bool is_augmented = stiff_regions[region] && !has_joint_block &&
                              parameters.schur_complement != SchurApproximation::simple;
    volumetric.coefficients.push_back(is_augmented ? alpha : 0.);
  }
  // Without a relaxation by the matrix only the rows of the stiff block are needed.
  const bool needs_all_rows = made.has_fluid && !is_matrix_free;
  const bool needs_stiff_rows = made.has_stiff && !made.has_polynomial_multigrid;
  // Where the regions have no matrices the joint block has none either, but its entries alone.
  const bool has_matrix =
      needs_all_rows || (needs_stiff_rows &&
                         !(has_joint_block && matrix_free_velocity && operators.front().products));
  if (has_matrix)
    assemble_rows(needs_all_rows ? nullptr : &parts.stiff, volumetric, made.velocity_matrix);

  std::unique_ptr<VelocityRelaxation> relaxation;
  if (made.has_fluid && is_matrix_free)
  {
    auto chebyshev = std::make_unique<ChebyshevRelaxation<dim>>(
        single_precision_cells(),
        typename ChebyshevRelaxation<dim>::Product::Coefficients{
            coefficients.mass, coefficients.stiffness, volumetric.coefficients},
        parts.fluid);
    made.chebyshev = chebyshev.get();
    relaxation = std::move(chebyshev);
  }
  else if (made.has_fluid)
    relaxation = std::make_unique<MatrixRelaxation>(made.velocity_matrix, parts);
  // Products in the iteration do without this matrix, and a factorisation has no memory to spare.
  TrilinosWrappers::SparseMatrix divergence_matrix;
  if (has_joint_block || made.has_polynomial_multigrid)
    assemble_divergence(space, operators, constraints, divergence_matrix);
  if (has_joint_block)
  {
    TrilinosWrappers::SparseMatrix block_compression;
    assemble_pressure_mass(space, operators, compressibility, block_compression);
    auto block = std::make_unique<SaddlePointBlock>(divergence_matrix.trilinos_matrix(),
                                                    block_compression.trilinos_matrix(),
                                                    parts.stiff, stiff_pressures);
    if (has_matrix)
      block->add_velocity_entries(made.velocity_matrix.trilinos_matrix());
    else
      add_velocities(*block, parts.stiff);
    if (!needs_all_rows)
      made.velocity_matrix.clear();
    SaddlePointBlock &stiff_block = *block;
    made.velocity = std::make_unique<VelocityPreconditioner>(
        divergence_matrix, std::move(block), stiff_pressures, std::move(relaxation));
    divergence_matrix.clear();
    stiff_block.factorize(parts.most_factor_bytes);
  }
  else if (made.has_polynomial_multigrid)
    made.velocity = std::make_unique<VelocityPreconditioner>(
        space.velocity_vector(),
        make_polynomial_multigrid(made, volumetric.coefficients, divergence_matrix),
        std::move(relaxation));
  else
    made.velocity = std::make_unique<VelocityPreconditioner>(made.velocity_matrix, parts,
                                                             std::move(relaxation));
  if (!needs_all_rows)
    made.velocity_matrix.clear();
}

template <int dim>
void IterativeStepSolver<dim>::assemble_rows(const std::vector<unsigned int> *const wanted,
                                             VolumetricStiffness &volumetric,
                                             TrilinosWrappers::SparseMatrix &matrix) const
{
  std::vector<bool> rows(space.velocity_owned.n_elements(), wanted == nullptr);
  if (wanted != nullptr)
    for (const unsigned int i : *wanted)
      rows[i] = true;
  // Where the regions have no matrices, these are made for the rows alone.
  std::vector<RegionOperators> of_regions;
  if (operators.front().products)
    of_regions = assembled_at(rows);
  const std::vector<RegionOperators> &assembled = of_regions.empty() ? operators : of_regions;
  assemble_volumetric_stiffness(space, assembled, volumetric);
  assemble_velocity_block(space, assembled, constraints, coefficients, &volumetric, &rows, matrix);
}

template <int dim>
const MatrixFreeProduct<dim, float> &IterativeStepSolver<dim>::single_precision_cells()
{
  if (!single_precision_product)
    single_precision_product = make_matrix_free_product<dim, float>(
        parameters.instruction_set,
        {space.mapping, space.velocity_dofs, constraints.all(), space.is_axisymmetric()});
  return *single_precision_product;
}

template <int dim>
std::unique_ptr<VelocityCycle> IterativeStepSolver<dim>::make_polynomial_multigrid(
    Preconditioner &made,
    const std::vector<double> &volumetric,
    const TrilinosWrappers::SparseMatrix &divergence_matrix)
{
  std::unique_ptr<TrilinosWrappers::SparseMatrix> supports;
  if (matrix_free_velocity->support_matrix() != nullptr)
  {
    supports = std::make_unique<TrilinosWrappers::SparseMatrix>();
    supports->copy_from(*matrix_free_velocity->support_matrix());
  }
  const StiffBlockLimits &limits = parameters.stiff_block_limits;
  const bool has_factor = n_stiff_of_all <= limits.largest_with_linear_factor &&
                          n_stiff_of_all != n_stiff_without_linear_factor;
  auto result = std::make_unique<PolynomialMultigrid<dim>>(
      single_precision_cells(), space, constraints,
      typename PolynomialMultigrid<dim>::Product::Coefficients{coefficients.mass,
                                                               coefficients.stiffness, volumetric},
      made.is_stiff, divergence_matrix, made.augmentation, std::move(supports),
      has_factor ? limits.linear_bytes_per_unknown * n_unknowns() : 0.);
  made.multigrid_name = result->name();
  if (!result->has_linear_factor())
    n_stiff_without_linear_factor = n_stiff_of_all;
  return result;
}

template <int dim>
double IterativeStepSolver<dim>::n_unknowns() const
{
  return static_cast<double>(space.velocity_dofs.n_dofs() + space.pressure_dofs.n_dofs());
}

template <int dim>
double IterativeStepSolver<dim>::most_factor_bytes(const unsigned int n_stiff) const
{
  const double unlimited = std::numeric_limits<double>::infinity();
  if (parameters.stiff_block != StiffBlock::automatic)
    return parameters.stiff_block == StiffBlock::direct ? unlimited : 0.;
  const StiffBlockLimits &limits = parameters.stiff_block_limits;
  if (n_stiff <= (dim == 2 ? limits.small_in_plane : limits.small_in_space))
    return unlimited;
  const auto n_velocity = space.velocity_dofs.n_dofs();
  if (refused_factor && refused_factor->n_stiff == n_stiff)
    return 0.;
  if (n_stiff > limits.largest || n_stiff > limits.largest_share * static_cast<double>(n_velocity))
    return 0.;
  return limits.bytes_per_unknown * n_unknowns();
}

template <int dim>
void IterativeStepSolver<dim>::refuse_large_factor(const VelocityBlocks &parts)
{
  if (!(parts.most_factor_bytes > 0.) || std::isinf(parts.most_factor_bytes) ||
      n_stiff_of_all == n_stiff_with_small_estimate)
    return;
  // An entry has at least the bytes of single precision.
  const double bytes = sizeof(float) * estimate_block_factor<dim>(space, constraints, parts.stiff);
  if (bytes > parts.most_factor_bytes)
    throw FactorTooLarge(bytes);
  n_stiff_with_small_estimate = n_stiff_of_all;
}

template <int dim>
void IterativeStepSolver<dim>::make_preconditioner()
{
  // The old one first: two would not fit where one does.
  preconditioner = nullptr;
  try
  {
    preconditioner = new_preconditioner();
  }
  catch (const FactorTooLarge &factor)
  {
    refused_factor = {n_stiff_of_all, factor.bytes};
    preconditioner = new_preconditioner();
  }
  if (!grad_div.empty() && preconditioner->chebyshev != nullptr)
    add_grad_div();
}

template <int dim>
void IterativeStepSolver<dim>::precondition_grad_div(const std::vector<double> &viscosities)
{
  if (viscosities.empty() || preconditioner->chebyshev == nullptr ||
      parameters.schur_complement == SchurApproximation::simple)
    return;
  const std::vector<double> &viscosity_of_regions = preconditioner->coefficients.stiffness;
  double sums[] = {0., 0.}; // of what there is, with alpha, and of the change of gamma
  for (const auto &cell : space.pressure_dofs.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      const unsigned int i = cell->active_cell_index();
      const double present = grad_div.empty() ? 0. : grad_div[i];
      if (viscosities[i] == 0. && present == 0.)
        continue; // a solid
      sums[0] += cell->measure() * (present + viscosity_of_regions[cell->material_id()]);
      sums[1] += cell->measure() * std::abs(viscosities[i] - present);
    }
  Utilities::MPI::sum(sums, space.communicator, sums);
  if (!(sums[1] > smallest_change * sums[0]))
    return;
  grad_div = viscosities;
  add_grad_div();
  preconditioner->is_used = false; // its iterations count anew
}

template <int dim>
void IterativeStepSolver<dim>::add_grad_div()
{
  std::vector<double> augmentation = grad_div;
  for (double &gamma : augmentation)
    gamma *= share_of_grad_div;
  preconditioner->chebyshev->set_volumetric_of_cells(augmentation);
  // The sum of the cells' parts of the mass form around each pressure, with 1/alpha and with
  // 1/(alpha + gamma).
  const SystemCoefficients &of_form = preconditioner->coefficients;
  DistributedVector before = space.pressure_vector(), roots = before;
  std::vector<types::global_dof_index> indices;
  for (const auto &cell : space.pressure_dofs.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      const double alpha = std::max(of_form.stiffness[cell->material_id()], 1e-100),
                   compressibility = of_form.compressibility[cell->material_id()],
                   gamma = augmentation[cell->active_cell_index()], volume = cell->measure();
      indices.resize(cell->get_fe().n_dofs_per_cell());
      cell->get_dof_indices(indices);
      before.add(indices,
                 std::vector<double>(indices.size(), volume * (1. / alpha + compressibility)));
      roots.add(indices, std::vector<double>(indices.size(),
                                             volume * (1. / (alpha + gamma) + compressibility)));
    }
  before.compress(VectorOperation::add);
  roots.compress(VectorOperation::add);
  for (unsigned int i = 0; i < roots.locally_owned_size(); ++i)
    roots.begin()[i] = std::sqrt(before.begin()[i] / roots.begin()[i]);
  preconditioner->schur_complement->scale_mass_inverse(roots);
}

template <int dim>
std::unique_ptr<typename IterativeStepSolver<dim>::Preconditioner>
IterativeStepSolver<dim>::new_preconditioner()
{
  auto made = std::make_unique<Preconditioner>();
  made->coefficients = coefficients;

  mass_diagonals.clear();
  stiffness_diagonals.clear();
  for (const RegionOperators &region : operators)
  {
    mass_diagonals.push_back(region.mass_diagonal());
    stiffness_diagonals.push_back(region.stiffness_diagonal());
  }
  const std::vector<bool> stiff_regions = find_stiff_regions();
  const unsigned int n_regions = operators.size();
  const bool has_inertia = std::all_of(coefficients.mass.begin(), coefficients.mass.end(),
                                       [](const double mass) { return mass > 0.; });

  DistributedVector mobility = space.velocity_vector();
  double fluid_ratio = 0.;
  VelocityBlocks parts = velocity_blocks(stiff_regions, mobility, fluid_ratio);
  const auto n_stiff =
      Utilities::MPI::sum(static_cast<unsigned int>(parts.stiff.size()), space.communicator);
  n_stiff_of_all = n_stiff;
  const bool has_fluid =
      Utilities::MPI::sum(static_cast<unsigned int>(parts.fluid.size()), space.communicator) > 0;
  parts.most_factor_bytes = most_factor_bytes(n_stiff);
  refuse_large_factor(parts);
  parts.stiff_is_direct = parts.most_factor_bytes > 0.;
  parts.fluid_is_viscous = parameters.fluid_block == FluidBlock::algebraic_multigrid ||
                           (parameters.fluid_block == FluidBlock::automatic &&
                            (fluid_ratio > viscous_ratio || !has_inertia));
  const bool simple = parameters.schur_complement == SchurApproximation::simple;
  const bool has_joint_block = n_stiff > 0 && parts.stiff_is_direct && !simple;

  made->has_polynomial_multigrid = n_stiff > 0 && !parts.stiff_is_direct && matrix_free_velocity &&
                                   parameters.stiff_block != StiffBlock::algebraic_multigrid;
  const bool has_algebraic_multigrid =
      (n_stiff > 0 && !parts.stiff_is_direct && !made->has_polynomial_multigrid) ||
      (has_fluid && parts.fluid_is_viscous);
  if (has_algebraic_multigrid)
    parts.modes = rigid_motions(space.mapping, space.velocity_dofs);
  const std::vector<unsigned int> stiff_pressures =
      has_joint_block ? find_stiff_pressures(stiff_regions) : std::vector<unsigned int>();
  made->has_fluid = has_fluid;
  made->has_stiff = n_stiff > 0;
  made->stiff_is_direct = parts.stiff_is_direct;
  made->fluid_is_viscous = parts.fluid_is_viscous;
  made->has_inertia = has_inertia;
  made->is_stiff.assign(space.velocity_owned.n_elements(), false);
  for (const unsigned int i : parts.stiff)
    made->is_stiff[i] = true;

  // The mass form of the Schur complement follows an augmentation by a bulk modulus of alpha.
  std::vector<double> mass_factors;
  made->augmentation = space.pressure_vector();
  DistributedVector one = space.pressure_vector(), volume = space.pressure_vector();
  one = 1.;
  for (unsigned int region = 0; region < n_regions; ++region)
  {
    const double alpha = coefficients.stiffness[region];
    const bool is_augmented = stiff_regions[region] && !simple && !has_joint_block;
    mass_factors.push_back((1. / std::max(alpha, 1e-100) + coefficients.compressibility[region]) /
                           (is_augmented ? 2. : 1.));
    if (!is_augmented)
      continue;
    multiply(operators[region].pressure_mass, volume, one);
    for (unsigned int i = 0; i < volume.locally_owned_size(); ++i)
      if (volume.begin()[i] > 0. &&
          !space.pressure_hanging.is_constrained(space.pressure_owned.nth_index_in_set(i)))
        made->augmentation.begin()[i] = alpha / volume.begin()[i];
  }
  mark_memory("preconditioner of the velocities");
  make_velocity_inverse(*made, stiff_regions, stiff_pressures, parts, has_joint_block);
  mark_memory("preconditioner of the velocities"); // also frees what the factorisation leaves

  if (n_stiff > 0 && has_fluid && has_inertia && !simple)
    let_walls_yield(stiff_regions, *made->velocity, mobility);

  const SchurComplement::Places places = places_of_pressures(space, n_regions);
  TrilinosWrappers::SparseMatrix divergence_matrix;
  assemble_divergence(space, operators, constraints, divergence_matrix);
  if (simple)
  {
    for (unsigned int i = 0; i < mobility.locally_owned_size(); ++i)
      mobility.begin()[i] = 1. / velocity_operator().diagonal().begin()[i];
    made->schur_complement = std::make_unique<SchurComplement>(
        std::move(divergence_matrix), compression, nullptr, &mobility, places);
  }
  else
  {
    TrilinosWrappers::SparseMatrix mass_form;
    assemble_pressure_mass(space, operators, mass_factors, mass_form);
    std::vector<unsigned int> pressures;
    std::vector<bool> is_left_out(space.pressure_owned.n_elements(), false);
    for (const unsigned int i : stiff_pressures)
      is_left_out[i] = true;
    for (unsigned int i = 0; i < is_left_out.size(); ++i)
      if (!is_left_out[i])
        pressures.push_back(i);
    made->schur_complement =
        std::make_unique<SchurComplement>(std::move(divergence_matrix), compression, &mass_form,
                                          has_inertia ? &mobility : nullptr, places, pressures);
  }

  std::ostringstream text;
  text << "FGMRES";
  if (n_stiff > 0)
    text << "; stiff block: "
         << (parts.stiff_is_direct            ? made->velocity->factor()->name()
             : made->has_polynomial_multigrid ? made->multigrid_name
                                              : "algebraic multigrid");
  if (!parts.stiff_is_direct && refused_factor && refused_factor->n_stiff == n_stiff)
    text << ", since a factor would need " << memory_text(refused_factor->bytes);
  if (has_fluid)
    text << "; fluid block: "
         << (parts.fluid_is_viscous                         ? "algebraic multigrid"
             : relaxes_without_matrix(stiff_regions, parts) ? "Chebyshev relaxation"
                                                            : "relaxation");
  text << "; Schur complement: " << (simple ? "simple" : "cahouet-chabard");
  if (matrix_free_velocity)
    text << "; products without a matrix ("
         << word_of(instruction_set_words(),
                    instruction_set_of_products<dim>(parameters.instruction_set))
         << ")";
  made->name = text.str();
  mark_memory("preconditioner of the pressure");
  mass_diagonals.clear();
  stiffness_diagonals.clear();
  mark_memory("preconditioner of the velocities");
  return made;
}

template <int dim>
void IterativeStepSolver<dim>::mark_memory(const std::string &part) const
{
  if (memory_use != nullptr)
    memory_use->mark(part);
}

template <int dim>
void IterativeStepSolver<dim>::record_use(const unsigned int iterations)
{
  Preconditioner &used = *preconditioner;
  if (!used.is_used)
    used.first_iterations = iterations;
  used.is_used = true;
  used.is_worn =
      !(coefficients == used.coefficients) && iterations > 1.5 * used.first_iterations + 5.;
}

template <int dim>
KrylovReport IterativeStepSolver<dim>::solve_by_krylov(const SaddlePointSolver::Blocks &system,
                                                       const double tolerance,
                                                       const bool is_correction,
                                                       const DistributedVector &momentum,
                                                       const DistributedVector &mass,
                                                       DistributedVector &velocity,
                                                       DistributedVector &pressure)
{
  unsigned int iterations = 0;
  KrylovReport report;
  for (bool last_try = false;; last_try = true)
  {
    if (is_correction)
    {
      velocity = 0.;
      pressure = 0.;
    }
    else
    {
      velocity.equ(1., last_velocity);
      pressure.equ(1., last_pressure);
    }
    report = solver.solve(system, *preconditioner->velocity, *preconditioner->schur_complement,
                          preconditioner->augmentation, momentum, mass, velocity, pressure,
                          tolerance, parameters.maximum_iterations, is_correction);
    iterations += report.iterations;
    if (report.converged || last_try || coefficients == preconditioner->coefficients)
      break;
    make_preconditioner();
  }
  if (report.converged)
    record_use(report.iterations);
  report.iterations = iterations;
  return report;
}

template <int dim>
std::string IterativeStepSolver<dim>::describe_failure(const SaddlePointSolver::Blocks &system,
                                                       const FurtherTerms kind,
                                                       const KrylovReport &report)
{
  Preconditioner &used = *preconditioner;
  solver.free_basis();
  // A + B^T W B, whose inverse the preconditioner of the velocities is, with the terms that A and B
  // have beside the linear ones. The row of the mass is -B.
  const DistributedVector no_pressure = space.pressure_vector();
  DistributedVector of_mass = space.pressure_vector(), of_velocity = space.velocity_vector();
  const LinearFunction matrix = [&](DistributedVector &target, const DistributedVector &source)
  {
    if (system.whole)
      system.whole(source, no_pressure, target, of_mass);
    else
    {
      system.velocity.multiply(target, source);
      system.divergence.multiply(of_mass, source);
      of_mass *= -1.;
    }
    of_mass.scale(used.augmentation);
    system.divergence.multiply_transposed(of_velocity, of_mass);
    target.add(-1., of_velocity);
  };
  const auto factor_of = [&](const bool of_stiff, const LinearFunction &inverse)
  {
    DistributedVector is_of_block = space.velocity_vector();
    for (unsigned int i = 0; i < is_of_block.locally_owned_size(); ++i)
      if (used.is_stiff[i] == of_stiff &&
          !constraints.all().is_constrained(space.velocity_owned.nth_index_in_set(i)))
        is_of_block.begin()[i] = 1.;
    return convergence_factor(matrix, inverse, velocity_operator().diagonal(), is_of_block);
  };
  BlockFactors factors;
  factors.further_terms = kind;
  factors.residual = report.residual;
  factors.of_all = report.late_factor;
  factors.has_stiff = used.has_stiff;
  factors.has_fluid = used.has_fluid;
  factors.stiff_is_direct = used.stiff_is_direct;
  factors.fluid_is_viscous = used.fluid_is_viscous;
  factors.has_inertia = used.has_inertia;
  if (used.has_stiff && !used.stiff_is_direct)
    factors.of_stiff =
        factor_of(true, [&](DistributedVector &target, const DistributedVector &source)
                  { used.velocity->solve_stiff(target, source); });
  if (used.has_fluid)
    factors.of_fluid =
        factor_of(false, [&](DistributedVector &target, const DistributedVector &source)
                  { used.velocity->relax_fluid(target, source); });
  return describe_stalled_block(factors, parameters);
}

template <int dim>
unsigned int IterativeStepSolver<dim>::solve(const DistributedVector &momentum,
                                             const DistributedVector &mass,
                                             DistributedVector &velocity,
                                             DistributedVector &pressure)
{
  const SaddlePointSolver::Blocks system = blocks();
  const KrylovReport report =
      solve_by_krylov(system, parameters.tolerance, false, momentum, mass, velocity, pressure);
  if (!report.converged)
  {
    std::ostringstream text;
    text << "the iterative solver has not converged: after " << report.iterations
         << " iterations the residual is " << report.residual
         << " of the largest term of the equations, and Linear solver/Tolerance is "
         << parameters.tolerance << ". " << describe_failure(system, FurtherTerms::none, report);
    throw RunError(text.str());
  }
  last_velocity.equ(1., velocity);
  last_pressure.equ(1., pressure);
  return report.iterations;
}

template <int dim>
unsigned int IterativeStepSolver<dim>::solve_tangent(const SaddlePointSolver::Product &whole,
                                                     const FurtherTerms kind,
                                                     const double tolerance,
                                                     const DistributedVector &momentum,
                                                     const DistributedVector &mass,
                                                     DistributedVector &velocity,
                                                     DistributedVector &pressure)
{
  SaddlePointSolver::Blocks tangent = blocks();
  tangent.whole = whole;
  const KrylovReport report =
      solve_by_krylov(tangent, tolerance, true, momentum, mass, velocity, pressure);
  if (!report.converged)
  {
    std::ostringstream text;
    text << "the iterative solver has not converged for a correction of Newton's iteration: after "
         << report.iterations << " iterations the residual is " << report.residual
         << " of that at the start, and Newton/Krylov tolerance is " << tolerance << ". "
         << describe_failure(tangent, kind, report);
    throw StepFailure(text.str());
  }
  return report.iterations;
}

template <int dim>
std::string IterativeStepSolver<dim>::name() const
{
  return preconditioner ? preconditioner->name : "FGMRES";
}

template <int dim>
const SymmetricFactor *IterativeStepSolver<dim>::factor() const
{
  return preconditioner ? preconditioner->velocity->factor() : nullptr;
}

template class IterativeStepSolver<2>;
template class IterativeStepSolver<3>;
} // namespace Continua
