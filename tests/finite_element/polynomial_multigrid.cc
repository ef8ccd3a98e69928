// Multigrid in the degree of the velocities: the product with B^T W B against the stored B, the
// matrix of the linear velocities against that of the quadratic ones between interpolations, and
// the cycle: symmetric, and it leaves less than 0.6 of an error where the cells are cubes. Hanging
// nodes, inclined and curved rollers, supports, two regions of which both or one are stiff. The
// same cycle as the relaxation of a viscous fluid.

#include <continua/finite_element/products/supports.h>
#include <continua/finite_element/solvers/condensed_system.h>
#include <continua/finite_element/solvers/polynomial_multigrid.h>
#include <continua/finite_element/solvers/polynomial_relaxation.h>
#include <continua/linear_algebra/matrix_product.h>

#include "../unit_test.h"
#include "shell_conditions.h"
#include "small_problem.h"

#include <algorithm>
#include <cmath>

namespace test_of_polynomial_multigrid
{
using namespace Continua;
using namespace dealii;

namespace
{
const std::vector<std::string> regions = {"soft", "hard"};
const std::vector<double> volumetric_of_regions = {2e3, 1e5};
const SystemCoefficients coefficients{{2e3, 5.}, {2e3, 1e5}, {0.1, 0.01}, 3e4, 10.};

/// A space of two regions with its constraints and matrices.
template <int dim>
struct Setting
{
  Setting(small_problem::Mesh<dim> &mesh, const Model model)
      : space(mesh, SpaceParameters(), model, regions.size()),
        conditions(shell::read_conditions(dim, regions)),
        constraints(space, conditions),
        operators(regions.size())
  {
    space.distribute();
    constraints.build();
    assemble_region_operators(space, operators);
    assemble_supports(space, conditions, operators);
    assemble_divergence(space, operators, constraints, divergence);
    assemble_velocity_block(space, operators, constraints, coefficients, nullptr, nullptr, matrix);
    SystemCoefficients of_supports = coefficients;
    of_supports.mass = of_supports.stiffness = {0., 0.};
    assemble_velocity_block(space, operators, constraints, of_supports, nullptr, nullptr, supports);
    is_free.resize(space.velocity_owned.n_elements());
    for (unsigned int i = 0; i < is_free.size(); ++i)
      is_free[i] = !constraints.all().is_constrained(space.velocity_owned.nth_index_in_set(i));
  }

  /// W = alpha over the volume of each pressure, in regions whose velocities are stiff.
  DistributedVector weights(const bool soft_is_stiff) const
  {
    DistributedVector result = space.pressure_vector(), volume = result, one = result;
    one = 1.;
    for (unsigned int region = soft_is_stiff ? 0 : 1; region < regions.size(); ++region)
    {
      multiply(operators[region].pressure_mass, volume, one);
      for (unsigned int i = 0; i < volume.locally_owned_size(); ++i)
        if (volume.begin()[i] > 0. &&
            !space.pressure_hanging.is_constrained(space.pressure_owned.nth_index_in_set(i)))
          result.begin()[i] = volumetric_of_regions[region] / volume.begin()[i];
    }
    return result;
  }

  /// Of the owned velocities; all, or those of the hard region.
  std::vector<bool> stiff(const bool soft_is_stiff) const
  {
    std::vector<bool> result(space.velocity_owned.n_elements(), soft_is_stiff);
    const std::vector<std::vector<unsigned int>> nodes = velocity_nodes(operators);
    for (const unsigned int i : nodes[1])
      result[i] = true;
    for (unsigned int i = 0; i < result.size(); ++i)
      if (space.velocity_hanging.is_constrained(space.velocity_owned.nth_index_in_set(i)))
        result[i] = false;
    return result;
  }

  /// (A + B^T W B) source, in double precision from stored matrices.
  DistributedVector product(const DistributedVector &weights, const DistributedVector &source) const
  {
    DistributedVector result = space.velocity_vector(), other = result;
    DistributedVector of_pressure = space.pressure_vector();
    multiply(matrix, result, source);
    multiply(divergence, of_pressure, source);
    of_pressure.scale(weights);
    multiply_transposed(divergence, other, of_pressure);
    result.add(1., other);
    return result;
  }

  Space<dim> space;
  std::vector<BoundaryCondition> conditions;
  BoundaryConstraints<dim> constraints;
  std::vector<RegionOperators> operators;
  TrilinosWrappers::SparseMatrix divergence, matrix, supports;
  std::vector<bool> is_free; ///< of the owned velocities
};

/// Values without order, the same on any number of ranks.
void fill(DistributedVector &vector)
{
  const auto range = vector.local_range();
  for (auto i = range.first; i < range.second; ++i)
    vector.begin()[i - range.first] = std::sin(1. + 7. * (i % 911)) + 0.3 * std::cos(2. * i);
}

double relative_distance(const DistributedVector &a, const DistributedVector &b)
{
  DistributedVector difference = a;
  difference.add(-1., b);
  return difference.linfty_norm() / b.linfty_norm();
}

template <int dim>
void check_augmentation(const std::string &name, const Setting<dim> &setting)
{
  const DistributedVector weights = setting.weights(false);
  const DivergenceAugmentation<dim> augmentation(setting.divergence, weights);
  DistributedVector source = setting.space.velocity_vector(), expected = source, found = source;
  DistributedVector of_pressure = setting.space.pressure_vector();
  fill(source);
  multiply(setting.divergence, of_pressure, source);
  of_pressure.scale(weights);
  multiply_transposed(setting.divergence, expected, of_pressure);
  expected.add(1., source);

  LinearAlgebra::distributed::Vector<float> from(setting.space.velocity_owned,
                                                 setting.space.communicator),
      to(from), diagonal(from);
  std::copy(source.begin(), source.end(), from.begin());
  to = from; // the product is added
  augmentation.add_product(to, from);
  std::copy(to.begin(), to.end(), found.begin());
  check::absolute(name + ": B^T W B", relative_distance(found, expected), 0., 1e-6);

  // The diagonal of B^T W B, entry by entry.
  augmentation.add_diagonal(diagonal);
  std::copy(diagonal.begin(), diagonal.end(), found.begin());
  expected = 0.;
  for (unsigned int k = 0; k < weights.locally_owned_size(); ++k)
  {
    const auto row = setting.space.pressure_owned.nth_index_in_set(k);
    for (auto entry = setting.divergence.begin(row); entry != setting.divergence.end(row); ++entry)
      expected(entry->column()) += weights.begin()[k] * entry->value() * entry->value();
  }
  expected.compress(VectorOperation::add);
  check::absolute(name + ": diagonal of B^T W B", relative_distance(found, expected), 0., 1e-6);
}

/// On cells that are parallelograms the integrals of both are equal: P^T A P is the coarse matrix.
template <int dim>
void check_linear_velocities(const std::string &name, const Setting<dim> &setting)
{
  const LinearVelocities<dim> linear(setting.space, setting.constraints.all(), setting.stiff(true));
  VolumetricStiffness volumetric{volumetric_of_regions, {}};
  assemble_volumetric_stiffness(setting.space, setting.operators, volumetric);
  TrilinosWrappers::SparseMatrix fine_matrix, coarse_matrix;
  assemble_velocity_block(setting.space, setting.operators, setting.constraints, coefficients,
                          &volumetric, nullptr, fine_matrix);
  linear.assemble({coefficients.mass, coefficients.stiffness, volumetric.coefficients},
                  &setting.supports, coarse_matrix);

  DistributedVector coarse = linear.vector(), expected = coarse, found = coarse;
  DistributedVector fine = setting.space.velocity_vector(), force = fine;
  // Columns of the interpolation that are empty are prescribed or hang.
  fine = 1.;
  multiply_transposed(linear.interpolation(), expected, fine);
  fill(coarse);
  const auto leave_free = [is_free = expected](DistributedVector &vector)
  {
    for (unsigned int i = 0; i < vector.locally_owned_size(); ++i)
      if (is_free.begin()[i] == 0.)
        vector.begin()[i] = 0.;
  };
  leave_free(coarse);
  multiply(linear.interpolation(), fine, coarse);
  multiply(fine_matrix, force, fine);
  multiply_transposed(linear.interpolation(), expected, force);
  multiply(coarse_matrix, found, coarse);
  leave_free(found);
  check::absolute(name + ": matrix of the linear velocities", relative_distance(found, expected),
                  0., 1e-12);
  const auto n_nodes = Utilities::MPI::sum(linear.stiff_rows().size(), setting.space.communicator);
  check::is_true(name + ": fewer linear velocities",
                 n_nodes > 0 && 3 * n_nodes < setting.space.velocity_dofs.n_dofs());
}

/// The factor by which a cycle reduces the energy of an error, after a few cycles.
template <int dim>
double convergence(const std::string &name,
                   const Setting<dim> &setting,
                   const bool soft_is_stiff,
                   const bool is_factored,
                   const std::string &degree)
{
  const DistributedVector weights = setting.weights(soft_is_stiff);
  const std::vector<bool> stiff = setting.stiff(soft_is_stiff);
  auto supports = std::make_unique<TrilinosWrappers::SparseMatrix>();
  supports->copy_from(setting.supports);
  const auto cells = make_matrix_free_product<dim, float>(
      dim == 2 ? InstructionSet::baseline : widest_instruction_set(), // baseline: cell by cell
      {setting.space.mapping, setting.space.velocity_dofs, setting.constraints.all(),
       setting.space.is_axisymmetric()});
  PolynomialMultigrid<dim> multigrid(
      *cells, setting.space, setting.constraints,
      {coefficients.mass,
       coefficients.stiffness,
       {soft_is_stiff ? volumetric_of_regions[0] : 0., volumetric_of_regions[1]}},
      stiff, setting.divergence, weights, std::move(supports), is_factored ? 1e9 : 0.);
  check::is_true(name + ": degree " + degree + (is_factored ? " and a factor" : ""),
                 multigrid.name().find("degree " + degree + ",") != std::string::npos &&
                     (multigrid.name().find("algebraic") == std::string::npos) == is_factored &&
                     multigrid.has_linear_factor() == is_factored);
  const auto restrict_to_stiff = [&](DistributedVector &vector)
  {
    for (unsigned int i = 0; i < vector.locally_owned_size(); ++i)
      if (!stiff[i] || !setting.is_free[i])
        vector.begin()[i] = 0.;
  };
  DistributedVector error = setting.space.velocity_vector(), other = error, cycle = error,
                    of_other = error;
  fill(error);
  other.equ(1., error);
  for (unsigned int i = 0; i < other.locally_owned_size(); ++i)
    other.begin()[i] *= other.begin()[i];
  restrict_to_stiff(error);
  restrict_to_stiff(other);
  cycle = 1.;
  multigrid.add_cycle(cycle, error);
  cycle.add(-1.);
  multigrid.add_cycle(of_other, other);
  check::absolute(name + ": the cycle is symmetric", (cycle * other) / (of_other * error), 1.,
                  1e-4);
  restrict_to_stiff(of_other);
  DistributedVector elsewhere = cycle, stiff_part = cycle;
  restrict_to_stiff(stiff_part);
  elsewhere.add(-1., stiff_part);
  check::absolute(name + ": the cycle leaves other velocities", elsewhere.linfty_norm(), 0., 0.);

  double factor = 0., old_energy = 0.;
  for (unsigned int step = 0; step < 12; ++step)
  {
    DistributedVector residual = setting.product(weights, error);
    restrict_to_stiff(residual);
    const double energy = error * residual;
    factor = step == 0 ? 0. : std::sqrt(energy / old_energy);
    old_energy = energy;
    cycle = 0.;
    multigrid.add_cycle(cycle, residual);
    error.add(-1., cycle);
  }
  return factor;
}

/// What a cycle leaves of an error, with all velocities stiff and with those of one region.
template <int dim>
void check_cycle(const std::string &name,
                 const Setting<dim> &setting,
                 const double bound,
                 const std::string &degree = "3",
                 const bool tries_factor = true)
{
  for (const bool soft_is_stiff : {true, false})
    for (const bool is_factored : {true, false})
    {
      if (is_factored && !tries_factor)
        continue;
      const std::string title = name + (soft_is_stiff ? ", all stiff" : ", one region stiff") +
                                (is_factored ? ", factor" : ", algebraic multigrid");
      const double factor = convergence(title, setting, soft_is_stiff, is_factored, degree);
      check::is_true(title + ": what a cycle leaves", factor > 0. && factor < bound);
      if (!(factor < bound))
        std::cout << factor << std::endl;
    }
}

/// The relaxation of a viscous fluid: the velocities that are not in the hard region, with and
/// without a bulk stiffness of the cells.
template <int dim>
void check_relaxation(const std::string &name, const Setting<dim> &setting)
{
  const std::vector<bool> hard = setting.stiff(false);
  std::vector<unsigned int> fluid;
  for (unsigned int i = 0; i < hard.size(); ++i)
    if (!hard[i] && !setting.space.velocity_hanging.is_constrained(
                        setting.space.velocity_owned.nth_index_in_set(i)))
      fluid.push_back(i);
  const auto cells = make_matrix_free_product<dim, float>(
      dim == 2 ? InstructionSet::baseline : widest_instruction_set(),
      {setting.space.mapping, setting.space.velocity_dofs, setting.constraints.all(),
       setting.space.is_axisymmetric()});
  PolynomialRelaxation<dim> relaxation(*cells, setting.space, setting.constraints,
                                       {{1., 1.}, {2e3, 1e5}, {}}, fluid, 1e9);
  check::is_true(name + ": the fluid has multigrid",
                 relaxation.name().find("degree 3,") != std::string::npos);
  DistributedVector error = setting.space.velocity_vector(), residual = error, zero = error;
  for (const double bulk : {0., 1e3})
  {
    if (bulk > 0.)
      relaxation.set_volumetric_of_cells(
          std::vector<double>(setting.space.triangulation.n_active_cells(), bulk));
    fill(error);
    for (unsigned int i = 0; i < hard.size(); ++i)
      if (hard[i] || !setting.is_free[i])
        error.begin()[i] = 0.;
    double factor = 0., old_energy = 0.;
    for (unsigned int step = 0; step < 8; ++step)
    {
      relaxation.leave_residual(residual, error, zero);
      const double energy = -(error * residual);
      factor = step == 0 ? 0. : std::sqrt(energy / old_energy);
      old_energy = energy;
      relaxation.add_relaxed(error, residual);
    }
    check::is_true(name + (bulk > 0. ? ", with a bulk stiffness" : "") +
                       ": what a relaxation of the fluid leaves",
                   factor > 0. && factor < 0.7);
    if (!(factor < 0.7))
      std::cout << factor << std::endl;
  }
}

template <int dim>
void check_all(const std::string &name, const Model model)
{
  {
    // Curved cells that are up to three times as long as thick.
    small_problem::Mesh<dim> mesh(MPI_COMM_WORLD);
    GridGenerator::quarter_hyper_shell(mesh, Point<dim>(), 1., 1.5, 0, true);
    mesh.refine_global(dim == 2 ? 2 : 1);
    for (const auto &cell : mesh.active_cell_iterators())
      cell->set_material_id(cell->center().norm() > 1.2 ? 1 : 0);
    small_problem::refine<dim>(mesh, [](const Point<dim> &x) { return x[0] > 0.9; });
    const Setting<dim> setting(mesh, model);
    check_augmentation(name, setting);
    check_cycle(name + ", shell", setting, 0.9);
  }
  for (const unsigned int n_refinements : {0, 1, 2})
  {
    // Cubes, and in the last round cells eight times as long as thick. The ids of the boundaries
    // are those of the shell, whose first one is the roller.
    const bool is_long = n_refinements == 2;
    small_problem::Mesh<dim> mesh(MPI_COMM_WORLD);
    std::vector<unsigned int> cells(dim, 2);
    cells[0] = 4;
    Point<dim> origin;
    origin[1] = 3.;
    small_problem::make_box<dim>(mesh, cells, origin, 2.);
    for (const auto &cell : mesh.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->at_boundary(f) && cell->face(f)->boundary_id() > dim + 1)
          cell->face(f)->set_boundary_id(dim + 1);
    if (is_long)
      GridTools::transform(
          [](Point<dim> x)
          {
            x[0] *= 8.;
            return x;
          },
          mesh);
    if constexpr (dim == 2)
      GridTools::rotate(0.2, mesh);
    else
      GridTools::rotate(Tensor<1, 3>({0., 0., 1.}), 0.2, mesh);
    mesh.refine_global(is_long ? 0 : n_refinements);
    small_problem::refine<dim>(mesh,
                               [&](const Point<dim> &x) { return x[0] > (is_long ? 16. : 2.); });
    const Setting<dim> setting(mesh, model);
    if (n_refinements == 0)
      check_linear_velocities(name, setting);
    if (n_refinements == 1)
      check_relaxation(name, setting);
    if (is_long)
      check_cycle(name + ", long cells", setting, 0.8, "8");
    else
      check_cycle(name + (n_refinements == 0 ? ", coarse cubes" : ", fine cubes"), setting, 0.6,
                  "3", n_refinements == 0);
  }
}
} // namespace

UNIT_TEST(polynomial_multigrid)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::quiet_other_ranks();
  check_all<2>("plane strain", Model::plane_strain);
  check_all<2>("axisymmetric", Model::axisymmetric);
  check_all<3>("three dimensions", Model::three_dimensional);
}
} // namespace test_of_polynomial_multigrid
