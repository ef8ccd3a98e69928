#include <continua/postprocess/probe_checks.h>

#include <continua/base/input_error.h>
#include <continua/base/parameter_text.h>
#include <continua/continuum/field_list.h>
#include <continua/mesh/cell_point.h>
#include <continua/mesh/plane_section.h>
#include <continua/postprocess/probe_fields.h>

#include <deal.II/fe/mapping_q.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <sstream>

namespace Continua
{
namespace
{
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
} // namespace

template <int dim>
void ProbeChecks<dim>::check_entries() const
{
  if (probe.place == Place::point && probe.point.size() != dim)
    probe.section.refuse("Point",
                         "the point has " + std::to_string(probe.point.size()) + " coordinates",
                         "Give " + std::to_string(dim) + " of them, separated by commas");
  if (probe.place != Place::point && probe.section.given("Moves with mesh"))
    probe.section.refuse("Moves with mesh", "the entry belongs to a Point",
                         "Leave it out: " + word_of(probe.place_words(), probe.place) +
                             " goes with the mesh");
  check_reference();
  check_sign_changes();
  if (probe.place == Place::interface && !probe.boundaries.empty() &&
      !std::all_of(probe.fields.begin(), probe.fields.end(),
                   [](const std::string &field) { return is_force(collapse_blanks(field)); }))
    probe.section.refuse("Boundary", "beside an Interface a Boundary counts for the force alone",
                         "Give other fields a probe of their own");
  if (!probe.is_on_wall() &&
      std::any_of(probe.fields.begin(), probe.fields.end(),
                  [](const std::string &field) { return is_force(collapse_blanks(field)); }))
    probe.section.refuse("Fields", "a force is that on a boundary",
                         "Give Boundary instead of " + word_of(probe.place_words(), probe.place));
  const bool names_interface = probe.place == Place::interface && probe.interface.size() == 1;
  if (probe.asks_for_forces())
    for (const char *key : {"Value", "Region", "Reference boundary", "Sign changes"})
      if (probe.section.given(key) && !(names_interface && key == std::string("Region")))
        probe.section.refuse(key, "the force is that of the whole body on the whole boundary",
                             "Leave the entry out, and give other fields a probe of their own");
  if ((probe.place == Place::point || probe.place == Place::stations) &&
      probe.section.given("Value"))
    probe.section.refuse("Value",
                         probe.place == Place::point
                             ? "a point has neither a mean nor an integral"
                             : "what is recorded at stations is said by the fields",
                         "Leave the entry out, or give Boundary, Section or Volume instead of " +
                             word_of(probe.place_words(), probe.place));
  if (probe.place == Place::stations && probe.section.given("Region"))
    probe.section.refuse("Region", "the region of stations is the fluid", "Set Fluid instead");
  if (probe.place == Place::interface && !names_interface && probe.section.given("Region"))
    probe.section.refuse("Region", "the side of an interface is that of its first region",
                         "Leave the entry out");
  if (probe.place == Place::volume && probe.section.given("Region"))
    probe.section.refuse("Region", "the volume is that of a region already", "Leave the entry out");
  if (probe.place != Place::stations)
    for (const char *key : {"Branch", "Fluid", "Pair distance", "Pair", "Pulse direction"})
      if (probe.section.given(key))
        probe.section.refuse(key, "the entry belongs to Stations", "Leave it out");
  if (!probe.signal_analysis && !probe.modes.empty())
    probe.section.refuse("Modes", "frequencies are fitted only in the signal analysis",
                         "Leave the entry out, or set Signal analysis = true");
  if (!probe.signal_analysis && probe.last_periods > 0)
    probe.section.refuse("Last periods", "periods are looked for only in the signal analysis",
                         "Leave the entry out, or set Signal analysis = true");
}

template <int dim>
void ProbeChecks<dim>::check_reference() const
{
  const std::array<std::pair<Place, bool>, 3> references = {
      {{Place::point, !probe.reference_point.empty()},
       {Place::boundary, !probe.reference_boundaries.empty()},
       {Place::section, !std::isnan(probe.reference_position)}}};
  for (const auto &[of_place, is_given] : references)
  {
    std::string word = word_of(probe.place_words(), of_place);
    const std::string owner = word;
    word[0] = static_cast<char>(std::tolower(word[0]));
    if (is_given && probe.place != of_place)
      probe.section.refuse("Reference " + word, "the entry belongs to a " + owner, "Leave it out");
  }
  if (!probe.reference_point.empty() && probe.reference_point.size() != dim)
    probe.section.refuse("Reference point",
                         "the point has " + std::to_string(probe.reference_point.size()) +
                             " coordinates",
                         "Give " + std::to_string(dim) + " of them, separated by commas");
}

template <int dim>
void ProbeChecks<dim>::check_sign_changes() const
{
  if (probe.n_sign_changes == 0)
  {
    for (const char *key : {"Sign changes along", "Sign changes between"})
      if (probe.section.given(key))
        probe.section.refuse(key, "the entry belongs to Sign changes",
                             "Say how many are wanted, such as 'set Sign changes = 1'");
    return;
  }
  if (!probe.is_on_wall())
    probe.section.refuse("Sign changes", "positions are those along a boundary or an interface",
                         "Give Boundary or Interface instead of " +
                             word_of(probe.place_words(), probe.place));
  if (dim == 3)
    probe.section.refuse(
        "Sign changes", "in three dimensions the sign changes along lines, at no single position",
        "Leave the entry out; the fields of the output have the wall shear stress");
  for (const char *key : {"Value", "Reference boundary"})
    if (probe.section.given(key))
      probe.section.refuse(key, "positions have neither a mean nor an integral",
                           "Leave the entry out, or give the positions a probe of their own");
  if (!probe.sign_change_range.empty() &&
      (probe.sign_change_range.size() != 2 ||
       !(probe.sign_change_range[0] < probe.sign_change_range[1])))
    probe.section.refuse("Sign changes between",
                         "these are not two coordinates, the smaller one first",
                         "Write for example 'set Sign changes between = 1 m, 20 m'");
}

template <int dim>
void ProbeChecks<dim>::check_limits(const std::vector<BoundaryCondition> &conditions,
                                    const ProbeLimits &limits,
                                    const std::vector<FieldComponent> &known_fields) const
{
  if (limits.mesh_moves && limits.is_cell_wise)
    check_moving_cells(known_fields);
  if (!limits.is_finite && probe.section.given("Moves with mesh"))
    probe.section.refuse("Moves with mesh",
                         limits.mesh_moves ? "the cell-wise path has points of the mesh alone"
                                           : "with small deformation the mesh stays",
                         "Leave the entry out, or set Deformation = finite");
  if (probe.place == Place::stations)
    return;
  if (limits.is_cell_wise && probe.n_sign_changes > 0)
    probe.section.refuse("Sign changes", "the cell-wise path has no positions along a wall",
                         "Leave the entry out, or set Discretisation = taylor hood");
  if (limits.is_cell_wise && probe.place == Place::interface && !probe.asks_for_forces())
    probe.section.refuse(
        "Interface", "of the fields, the cell-wise path has force alone on an interface",
        "Ask for force alone, give a Boundary, or set Discretisation = taylor hood");
  for (const FieldComponent &field : probe.components(known_fields))
  {
    const bool is_wall_field = field.name.compare(0, 18, "wall shear stress ") == 0 ||
                               field.name == "magnitude of wall shear stress" ||
                               is_average(field.name);
    if (limits.is_cell_wise && (is_wall_field || field.name == "Q criterion"))
      probe.section.refuse("Fields", "the cell-wise path has no field '" + field.name + "'",
                           "Leave it out, or set Discretisation = taylor hood");
    if (limits.is_finite && field.name == volume_change)
      probe.section.refuse("Fields", "'volume change' is that of a small deformation",
                           "Ask for the integral of 'dilatation' over the Volume");
    if (!limits.is_in_time && is_average(field.name))
      probe.section.refuse("Fields", "a state without time has no '" + field.name + "'",
                           "Leave it out, or set Analysis = transient");
  }
  if (probe.asks_for_averages(known_fields))
    check_walls(conditions, limits);
  check_cavities(conditions, known_fields);
  if (!probe.asks_for_forces())
    return;
  if (limits.is_modal)
    probe.section.refuse(
        "Fields",
        "there is no field 'force': it is what a step in time leaves at what is held, and a "
        "shape of vibration or a motion in the frequency domain has no step",
        "Leave it out, or integrate the stress over the Boundary");
  // Of boundaries beside an interface only what holds its first region counts.
  const std::set<unsigned int> of_regions =
      probe.place == Place::interface ? probe.request.region_ids : std::set<unsigned int>();
  for (const auto &[id, name] : probe.names_of_boundaries)
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
      probe.section.refuse(
          "Fields",
          "the force on the springs and dampers of the boundary '" + name +
              "' is that of their moduli",
          "Ask for displacement and velocity, whose mean over the boundary times the "
          "moduli and its area is the force");
    if (!is_held)
      probe.section.refuse("Fields",
                           "nothing holds the boundary '" + name +
                               "': the force there is the load that is given",
                           "Name boundaries with a prescribed velocity, such as 'fixed'");
  }
}

template <int dim>
void ProbeChecks<dim>::check_moving_cells(const std::vector<FieldComponent> &known_fields) const
{
  if (probe.place == Place::point)
    return;
  if (probe.place == Place::stations || probe.place == Place::section)
    probe.section.refuse(
        "", "sections of the cell-wise path are those of the undeformed mesh, and the mesh moves",
        "Give a Point, a Boundary or a Volume, or set Discretisation = taylor hood");
  for (const FieldComponent &field : probe.components(known_fields))
  {
    const auto is_named = [&field](const std::string &name)
    { return field.name.compare(0, name.size(), name) == 0; };
    // A mean of the displacement is one over matter.
    if (!is_named("force ") && !is_named("displacement ") && !is_named("velocity ") &&
        field.name != "pressure" && !is_of_cavity(field.name))
      probe.section.refuse(
          "Fields",
          "'" + field.name + "' would be an integral over the undeformed mesh, and the mesh moves",
          "Ask for force, displacement, velocity or pressure there, give a Point, or "
          "set Discretisation = taylor hood");
  }
}

template <int dim>
void ProbeChecks<dim>::check_cavities(const std::vector<BoundaryCondition> &conditions,
                                      const std::vector<FieldComponent> &known_fields) const
{
  const std::vector<FieldComponent> all = probe.components(known_fields);
  if (std::none_of(all.begin(), all.end(),
                   [](const FieldComponent &field) { return is_of_cavity(field.name); }))
    return;
  for (const char *key : {"Value", "Region", "Reference boundary", "Sign changes"})
    if (probe.section.given(key))
      probe.section.refuse(key, "a cavity has one pressure and one volume",
                           "Leave the entry out, and give other fields a probe of their own");
  const auto n_cavities = std::count_if(
      conditions.begin(), conditions.end(),
      [this](const BoundaryCondition &condition) {
        return condition.is_cavity() && probe.names_of_boundaries.count(condition.boundary_id) > 0;
      });
  if (probe.names_of_boundaries.size() > 1 || n_cavities != 1)
    probe.section.refuse("Boundary",
                         "the pressure and the volume are those of one boundary with Type = cavity",
                         "Name that boundary alone");
}

template <int dim>
void ProbeChecks<dim>::check_walls(const std::vector<BoundaryCondition> &conditions,
                                   const ProbeLimits &limits) const
{
  if (probe.place == Place::interface)
  {
    if (limits.is_solid[*probe.request.region_ids.begin()] ||
        !limits.is_solid[*probe.request.neighbour_ids.begin()])
      probe.section.refuse("Interface", "averages over time are those of a liquid on a solid",
                           "Name the liquid first and the solid second");
    return;
  }
  for (const auto &[id, name] : probe.names_of_boundaries)
    for (const BoundaryCondition &condition : conditions)
      for (const unsigned int of_condition : condition.region_ids)
        if (condition.boundary_id == id &&
            (probe.request.region_ids.empty() ||
             probe.request.region_ids.count(of_condition) > 0) &&
            (limits.is_solid[of_condition] || !condition.is_wall()))
          probe.section.refuse(
              "Fields",
              "averages over time are those of a liquid on a wall, and the boundary '" + name +
                  "' is none",
              "Name boundaries of a liquid with Type = fixed, with the Region of the "
              "liquid if there are others");
}

template <int dim>
void ProbeChecks<dim>::check_point(const std::string &entry,
                                   const dealii::Point<dim> &point,
                                   const dealii::Triangulation<dim> &coarse_mesh) const
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
void ProbeChecks<dim>::check_boundaries(
    const std::set<std::pair<unsigned int, unsigned int>> &boundary_regions) const
{
  const std::set<unsigned int> &region_ids = probe.request.region_ids;
  for (const auto &[id, name] : probe.names_of_boundaries)
    if (std::none_of(boundary_regions.begin(), boundary_regions.end(),
                     [&, boundary_id = id](const auto &pair) {
                       return pair.first == boundary_id &&
                              (region_ids.empty() || region_ids.count(pair.second) > 0);
                     }))
    {
      if (probe.place == Place::interface)
        probe.section.refuse(
            "Boundary", "the boundary '" + name + "' has no face of the interface's first region",
            "Name a boundary of that region, or leave the entry out");
      probe.section.refuse("Region", "the boundary '" + name + "' has no face in this region",
                           "Name a region that touches the boundary, or none");
    }
}

template <int dim>
void ProbeChecks<dim>::check_section(const std::string &entry,
                                     const ProbeRequest<dim> &of_section,
                                     const dealii::Triangulation<dim> &coarse_mesh) const
{
  if (!PlaneSection<dim>::exists(dealii::MappingQ<dim>(degree_of_coarse_cells), coarse_mesh,
                                 of_section.region_ids, of_section.point, of_section.normal))
    probe.section.refuse(entry, "a section without area: the plane does not cut the body",
                         "Give a position at which it does, in the Region if there is one");
}

template <int dim>
void ProbeChecks<dim>::check_interface(const dealii::Triangulation<dim> &coarse_mesh) const
{
  for (const auto &cell : coarse_mesh.cell_iterators_on_level(0))
    if (probe.request.region_ids.count(cell->material_id()) > 0)
      for (const unsigned int f : cell->face_indices())
        if (!cell->at_boundary(f) &&
            probe.request.neighbour_ids.count(cell->neighbor(f)->material_id()) > 0)
          return;
  probe.section.refuse("Interface", "these regions do not meet",
                       "Name two regions with a common face");
}

template <int dim>
void ProbeChecks<dim>::check(
    const dealii::Triangulation<dim> &coarse_mesh,
    const std::vector<FieldComponent> &known_fields,
    const std::set<std::pair<unsigned int, unsigned int>> &boundary_regions) const
{
  if (probe.place == Place::stations)
  {
    if (std::none_of(known_fields.begin(), known_fields.end(),
                     [](const FieldComponent &field)
                     { return field.name == "radial displacement"; }))
      probe.section.refuse("Stations", "a plane model has no tube",
                           "Use Model = axisymmetric or three-dimensional, or a Section");
    return;
  }
  for (const FieldComponent &field : probe.components(known_fields))
  {
    if (field.name == volume_change &&
        !has_interface(coarse_mesh, *probe.request.region_ids.begin()))
      probe.section.refuse("Fields",
                           "the region '" + probe.volume +
                               "' meets no other one, whose motion could change its volume",
                           "Leave 'volume change' out; the integral of 'dilatation' is the change "
                           "of volume by strain");
    if (probe.n_sign_changes > 0 && !can_change_sign(field.name))
      probe.section.refuse(
          "Sign changes", "there are none of '" + field.name + "'",
          "Ask for a component of the wall shear stress, the velocity, the stress or the "
          "vorticity, or for the pressure");
  }
  if (probe.place == Place::boundary)
    check_boundaries(boundary_regions);
  else if (probe.place == Place::interface)
  {
    check_interface(coarse_mesh);
    check_boundaries(boundary_regions);
  }
  else if (probe.place == Place::section)
  {
    check_section("Section", probe.request, coarse_mesh);
    if (probe.has_reference)
      check_section("Reference section", probe.reference, coarse_mesh);
  }
  else if (probe.place == Place::point)
  {
    check_point("Point", probe.request.point, coarse_mesh);
    if (probe.has_reference)
      check_point("Reference point", probe.reference.point, coarse_mesh);
  }
}

template class ProbeChecks<2>;
template class ProbeChecks<3>;
} // namespace Continua
