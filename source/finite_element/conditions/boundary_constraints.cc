#include <continua/base/collective.h>
#include <continua/finite_element/conditions/boundary_constraints.h>
#include <continua/finite_element/conditions/flow_shapes.h>
#include <continua/mesh/cells_in_tree_order.h>
#include <continua/signal/jump.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace Continua
{
using namespace dealii;

namespace
{
/// One condition at one node, with the mean normal of its faces there.
template <int dim>
struct NodeFace
{
  unsigned int condition;
  Tensor<1, dim> normal;
};

/// A boundary node: its dofs by component, where it is, and the faces that meet there.
template <int dim>
struct Node
{
  std::array<types::global_dof_index, dim> dofs;
  Point<dim> point;
  std::vector<NodeFace<dim>> faces;
};

/// Faces of one condition whose normals differ by less than about 25 degrees are one smooth
/// boundary at a node.
constexpr double same_face_cosine = 0.9;
/// Components of a direction of length 1 that are below this are zero.
constexpr double round_off_of_direction = 1e-12;
/// An equation of which less than this is left after elimination depends on the earlier ones.
constexpr double dependent_remainder = 0.1;

/// Directions that complete the normal to an orthonormal basis.
template <int dim>
std::vector<Tensor<1, dim>> tangents(const Tensor<1, dim> &normal)
{
  std::vector<Tensor<1, dim>> result;
  // Start from the axis that is least along the normal, so that tangents of axis-parallel faces are
  // axes.
  if constexpr (dim == 2)
  {
    Tensor<1, dim> tangent;
    tangent[0] = -normal[1];
    tangent[1] = normal[0];
    result.push_back(tangent);
  }
  else
  {
    unsigned int least = 0;
    for (unsigned int c = 1; c < dim; ++c)
      if (std::abs(normal[c]) < std::abs(normal[least]))
        least = c;
    Tensor<1, dim> first;
    first[least] = 1.;
    first -= (first * normal) * normal;
    first /= first.norm();
    result.push_back(first);
    result.push_back(cross_product_3d(normal, first));
  }
  return result;
}

template <int dim>
std::map<types::global_dof_index, Node<dim>>
collect_nodes(const Space<dim> &space, const std::vector<BoundaryCondition> &conditions)
{
  std::map<std::pair<unsigned int, unsigned int>, unsigned int> condition_of;
  for (unsigned int c = 0; c < conditions.size(); ++c)
    for (const unsigned int region : conditions[c].region_ids)
      condition_of[{conditions[c].boundary_id, region}] = c;

  // The support points of the face are its quadrature points, so that the normals are the ones at
  // the nodes.
  const FiniteElement<dim> &scalar_element = space.scalar_element();
  const Quadrature<dim - 1> nodes_of_face(scalar_element.get_unit_face_support_points());
  FEFaceValues<dim> values(space.mapping, scalar_element, nodes_of_face,
                           update_quadrature_points | update_normal_vectors);
  std::vector<types::global_dof_index> face_dofs(space.velocity_element.n_dofs_per_face());

  std::map<types::global_dof_index, Node<dim>> nodes;
  for (const auto &cell : cells_in_tree_order(space.velocity_dofs))
    if (!cell->is_artificial() && cell->at_boundary())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary())
        {
          const auto found = condition_of.find({cell->face(f)->boundary_id(), cell->material_id()});
          AssertThrow(found != condition_of.end(), ExcInternalError());
          const BoundaryCondition &condition = conditions[found->second];
          if (condition.normal.kind != BoundaryPart::Kind::velocity &&
              condition.tangential.kind != BoundaryPart::Kind::velocity)
            continue;
          values.reinit(static_cast<typename Triangulation<dim>::active_cell_iterator>(cell), f);
          cell->face(f)->get_dof_indices(face_dofs, cell->active_fe_index());
          // place on the face -> dofs of all components
          std::vector<std::array<types::global_dof_index, dim>> dofs(nodes_of_face.size());
          for (unsigned int i = 0; i < face_dofs.size(); ++i)
          {
            const auto component = space.velocity_element.face_system_to_component_index(i, f);
            dofs[component.second][component.first] = face_dofs[i];
          }
          for (unsigned int k = 0; k < nodes_of_face.size(); ++k)
          {
            if (!space.velocity_owned.is_element(dofs[k][0]) ||
                space.velocity_hanging.is_constrained(dofs[k][0]))
              continue;
            Node<dim> &node = nodes[dofs[k][0]];
            node.dofs = dofs[k];
            node.point = values.quadrature_point(k);
            const Tensor<1, dim> normal = values.normal_vector(k);
            bool merged = false;
            for (NodeFace<dim> &face : node.faces)
              if (face.condition == found->second &&
                  face.normal * normal > same_face_cosine * face.normal.norm())
              {
                // Summed here, brought to unit length when all faces are known.
                face.normal += normal;
                merged = true;
                break;
              }
            if (!merged)
              node.faces.push_back({static_cast<unsigned int>(found->second), normal});
          }
        }
  for (auto &entry : nodes)
  {
    for (NodeFace<dim> &face : entry.second.faces)
      face.normal /= face.normal.norm();
    // The order of the conditions in the file decides at conflicts, on any number of ranks; among
    // faces of one condition the order of the normals.
    std::sort(entry.second.faces.begin(), entry.second.faces.end(),
              [](const NodeFace<dim> &a, const NodeFace<dim> &b)
              {
                if (a.condition != b.condition)
                  return a.condition < b.condition;
                for (unsigned int c = 0; c < dim; ++c)
                  if (std::abs(a.normal[c] - b.normal[c]) > 1e-6)
                    return a.normal[c] < b.normal[c];
                return false;
              });
  }
  return nodes;
}

/// One equation at a node while it is being reduced: sum_c direction[c] u_c = sum weights *
/// sources.
template <int dim>
struct Equation
{
  Tensor<1, dim> direction;
  std::map<unsigned int, double> weights;
  unsigned int pivot = 0;
  unsigned int condition = 0;
};

template <int dim>
void subtract(Equation<dim> &equation, const double factor, const Equation<dim> &other)
{
  equation.direction -= factor * other.direction;
  for (const auto &weight : other.weights)
    equation.weights[weight.first] -= factor * weight.second;
}

/// The halves of a condition that prescribe a velocity at a face, each with a direction.
template <int dim>
std::vector<std::pair<const BoundaryPart *, Tensor<1, dim>>>
prescribed_directions(const BoundaryCondition &condition, const Tensor<1, dim> &face_normal)
{
  const bool normal = condition.normal.kind == BoundaryPart::Kind::velocity;
  const bool tangential = condition.tangential.kind == BoundaryPart::Kind::velocity;
  std::vector<std::pair<const BoundaryPart *, Tensor<1, dim>>> asked;
  const bool prescribes_vector =
      normal && tangential && condition.normal.along_normal.is_zero() &&
      condition.normal.vector.size() == condition.tangential.vector.size();
  if (prescribes_vector)
    // Both halves are of one vector: its Cartesian components, free of round-off from normals.
    for (unsigned int c = 0; c < dim; ++c)
    {
      Tensor<1, dim> axis;
      axis[c] = 1.;
      asked.emplace_back(&condition.tangential, axis);
    }
  else
  {
    if (normal)
      asked.emplace_back(&condition.normal, face_normal);
    if (tangential)
      for (const Tensor<1, dim> &tangent : tangents(face_normal))
        asked.emplace_back(&condition.tangential, tangent);
  }
  return asked;
}

/// Adds an equation to those that are reduced already, each of which has a pivot of its own and
/// zeros at the others' pivots. Returns false, and leaves the right-hand side that must vanish in
/// `equation`, if it depends on them.
template <int dim>
bool reduce(Equation<dim> &equation, std::vector<Equation<dim>> &equations)
{
  for (const Equation<dim> &earlier : equations)
    subtract(equation, equation.direction[earlier.pivot], earlier);
  if (equation.direction.norm() < dependent_remainder)
    return false;
  // Pivot on the largest component, eliminate it from the earlier equations.
  for (unsigned int c = 1; c < dim; ++c)
    if (std::abs(equation.direction[c]) > std::abs(equation.direction[equation.pivot]) + 1e-12)
      equation.pivot = c;
  const double scale = 1. / equation.direction[equation.pivot];
  equation.direction *= scale;
  for (auto &weight : equation.weights)
    weight.second *= scale;
  for (Equation<dim> &earlier : equations)
    subtract(earlier, earlier.direction[equation.pivot], equation);
  equations.push_back(equation);
  return true;
}
} // namespace

template <int dim>
BoundaryConstraints<dim>::BoundaryConstraints(const Space<dim> &space,
                                              const std::vector<BoundaryCondition> &conditions)
    : space(space), conditions(conditions)
{
}

template <int dim>
double BoundaryConstraints<dim>::Source::value(const double time) const
{
  double sum = 0.;
  for (unsigned int c = 0; c < part->vector.size(); ++c)
    if (direction[c] != 0.)
      sum += direction[c] * part->vector[c](point, time);
  const double along = direction * normal;
  if (part->flow)
  {
    const std::vector<double> &amplitudes = part->flow->amplitudes(time);
    for (std::size_t m = 0; m < flow_shapes.size(); ++m)
      sum -= along * flow_shapes[m] * amplitudes[m];
  }
  else if (std::abs(along) > round_off_of_direction)
    sum += (part->negative ? -along : along) * part->along_normal(point, time);
  return sum;
}

template <int dim>
bool BoundaryConstraints<dim>::vanishes(const std::map<unsigned int, double> &weights) const
{
  // At t = 0 and over many scales of time.
  for (int i = -1; i < 72; ++i)
  {
    const double time = i < 0 ? 0. : 1e-6 * std::pow(10., i / 8.);
    double value = 0., scale = 0.;
    for (const auto &weight : weights)
    {
      // What round-off in a normal of length 1 leaves is no part of the condition.
      if (std::abs(weight.second) < round_off_of_direction)
        continue;
      const double term = weight.second * sources[weight.first].value(time);
      value += term;
      scale += std::abs(term);
    }
    if (std::abs(value) > 1e-8 * scale)
      return false;
  }
  return true;
}

template <int dim>
void BoundaryConstraints<dim>::build()
{
  sources.clear();
  constrained.clear();
  hanging.clear();
  conflict_texts.clear();
  homogeneous = true;
  constants_are_set = false;
  std::set<std::pair<unsigned int, unsigned int>> conflicts;

  std::map<const BoundaryPart *, std::map<types::global_dof_index, std::vector<double>>> flows;
  for (const BoundaryCondition &condition : conditions)
    if (condition.normal.flow)
      flows[&condition.normal] = nodal_flow_shapes(space, condition);

  AffineConstraints<double> boundary(space.velocity_relevant);
  for (const auto index : space.velocity_owned)
    if (space.velocity_hanging.is_constrained(index))
      hanging.push_back(space.velocity_owned.index_within_set(index));

  for (const auto &entry : collect_nodes(space, conditions))
  {
    const Node<dim> &node = entry.second;
    std::vector<Equation<dim>> equations;
    for (const NodeFace<dim> &face : node.faces)
      for (const auto &[part, direction] :
           prescribed_directions(conditions[face.condition], face.normal))
      {
        Equation<dim> equation;
        equation.direction = direction;
        equation.condition = face.condition;
        // At the rim of a section that a flow passes the velocity is zero for ever.
        const bool is_rim = part->flow && flows[part].count(node.dofs[0]) == 0;
        if (!part->is_zero() && !is_rim)
        {
          Source source{part, direction, face.normal, {0., 0., 0.}, {}};
          if (part->flow)
            source.flow_shapes = flows[part][node.dofs[0]];
          for (unsigned int c = 0; c < dim; ++c)
            source.point[c] = node.point[c];
          equation.weights[sources.size()] = 1.;
          sources.push_back(source);
        }
        if (!reduce(equation, equations) && !vanishes(equation.weights))
          for (const Equation<dim> &earlier : equations)
            if (earlier.condition != equation.condition)
              conflicts.insert({earlier.condition, equation.condition});
      }
    for (const Equation<dim> &equation : equations)
    {
      Constrained entry_of_dof;
      entry_of_dof.index = space.velocity_owned.index_within_set(node.dofs[equation.pivot]);
      entry_of_dof.time_dependent = false;
      boundary.add_line(node.dofs[equation.pivot]);
      for (unsigned int c = 0; c < dim; ++c)
        if (c != equation.pivot && std::abs(equation.direction[c]) > round_off_of_direction)
        {
          boundary.add_entry(node.dofs[equation.pivot], node.dofs[c], -equation.direction[c]);
          entry_of_dof.masters.push_back(
              {static_cast<unsigned int>(space.velocity_owned.index_within_set(node.dofs[c])),
               -equation.direction[c]});
        }
      for (const auto &weight : equation.weights)
        if (std::abs(weight.second) > 1e-14)
        {
          entry_of_dof.sources.emplace_back(weight.first, weight.second);
          homogeneous = false;
          if (sources[weight.first].part->depends_on_time())
            entry_of_dof.time_dependent = true;
        }
      constrained.push_back(entry_of_dof);
    }
  }
  // Hanging nodes on the boundary follow masters that are on it too and constrained themselves.
  constraints.clear();
  constraints.reinit(space.velocity_relevant);
  constraints.merge(space.velocity_hanging, AffineConstraints<double>::no_conflicts_allowed, true);
  constraints.merge(boundary, AffineConstraints<double>::no_conflicts_allowed, true);
  if (Utilities::MPI::n_mpi_processes(space.communicator) > 1)
    constraints.make_consistent_in_parallel(space.velocity_owned, space.velocity_relevant,
                                            space.communicator);
  constraints.close();

  // A few nodes of each part tell whether it jumps.
  watched_sources.clear();
  std::map<const BoundaryPart *, std::vector<unsigned int>> of_part;
  for (unsigned int i = 0; i < sources.size(); ++i)
    if (sources[i].part->depends_on_time())
      of_part[sources[i].part].push_back(i);
  constexpr unsigned int n_watched = 8;
  for (const auto &[part, indices] : of_part)
    for (unsigned int i = 0; i < std::min<std::size_t>(n_watched, indices.size()); ++i)
      watched_sources.push_back(
          indices[i * indices.size() / std::min<std::size_t>(n_watched, indices.size())]);

  homogeneous = Utilities::MPI::min(homogeneous ? 1 : 0, space.communicator) == 1;
  std::vector<unsigned int> own_conflicts;
  for (const auto &[first, second] : conflicts)
    own_conflicts.insert(own_conflicts.end(), {first, second});
  for (const auto &of_rank : all_gather(space.communicator, own_conflicts))
    for (std::size_t i = 0; i < of_rank.size(); i += 2)
      conflicts.emplace(of_rank[i], of_rank[i + 1]);
  for (const auto &pair : conflicts)
    conflict_texts.push_back("the boundaries '" + conditions[pair.first].name + "' and '" +
                             conditions[pair.second].name + "' meet with different velocities; '" +
                             conditions[pair.first].name +
                             "' holds at the nodes they share (it stands first)");
}

template <int dim>
void BoundaryConstraints<dim>::restrict_to_free(DistributedVector &residual) const
{
  double *const values = residual.begin();
  for (const Constrained &dof : constrained)
  {
    for (const Master &master : dof.masters)
      values[master.index] += master.coefficient * values[dof.index];
    values[dof.index] = 0.;
  }
  for (const unsigned int index : hanging)
    values[index] = 0.;
}

namespace
{
/// Sets the constrained entries from their masters and, unless they are null, `values`.
template <typename Constrained>
void set_entries(const std::vector<Constrained> &constrained,
                 const std::vector<unsigned int> &hanging,
                 const double *const values,
                 double *const u)
{
  for (const Constrained &dof : constrained)
  {
    double sum = values != nullptr ? values[dof.index] : 0.;
    for (const auto &master : dof.masters)
      sum += master.coefficient * u[master.index];
    u[dof.index] = sum;
  }
  for (const unsigned int index : hanging)
    u[index] = 0.;
}
} // namespace

template <int dim>
void BoundaryConstraints<dim>::set_constrained(DistributedVector &velocity,
                                               const DistributedVector &values) const
{
  set_entries(constrained, hanging, values.begin(), velocity.begin());
}

template <int dim>
void BoundaryConstraints<dim>::expand_free(DistributedVector &velocity) const
{
  set_entries(constrained, hanging, nullptr, velocity.begin());
}

template <int dim>
void BoundaryConstraints<dim>::prescribed_part(const DistributedVector &velocity,
                                               DistributedVector &values) const
{
  const double *const u = velocity.begin();
  double *const g = values.begin();
  for (const Constrained &dof : constrained)
  {
    double value = u[dof.index];
    for (const Master &master : dof.masters)
      value -= master.coefficient * u[master.index];
    g[dof.index] = value;
  }
}

template <int dim>
void BoundaryConstraints<dim>::evaluate(const double time, DistributedVector &values) const
{
  double *const g = values.begin();
  for (const Constrained &dof : constrained)
    if (dof.time_dependent || !constants_are_set)
    {
      double sum = 0.;
      for (const auto &source : dof.sources)
        sum += source.second * sources[source.first].value(time);
      g[dof.index] = sum;
    }
  constants_are_set = true;
}

template <int dim>
void BoundaryConstraints<dim>::evaluate_of(const BoundaryCondition &condition,
                                           const double time,
                                           DistributedVector &values) const
{
  values = 0.;
  for (const Constrained &dof : constrained)
    for (const auto &[number, weight] : dof.sources)
      if (const Source &source = sources[number];
          source.part == &condition.normal || source.part == &condition.tangential)
        values.begin()[dof.index] += weight * source.value(time);
}

template <int dim>
bool BoundaryConstraints<dim>::jumps(const double begin, const double end) const
{
  bool found = false;
  for (const unsigned int index : watched_sources)
    found = found ||
            jumps_within([&](const double time) { return sources[index].value(time); }, begin, end);
  return Utilities::MPI::max(found ? 1 : 0, space.communicator) == 1;
}

template class BoundaryConstraints<2>;
template class BoundaryConstraints<3>;
} // namespace Continua
