#include <continua/base/csv_table.h>
#include <continua/base/words.h>
#include <continua/vessel/tube_law.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Continua
{
namespace
{
/// The thesis's tubes, table A.3 [m].
namespace Thesis
{
constexpr double tube_length = 446e-3;
constexpr double wide_diameter = 25e-3;
constexpr double narrow_diameter = 12.5e-3;
constexpr double thick_wall = 0.1e-3;
constexpr double thin_wall = 0.05e-3;
} // namespace Thesis

/// In a function, so that it is there when another file's static data read parameters.
const std::vector<std::string> &law_names()
{
  static const std::vector<std::string> names = {"uniform", "taper", "table", "A", "B",
                                                 "C",       "D",     "E",     "F", "aorta"};
  return names;
}

bool is_thesis_tube(const std::string &law)
{
  return law.size() == 1;
}

std::function<double(double)> constant(const double value)
{
  return [value](const double) { return value; };
}

std::function<double(double)> line(const double length, const double begin, const double end)
{
  return [=](const double z) { return begin + (end - begin) * (z / length); };
}

/// The entries about the shape that a law has; the others are refused.
std::vector<std::string> entries_of(const std::string &law)
{
  if (law == "uniform")
    return {"Length", "Inner diameter", "Wall thickness"};
  if (law == "taper")
    return {"Length", "Inner diameter", "Wall thickness", "Outlet diameter",
            "Outlet wall thickness"};
  if (law == "table")
    return {"Table", "Interpolation"};
  if (law == "aorta")
    return {"Wall thickness"};
  return {};
}

void refuse_entries_of_other_laws(const ParameterSection &geometry, const std::string &law)
{
  const std::vector<std::string> wanted = entries_of(law);
  std::string list;
  for (const std::string &entry : wanted)
    list += (list.empty() ? "'" : ", '") + entry + "'";
  for (const char *const entry : {"Length", "Inner diameter", "Wall thickness", "Outlet diameter",
                                  "Outlet wall thickness", "Table", "Interpolation"})
    if (geometry.given(entry) && std::find(wanted.begin(), wanted.end(), entry) == wanted.end())
      geometry.refuse(entry, "Law = " + law + " has no such entry",
                      std::string("Remove the entry or choose another Law; this one has ") +
                          (list.empty() ? "its own dimensions" : list));
}
} // namespace

TubeLaw::TubeLaw() : TubeLaw(uniform(0.1, 0.02, 1e-3)) {}

TubeLaw::TubeLaw(const std::string &law,
                 const double length,
                 const Profile &diameter,
                 const Profile &thickness,
                 const bool uniform_everywhere)
    : law(law),
      length_as_made(length),
      diameter_as_made(diameter),
      thickness_as_made(thickness),
      uniform_everywhere(uniform_everywhere)
{
}

TubeLaw
TubeLaw::uniform(const double length, const double inner_diameter, const double wall_thickness)
{
  return TubeLaw("uniform", length, constant(inner_diameter), constant(wall_thickness), true);
}

TubeLaw TubeLaw::taper(const double length,
                       const double inlet_diameter,
                       const double outlet_diameter,
                       const double inlet_thickness,
                       const double outlet_thickness)
{
  return TubeLaw("taper", length, line(length, inlet_diameter, outlet_diameter),
                 line(length, inlet_thickness, outlet_thickness),
                 inlet_diameter == outlet_diameter && inlet_thickness == outlet_thickness);
}

TubeLaw TubeLaw::thesis(const char letter)
{
  Assert('A' <= letter && letter <= 'F', dealii::ExcInternalError());
  using namespace Thesis;
  const Profile wide = constant(wide_diameter);
  const Profile tapered = line(tube_length, wide_diameter, narrow_diameter);
  const std::string name(1, letter);
  switch (letter)
  {
  case 'A':
    return TubeLaw(name, tube_length, wide, constant(thick_wall), true);
  case 'B':
    return TubeLaw(name, tube_length, wide, constant(thin_wall), true);
  case 'C':
    return TubeLaw(
        name, tube_length, wide,
        [tapered](const double z) { return thin_wall * wide_diameter / tapered(z); }, false);
  case 'D':
    return TubeLaw(name, tube_length, tapered, constant(thick_wall), false);
  case 'E':
    return TubeLaw(name, tube_length, tapered, constant(thin_wall), false);
  default:
    return TubeLaw(
        name, tube_length, tapered,
        [tapered](const double z) { return thick_wall * tapered(z) / wide_diameter; }, false);
  }
}

TubeLaw TubeLaw::table(const std::vector<double> &positions,
                       const std::vector<double> &inner_diameters,
                       const std::vector<double> &wall_thicknesses,
                       const Interpolant::Kind interpolation)
{
  const auto is_constant = [](const std::vector<double> &values)
  {
    return std::all_of(values.begin(), values.end(),
                       [&values](const double value) { return value == values.front(); });
  };
  return TubeLaw("table", positions.back(), Interpolant(positions, inner_diameters, interpolation),
                 Interpolant(positions, wall_thicknesses, interpolation),
                 is_constant(inner_diameters) && is_constant(wall_thicknesses));
}

TubeLaw TubeLaw::read(ParameterSection geometry)
{
  std::string law = "uniform";
  geometry.add_choice("Law", law, law_names(),
                      "How the tube's inner diameter D and wall thickness h vary along its axis "
                      "x: 'uniform'; 'taper', both linear from the inlet to the outlet; 'table', "
                      "from a csv file; 'A' to 'F', the thesis's tubes of length 446 mm: A is D "
                      "= 25 mm, h = 0.1 mm; B is D = 25 mm, h = 0.05 mm; C is D = 25 mm, h from "
                      "0.05 to 0.1 mm, inversely as the D of E; D is D from 25 to 12.5 mm, h = "
                      "0.1 mm; E is D from 25 to 12.5 mm, h = 0.05 mm; F is D from 25 to 12.5 mm, "
                      "h from 0.1 to 0.05 mm, in proportion to D; 'aorta', D from 40 to 22 mm, "
                      "length 315 mm (Westerhof et al. 1969)");
  refuse_entries_of_other_laws(geometry, law);
  const WallLayers layers = WallLayers::read(geometry);
  const bool is_rigid = layers.names.empty();
  if (is_rigid)
    for (const char *const entry : {"Wall thickness", "Outlet wall thickness"})
      if (geometry.given(entry))
        geometry.refuse(entry, "the tube has no wall (Wall layers = none)",
                        "Remove the entry or name the layers");
  TubeLaw tube = read_law(geometry, law, is_rigid);

  double pre_strain = 0.;
  geometry.add("Axial pre-strain", pre_strain, Dimensions::none,
               "By how much the tube as made, which the other entries describe, is stretched along "
               "its axis before the experiment, over its length as made. It changes the geometry "
               "alone and leaves no stress: the length becomes (1 + e) times as large, diameter "
               "and wall thickness (1 + e)^(-1/2) times, as of a wall that keeps its volume [1]",
               Range{-1., std::numeric_limits<double>::infinity(), true, false});
  tube = tube.stretched(pre_strain);
  tube.set_layers(layers.names, layers.fractions);
  return tube;
}

TubeLaw TubeLaw::read_law(ParameterSection &geometry, const std::string &law, const bool is_rigid)
{
  if (is_thesis_tube(law))
    return thesis(law.front());
  if (law == "table")
    return read_table(geometry, is_rigid);
  if (law == "aorta")
  {
    // Without an entry only where the documentation of the entries is made.
    double thickness = std::numeric_limits<double>::quiet_NaN();
    geometry.add("Wall thickness", thickness, Dimensions::length,
                 "Thickness of the wall, all its layers together, the same everywhere; published "
                 "is Y h/D = 0.02 to 0.04 MPa with Young's modulus Y [m]",
                 Range::positive());
    if (!is_rigid)
      geometry.require("Wall thickness");
    TubeLaw tube = taper(315e-3, 40e-3, 22e-3, thickness, thickness);
    tube.law = law;
    return tube;
  }

  double length = 0.1;
  double diameter = 0.02;
  double thickness = 1e-3;
  geometry.add("Length", length, Dimensions::length, "Extent along the axis x [m]",
               Range::positive());
  geometry.add("Inner diameter", diameter, Dimensions::length,
               "Diameter of the fluid column; of a 'taper' at the inlet [m]", Range::positive());
  geometry.add("Wall thickness", thickness, Dimensions::length,
               "Thickness of the wall, all its layers together; of a 'taper' at the inlet [m]",
               Range::positive());
  if (law == "uniform")
    return uniform(length, diameter, thickness);

  // What is left out is as at the inlet.
  double outlet_diameter = std::numeric_limits<double>::quiet_NaN();
  double outlet_thickness = std::numeric_limits<double>::quiet_NaN();
  geometry.add("Outlet diameter", outlet_diameter, Dimensions::length,
               "Diameter of the fluid column at the outlet; as at the inlet if there is none [m]",
               Range::positive());
  geometry.add("Outlet wall thickness", outlet_thickness, Dimensions::length,
               "Thickness of the wall at the outlet; as at the inlet if there is none [m]",
               Range::positive());
  return taper(length, diameter, std::isnan(outlet_diameter) ? diameter : outlet_diameter,
               thickness, std::isnan(outlet_thickness) ? thickness : outlet_thickness);
}

TubeLaw TubeLaw::read_table(ParameterSection &geometry, const bool is_rigid)
{
  std::string path;
  Interpolant::Kind interpolation = Interpolant::Kind::linear;
  geometry.add_input_file(
      "Table", path,
      "A csv file with the header 'position [mm], inner diameter [mm], wall "
      "thickness [mm]' (units required, further columns are left out; a rigid "
      "tube needs no wall thickness). The positions increase from 0 at the inlet; the "
      "last one is the length");
  add_choice(geometry, "Interpolation", interpolation,
             {{"linear", Interpolant::Kind::linear}, {"cubic", Interpolant::Kind::cubic}},
             "Between the rows of the table; cubic is smooth and does not overshoot");
  geometry.require("Table");
  // Without a table only where the documentation of the entries is made.
  if (path.empty())
    return TubeLaw();

  const CsvTable file(path, is_rigid ? "position [mm], inner diameter [mm]"
                                     : "position [mm], inner diameter [mm], wall thickness [mm]");
  const std::size_t position_column = file.find("position");
  const std::size_t diameter_column = file.find("inner diameter");
  const std::vector<double> positions =
      file.increasing_values(position_column, Dimensions::length, "position", "larger");
  std::vector<std::pair<std::size_t, std::vector<double>>> columns = {
      {diameter_column, file.values(diameter_column, Dimensions::length)}};
  if (!is_rigid)
  {
    const std::size_t thickness_column = file.find("wall thickness");
    columns.emplace_back(thickness_column, file.values(thickness_column, Dimensions::length));
  }
  file.require_rows(2);
  if (positions.front() != 0.)
    file.refuse(0, position_column, "the first position is not 0",
                "Measure the positions from the inlet, and say how the tube is there");
  for (std::size_t row = 0; row < positions.size(); ++row)
    for (const auto &[column, values] : columns)
      if (values[row] <= 0.)
        file.refuse(row, column,
                    "the " + file.name(column) + " is not positive at the position " +
                        shortest_number(positions[row]) + " m",
                    "Give a positive one, or end the table before");
  return table(positions, columns.front().second,
               is_rigid ? std::vector<double>(positions.size(), 0.) : columns.back().second,
               interpolation);
}

void TubeLaw::set_layers(const std::vector<std::string> &names,
                         const std::vector<double> &fractions)
{
  Assert(names.size() == fractions.size(), dealii::ExcInternalError());
  layers = {names, fractions};
  if (is_rigid())
    thickness_as_made = constant(0.);
}

TubeLaw TubeLaw::stretched(const double pre_strain) const
{
  Assert(pre_strain > -1., dealii::ExcInternalError());
  TubeLaw tube = *this;
  tube.stretch *= 1. + pre_strain;
  return tube;
}

TubeLaw TubeLaw::as_made() const
{
  TubeLaw tube = *this;
  tube.stretch = 1.;
  return tube;
}

double TubeLaw::inner_diameter(const double z) const
{
  return diameter_as_made(z / stretch) / std::sqrt(stretch);
}

double TubeLaw::wall_thickness(const double z) const
{
  return thickness_as_made(z / stretch) / std::sqrt(stretch);
}
} // namespace Continua
