#include <continua/boundary/profile_table.h>

#include <continua/base/input_error.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
namespace
{
const char *const profile_example = "r [mm], U [m/s]";
/// Of the radius, by which a table may fall short of the rim.
constexpr double rim_slack = 1e-3;
/// Of the largest velocity, below which the mean is none that could be scaled.
constexpr double least_mean = 1e-6;

std::size_t velocity_column(const CsvTable &table, const std::string &name)
{
  if (table.n_columns() < 2)
    throw InputError(table.header(), "", "the header has one column, expected are r and U",
                     std::string("Write a first line such as '") + profile_example + "'");
  if (!name.empty())
    return table.find(name, 1);
  if (table.n_columns() > 2)
    throw InputError(table.header(), "", "there are several columns: " + table.names(1),
                     "Choose one with 'Profile column'");
  return 1;
}

std::string in_millimetres(const double length)
{
  std::string text = std::to_string(1e3 * length);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.')
    text.pop_back();
  return text + " mm";
}
} // namespace

ProfileTable::ProfileTable(const std::string &file,
                           const Interpolant::Kind kind,
                           const std::string &column)
    : table(file, profile_example)
{
  const std::size_t chosen = velocity_column(table, column);
  distances = table.increasing_values(0, Dimensions::length, "distance", "larger");
  const std::vector<double> velocities = table.values(chosen, Dimensions::velocity);
  table.require_rows(2);
  velocity = Interpolant(distances, velocities, kind);
}

void ProfileTable::check(const double radius, const bool is_channel) const
{
  const std::string section = is_channel ? "half of the gap is " : "the section has the radius ";
  if (has_two_sides() && !is_channel)
    table.refuse(0, 0, "a distance from the centre of a round section is negative",
                 "Give the distances from 0 to the radius");
  if (distances.back() < radius * (1. - rim_slack))
    table.refuse(table.n_rows() - 1, 0,
                 "the profile ends at " + in_millimetres(distances.back()) + ", " + section +
                     in_millimetres(radius),
                 "Add rows up to the wall, where the velocity is zero");
  const double first = has_two_sides() ? -radius : 0.;
  if (distances.front() > first + radius * rim_slack)
    table.refuse(0, 0,
                 "the profile begins at " + in_millimetres(distances.front()) + ", " + section +
                     in_millimetres(radius),
                 has_two_sides() ? "Add rows from the other wall on"
                                 : "Add rows from the centre, r = 0, on");
  double largest = 0.;
  for (const double distance : distances)
    largest = std::max(largest, std::abs(velocity(distance)));
  if (std::abs(mean(radius, is_channel)) <= least_mean * largest)
    table.refuse(table.n_rows() - 1, 1, "the profile lets nothing through the section",
                 "Give a profile whose mean is not zero: the flow rate scales it");
}

double ProfileTable::mean(const double radius, const bool is_channel) const
{
  // Exact between two rows: a cubic, times r.
  const dealii::QGauss<1> rule(3);
  std::vector<double> ends = {is_channel && has_two_sides() ? -radius : 0.};
  for (const double distance : distances)
    if (distance > ends.front() && distance < radius)
      ends.push_back(distance);
  ends.push_back(radius);
  double flow = 0., area = 0.;
  for (std::size_t i = 1; i < ends.size(); ++i)
    for (unsigned int q = 0; q < rule.size(); ++q)
    {
      const double length = ends[i] - ends[i - 1],
                   distance = ends[i - 1] + rule.point(q)[0] * length,
                   weight = rule.weight(q) * length * (is_channel ? 1. : distance);
      flow += weight * velocity(distance);
      area += weight;
    }
  return flow / area;
}

double ProfileTable::shape(const double distance, const double radius, const bool is_channel) const
{
  return velocity(has_two_sides() ? distance : std::abs(distance)) / mean(radius, is_channel);
}
} // namespace Continua
