#include <continua/boundary/boundary_conditions.h>

#include <continua/base/joined.h>
#include <continua/base/parameter_text.h>
#include <continua/base/quoted_name.h>
#include <continua/boundary/boundary_types.h>

#include <algorithm>
#include <map>

namespace Continua
{
namespace
{
unsigned int index_of(const ParameterSection &section,
                      const std::string &key,
                      const std::string &what,
                      const std::string &name,
                      const std::vector<std::string> &names)
{
  auto place = std::find(names.begin(), names.end(), name);
  if (place == names.end())
    place = std::find(names.begin(), names.end(), without_quotes(collapse_blanks(name)));
  if (place == names.end())
    section.refuse(key, "the geometry has no " + what + " called '" + name + "'",
                   "It has: " + joined(names));
  return place - names.begin();
}

/// What a mesh that moves does on the boundary.
void read_mesh_condition(ParameterSection &section,
                         BoundaryCondition &condition,
                         const unsigned int n_dimensions)
{
  add_choice(section, "Mesh", condition.mesh,
             {{"automatic", MeshCondition::automatic},
              {"slides", MeshCondition::slides},
              {"fixed", MeshCondition::fixed},
              {"follows", MeshCondition::follows}},
             "What the mesh of a liquid does on the boundary with Deformation = finite, and on the "
             "cell-wise path with Mesh motion = elastic: "
             "slides - along a plane that is normal to an axis; fixed - it stays; follows - it "
             "moves with the velocity that is prescribed, or with 'Mesh velocity'; "
             "automatic - it slides on planes where the pressure or the traction is given, on "
             "outlets, on rollers and on the axis, and stays on walls, curved boundaries and "
             "where a velocity is given.");
  condition.mesh_velocity = Waveform::read_vector(
      section, "Mesh velocity", n_dimensions, Dimensions::velocity,
      "Of Mesh = follows: Cartesian components of the velocity of the mesh, where the liquid "
      "passes it; by itself the mesh has the velocity of the liquid. A formula has the place "
      "in the undeformed mesh.",
      false, "Mesh");
  // Zeros that are given hold the mesh.
  const bool has_mesh_velocity =
      section.given("Mesh velocity") ||
      std::any_of(condition.mesh_velocity.begin(), condition.mesh_velocity.end(),
                  [](const Waveform &component) { return !component.is_zero(); });
  if (!has_mesh_velocity)
    condition.mesh_velocity.clear();
  else if (condition.mesh != MeshCondition::follows)
    section.refuse(section.given("Mesh velocity") ? "Mesh velocity" : "Mesh waveform",
                   "the mesh of the boundary does not follow",
                   "Set Mesh = follows, or leave the entry out");
  if (condition.mesh == MeshCondition::follows && condition.mesh_velocity.empty() &&
      (condition.normal.kind != BoundaryPart::Kind::velocity ||
       condition.tangential.kind != BoundaryPart::Kind::velocity))
    section.refuse("Mesh", "no velocity is prescribed here that the mesh would follow",
                   "Set Type = velocity, give a Mesh velocity, or set Mesh = slides or fixed");
}
} // namespace

std::set<std::string> boundaries_held_across(const ParameterFile &file)
{
  std::set<std::string> names;
  const ParameterText::Section *const section = file.text().find({"Boundaries"});
  if (section == nullptr)
    return names;
  for (const ParameterText::Section &child : section->sections)
  {
    const auto says = [&child](const char *const key, const std::vector<std::string> &words)
    {
      const ParameterText::Entry *const entry = child.entry(key);
      return entry != nullptr &&
             std::find(words.begin(), words.end(), entry->value()) != words.end();
    };
    const ParameterText::Entry *const boundary = child.entry("Boundary");
    if (says("Type", {"fixed", "velocity"}) ||
        (says("Type", {"flow rate"}) && !says("Profile", {"free"})) ||
        says("Tangential", {"fixed", "velocity"}) || says("Coupling", {"flow"}))
      names.insert(boundary != nullptr && !boundary->value().empty() ? boundary->value()
                                                                     : child.name);
  }
  return names;
}

bool some_mesh_follows(const ParameterFile &file)
{
  const ParameterText::Section *const section = file.text().find({"Boundaries"});
  return section != nullptr && std::any_of(section->sections.begin(), section->sections.end(),
                                           [](const ParameterText::Section &child)
                                           {
                                             const ParameterText::Entry *const entry =
                                                 child.entry("Mesh");
                                             return entry != nullptr && entry->value() == "follows";
                                           });
}

std::vector<BoundaryCondition>
read_boundary_conditions(ParameterSection section,
                         const std::vector<std::string> &boundaries,
                         const std::vector<std::string> &regions,
                         const std::set<std::pair<unsigned int, unsigned int>> &pairs,
                         const unsigned int n_dimensions,
                         const bool axisymmetric)
{
  std::string type_text = "What holds on the boundary; required.";
  for (const auto &[name, description] : boundary_types())
    type_text += " " + name + " - " + description;

  std::vector<BoundaryCondition> conditions;
  std::map<std::pair<unsigned int, unsigned int>, std::string> taken;
  for (const std::string &child_name : section.subsections())
  {
    ParameterSection child = section.subsection(child_name);
    BoundaryCondition condition;
    condition.name = child_name;

    std::string boundary = child_name;
    child.add("Boundary", boundary,
              "Name of the boundary, where the subsection is not called after it (two conditions "
              "on the parts of one "
              "boundary that belong to different regions).");
    condition.boundary_id = index_of(child, child.given("Boundary") ? "Boundary" : "", "boundary",
                                     boundary, boundaries);

    std::string region;
    child.add("Region", region,
              "The one region whose part of the boundary is meant; empty: all of it.");
    for (const auto &pair : pairs)
      if (pair.first == condition.boundary_id &&
          (region.empty() || pair.second == index_of(child, "Region", "region", region, regions)))
        condition.region_ids.insert(pair.second);
    if (condition.region_ids.empty())
      child.refuse(region.empty() ? "" : "Region",
                   "the boundary '" + boundary + "' has no face" +
                       (region.empty() ? "" : " in the region '" + region + "'"),
                   "Remove the subsection, or name a region that touches the boundary");

    add_choice(child, "Type", condition.type, boundary_type_words(), type_text);
    child.require("Type");
    if (condition.type == BoundaryType::axis && !axisymmetric)
      child.refuse("Type", "there is no axis in this model",
                   "Use 'roller', or Model = axisymmetric");
    condition.is_in_plane = n_dimensions == 2 && !axisymmetric;
    read_boundary_type(child, condition, n_dimensions);
    read_mesh_condition(child, condition, n_dimensions);
    if (condition.outlet && condition.profile && n_dimensions == 2 && !axisymmetric)
      child.refuse("Coupling", "a plane model has no round section with a profile",
                   "Use Coupling = pressure, or Model = axisymmetric or three-dimensional");

    for (const unsigned int id : condition.region_ids)
    {
      const auto inserted = taken.insert({{condition.boundary_id, id}, child_name});
      if (!inserted.second)
        child.refuse("",
                     "the boundary '" + boundary + "' of the region '" + regions[id] +
                         "' has two conditions, here and in 'Boundaries/" + inserted.first->second +
                         "'",
                     "Keep one of the two");
    }
    conditions.push_back(condition);
  }
  for (const auto &pair : pairs)
    if (taken.count(pair) == 0)
      section.refuse_missing(
          "the boundary '" + boundaries[pair.first] + "' has no condition" +
              (regions.size() > 1 ? " in the region '" + regions[pair.second] + "'" : ""),
          "Add 'subsection " + quoted_name(boundaries[pair.first], "#") +
              "' with a Type (such as free) to Boundaries");
  return conditions;
}
} // namespace Continua
