// The operators of a region on fields whose stress is constant: tractions are exact on every mesh
// of flat-faced cells and do not depend on the stencil coefficient, cells are in balance, faces
// carry the traction; the gradient of a linear pressure and the divergence of a linear field.

#include <continua/finite_volume/cell_wise_operators.h>
#include <continua/linear_algebra/matrix_product.h>

#include "cell_wise_body.h"

#include "../unit_test.h"

#include <algorithm>

namespace test_of_cell_wise_operators
{
using namespace cell_wise_meshes;

namespace
{
/// A field whose gradient is constant; in axisymmetry with u_r in proportion to r.
template <int dim>
dealii::Tensor<2, dim> slopes(const bool axisymmetric)
{
  dealii::Tensor<2, dim> result; // of component a along direction b
  for (unsigned int a = 0; a < dim; ++a)
    for (unsigned int b = 0; b < dim; ++b)
      result[a][b] = axisymmetric ? (a == b ? 0.7 - 0.4 * a : 0.) : 0.3 + 0.5 * a - 0.2 * b * b;
  return result;
}

template <int dim>
void check_meshes(const Model model)
{
  const bool axisymmetric = model == Model::axisymmetric;
  const dealii::Tensor<2, dim> grad = slopes<dim>(axisymmetric);
  const double hoop = axisymmetric ? grad[1][1] : 0.;
  const std::string kind = axisymmetric ? "axisymmetric, " : dim == 2 ? "2-D, " : "3-D, ";
  for (const auto &named : flat_faced<dim>())
  {
    Triangulation<dim> triangulation(MPI_COMM_WORLD);
    named.make(triangulation);
    Problem problem = make_problem<dim>(model);
    problem.materials[1] = problem.materials[0];
    CellWiseSpace<dim> space(triangulation, model);
    space.distribute();
    FaceConditions<dim> conditions(space, problem.conditions);
    conditions.build();
    const DistributedVector w = velocity_field<dim>(space, [&](const dealii::Point<dim> &p)
                                                    { return grad * dealii::Tensor<1, dim>(p); });
    const DistributedVector p = pressure_field<dim>(
        space, [](const dealii::Point<dim> &x, const unsigned int) { return 5. - 2. * x[0]; });

    double out_of_balance = 0., traction_error = 0., gradient_error = 0., divergence_error = 0.;
    for (const auto coefficient :
         {StencilCoefficient::longitudinal, StencilCoefficient::deviatoric})
    {
      CellWiseParameters parameters;
      parameters.stencil_coefficient = coefficient;
      std::vector<CellWiseOperators> operators;
      PressureClosure closure;
      assemble_cell_operators(space, problem, conditions, parameters,
                              std::vector<bool>(problem.materials.size(), true), operators,
                              closure);
      DistributedVector force = space.velocity_vector(), product = force, pressure_force = force,
                        rate = space.pressure_vector(), part = rate;
      for (const CellWiseOperators &of_region : operators)
      {
        multiply(of_region.stiffness, product, w);
        force.add(1., product);
        multiply(of_region.gradient, product, p);
        pressure_force.add(1., product);
        multiply(of_region.divergence, part, w);
        rate.add(1., part);
      }
      const double trace = dealii::trace(grad) + hoop;
      for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
      {
        const auto &volume = space.mesh.cells()[cell];
        const unsigned int row = space.local_velocity(space.velocities.of_cell(cell));
        for (unsigned int c = 0; c < dim; ++c)
        {
          out_of_balance = std::max(out_of_balance, std::abs(force.begin()[row + c]));
          gradient_error = std::max(gradient_error, std::abs(pressure_force.begin()[row + c] -
                                                             (c == 0 ? -2. * volume.volume : 0.)));
        }
        divergence_error =
            std::max(divergence_error,
                     std::abs(rate.begin()[space.local_pressure(space.pressures.of_cell(cell))] -
                              trace * volume.volume));
      }
      for (const auto &face : conditions.faces())
      {
        const dealii::Tensor<1, dim> &n = space.mesh.faces()[face.face].normal;
        const dealii::Tensor<1, dim> t =
            grad * n + dealii::transpose(grad) * n - 2. / 3. * trace * n;
        for (unsigned int c = 0; c < dim; ++c)
          traction_error = std::max(traction_error,
                                    std::abs(force.begin()[face.index + c] - face.weight * t[c]));
      }
    }
    check::absolute(kind + named.name + ": cells in balance", largest(out_of_balance), 0., 1e-11);
    check::absolute(kind + named.name + ": tractions", largest(traction_error), 0., 1e-11);
    if (!axisymmetric)
    {
      check::absolute(kind + named.name + ": gradient", largest(gradient_error), 0., 1e-12);
      check::absolute(kind + named.name + ": divergence", largest(divergence_error), 0., 1e-12);
    }
  }
}
} // namespace

UNIT_TEST(cell_wise_operators)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  check_meshes<2>(Model::plane_strain);
  check_meshes<2>(Model::axisymmetric);
  check_meshes<3>(Model::three_dimensional);

  // Coefficients of a solid with K = 2 Pa and mu = 3 Pa.
  Material solid = make_problem<2>(Model::plane_strain).materials[0];
  solid.compression = Compression::elastic(0.5);
  CellWiseParameters parameters;
  check::absolute("with pressure: 4/3", traction_coefficients(solid, parameters).stencil_ratio,
                  4. / 3., 1e-14);
  check::absolute("and no lambda", traction_coefficients(solid, parameters).trace_ratio, -2. / 3.,
                  1e-14);
  parameters.formulation = Formulation::velocity;
  check::absolute("without: (K + 4/3 mu)/mu",
                  traction_coefficients(solid, parameters).stencil_ratio, 2. / 3. + 4. / 3., 1e-14);
  check::absolute("and lambda/mu", traction_coefficients(solid, parameters).trace_ratio,
                  2. / 3. - 2. / 3., 1e-14);
  solid.compression = Compression();
  check::throws<std::invalid_argument>(
      "an incompressible one", [&]() { traction_coefficients(solid, parameters); },
      "no finite longitudinal modulus");
}
} // namespace test_of_cell_wise_operators
