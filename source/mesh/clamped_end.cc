#include <continua/mesh/clamped_end.h>
#include <continua/mesh/grading.h>

#include <cmath>

namespace Continua
{
void add_axial_grading(ParameterSection mesh, double &grading, const std::string &boundaries)
{
  mesh.add(
      "Axial grading", grading, Dimensions::none,
      "Length of the first cell at an end where the wall cannot widen (Boundaries/" + boundaries +
          " with Type = fixed; or the velocity along the liquid's section there is prescribed, as "
          "by Type = flow rate or fixed, Tangential = fixed, Coupling = flow) over that of "
          "equal cells along the whole axis. From there "
          "each cell is at most 1.5 times as long as the one before, until the equal cells of "
          "the rest are reached. 0 makes the first cell sqrt(R h)/2 long, R the inner radius "
          "and h the wall's thickness, since a wall that is held bends there; 1 makes all "
          "cells equal, as they are at ends that are not held",
      Range{0., 1., false, false});
  if (grading > 0. && grading < grading_range.lower)
    mesh.refuse("Axial grading", "it is less than " + shortest_number(grading_range.lower),
                "Give 0 for an automatic one, or a larger one");
}

double clamped_end_cell(const double grading,
                        const double equal_cell,
                        const double inner_radius,
                        const double wall_thickness)
{
  return grading > 0. ? grading * equal_cell : 0.5 * std::sqrt(inner_radius * wall_thickness);
}
} // namespace Continua
