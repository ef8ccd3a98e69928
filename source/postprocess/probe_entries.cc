#include <continua/postprocess/probe_entries.h>

#include <continua/base/input_error.h>
#include <continua/base/joined.h>
#include <continua/base/name_choice.h>
#include <continua/base/parameter_text.h>
#include <continua/continuum/field_list.h>
#include <continua/postprocess/probe_checks.h>
#include <continua/postprocess/probe_fields.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace Continua
{
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
      "'magnitude of wall shear stress', 'time-averaged wall shear stress', 'oscillatory shear "
      "index' and 'relative residence time' (of the window in Output). Of Type = cavity: 'cavity "
      "pressure' "
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
void ProbeEntries<dim>::set_place()
{
  if (fields.empty())
    section.refuse("Fields", "the probe has no field", "Write for example 'set Fields = velocity'");
  std::vector<Place> places;
  if (!point.empty())
    places.push_back(Place::point);
  // Beside an interface boundaries count for the force, see ProbeChecks.
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
ProbeEntries<dim>::ProbeEntries(const ParameterSection &section,
                                const std::vector<std::string> &known_boundaries,
                                const std::vector<std::string> &known_regions,
                                const std::vector<VesselBranch<dim>> &branches,
                                const std::vector<NamedInterface> &interfaces)
    : section(section)
{
  read_entries();
  set_place();
  ProbeChecks<dim>(*this).check_entries();
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
  ProbeChecks<dim>(*this).check_limits(conditions, limits, known_fields);
}

template <int dim>
void ProbeEntries<dim>::check(
    const dealii::Triangulation<dim> &coarse_mesh,
    const std::vector<FieldComponent> &known_fields,
    const std::set<std::pair<unsigned int, unsigned int>> &boundary_regions)
{
  ProbeChecks<dim>(*this).check(coarse_mesh, known_fields, boundary_regions);
  if (place == Place::stations)
    stations.check(section, coarse_mesh);
}

template class ProbeEntries<2>;
template class ProbeEntries<3>;
} // namespace Continua
