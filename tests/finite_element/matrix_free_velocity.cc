// Products without a matrix against the assembled matrix: plane strain, axisymmetry and three
// dimensions, curved cells with hanging nodes, rollers on curved walls, supports, two regions whose
// coefficients differ by 1e7; with every instruction set of the processor, of which `automatic`
// takes the widest. Then the relaxation against its polynomial with the assembled matrix.

#include <continua/finite_element/products/matrix_free_regions.h>
#include <continua/finite_element/products/supports.h>
#include <continua/finite_element/solvers/chebyshev_relaxation.h>
#include <continua/finite_element/solvers/condensed_system.h>
#include <continua/finite_element/solvers/matrix_free_divergence.h>
#include <continua/finite_element/solvers/matrix_free_velocity.h>
#include <continua/linear_algebra/matrix_operator.h>

#include "../parameter_text.h"
#include "../unit_test.h"
#include "shell_conditions.h"
#include "small_problem.h"

#include <algorithm>

namespace test_of_matrix_free_velocity
{
using namespace Continua;
using namespace dealii;

namespace
{
/// Largest difference relative to the largest entry of the second.
double relative_distance(const DistributedVector &a, const DistributedVector &b)
{
  DistributedVector difference = a;
  difference.add(-1., b);
  return difference.linfty_norm() / b.linfty_norm();
}

/// r -> p(D^-1 A) D^-1 r, the Chebyshev polynomial of degree 2 for eigenvalues from an eighth of
/// the largest to that one, on the velocities of the mask: its error 1 - x p(x) is T_2(t(x)) /
/// T_2(t(0)) with t from -1 to 1 over the interval. Written out in powers of x.
DistributedVector relaxed(const MatrixOperator &a,
                          const DistributedVector &mask,
                          const double largest_eigenvalue,
                          const DistributedVector &source)
{
  const double middle = (1. + 1. / 8.) / 2. * largest_eigenvalue,
               half = (1. - 1. / 8.) / 2. * largest_eigenvalue;
  const double scale = 2. * middle * middle / (half * half) - 1.; // T_2(t(0))
  DistributedVector first = source, product = source;
  const auto invert = [&](DistributedVector &vector)
  {
    vector.scale(mask);
    for (unsigned int i = 0; i < vector.locally_owned_size(); ++i)
      vector.begin()[i] /= a.diagonal().begin()[i];
  };
  invert(first);
  a.multiply(product, first);
  invert(product);
  DistributedVector result = first;
  result *= 4. * middle / (half * half * scale);
  result.add(-2. / (half * half * scale), product);
  return result;
}

template <int dim>
void check_products(const std::string &name, const Model model)
{
  small_problem::Mesh<dim> mesh(MPI_COMM_WORLD);
  GridGenerator::quarter_hyper_shell(mesh, Point<dim>(), 1., 1.5, 0, true);
  mesh.refine_global(dim == 2 ? 2 : 1);
  const std::vector<std::string> regions = {"soft", "hard"};
  for (const auto &cell : mesh.active_cell_iterators())
    cell->set_material_id(cell->center().norm() > 1.2 ? 1 : 0);
  small_problem::refine<dim>(mesh, [](const Point<dim> &x) { return x[0] > 0.6; });
  Space<dim> space(mesh, SpaceParameters(), model, regions.size());
  space.distribute();
  const std::vector<BoundaryCondition> conditions = shell::read_conditions(dim, regions);
  BoundaryConstraints<dim> constraints(space, conditions);
  constraints.build();
  std::vector<RegionOperators> operators(regions.size());
  assemble_region_operators(space, operators);
  assemble_supports(space, conditions, operators);

  const DistributedVector source = small_problem::interpolated<dim>(
      space,
      [](const Point<dim> &x)
      {
        Tensor<1, dim> value;
        for (unsigned int c = 0; c < dim; ++c)
          value[c] = std::sin(5. * x[0] + 2. * x[1] + c) + std::cos(7. * x[dim - 1] - c);
        return value;
      });
  DistributedVector expected = space.velocity_vector(), product = expected;
  for (const bool is_supported : {false, true})
  {
    const SystemCoefficients coefficients{
        {2e3, 5.}, {1e-2, 1e5}, {0.1, 0.01}, is_supported ? 30. : 0., is_supported ? 1. : 0.};
    TrilinosWrappers::SparseMatrix matrix;
    assemble_velocity_block(space, operators, constraints, coefficients, nullptr, nullptr, matrix);
    const MatrixOperator assembled(matrix);
    assembled.multiply(expected, source);
    TrilinosWrappers::SparseMatrix divergence;
    assemble_divergence(space, operators, constraints, divergence);
    const DistributedVector pressure = small_problem::interpolated_pressure<dim>(
        space, [](const Point<dim> &x, const unsigned int region)
        { return std::sin(4. * x[0] + 3. * x[dim - 1] + region); });
    DistributedVector of_velocity = pressure, of_pressure = expected, expected_volume = pressure,
                      expected_force = expected;
    multiply(divergence, expected_volume, source);
    multiply_transposed(divergence, expected_force, pressure);
    double distance = 0., of_diagonal = 0., of_divergence = 0., of_gradient = 0., of_both = 0.;
    for (const InstructionSet set :
         {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512})
      if (can_run(set))
      {
        const MatrixFreeRegions<dim> products(space, constraints, regions.size(), set);
        MatrixFreeVelocity<dim> matrix_free(space, operators, constraints, products.product());
        matrix_free.set(coefficients);
        matrix_free.multiply(product, source);
        distance = std::max(distance, relative_distance(product, expected));
        of_diagonal =
            std::max(of_diagonal, relative_distance(matrix_free.diagonal(), assembled.diagonal()));

        // Twice: the first product must leave nothing behind.
        const MatrixFreeDivergence<dim> b(space, products.product());
        for (unsigned int k = 0; k < 2; ++k)
        {
          b.multiply(of_velocity, source);
          b.multiply_transposed(of_pressure, pressure);
        }
        of_divergence = std::max(of_divergence, relative_distance(of_velocity, expected_volume));
        of_gradient = std::max(of_gradient, relative_distance(of_pressure, expected_force));
        for (unsigned int k = 0; k < 2; ++k)
          b.multiply_with(matrix_free, product, of_velocity, source, pressure);
        of_pressure.sadd(-1., 1., expected);
        of_both = std::max({of_both, relative_distance(product, of_pressure),
                            relative_distance(of_velocity, expected_volume)});
      }
    const std::string title = name + (is_supported ? ", with a support" : "");
    check::absolute(title + ": product", distance, 0., 1e-13);
    check::absolute(title + ": diagonal", of_diagonal, 0., 1e-13);
    check::absolute(title + ": divergence", of_divergence, 0., 1e-13);
    check::absolute(title + ": gradient", of_gradient, 0., 1e-13);
    check::absolute(title + ": both with the product", of_both, 0., 1e-13);
  }

  // One region alone.
  double of_mass = 0., of_stiffness = 0., of_diagonals = 0.;
  bool has_same_nodes = true;
  DistributedVector diagonal = space.velocity_vector();
  for (const InstructionSet set :
       {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512})
    if (can_run(set))
    {
      const MatrixFreeRegions<dim> products(space, constraints, regions.size(), set);
      for (unsigned int region = 0; region < regions.size(); ++region)
      {
        multiply(operators[region].mass, expected, source);
        products.multiply(region, 1., 0., product, source);
        space.set_hanging_velocities_to_zero(expected);
        of_mass = std::max(of_mass, relative_distance(product, expected));
        multiply(operators[region].stiffness, expected, source);
        products.multiply(region, 0., 1., product, source);
        of_stiffness = std::max(of_stiffness, relative_distance(product, expected));
        products.mass_diagonal(region, diagonal);
        expected = operators[region].mass_diagonal();
        space.set_hanging_velocities_to_zero(expected);
        of_diagonals = std::max(of_diagonals, relative_distance(diagonal, expected));
        products.stiffness_diagonal(region, diagonal);
        expected = operators[region].stiffness_diagonal();
        space.set_hanging_velocities_to_zero(expected);
        of_diagonals = std::max(of_diagonals, relative_distance(diagonal, expected));
        has_same_nodes =
            has_same_nodes && products.nodes(region) == velocity_nodes(operators)[region];
      }
    }
  check::absolute(name + ": mass of a region", of_mass, 0., 1e-13);
  check::absolute(name + ": stiffness of a region", of_stiffness, 0., 1e-13);
  check::absolute(name + ": diagonals of a region", of_diagonals, 0., 1e-13);
  check::is_true(name + ": nodes of a region", has_same_nodes);

  // A bulk stiffness is for preconditioners alone, of a region or of cells, here of the soft ones;
  // the relaxation leaves the hard region out.
  VolumetricStiffness volumetric{{40., 3e3}, {}};
  std::vector<double> of_soft_cells(mesh.n_active_cells(), 0.);
  for (const auto &cell : mesh.active_cell_iterators())
    if (cell->is_locally_owned() && cell->material_id() == 0)
      of_soft_cells[cell->active_cell_index()] = 40.;
  assemble_volumetric_stiffness(space, operators, volumetric);
  const SystemCoefficients coefficients{{2e3, 5.}, {10., 1e5}, {0.1, 0.01}};
  TrilinosWrappers::SparseMatrix matrix;
  assemble_velocity_block(space, operators, constraints, coefficients, &volumetric, nullptr,
                          matrix);
  const MatrixOperator assembled(matrix);
  const std::vector<unsigned int> hard = velocity_nodes(operators)[1];
  std::vector<unsigned int> fluid;
  DistributedVector mask = space.velocity_vector(), free_source = source;
  for (unsigned int i = 0; i < space.velocity_owned.n_elements(); ++i)
  {
    const bool is_constrained =
        constraints.all().is_constrained(space.velocity_owned.nth_index_in_set(i));
    const bool is_fluid = !std::binary_search(hard.begin(), hard.end(), i);
    if (is_constrained)
      free_source.begin()[i] = 0.;
    if (is_fluid)
      fluid.push_back(i);
    mask.begin()[i] = is_fluid && !is_constrained ? 1. : 0.;
  }
  double distance = 0., of_relaxation = 0., symmetry = 0., largest_eigenvalue = 0.;
  for (const InstructionSet set :
       {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512})
    if (can_run(set))
    {
      // The relaxation keeps the cells, and leaves out those of the hard region alone.
      auto cells = make_matrix_free_product<dim, float>(
          set, {space.mapping, space.velocity_dofs, constraints.all(), space.is_axisymmetric()});
      ChebyshevRelaxation<dim> relaxation(
          *cells, {coefficients.mass, coefficients.stiffness, {0., 3e3}}, fluid);
      cells = nullptr;
      relaxation.set_volumetric_of_cells(of_soft_cells);
      assembled.multiply(expected, free_source);
      expected.sadd(-1., 1., source);
      relaxation.leave_residual(product, free_source, source);
      for (unsigned int i = 0; i < product.locally_owned_size(); ++i)
        if (free_source.begin()[i] == 0.)
          product.begin()[i] = expected.begin()[i]; // constrained
      distance = std::max(distance, relative_distance(product, expected));

      product = 0.;
      relaxation.add_relaxed(product, source);
      of_relaxation =
          std::max(of_relaxation,
                   relative_distance(
                       product, relaxed(assembled, mask, relaxation.largest_eigenvalue(), source)));
      DistributedVector other = expected;
      other = 0.;
      relaxation.add_relaxed(other, expected);
      symmetry = std::max(symmetry, std::abs(product * expected / (other * source) - 1.));
      largest_eigenvalue = relaxation.largest_eigenvalue();
    }
  // The largest eigenvalue of D^-1 A on the velocities of the mask, by many more power steps.
  DistributedVector mode = mask;
  double exact_eigenvalue = 0.;
  for (unsigned int step = 0; step < 400; ++step)
  {
    mode.scale(mask);
    for (unsigned int i = 0; i < mode.locally_owned_size(); ++i)
      mode.begin()[i] *= step == 0 ? std::sin(3. * i) : 1. / assembled.diagonal().begin()[i];
    exact_eigenvalue = mode.l2_norm();
    mode /= exact_eigenvalue;
    assembled.multiply(product, mode);
    mode.equ(1., product);
  }
  check::is_true(name + ": largest eigenvalue with a margin",
                 largest_eigenvalue > exact_eigenvalue &&
                     largest_eigenvalue < 1.2 * exact_eigenvalue);
  check::absolute(name + ": residual in single precision", distance, 0., 2e-6);
  check::absolute(name + ": relaxation", of_relaxation, 0., 2e-6);
  check::absolute(name + ": relaxation is symmetric", symmetry, 0., 1e-5);
}
/// u = x has the work int lambda (div u)^2 = n^2 sum of lambda V, n = dim, in a ring 3: with a
/// lambda of its own in each cell.
template <int dim>
void check_volumetric_of_cells(const std::string &name, const Model model)
{
  small_problem::Mesh<dim> mesh(MPI_COMM_WORLD);
  small_problem::make_box<dim>(mesh, std::vector<unsigned int>(dim, 2), Point<dim>(), 1.);
  small_problem::refine<dim>(mesh, [](const Point<dim> &x) { return x[0] < 0.5; });
  Space<dim> space(mesh, SpaceParameters(), model, 2);
  space.distribute();
  std::vector<double> lambda(mesh.n_active_cells(), 0.);
  double work = 0.;
  const double divergence = space.is_axisymmetric() ? 3. : dim;
  for (const auto &cell : mesh.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      const Point<dim> centre = cell->center();
      double &here = lambda[cell->active_cell_index()];
      here = 2. + std::sin(10. * centre[0] + 30. * centre[1] + 50. * centre[dim - 1]);
      work += here * cell->measure() * space.circumference(centre) * divergence * divergence;
    }
  work = Utilities::MPI::sum(work, MPI_COMM_WORLD);
  double distance = 0.;
  for (const InstructionSet set :
       {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512})
    if (can_run(set))
    {
      const auto product = make_matrix_free_product<dim, double>(
          set,
          {space.mapping, space.velocity_dofs, space.velocity_hanging, space.is_axisymmetric()});
      product->set({{0.}, {0.}, {}, lambda});
      typename MatrixFreeProduct<dim, double>::Vector source, target;
      product->initialise(source);
      product->initialise(target);
      const DistributedVector position = small_problem::interpolated<dim>(
          space, [](const Point<dim> &x) { return Tensor<1, dim>(x); });
      std::copy(position.begin(), position.end(), source.begin());
      product->multiply(target, source);
      distance = std::max(distance, std::abs(source * target / work - 1.));
    }
  check::absolute(name + ": bulk stiffness of each cell", distance, 0., 1e-12);
}
} // namespace

UNIT_TEST(matrix_free_velocity)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::quiet_other_ranks();
  check_products<2>("plane strain", Model::plane_strain);
  check_products<2>("axisymmetric", Model::axisymmetric);
  check_products<3>("three dimensions", Model::three_dimensional);
  check_volumetric_of_cells<2>("plane strain", Model::plane_strain);
  check_volumetric_of_cells<2>("axisymmetric", Model::axisymmetric);
  check_volumetric_of_cells<3>("three dimensions", Model::three_dimensional);
  check::is_true("every processor has the baseline", can_run(InstructionSet::baseline));
  check::is_true("the widest one can run", can_run(widest_instruction_set()));
}
} // namespace test_of_matrix_free_velocity
