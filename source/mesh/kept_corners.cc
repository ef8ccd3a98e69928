#include <continua/mesh/kept_corners.h>
#include <continua/mesh/quadratic_cell_manifold.h>

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

/// The unit normal of the face of a curved cell at a place of it, out of the cell.
template <int dim>
Tensor<1, dim> normal_of(const QuadraticCellManifold<dim> &curved,
                         const unsigned int face,
                         const Point<dim> &place)
{
  const Tensor<2, dim> gradient = curved.push_forward_gradient(curved.pull_back(place));
  Tensor<1, dim> in_chart;
  in_chart[face / 2] = face % 2 == 0 ? -1. : 1.;
  const Tensor<1, dim> normal = transpose(invert(gradient)) * in_chart;
  return normal / normal.norm();
}

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

template <int dim>
const QuadraticCellManifold<dim> *as_curved(const Manifold<dim> &manifold)
{
  return dynamic_cast<const QuadraticCellManifold<dim> *>(&manifold);
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
      const auto *curved = as_curved<dim>(cell->get_manifold());
      // A straight cell may have a curved one as its neighbour.
      const bool is_straight = cell->manifold_id() == numbers::flat_manifold_id &&
                               (face->manifold_id() == numbers::flat_manifold_id ||
                                as_curved<dim>(face->get_manifold()) != nullptr);
      if (curved == nullptr && !is_straight)
        continue;
      Surface surface(outside, face->boundary_id());
      if (!cell->at_boundary(f))
      {
        // Each interface from the side of its lower region.
        if (cell->neighbor(f)->material_id() <= cell->material_id())
          continue;
        surface = {cell->material_id(), cell->neighbor(f)->material_id()};
      }
      const auto add = [&](const unsigned int index, const Point<dim> &place)
      {
        Ridge &ridge = ridges[{surface, index}];
        ridge.normals.push_back(curved != nullptr ? normal_of<dim>(*curved, f, place)
                                                  : normal_of<dim>(cell, face));
        ridge.place = place;
      };
      if constexpr (dim == 2)
        for (const unsigned int v : face->vertex_indices())
          add(face->vertex_index(v), face->vertex(v));
      else
        for (const unsigned int l : face->line_indices())
          add(face->line_index(l), face->line(l)->center(true));
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
  text << "the faces of the coarse mesh meet at corners, and division of the cells keeps these: ";
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
          "stresses at corners that point into the body grow without bound: mesh with curved cells "
          "(Mesh.ElementOrder = 2 in gmsh) that are small enough, or make the cells of the mesh "
          "file small instead, with "
          "Mesh/Refinements = 0 and without Adaptivity";
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
