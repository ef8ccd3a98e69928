#include <continua/mesh/channel_section.h>

#include <array>
#include <cmath>
#include <map>
#include <stdexcept>

namespace Continua
{
using namespace dealii;

namespace
{
/// Of the length, by which a line may be bent or have gaps.
constexpr double straight = 1e-6;
} // namespace

ChannelSection find_channel_section(const Triangulation<2> &triangulation,
                                    const types::boundary_id boundary,
                                    const std::set<unsigned int> &regions,
                                    const std::set<types::boundary_id> &symmetry)
{
  std::map<unsigned int, Point<2>> vertices;
  std::set<unsigned int> symmetric;
  double length = 0.;
  for (const auto &cell : triangulation.cell_iterators_on_level(0))
    for (const unsigned int f : cell->face_indices())
    {
      const auto face = cell->face(f);
      if (!cell->at_boundary(f))
        continue;
      const bool is_section =
          face->boundary_id() == boundary && regions.count(cell->material_id()) > 0;
      // A wall beside the liquid may end at a roller, too.
      const bool is_symmetry =
          symmetry.count(face->boundary_id()) > 0 && regions.count(cell->material_id()) > 0;
      if (is_section)
        length += face->vertex(0).distance(face->vertex(1));
      for (const unsigned int v : face->vertex_indices())
      {
        if (is_section)
          vertices[face->vertex_index(v)] = face->vertex(v);
        if (is_symmetry)
          symmetric.insert(face->vertex_index(v));
      }
    }
  if (vertices.empty())
    throw std::invalid_argument("the boundary has no face there");
  // The ends: the vertices that are farthest from each other.
  const auto farthest = [&vertices](const Point<2> &from)
  {
    auto found = vertices.begin();
    for (auto vertex = vertices.begin(); vertex != vertices.end(); ++vertex)
      if (vertex->second.distance(from) > found->second.distance(from))
        found = vertex;
    return found;
  };
  const auto first = farthest(vertices.begin()->second);
  const auto last = farthest(first->second);
  const double distance = first->second.distance(last->second);
  Tensor<1, 2> direction = (last->second - first->second) / distance;
  for (const auto &[index, vertex] : vertices)
  {
    const Tensor<1, 2> from_first = vertex - first->second;
    if (std::abs(from_first[0] * direction[1] - from_first[1] * direction[0]) > straight * distance)
      throw std::invalid_argument("the boundary is not a straight line");
  }
  if (std::abs(length - distance) > straight * distance)
    throw std::invalid_argument("the boundary is not one line without gaps");

  if (direction[1] < -straight || (std::abs(direction[1]) <= straight && direction[0] < 0.))
    direction *= -1.;
  ChannelSection section;
  section.direction = direction;
  const bool first_is_middle = symmetric.count(first->first) > 0,
             last_is_middle = symmetric.count(last->first) > 0;
  if (first_is_middle && last_is_middle)
    throw std::invalid_argument("both ends of the boundary lie on planes of symmetry, so that the "
                                "channel has no wall");
  if (first_is_middle || last_is_middle)
  {
    section.middle = first_is_middle ? first->second : last->second;
    section.half_gap = distance;
    section.fraction = 0.5;
  }
  else
  {
    section.middle = first->second + 0.5 * (last->second - first->second);
    section.half_gap = 0.5 * distance;
  }
  return section;
}
} // namespace Continua
