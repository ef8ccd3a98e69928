#ifndef continua_mesh_tube_cross_section_h
#define continua_mesh_tube_cross_section_h

#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace Continua
{
/**
 * The mesh of a tube's cross-section, of which a quarter (y, z >= 0), a half (z >= 0) or all of it
 * is made: a square core, whose diagonals end at 0.6 of the radius, and rings around it that become
 * round outwards.
 *
 * A point is told by its place (rho, u): rho is 0 on the core's surface, 1 on the wall's inner and
 * 2 on its outer surface; u counts eighths of a turn from the y axis towards the z axis. Inside the
 * wall's inner surface a line of constant u is straight from the core's side, which u divides
 * equally, to the circle, which it divides equally, too. Coordinates here are scaled: a point
 * inside has its distances from the axis over the inner radius, in the wall its distance from the
 * axis is rho.
 */
class TubeCrossSection
{
public:
  /// What is made; its number is that of quarters.
  enum class Sector : unsigned int
  {
    quarter = 1,
    half = 2,
    full = 4
  };
  struct Cell
  {
    std::array<unsigned int, 4> vertices; ///< lexicographic, counter-clockwise positive
    bool is_core;
    unsigned int ring; ///< from the core outwards; of the core, 0
  };

  /// `rings`: the places rho of the rings' surfaces, ascending from 0; `n_side_cells` along half a
  /// side of the core, which is half of those along a quarter of the circumference.
  TubeCrossSection(const std::vector<double> &rings, unsigned int n_side_cells, Sector sector);

  const std::vector<dealii::Point<2>> &vertices() const { return all_vertices; } ///< scaled (y, z)
  const std::vector<Cell> &cells() const { return all_cells; }

  /// The scaled point at the place (rho, u), rho >= 0; the planes y = 0 and z = 0 are hit exactly.
  static dealii::Point<2> point(double rho, double u);
  /// The place (rho, u), 0 <= u <= 8, of a scaled point outside the core.
  static dealii::Point<2> place(const dealii::Point<2> &point);
  /// Half the side of the core over the inner radius.
  static constexpr double half_side = 0.4242640687119285; // 0.6 sqrt(1/2)
  /// The period of u.
  static constexpr double full_turn = 8.;

private:
  std::vector<dealii::Point<2>> all_vertices;
  std::vector<Cell> all_cells;
};
} // namespace Continua

#endif
