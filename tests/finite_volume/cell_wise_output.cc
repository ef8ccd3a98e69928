// The fields of a picture, cell by cell, as they were drawn.

#include <continua/finite_volume/cell_wise_output.h>

#include "../unit_test.h"
#include "cell_wise_body.h"

#include <algorithm>

namespace test_of_cell_wise_output
{
using namespace cell_wise_meshes;
using dealii::Point;
using dealii::Tensor;

namespace
{
/// Gives what was drawn.
template <int dim>
class Drawing : public dealii::DataOut<dim>
{
public:
  using dealii::DataOut<dim>::get_patches;
  using dealii::DataOut<dim>::get_dataset_names;
};

template <int dim>
void test(const Model model)
{
  const std::string name = model == Model::axisymmetric ? "axisymmetric: "
                           : dim == 2                   ? "2-D: "
                                                        : "3-D: ";
  Body<dim> body(
      [](Triangulation<dim> &mesh)
      {
        make_box(mesh, 4);
        refine_corner(mesh);
      },
      model);
  // Both fields are r in the direction of y in axisymmetry, where there is a hoop strain.
  const auto field = [](const Point<dim> &x)
  {
    Tensor<1, dim> result;
    result[0] = 1. + 2. * x[0];
    result[1] = 5. * x[1];
    return result;
  };
  body.velocity = velocity_field<dim>(body.space, field);
  body.history.displacement() =
      velocity_field<dim>(body.space, [&](const Point<dim> &x) { return 2. * field(x); });
  body.pressure = pressure_field<dim>(body.space, [](const Point<dim> &x, const unsigned int region)
                                      { return x[0] + 100. * region; });
  CellWiseOutput<dim> output(body.space, body.problem, body.evaluation);
  Drawing<dim> drawing;
  const auto units = output.add(body.state(), drawing);
  check::is_true(name + "units", units.at("velocity") == "m/s" && units.at("displacement") == "m" &&
                                     units.at("stress_xy") == "Pa" && units.at("phase") == "1");
  drawing.build_patches(1);
  const auto names = drawing.get_dataset_names();
  // Velocity and displacement are vectors of the space, the stress has 4 or 6 components.
  check::is_true(name + "fields", names.size() == 2 * dim + 1 + (dim == 2 ? 4 : 6) + 3);
  const auto row = [&](const std::string &which) {
    return static_cast<unsigned int>(std::find(names.begin(), names.end(), which) - names.begin());
  };

  double of_velocity = 0., of_displacement = 0., of_pressure = 0., of_stress = 0.;
  bool regions_are_right = true;
  for (const auto &patch : drawing.get_patches())
  {
    const Point<dim> middle = 0.5 * (patch.vertices[0] + patch.vertices[(1 << dim) - 1]);
    const unsigned int region =
        static_cast<unsigned int>(std::lround(patch.data(row("material_id"), 0)));
    const auto error = [&](const unsigned int which, const double exact)
    { return std::abs(patch.data(which, 0) - exact); };
    regions_are_right = regions_are_right && patch.data(row("phase"), 0) == (region == 0 ? 1. : 0.);
    for (unsigned int c = 0; c < dim; ++c)
    {
      of_velocity = std::max(of_velocity, error(c, field(middle)[c]));
      of_displacement = std::max(of_displacement, error(dim + c, 2. * field(middle)[c]));
    }
    const double p = middle[0] + 100. * region;
    of_pressure = std::max(of_pressure, error(row("pressure"), p));
    // w = 3 D or 2 U.
    const double scale = region == 0 ? 6. : 2.;
    const double hoop = model == Model::axisymmetric ? 5. : 0.;
    const double mean = (2. + 5. + hoop) / 3.;
    of_stress = std::max({of_stress, error(row("stress_xx"), 2. * scale * (2. - mean) - p),
                          error(row("stress_yy"), 2. * scale * (5. - mean) - p),
                          error(row("stress_zz"), 2. * scale * (hoop - mean) - p),
                          error(row("stress_xy"), 0.)});
  }
  check::absolute(name + "velocity", largest(of_velocity), 0., 1e-6);
  check::absolute(name + "displacement", largest(of_displacement), 0., 1e-5);
  check::absolute(name + "pressure", largest(of_pressure), 0., 1e-4);
  check::absolute(name + "stress", largest(of_stress), 0., 1e-4);
  check::is_true(name + "phase", regions_are_right);
}
} // namespace

UNIT_TEST(cell_wise_output)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  test<2>(Model::plane_strain);
  test<2>(Model::axisymmetric);
  test<3>(Model::three_dimensional);
}
} // namespace test_of_cell_wise_output
