#include <continua/vessel/spin_coating.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
using dealii::numbers::PI;

namespace
{
/// A.2: of a truncated cone [m^3].
double cone_volume(const double first_diameter, const double last_diameter, const double length)
{
  return PI * length / 12. *
         (first_diameter * first_diameter + first_diameter * last_diameter +
          last_diameter * last_diameter);
}
} // namespace

SpinCoating SpinCoating::read(ParameterSection section)
{
  SpinCoating coating;
  section.add("Rod counts", coating.rod_counts,
              "Counts that the servomotor of the turning rod makes in one turn", 1);
  section.add("Trolley counts", coating.trolley_counts,
              "Counts that the servomotor of the trolley's ball screw makes in one turn", 1);
  section.add("Screw pitch", coating.screw_pitch, Dimensions::length,
              "How far the trolley moves in one turn of its ball screw [m]", Range::positive());
  section.add("Stripe distance", coating.stripe_distance, Dimensions::length,
              "Distance along the rod between neighbouring turns of the spiral; stripes about 3 mm "
              "wide merge if it is less [m]",
              Range::positive());
  section.add("Concentration", coating.concentration, Dimensions::none,
              "Volume of the dry wall over that of the solution it is made of [1]",
              Range{0., 1., true, false});
  section.add("Flow rate", coating.flow_rate, Dimensions::flow_rate,
              "Solution that the pump gives [m^3/s]", Range::positive());
  section.add("Position increment", coating.increment, Dimensions::length,
              "Distance between the rows of the table, at most [m]", Range::positive());
  return coating;
}

double SpinCoating::tapered_volume(const double first_diameter,
                                   const double last_diameter,
                                   const double first_thickness,
                                   const double last_thickness,
                                   const double length) const
{
  return (cone_volume(first_diameter + 2. * first_thickness, last_diameter + 2. * last_thickness,
                      length) -
          cone_volume(first_diameter, last_diameter, length)) /
         concentration;
}

double SpinCoating::duration(const double volume) const
{
  return volume / flow_rate;
}

double SpinCoating::trolley_velocity(const double diameter, const double thickness) const
{
  return flow_rate * concentration / (PI * diameter * thickness);
}

double SpinCoating::trolley_speed(const double diameter, const double thickness) const
{
  return trolley_velocity(diameter, thickness) * trolley_counts / screw_pitch;
}

double SpinCoating::rod_speed(const double diameter, const double thickness) const
{
  return trolley_velocity(diameter, thickness) * rod_counts / stripe_distance;
}

std::vector<SpinCoating::Row> SpinCoating::table(const TubeLaw &law) const
{
  const TubeLaw tube = law.as_made();
  const unsigned int n_increments =
      std::max(1u, static_cast<unsigned int>(std::ceil(tube.length() / increment * (1. - 1e-12))));
  std::vector<Row> rows;
  double sum = 0.;
  for (unsigned int i = 0; i <= n_increments; ++i)
  {
    const double z = tube.length() * i / n_increments;
    const double diameter = tube.inner_diameter(z);
    const double thickness = tube.wall_thickness(z);
    if (i > 0)
      sum += tapered_volume(rows.back().diameter, diameter, rows.back().thickness, thickness,
                            z - rows.back().position);
    rows.push_back({z, diameter, thickness, trolley_speed(diameter, thickness),
                    rod_speed(diameter, thickness), sum, duration(sum)});
  }
  return rows;
}
} // namespace Continua
