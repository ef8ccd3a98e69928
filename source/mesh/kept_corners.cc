#include <continua/mesh/kept_corners.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <utility>

namespace Continua
{
using namespace dealii;

namespace
{
/// A boundary by its id, or an interface by its two regions, the lower first.
using Surface = std::pair<unsigned int, unsigned int>;
constexpr unsigned int outside = numbers::invalid_unsigned_int;

/// The unit normal of a straight face, away from a cell of it.
template <int dim>
Tensor<1, dim> normal_of(const typename Triangulation<dim>::cell_iterator &cell,
                         const typename Triangulation<dim>::face_iterator &face)
{
  Tensor<1, dim> normal;
  if constexpr (dim == 2)
    normal = cross_product_2d(face->vertex(1) - face->vertex(0));
  else
    normal = cross_product_3d(face->vertex(3) - face->vertex(0), face->vertex(2) - face->vertex(1));
  if (normal * (face->center() - cell->center()) < 0.)
    normal = -normal;
  return normal / normal.norm();
}
} // namespace

template <int dim>
std::vector<KeptCorner<dim>> kept_corners(const Triangulation<dim> &coarse_mesh,
                                          const std::vector<std::string> &regions,
                                          const std::vector<std::string> &boundaries)
{
  struct Ridge
  {
    std::vector<Tensor<1, dim>> normals;
    Point<dim> place;
  };
  // By surface and vertex (in 2-D) or line (in 3-D).
  std::map<std::pair<Surface, unsigned int>, Ridge> ridges;
  for (const auto &cell : coarse_mesh.cell_iterators_on_level(0))
    for (const unsigned int f : cell->face_indices())
    {
      const auto face = cell->face(f);
      if (face->manifold_id() != numbers::flat_manifold_id ||
          cell->manifold_id() != numbers::flat_manifold_id)
        continue;
      Surface surface(outside, face->boundary_id());
      if (!cell->at_boundary(f))
      {
        // Each interface from the side of its lower region.
        if (cell->neighbor(f)->material_id() <= cell->material_id())
          continue;
        surface = {cell->material_id(), cell->neighbor(f)->material_id()};
      }
      const Tensor<1, dim> normal = normal_of<dim>(cell, face);
      const auto add = [&](const unsigned int index, const Point<dim> &place)
      {
        Ridge &ridge = ridges[{surface, index}];
        ridge.normals.push_back(normal);
        ridge.place = place;
      };
      if constexpr (dim == 2)
        for (const unsigned int v : face->vertex_indices())
          add(face->vertex_index(v), face->vertex(v));
      else
        for (const unsigned int l : face->line_indices())
          add(face->line_index(l), face->line(l)->center());
    }

  std::map<Surface, KeptCorner<dim>> largest;
  for (const auto &[key, ridge] : ridges)
  {
    // More than two faces of a name meet where parts of it touch.
    if (ridge.normals.size() != 2)
      continue;
    const double angle =
        2. * std::asin(std::min(1., 0.5 * (ridge.normals[0] - ridge.normals[1]).norm()));
    if (angle < smallest_curved || angle > largest_curved)
      continue;
    KeptCorner<dim> &corner = largest[key.first];
    // Round-off must not choose between corners that symmetry makes equal.
    if (angle <= (1. + 1e-6) * corner.angle)
      continue;
    const auto &[first, second] = key.first;
    corner = {first == outside
                  ? "the boundary '" + boundaries[second] + "'"
                  : "the interface of '" + regions[first] + "' and '" + regions[second] + "'",
              angle, ridge.place};
  }
  std::vector<KeptCorner<dim>> result;
  for (const auto &[surface, corner] : largest)
    result.push_back(corner);
  std::stable_sort(result.begin(), result.end(),
                   [](const auto &a, const auto &b) { return a.angle > (1. + 1e-6) * b.angle; });
  return result;
}

template <int dim>
std::string warning_of(const std::vector<KeptCorner<dim>> &corners)
{
  if (corners.empty())
    return "";
  std::ostringstream text;
  text.precision(3);
  text << "the coarse mesh has straight faces, and division of the cells keeps the corners between "
          "them: ";
  for (std::size_t k = 0; k < corners.size(); ++k)
  {
    text << (k == 0 ? "" : "; ") << corners[k].surface << " up to "
         << corners[k].angle * 180. / numbers::PI << " degrees, at (";
    for (unsigned int d = 0; d < dim; ++d)
      text << (d == 0 ? "" : ", ")
           << (std::abs(corners[k].place[d]) < 1e-12 * corners[k].place.norm()
                   ? 0.
                   : corners[k].place[d]);
    text << ") m";
  }
  text << ". If they stand for a curve, finer cells go to the polygon and not to the curve, and "
          "stresses at corners that point into the body grow without bound: make the cells of the "
          "mesh "
          "file small instead, with Mesh/Refinements = 0 and without Adaptivity";
  return text.str();
}

template std::vector<KeptCorner<2>> kept_corners(const Triangulation<2> &,
                                                 const std::vector<std::string> &,
                                                 const std::vector<std::string> &);
template std::vector<KeptCorner<3>> kept_corners(const Triangulation<3> &,
                                                 const std::vector<std::string> &,
                                                 const std::vector<std::string> &);
template std::string warning_of(const std::vector<KeptCorner<2>> &);
template std::string warning_of(const std::vector<KeptCorner<3>> &);
} // namespace Continua
