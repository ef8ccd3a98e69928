#include <continua/postprocess/stations.h>

#include <continua/base/name_choice.h>
#include <continua/base/parameter_text.h>
#include <continua/base/unit_scale.h>
#include <continua/base/words.h>
#include <continua/mesh/cell_point.h>
#include <continua/mesh/plane_section.h>

#include <deal.II/base/numbers.h>
#include <deal.II/fe/mapping_q.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Continua
{
namespace
{
const std::vector<FieldComponent> station_fields = {
    {"pressure", "Pa"},          {"axis pressure", "Pa"},
    {"flow rate", "m^3/s"},      {"velocity integral", "m^3/s"},
    {"wall distension", "m"},    {"pressure gradient", "Pa/m"},
    {"wall shear stress", "Pa"}, {"hoop stress", "Pa"}};

/// A computed position in a message: to nanometres, without its round-off.
std::string rounded_metres(const double value)
{
  return named_value(std::round(1e9 * value) / 1e9, "m");
}
} // namespace

template <int dim>
void Stations<dim>::add_entries(ParameterSection section)
{
  section.add(
      "Stations", station_positions, Dimensions::length,
      "Instead of a point: positions along the axis of a tube in the undeformed body, from its "
      "inlet on (of a branch, from where it begins; of a body that is no vessel, on the x "
      "axis) [m]; the Fields are then among pressure (mean over the section), "
      "axis pressure, flow rate (by the balance of mass), velocity integral (over the "
      "section), wall distension (change of the inner diameter), pressure "
      "gradient, wall shear stress, hoop stress (mean over the wall)");
  section.add("Branch", branch_name,
              "With Stations, in a vessel that divides: the branch along whose axis they stand");
  section.add("Fluid", fluid, "With Stations: the region of the fluid; all others are the wall");
  section.add("Pair distance", distance, Dimensions::length,
              "With Stations: from the first to the second section of a pressure gradient [m]",
              Range::positive());
  add_choice(section, "Pair", pair, {{"centred", Pair::centred}, {"downstream", Pair::downstream}},
             "With Stations: where the two sections of a pressure gradient are: centred - half a "
             "Pair distance before and behind the station, the value belongs to the station; "
             "downstream - at the station and one Pair distance behind it, as two catheters that "
             "measure pressure and gradient at one time");
  add_choice(section, "Pulse direction", pulse_direction,
             {{"automatic", 0}, {"downstream", 1}, {"upstream", -1}},
             "With Stations: in which direction the first pulse passes them: automatic - away from "
             "the end that is loaded; downstream - from the inlet to the outlet; upstream - the "
             "other way, such as one half of a pulse from the middle of the tube");
}

template <int dim>
bool Stations<dim>::has(const std::string &field) const
{
  return std::find(field_names.begin(), field_names.end(), field) != field_names.end();
}

template <int dim>
void Stations<dim>::set(const ParameterSection &section,
                        const std::vector<std::string> &fields,
                        const std::vector<std::string> &regions,
                        const std::vector<VesselBranch<dim>> &branches)
{
  set_branch(section, branches);
  std::vector<std::string> known;
  for (const FieldComponent &field : station_fields)
    known.push_back(field.name);
  for (const std::string &word : fields)
  {
    const std::string field = collapse_blanks(word);
    if (std::find(known.begin(), known.end(), field) == known.end())
      section.refuse("Fields", "there is no field '" + field + "' at stations",
                     choices(field, known));
    if (has(field))
      section.refuse("Fields", "'" + field + "' is recorded twice", "Name every field once");
    field_names.push_back(field);
  }
  std::set<std::string> labels;
  for (unsigned int s = 0; s < station_positions.size(); ++s)
    if (!labels.insert(label(s)).second)
      section.refuse("Stations", "the station " + label(s) + " is given twice",
                     "Name every station once");
  for (unsigned int s = 1; s < station_positions.size(); ++s)
    if (station_positions[s] < station_positions[s - 1])
      section.refuse("Stations", "the station " + label(s) + " stands behind " + label(s - 1),
                     "List the stations from the inlet on");
  const unsigned int fluid_id = find_name(section, "Fluid", fluid, regions);
  for (unsigned int region = 0; region < regions.size(); ++region)
    (region == fluid_id ? fluid_ids : wall_ids).insert(region);
  if (has("hoop stress") && wall_ids.empty())
    section.refuse("Fields", "there is no wall whose hoop stress could be recorded",
                   "Leave 'hoop stress' out");
}

template <int dim>
void Stations<dim>::set_branch(const ParameterSection &section,
                               const std::vector<VesselBranch<dim>> &branches)
{
  std::vector<std::string> names;
  for (const VesselBranch<dim> &branch : branches)
    if (!branch.name.empty())
      names.push_back(branch.name);
  if (names.empty() && section.given("Branch"))
    section.refuse("Branch", "the geometry does not divide into branches", "Leave the entry out");
  if (!names.empty())
  {
    if (!section.given("Branch"))
      section.refuse("Stations", "the vessel divides, and its branches have an axis each",
                     "Add 'set Branch = ...': " + choices("", names));
    branch_index = find_name(section, "Branch", branch_name, names);
  }
  if (!branches.empty())
    axis = branches[branch_index].axis;
}

template <int dim>
std::array<double, 2> Stations<dim>::range(const dealii::Triangulation<dim> &coarse_mesh) const
{
  if (axis != nullptr)
    return axis->range();
  double begin = std::numeric_limits<double>::max(), end = -begin;
  for (const auto &cell : coarse_mesh.cell_iterators_on_level(0))
    if (fluid_ids.count(cell->material_id()) > 0)
      for (const unsigned int v : cell->vertex_indices())
      {
        begin = std::min(begin, cell->vertex(v)[0]);
        end = std::max(end, cell->vertex(v)[0]);
      }
  return {{begin, end}};
}

template <int dim>
void Stations<dim>::check(const ParameterSection &section,
                          const dealii::Triangulation<dim> &coarse_mesh)
{
  const auto [begin, end] = range(coarse_mesh);
  const double round_off = 1e-9 * (end - begin);
  const std::string range = "between " + rounded_metres(begin) + " and ";
  for (unsigned int s = 0; s < station_positions.size(); ++s)
  {
    const double position = station_positions[s];
    if (position < begin - round_off || position > end + round_off)
      section.refuse("Stations", "the station " + label(s) + " is outside the tube",
                     "Give positions " + range + rounded_metres(end));
    for (const double place : {position + pair_offset(), position + pair_offset() + distance})
      if (has("pressure gradient") && (place < begin - round_off || place > end + round_off))
        section.refuse("Stations",
                       "the pressure gradient at " + label(s) + " needs the section at " +
                           rounded_metres(place) + ", which is outside the tube",
                       "Give positions between " + rounded_metres(begin - pair_offset()) + " and " +
                           rounded_metres(end - distance - pair_offset()) +
                           ", or a shorter Pair distance");
  }

  // Of a high degree, since a coarse cell may stand for a large part of a circle.
  const dealii::MappingQ<dim> mapping(6);
  const auto place_of = [&](const double position)
  { return request(ProbeRequest<dim>::Kind::point, "", {}, position); };
  const auto is_cut = [&](const std::set<unsigned int> &region_ids, const double position)
  {
    const ProbeRequest<dim> place = place_of(position);
    return PlaneSection<dim>::exists(mapping, coarse_mesh, region_ids, place.point, place.normal,
                                     axis.get());
  };
  for (unsigned int s = 0; s < station_positions.size(); ++s)
  {
    const double position = station_positions[s];
    if (!is_cut(fluid_ids, position))
      section.refuse("Stations", "a section without area: there is no fluid at " + label(s),
                     "Give positions at which the plane cuts the fluid");
    if (has("hoop stress") && !is_cut(wall_ids, position))
      section.refuse("Fields", "there is no wall at " + label(s),
                     "Leave 'hoop stress' out, or the station");
    if (has("axis pressure"))
    {
      const ProbeRequest<dim> place = place_of(position);
      dealii::Point<dim> unit_point;
      bool inside = false;
      for (const auto &cell : coarse_mesh.cell_iterators_on_level(0))
        inside = inside || (fluid_ids.count(cell->material_id()) > 0 &&
                            cell_holds_point<dim>(mapping, cell, place.point, unit_point));
      if (!inside)
        section.refuse("Fields", "the axis is not in the fluid at " + label(s),
                       "Leave 'axis pressure' out, or the station");
    }
  }
  if (dim == 2)
    return;
  // The angle that the rim subtends at the axis, by Gauss's law in the plane.
  double angle = 0.;
  const ProbeRequest<dim> first = place_of(station_positions.front());
  const PlaneSection<dim> cut(mapping, coarse_mesh, PlaneSection<dim>::Cells::coarse, fluid_ids,
                              first.point, first.normal, 6, axis.get());
  for (const auto &part : cut.outer_rim())
    for (unsigned int q = 0; q < part.points.size(); ++q)
    {
      dealii::Tensor<1, dim> radial = part.points[q] - first.point;
      radial -= (radial * first.normal) * first.normal;
      angle += part.quadrature.weight(q) * (part.normals[q] * radial) / radial.norm_square();
    }
  if (angle > 0.)
    n_copies = 2. * dealii::numbers::PI / angle;
  // A half, a quarter, ... up to the error of the quadrature.
  if (std::abs(n_copies - std::round(n_copies)) < 0.01)
    n_copies = std::round(n_copies);
}

template <int dim>
ProbeRequest<dim> Stations<dim>::request(const typename ProbeRequest<dim>::Kind kind,
                                         const std::string &field,
                                         const std::set<unsigned int> &region_ids,
                                         const double position) const
{
  ProbeRequest<dim> result;
  result.kind = kind;
  result.field = field;
  result.point[0] = position;
  if (axis != nullptr)
  {
    result.point = axis->point(position);
    result.normal = axis->tangent(position);
    result.axis = axis;
  }
  result.region_ids = region_ids;
  return result;
}

template <int dim>
std::vector<typename Stations<dim>::Column> Stations<dim>::columns() const
{
  using Kind = typename ProbeRequest<dim>::Kind;
  std::vector<Column> result;
  for (unsigned int s = 0; s < station_positions.size(); ++s)
    for (const std::string &name : field_names)
    {
      const double x = station_positions[s];
      const auto field =
          std::find_if(station_fields.begin(), station_fields.end(),
                       [&name](const FieldComponent &other) { return other.name == name; });
      Column column{s, *field, {}, {}, {}};
      const auto add = [&](const Kind kind, const std::string &solver_field,
                           const std::set<unsigned int> &region_ids, const double position,
                           const double factor)
      { column.terms.emplace_back(request(kind, solver_field, region_ids, position), factor); };
      if (name == "pressure")
        add(Kind::section_mean, name, fluid_ids, x, 1.);
      else if (name == "axis pressure")
        add(Kind::point, "pressure", fluid_ids, x, 1.);
      else if (name == "flow rate")
        add(Kind::section_flow, "", fluid_ids, x, n_copies);
      else if (name == "velocity integral")
        add(Kind::section_integral, "axial velocity", fluid_ids, x, n_copies);
      else if (name == "wall distension")
        add(Kind::rim_mean, "radial displacement", fluid_ids, x, 2.);
      else if (name == "pressure gradient")
      {
        const double first = x + pair_offset();
        add(Kind::section_mean, "pressure", fluid_ids, first + distance, 1. / distance);
        add(Kind::section_mean, "pressure", fluid_ids, first, -1. / distance);
        const auto movement = [&](const std::string &of_component, const double position)
        { return request(Kind::section_mean, of_component, fluid_ids, position); };
        column.line = movement("", first + distance).point - movement("", first).point;
        for (const std::string of_component :
             {"displacement x", "displacement y", "displacement z"})
          if (column.movements.size() < dim)
            column.movements.push_back({{movement(of_component, first + distance), 1.},
                                        {movement(of_component, first), -1.}});
      }
      else if (name == "wall shear stress")
        add(Kind::rim_mean, name, fluid_ids, x, 1.);
      else
        add(Kind::section_mean, "hoop stress", wall_ids, x, 1.);
      result.push_back(column);
    }
  return result;
}

template <int dim>
std::string Stations<dim>::label(const unsigned int station) const
{
  return named_value(station_positions[station], "m");
}

template class Stations<2>;
template class Stations<3>;
} // namespace Continua
