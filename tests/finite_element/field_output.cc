// The fields of a picture: vorticity, Q criterion and wall shear stress, which are drawn where they
// are asked for, and the stress of a body that is stretched far.

#include <continua/finite_element/looking/field_output.h>
#include <continua/finite_element/products/region_operators.h>
#include <continua/materials/strain_law_types.h>

#include "../unit_test.h"
#include "small_problem.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace test_of_field_output
{
using namespace Continua;
using namespace dealii;

namespace
{
/// Gives what was drawn.
template <int dim>
class DrawnFields : public DataOut<dim>
{
public:
  using DataOut<dim>::get_patches;
  using DataOut<dim>::get_dataset_names;
};

/// A liquid of viscosity 2 in a box, held on the bottom: U = (3 y, 5 x), of which the curl is 2, Q
/// is -15 and eta (3 + 5) the shear stress.
template <int dim>
void test_drawing(const std::string &name)
{
  small_problem::Mesh<dim> mesh(MPI_COMM_WORLD);
  small_problem::make_box<dim>(mesh, std::vector<unsigned int>(dim, 2));
  small_problem::refine<dim>(mesh, [](const Point<dim> &x) { return x[0] > 1. && x[1] < 1.; });
  Problem problem;
  problem.model = dim == 2 ? Model::plane_strain : Model::three_dimensional;
  problem.regions = {"liquid"};
  Material liquid;
  liquid.shear.viscosity = 2.;
  problem.materials = {liquid};
  BoundaryCondition fixed;
  fixed.boundary_id = 2;
  fixed.region_ids = {0};
  fixed.normal.kind = fixed.tangential.kind = BoundaryPart::Kind::velocity;
  problem.conditions = {fixed};
  problem.further_fields.vorticity = problem.further_fields.q_criterion =
      problem.further_fields.wall_shear_stress = true;
  Space<dim> space(mesh, SpaceParameters(), problem.model, 1);
  space.distribute();
  std::vector<RegionOperators> operators(1);
  assemble_region_operators(space, operators);
  BranchHistory history(problem.materials);
  history.reinit(space.velocity_vector(), velocity_nodes(operators));
  const DistributedVector velocity = small_problem::interpolated<dim>(space,
                                                                      [](const Point<dim> &x)
                                                                      {
                                                                        Tensor<1, dim> v;
                                                                        v[0] = 3. * x[1];
                                                                        v[1] = 5. * x[0];
                                                                        return v;
                                                                      });
  const DistributedVector pressure = space.pressure_vector();
  FieldEvaluation<dim> evaluation(space, problem);
  WallShearStress<dim> wall_shear(space, problem);
  wall_shear.reinit();
  FieldOutput<dim> output(space, problem, evaluation, wall_shear);
  DrawnFields<dim> drawing;
  const auto units = output.add(State{velocity, pressure, history}, drawing);
  check::is_true(name + "units", units.at("vorticity") == "1/s" &&
                                     units.at("Q_criterion") == "1/s^2" &&
                                     units.at("wall_shear_stress") == "Pa" &&
                                     units.count("oscillatory_shear_index") == 0);
  drawing.build_patches(2);
  const auto names = drawing.get_dataset_names();
  const auto row = [&](const std::string &which) {
    return static_cast<unsigned int>(std::find(names.begin(), names.end(), which) - names.begin());
  };
  const unsigned int last_of_vorticity = row("Q_criterion") - 1;
  double of_vorticity = 0., of_q = 0., on_wall = 0., elsewhere = 0.;
  for (const auto &patch : drawing.get_patches())
    for (unsigned int point = 0; point < patch.data.n_cols(); ++point)
    {
      of_vorticity = std::max(of_vorticity, std::abs(patch.data(last_of_vorticity, point) - 2.));
      of_q = std::max(of_q, std::abs(patch.data(row("Q_criterion"), point) + 15.));
    }
  for (const auto &patch : drawing.get_patches())
    for (const unsigned int v : GeometryInfo<dim>::vertex_indices())
    {
      // A corner of the cell is a corner of the patch's points.
      unsigned int point = 0;
      for (unsigned int d = 0, stride = 1; d < dim; ++d, stride *= 3)
        point += (v >> d) % 2 * 2 * stride;
      const double shear = patch.data(row("wall_shear_stress"), point);
      if (patch.vertices[v][1] < 1e-9)
        on_wall = std::max(on_wall, std::abs(shear - 16.));
      else
        elsewhere = std::max(elsewhere, std::abs(shear));
    }
  const auto largest = [](const double value)
  { return Utilities::MPI::max(value, MPI_COMM_WORLD); };
  check::absolute(name + "vorticity", largest(of_vorticity), 0., 1e-5);
  check::absolute(name + "Q criterion", largest(of_q), 0., 1e-5);
  check::absolute(name + "shear on the wall", largest(on_wall), 0., 1e-5);
  check::absolute(name + "none elsewhere", largest(elsewhere), 0., 1e-12);
}

/// A neo-Hookean body of shear modulus 2 under a pressure of 3 whose stretch along x, 1 + x/5, is
/// another one at each corner of a cell: the mean-free stress is mu J^(-5/3) dev diag(J^2, 1, 1).
template <int dim>
void test_finite_stress(const std::string &name)
{
  small_problem::Mesh<dim> mesh(MPI_COMM_WORLD);
  small_problem::make_box<dim>(mesh, std::vector<unsigned int>(dim, 2));
  Problem problem;
  problem.model = dim == 2 ? Model::plane_strain : Model::three_dimensional;
  problem.deformation = Deformation::finite;
  problem.regions = {"body"};
  Material body;
  body.shear.branches = {{2., std::numeric_limits<double>::infinity()}};
  body.strain_law = make_strain_law(StrainLawParameters(), 2., 7.);
  problem.materials = {body};
  Space<dim> space(mesh, SpaceParameters(), problem.model, 1);
  space.distribute();
  std::vector<RegionOperators> operators(1);
  assemble_region_operators(space, operators);
  BranchHistory history(problem.materials);
  history.reinit(space.velocity_vector(), velocity_nodes(operators));
  history.displacement() = small_problem::interpolated<dim>(space,
                                                            [](const Point<dim> &x)
                                                            {
                                                              Tensor<1, dim> u;
                                                              u[0] = 0.1 * x[0] * x[0];
                                                              return u;
                                                            });
  const DistributedVector velocity = space.velocity_vector(),
                          pressure = small_problem::interpolated_pressure<dim>(
                              space, [](const Point<dim> &, unsigned int) { return 3.; });
  FieldEvaluation<dim> evaluation(space, problem);
  WallShearStress<dim> wall_shear(space, problem);
  wall_shear.reinit();
  FieldOutput<dim> output(space, problem, evaluation, wall_shear);
  DrawnFields<dim> drawing;
  output.add(State{velocity, pressure, history}, drawing);
  drawing.build_patches(1);
  const auto names = drawing.get_dataset_names();
  const auto row = [&](const std::string &which) {
    return static_cast<unsigned int>(std::find(names.begin(), names.end(), which) - names.begin());
  };
  double along = 0., across = 0., shear = 0.;
  for (const auto &patch : drawing.get_patches())
    for (const unsigned int v : GeometryInfo<dim>::vertex_indices())
    {
      const double stretch = 1. + 0.2 * patch.vertices[v][0],
                   part = 2. * std::pow(stretch, -5. / 3.) * (stretch * stretch - 1.) / 3.;
      along = std::max(along, std::abs(patch.data(row("stress_xx"), v) - (2. * part - 3.)));
      for (const char *which : {"stress_yy", "stress_zz"})
        across = std::max(across, std::abs(patch.data(row(which), v) - (-part - 3.)));
      shear = std::max<double>(shear, std::abs(patch.data(row("stress_xy"), v)));
    }
  const auto largest = [](const double value)
  { return Utilities::MPI::max(value, MPI_COMM_WORLD); };
  check::absolute(name + "stress along the stretch", largest(along), 0., 1e-6);
  check::absolute(name + "stress across it", largest(across), 0., 1e-6);
  check::absolute(name + "no shear", largest(shear), 0., 1e-6);
}
} // namespace

UNIT_TEST(field_output)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::quiet_other_ranks();
  test_drawing<2>("2-D: ");
  test_drawing<3>("3-D: ");
  test_finite_stress<2>("2-D: ");
  test_finite_stress<3>("3-D: ");
}
} // namespace test_of_field_output
