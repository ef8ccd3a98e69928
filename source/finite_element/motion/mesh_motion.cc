#include <continua/finite_element/motion/mesh_motion.h>

#include <continua/base/collective.h>
#include <continua/base/input_error.h>
#include <continua/finite_element/space/velocity_nodes.h>
#include <continua/mesh/coordinates.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <utility>

namespace Continua
{
using namespace dealii;

namespace
{
/// Tolerances of the residual over the right side. Changes belong to directions of a Krylov
/// iteration, and are wanted to its tolerance.
constexpr double tolerance_of_step = 1e-10, tolerance_from_undeformed = 1e-12,
                 largest_change_tolerance = 1e-2;
/// Of a normal: a plane face normal to an axis.
constexpr double largest_tilt = 1e-10;

/// The axis to which all faces of a condition on liquids are normal, or -1; collective.
template <int dim>
int axis_of_plane(const Space<dim> &space,
                  const Problem &problem,
                  const BoundaryCondition &condition)
{
  FEFaceValues<dim> values(space.mapping, space.velocity_element, space.face_quadrature(2),
                           update_normal_vectors);
  double tilts[dim] = {};
  for (const auto &cell : space.velocity_dofs.active_cell_iterators())
    if (cell->is_locally_owned() && cell->at_boundary() &&
        problem.region_model(cell->material_id()) == RegionModel::flow &&
        condition.region_ids.count(cell->material_id()) > 0)
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == condition.boundary_id)
        {
          values.reinit(cell, f);
          for (const unsigned int q : values.quadrature_point_indices())
            for (unsigned int c = 0; c < dim; ++c)
              tilts[c] = std::max(tilts[c], 1. - std::abs(values.normal_vector(q)[c]));
        }
  for (unsigned int c = 0; c < dim; ++c)
    if (Utilities::MPI::max(tilts[c], space.communicator) < largest_tilt)
      return static_cast<int>(c);
  return -1;
}
} // namespace

template <int dim>
MeshMotion<dim>::MeshMotion(const Space<dim> &space, const Problem &problem)
    : space(space),
      problem(problem),
      kind(problem.mesh_motion),
      cells(space, problem, space.quadrature(space.n_quadrature_points()), RegionModel::flow),
      corners(space, problem, QTrapezoid<dim>(), RegionModel::flow),
      displacement_at_points(cells, ValuesAtPoints<dim>::Field::velocity, true),
      displacement_at_corners(corners, ValuesAtPoints<dim>::Field::velocity, true),
      assembly(cells, false)
{
  for (Vector<double> *vector : {&cell_displacement, &cell_rows})
    vector->reinit(dim * cells.n_functions());
}

template <int dim>
void MeshMotion<dim>::set_constraints()
{
  // Marks of the components of d that are given by D, and of those that a boundary holds.
  DistributedVector of_solids = space.velocity_vector(), of_boundaries = of_solids;
  std::vector<types::global_dof_index> indices(space.velocity_element.n_dofs_per_cell()), marked;
  const auto mark = [&](DistributedVector &marks)
  { marks.add(marked, std::vector<double>(marked.size(), 1.)); };
  std::vector<int> axes;
  for (const BoundaryCondition &condition : problem.conditions)
    axes.push_back(axis_of_plane(space, problem, condition));
  for (const auto &cell : space.velocity_dofs.active_cell_iterators())
  {
    if (!cell->is_locally_owned())
      continue;
    cell->get_dof_indices(indices);
    if (problem.region_model(cell->material_id()) != RegionModel::flow)
    {
      marked = indices;
      mark(of_solids);
      continue;
    }
    for (const unsigned int f : cell->face_indices())
      for (unsigned int k = 0; k < problem.conditions.size() && cell->face(f)->at_boundary(); ++k)
      {
        const BoundaryCondition &condition = problem.conditions[k];
        if (cell->face(f)->boundary_id() != condition.boundary_id ||
            condition.region_ids.count(cell->material_id()) == 0)
          continue;
        // They are held at the place to which they have gone.
        if (condition.mesh == MeshCondition::follows)
        {
          marked.clear();
          for (unsigned int i = 0; i < indices.size(); ++i)
            if (space.velocity_element.has_support_on_face(i, f))
              marked.push_back(indices[i]);
          mark(of_boundaries);
          continue;
        }
        const bool is_axis = condition.type == BoundaryType::axis,
                   slides = is_axis || (condition.mesh_slides() && axes[k] >= 0);
        const unsigned int across = is_axis ? 1 : axes[k];
        marked.clear();
        for (unsigned int i = 0; i < indices.size(); ++i)
          if (space.velocity_element.has_support_on_face(i, f) &&
              (!slides || space.velocity_element.system_to_component_index(i).first == across))
            marked.push_back(indices[i]);
        mark(of_boundaries);
      }
  }
  of_solids.compress(VectorOperation::add);
  of_boundaries.compress(VectorOperation::add);
  is_of_solid.resize(of_solids.locally_owned_size());
  for (unsigned int i = 0; i < is_of_solid.size(); ++i)
    is_of_solid[i] = of_solids.begin()[i] > 0.;

  constraints.reinit(space.velocity_relevant);
  DoFTools::make_hanging_node_constraints(space.velocity_dofs, constraints);
  of_boundaries.add(1., of_solids);
  DistributedVector relevant(space.velocity_owned, space.velocity_relevant, space.communicator);
  relevant = of_boundaries;
  for (const auto index : space.velocity_relevant)
    if (relevant(index) > 0. && !constraints.is_constrained(index))
      constraints.add_line(index);
  constraints.close();
}

template <int dim>
void MeshMotion<dim>::find_followers()
{
  followers.clear();
  // The support points of the face are its quadrature points.
  const FiniteElement<dim> &scalar_element = space.scalar_element();
  FEFaceValues<dim> values(space.mapping, scalar_element,
                           Quadrature<dim - 1>(scalar_element.get_unit_face_support_points()),
                           update_quadrature_points);
  std::vector<types::global_dof_index> indices(space.velocity_element.n_dofs_per_face());
  std::map<unsigned int, Follower> found;
  for (const auto &cell : space.velocity_dofs.active_cell_iterators())
  {
    if (cell->is_artificial() || problem.region_model(cell->material_id()) != RegionModel::flow)
      continue;
    for (const unsigned int f : cell->face_indices())
      for (unsigned int k = 0; k < problem.conditions.size() && cell->face(f)->at_boundary(); ++k)
      {
        const BoundaryCondition &condition = problem.conditions[k];
        if (condition.mesh != MeshCondition::follows ||
            cell->face(f)->boundary_id() != condition.boundary_id ||
            condition.region_ids.count(cell->material_id()) == 0)
          continue;
        values.reinit(static_cast<typename Triangulation<dim>::active_cell_iterator>(cell), f);
        cell->face(f)->get_dof_indices(indices, cell->active_fe_index());
        for (unsigned int i = 0; i < indices.size(); ++i)
        {
          if (!space.velocity_owned.is_element(indices[i]) ||
              space.velocity_hanging.is_constrained(indices[i]))
            continue;
          const unsigned int index = space.velocity_owned.index_within_set(indices[i]);
          const auto [component, node] =
              space.velocity_element.face_system_to_component_index(i, f);
          // A node of the axis stays on it.
          if (space.is_axisymmetric() && component == 1 && values.quadrature_point(node)[1] == 0.)
            continue;
          // Where two meet the first of the file holds, as of velocities.
          const auto earlier = found.find(index);
          if (!is_of_solid[index] && (earlier == found.end() || earlier->second.condition > k))
            found[index] = {index, k, component, coordinates(values.quadrature_point(node))};
        }
      }
  }
  for (const auto &[index, follower] : found)
    followers.push_back(follower);
  followed.assign(followers.size(), 0.);
}

template <int dim>
void MeshMotion<dim>::reinit(const MeshSolver &solver)
{
  cells.reinit();
  corners.reinit();
  set_constraints();
  find_followers();
  set_stiffness();
  for (DistributedVector *vector : {&present, &older, &predicted, &known, &right_side, &work})
    *vector = space.velocity_vector();
  ghosted = space.ghosted_velocity(work);
  find_known();
  sums.reinit(ghosted, space.velocity_owned, space.velocity_hanging);
  packed.resize(space.velocity_owned.n_elements());
  owned.clear();
  for (const auto index : space.velocity_owned)
    owned.push_back(index);
  factor = nullptr;
  multigrid = nullptr;
  without_matrix = nullptr;
  if (solver.is_iterative && solver.instruction_set)
    make_products(*solver.instruction_set);
  else if (solver.is_iterative)
    make_multigrid();
  if (is_iterative())
    last_extension = change_rows = space.velocity_vector();
  is_linearised = false;
  if (kind == MeshMotionKind::elastic)
    linearise();
}

template <int dim>
void MeshMotion<dim>::find_known()
{
  for (unsigned int i = 0; i < is_of_solid.size(); ++i)
    known.begin()[i] = is_of_solid[i] ? 1. : 0.;
  for (const Follower &follower : followers)
    known.begin()[follower.index] = 1.;
  // A hanging node has a part of what its masters have.
  space.copy_velocity(known, ghosted);
  has_known.clear();
  for (const Cell &cell : cells.all())
    has_known.push_back(std::any_of(cell.velocity_places.begin(), cell.velocity_places.end(),
                                    [this](const unsigned int place)
                                    { return ghosted.begin()[place] != 0.; }));
}

template <int dim>
void MeshMotion<dim>::make_multigrid()
{
  TrilinosWrappers::SparsityPattern pattern(space.velocity_owned, space.velocity_owned,
                                            space.velocity_relevant, space.communicator);
  DistributedVector marks = space.velocity_vector();
  const std::vector<double> ones(dim * cells.n_functions(), 1.);
  for (const Cell &cell : cells.all())
  {
    constraints.add_entries_local_to_global(cell.velocity_indices, pattern, false);
    marks.add(cell.velocity_indices, ones);
  }
  for (const auto index : space.velocity_owned)
    pattern.add(index, index);
  pattern.compress();
  marks.compress(VectorOperation::add);
  VelocityBlocks blocks;
  blocks.n_components = dim;
  for (const unsigned int i : nodes_in_order(space.velocity_dofs))
    if (marks.begin()[i] > 0.)
      blocks.fluid.push_back(i);
  blocks.modes = rigid_motions(space.mapping, space.velocity_dofs);
  multigrid = std::make_unique<MultigridSolver>(pattern, std::move(blocks));
}

template <int dim>
void MeshMotion<dim>::make_products(const InstructionSet instruction_set)
{
  const unsigned int n_cells = space.triangulation.n_active_cells();
  typename MeshMultigrid<dim>::Input input{instruction_set,
                                           constraints,
                                           kind == MeshMotionKind::hyperelastic,
                                           static_cast<unsigned int>(problem.regions.size()),
                                           std::vector<double>(n_cells, 0.),
                                           std::vector<bool>(n_cells, false)};
  for (std::size_t k = 0; k < cells.all().size(); ++k)
  {
    const unsigned int index = cells.all()[k].velocity_cell->active_cell_index();
    input.stiffness[index] = stiffness[k];
    input.has_given[index] = has_known[k];
  }
  without_matrix = std::make_unique<MeshMultigrid<dim>>(space, input);
}

template <int dim>
void MeshMotion<dim>::solve_iteratively(DistributedVector &solution,
                                        const DistributedVector &rows,
                                        const double tolerance)
{
  if (without_matrix != nullptr)
    without_matrix->solve(solution, rows, tolerance);
  else
    multigrid->solve(solution, rows, tolerance);
}

template <int dim>
void MeshMotion<dim>::set_stiffness()
{
  // The nodes of the faces that move, on all ranks.
  const FiniteElement<dim> &scalar_element = space.scalar_element();
  FEFaceValues<dim> values(space.mapping, scalar_element,
                           Quadrature<dim - 1>(scalar_element.get_unit_face_support_points()),
                           update_quadrature_points);
  const auto moves = [this](const auto &cell, const unsigned int f)
  {
    if (!cell->at_boundary(f))
      return problem.region_model(cell->neighbor(f)->material_id()) != RegionModel::flow;
    return std::any_of(problem.conditions.begin(), problem.conditions.end(),
                       [&](const BoundaryCondition &condition)
                       {
                         return condition.mesh == MeshCondition::follows &&
                                condition.boundary_id == cell->face(f)->boundary_id() &&
                                condition.region_ids.count(cell->material_id()) > 0;
                       });
  };
  std::vector<double> coordinates_of_nodes;
  for (const auto &cell : space.velocity_dofs.active_cell_iterators())
    if (cell->is_locally_owned() && problem.region_model(cell->material_id()) == RegionModel::flow)
      for (const unsigned int f : cell->face_indices())
        if (moves(cell, f))
        {
          values.reinit(static_cast<typename Triangulation<dim>::active_cell_iterator>(cell), f);
          for (const Point<dim> &point : values.get_quadrature_points())
            for (unsigned int c = 0; c < dim; ++c)
              coordinates_of_nodes.push_back(point[c]);
        }
  std::vector<Point<dim>> nodes;
  for (const std::vector<double> &of_rank : all_gather(space.communicator, coordinates_of_nodes))
    for (std::size_t i = 0; i < of_rank.size(); i += dim)
    {
      nodes.emplace_back();
      std::copy(of_rank.begin() + i, of_rank.begin() + i + dim, &nodes.back()[0]);
    }
  const auto tree = pack_rtree(nodes);
  stiffness.clear();
  for (const Cell &cell : cells.all())
  {
    double volume = 0.;
    for (const typename Cell::Point &point : cell.points)
      volume += point.weight;
    const Point<dim> centre = cell.velocity_cell->center();
    double distance = nodes.empty() ? 1. : std::numeric_limits<double>::max();
    for (const Point<dim> &node :
         tree | boost::geometry::index::adaptors::queried(
                    boost::geometry::index::nearest(centre, nodes.empty() ? 0 : 1)))
      distance = centre.distance(node);
    stiffness.push_back(1. / (volume * distance));
  }
}

template <int dim>
void MeshMotion<dim>::integrate(const Cell &cell,
                                const double cell_stiffness,
                                FullMatrix<double> &matrix)
{
  MeshPoint<> point;
  point.is_hyperelastic = kind == MeshMotionKind::hyperelastic;
  for (unsigned int q = 0; q < cells.n_points(); ++q)
  {
    const typename Cell::Point &geometry = cell.points[q];
    point.displacement_gradient = cells.gradient(cell, cell_displacement, q);
    point.inverse = Kinematics(point.displacement_gradient).inverse();
    point.hoop = geometry.hoop;
    const double weight = geometry.weight * cell_stiffness;
    assembly.take_derivative(q, geometry.inverse_jacobian, weight, {},
                             [&point](const PointChange<dim> &change, Tested<dim> &tested)
                             { MeshStress::add_derivative(point, change, tested); });
    Tested<dim> tested;
    MeshStress::add(point, tested);
    assembly.add(q, geometry.inverse_jacobian, -weight, tested);
  }
  assembly.finish_matrix(matrix);
  assembly.finish_rows(cell_rows);
}

template <int dim>
void MeshMotion<dim>::begin_triplets(SymmetricTriplets &triplets) const
{
  triplets.n = static_cast<int>(space.velocity_dofs.n_dofs());
  for (const auto index : space.velocity_owned)
    if (constraints.is_constrained(index))
    {
      triplets.rows.push_back(index);
      triplets.columns.push_back(index);
      triplets.values.push_back(1.);
    }
}

template <int dim>
void MeshMotion<dim>::add_triplets(const Cell &cell,
                                   const FullMatrix<double> &matrix,
                                   SymmetricTriplets &triplets) const
{
  std::vector<std::vector<std::pair<int, double>>> masters(matrix.m());
  for (unsigned int i = 0; i < masters.size(); ++i)
  {
    const types::global_dof_index index = cell.velocity_indices[i];
    masters[i].clear();
    if (!constraints.is_constrained(index))
      masters[i].emplace_back(index, 1.);
    else
      for (const auto &entry : *constraints.get_constraint_entries(index))
        masters[i].emplace_back(entry.first, entry.second);
  }
  for (unsigned int i = 0; i < masters.size(); ++i)
    for (unsigned int j = 0; j < masters.size(); ++j)
      for (const auto &[row, row_weight] : masters[i])
        for (const auto &[column, column_weight] : masters[j])
          if (row >= column)
          {
            triplets.rows.push_back(row);
            triplets.columns.push_back(column);
            triplets.values.push_back(row_weight * column_weight * matrix(i, j));
          }
}

template <int dim>
void MeshMotion<dim>::linearise()
{
  if (is_iterative())
    last_extension = 0.;
  if (without_matrix != nullptr)
  {
    without_matrix->linearise(present, right_side);
    if (kind == MeshMotionKind::elastic)
      right_side = 0.; // it counts from rest
    is_linearised = true;
    return;
  }
  space.copy_velocity(present, ghosted);
  right_side = 0.;
  matrices.resize(cells.all().size());
  SymmetricTriplets triplets;
  if (multigrid != nullptr)
  {
    multigrid->matrix() = 0.;
  }
  else
    begin_triplets(triplets);
  FullMatrix<double> all_entries;
  for (std::size_t k = 0; k < matrices.size(); ++k)
  {
    const Cell &cell = cells.all()[k];
    // Only cells with motion that is known need theirs again.
    FullMatrix<double> &matrix = has_known[k] ? matrices[k] : all_entries;
    set_entries(cell.velocity_places, ghosted, cell_displacement);
    integrate(cell, stiffness[k], matrix);
    if (multigrid != nullptr)
      constraints.distribute_local_to_global(matrix, cell.velocity_indices, multigrid->matrix());
    else
      add_triplets(cell, matrix, triplets);
    if (kind != MeshMotionKind::elastic)
      sums.add(cell.velocity_places, cell_rows);
  }
  sums.add_to(right_side);
  is_linearised = true;
  if (multigrid != nullptr)
  {
    multigrid->take();
    return;
  }
  if (factor == nullptr)
  {
    factor = make_symmetric_factor(DirectSolver::automatic, true, triplets.values.size(),
                                   space.communicator);
    factor->keeps_analysis = kind == MeshMotionKind::hyperelastic;
  }
  factor->factorize(std::move(triplets), owned);
}

template <int dim>
void MeshMotion<dim>::begin_step(const Step &step)
{
  const BranchCoefficients c = step.branch(std::numeric_limits<double>::infinity());
  Assert(c.velocity_old == 0., ExcInternalError());
  predicted.equ(c.old, present);
  if (c.older != 0.)
    predicted.add(c.older, older);
  if (kind == MeshMotionKind::hyperelastic && !is_linearised && !step.finds_unloaded_shape)
    linearise();
  // The first guess is that of the step before; the elastic extension counts from rest.
  if (is_iterative())
    for (unsigned int i = 0; i < owned.size(); ++i)
      last_extension.begin()[i] = constraints.is_constrained(owned[i]) ? 0.
                                  : kind == MeshMotionKind::elastic
                                      ? 2. * present.begin()[i] - older.begin()[i]
                                      : present.begin()[i] - older.begin()[i];
}

template <int dim>
void MeshMotion<dim>::extend(const DistributedVector &solid_displacement,
                             DistributedVector &mesh_displacement)
{
  // The elastic extension is linear from the undeformed mesh on.
  const bool from_undeformed = kind == MeshMotionKind::elastic;
  for (unsigned int i = 0; i < is_of_solid.size(); ++i)
    known.begin()[i] =
        is_of_solid[i] ? solid_displacement.begin()[i] - (from_undeformed ? 0. : present.begin()[i])
                       : 0.;
  for (std::size_t k = 0; k < followers.size(); ++k)
  {
    const unsigned int i = followers[k].index;
    known.begin()[i] = followed[k] - (from_undeformed ? 0. : present.begin()[i]);
  }
  DistributedVector &rows = mesh_displacement;
  rows.equ(1., right_side);
  subtract_known(rows);
  if (is_iterative())
  {
    solve_iteratively(last_extension, rows,
                      from_undeformed ? tolerance_from_undeformed : tolerance_of_step);
    mesh_displacement.equ(1., last_extension);
  }
  else
    solve_by_factor(mesh_displacement);
  mesh_displacement.add(1., known);
  if (!from_undeformed)
    mesh_displacement.add(1., present);
  space.set_hanging_velocities_to_zero(mesh_displacement);
}

template <int dim>
void MeshMotion<dim>::subtract_known(DistributedVector &rows)
{
  if (without_matrix != nullptr)
    without_matrix->subtract_product(known, rows);
  else
    subtract_known_by_matrices(rows);
  for (std::size_t i = 0; i < owned.size(); ++i)
    if (constraints.is_constrained(owned[i]))
      rows.begin()[i] = 0.;
}

template <int dim>
void MeshMotion<dim>::subtract_known_by_matrices(DistributedVector &rows)
{
  space.copy_velocity(known, ghosted);
  for (std::size_t k = 0; k < matrices.size(); ++k)
  {
    const Cell &cell = cells.all()[k];
    if (!has_known[k])
      continue;
    bool is_known = false;
    for (unsigned int i = 0; i < cell_displacement.size(); ++i)
    {
      cell_displacement[i] = ghosted.begin()[cell.velocity_places[i]];
      is_known = is_known || cell_displacement[i] != 0.;
    }
    if (!is_known)
      continue;
    matrices[k].vmult(cell_rows, cell_displacement);
    cell_rows *= -1.;
    sums.add(cell.velocity_places, cell_rows);
  }
  sums.add_to(rows);
}

template <int dim>
void MeshMotion<dim>::solve_by_factor(DistributedVector &rows)
{
  std::copy(rows.begin(), rows.end(), packed.begin());
  factor->solve(packed);
  std::copy(packed.begin(), packed.end(), rows.begin());
}

template <int dim>
void MeshMotion<dim>::set_change(const Step &step,
                                 const DistributedVector &of_velocity,
                                 DistributedVector &of_mesh_displacement)
{
  of_mesh_displacement = 0.;
  if (step.finds_unloaded_shape)
    return;
  const double displacement_by_velocity =
      step.branch(std::numeric_limits<double>::infinity()).velocity;
  for (unsigned int i = 0; i < is_of_solid.size(); ++i)
    known.begin()[i] = is_of_solid[i] ? displacement_by_velocity * of_velocity.begin()[i] : 0.;
  for (const Follower &follower : followers)
    known.begin()[follower.index] =
        problem.conditions[follower.condition].mesh_velocity.empty()
            ? displacement_by_velocity * of_velocity.begin()[follower.index]
            : 0.;
  subtract_known(of_mesh_displacement);
  if (is_iterative())
  {
    change_rows.equ(1., of_mesh_displacement);
    of_mesh_displacement = 0.;
    solve_iteratively(of_mesh_displacement, change_rows,
                      std::min(problem.newton.krylov_tolerance, largest_change_tolerance));
  }
  else
    solve_by_factor(of_mesh_displacement);
  of_mesh_displacement.add(1., known);
  space.set_hanging_velocities_to_zero(of_mesh_displacement);
}

template <int dim>
void MeshMotion<dim>::forget_solver()
{
  if (!is_iterative())
    return;
  if (multigrid != nullptr)
    multigrid->forget();
  // The operator of a mesh that keeps it is made again as at a start.
  is_linearised = false;
  if (kind == MeshMotionKind::elastic)
    linearise();
}

template <int dim>
void MeshMotion<dim>::move(StepSolution &state)
{
  if (state.step.finds_unloaded_shape)
  {
    // The mesh has the shape under the loads, where the liquid is; what moves is the unloaded one.
    state.mesh_displacement = 0.;
    state.mesh_velocity = 0.;
    return;
  }
  const double displacement_by_velocity =
      state.step.branch(std::numeric_limits<double>::infinity()).velocity;
  for (std::size_t k = 0; k < followers.size(); ++k)
  {
    const Follower &follower = followers[k];
    const std::vector<Waveform> &given = problem.conditions[follower.condition].mesh_velocity;
    const double velocity =
        given.empty() ? state.velocity.begin()[follower.index]
                      : given[follower.component](follower.place.data(), state.step.balance_time);
    followed[k] = predicted.begin()[follower.index] + displacement_by_velocity * velocity;
  }
  extend(state.displacement, state.mesh_displacement);
  const double factor_of_velocity = 1. / displacement_by_velocity;
  state.mesh_velocity.equ(factor_of_velocity, state.mesh_displacement);
  state.mesh_velocity.add(-factor_of_velocity, predicted);
}

template <int dim>
void MeshMotion<dim>::finish_step(const StepSolution &step_solution)
{
  older.swap(present);
  present.equ(1., step_solution.mesh_displacement);
  if (step_solution.step.extrapolate)
  {
    present *= 2.;
    present.add(-1., older);
  }
  is_linearised = is_linearised && kind == MeshMotionKind::elastic;
  // Of the last iterate, which was accepted, and of what lies beyond it.
  const auto take = [&](const MeshQuality &of_step, const double time)
  {
    if (!(of_step.least_volume_ratio < worst_of_steps.least_volume_ratio))
      return;
    worst_of_steps = of_step;
    worst_of_steps.time = time;
  };
  take(last, step_solution.step.balance_time);
  if (step_solution.step.extrapolate)
    take(quality(present), step_solution.step.time);
}

template <int dim>
void MeshMotion<dim>::start_from(const DistributedVector &displacement)
{
  if (!is_linearised)
    linearise();
  for (std::size_t k = 0; k < followers.size(); ++k)
    followed[k] = present.begin()[followers[k].index];
  extend(displacement, work);
  present.equ(1., work);
  older.equ(1., present);
  take_state();
}

template <int dim>
void MeshMotion<dim>::visit(StateVisitor &visitor)
{
  visitor.levels("mesh displacement", StateKind::velocity, present, older);
  visitor.value("least volume ratio of the mesh", worst_of_steps.least_volume_ratio);
  visitor.value("time of the least volume ratio of the mesh", worst_of_steps.time);
}

template <int dim>
void MeshMotion<dim>::take_state()
{
  is_linearised = is_linearised && kind == MeshMotionKind::elastic;
}

template <int dim>
MeshQuality MeshMotion<dim>::quality(const DistributedVector &mesh_displacement)
{
  space.copy_velocity(mesh_displacement, ghosted);
  double least = std::numeric_limits<double>::max();
  // Of cells that are equally bad the first one is named: round-off must not choose.
  constexpr double round_off = 1e-9;
  double least_of_named = least;
  const Cell *worst = nullptr;
  for (std::size_t k = 0; k < cells.all().size(); ++k)
  {
    const Cell &cell = cells.all()[k];
    for (unsigned int i = 0; i < cell_displacement.size(); ++i)
      cell_displacement[i] = ghosted.begin()[cell.velocity_places[i]];
    const auto take = [&](const Cell &of_points, ValuesAtPoints<dim> &displacement)
    {
      displacement.set(cell_displacement);
      for (unsigned int q = 0; q < of_points.points.size(); ++q)
      {
        const double ratio = determinant(Tensor<2, 3>(unit_symmetric_tensor<3>()) +
                                         displacement.space_gradient(q, of_points.points[q]));
        // What is no number fails the comparison, and is kept.
        if (std::isnan(least) || ratio >= least)
          continue;
        least = ratio;
        if (ratio >= least_of_named - round_off * std::abs(least_of_named))
          continue;
        least_of_named = ratio;
        worst = &cell;
      }
    };
    take(cell, displacement_at_points);
    take(corners.all()[k], displacement_at_corners);
  }
  const auto over_ranks = Utilities::MPI::min_max_avg(
      std::isnan(least) ? -std::numeric_limits<double>::max() : least, space.communicator);
  MeshQuality quality;
  quality.least_volume_ratio = over_ranks.min;
  std::ostringstream text;
  text.precision(4);
  if (worst != nullptr)
  {
    text << "in the region '" << problem.regions[worst->region] << "' near (";
    for (unsigned int c = 0; c < dim; ++c)
      text << (c == 0 ? "" : ", ") << worst->velocity_cell->center()[c];
    text << ") m";
  }
  quality.place = Utilities::MPI::broadcast(space.communicator, text.str(), over_ranks.min_index);
  last = quality;
  return quality;
}

template class MeshMotion<2>;
template class MeshMotion<3>;
} // namespace Continua
