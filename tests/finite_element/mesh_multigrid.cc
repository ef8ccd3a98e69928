// The equations of the mesh's motion without a matrix. A uniform gradient of the displacement has a
// known power and a known product; on a bent mesh the product is the change of the residual, by
// differences. What conjugate gradients find leaves what they were asked to leave, after few
// iterations. Curved cells, hanging nodes, a solid that is no part of the body, each set of
// instructions that this processor has.

#include <continua/base/input_error.h>
#include <continua/continuum/kinematics.h>
#include <continua/finite_element/motion/mesh_multigrid.h>

#include "../unit_test.h"
#include "small_problem.h"

#include <cmath>

namespace test_of_mesh_multigrid
{
using namespace Continua;
using namespace dealii;

namespace
{
/// Not small, and not symmetric in the plane or in space; in axisymmetry radii stay radial.
template <int dim>
Tensor<2, dim> uniform_gradient(const bool is_axisymmetric)
{
  Tensor<2, dim> gradient;
  for (unsigned int c = 0; c < dim; ++c)
    for (unsigned int d = 0; d < dim; ++d)
      gradient[c][d] = is_axisymmetric && c != d ? 0. : 0.15 * std::cos(1. + 2. * c + 3. * d);
  return gradient;
}

template <int dim>
struct Setting
{
  Setting(small_problem::Mesh<dim> &mesh, const Model model)
      : space(mesh, SpaceParameters(), model, 2)
  {
    space.distribute();
    is_axisymmetric = space.is_axisymmetric();
    // The solid gives its nodes, and so does the boundary of the liquid.
    DistributedVector marks = space.velocity_vector();
    std::vector<types::global_dof_index> indices(space.velocity_element.n_dofs_per_cell()), marked;
    k.assign(mesh.n_active_cells(), 0.);
    has_given.assign(mesh.n_active_cells(), false);
    for (const auto &cell : space.velocity_dofs.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        const unsigned int number = cell->active_cell_index();
        if (cell->material_id() == 0)
          k[number] = 1. + cell->center()[0] * cell->center()[0];
        cell->get_dof_indices(indices);
        for (unsigned int i = 0; i < indices.size(); ++i)
        {
          bool is_given = cell->material_id() == 1;
          for (const unsigned int f : cell->face_indices())
            is_given =
                is_given || ((cell->at_boundary(f) || cell->neighbor(f)->material_id() == 1) &&
                             space.velocity_element.has_support_on_face(i, f));
          if (is_given)
            marked.push_back(indices[i]);
        }
      }
    marks.add(marked, std::vector<double>(marked.size(), 1.));
    marks.compress(VectorOperation::add);
    DistributedVector ghosted(space.velocity_owned, space.velocity_relevant, space.communicator);
    ghosted = marks;
    constraints.reinit(space.velocity_relevant);
    DoFTools::make_hanging_node_constraints(space.velocity_dofs, constraints);
    for (const auto index : space.velocity_relevant)
      if (ghosted(index) > 0. && !constraints.is_constrained(index))
        constraints.add_line(index);
    constraints.close();
    for (const auto &cell : space.velocity_dofs.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        cell->get_dof_indices(indices);
        for (const auto index : indices)
          if (ghosted(index) > 0. || space.velocity_hanging.is_constrained(index))
            has_given[cell->active_cell_index()] = true;
      }
  }

  MatrixFreeMesh<dim> &product(const InstructionSet set, const bool is_hyperelastic)
  {
    made = make_matrix_free_mesh<dim>(set, {space.mapping, space.velocity_dofs, constraints,
                                            space.velocity_hanging, is_axisymmetric,
                                            is_hyperelastic, k, has_given});
    return *made;
  }
  MeshMultigrid<dim> multigrid(const InstructionSet set, const bool is_hyperelastic) const
  {
    return MeshMultigrid<dim>(space, {set, constraints, is_hyperelastic, 2, k, has_given});
  }
  DistributedVector linear(const Tensor<2, dim> &gradient) const
  {
    return small_problem::interpolated<dim>(space, [&gradient](const Point<dim> &x)
                                            { return gradient * x; });
  }
  /// Bends the body; in axisymmetry the axis stays.
  DistributedVector bent(const double size) const
  {
    return small_problem::interpolated<dim>(
        space,
        [size](const Point<dim> &x)
        {
          Tensor<1, dim> displacement;
          for (unsigned int c = 0; c < dim; ++c)
            displacement[c] = size * x[dim - 1] * std::sin(2. + 3. * x[0] + 2. * x[1] + c);
          return displacement;
        });
  }
  /// int k dv, with the circumference in axisymmetry.
  double integral_of_k() const
  {
    FEValues<dim> values(space.mapping, space.velocity_element,
                         space.quadrature(space.n_quadrature_points()),
                         update_JxW_values | update_quadrature_points);
    double result = 0.;
    for (const auto &cell : space.velocity_dofs.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        values.reinit(cell);
        for (const unsigned int q : values.quadrature_point_indices())
          result += k[cell->active_cell_index()] * values.JxW(q) *
                    space.circumference(values.quadrature_point(q));
      }
    return Utilities::MPI::sum(result, MPI_COMM_WORLD);
  }

  Space<dim> space;
  bool is_axisymmetric = false;
  AffineConstraints<double> constraints;
  std::vector<double> k;
  std::vector<bool> has_given;
  std::unique_ptr<MatrixFreeMesh<dim>> made;
};

/// P at a uniform gradient, and its change, written out.
Tensor<2, 3> stress(const Tensor<2, 3> &gradient, const bool is_hyperelastic)
{
  Tensor<2, 3> one;
  for (unsigned int c = 0; c < 3; ++c)
    one[c][c] = 1.;
  if (is_hyperelastic)
    return gradient + one - transpose(invert(gradient + one));
  return gradient + transpose(gradient) + 2. * trace(gradient) * one;
}

template <int dim>
void check_products(const std::string &name,
                    Setting<dim> &setting,
                    const InstructionSet set,
                    const bool is_hyperelastic,
                    const double tolerance_of_power)
{
  using Vector = typename MatrixFreeMesh<dim>::Vector;
  MatrixFreeMesh<dim> &product = setting.product(set, is_hyperelastic);
  Vector displacement, tested, rows, above, below;
  for (Vector *const vector : {&displacement, &tested, &rows, &above, &below})
    product.initialise_given(*vector);
  const auto take = [](const DistributedVector &from, Vector &to)
  { std::copy(from.begin(), from.end(), to.begin()); };

  const Tensor<2, dim> gradient = uniform_gradient<dim>(setting.is_axisymmetric),
                       of_tested = transpose(gradient) * gradient;
  const auto whole = [&setting](const Tensor<2, dim> &plane)
  { return whole_gradient<dim>(plane, setting.is_axisymmetric ? plane[1][1] : 0.); };
  take(setting.linear(gradient), displacement);
  take(setting.linear(of_tested), tested);
  product.set_residual(rows, displacement);
  check::relative(name + ": power of a uniform stress", rows * tested,
                  setting.integral_of_k() *
                      scalar_product(stress(whole(gradient), is_hyperelastic), whole(of_tested)),
                  tolerance_of_power);

  // The product against differences of the residual.
  take(setting.bent(0.08), displacement);
  take(setting.bent(-0.7), tested);
  const double h = 1e-6;
  Vector shifted(displacement);
  shifted.add(h, tested);
  product.set_residual(above, shifted);
  shifted.add(-2. * h, tested);
  product.set_residual(below, shifted);
  above.add(-1., below);
  above *= 0.5 / h;
  product.set(displacement);
  product.multiply_given(rows, tested);
  // Cells without a node that is given are left out: rows of nodes that are given have them all.
  double distance = 0., largest = 0.;
  for (unsigned int i = 0; i < rows.locally_owned_size(); ++i)
    if (setting.constraints.is_constrained(setting.space.velocity_owned.nth_index_in_set(i)))
    {
      distance = std::max(distance, std::abs(rows.local_element(i) - above.local_element(i)));
      largest = std::max(largest, std::abs(above.local_element(i)));
    }
  distance = Utilities::MPI::max(distance, MPI_COMM_WORLD);
  largest = Utilities::MPI::max(largest, MPI_COMM_WORLD);
  check::is_true(name + ": there are rows of what is given", largest > 0.1);
  check::absolute(name + ": product with what is given", distance / largest, 0., 1e-8);

  // The free entries of the same.
  Vector free, of_free;
  product.initialise_free(free);
  product.initialise_free(of_free);
  for (unsigned int i = 0; i < free.locally_owned_size(); ++i)
    if (!setting.constraints.is_constrained(setting.space.velocity_owned.nth_index_in_set(i)))
      free.local_element(i) = std::sin(1. + i);
  std::copy(free.begin(), free.end(), tested.begin());
  shifted = displacement;
  shifted.add(h, tested);
  product.set_residual(above, shifted);
  shifted.add(-2. * h, tested);
  product.set_residual(below, shifted);
  above.add(-1., below);
  above *= 0.5 / h;
  product.multiply(of_free, free);
  distance = 0.;
  for (unsigned int i = 0; i < free.locally_owned_size(); ++i)
    if (!setting.constraints.is_constrained(setting.space.velocity_owned.nth_index_in_set(i)))
      distance = std::max(distance, std::abs(of_free.local_element(i) - above.local_element(i)));
  check::absolute(name + ": product with what is free",
                  Utilities::MPI::max(distance, MPI_COMM_WORLD) / of_free.linfty_norm(), 0., 1e-7);
}

template <int dim>
void check_solution(const std::string &name,
                    Setting<dim> &setting,
                    const InstructionSet set,
                    const bool is_hyperelastic)
{
  const Space<dim> &space = setting.space;
  MeshMultigrid<dim> multigrid = setting.multigrid(set, is_hyperelastic);
  DistributedVector rows = space.velocity_vector(), solution = rows;
  multigrid.linearise(setting.bent(0.08), rows);
  DistributedVector given = setting.bent(-0.3);
  for (unsigned int i = 0; i < rows.locally_owned_size(); ++i)
  {
    const auto index = space.velocity_owned.nth_index_in_set(i);
    if (!setting.constraints.is_constrained(index))
      given.begin()[i] = 0.;
  }
  multigrid.subtract_product(given, rows);
  for (unsigned int i = 0; i < rows.locally_owned_size(); ++i)
    if (setting.constraints.is_constrained(space.velocity_owned.nth_index_in_set(i)))
      rows.begin()[i] = 0.;
  multigrid.solve(solution, rows, 1e-10);

  // With the solution in the place of what is given nothing is left.
  using Vector = typename MatrixFreeMesh<dim>::Vector;
  MatrixFreeMesh<dim> &product = setting.product(set, is_hyperelastic);
  Vector displacement, source, target;
  product.initialise_given(displacement);
  product.initialise_free(source);
  product.initialise_free(target);
  const DistributedVector bent = setting.bent(0.08);
  std::copy(bent.begin(), bent.end(), displacement.begin());
  product.set(displacement);
  std::copy(solution.begin(), solution.end(), source.begin());
  product.multiply(target, source);
  for (unsigned int i = 0; i < target.locally_owned_size(); ++i)
    target.local_element(i) -= rows.begin()[i];
  check::is_true(name + ": there is a right-hand side", rows.linfty_norm() > 1e-2);
  check::absolute(name + ": residual of the solution", target.l2_norm() / rows.l2_norm(), 0.,
                  2e-10);
  check::is_true(name + ": few iterations",
                 multigrid.n_iterations() > 3 && multigrid.n_iterations() <= 25);
}

template <int dim>
void check_mesh(const std::string &name, const Model model)
{
  small_problem::Mesh<dim> mesh(MPI_COMM_WORLD);
  GridGenerator::quarter_hyper_shell(mesh, Point<dim>(), 1., 1.5, 0, true);
  mesh.refine_global(dim == 2 ? 2 : 1);
  for (const auto &cell : mesh.active_cell_iterators())
    cell->set_material_id(cell->center().norm() > 1.35 ? 1 : 0);
  {
    Setting<dim> regular(mesh, model);
    check_products(name + ", without hanging nodes, hyperelastic", regular,
                   InstructionSet::baseline, true, 1e-12);
  }
  small_problem::refine<dim>(mesh, [](const Point<dim> &x) { return x[0] > 0.6; });
  Setting<dim> setting(mesh, model);
  // Hanging nodes on curved faces are not where their masters would have them, by 1e-5 here.
  const double of_hanging_nodes = 1e-4;
  for (const InstructionSet set :
       {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512})
  {
    // What this processor lacks is as good as what it has: the answer must not depend on it.
    const InstructionSet usable = can_run(set) ? set : InstructionSet::baseline;
    const std::string of_set = name + ", " + word_of(instruction_set_words(), set);
    check_products(of_set + ", hyperelastic", setting, usable, true, of_hanging_nodes);
  }
  check_products(name + ", elastic", setting, InstructionSet::baseline, false, of_hanging_nodes);
  const InstructionSet widest = dim == 2 ? InstructionSet::baseline : widest_instruction_set();
  check_solution(name + ", hyperelastic", setting, widest, true);
  check_solution(name + ", elastic", setting, widest, false);
}
} // namespace

UNIT_TEST(mesh_multigrid)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::quiet_other_ranks();
  check_mesh<2>("plane", Model::plane_strain);
  check_mesh<2>("axisymmetric", Model::axisymmetric);
  check_mesh<3>("in space", Model::three_dimensional);
}
} // namespace test_of_mesh_multigrid
