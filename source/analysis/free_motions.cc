#include <continua/analysis/free_motions.h>

#include <continua/analysis/rigid_motions.h>
#include <continua/mesh/connected_cells.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>

namespace Continua
{
using namespace dealii;

namespace
{
/// Mean square of the held part of a motion over that of the motion below which the motion is free.
constexpr double least_held_part = 1e-5;
/// Of curved boundaries, whose normals are then right to some 1e-3.
constexpr unsigned int mapping_degree = 4;

template <int dim>
using Cell = typename Triangulation<dim>::cell_iterator;

/// Coarse cells of solids, or of liquids, that hang together by faces.
template <int dim>
struct Body
{
  std::vector<Cell<dim>> cells;
  std::set<unsigned int> regions;
  bool is_solid = false;
};

template <int dim>
std::vector<Body<dim>> bodies(const Triangulation<dim> &triangulation,
                              const std::vector<Material> &materials,
                              std::vector<unsigned int> &body_of_cell)
{
  std::vector<unsigned int> kinds;
  kinds.reserve(materials.size());
  for (const Material &material : materials)
    kinds.push_back(material.is_solid() ? 1 : 0);
  body_of_cell = connected_cells(triangulation, kinds);
  std::vector<Body<dim>> result;
  for (const auto &cell : triangulation.cell_iterators_on_level(0))
  {
    const unsigned int number = body_of_cell[cell->index()];
    if (number == result.size())
      result.emplace_back();
    Body<dim> &body = result[number];
    body.is_solid = materials[cell->material_id()].is_solid();
    body.cells.push_back(cell);
    body.regions.insert(cell->material_id());
  }
  return result;
}

/// The two matrices over the motions of one body, and what one condition adds to them.
template <int dim>
class HeldMotions
{
public:
  explicit HeldMotions(const std::vector<RigidMotion<dim>> &motions)
      : motions(motions),
        held(motions.size()),
        mean_square(motions.size()),
        of_held(held),
        of_square(held),
        displaced(motions.size())
  {
  }
  /// A place at which the part P m of a motion is held: P is n n, 1 - n n or 1.
  void add_place(const Point<dim> &place,
                 const Tensor<1, dim> &normal,
                 const double weight,
                 const bool holds_normal,
                 const bool holds_tangential)
  {
    for (std::size_t i = 0; i < motions.size(); ++i)
      for (std::size_t j = 0; j < motions.size(); ++j)
      {
        const Tensor<1, dim> a = motions[i](place), b = motions[j](place);
        const double of_normal = (a * normal) * (b * normal);
        of_square(i, j) += weight * (a * b);
        of_held(i, j) += weight * ((holds_normal ? of_normal : 0.) +
                                   (holds_tangential ? a * b - of_normal : 0.));
      }
    area += weight;
  }
  /// One over which only the whole volume that a motion displaces is held.
  void add_volume_place(const Point<dim> &place, const Tensor<1, dim> &normal, const double weight)
  {
    add_place(place, normal, weight, false, false);
    for (std::size_t i = 0; i < motions.size(); ++i)
      displaced[i] += weight * (motions[i](place) * normal);
  }
  /// The places of one condition are complete.
  void finish_condition()
  {
    if (area > 0.)
    {
      for (std::size_t i = 0; i < motions.size(); ++i)
        for (std::size_t j = 0; j < motions.size(); ++j)
          of_held(i, j) += displaced[i] * displaced[j] / area;
      held.add(1. / area, of_held);
      mean_square.add(1. / area, of_square);
    }
    of_held = 0.;
    of_square = 0.;
    displaced = 0.;
    area = 0.;
  }
  /// The free motions, as factors of the motions.
  std::vector<std::vector<double>> free() const;

private:
  const std::vector<RigidMotion<dim>> &motions;
  FullMatrix<double> held, mean_square, of_held, of_square;
  Vector<double> displaced;
  double area = 0.;
};

template <int dim>
std::vector<std::vector<double>> HeldMotions<dim>::free() const
{
  const unsigned int n = motions.size();
  std::vector<std::vector<double>> result;
  if (mean_square.frobenius_norm() == 0.)
  {
    for (unsigned int i = 0; i < n; ++i)
    {
      result.emplace_back(n, 0.);
      result.back()[i] = 1.;
    }
    return result;
  }
  // Turns are lengths where they are taken by the size of what is held; a motion that leaves all
  // that is held in its place is free of it, too.
  LAPACKFullMatrix<double> matrix(n, n);
  std::vector<double> scale(n);
  double largest = 0.;
  for (unsigned int i = 0; i < n; ++i)
    largest = std::max(largest, motions[i].rotates ? 0. : mean_square(i, i));
  for (unsigned int i = 0; i < n; ++i)
    scale[i] = 1. / std::sqrt(std::max(mean_square(i, i), 1e-20 * largest));
  LAPACKFullMatrix<double> squares(n, n);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
    {
      matrix(i, j) = scale[i] * scale[j] * held(i, j);
      squares(i, j) = scale[i] * scale[j] * mean_square(i, j) + (i == j ? 1e-10 : 0.);
    }
  std::vector<Vector<double>> vectors(n, Vector<double>(n));
  matrix.compute_generalized_eigenvalues_symmetric(squares, vectors);
  for (unsigned int k = 0; k < n; ++k)
    if (matrix.eigenvalue(k).real() < least_held_part)
    {
      result.emplace_back(n);
      for (unsigned int i = 0; i < n; ++i)
        result.back()[i] = scale[i] * vectors[k](i);
    }
  return result;
}

/// Takes the vectors to the form in which each has one leading entry of 1 that the others have not,
/// turns first, so that motions along the axes stand alone where they can.
void reduce(std::vector<std::vector<double>> &vectors,
            const std::vector<unsigned int> &order,
            const std::vector<double> &sizes)
{
  std::size_t row = 0;
  for (const unsigned int column : order)
  {
    std::size_t best = row;
    for (std::size_t k = row; k < vectors.size(); ++k)
      if (std::abs(vectors[k][column]) > std::abs(vectors[best][column]))
        best = k;
    if (row == vectors.size())
      return;
    double largest = 0.;
    for (unsigned int i = 0; i < sizes.size(); ++i)
      largest = std::max(largest, std::abs(vectors[best][i]) * sizes[i]);
    if (std::abs(vectors[best][column]) * sizes[column] < 1e-2 * largest)
      continue;
    std::swap(vectors[row], vectors[best]);
    const double pivot = vectors[row][column];
    for (double &entry : vectors[row])
      entry /= pivot;
    for (std::size_t k = 0; k < vectors.size(); ++k)
      if (const double factor = vectors[k][column]; k != row)
        for (unsigned int i = 0; i < sizes.size(); ++i)
          vectors[k][i] -= factor * vectors[row][i];
    ++row;
  }
}

/// The words for a motion; `length`: of the body [m].
template <int dim>
std::string text_of(const std::vector<RigidMotion<dim>> &motions,
                    const std::vector<double> &factors,
                    const double length)
{
  const std::array<const char *, 3> names = {{"x", "y", "z"}};
  Tensor<1, 3> translation, turn, centre;
  for (std::size_t i = 0; i < motions.size(); ++i)
  {
    (motions[i].rotates ? turn : translation)[motions[i].axis_number] += factors[i];
    for (unsigned int d = 0; d < dim; ++d)
      centre[d] = motions[i].centre[d];
  }
  const auto direction = [&](Tensor<1, 3> of)
  {
    of /= of.norm();
    for (unsigned int d = 0; d < 3; ++d)
      if (std::abs(of[d]) > 1. - 1e-6)
        return std::string(names[d]);
    std::ostringstream text;
    text.precision(3);
    text << '(';
    for (unsigned int d = 0; d < dim; ++d)
      text << (d == 0 ? "" : ", ") << (std::abs(of[d]) < 1e-3 ? 0. : of[d]);
    text << ')';
    return text.str();
  };
  std::ostringstream text;
  text.precision(4);
  if (turn.norm() * length <= 1e-2 * translation.norm())
  {
    text << "moving along " << direction(translation);
    return text.str();
  }
  const Tensor<1, 3> place = centre + cross_product_3d(turn, translation) / (turn * turn);
  text << "turning about " << direction(turn) << " through (";
  for (unsigned int d = 0; d < dim; ++d)
    text << (d == 0 ? "" : ", ") << (std::abs(place[d]) < 1e-6 * length ? 0. : place[d]);
  text << ") m";
  const double pitch = (turn * translation) / (turn * turn);
  if (std::abs(pitch) > 1e-2 * length)
    text << " while moving along it";
  return text.str();
}

/// Whether liquid can leave a body of liquid, or what is around it yields.
bool lets_liquid_through(const BoundaryCondition &condition)
{
  return condition.normal.kind == BoundaryPart::Kind::traction && !condition.has_unknown_pressure();
}
} // namespace

template <int dim>
std::vector<FreeMotion> free_motions(const Case<dim> &input)
{
  const Problem &problem = input.problem;
  const Triangulation<dim> &triangulation = *input.triangulation;
  const bool axisymmetric = problem.model == Model::axisymmetric;
  const bool springs_hold = !problem.finds_unloaded_shape();
  std::vector<unsigned int> body_of_cell;
  const std::vector<Body<dim>> all = bodies<dim>(triangulation, problem.materials, body_of_cell);
  const auto condition_at = [&](const Cell<dim> &cell, const unsigned int f)
  {
    for (unsigned int c = 0; c < problem.conditions.size(); ++c)
      if (problem.conditions[c].boundary_id == cell->face(f)->boundary_id() &&
          problem.conditions[c].region_ids.count(cell->material_id()) > 0)
        return c;
    return numbers::invalid_unsigned_int;
  };
  const auto holds = [&](const BoundaryPart &part)
  { return part.kind == BoundaryPart::Kind::velocity || (springs_hold && part.stiffness > 0.); };

  const MappingQ<dim> mapping(mapping_degree);
  const FE_Nothing<dim> element;
  const QGauss<dim - 1> quadrature(3);
  FEFaceValues<dim> values(mapping, element, quadrature,
                           update_quadrature_points | update_normal_vectors | update_JxW_values);

  // Liquids that cannot flow out.
  std::vector<bool> is_closed(all.size(), false);
  for (unsigned int b = 0; b < all.size(); ++b)
  {
    is_closed[b] = !all[b].is_solid;
    for (const Cell<dim> &cell : all[b].cells)
      for (const unsigned int f : cell->face_indices())
        if (cell->at_boundary(f))
          if (const unsigned int c = condition_at(cell, f);
              c != numbers::invalid_unsigned_int && lets_liquid_through(problem.conditions[c]) &&
              problem.conditions[c].type != BoundaryType::axis)
            is_closed[b] = false;
  }

  std::vector<FreeMotion> result;
  for (unsigned int b = 0; b < all.size(); ++b)
  {
    const Body<dim> &body = all[b];
    if (!body.is_solid)
      continue;
    Point<dim> centre;
    for (const Cell<dim> &cell : body.cells)
      centre += cell->center() / static_cast<double>(body.cells.size());
    double length = 0.;
    std::set<unsigned int> vertices;
    for (const Cell<dim> &cell : body.cells)
      for (const unsigned int v : cell->vertex_indices())
      {
        vertices.insert(cell->vertex_index(v));
        length = std::max(length, 2. * centre.distance(cell->vertex(v)));
      }
    const std::vector<RigidMotion<dim>> motions = rigid_motions<dim>(centre, axisymmetric);
    HeldMotions<dim> held(motions);
    std::set<unsigned int> holding;

    // Boundaries of the body itself, and of liquids beside it whose velocity is prescribed: they
    // hold it by the vertices that both have.
    for (unsigned int c = 0; c < problem.conditions.size(); ++c)
    {
      const BoundaryCondition &condition = problem.conditions[c];
      const bool holds_normal = holds(condition.normal),
                 holds_tangential = holds(condition.tangential);
      if (!holds_normal && !holds_tangential && !condition.is_cavity())
        continue;
      bool touches = false;
      for (const auto &cell : triangulation.cell_iterators_on_level(0))
        for (const unsigned int f : cell->face_indices())
        {
          if (!cell->at_boundary(f) || condition_at(cell, f) != c)
            continue;
          const bool is_own = body_of_cell[cell->index()] == b;
          bool has_vertex = is_own;
          for (unsigned int v = 0; v < cell->face(f)->n_vertices() && !has_vertex; ++v)
            has_vertex = vertices.count(cell->face(f)->vertex_index(v)) > 0;
          if (!has_vertex || (!is_own && condition.is_cavity()))
            continue;
          values.reinit(cell, f);
          touches = true;
          if (is_own)
            for (const unsigned int q : values.quadrature_point_indices())
            {
              const Point<dim> &place = values.quadrature_point(q);
              const double weight = values.JxW(q) * (axisymmetric ? place[1] : 1.);
              if (condition.is_cavity())
                held.add_volume_place(place, values.normal_vector(q), weight);
              else
                held.add_place(place, values.normal_vector(q), weight, holds_normal,
                               holds_tangential);
            }
          else
            for (unsigned int v = 0; v < cell->face(f)->n_vertices(); ++v)
              if (vertices.count(cell->face(f)->vertex_index(v)) > 0)
                held.add_place(cell->face(f)->vertex(v), values.normal_vector(0), 1., holds_normal,
                               holds_tangential);
        }
      held.finish_condition();
      if (touches)
        holding.insert(c);
    }
    // Liquids that cannot flow out.
    for (unsigned int liquid = 0; liquid < all.size(); ++liquid)
    {
      if (!is_closed[liquid])
        continue;
      for (const Cell<dim> &cell : body.cells)
        for (const unsigned int f : cell->face_indices())
          if (!cell->at_boundary(f) && body_of_cell[cell->neighbor(f)->index()] == liquid)
          {
            values.reinit(cell, f);
            for (const unsigned int q : values.quadrature_point_indices())
            {
              const Point<dim> &place = values.quadrature_point(q);
              held.add_volume_place(place, values.normal_vector(q),
                                    values.JxW(q) * (axisymmetric ? place[1] : 1.));
            }
          }
      held.finish_condition();
    }

    std::vector<std::vector<double>> free = held.free();
    std::vector<unsigned int> order;
    std::vector<double> sizes;
    sizes.reserve(motions.size());
    for (const bool turns : {true, false})
      for (unsigned int i = 0; i < motions.size(); ++i)
        if (motions[i].rotates == turns)
          order.push_back(i);
    for (const RigidMotion<dim> &motion : motions)
      sizes.push_back(motion.rotates ? length : 1.);
    reduce(free, order, sizes);
    // Those along the axes, which come last here, are told of first.
    std::vector<FreeMotion> of_body;
    of_body.reserve(free.size());
    for (const std::vector<double> &factors : free)
      of_body.push_back({text_of(motions, factors, length), body.regions, holding});
    std::stable_partition(of_body.begin(), of_body.end(),
                          [](const FreeMotion &motion)
                          { return motion.motion.find("turning") == std::string::npos; });
    result.insert(result.end(), of_body.begin(), of_body.end());
  }
  return result;
}

template <int dim>
void refuse_free_motions(const Case<dim> &input,
                         ParameterSection root,
                         const std::string &what_follows,
                         const std::string &other_remedy)
{
  const std::vector<FreeMotion> free = free_motions(input);
  if (free.empty())
    return;
  const FreeMotion &first = free.front();
  const Problem &problem = input.problem;
  const auto listed = [](const std::vector<std::string> &names)
  {
    std::string text;
    for (const std::string &name : names)
      text += (text.empty() ? "'" : ", '") + name + "'";
    return text;
  };
  std::vector<std::string> regions, conditions, motions;
  for (const unsigned int region : first.regions)
    regions.push_back(problem.regions[region]);
  for (const unsigned int c : first.conditions)
    conditions.push_back(problem.conditions[c].name);
  for (const FreeMotion &motion : free)
    if (motion.regions == first.regions)
      motions.push_back(motion.motion);
  std::string of_motions;
  for (std::size_t i = 0; i < motions.size(); ++i)
    of_motions += (i == 0 ? "" : i + 1 < motions.size() ? ", " : " and ") + motions[i];
  std::string text = "nothing holds the body";
  if (first.regions.size() < problem.regions.size())
    text += " of " + listed(regions);
  text += " against " + of_motions;
  if (!conditions.empty())
    text +=
        ", which " + listed(conditions) + (conditions.size() == 1 ? " lets" : " let") + " it do";
  text += what_follows;
  if (!problem.finds_unloaded_shape())
    text += !what_follows.empty() ? "" : "; loads, dampers and inertia do not hold a body at rest";
  else
    text += "; springs of a support do not act in the mesh's shape";
  root.subsection("Boundaries")
      .refuse("", text,
              std::string("Make a boundary that such a motion would move 'fixed' or 'roller'") +
                  (problem.finds_unloaded_shape() ? "" : ", or a 'support' with a stiffness") +
                  "; if body and loads are symmetric, take half of them, with a 'roller' on the "
                  "plane of symmetry" +
                  other_remedy);
}

template std::vector<FreeMotion> free_motions(const Case<2> &);
template std::vector<FreeMotion> free_motions(const Case<3> &);
template void
refuse_free_motions(const Case<2> &, ParameterSection, const std::string &, const std::string &);
template void
refuse_free_motions(const Case<3> &, ParameterSection, const std::string &, const std::string &);
} // namespace Continua
