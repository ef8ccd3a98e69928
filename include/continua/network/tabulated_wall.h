#ifndef continua_network_tabulated_wall_h
#define continua_network_tabulated_wall_h

#include <continua/network/square_root_wall.h>

#include <functional>
#include <memory>
#include <vector>

namespace Continua
{
/**
 * Pressure over the area A [m^2] of a section of a tube with a wall of any law: cubics between the
 * values of the law, at equal distances of the logarithm of the area, with slopes by differences of
 * fourth order. The areas go from a third of that without pressure to three times that of the mesh.
 * (The mesh of a ring that was opened has a much larger area than the closed ring without pressure;
 * the table begins at 1/81 of it at the least.) Where the pressure has a largest value, as that of
 * rubber has, the wall has no state beyond it; nor has it one outside the table.
 */
class TabulatedWall
{
public:
  /// `pressure(r)` [Pa] of the inner radius r [m]; `area` [m^2] of the mesh; to all pressures
  /// `shift` [Pa] is added. Throws std::domain_error where the pressure does not rise at `area`.
  TabulatedWall(double area, const std::function<double(double)> &pressure, double shift = 0.);
  /// Between two tables: `share` of the second one and the rest of the first one, whose shift it
  /// has. `area` [m^2] of the mesh.
  TabulatedWall(double area, const TabulatedWall &first, const TabulatedWall &second, double share);

  /// Of the mesh [m^2].
  double reference_area() const { return mesh_area; }
  /// Which no area reaches [Pa].
  double largest_pressure() const { return table->pressures.back() + shift; }
  /// [Pa] at an area [m^2]; NaN beyond the table.
  double pressure(const double area) const { return both(area).pressure; }
  /// dp/dA [Pa/m^2].
  double stiffness(const double area) const { return both(area).stiffness; }
  /// Both at once.
  PressureAndStiffness both(double area) const;
  /// The area [m^2] at a pressure [Pa]; NaN if there is none. `start` is of no use here.
  double area(double pressure, double start) const;

private:
  /// Over the logarithm of the area relative to that of the mesh, from `first` on; the pressures
  /// rise.
  struct Table
  {
    double first; ///< [1]
    std::vector<double> pressures, slopes;
  };
  double mesh_area; ///< [m^2]
  double shift;     ///< [Pa]
  std::shared_ptr<const Table> table;

  /// In an interval of the table, at a part of it from 0 to 1; the derivative is by the
  /// logarithm of the area.
  PressureAndStiffness in_interval(std::size_t interval, double part) const;
};
} // namespace Continua

#endif
