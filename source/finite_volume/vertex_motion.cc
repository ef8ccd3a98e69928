#include <continua/finite_volume/vertex_motion.h>

#include <continua/base/input_error.h>
#include <continua/mesh/coordinates.h>

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_renumbering.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>

namespace Continua
{
using namespace dealii;

namespace
{
/// Of a normal: a plane face normal to an axis.
constexpr double largest_tilt = 1e-10;
/// Of a mesh that moves; the program warns below.
constexpr double least_good_volume_ratio = 0.2;

/// The volume of the parallelepiped of the edges that meet at a corner of a cell.
template <int dim>
double volume_at_corner(const std::vector<Point<dim>> &corners, const unsigned int corner)
{
  Tensor<2, dim> edges;
  for (unsigned int c = 0; c < dim; ++c)
    edges[c] =
        (corners[corner ^ (1u << c)] - corners[corner]) * ((corner >> c) % 2 == 0 ? 1. : -1.);
  return determinant(edges);
}
} // namespace

template <int dim>
VertexMotion<dim>::VertexMotion(const CellWiseSpace<dim> &space,
                                const Problem &problem,
                                const LinearReconstruction<dim> &reconstruction)
    : space(space),
      problem(problem),
      reconstruction(reconstruction),
      element(FE_Q<dim>(1), dim),
      vertex_dofs(space.mesh.triangulation)
{
}

template <int dim>
void VertexMotion<dim>::reinit()
{
  vertex_dofs.distribute_dofs(element);
  DoFRenumbering::hierarchical(vertex_dofs);
  owned = vertex_dofs.locally_owned_dofs();
  DoFTools::extract_locally_relevant_dofs(vertex_dofs, relevant);
  hanging.reinit(relevant);
  DoFTools::make_hanging_node_constraints(vertex_dofs, hanging);
  hanging.close();
  for (DistributedVector *const level : {&next, &present, &older})
    *level = vector();
  solid_motion = space.velocity_vector();
  find_parts_of_solids();
  mark_entries();
}

template <int dim>
VectorNumbering VertexMotion<dim>::numbering() const
{
  return {space.communicator, "mesh vertices", numbers_of_dofs(vertex_dofs)};
}

template <int dim>
void VertexMotion<dim>::find_parts_of_solids()
{
  parts_of_solids.clear();
  for (DistributedVector &count : counts)
    count = vector();
  const CellWiseMesh<dim> &mesh = space.mesh;
  const auto is_held_face = [&](const VolumeFace<dim> &face, const unsigned int material)
  {
    return face.at_boundary() &&
           std::any_of(problem.conditions.begin(), problem.conditions.end(),
                       [&](const BoundaryCondition &condition)
                       {
                         return condition.boundary_id == face.boundary_id &&
                                condition.region_ids.count(material) > 0 &&
                                condition.normal.kind == BoundaryPart::Kind::velocity &&
                                condition.tangential.kind == BoundaryPart::Kind::velocity;
                       });
  };
  for (unsigned int number = 0; number < mesh.n_owned_cells(); ++number)
  {
    const FiniteVolume<dim> &volume = mesh.cells()[number];
    if (!is_solid(volume.material_id))
      continue;
    const auto iterator = typename DoFHandler<dim>::active_cell_iterator(
        &mesh.triangulation, volume.iterator->level(), volume.iterator->index(), &vertex_dofs);
    for (const unsigned int v : iterator->vertex_indices())
    {
      Part part;
      for (unsigned int c = 0; c < dim; ++c)
        part.entries[c] = iterator->vertex_dof_index(v, c);
      const auto add = [&](const Rank rank, const Stencil<double> &displacement)
      {
        part.rank = rank;
        part.displacement = displacement;
        parts_of_solids.push_back(part);
        for (const auto entry : part.entries)
          counts[rank](entry) += 1.;
      };
      const Point<dim> &place = iterator->vertex(v);
      add(cell, reconstruction.velocity({number, CellPlace::none}, place));
      for (const unsigned int f : volume.faces)
      {
        const VolumeFace<dim> &face = mesh.faces()[f];
        if (!face.has_value() ||
            std::count(face.vertices.begin(), face.vertices.end(), iterator->vertex_index(v)) == 0)
          continue;
        if (is_held_face(face, volume.material_id))
          add(held_face, {space.velocities.of_face(f, mesh.side(f, number)), 1.});
        else
          add(own_face, reconstruction.velocity({number, f}, place));
      }
    }
  }
  for (DistributedVector &count : counts)
    count.compress(VectorOperation::add);
}

template <int dim>
void VertexMotion<dim>::mark_entries()
{
  // The axis to which all faces of a condition in a region are normal, or dim.
  const CellWiseMesh<dim> &mesh = space.mesh;
  const auto same_condition =
      [&](const BoundaryCondition &condition, const VolumeFace<dim> &face, const bool of_solid)
  {
    const unsigned int material = mesh.cells()[face.owner].material_id;
    return face.at_boundary() && face.boundary_id == condition.boundary_id &&
           condition.region_ids.count(material) > 0 && is_solid(material) == of_solid;
  };
  DistributedVector of_solids = vector(), held = vector(), of_boundaries = vector();
  for (const bool of_solid : {true, false})
    for (const BoundaryCondition &condition : problem.conditions)
    {
      std::vector<double> tilts(dim, 0.);
      for (const VolumeFace<dim> &face : mesh.faces())
        if (same_condition(condition, face, of_solid))
          for (unsigned int c = 0; c < dim; ++c)
            tilts[c] = std::max(tilts[c], 1. - std::abs(face.normal[c]));
      Utilities::MPI::max(tilts, space.communicator, tilts);
      unsigned int across = 0;
      while (across < dim && tilts[across] >= largest_tilt)
        ++across;
      const bool is_axis = condition.type == BoundaryType::axis;
      if (is_axis)
        across = 1;
      const bool follows = condition.mesh == MeshCondition::follows && !of_solid;
      const bool slides =
          !follows && (of_solid || is_axis || condition.mesh_slides()) && across < dim;
      // A solid is held along a plane by its own condition, else it has its displacement.
      if (of_solid && !(slides && (is_axis || condition.normal.is_fixed())))
        continue;
      for (const VolumeFace<dim> &face : mesh.faces())
      {
        if (!same_condition(condition, face, of_solid) || !mesh.cells()[face.owner].is_owned)
          continue;
        const auto &iterator = mesh.cells()[face.owner].iterator;
        const auto on_vertices = typename DoFHandler<dim>::active_cell_iterator(
            &mesh.triangulation, iterator->level(), iterator->index(), &vertex_dofs);
        for (const unsigned int v : iterator->vertex_indices())
          if (std::count(face.vertices.begin(), face.vertices.end(), iterator->vertex_index(v)) > 0)
            for (unsigned int c = 0; c < dim; ++c)
              if (!slides || c == across)
                (of_solid ? held : of_boundaries)(on_vertices->vertex_dof_index(v, c)) += 1.;
      }
    }
  held.compress(VectorOperation::add);
  of_boundaries.compress(VectorOperation::add);
  is_of_solid.assign(owned.n_elements(), false);
  is_held.assign(owned.n_elements(), false);
  for (unsigned int i = 0; i < is_held.size(); ++i)
  {
    is_of_solid[i] = counts[cell].begin()[i] > 0.;
    is_held[i] = held.begin()[i] > 0.;
    of_solids.begin()[i] = is_of_solid[i] || of_boundaries.begin()[i] > 0. ? 1. : 0.;
  }
  find_followers();
  std::vector<bool> is_liquid;
  for (const Material &material : problem.materials)
    is_liquid.push_back(!material.is_solid());
  extension.reinit(vertex_dofs, hanging, space.is_axisymmetric(), is_liquid, of_solids);
}

template <int dim>
void VertexMotion<dim>::find_followers()
{
  followers.clear();
  std::map<unsigned int, Follower> found;
  const auto &triangulation = space.mesh.triangulation;
  for (const auto &iterator : vertex_dofs.active_cell_iterators())
  {
    if (iterator->is_artificial() || is_solid(iterator->material_id()))
      continue;
    for (const unsigned int f : iterator->face_indices())
      for (unsigned int k = 0; k < problem.conditions.size() && iterator->at_boundary(f); ++k)
      {
        const BoundaryCondition &condition = problem.conditions[k];
        if (condition.mesh != MeshCondition::follows ||
            iterator->face(f)->boundary_id() != condition.boundary_id ||
            condition.region_ids.count(iterator->material_id()) == 0)
          continue;
        for (const unsigned int v : iterator->face(f)->vertex_indices())
          for (unsigned int c = 0; c < dim; ++c)
          {
            const auto entry = iterator->face(f)->vertex_dof_index(v, c);
            if (!owned.is_element(entry) || hanging.is_constrained(entry))
              continue;
            const Point<dim> &place =
                triangulation.get_vertices()[iterator->face(f)->vertex_index(v)];
            // A vertex of the axis stays on it.
            if (space.is_axisymmetric() && c == 1 && place[1] == 0.)
              continue;
            const auto index = static_cast<unsigned int>(owned.index_within_set(entry));
            // Where two meet the first of the file holds, as of velocities.
            const auto earlier = found.find(index);
            if (!is_of_solid[index] && (earlier == found.end() || earlier->second.condition > k))
              found[index] = {index, k, c, coordinates(place)};
          }
      }
  }
  for (const auto &[index, follower] : found)
    followers.push_back(follower);
}

template <int dim>
void VertexMotion<dim>::extend(const std::vector<double> &followed)
{
  const DistributedVector motion = reconstruction.ghosted_velocity(solid_motion);
  std::array<DistributedVector, n_ranks> sums{{vector(), vector(), vector()}};
  for (const Part &part : parts_of_solids)
  {
    const Tensor<1, dim> value = LinearReconstruction<dim>::vector_value(part.displacement, motion);
    for (unsigned int c = 0; c < dim; ++c)
      sums[part.rank](part.entries[c]) += value[c];
  }
  for (DistributedVector &sum : sums)
    sum.compress(VectorOperation::add);
  next = 0.;
  for (unsigned int i = 0; i < is_of_solid.size(); ++i)
    for (unsigned int rank = 0; rank < n_ranks && is_of_solid[i] && !is_held[i]; ++rank)
      if (const double count = counts[rank].begin()[i]; count > 0.)
      {
        next.begin()[i] = sums[rank].begin()[i] / count;
        break;
      }
  for (std::size_t k = 0; k < followers.size(); ++k)
    next.begin()[followers[k].index] = followed[k];
  extension.extend(next);
}

template <int dim>
void VertexMotion<dim>::begin_step(const Step &step, const State &start)
{
  solid_motion.equ(1., start.history.displacement());
  if (!step.finds_steady_state)
    solid_motion.add(step.size(), start.velocity);
  const BranchCoefficients formula = step.branch(std::numeric_limits<double>::infinity());
  std::vector<double> followed;
  for (const Follower &follower : followers)
  {
    const BoundaryCondition &condition = problem.conditions[follower.condition];
    const unsigned int c = follower.component;
    double velocity = 0.;
    if (!condition.mesh_velocity.empty())
      velocity = condition.mesh_velocity[c](follower.place.data(), step.balance_time);
    else if (!condition.normal.vector.empty())
      velocity = condition.normal.vector[c](follower.place.data(), step.balance_time);
    followed.push_back(formula.old * present.begin()[follower.index] +
                       (formula.older != 0. ? formula.older * older.begin()[follower.index] : 0.) +
                       formula.velocity * velocity);
  }
  extend(followed);
}

template <int dim>
void VertexMotion<dim>::check()
{
  measure_quality();
  if (last.least_volume_ratio > 0.)
    return;
  std::ostringstream text;
  text << "the mesh is turned inside out " << last.place
       << ": the ratio of its volume to the undeformed one is " << last.least_volume_ratio
       << " there; a smaller time step, loads that begin smoothly, Mesh = slides on a plane "
          "boundary along which it moves, or a coarser mesh beside what moves help";
  throw StepFailure(text.str());
}

template <int dim>
std::string VertexMotion<dim>::finish_step(const double time)
{
  older.equ(1., present);
  present.equ(1., next);
  last.time = time;
  if (last.least_volume_ratio < worst_of_steps.least_volume_ratio)
    worst_of_steps = last;
  if (last.least_volume_ratio >= least_good_volume_ratio || warning_was_given)
    return "";
  warning_was_given = true;
  std::ostringstream text;
  text << "at t = " << time << " s the mesh is compressed " << last.place << " to "
       << last.least_volume_ratio << " of its undeformed volume; below " << least_good_volume_ratio
       << " results there lose digits, and at 0 the run ends";
  return text.str();
}

template <int dim>
void VertexMotion<dim>::start_from(const State &state)
{
  solid_motion.equ(1., state.history.displacement());
  std::vector<double> followed;
  for (const Follower &follower : followers)
    followed.push_back(present.begin()[follower.index]);
  extend(followed);
  present.equ(1., next);
  older.equ(1., next);
  // Steps before the start do not count.
  check();
  last.time = 0.;
  worst_of_steps = last;
}

template <int dim>
void VertexMotion<dim>::visit(StateVisitor &visitor)
{
  visitor.levels("mesh displacement", StateKind::mesh_vertex, present, older);
  visitor.value("least volume ratio of the mesh", worst_of_steps.least_volume_ratio);
  visitor.value("time of the least volume ratio of the mesh", worst_of_steps.time);
}

template <int dim>
void VertexMotion<dim>::take_state()
{
  next.equ(1., present);
}

template <int dim>
DistributedVector VertexMotion<dim>::ghosted(const DistributedVector &displacement) const
{
  DistributedVector result(owned, relevant, space.communicator);
  result = displacement;
  return result;
}

template <int dim>
VertexPlaces<dim> VertexMotion<dim>::places_at(const DistributedVector &displacement) const
{
  const DistributedVector with_ghosts = ghosted(displacement);
  const VertexPlaces<dim> &undeformed = space.mesh.triangulation.get_vertices();
  VertexPlaces<dim> places = undeformed;
  for (const auto &iterator : vertex_dofs.active_cell_iterators())
    if (!iterator->is_artificial())
      for (const unsigned int v : iterator->vertex_indices())
      {
        Point<dim> &place = places[iterator->vertex_index(v)];
        for (unsigned int c = 0; c < dim; ++c)
          place[c] = undeformed[iterator->vertex_index(v)][c] +
                     with_ghosts(iterator->vertex_dof_index(v, c));
      }
  return places;
}

template <int dim>
void VertexMotion<dim>::measure_quality()
{
  const VertexPlaces<dim> moved = places();
  double least = std::numeric_limits<double>::max();
  const FiniteVolume<dim> *worst = nullptr;
  for (unsigned int number = 0; number < space.mesh.n_owned_cells(); ++number)
  {
    const FiniteVolume<dim> &volume = space.mesh.cells()[number];
    if (is_solid(volume.material_id))
      continue;
    std::vector<Point<dim>> undeformed, present_ones;
    for (const unsigned int v : volume.iterator->vertex_indices())
    {
      undeformed.push_back(volume.iterator->vertex(v));
      present_ones.push_back(moved[volume.iterator->vertex_index(v)]);
    }
    for (unsigned int v = 0; v < undeformed.size(); ++v)
    {
      double ratio = volume_at_corner<dim>(present_ones, v) / volume_at_corner<dim>(undeformed, v);
      if (space.is_axisymmetric() && undeformed[v][1] > 0.)
        ratio *= present_ones[v][1] / undeformed[v][1];
      // What is no number fails the comparison, and is kept.
      if (!std::isnan(least) && !(ratio >= least))
      {
        least = ratio;
        worst = &volume;
      }
    }
  }
  const auto over_ranks = Utilities::MPI::min_max_avg(
      std::isnan(least) ? -std::numeric_limits<double>::max() : least, space.communicator);
  std::ostringstream text;
  text.precision(4);
  if (worst != nullptr)
  {
    text << "in the region '" << problem.regions[worst->material_id] << "' near (";
    for (unsigned int c = 0; c < dim; ++c)
      text << (c == 0 ? "" : ", ") << worst->iterator->center()[c];
    text << ") m";
  }
  last.least_volume_ratio = over_ranks.min;
  last.place = Utilities::MPI::broadcast(space.communicator, text.str(), over_ranks.min_index);
}

template class VertexMotion<2>;
template class VertexMotion<3>;
} // namespace Continua
