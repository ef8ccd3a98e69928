// The traction on a face: exact for linear fields on every mesh of flat-faced cells, whatever the
// stencil coefficient is; none by a rotation; equal and opposite on the sides of a face for any
// field; what the compact and the wide stencil make of a checkerboard; the stress round the axis.

#include <continua/finite_volume/face_traction.h>

#include "cell_wise_meshes.h"

#include "../unit_test.h"

#include <algorithm>

namespace test_of_face_traction
{
namespace
{
using namespace cell_wise_meshes;
using Components = std::vector<std::vector<double>>;

/// The values of a vector field by component.
template <int dim>
Components
components_of(const CellWiseSpace<dim> &space,
              const std::function<dealii::Tensor<1, dim>(const dealii::Point<dim> &)> &function)
{
  Components result;
  for (unsigned int c = 0; c < dim; ++c)
    result.push_back(replicated_field<dim>(
        space.mesh, space.velocities, [&](const dealii::Point<dim> &p) { return function(p)[c]; }));
  return result;
}

template <int dim>
dealii::Tensor<1, dim> traction_of(const Stencil<dealii::Tensor<2, dim>> &stencil,
                                   const Components &field)
{
  dealii::Tensor<1, dim> result;
  for (const auto &[value, matrix] : stencil)
    for (unsigned int a = 0; a < dim; ++a)
      for (unsigned int b = 0; b < dim; ++b)
        result[a] += matrix[a][b] * field[b][value];
  return result;
}

struct Coefficients
{
  double stencil, trace;
  bool replaced;
};

/// Of component a along direction b; in axisymmetry with u_r in proportion to r.
template <int dim>
dealii::Tensor<2, dim> constant_gradient(const bool axisymmetric)
{
  dealii::Tensor<2, dim> result;
  for (unsigned int a = 0; a < dim; ++a)
    for (unsigned int b = 0; b < dim; ++b)
      result[a][b] = axisymmetric ? (a == b ? 0.7 - 0.4 * a : 0.) : 0.3 + 0.5 * a - 0.2 * b * b;
  return result;
}

template <int dim>
void check_meshes(const Model model, const std::vector<Coefficients> &list)
{
  const bool axisymmetric = model == Model::axisymmetric;
  const dealii::Tensor<2, dim> gradient = constant_gradient<dim>(axisymmetric);
  const double trace = dealii::trace(gradient) + (axisymmetric ? gradient[1][1] : 0.);
  const std::string kind = axisymmetric ? "axisymmetric, " : dim == 2 ? "2-D, " : "3-D, ";
  for (const auto &named : flat_faced<dim>())
  {
    Triangulation<dim> triangulation(MPI_COMM_WORLD);
    named.make(triangulation);
    CellWiseSpace<dim> space(triangulation, model);
    space.distribute();
    const Components linear_field = components_of<dim>(
        space, [&](const dealii::Point<dim> &p) { return gradient * dealii::Tensor<1, dim>(p); });
    // About the axis z, and moved; in axisymmetry a motion along the axis.
    const Components rigid = components_of<dim>(space,
                                                [&](const dealii::Point<dim> &p)
                                                {
                                                  dealii::Tensor<1, dim> u;
                                                  u[0] = 2. - (axisymmetric ? 0. : p[1]);
                                                  u[1] = axisymmetric ? 0. : p[0];
                                                  return u;
                                                });
    const Components rough = components_of<dim>(space,
                                                [](const dealii::Point<dim> &p)
                                                {
                                                  dealii::Tensor<1, dim> u;
                                                  for (unsigned int c = 0; c < dim; ++c)
                                                    u[c] = std::sin(1e3 * p.norm() + 1e2 * c);
                                                  return u;
                                                });
    double linear_error = 0., wide_error = 0., rigid_error = 0., difference = 0., hoop_error = 0.;
    for (const Coefficients &coefficients : list)
    {
      const FaceTraction<dim> traction(space, coefficients.stencil, coefficients.trace,
                                       coefficients.replaced);
      for (unsigned int f = 0; f < space.mesh.faces().size(); ++f)
      {
        const auto &face = space.mesh.faces()[f];
        dealii::Tensor<1, dim> sum;
        for (unsigned int side = 0; side < face.n_sides(); ++side)
        {
          const dealii::Tensor<1, dim> n = face.outward(side);
          const dealii::Tensor<1, dim> exact =
              gradient * n + dealii::transpose(gradient) * n + coefficients.trace * trace * n;
          const auto stencil = traction(f, side);
          linear_error =
              std::max(linear_error, (traction_of(stencil, linear_field) - exact).norm());
          wide_error = std::max(wide_error,
                                (traction_of(traction.wide(f, side), linear_field) - exact).norm());
          rigid_error = std::max(rigid_error, traction_of(stencil, rigid).norm());
          sum += traction_of(stencil, rough);
        }
        if (!face.has_value())
          difference = std::max(difference, sum.norm());
      }
      for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
      {
        double stress = 0.;
        for (const auto &[value, vector] : traction.hoop(cell))
          for (unsigned int c = 0; c < dim; ++c)
            stress += vector[c] * linear_field[c][value];
        hoop_error = std::max(
            hoop_error,
            std::abs(stress -
                     (axisymmetric ? 2. * gradient[1][1] + coefficients.trace * trace : 0.)));
      }
    }
    check::absolute(kind + named.name + ": linear fields", largest(linear_error), 0., 1e-11);
    check::absolute(kind + named.name + ": wide", largest(wide_error), 0., 1e-11);
    check::absolute(kind + named.name + ": rigid motions", largest(rigid_error), 0., 1e-11);
    check::absolute(kind + named.name + ": opposite on the two sides", largest(difference), 0.,
                    1e-10);
    if (axisymmetric)
      check::absolute(kind + named.name + ": round the axis", largest(hoop_error), 0., 1e-11);
  }
}

/// On squares of 1/8 the compact normal gradient of a checkerboard of +-1 is -16 times the owner's
/// value, the gradients of the cells are zero.
void check_checkerboard()
{
  Triangulation<2> triangulation(MPI_COMM_WORLD);
  make_box(triangulation, 8);
  for (const auto &cell : triangulation.active_cell_iterators())
    cell->set_material_id(0);
  CellWiseSpace<2> space(triangulation, Model::plane_strain);
  space.distribute();
  const auto sign = [](const dealii::Point<2> &p)
  { return (int(std::floor(8. * p[0])) + int(std::floor(8. * p[1]))) % 2 == 0 ? 1. : -1.; };
  const Components field = components_of<2>(space,
                                            [&](const dealii::Point<2> &p) {
                                              return dealii::Tensor<1, 2>({sign(p), 0.});
                                            });
  const FaceTraction<2> traction(space, 4. / 3., -2. / 3., true);
  double compact = 0., wide = 0.;
  unsigned int n_faces = 0;
  for (unsigned int f = 0; f < space.mesh.faces().size(); ++f)
  {
    const auto &face = space.mesh.faces()[f];
    if (face.centre[0] < 0.2 || face.centre[0] > 0.8 || face.centre[1] < 0.2 ||
        face.centre[1] > 0.8)
      continue;
    ++n_faces;
    const dealii::Tensor<1, 2> exact(
        {-16. * 4. / 3. * sign(space.mesh.cells()[face.owner].centre), 0.});
    compact = std::max(compact, (traction_of(traction(f, 0), field) - exact).norm());
    wide = std::max(wide, traction_of(traction.wide(f, 0), field).norm());
  }
  check::is_true("checkerboard: faces", n_faces > 20);
  check::absolute("checkerboard, compact", compact, 0., 1e-12);
  check::absolute("checkerboard, wide: not seen", wide, 0., 1e-12);
}
} // namespace

UNIT_TEST(face_traction)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  check_meshes<2>(Model::plane_strain,
                  {{1., -2. / 3., true}, {4. / 3., 2., false}, {10., -2. / 3., true}});
  check_meshes<2>(Model::axisymmetric,
                  {{1., -2. / 3., true}, {4. / 3., 2., false}, {10., -2. / 3., true}});
  check_meshes<3>(Model::three_dimensional, {{4. / 3., 2., false}});
  check_checkerboard();
}
} // namespace test_of_face_traction
