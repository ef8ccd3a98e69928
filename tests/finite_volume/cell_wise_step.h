#ifndef continua_tests_finite_volume_cell_wise_step_h
#define continua_tests_finite_volume_cell_wise_step_h

// The equations of one step on a small mesh, for the unit tests of what is made of them.

#include <continua/finite_volume/cell_wise_system.h>

#include "cell_wise_body.h"

#include <random>

namespace cell_wise_meshes
{
/// The unit square or cube in n cells each way, all of region 0, the solid of make_problem().
template <int dim>
void make_uniform_box(Triangulation<dim> &mesh, const unsigned int n)
{
  make_box(mesh, n);
  for (const auto &cell : mesh.active_cell_iterators())
    cell->set_material_id(0);
}

/// Two squares of width 1/2, the left one solid, the right one fluid.
inline void make_two_squares(Triangulation<2> &mesh)
{
  dealii::GridGenerator::subdivided_hyper_rectangle(
      mesh, std::vector<unsigned int>{2, 1}, dealii::Point<2>(), dealii::Point<2>(1., 0.5), true);
  for (const auto &cell : mesh.active_cell_iterators())
    cell->set_material_id(cell->center()[0] < 0.5 ? 0 : 1);
}

inline void set_free(BoundaryCondition &condition)
{
  condition.normal.kind = condition.tangential.kind = BoundaryPart::Kind::traction;
}
/// Held along the normal only.
inline void set_roller(BoundaryCondition &condition)
{
  condition.normal.kind = BoundaryPart::Kind::velocity;
  condition.tangential.kind = BoundaryPart::Kind::traction;
}

/// Moduli of 3 Pa (solid) and 2 Pa s (fluid), mass 10 and 20 kg/(m^3 s), 1/(K b) 0.5 and 0.25 1/(Pa
/// s).
inline CellWiseCoefficients make_coefficients()
{
  CellWiseCoefficients coefficients;
  coefficients.mass = {10., 20.};
  coefficients.stiffness = {3., 2.};
  coefficients.compressibility = {0.5, 0.25};
  coefficients.increment_mobility = {0., 0.};
  return coefficients;
}

template <int dim>
class CellWiseStep
{
public:
  /// `change`: of make_problem(), where every boundary is held.
  CellWiseStep(
      const std::function<void(Triangulation<dim> &)> &make_mesh,
      const Model model,
      const CellWiseCoefficients &coefficients = make_coefficients(),
      const std::function<void(Problem &)> &change = [](Problem &) {},
      const CellWiseParameters &parameters = {})
      : triangulation(MPI_COMM_WORLD),
        problem(make_problem<dim>(model)),
        parameters(parameters),
        space(triangulation, model),
        conditions(space, problem.conditions),
        system(space, problem, conditions, operators, closure, this->parameters)
  {
    make_mesh(triangulation);
    change(problem);
    space.distribute();
    conditions.build();
    assemble_cell_operators(space, problem, conditions, parameters,
                            std::vector<bool>(problem.materials.size(), true), operators, closure);
    system.reinit();
    system.prepare(coefficients);
  }

  unsigned int cell_row(const unsigned int cell) const
  {
    return space.local_velocity(space.velocities.of_cell(cell));
  }
  unsigned int cell_pressure_row(const unsigned int cell) const
  {
    return space.local_pressure(space.pressures.of_cell(cell));
  }

  Triangulation<dim> triangulation;
  Problem problem;
  const CellWiseParameters parameters;
  CellWiseSpace<dim> space;
  FaceConditions<dim> conditions;
  std::vector<CellWiseOperators> operators;
  PressureClosure closure;
  CellWiseSystem<dim> system;
};

/// Numbers between -1 and 1 in the owned entries.
inline void fill_at_random(DistributedVector &vector, const unsigned int seed)
{
  std::mt19937 generator(seed + 100 * dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD));
  std::uniform_real_distribution<double> distribution(-1., 1.);
  for (double &value : vector)
    value = distribution(generator);
}

/// All unknowns of all ranks, numbered as by CellWiseSystem::for_entries().
template <int dim>
std::vector<double> all_unknowns(const CellWiseSpace<dim> &space,
                                 const DistributedVector &velocity,
                                 const DistributedVector &pressure)
{
  const unsigned int n_velocities = dim * space.velocities.n_values();
  std::vector<double> result(n_velocities + space.pressures.n_values(), 0.);
  std::copy(velocity.begin(), velocity.end(),
            result.begin() + dim * space.velocities.first_owned());
  std::copy(pressure.begin(), pressure.end(),
            result.begin() + n_velocities + space.pressures.first_owned());
  dealii::Utilities::MPI::sum(result, MPI_COMM_WORLD, result);
  return result;
}

/// Whether a point of the unit box is so far from its boundary.
template <int dim>
bool is_deep_inside(const dealii::Point<dim> &centre, const double distance)
{
  for (unsigned int c = 0; c < dim; ++c)
    if (centre[c] < distance || centre[c] > 1. - distance)
      return false;
  return true;
}
} // namespace cell_wise_meshes

#endif
