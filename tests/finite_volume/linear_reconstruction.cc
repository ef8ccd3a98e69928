// Between the places of its values a linear field is exact: in the corners of every cell and on the
// faces with values of their own, with the values of the other ranks; gradients and the hoop
// strain.

#include <continua/finite_volume/linear_reconstruction.h>

#include "cell_wise_body.h"

#include "../unit_test.h"

#include <algorithm>

namespace test_of_linear_reconstruction
{
namespace
{
using namespace cell_wise_meshes;

template <int dim>
void test(const Model model)
{
  const bool axisymmetric = model == Model::axisymmetric;
  // Row a is the slope of component a.
  dealii::Tensor<2, dim> slopes;
  for (unsigned int a = 0; a < dim; ++a)
    for (unsigned int b = 0; b < dim; ++b)
      slopes[a][b] = axisymmetric && a == 1 ? (b == 1 ? 0.4 : 0.) : 1. + a - 0.3 * b;
  const auto field = [&](const dealii::Point<dim> &p)
  { return slopes * dealii::Tensor<1, dim>(p); };
  for (const auto &named : flat_faced<dim>())
  {
    Triangulation<dim> triangulation(MPI_COMM_WORLD);
    named.make(triangulation);
    CellWiseSpace<dim> space(triangulation, model);
    space.distribute();
    const Problem problem = make_problem<dim>(model);
    LinearReconstruction<dim> reconstruction(space, problem);
    reconstruction.build();
    const DistributedVector velocity =
        reconstruction.ghosted_velocity(velocity_field<dim>(space, field));
    const DistributedVector pressure = reconstruction.ghosted_pressure(pressure_field<dim>(
        space, [](const dealii::Point<dim> &p, const unsigned int) { return linear<dim>(p); }));
    using Reconstruction = LinearReconstruction<dim>;

    double values = 0., gradients = 0., hoops = 0.;
    const auto look = [&](const CellPlace &place, const dealii::Point<dim> &point)
    {
      values = std::max(
          {values,
           (Reconstruction::vector_value(reconstruction.velocity(place, point), velocity) -
            field(point))
               .norm(),
           std::abs(Reconstruction::value(reconstruction.pressure(place, point), pressure) -
                    linear<dim>(point))});
      gradients = std::max(gradients, (Reconstruction::vector_gradient(
                                           reconstruction.velocity_gradient(place), velocity) -
                                       slopes)
                                          .norm());
      double hoop = 0.;
      for (const auto &[value, factor] : reconstruction.hoop(place))
        hoop += factor * velocity(dim * value + 1);
      hoops = std::max(hoops, std::abs(hoop - (axisymmetric ? 0.4 : 0.)));
    };
    for (unsigned int c = 0; c < space.mesh.n_owned_cells(); ++c)
    {
      const auto &cell = space.mesh.cells()[c];
      for (const unsigned int v : cell.iterator->vertex_indices())
        look({c, CellPlace::none}, cell.iterator->vertex(v));
      for (const unsigned int f : cell.faces)
        if (space.mesh.faces()[f].has_value())
        {
          // Off its centre, in its plane.
          const auto &face = space.mesh.faces()[f];
          dealii::Tensor<1, dim> along;
          along[0] = 0.05 * face.normal[1];
          along[1] = -0.05 * face.normal[0];
          look({c, f}, face.centre + along);
        }
    }
    const std::string name = (axisymmetric ? "axisymmetric, "
                              : dim == 2   ? "2-D, "
                                           : "3-D, ") +
                             named.name;
    check::absolute(name + ": values", largest(values), 0., 1e-12);
    check::absolute(name + ": gradients", largest(gradients), 0., 1e-11);
    check::absolute(name + ": round the axis", largest(hoops), 0., 1e-12);
  }
}
} // namespace

UNIT_TEST(linear_reconstruction)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  test<2>(Model::plane_strain);
  test<2>(Model::axisymmetric);
  test<3>(Model::three_dimensional);
}
} // namespace test_of_linear_reconstruction
