#ifndef continua_tests_finite_volume_cell_wise_body_h
#define continua_tests_finite_volume_cell_wise_body_h

// A body of a solid and a fluid with given fields, for the unit tests of what is read off them.

#include <continua/continuum/problem.h>
#include <continua/finite_volume/cell_wise_evaluation.h>
#include <continua/finite_volume/face_conditions.h>

#include "cell_wise_meshes.h"

#include <functional>
#include <limits>

namespace cell_wise_meshes
{
/// Region 0 has a spring of 3 Pa, region 1 a viscosity of 2 Pa s; every boundary is held.
template <int dim>
Problem make_problem(const Model model)
{
  Problem problem;
  problem.model = model;
  problem.regions = {"solid", "fluid"};
  Material solid, fluid;
  solid.shear.branches = {Branch{3., std::numeric_limits<double>::infinity()}};
  solid.compression = fluid.compression = Compression::elastic(1.);
  fluid.shear.viscosity = 2.;
  problem.materials = {solid, fluid};
  for (unsigned int b = 0; b < 2 * dim; ++b)
  {
    BoundaryCondition fixed;
    fixed.name = "boundary " + std::to_string(b);
    fixed.boundary_id = b;
    fixed.region_ids = {0, 1};
    fixed.normal.kind = fixed.tangential.kind = BoundaryPart::Kind::velocity;
    problem.boundaries.push_back(fixed.name);
    problem.conditions.push_back(fixed);
  }
  return problem;
}

template <int dim>
using VectorFunction = std::function<dealii::Tensor<1, dim>(const dealii::Point<dim> &)>;
/// Of the place and the region.
template <int dim>
using PressureFunction = std::function<double(const dealii::Point<dim> &, unsigned int)>;

/// The values of a function at the centres of cells and faces.
template <int dim>
DistributedVector velocity_field(const CellWiseSpace<dim> &space,
                                 const VectorFunction<dim> &function)
{
  DistributedVector result = space.velocity_vector();
  const auto set = [&](const unsigned int value, const dealii::Point<dim> &point)
  {
    for (unsigned int c = 0; c < dim; ++c)
      result.begin()[space.local_velocity(value) + c] = function(point)[c];
  };
  for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
    set(space.velocities.of_cell(cell), space.mesh.cells()[cell].centre);
  for (unsigned int face = 0; face < space.mesh.faces().size(); ++face)
    if (space.mesh.faces()[face].has_value() && space.velocities.owns_face(face, 0))
      set(space.velocities.of_face(face, 0), space.mesh.faces()[face].centre);
  return result;
}

template <int dim>
DistributedVector pressure_field(const CellWiseSpace<dim> &space,
                                 const PressureFunction<dim> &function)
{
  DistributedVector result = space.pressure_vector();
  const auto set =
      [&](const unsigned int value, const dealii::Point<dim> &point, const unsigned int cell)
  {
    result.begin()[space.local_pressure(value)] =
        function(point, space.mesh.cells()[cell].material_id);
  };
  for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
    set(space.pressures.of_cell(cell), space.mesh.cells()[cell].centre, cell);
  for (unsigned int face = 0; face < space.mesh.faces().size(); ++face)
  {
    const VolumeFace<dim> &surface = space.mesh.faces()[face];
    for (unsigned int side = 0; surface.has_value() && side < surface.n_sides(); ++side)
      if (space.pressures.owns_face(face, side))
        set(space.pressures.of_face(face, side), surface.centre, surface.cell(side));
  }
  return result;
}

/// Local indices of the values of each region, faces included.
template <int dim>
std::vector<std::vector<unsigned int>> nodes_of_regions(const CellWiseSpace<dim> &space)
{
  std::vector<std::vector<bool>> has(2, std::vector<bool>(space.velocities.n_owned(), false));
  for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
    has[space.mesh.cells()[cell].material_id]
       [space.velocities.of_cell(cell) - space.velocities.first_owned()] = true;
  for (unsigned int face = 0; face < space.mesh.faces().size(); ++face)
  {
    const VolumeFace<dim> &surface = space.mesh.faces()[face];
    for (unsigned int side = 0; surface.has_value() && side < surface.n_sides(); ++side)
      if (space.velocities.owns_face(face, side))
        has[space.mesh.cells()[surface.cell(side)].material_id]
           [space.velocities.of_face(face, side) - space.velocities.first_owned()] = true;
  }
  std::vector<std::vector<unsigned int>> nodes(2);
  for (unsigned int region = 0; region < 2; ++region)
    for (unsigned int value = 0; value < has[region].size(); ++value)
      for (unsigned int c = 0; c < dim && has[region][value]; ++c)
        nodes[region].push_back(dim * value + c);
  return nodes;
}

template <int dim>
class Body
{
public:
  Body(const std::function<void(Triangulation<dim> &)> &make_mesh, const Model model)
      : triangulation(MPI_COMM_WORLD),
        problem(make_problem<dim>(model)),
        space(triangulation, model),
        history(problem.materials),
        evaluation(space, problem)
  {
    make_mesh(triangulation);
    space.distribute();
    history.reinit(space.velocity_vector(), nodes_of_regions(space));
    evaluation.build();
    velocity = space.velocity_vector();
    pressure = space.pressure_vector();
  }
  State state() const { return {velocity, pressure, history}; }
  double value(const ProbeRequest<dim> &request)
  {
    const unsigned int number = evaluation.add(request);
    std::vector<double> values;
    evaluation.evaluate(state(), nullptr, values);
    return values.at(number);
  }

  Triangulation<dim> triangulation;
  Problem problem;
  CellWiseSpace<dim> space;
  BranchHistory history;
  CellWiseEvaluation<dim> evaluation;
  DistributedVector velocity, pressure;
};
} // namespace cell_wise_meshes

#endif
