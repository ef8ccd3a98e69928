#include <continua/postprocess/probe_entries.h>

#include <continua/base/input_error.h>
#include <continua/base/joined.h>
#include <continua/base/name_choice.h>
#include <continua/base/parameter_text.h>
#include <continua/continuum/field_list.h>
#include <continua/mesh/cell_point.h>
#include <continua/mesh/plane_section.h>

#include <deal.II/fe/mapping_q.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <sstream>
#include <string>

namespace Continua
{
namespace
{
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
    names.reserve(fields.size());
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

/// What the surface of a cavity has beside the fields.
const std::string cavity_pressure = "cavity pressure", cavity_volume = "cavity volume";

bool is_of_cavity(const std::string &field)
{
  return field == cavity_pressure || field == cavity_volume;
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

bool is_average(const std::string &field)
{
  return field == "time-averaged wall shear stress" || field == "oscillatory shear index";
}

/// Whether the field has a sign, and is evaluated point by point.
bool can_change_sign(const std::string &field)
{
  for (const char *const family :
       {"velocity ", "radial velocity", "axial velocity", "pressure", "stress ", "hoop stress",
        "wall shear stress", "vorticity ", "Q criterion"})
    if (field.compare(0, std::string(family).size(), family) == 0)
      return true;
  return false;
}
} // namespace

template <int dim>
const Words<typename ProbeEntries<dim>::Place> &ProbeEntries<dim>::place_words()
{
  static const Words<Place> words = {
      {"Point", Place::point},     {"Boundary", Place::boundary}, {"Interface", Place::interface},
      {"Section", Place::section}, {"Volume", Place::volume},     {"Stations", Place::stations}};
  return words;
}

template <int dim>
void ProbeEntries<dim>::read_entries()
{
  section.add("Fields", fields,
              "What to record: fields (displacement y), or vectors and tensors with all their "
              "components (displacement)");
  section.add("Point", point, Dimensions::length,
              "Coordinates of the point in the undeformed body [m]");
  section.add("Reference point", reference_point, Dimensions::length,
              "Of a Point: another one, whose values are taken off, such as for a pressure drop "
              "[m]; empty: none");
  section.add("Moves with mesh", moves_with_mesh,
              "Of a Point with Deformation = finite: whether it goes with the mesh, which is with "
              "matter in solids, or stays where it is in space; the values are then nan while the "
              "body, or its Region, is elsewhere");
  section.add(
      "Boundary", boundaries,
      "Instead of a point: names of boundaries. They have the further fields 'force' with "
      "its components (the force of the body on what holds them, by the balance of forces "
      "at their nodes or faces [N], in the plane of a metre of depth [N/m]), 'wall shear stress x' "
      "and other components (tangential part of the traction of the body on the wall), "
      "'magnitude of wall shear stress', 'time-averaged wall shear stress' and "
      "'oscillatory shear index' (of the window in Output). Of Type = cavity: 'cavity pressure' "
      "[Pa] and 'cavity volume' (of the part that is modelled [m^3], in the plane [m^2])");
  section.add(
      "Reference boundary", reference_boundaries,
      "Of a Boundary: names of other ones, whose mean or integral is taken off, such as for "
      "a pressure drop; empty: none");
  section.add(
      "Interface", interface,
      "Instead of a point: the names of two regions that meet. Values are those of the side "
      "of the first region, which has the further fields of a Boundary there; its force is "
      "that of the first region on the second, and with a Boundary beside it that on both, such as "
      "of a flow on a cylinder and the beam behind it. Or the name of an interface, which a mesh "
      "of gmsh may give: values are then those of the side of Region");
  section.add(
      "Section", position, Dimensions::length,
      "Instead of a point: the plane x = Section through the undeformed body, or its Region "
      "[m]");
  section.add("Reference section", reference_position, Dimensions::length,
              "Of a Section: another one, whose mean or integral is taken off [m]");
  section.add(
      "Volume", volume,
      "Instead of a point: name of a region, over the volume of which the fields are taken. "
      "It has the further field 'volume change': by how much the region has grown by the "
      "motion of its surface with other regions, such as a lumen by that of its wall "
      "[m^3]");
  stations.add_entries(section);
  add_choice(section, "Value", value, {{"mean", Value::mean}, {"integral", Value::integral}},
             "What to record of the fields on the boundary, interface, section or volume, of which "
             "the integral is over the part that is modelled");
  section.add(
      "Sign changes", n_sign_changes,
      "Of a Boundary or an Interface in two dimensions: how many positions to record at "
      "which the field changes its sign, in the place of its mean, such as those of "
      "separation and reattachment by 'wall shear stress x' [1]; nan where there are fewer");
  add_choice(section, "Sign changes along", sign_change_coordinate, {{"x", 0u}, {"y", 1u}},
             "The coordinate of these positions, in the order of which they are counted");
  section.add("Sign changes between", sign_change_range, Dimensions::length,
              "Two coordinates between which they are looked for [m]; empty: everywhere");
  section.add("Region", region,
              "Whose side counts where a field jumps between regions; empty: any");
  section.add("Signal analysis", signal_analysis,
              "Whether to look for maxima, frequency and decay in the histories at the end");
  section.add("Modes", modes, Dimensions::frequency,
              "Frequencies near those of a sum of damped sines that is fitted to the histories "
              "[Hz]; empty: no such fit",
              Range::positive());
  section.add("Last periods", last_periods,
              "How many periods at the end of the histories are analysed by themselves: mean, "
              "middle, amplitude and frequency of an oscillation that has settled [1]; 0: none",
              0);
}

template <int dim>
void ProbeEntries<dim>::check_entries()
{
  if (fields.empty())
    section.refuse("Fields", "the probe has no field", "Write for example 'set Fields = velocity'");
  set_place();
  if (place == Place::point && point.size() != dim)
    section.refuse("Point", "the point has " + std::to_string(point.size()) + " coordinates",
                   "Give " + std::to_string(dim) + " of them, separated by commas");
  if (place != Place::point && section.given("Moves with mesh"))
    section.refuse("Moves with mesh", "the entry belongs to a Point",
                   "Leave it out: " + word_of(place_words(), place) + " goes with the mesh");
  check_reference();
  check_sign_changes();
  if (place == Place::interface && !boundaries.empty() &&
      !std::all_of(fields.begin(), fields.end(),
                   [](const std::string &field) { return is_force(collapse_blanks(field)); }))
    section.refuse("Boundary", "beside an Interface a Boundary counts for the force alone",
                   "Give other fields a probe of their own");
  if (!is_on_wall() &&
      std::any_of(fields.begin(), fields.end(),
                  [](const std::string &field) { return is_force(collapse_blanks(field)); }))
    section.refuse("Fields", "a force is that on a boundary",
                   "Give Boundary instead of " + word_of(place_words(), place));
  const bool names_interface = place == Place::interface && interface.size() == 1;
  if (asks_for_forces())
    for (const char *key : {"Value", "Region", "Reference boundary", "Sign changes"})
      if (section.given(key) && !(names_interface && key == std::string("Region")))
        section.refuse(key, "the force is that of the whole body on the whole boundary",
                       "Leave the entry out, and give other fields a probe of their own");
  if ((place == Place::point || place == Place::stations) && section.given("Value"))
    section.refuse("Value",
                   place == Place::point ? "a point has neither a mean nor an integral"
                                         : "what is recorded at stations is said by the fields",
                   "Leave the entry out, or give Boundary, Section or Volume instead of " +
                       word_of(place_words(), place));
  if (place == Place::stations && section.given("Region"))
    section.refuse("Region", "the region of stations is the fluid", "Set Fluid instead");
  if (place == Place::interface && !names_interface && section.given("Region"))
    section.refuse("Region", "the side of an interface is that of its first region",
                   "Leave the entry out");
  if (place == Place::volume && section.given("Region"))
    section.refuse("Region", "the volume is that of a region already", "Leave the entry out");
  if (place != Place::stations)
    for (const char *key : {"Branch", "Fluid", "Pair distance", "Pair", "Pulse direction"})
      if (section.given(key))
        section.refuse(key, "the entry belongs to Stations", "Leave it out");
  if (!signal_analysis && !modes.empty())
    section.refuse("Modes", "frequencies are fitted only in the signal analysis",
                   "Leave the entry out, or set Signal analysis = true");
  if (!signal_analysis && last_periods > 0)
    section.refuse("Last periods", "periods are looked for only in the signal analysis",
                   "Leave the entry out, or set Signal analysis = true");
}

template <int dim>
void ProbeEntries<dim>::set_place()
{
  std::vector<Place> places;
  if (!point.empty())
    places.push_back(Place::point);
  // Beside an interface boundaries count for the force, see check_entries().
  if (!boundaries.empty() && interface.empty())
    places.push_back(Place::boundary);
  if (!interface.empty())
    places.push_back(Place::interface);
  if (!std::isnan(position))
    places.push_back(Place::section);
  if (!volume.empty())
    places.push_back(Place::volume);
  if (stations.given())
    places.push_back(Place::stations);
  if (places.size() != 1)
    section.refuse(places.empty() ? "" : word_of(place_words(), places.back()),
                   places.empty() ? "the probe has no place" : "the probe has more than one place",
                   "Give either Point or Boundary or Interface or Section or Volume or Stations");
  place = places.front();
}

template <int dim>
void ProbeEntries<dim>::check_reference() const
{
  const std::array<std::pair<Place, bool>, 3> references = {
      {{Place::point, !reference_point.empty()},
       {Place::boundary, !reference_boundaries.empty()},
       {Place::section, !std::isnan(reference_position)}}};
  for (const auto &[of_place, is_given] : references)
  {
    std::string word = word_of(place_words(), of_place);
    const std::string owner = word;
    word[0] = static_cast<char>(std::tolower(word[0]));
    if (is_given && place != of_place)
      section.refuse("Reference " + word, "the entry belongs to a " + owner, "Leave it out");
  }
  if (!reference_point.empty() && reference_point.size() != dim)
    section.refuse("Reference point",
                   "the point has " + std::to_string(reference_point.size()) + " coordinates",
                   "Give " + std::to_string(dim) + " of them, separated by commas");
}

template <int dim>
void ProbeEntries<dim>::check_sign_changes() const
{
  if (n_sign_changes == 0)
  {
    for (const char *key : {"Sign changes along", "Sign changes between"})
      if (section.given(key))
        section.refuse(key, "the entry belongs to Sign changes",
                       "Say how many are wanted, such as 'set Sign changes = 1'");
    return;
  }
  if (!is_on_wall())
    section.refuse("Sign changes", "positions are those along a boundary or an interface",
                   "Give Boundary or Interface instead of " + word_of(place_words(), place));
  if (dim == 3)
    section.refuse("Sign changes",
                   "in three dimensions the sign changes along lines, at no single position",
                   "Leave the entry out; the fields of the output have the wall shear stress");
  for (const char *key : {"Value", "Reference boundary"})
    if (section.given(key))
      section.refuse(key, "positions have neither a mean nor an integral",
                     "Leave the entry out, or give the positions a probe of their own");
  if (!sign_change_range.empty() &&
      (sign_change_range.size() != 2 || !(sign_change_range[0] < sign_change_range[1])))
    section.refuse("Sign changes between", "these are not two coordinates, the smaller one first",
                   "Write for example 'set Sign changes between = 1 m, 20 m'");
}

template <int dim>
ProbeEntries<dim>::ProbeEntries(const ParameterSection &section,
                                const std::vector<std::string> &known_boundaries,
                                const std::vector<std::string> &known_regions,
                                const std::vector<VesselBranch<dim>> &branches,
                                const std::vector<NamedInterface> &interfaces)
    : section(section)
{
  read_entries();
  check_entries();
  set_requests(known_boundaries, known_regions, branches, interfaces);
}

template <int dim>
void ProbeEntries<dim>::refuse_interfaces(const std::string &key,
                                          const std::vector<std::string> &names,
                                          const std::vector<NamedInterface> &interfaces) const
{
  for (const NamedInterface &known : interfaces)
    if (std::find(names.begin(), names.end(), known.name) != names.end())
      section.refuse(key, "'" + known.name + "' lies between regions, not on the outside",
                     "Write 'set Interface = " + known.name +
                         "', with the region on whose side the fields are taken as Region");
}

template <int dim>
void ProbeEntries<dim>::set_interface(const std::vector<std::string> &known_regions,
                                      const std::vector<NamedInterface> &interfaces)
{
  if (interface.size() == 2)
  {
    request.region_ids = {find_name(section, "Interface", interface[0], known_regions)};
    request.neighbour_ids = {find_name(section, "Interface", interface[1], known_regions)};
    if (request.region_ids == request.neighbour_ids)
      section.refuse("Interface", "a region has no interface with itself", "Name two regions");
    return;
  }
  if (interface.size() > 2 || interfaces.empty())
    section.refuse("Interface",
                   "an interface is that of two regions, here are " +
                       std::to_string(interface.size()),
                   "Write for example 'set Interface = fluid, wall'");
  std::vector<std::string> names;
  names.reserve(interfaces.size());
  for (const NamedInterface &known : interfaces)
    names.push_back(known.name);
  const NamedInterface &named = interfaces[find_name(section, "Interface", interface[0], names,
                                                     "the mesh has no interface '")];
  std::set<unsigned int> ids;
  for (const auto &[pair, is_whole] : named.sides)
    ids.insert({pair.first, pair.second});
  std::vector<std::string> regions;
  regions.reserve(ids.size());
  for (const unsigned int id : ids)
    regions.push_back(known_regions[id]);
  if (region.empty())
    section.refuse("Interface", "it is not said on which side of '" + named.name + "' to look",
                   "Set Region to one of: " + joined(regions));
  const unsigned int id = find_name(section, "Region", region, known_regions);
  for (const auto &[pair, is_whole] : named.sides)
  {
    if (pair.first != id && pair.second != id)
      continue;
    const unsigned int other = pair.first == id ? pair.second : pair.first;
    if (!is_whole)
      section.refuse("Interface",
                     "'" + named.name + "' is only a part of what lies between the regions '" +
                         known_regions[id] + "' and '" + known_regions[other] + "'",
                     "Give the cells on one side of it a region of their own, or write 'set "
                     "Interface = " +
                         known_regions[id] + ", " + known_regions[other] + "' for the whole");
    request.neighbour_ids.insert(other);
  }
  if (request.neighbour_ids.empty())
    section.refuse("Region",
                   "the region '" + known_regions[id] + "' is on no side of '" + named.name + "'",
                   "Set it to one of: " + joined(regions));
}

template <int dim>
void ProbeEntries<dim>::set_boundaries(const std::string &key,
                                       const std::vector<std::string> &names,
                                       const std::vector<std::string> &known,
                                       ProbeRequest<dim> &of_place)
{
  for (const std::string &word : names)
  {
    const unsigned int id = find_name(section, key, word, known);
    if (!of_place.boundary_ids.insert(id).second)
      section.refuse(key, "'" + word + "' stands there twice", "Name it once");
    names_of_boundaries[id] = known[id];
  }
}

template <int dim>
void ProbeEntries<dim>::set_requests(const std::vector<std::string> &known_boundaries,
                                     const std::vector<std::string> &known_regions,
                                     const std::vector<VesselBranch<dim>> &branches,
                                     const std::vector<NamedInterface> &interfaces)
{
  using Kind = typename ProbeRequest<dim>::Kind;
  const bool mean = value == Value::mean;
  has_reference =
      !reference_point.empty() || !reference_boundaries.empty() || !std::isnan(reference_position);
  switch (place)
  {
  case Place::point:
    for (unsigned int d = 0; d < dim; ++d)
    {
      request.point[d] = point[d];
      if (has_reference)
        reference.point[d] = reference_point[d];
    }
    request.is_fixed_in_space = reference.is_fixed_in_space = !moves_with_mesh;
    break;
  case Place::boundary:
    request.kind = mean ? Kind::boundary_mean : Kind::boundary_integral;
    refuse_interfaces("Boundary", boundaries, interfaces);
    refuse_interfaces("Reference boundary", reference_boundaries, interfaces);
    set_boundaries("Boundary", boundaries, known_boundaries, request);
    set_boundaries("Reference boundary", reference_boundaries, known_boundaries, reference);
    break;
  case Place::interface:
    request.kind = mean ? Kind::boundary_mean : Kind::boundary_integral;
    set_interface(known_regions, interfaces);
    refuse_interfaces("Boundary", boundaries, interfaces);
    set_boundaries("Boundary", boundaries, known_boundaries, request);
    break;
  case Place::section:
    request.kind = mean ? Kind::section_mean : Kind::section_integral;
    request.point[0] = position;
    reference.point[0] = reference_position;
    break;
  case Place::volume:
    request.kind = mean ? Kind::volume_mean : Kind::volume_integral;
    request.region_ids = {find_name(section, "Volume", volume, known_regions)};
    break;
  case Place::stations:
    stations.set(section, fields, known_regions, branches);
    break;
  }
  if (!region.empty())
    request.region_ids = {find_name(section, "Region", region, known_regions)};
  reference.kind = request.kind;
  reference.region_ids = request.region_ids;
  request.component = sign_change_coordinate;
  if (!sign_change_range.empty())
    request.range = {sign_change_range[0], sign_change_range[1]};
}

template <int dim>
std::vector<FieldComponent>
ProbeEntries<dim>::components(const std::vector<FieldComponent> &known_fields) const
{
  std::vector<FieldComponent> result, all = known_fields;
  if (is_on_wall())
    for (const FieldComponent &field : wall_field_names<dim>())
      all.push_back(field);
  for (const std::string &word : fields)
  {
    const std::string name = collapse_blanks(word);
    if (is_on_wall() && is_force(name))
    {
      for (const FieldComponent &force : expand(section, name, forces<dim>()))
        result.push_back(force);
      continue;
    }
    if (place == Place::boundary && is_of_cavity(name))
    {
      result.push_back({name, name == cavity_volume ? "1" : "Pa"});
      continue;
    }
    if (place == Place::volume && name == volume_change)
      result.push_back({volume_change, "1"});
    else
      for (const FieldComponent &field : expand(section, name, all))
        result.push_back(field);
  }
  for (std::size_t i = 0; i < result.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (result[j].name == result[i].name)
        section.refuse("Fields", "'" + result[i].name + "' is recorded twice",
                       "Name every field once");
  return result;
}

template <int dim>
std::vector<typename ProbeEntries<dim>::Recorded>
ProbeEntries<dim>::recorded(const std::vector<FieldComponent> &known_fields,
                            const Model model) const
{
  using Kind = typename ProbeRequest<dim>::Kind;
  std::vector<Recorded> result;
  for (FieldComponent field : components(known_fields))
  {
    ProbeRequest<dim> of_field = request;
    of_field.field = field.name;
    if (n_sign_changes > 0)
    {
      of_field.kind = Kind::sign_change;
      for (of_field.number = 0; of_field.number < n_sign_changes; ++of_field.number)
        result.push_back(
            {{"sign change " + std::to_string(of_field.number + 1) + " of " + field.name, "m"},
             {{of_field, 1.}}});
      continue;
    }
    if (field.name == volume_change)
      of_field.kind = Kind::volume_change;
    if (is_force(field.name))
    {
      of_field.kind = Kind::boundary_force;
      of_field.component = field.name.back() - 'x';
    }
    if (is_of_cavity(field.name))
      of_field.kind = field.name == cavity_volume ? Kind::cavity_volume : Kind::cavity_pressure;
    if (of_field.kind != Kind::cavity_pressure &&
        (of_field.is_integral() || of_field.has_no_field()))
      field.unit = unit_of_integral(field.unit, model,
                                    place == Place::volume || of_field.kind == Kind::cavity_volume);
    Recorded entry{field, {{of_field, 1.}}};
    if (has_reference)
    {
      entry.terms.emplace_back(reference, -1.);
      entry.terms.back().first.field = field.name;
    }
    result.push_back(entry);
  }
  return result;
}

template <int dim>
bool ProbeEntries<dim>::asks_for_forces() const
{
  return is_on_wall() &&
         std::any_of(fields.begin(), fields.end(),
                     [](const std::string &field) { return is_force(collapse_blanks(field)); });
}

template <int dim>
bool ProbeEntries<dim>::asks_for_averages(const std::vector<FieldComponent> &known_fields) const
{
  if (!is_on_wall())
    return false;
  const std::vector<FieldComponent> all = components(known_fields);
  return std::any_of(all.begin(), all.end(),
                     [](const FieldComponent &field) { return is_average(field.name); });
}

template <int dim>
void ProbeEntries<dim>::check_limits(const std::vector<BoundaryCondition> &conditions,
                                     const ProbeLimits &limits,
                                     const std::vector<FieldComponent> &known_fields) const
{
  if (limits.mesh_moves && limits.is_cell_wise)
    check_moving_cells(known_fields);
  if (!limits.is_finite && section.given("Moves with mesh"))
    section.refuse("Moves with mesh",
                   limits.mesh_moves ? "the cell-wise path has points of the mesh alone"
                                     : "with small deformation the mesh stays",
                   "Leave the entry out, or set Deformation = finite");
  if (place == Place::stations)
    return;
  if (limits.is_cell_wise && n_sign_changes > 0)
    section.refuse("Sign changes", "the cell-wise path has no positions along a wall",
                   "Leave the entry out, or set Discretisation = taylor hood");
  if (limits.is_cell_wise && place == Place::interface && !asks_for_forces())
    section.refuse("Interface", "of the fields, the cell-wise path has force alone on an interface",
                   "Ask for force alone, give a Boundary, or set Discretisation = taylor hood");
  for (const FieldComponent &field : components(known_fields))
  {
    const bool is_wall_field = field.name.compare(0, 18, "wall shear stress ") == 0 ||
                               field.name == "magnitude of wall shear stress" ||
                               is_average(field.name);
    if (limits.is_cell_wise && (is_wall_field || field.name == "Q criterion"))
      section.refuse("Fields", "the cell-wise path has no field '" + field.name + "'",
                     "Leave it out, or set Discretisation = taylor hood");
    if (limits.is_finite && field.name == volume_change)
      section.refuse("Fields", "'volume change' is that of a small deformation",
                     "Ask for the integral of 'dilatation' over the Volume");
    if (!limits.is_in_time && is_average(field.name))
      section.refuse("Fields", "a state without time has no '" + field.name + "'",
                     "Leave it out, or set Analysis = transient");
  }
  if (asks_for_averages(known_fields))
    check_walls(conditions, limits);
  check_cavities(conditions, known_fields);
  if (!asks_for_forces())
    return;
  if (limits.is_modal)
    section.refuse(
        "Fields",
        "there is no field 'force': it is what a step in time leaves at what is held, and a "
        "shape of vibration or a motion in the frequency domain has no step",
        "Leave it out, or integrate the stress over the Boundary");
  // Of boundaries beside an interface only what holds its first region counts.
  const std::set<unsigned int> of_regions =
      place == Place::interface ? request.region_ids : std::set<unsigned int>();
  for (const auto &[id, name] : names_of_boundaries)
  {
    bool is_held = false, is_supported = false;
    for (const BoundaryCondition &condition : conditions)
    {
      if (!of_regions.empty() && std::none_of(of_regions.begin(), of_regions.end(),
                                              [&condition](const unsigned int region)
                                              { return condition.region_ids.count(region) > 0; }))
        continue;
      is_held = is_held || (condition.boundary_id == id &&
                            (condition.normal.kind == BoundaryPart::Kind::velocity ||
                             condition.tangential.kind == BoundaryPart::Kind::velocity));
      is_supported = is_supported || (condition.boundary_id == id && condition.is_supported());
    }
    if (!is_held && is_supported)
      section.refuse("Fields",
                     "the force on the springs and dampers of the boundary '" + name +
                         "' is that of their moduli",
                     "Ask for displacement and velocity, whose mean over the boundary times the "
                     "moduli and its area is the force");
    if (!is_held)
      section.refuse("Fields",
                     "nothing holds the boundary '" + name +
                         "': the force there is the load that is given",
                     "Name boundaries with a prescribed velocity, such as 'fixed'");
  }
}

template <int dim>
void ProbeEntries<dim>::check_moving_cells(const std::vector<FieldComponent> &known_fields) const
{
  if (place == Place::point)
    return;
  if (place == Place::stations || place == Place::section)
    section.refuse(
        "", "sections of the cell-wise path are those of the mesh at rest, and the mesh moves",
        "Give a Point, a Boundary or a Volume, or set Discretisation = taylor hood");
  for (const FieldComponent &field : components(known_fields))
  {
    const auto is_named = [&field](const std::string &name)
    { return field.name.compare(0, name.size(), name) == 0; };
    // A mean of the displacement is one over matter.
    if (!is_named("force ") && !is_named("displacement ") && !is_named("velocity ") &&
        field.name != "pressure" && !is_of_cavity(field.name))
      section.refuse("Fields",
                     "'" + field.name +
                         "' would be an integral over the mesh at rest, and the mesh moves",
                     "Ask for force, displacement, velocity or pressure there, give a Point, or "
                     "set Discretisation = taylor hood");
  }
}

template <int dim>
void ProbeEntries<dim>::check_cavities(const std::vector<BoundaryCondition> &conditions,
                                       const std::vector<FieldComponent> &known_fields) const
{
  const std::vector<FieldComponent> all = components(known_fields);
  if (std::none_of(all.begin(), all.end(),
                   [](const FieldComponent &field) { return is_of_cavity(field.name); }))
    return;
  for (const char *key : {"Value", "Region", "Reference boundary", "Sign changes"})
    if (section.given(key))
      section.refuse(key, "a cavity has one pressure and one volume",
                     "Leave the entry out, and give other fields a probe of their own");
  const auto n_cavities = std::count_if(
      conditions.begin(), conditions.end(),
      [this](const BoundaryCondition &condition)
      { return condition.is_cavity() && names_of_boundaries.count(condition.boundary_id) > 0; });
  if (names_of_boundaries.size() > 1 || n_cavities != 1)
    section.refuse("Boundary",
                   "the pressure and the volume are those of one boundary with Type = cavity",
                   "Name that boundary alone");
}

template <int dim>
void ProbeEntries<dim>::check_walls(const std::vector<BoundaryCondition> &conditions,
                                    const ProbeLimits &limits) const
{
  if (place == Place::interface)
  {
    if (limits.is_solid[*request.region_ids.begin()] ||
        !limits.is_solid[*request.neighbour_ids.begin()])
      section.refuse("Interface", "averages over time are those of a liquid on a solid",
                     "Name the liquid first and the solid second");
    return;
  }
  for (const auto &[id, name] : names_of_boundaries)
    for (const BoundaryCondition &condition : conditions)
      for (const unsigned int of_condition : condition.region_ids)
        if (condition.boundary_id == id &&
            (request.region_ids.empty() || request.region_ids.count(of_condition) > 0) &&
            (limits.is_solid[of_condition] || !condition.is_wall()))
          section.refuse("Fields",
                         "averages over time are those of a liquid on a wall, and the boundary '" +
                             name + "' is none",
                         "Name boundaries of a liquid with Type = fixed, with the Region of the "
                         "liquid if there are others");
}

template <int dim>
void ProbeEntries<dim>::check_point(const std::string &entry,
                                    const dealii::Point<dim> &point,
                                    const dealii::Triangulation<dim> &coarse_mesh) const
{
  const dealii::MappingQ<dim> mapping(degree_of_coarse_cells);
  const std::set<unsigned int> &region_ids = request.region_ids;
  bool inside = false;
  dealii::Point<dim> unit_point;
  for (const auto &cell : coarse_mesh.cell_iterators_on_level(0))
    inside = inside || ((region_ids.empty() || region_ids.count(cell->material_id()) > 0) &&
                        cell_holds_point<dim>(mapping, cell, point, unit_point));
  if (!inside)
    section.refuse(entry,
                   "the point is not inside the mesh, which extends over " +
                       extent(coarse_mesh, region_ids),
                   "Give a point of the undeformed body, in the Region if there is one");
}

template <int dim>
void ProbeEntries<dim>::check_boundaries(
    const std::set<std::pair<unsigned int, unsigned int>> &boundary_regions) const
{
  const std::set<unsigned int> &region_ids = request.region_ids;
  for (const auto &[id, name] : names_of_boundaries)
    if (std::none_of(boundary_regions.begin(), boundary_regions.end(),
                     [&, boundary_id = id](const auto &pair) {
                       return pair.first == boundary_id &&
                              (region_ids.empty() || region_ids.count(pair.second) > 0);
                     }))
    {
      if (place == Place::interface)
        section.refuse("Boundary",
                       "the boundary '" + name + "' has no face of the interface's first region",
                       "Name a boundary of that region, or leave the entry out");
      section.refuse("Region", "the boundary '" + name + "' has no face in this region",
                     "Name a region that touches the boundary, or none");
    }
}

template <int dim>
void ProbeEntries<dim>::check_section(const std::string &entry,
                                      const ProbeRequest<dim> &of_section,
                                      const dealii::Triangulation<dim> &coarse_mesh) const
{
  if (!PlaneSection<dim>::exists(dealii::MappingQ<dim>(degree_of_coarse_cells), coarse_mesh,
                                 of_section.region_ids, of_section.point, of_section.normal))
    section.refuse(entry, "a section without area: the plane does not cut the body",
                   "Give a position at which it does, in the Region if there is one");
}

template <int dim>
void ProbeEntries<dim>::check_interface(const dealii::Triangulation<dim> &coarse_mesh) const
{
  for (const auto &cell : coarse_mesh.cell_iterators_on_level(0))
    if (request.region_ids.count(cell->material_id()) > 0)
      for (const unsigned int f : cell->face_indices())
        if (!cell->at_boundary(f) &&
            request.neighbour_ids.count(cell->neighbor(f)->material_id()) > 0)
          return;
  section.refuse("Interface", "these regions do not meet", "Name two regions with a common face");
}

template <int dim>
void ProbeEntries<dim>::check(
    const dealii::Triangulation<dim> &coarse_mesh,
    const std::vector<FieldComponent> &known_fields,
    const std::set<std::pair<unsigned int, unsigned int>> &boundary_regions)
{
  if (place == Place::stations)
  {
    if (std::none_of(known_fields.begin(), known_fields.end(),
                     [](const FieldComponent &field)
                     { return field.name == "radial displacement"; }))
      section.refuse("Stations", "a plane model has no tube",
                     "Use Model = axisymmetric or three-dimensional, or a Section");
    stations.check(section, coarse_mesh);
    return;
  }
  for (const FieldComponent &field : components(known_fields))
  {
    if (field.name == volume_change && !has_interface(coarse_mesh, *request.region_ids.begin()))
      section.refuse("Fields",
                     "the region '" + volume +
                         "' meets no other one, whose motion could change its volume",
                     "Leave 'volume change' out; the integral of 'dilatation' is the change "
                     "of volume by strain");
    if (n_sign_changes > 0 && !can_change_sign(field.name))
      section.refuse(
          "Sign changes", "there are none of '" + field.name + "'",
          "Ask for a component of the wall shear stress, the velocity, the stress or the "
          "vorticity, or for the pressure");
  }
  if (place == Place::boundary)
    check_boundaries(boundary_regions);
  else if (place == Place::interface)
  {
    check_interface(coarse_mesh);
    check_boundaries(boundary_regions);
  }
  else if (place == Place::section)
  {
    check_section("Section", request, coarse_mesh);
    if (has_reference)
      check_section("Reference section", reference, coarse_mesh);
  }
  else if (place == Place::point)
  {
    check_point("Point", request.point, coarse_mesh);
    if (has_reference)
      check_point("Reference point", reference.point, coarse_mesh);
  }
}

template class ProbeEntries<2>;
template class ProbeEntries<3>;
} // namespace Continua
