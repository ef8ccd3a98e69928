#include <continua/materials/prestretch.h>

#include <continua/base/angle_entry.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/symmetric_tensor.h>

namespace Continua
{
using namespace dealii;

void Prestretch::read(ParameterSection &section)
{
  section.add("Axial prestretch", axial, Dimensions::none,
              "Length of the tube in the mesh over its stress-free length: the wall is stretched "
              "along the axis from the start.",
              Range::positive());
  add_angle(section, "Opening angle", opening_angle,
            "Angle by which a ring of this layer springs open when it is cut: its sector has 360 "
            "deg less this angle, and the mesh has the radii of the sector; beside Unloaded shape "
            "= inverse solve it has those of the loaded wall.");
  if (!(opening_angle < 2. * numbers::PI))
    section.refuse("Opening angle", "a ring that springs open by a full turn has no sector left",
                   "Give less than 360 deg");
}

double Prestretch::along(const double share) const
{
  return 1. + share * (1. / axial - 1.);
}

double Prestretch::around(const double share) const
{
  return 1. - share * opening_angle / (2. * numbers::PI);
}

Tensor<2, 3> Prestretch::inverse(const Tensor<1, 3> &axis,
                                 const Tensor<1, 3> &circumference,
                                 const double share) const
{
  return static_cast<Tensor<2, 3>>(unit_symmetric_tensor<3>()) +
         (1. / along(share) - 1.) * outer_product(axis, axis) +
         (1. / around(share) - 1.) * outer_product(circumference, circumference);
}

double Prestretch::volume_ratio(const double share) const
{
  return along(share) * around(share);
}
} // namespace Continua
