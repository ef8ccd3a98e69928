#include <continua/analysis/documentation.h>

#include <continua/analysis/analyses.h>
#include <continua/analysis/case.h>
#include <continua/base/input_error.h>
#include <continua/boundary/boundary_condition.h>
#include <continua/materials/material.h>
#include <continua/mesh/geometry.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <functional>
#include <sstream>

namespace Continua
{
namespace
{
using Types = std::vector<std::pair<std::string, std::string>>;
using Overrides = std::vector<std::string>;

/// One section of the documentation. Its entries are those that `read`, the function of a run,
/// declares.
struct Section
{
  std::string title;
  std::string introduction;
  Overrides overrides; ///< what must be set for anything to be declared: members of families
  std::function<void(ParameterSection root, const GeneralParameters &general)> read;
  std::string type_key; ///< the entry that picks a row of a table; empty: there is no table
  Types types;
};

/// An entry as ParameterFile prints it in json, and the other entries on which it depends.
struct Entry
{
  nlohmann::ordered_json data;
  std::string condition; ///< "Waveform = table"

  std::string path() const { return data["path"]; }
  bool operator==(const Entry &other) const
  {
    return data == other.data && condition == other.condition;
  }
};

/// The entries of one type, or of a section without types.
struct Part
{
  std::string type;
  std::string description;
  std::string models; ///< where not every Model has it: those that have it
  std::vector<Entry> entries;
};

const std::vector<Section> &sections()
{
  const auto geometry = [](ParameterSection root, const GeneralParameters &general)
  {
    const Model model = model_of(general.model);
    ParameterSection mesh = root.subsection("Mesh");
    if (n_dimensions(model) == 3)
      make_geometry<3>(root.subsection("Geometry"), mesh, false);
    else
      make_geometry<2>(root.subsection("Geometry"), mesh, model == Model::axisymmetric);
    MeshParameters::read(mesh);
  };
  static const std::vector<Section> list = {
      {"General", "At the top of the file, outside all subsections.", {}, {}, "", {}},
      {"Geometry and mesh",
       "The shape, whose type decides how its regions and boundaries are called, and the coarse "
       "mesh.",
       {},
       geometry,
       "Geometry/Type",
       geometry_types<2>()},
      {"Painted regions",
       "A family of entries, one a region: parts of any geometry that are to have a material of "
       "their own.",
       {"Geometry/Regions/<region>=1"},
       geometry,
       "",
       {}},
      {"Materials",
       "A family: one subsection for each region of the geometry, called after it.",
       {},
       [](ParameterSection root, const GeneralParameters &general)
       {
         read_material(root.subsection("Materials").subsection("<region>"),
                       model_of(general.model));
       },
       "Materials/<region>/Type",
       material_types()},
      {"Boundaries",
       "A family: one subsection for each boundary of the geometry, called after it.",
       {},
       [](ParameterSection root, const GeneralParameters &general)
       {
         const Model model = model_of(general.model);
         read_boundary_conditions(root.subsection("Boundaries"), {"<boundary>"}, {"<region>"},
                                  {{0, 0}}, n_dimensions(model), model == Model::axisymmetric);
       },
       "Boundaries/<boundary>/Type",
       boundary_types()},
      {"Body force and initial state",
       "What acts inside the body, and the state at t = 0, which is rest unless it is given.",
       {},
       [](ParameterSection root, const GeneralParameters &general)
       {
         InteriorData().read(root.subsection("Body force"), root.subsection("Initial state"),
                             {"<region>"}, n_dimensions(model_of(general.model)));
       },
       "",
       {}},
      {"Finite elements and linear solver",
       "How the equations are discretised in space, and how the systems are solved.",
       {},
       [](ParameterSection root, const GeneralParameters &)
       {
         TaylorHoodParameters parameters;
         parameters.space.read(root.subsection("Finite element"));
         parameters.linear_solver.read(root.subsection("Linear solver"));
       },
       "",
       {}},
      {"Time",
       "Of an analysis that steps through time.",
       {},
       [](ParameterSection root, const GeneralParameters &)
       { TimeParameters().read(root.subsection("Time")); },
       "",
       {}},
      {"Steady",
       "Of a steady analysis of fluid and solid together, which is stepped to rest.",
       {},
       [](ParameterSection root, const GeneralParameters &)
       { RestParameters().read(root.subsection("Steady")); },
       "",
       {}},
      {"Adaptivity",
       "How the mesh follows the solution.",
       {},
       [](ParameterSection root, const GeneralParameters &general) {
         AdaptationParameters().read(root.subsection("Adaptivity"),
                                     general.analysis == "transient");
       },
       "",
       {}},
      {"Output",
       "What is written, and when.",
       {},
       [](ParameterSection root, const GeneralParameters &)
       { OutputParameters().read(root.subsection("Output")); },
       "",
       {}},
      {"Probes",
       "A family: one subsection for each probe, called as you like.",
       {"Probes/<probe>/Fields=velocity", "Probes/<probe>/Boundary=<boundary>"},
       [](ParameterSection root, const GeneralParameters &)
       { Probes<2>(MPI_COMM_SELF).read(root.subsection("Probes"), {"<boundary>"}, {"<region>"}); },
       "",
       {}},
      {"Exact solution",
       "Functions with which the state at the end is compared.",
       {},
       [](ParameterSection root, const GeneralParameters &)
       { ErrorNorms<2>().read(root.subsection("Exact solution")); },
       "",
       {}},
      {"Expected",
       "A family of entries: values that the run must meet, each with a verdict at its end.",
       {"Expected/<quantity>=1 +- 1 %"},
       [](ParameterSection root, const GeneralParameters &)
       { read_expected(root.subsection("Expected")); },
       "",
       {}}};
  return list;
}

/// What a run with these entries would declare; nothing if it would refuse them.
std::vector<Entry> declared(const Section &section, const Overrides &overrides)
{
  ParameterFile file("", overrides);
  try
  {
    GeneralParameters general;
    general.read(file.root());
    if (section.read)
      section.read(file.root(), general);
  }
  catch (const InputError &)
  {
    return {};
  }
  std::stringstream text;
  file.print(text, ParameterFile::Style::json);
  std::vector<Entry> entries;
  for (const auto &data : nlohmann::ordered_json::parse(text))
    entries.push_back({data, ""});
  return entries;
}

std::vector<std::string> choices_of(const Entry &entry)
{
  const std::string values = entry.data["values"];
  std::vector<std::string> choices;
  for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 2)
  {
    end = values.find(", ", begin);
    choices.push_back(values.substr(begin, end - begin));
  }
  return choices;
}

/// Adds the entries that exist with `overrides`, and those that appear when a choice among them is
/// made otherwise, with the condition under which they exist.
void explore(const Section &section,
             const Overrides &overrides,
             const std::string &condition,
             std::vector<Entry> &entries)
{
  std::vector<Entry> found;
  for (Entry &entry : declared(section, overrides))
    if (std::none_of(entries.begin(), entries.end(),
                     [&](const Entry &other) { return other.path() == entry.path(); }))
    {
      entry.condition = condition;
      found.push_back(entry);
    }
  const auto is_fixed = [&](const Entry &entry)
  {
    return std::any_of(overrides.begin(), overrides.end(),
                       [&](const std::string &text)
                       { return text.compare(0, entry.path().size() + 1, entry.path() + "=") == 0; });
  };
}
} // namespace
} // namespace Continua
