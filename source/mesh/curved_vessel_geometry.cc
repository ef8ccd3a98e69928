#include <continua/base/csv_table.h>
#include <continua/base/words.h>
#include <continua/mesh/curved_vessel_geometry.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace Continua
{
namespace
{
/// What points may stand out of a plane, over the length of the line, to lie in it.
constexpr double plane_tolerance = 1e-6;
/// In how many directions from the line its distance from other parts of the vessel is looked at.
constexpr unsigned int n_directions = 16;

const char *const example_header = "x [mm], y [mm], z [mm], inner radius [mm], wall thickness [mm]";

/// The table's columns in SI.
struct Rows
{
  std::vector<Centreline::Point> points;
  std::vector<double> inner_radii, wall_thicknesses;
};

Rows read_rows(const CsvTable &table, const bool is_rigid)
{
  std::array<std::vector<double>, 3> coordinates;
  const char *const names[] = {"x", "y", "z"};
  for (unsigned int d = 0; d < 3; ++d)
    coordinates[d] = table.values(table.find(names[d]), Dimensions::length);
  Rows rows;
  const std::size_t radius_column = table.find("inner radius");
  rows.inner_radii = table.values(radius_column, Dimensions::length);
  rows.wall_thicknesses.assign(table.n_rows(), 0.);
  std::vector<std::pair<std::size_t, const std::vector<double> *>> columns = {
      {radius_column, &rows.inner_radii}};
  if (!is_rigid)
  {
    const std::size_t thickness_column = table.find("wall thickness");
    rows.wall_thicknesses = table.values(thickness_column, Dimensions::length);
    columns.emplace_back(thickness_column, &rows.wall_thicknesses);
  }
  table.require_rows(2);
  for (std::size_t row = 0; row < table.n_rows(); ++row)
  {
    for (const auto &[column, values] : columns)
      if ((*values)[row] <= 0.)
        table.refuse(row, column, "the " + table.name(column) + " is not positive",
                     "Give a positive one, or end the table before");
    rows.points.emplace_back(coordinates[0][row], coordinates[1][row], coordinates[2][row]);
    if (row == 0)
      continue;
    const auto step = rows.points[row] - rows.points[row - 1];
    if (step.norm() == 0.)
      table.refuse(row, table.n_columns(), "the point is that of the row before",
                   "Remove one of the two rows");
    if (row > 1 && step * (rows.points[row - 1] - rows.points[row - 2]) <= 0.)
      table.refuse(row, table.n_columns(),
                   "from here the line goes back: it turns by more than 90 degrees in one point",
                   "List the points in their order along the vessel, and a tight bend by more of "
                   "them");
  }
  return rows;
}

/// The row of the table's point that is nearest to a position.
std::size_t row_at(const Centreline &centreline, const double position)
{
  const std::vector<double> &rows = centreline.positions_of_points();
  std::size_t nearest = 0;
  for (std::size_t row = 1; row < rows.size(); ++row)
    if (std::abs(rows[row] - position) < std::abs(rows[nearest] - position))
      nearest = row;
  return nearest;
}

double outer_radius(const TubeLaw &law, const double position)
{
  return 0.5 * law.inner_diameter(position) + law.wall_thickness(position);
}

std::string millimetres(const double value)
{
  std::ostringstream text;
  text.precision(4);
  text << 1e3 * value << " mm";
  return text.str();
}

void refuse_tight_bends(const CsvTable &table, const Centreline &centreline, const TubeLaw &law)
{
  double tightest = 0., place = 0.;
  for (const double position : centreline.samples())
  {
    const double bend = outer_radius(law, position) * centreline.curvature(position);
    if (bend > tightest)
    {
      tightest = bend;
      place = position;
    }
  }
  if (tightest > CurvedVesselGeometry::largest_bend)
    table.refuse(row_at(centreline, place), table.n_columns(),
                 "the bend folds the cells: its radius is " +
                     millimetres(1. / centreline.curvature(place)) + " " + millimetres(place) +
                     " from the inlet, where the vessel with its wall has the radius " +
                     millimetres(outer_radius(law, place)),
                 "Give a wider bend, a thinner wall or a smaller radius: the vessel's radius is at "
                 "most " +
                     shortest_number(CurvedVesselGeometry::largest_bend) +
                     " of the bend's. Points that scatter make bends, too: smooth them");
}

void refuse_contact(const CsvTable &table, const Centreline &centreline, const TubeLaw &law)
{
  const std::vector<double> &samples = centreline.samples();
  std::vector<Centreline::Frame> frames;
  std::vector<double> radii;
  for (const double position : samples)
  {
    frames.push_back(centreline.frame(position));
    radii.push_back(outer_radius(law, position));
  }
  for (std::size_t i = 0; i < samples.size(); ++i)
    for (std::size_t j = i + 1; j < samples.size(); ++j)
    {
      // Nearer along the line are the neighbours in one bend, which was looked at before.
      if (samples[j] - samples[i] < 1.5 * (radii[i] + radii[j]) ||
          frames[i].point.distance(frames[j].point) > radii[i] + radii[j])
        continue;
      for (unsigned int k = 0; k < n_directions; ++k)
      {
        const double angle = 2. * dealii::numbers::PI * k / n_directions;
        const Centreline::Point on_surface =
            frames[i].point +
            radii[i] * (std::cos(angle) * frames[i].normal + std::sin(angle) * frames[i].binormal);
        if (on_surface.distance(frames[j].point) < radii[j])
          table.refuse(row_at(centreline, samples[j]), table.n_columns(),
                       "the vessel lies in itself: its wall " + millimetres(samples[i]) +
                           " from the inlet is inside that " + millimetres(samples[j]) + " from it",
                       "Lead the line apart, or give smaller radii");
      }
    }
}

bool lies_in_a_plane(const Centreline &centreline, const std::vector<Centreline::Point> &points)
{
  const Centreline::Frame begin = centreline.frame(0.);
  return std::all_of(points.begin(), points.end(),
                     [&](const Centreline::Point &point)
                     {
                       return std::abs((point - begin.point) * begin.binormal) <
                              plane_tolerance * centreline.length();
                     });
}
} // namespace

CurvedVesselGeometry::Parameters CurvedVesselGeometry::Parameters::read(ParameterSection geometry,
                                                                        ParameterSection mesh)
{
  Parameters parameters;
  std::string path;
  Interpolant::Kind interpolation = Interpolant::Kind::cubic;
  geometry.add_input_file(
      "Table", path,
      std::string("A csv file with the header '") + example_header +
          "' (units required, further columns are left out): points of the vessel's axis in their "
          "order from the inlet to the outlet, through which a smooth line is laid, with the "
          "radius of the fluid and the thickness of the wall there; a rigid vessel needs no wall "
          "thickness");
  add_choice(geometry, "Interpolation", interpolation,
             {{"linear", Interpolant::Kind::linear}, {"cubic", Interpolant::Kind::cubic}},
             "Of radius and thickness between the rows of the table, over the length of the line; "
             "cubic is smooth and does not overshoot");
  geometry.require("Table");
  using Sector = TubeCrossSection::Sector;
  parameters.sector = Sector::full;
  add_choice(geometry, "Sector", parameters.sector,
             {{"half", Sector::half}, {"full", Sector::full}},
             "Which part of the vessel there is: all of it, or, if its axis lies in a plane, the "
             "half on one side of that plane, which is the boundary 'side z'; a flow that is "
             "symmetric about it has Type = roller there");
  const WallLayers layers = WallLayers::read(geometry);
  // Without a table only where the documentation of the entries is made.
  if (!path.empty())
  {
    const CsvTable table(path, example_header);
    const Rows rows = read_rows(table, layers.names.empty());
    const auto centreline = std::make_shared<const Centreline>(rows.points);
    std::vector<double> diameters;
    for (const double radius : rows.inner_radii)
      diameters.push_back(2. * radius);
    parameters.law = TubeLaw::table(centreline->positions_of_points(), diameters,
                                    rows.wall_thicknesses, interpolation);
    parameters.centreline = centreline;
    refuse_tight_bends(table, *centreline, parameters.law);
    refuse_contact(table, *centreline, parameters.law);
    if (parameters.sector == Sector::half && !lies_in_a_plane(*centreline, rows.points))
      geometry.refuse("Sector",
                      "the vessel's axis does not lie in a plane, so that no half of it "
                      "is the mirror image of the other",
                      "Use 'full'");
  }
  parameters.law.set_layers(layers.names, layers.fractions);
  parameters.read_mesh(mesh);
  return parameters;
}
} // namespace Continua
