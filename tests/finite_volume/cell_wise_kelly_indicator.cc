// Kelly's indicator from the cells' gradients: none of a linear field, that of a parabola by hand,
// none at an interface.

#include <continua/finite_volume/cell_wise_kelly_indicator.h>

#include "../unit_test.h"
#include "cell_wise_body.h"

#include <algorithm>

namespace test_of_cell_wise_kelly_indicator
{
using namespace cell_wise_meshes;
using dealii::Point;
using dealii::Tensor;

namespace
{
template <int dim>
void test()
{
  const std::string name = dim == 2 ? "2-D: " : "3-D: ";
  const Model model = dim == 2 ? Model::plane_strain : Model::three_dimensional;
  const auto linear = [](const Point<dim> &x) { return 3. * x[0] - 2. * x[1]; };
  const auto in_x = [](const double value)
  {
    Tensor<1, dim> vector;
    vector[0] = value;
    return vector;
  };
  dealii::Vector<float> per_cell;
  {
    Body<dim> body(
        [](Triangulation<dim> &mesh)
        {
          make_box(mesh, 4);
          refine_corner(mesh);
        },
        model);
    const auto &reconstruction = body.evaluation.reconstruction();
    body.velocity =
        velocity_field<dim>(body.space, [&](const Point<dim> &x) { return in_x(linear(x)); });
    body.pressure =
        pressure_field<dim>(body.space, [&](const Point<dim> &x, const unsigned int region)
                            { return linear(x) + 7. * region * x[0]; });
    kelly_indicators_of_velocity(body.space, reconstruction, body.velocity, per_cell);
    check::absolute(name + "linear velocity", largest(per_cell.linfty_norm()), 0., 1e-5);
    kelly_indicators_of_pressure(body.space, reconstruction, body.pressure, per_cell);
    check::absolute(name + "linear pressure with a kink at the interface",
                    largest(per_cell.linfty_norm()), 0., 1e-5);
  }
  Body<dim> body([](Triangulation<dim> &mesh) { make_box(mesh, 8); }, model);
  const auto &reconstruction = body.evaluation.reconstruction();
  body.velocity =
      velocity_field<dim>(body.space, [&](const Point<dim> &x) { return in_x(x[0] * x[0]); });
  body.pressure = pressure_field<dim>(body.space, [](const Point<dim> &x, unsigned int)
                                      { return x[0] * x[0]; });
  // Central differences have the parabola's slope; it differs by 2 h between neighbours.
  const double h = 1. / 8.;
  const double expected =
      std::sqrt(std::sqrt(double(dim)) * h / 24. * 2. * std::pow(h, dim - 1) * 4. * h * h);
  for (const bool of_velocity : {true, false})
  {
    if (of_velocity)
      kelly_indicators_of_velocity(body.space, reconstruction, body.velocity, per_cell);
    else
      kelly_indicators_of_pressure(body.space, reconstruction, body.pressure, per_cell);
    double error = 0.;
    for (unsigned int cell = 0; cell < body.space.mesh.n_owned_cells(); ++cell)
    {
      // Three cells in a row that have no face with its own value across the x axis.
      const FiniteVolume<dim> &volume = body.space.mesh.cells()[cell];
      if (volume.centre[0] > 0.7 && volume.centre[0] < 0.8)
        error =
            std::max(error, std::abs(per_cell[volume.iterator->active_cell_index()] - expected));
    }
    check::absolute(name + "parabola of " + (of_velocity ? "velocity" : "pressure"),
                    largest(error) / expected, 0., 1e-5);
  }
}
} // namespace

UNIT_TEST(cell_wise_kelly_indicator)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  test<2>();
  test<3>();
}
} // namespace test_of_cell_wise_kelly_indicator
