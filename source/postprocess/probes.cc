#include <continua/base/collective.h>
#include <continua/base/input_error.h>
#include <continua/base/parameter_text.h>
#include <continua/mesh/cell_point.h>
#include <continua/mesh/plane_section.h>
#include <continua/postprocess/name_choice.h>
#include <continua/postprocess/probes.h>

#include <continua/postprocess/writing_rank.h>
#include <continua/signal/last_periods.h>
#include <continua/signal/signal_analysis.h>
#include <deal.II/fe/mapping_q.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace Continua
{
namespace
{
/// The first row of probes.csv.
std::vector<std::string> header(const std::vector<std::string> &column_names)
{
  std::vector<std::string> names = {"time [s]"};
  names.insert(names.end(), column_names.begin(), column_names.end());
  return names;
}

/// The field of that name, or all components of the vector or tensor of that name.
std::vector<FieldComponent> expand(const ParameterSection &section,
                                   const std::string &word,
                                   const std::vector<FieldComponent> &fields)
{
  std::vector<FieldComponent> components;
  for (const FieldComponent &field : fields)
    if (field.name == word)
      return {field};
    else if (field.name.compare(0, word.size() + 1, word + " ") == 0)
      components.push_back(field);
  if (components.empty())
  {
    std::vector<std::string> names;
    for (const FieldComponent &field : fields)
      names.push_back(field.name);
    section.refuse("Fields", "there is no field '" + word + "'",
                   choices(word, names) +
                       "; without the component: all components of a vector or tensor");
  }
  return components;
}

/// The unit of a field integrated over a boundary, a section or a volume; in the plane, of a depth
/// of 1 m, over a line or an area.
std::string unit_of_integral(const std::string &unit, const Model model, const bool over_volume)
{
  Dimension dimension;
  unit_factor(unit, dimension);
  const bool is_plane = model == Model::plane_strain || model == Model::plane_stress;
  dimension.length += (over_volume ? 3 : 2) - (is_plane ? 1 : 0);
  return dimension.unit();
}

/// What a volume has beside the fields: by how much it has grown.
const std::string volume_change = "volume change";

/// What boundaries have beside the fields: the force of the body on them, by component.
template <int dim>
std::vector<FieldComponent> forces()
{
  const char *const names[] = {"force x", "force y", "force z"};
  std::vector<FieldComponent> components;
  for (unsigned int d = 0; d < dim; ++d)
    components.push_back({names[d], "Pa"});
  return components;
}

bool is_force(const std::string &field)
{
  return field == "force" || field.compare(0, 6, "force ") == 0;
}

/// Whether the region meets another one.
template <int dim>
bool has_interface(const dealii::Triangulation<dim> &coarse_mesh, const unsigned int region)
{
  for (const auto &cell : coarse_mesh.cell_iterators_on_level(0))
    if (cell->material_id() == region)
      for (const unsigned int f : cell->face_indices())
        if (!cell->at_boundary(f) && cell->neighbor(f)->material_id() != region)
          return true;
  return false;
}
} // namespace

template <int dim>
Probes<dim>::Probes(const MPI_Comm communicator)
    : communicator(communicator), run_table(communicator)
{
}

template <int dim>
const Words<typename Probes<dim>::Place> &Probes<dim>::place_words()
{
  static const Words<Place> words = {{"Point", Place::point},
                                     {"Boundary", Place::boundary},
                                     {"Section", Place::section},
                                     {"Volume", Place::volume},
                                     {"Stations", Place::stations}};
  return words;
}

template <int dim>
void Probes<dim>::read_entries(Probe &probe) const
{
  ParameterSection &section = probe.section;
  section.add("Fields", probe.fields,
              "What to record: fields (displacement y), or vectors and tensors with all their "
              "components (displacement)");
  section.add("Point", probe.point, Dimensions::length,
              "Coordinates of the point in the undeformed body [m]");
  section.add("Reference point", probe.reference_point, Dimensions::length,
              "Of a Point: another one, whose values are taken off, such as for a pressure drop "
              "[m]; empty: none");
  section.add("Boundary", probe.boundaries,
              "Instead of a point: names of boundaries. They have the further field 'force' with "
              "its components: the force of the body on what holds them, by the balance of forces "
              "at their nodes [N], in the plane of a metre of depth [N/m]");
  section.add(
      "Section", probe.position, Dimensions::length,
      "Instead of a point: the plane x = Section through the undeformed body, or its Region "
      "[m]");
  section.add(
      "Volume", probe.volume,
      "Instead of a point: name of a region, over the volume of which the fields are taken. "
      "It has the further field 'volume change': by how much the region has grown by the "
      "motion of its surface with other regions, such as a lumen by that of its wall "
      "[m^3]");
  probe.stations.add_entries(section);
  add_choice(section, "Value", probe.value, {{"mean", Value::mean}, {"integral", Value::integral}},
             "What to record of the fields on the boundary, section or volume, of which the "
             "integral is over the part that is modelled");
  section.add("Region", probe.region,
              "Whose side counts where a field jumps between regions; empty: any");
  section.add("Signal analysis", probe.signal_analysis,
              "Whether to look for maxima, frequency and decay in the histories at the end");
  section.add("Modes", probe.modes, Dimensions::frequency,
              "Frequencies near those of a sum of damped sines that is fitted to the histories "
              "[Hz]; empty: no such fit",
              Range::positive());
  section.add("Last periods", probe.last_periods,
              "How many periods at the end of the histories are analysed by themselves: mean, "
              "middle, amplitude and frequency of an oscillation that has settled [1]; 0: none",
              0);
}

template <int dim>
void Probes<dim>::check_entries(Probe &probe) const
{
  const ParameterSection &section = probe.section;
  if (probe.fields.empty())
    section.refuse("Fields", "the probe has no field", "Write for example 'set Fields = velocity'");
  std::vector<Place> places;
  if (!probe.point.empty())
    places.push_back(Place::point);
  if (!probe.boundaries.empty())
    places.push_back(Place::boundary);
  if (!std::isnan(probe.position))
    places.push_back(Place::section);
  if (!probe.volume.empty())
    places.push_back(Place::volume);
  if (probe.stations.given())
    places.push_back(Place::stations);
  if (places.size() != 1)
    section.refuse(places.empty() ? "" : word_of(place_words(), places.back()),
                   places.empty() ? "the probe has no place" : "the probe has more than one place",
                   "Give either Point or Boundary or Section or Volume or Stations");
  probe.place = places.front();
  if (probe.place == Place::point && probe.point.size() != dim)
    section.refuse("Point", "the point has " + std::to_string(probe.point.size()) + " coordinates",
                   "Give " + std::to_string(dim) + " of them, separated by commas");
  if (!probe.reference_point.empty() && probe.place != Place::point)
    section.refuse("Reference point", "the entry belongs to a Point", "Leave it out");
  if (!probe.reference_point.empty() && probe.reference_point.size() != dim)
    section.refuse("Reference point",
                   "the point has " + std::to_string(probe.reference_point.size()) + " coordinates",
                   "Give " + std::to_string(dim) + " of them, separated by commas");
  if (probe.place != Place::boundary &&
      std::any_of(probe.fields.begin(), probe.fields.end(),
                  [](const std::string &field) { return is_force(collapse_blanks(field)); }))
    section.refuse("Fields", "a force is that on a boundary",
                   "Give Boundary instead of " + word_of(place_words(), probe.place));
  if (asks_for_forces(probe))
    for (const char *key : {"Value", "Region"})
      if (section.given(key))
        section.refuse(key, "the force is that of the whole body on the whole boundary",
                       "Leave the entry out, and give other fields a probe of their own");
  if ((probe.place == Place::point || probe.place == Place::stations) && section.given("Value"))
    section.refuse("Value",
                   probe.place == Place::point
                       ? "a point has neither a mean nor an integral"
                       : "what is recorded at stations is said by the fields",
                   "Leave the entry out, or give Boundary, Section or Volume instead of " +
                       word_of(place_words(), probe.place));
  if (probe.place == Place::stations && section.given("Region"))
    section.refuse("Region", "the region of stations is the fluid", "Set Fluid instead");
  if (probe.place == Place::volume && section.given("Region"))
    section.refuse("Region", "the volume is that of a region already", "Leave the entry out");
  if (probe.place != Place::stations)
    for (const char *key : {"Branch", "Fluid", "Pair distance", "Pair", "Pulse direction"})
      if (section.given(key))
        section.refuse(key, "the entry belongs to Stations", "Leave it out");
  if (!probe.signal_analysis && !probe.modes.empty())
    section.refuse("Modes", "frequencies are fitted only in the signal analysis",
                   "Leave the entry out, or set Signal analysis = true");
  if (!probe.signal_analysis && probe.last_periods > 0)
    section.refuse("Last periods", "periods are looked for only in the signal analysis",
                   "Leave the entry out, or set Signal analysis = true");
}

template <int dim>
void Probes<dim>::read(ParameterSection section,
                       const std::vector<std::string> &boundaries,
                       const std::vector<std::string> &regions,
                       const std::vector<VesselBranch<dim>> &branches)
{
  for (const std::string &name : section.subsections())
  {
    const ParameterSection child = section.subsection(name);
    if (name.find('/') != std::string::npos)
      child.refuse("", "the name of a probe has a '/', which files cannot have in their names",
                   "Call it otherwise");
    Probe probe(child);
    read_entries(probe);
    check_entries(probe);

    using Kind = typename ProbeRequest<dim>::Kind;
    const bool mean = probe.value == Value::mean;
    if (probe.place == Place::point)
      for (unsigned int d = 0; d < dim; ++d)
      {
        probe.request.point[d] = probe.point[d];
        if (!probe.reference_point.empty())
          probe.reference[d] = probe.reference_point[d];
      }
    else if (probe.place == Place::boundary)
    {
      probe.request.kind = mean ? Kind::boundary_mean : Kind::boundary_integral;
      for (const std::string &boundary : probe.boundaries)
      {
        const std::string name = collapse_blanks(boundary);
        const unsigned int id = find_name(child, "Boundary", name, boundaries);
        if (!probe.request.boundary_ids.insert(id).second)
          child.refuse("Boundary", "'" + name + "' stands there twice", "Name it once");
        probe.names_of_boundaries[id] = name;
      }
    }
    else if (probe.place == Place::section)
    {
      probe.request.kind = mean ? Kind::section_mean : Kind::section_integral;
      probe.request.point[0] = probe.position;
    }
    else if (probe.place == Place::volume)
    {
      probe.request.kind = mean ? Kind::volume_mean : Kind::volume_integral;
      probe.request.region_ids = {find_name(child, "Volume", probe.volume, regions)};
    }
    else
    {
      const Stations<dim> &stations = probe.stations;
      probe.stations.set(child, probe.fields, regions, branches);
      stations_probes.push_back(
          {child, name, stations.positions(), stations.fields(), stations.branch(),
           stations.pair_distance(), stations.pair_offset(), stations.direction(),
           std::vector<std::vector<unsigned int>>(stations.positions().size())});
    }
    if (!probe.region.empty())
      probe.request.region_ids = {find_name(child, "Region", probe.region, regions)};
    probes.push_back(probe);
  }
}

template <int dim>
void Probes<dim>::attach(ContinuumSolver<dim> &continuum_solver, const Model model)
{
  solver = &continuum_solver;
  for (unsigned int p = 0; p < probes.size(); ++p)
    if (probes[p].stations.given())
      attach_stations(p);
    else
      attach_fields(p, model);
}

template <int dim>
unsigned int Probes<dim>::add_to_solver(const Probe &probe, const ProbeRequest<dim> &request)
{
  try
  {
    return solver->add_probe(request);
  }
  catch (const std::invalid_argument &error)
  {
    const std::map<Place, std::string> remedies = {
        {Place::point, "Give a point of the undeformed body, in the Region if there is one"},
        {Place::boundary,
         "Give a boundary on which the field exists, next to the Region if there is one"},
        {Place::section, "Give a position at which the plane cuts the body, or the Region"},
        {Place::volume, "Give a region that meets another one, or leave 'volume change' out"},
        {Place::stations, "Give positions inside the tube"}};
    probe.section.refuse(word_of(place_words(), probe.place), error.what(),
                         remedies.at(probe.place));
  }
}

template <int dim>
std::vector<FieldComponent> Probes<dim>::components(const Probe &probe,
                                                    const std::vector<FieldComponent> &fields)
{
  std::vector<FieldComponent> result;
  for (const std::string &word : probe.fields)
  {
    const std::string name = collapse_blanks(word);
    if (probe.place == Place::boundary && is_force(name))
    {
      for (const FieldComponent &force : expand(probe.section, name, forces<dim>()))
        result.push_back(force);
      continue;
    }
    if (probe.place == Place::volume && name == volume_change)
      result.push_back({volume_change, "1"});
    else
      for (const FieldComponent &field : expand(probe.section, name, fields))
        result.push_back(field);
  }
  for (std::size_t i = 0; i < result.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (result[j].name == result[i].name)
        probe.section.refuse("Fields", "'" + result[i].name + "' is recorded twice",
                             "Name every field once");
  return result;
}

template <int dim>
void Probes<dim>::attach_fields(const unsigned int p, const Model model)
{
  Probe &probe = probes[p];
  std::vector<FieldComponent> recorded = components(probe, solver->fields());
  for (FieldComponent &field : recorded)
  {
    ProbeRequest<dim> request = probe.request;
    request.field = field.name;
    if (field.name == volume_change)
      request.kind = ProbeRequest<dim>::Kind::volume_change;
    if (is_force(field.name))
    {
      request.kind = ProbeRequest<dim>::Kind::boundary_force;
      request.component = field.name.back() - 'x';
    }
    if (request.is_integral() || request.has_no_field())
      field.unit = unit_of_integral(field.unit, model, probe.place == Place::volume);
    std::vector<std::pair<unsigned int, double>> terms = {{add_to_solver(probe, request), 1.}};
    if (!probe.reference_point.empty())
    {
      request.point = probe.reference;
      terms.emplace_back(add_to_solver(probe, request), -1.);
    }
    columns.push_back({p, probe.section.name(), field, recorded.size() == 1, terms, {}});
  }
}

template <int dim>
void Probes<dim>::attach_stations(const unsigned int p)
{
  const Probe &probe = probes[p];
  const Stations<dim> &stations = probe.stations;
  StationsProbe &entry = *std::find_if(stations_probes.begin(), stations_probes.end(),
                                       [&probe](const StationsProbe &other)
                                       { return other.name == probe.section.name(); });
  for (const typename Stations<dim>::Column &column : stations.columns())
  {
    std::vector<std::pair<unsigned int, double>> terms;
    for (const auto &[request, factor] : column.terms)
      terms.emplace_back(add_to_solver(probe, request), factor);
    entry.columns[column.station].push_back(n_columns());
    columns.push_back({p,
                       entry.name + " " + stations.label(column.station),
                       column.field,
                       entry.fields.size() == 1,
                       terms,
                       {}});
  }
}

namespace
{
/// "x = 0 to 2 m, y = 0 to 1 m": between the vertices of the cells in the regions, all if there are
/// none.
template <int dim>
std::string extent(const dealii::Triangulation<dim> &coarse_mesh,
                   const std::set<unsigned int> &region_ids)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<std::pair<double, double>, dim> limits;
  limits.fill({infinity, -infinity});
  for (const auto &cell : coarse_mesh.cell_iterators_on_level(0))
    if (region_ids.empty() || region_ids.count(cell->material_id()) > 0)
      for (const unsigned int v : cell->vertex_indices())
        for (unsigned int d = 0; d < dim; ++d)
        {
          limits[d].first = std::min(limits[d].first, cell->vertex(v)[d]);
          limits[d].second = std::max(limits[d].second, cell->vertex(v)[d]);
        }
  std::ostringstream text;
  const char *const names[] = {"x = ", ", y = ", ", z = "};
  for (unsigned int d = 0; d < dim; ++d)
    text << names[d] << limits[d].first << " to " << limits[d].second << " m";
  return text.str();
}

/// High, since a coarse cell may stand for a large part of a circle.
constexpr unsigned int degree_of_coarse_cells = 6;
} // namespace

template <int dim>
bool Probes<dim>::asks_for_forces(const Probe &probe)
{
  return probe.place == Place::boundary &&
         std::any_of(probe.fields.begin(), probe.fields.end(),
                     [](const std::string &field) { return is_force(collapse_blanks(field)); });
}

template <int dim>
void Probes<dim>::check_forces(const std::vector<BoundaryCondition> &conditions,
                               const std::string &reason) const
{
  for (const Probe &probe : probes)
  {
    if (!asks_for_forces(probe))
      continue;
    if (!reason.empty())
      probe.section.refuse("Fields", "there is no field 'force': " + reason,
                           "Leave it out, or integrate the stress over the Boundary");
    for (const auto &[id, name] : probe.names_of_boundaries)
    {
      bool is_held = false;
      for (const BoundaryCondition &condition : conditions)
        is_held = is_held || (condition.boundary_id == id &&
                              (condition.normal.kind == BoundaryPart::Kind::velocity ||
                               condition.tangential.kind == BoundaryPart::Kind::velocity));
      if (!is_held)
        probe.section.refuse("Fields",
                             "nothing holds the boundary '" + name +
                                 "': the force there is the load that is given",
                             "Name boundaries with a prescribed velocity, such as 'fixed'");
    }
  }
}

template <int dim>
void Probes<dim>::check_point(const Probe &probe,
                              const std::string &entry,
                              const dealii::Point<dim> &point,
                              const dealii::Triangulation<dim> &coarse_mesh)
{
  const dealii::MappingQ<dim> mapping(degree_of_coarse_cells);
  const std::set<unsigned int> &region_ids = probe.request.region_ids;
  bool inside = false;
  dealii::Point<dim> unit_point;
  for (const auto &cell : coarse_mesh.cell_iterators_on_level(0))
    inside = inside || ((region_ids.empty() || region_ids.count(cell->material_id()) > 0) &&
                        cell_holds_point<dim>(mapping, cell, point, unit_point));
  if (!inside)
    probe.section.refuse(entry,
                         "the point is not inside the mesh, which extends over " +
                             extent(coarse_mesh, region_ids),
                         "Give a point of the undeformed body, in the Region if there is one");
}

template <int dim>
void Probes<dim>::check(const dealii::Triangulation<dim> &coarse_mesh,
                        const std::vector<FieldComponent> &fields,
                        const std::set<std::pair<unsigned int, unsigned int>> &boundary_regions)
{
  const dealii::MappingQ<dim> mapping(degree_of_coarse_cells);
  for (Probe &probe : probes)
  {
    if (probe.place == Place::stations)
    {
      if (std::none_of(fields.begin(), fields.end(),
                       [](const FieldComponent &field)
                       { return field.name == "radial displacement"; }))
        probe.section.refuse("Stations", "a plane model has no tube",
                             "Use Model = axisymmetric or three-dimensional, or a Section");
      probe.stations.check(probe.section, coarse_mesh);
      continue;
    }
    for (const FieldComponent &field : components(probe, fields))
      if (field.name == volume_change &&
          !has_interface(coarse_mesh, *probe.request.region_ids.begin()))
        probe.section.refuse(
            "Fields",
            "the region '" + probe.volume +
                "' meets no other one, whose motion could change its volume",
            "Leave 'volume change' out; the integral of 'dilatation' is the change "
            "of volume by strain");
    if (probe.place == Place::volume)
      continue;
    const std::set<unsigned int> &region_ids = probe.request.region_ids;
    if (probe.place == Place::boundary)
    {
      for (const auto &[id, name] : probe.names_of_boundaries)
        if (std::none_of(boundary_regions.begin(), boundary_regions.end(),
                         [&, boundary_id = id](const auto &pair) {
                           return pair.first == boundary_id &&
                                  (region_ids.empty() || region_ids.count(pair.second) > 0);
                         }))
          probe.section.refuse("Region", "the boundary '" + name + "' has no face in this region",
                               "Name a region that touches the boundary, or none");
    }
    else if (probe.place == Place::section)
    {
      if (PlaneSection<dim>(mapping, coarse_mesh, PlaneSection<dim>::Cells::coarse, region_ids,
                            probe.request.point, probe.request.normal, 2)
              .area() == 0.)
        probe.section.refuse("Section", "a section without area: the plane does not cut the body",
                             "Give a position at which it does, in the Region if there is one");
    }
    else
    {
      check_point(probe, "Point", probe.request.point, coarse_mesh);
      if (!probe.reference_point.empty())
        check_point(probe, "Reference point", probe.reference, coarse_mesh);
    }
  }
}

template <int dim>
void Probes<dim>::refuse_stresses_in(const std::set<unsigned int> &regions,
                                     const std::vector<FieldComponent> &fields) const
{
  const auto is_stress = [](const std::string &field)
  { return field.find("stress") != std::string::npos; };
  for (const Probe &probe : probes)
  {
    const std::set<unsigned int> &of_probe = probe.request.region_ids;
    const bool meets = of_probe.empty() || std::any_of(of_probe.begin(), of_probe.end(),
                                                       [&](const unsigned int region)
                                                       { return regions.count(region) > 0; });
    bool has_stress = std::any_of(probe.fields.begin(), probe.fields.end(), is_stress);
    if (probe.place != Place::stations)
      for (const FieldComponent &field : components(probe, fields))
        has_stress = has_stress || is_stress(field.name);
    if (meets && has_stress)
      probe.section.refuse("Fields",
                           "a probe has no stress of a liquid whose viscosity depends on the rate "
                           "of shear",
                           "Ask for the velocity, or name a 'Region' of another material; the "
                           "fields of the output have the stress");
  }
}

template <int dim>
std::vector<std::string> Probes<dim>::column_names() const
{
  std::vector<std::string> names;
  for (const Column &column : columns)
    names.push_back(column.name + ": " + column.field.name + " [" + column.field.unit + "]");
  return names;
}

template <int dim>
void Probes<dim>::open(const std::string &file)
{
  if (columns.empty())
    return;
  run_table.open(file, header(column_names()));
}

template <int dim>
void Probes<dim>::open(const std::string &file, const double restart_time)
{
  if (columns.empty())
    return;
  run_table.resume(file, header(column_names()), restart_time);
  on_writing_rank(communicator, [&]() { read_history(file); });
  record_times = broadcast(communicator, record_times);
  for (Column &column : columns)
    column.values = broadcast(communicator, column.values);
}

template <int dim>
void Probes<dim>::read_history(const std::string &file)
{
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    throw RunError("cannot continue '" + file + "': it cannot be read");
  std::string line;
  std::getline(stream, line); // the header, which the table writer has checked
  while (std::getline(stream, line))
  {
    const char *begin = line.data();
    const char *const end = begin + line.size();
    for (unsigned int i = 0; i <= columns.size(); ++i)
    {
      double value = 0.;
      const std::from_chars_result result = std::from_chars(begin, end, value);
      const bool complete =
          i < columns.size() ? result.ptr != end && *result.ptr == ',' : result.ptr == end;
      if (result.ec != std::errc() || !complete)
        throw RunError("cannot continue '" + file + "': the row '" + line + "' is damaged");
      (i == 0 ? record_times : columns[i - 1].values).push_back(value);
      begin = result.ptr + 1;
    }
  }
  if (stream.bad())
    throw RunError("cannot continue '" + file + "': it cannot be read");
}

template <int dim>
std::vector<double> Probes<dim>::present_values()
{
  if (columns.empty())
    return {};
  solver->evaluate_probes(solver_values);
  std::vector<double> values;
  for (const Column &column : columns)
  {
    double value = 0.;
    for (const auto &[number, factor] : column.terms)
      value += factor * solver_values[number];
    values.push_back(value);
  }
  return values;
}

template <int dim>
void Probes<dim>::record(const double time)
{
  if (columns.empty())
    return;
  const std::vector<double> values = present_values();
  record_times.push_back(time);
  row.assign(1, time);
  row.insert(row.end(), values.begin(), values.end());
  for (unsigned int i = 0; i < columns.size(); ++i)
    columns[i].values.push_back(values[i]);
  run_table.row(row);
}

template <int dim>
void Probes<dim>::add_quantities(const Column &column,
                                 Summary &summary,
                                 std::vector<std::string> &warnings) const
{
  const Probe &probe = probes[column.probe];
  const std::string &field = column.field.name;
  const std::string &unit = column.field.unit;
  const std::string label = column.name + (column.alone ? std::string() : ": " + field);
  const auto add = [&](const std::string &name, const double value, const std::string &unit_of_it)
  {
    if (!std::isnan(value))
      summary.add({name, value, unit_of_it, label});
  };

  if (record_times.size() > 1)
  {
    const SignalAnalysis signal = analyse_signal(record_times, column.values);
    add("maximum " + field, signal.maximum, unit);
    add("time of maximum " + field, signal.time_of_maximum, "s");
    add("minimum " + field, signal.minimum, unit);
    add("time of minimum " + field, signal.time_of_minimum, "s");
    add("first maximum " + field, signal.first_maximum, unit);
    add("time of first maximum " + field, signal.time_of_first_maximum, "s");
    add("mean " + field, signal.mean, unit);
    add("frequency", signal.frequency_zero_crossings, "Hz");
    add("frequency of the fit", signal.frequency_fit, "Hz");
    add("decay per oscillation", signal.decay_per_oscillation_fit, "1");
    add("fit residual", signal.fit_residual, "1");
  }
  add("final " + field, column.values.back(), unit);

  if (probe.last_periods > 0)
  {
    const LastPeriods periods =
        analyse_last_periods(record_times, column.values, probe.last_periods);
    const std::string of_periods = " of the last periods";
    add("mean " + field + of_periods, periods.mean, unit);
    add("middle " + field + of_periods, periods.middle, unit);
    add("amplitude " + field + of_periods, periods.amplitude, unit);
    add("frequency" + of_periods, periods.frequency, "Hz");
    add("change of amplitude" + of_periods, periods.change_of_amplitude, "1");
    if (std::isnan(periods.frequency))
      warnings.push_back("the history of " + field + " of the probe '" + column.name +
                         "' does not end with " + std::to_string(probe.last_periods) +
                         (probe.last_periods == 1 ? " period" : " periods of about one length"));
  }
  if (probe.modes.empty())
    return;
  // An offset, and four numbers a mode.
  const bool enough = record_times.size() > 1 + 4 * probe.modes.size();
  const DampedSineFit fit =
      enough ? fit_damped_sines(record_times, column.values, probe.modes) : DampedSineFit();
  if (!enough || !fit.converged)
  {
    warnings.push_back("the modes could not be fitted to " + field + " of the probe '" +
                       column.name +
                       "': " + (enough ? "the fit did not converge" : "it has too few rows"));
    return;
  }
  for (unsigned int m = 0; m < fit.components.size(); ++m)
  {
    const DampedSine &mode = fit.components[m];
    const std::string name = "mode " + std::to_string(m + 1);
    add(name + " frequency", mode.frequency, "Hz");
    add(name + " decay per oscillation", std::exp(-mode.decay_rate / mode.frequency), "1");
    add(name + " amplitude", mode.amplitude, unit);
  }
  add("modes offset", fit.offset, unit);
  add("modes residual", fit.residual, "1");
}

template <int dim>
void Probes<dim>::flush_to_disk()
{
  run_table.flush_to_disk();
}

template <int dim>
std::optional<WrittenTable> Probes<dim>::table() const
{
  return run_table.written();
}

template <int dim>
void Probes<dim>::flush()
{
  run_table.flush();
}

template <int dim>
std::vector<std::string> Probes<dim>::finish(Summary &summary)
{
  flush();
  std::vector<std::string> warnings;
  if (!record_times.empty())
    for (const Column &column : columns)
      if (probes[column.probe].signal_analysis)
        add_quantities(column, summary, warnings);
  return warnings;
}

template <int dim>
void Probes<dim>::name_quantities(const std::vector<FieldComponent> &fields,
                                  const bool at_rest,
                                  QuantityNames &names) const
{
  for (const Probe &probe : probes)
  {
    if (!probe.signal_analysis)
      continue;
    // As attach() makes them: the name of the probe or station, and the field.
    std::vector<std::pair<std::string, std::string>> recorded;
    if (probe.stations.given())
      for (const typename Stations<dim>::Column &column : probe.stations.columns())
        recorded.emplace_back(probe.section.name() + " " + probe.stations.label(column.station),
                              column.field.name);
    else
      for (const FieldComponent &field : components(probe, fields))
        recorded.emplace_back(probe.section.name(), field.name);
    const bool alone =
        probe.stations.given() ? probe.stations.fields().size() == 1 : recorded.size() == 1;
    for (const auto &[name, field] : recorded)
    {
      const std::string label = name + (alone ? std::string() : ": " + field);
      names.add("final " + field, label);
      if (at_rest)
        continue;
      for (const char *const what : {"maximum ", "time of maximum ", "minimum ", "time of minimum ",
                                     "first maximum ", "time of first maximum ", "mean "})
        names.add(what + field, label);
      for (const char *const what :
           {"frequency", "frequency of the fit", "decay per oscillation", "fit residual"})
        names.add(what, label);
      for (std::size_t m = 1; m <= probe.modes.size(); ++m)
        for (const char *const what : {" frequency", " decay per oscillation", " amplitude"})
          names.add("mode " + std::to_string(m) + what, label);
      if (probe.last_periods > 0)
      {
        for (const char *const what : {"mean ", "middle ", "amplitude "})
          names.add(what + field + " of the last periods", label);
        names.add("frequency of the last periods", label);
        if (probe.last_periods > 1)
          names.add("change of amplitude of the last periods", label);
      }
      if (!probe.modes.empty())
      {
        names.add("modes offset", label);
        names.add("modes residual", label);
      }
    }
  }
}

template class Probes<2>;
template class Probes<3>;
} // namespace Continua
