// The faces' excess velocity under a pressure that stays is -s/v (1 - exp(-v t/rho)), s the compact
// minus the wide normal gradient: schemes meet it with their orders, its steady value does not
// depend on the time step, and what it lets out of one cell enters the next; with hanging nodes.

#include <continua/continuum/state_vectors.h>
#include <continua/finite_volume/excess_velocity.h>

#include "cell_wise_step.h"

#include "../unit_test.h"

#include <cmath>

namespace test_of_excess_velocity
{
namespace
{
using namespace cell_wise_meshes;
const double density = 1.7;

std::string kind_of_model(const Model model)
{
  return model == Model::axisymmetric   ? "axisymmetric: "
         : model == Model::plane_strain ? "2-D: "
                                        : "3-D: ";
}

/// Viscosity 2 Pa s.
CellWiseCoefficients coefficients_of(const Step &step)
{
  CellWiseCoefficients coefficients = make_coefficients();
  coefficients.mass = {step.a0 * density, step.a0 * density};
  return coefficients;
}

template <int dim>
struct Liquid
{
  explicit Liquid(const Model model)
      : body(
            [](Triangulation<dim> &mesh)
            {
              make_box(mesh, 4);
              refine_corner(mesh);
              for (const auto &cell : mesh.active_cell_iterators())
                cell->set_material_id(1);
            },
            model,
            make_coefficients(),
            [](Problem &problem) { problem.materials[1].density = density; }),
        reconstruction(body.space, body.problem),
        excess(body.system, reconstruction)
  {
    reconstruction.build();
    excess.reinit();
    pressure = pressure_field<dim>(
        body.space, [](const dealii::Point<dim> &p, const unsigned int)
        { return std::sin(5. * p[0]) * std::cos(4. * p[1]) + (p[0] > 0.4 ? 1. : 0.); });
    rest();
  }
  void rest()
  {
    const DistributedVector no_velocity = body.space.velocity_vector(),
                            no_pressure = body.space.pressure_vector();
    StateSizes sizes(no_velocity, no_pressure, no_pressure, no_pressure);
    excess.visit(sizes);
  }
  /// What flows out of each cell by the excess.
  DistributedVector outflow() const
  {
    DistributedVector nothing = body.space.pressure_vector(), result = nothing;
    excess.add_outflow(nothing, result);
    return result;
  }
  /// The same after a time, exactly; v of each face from the correction without inertia.
  DistributedVector exact(const double time)
  {
    const CellWiseSpace<dim> &space = body.space;
    CellWiseCoefficients steady = make_coefficients();
    steady.mass = {0., 0.};
    body.system.prepare(steady);
    const DistributedVector ghosted = reconstruction.ghosted_pressure(pressure);
    DistributedVector result = space.pressure_vector();
    for (unsigned int face = 0; face < space.mesh.faces().size(); ++face)
    {
      const VolumeFace<dim> &surface = space.mesh.faces()[face];
      if (surface.has_value())
        continue;
      const double mobility = body.system.flux_mobility(face);
      const double slope =
          LinearReconstruction<dim>::value(body.system.pressure_difference(face), ghosted);
      const double velocity = -mobility * slope * (1. - std::exp(-time / (mobility * density)));
      for (unsigned int side = 0; side < 2; ++side)
        if (space.mesh.cells()[surface.cell(side)].is_owned)
          result.begin()[body.cell_pressure_row(surface.cell(side))] +=
              (side == 0 ? 1. : -1.) * surface.area * velocity;
    }
    return result;
  }
  /// Steps from rest to a time; the relative error of the outflow.
  double error(const std::string &scheme, const double end, const unsigned int n)
  {
    rest();
    DistributedVector known = body.space.pressure_vector();
    const double h = end / n;
    for (unsigned int i = 0; i < n; ++i)
    {
      const Step step = scheme == "crank nicolson" ? crank_nicolson_step(i * h, h)
                        : scheme == "backward differencing" && i > 0
                            ? backward_differencing_step(i * h, h, h, Update::implicit)
                            : euler_step(i * h, h, Update::implicit);
      body.system.prepare(coefficients_of(step));
      excess.add_past(step, known);
      excess.advance(step, pressure);
    }
    // Without a system there is nothing but e itself.
    body.system.reinit();
    DistributedVector difference = outflow();
    total = 0.;
    for (const double value : difference)
      total += value;
    const DistributedVector right = exact(end);
    difference.add(-1., right);
    total = std::abs(sum(total)) / right.linfty_norm();
    return difference.linfty_norm() / right.linfty_norm();
  }

  CellWiseStep<dim> body;
  LinearReconstruction<dim> reconstruction;
  ExcessVelocity<dim> excess;
  DistributedVector pressure;
  double total = 0.;
};

template <int dim>
void check_model(const Model model)
{
  const std::string name = kind_of_model(model);
  Liquid<dim> liquid(model);
  check::is_true(name + "a liquid has it", liquid.excess.exists());
  // The slowest face takes rho d^2/(4 eta) of 13 ms.
  const double end = 4e-3;
  for (const auto &[scheme, order] : {std::pair<std::string, double>{"euler", 1.},
                                      {"backward differencing", 2.},
                                      {"crank nicolson", 2.}})
  {
    const double coarse = liquid.error(scheme, end, 64), fine = liquid.error(scheme, end, 128);
    check::absolute(name + scheme + ", order", std::log2(coarse / fine), order, 0.1);
    check::absolute(name + scheme + ", the volume is kept", liquid.total, 0., 1e-12);
  }
  for (const unsigned int n : {20, 50})
    check::absolute(name + "steady", liquid.error("euler", 10., n), 0., 1e-12);
}
} // namespace

UNIT_TEST(excess_velocity)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  check_model<2>(Model::plane_strain);
  check_model<2>(Model::axisymmetric);
  check_model<3>(Model::three_dimensional);
}
} // namespace test_of_excess_velocity
