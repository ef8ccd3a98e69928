#include <continua/boundary/boundary_types.h>
#include <continua/program/parameter_catalogue.h>

#include <continua/base/input_error.h>
#include <continua/base/joined.h>
#include <continua/base/parameter_text.h>
#include <continua/boundary/boundary_conditions.h>
#include <continua/case/case.h>
#include <continua/case/measured_waves.h>
#include <continua/continuum/convection.h>
#include <continua/continuum/wall_directions_parameters.h>
#include <continua/laboratory/amplification_parameters.h>
#include <continua/laboratory/artery_fit_parameters.h>
#include <continua/laboratory/laboratory_parameters.h>
#include <continua/laboratory/material_fit_parameters.h>
#include <continua/materials/material.h>
#include <continua/materials/strain_law_types.h>
#include <continua/mesh/geometry.h>
#include <continua/network/network_parameters.h>
#include <continua/program/analyses.h>
#include <continua/studies/comparison_parameters.h>
#include <continua/studies/identification_parameters.h>
#include <continua/studies/refinement_study_parameters.h>
#include <continua/studies/sweep_parameters.h>
#include <continua/vessel/spin_coating.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

namespace Continua
{
namespace
{
using Entries = std::vector<CatalogueEntry>;
using Overrides = std::vector<std::string>;

/// What a section of the documentation is made of.
struct Source
{
  const char *title;
  const char *introduction;
  Overrides members; ///< of families, without which they would declare nothing
  void (*read)(ParameterSection &root, const GeneralParameters &general);
  std::string type_path; ///< the entry that picks a row of `types`
  std::vector<std::pair<std::string, std::string>> types;
};

/// What the geometry calls its parts.
template <int dim>
std::string read_geometry_in(ParameterSection &root, const bool axisymmetric)
{
  const auto geometry =
      make_geometry<dim>(root.subsection("Geometry"), root.subsection("Mesh"), axisymmetric);
  MeshParameters::read(root.subsection("Mesh"));
  return "regions: " + joined(geometry->regions()) +
         "; boundaries: " + joined(geometry->boundaries());
}

std::string names_of_geometry(ParameterSection &root, const GeneralParameters &general)
{
  const Model model = model_of(general.model);
  return n_dimensions(model) == 3 ? read_geometry_in<3>(root, false)
                                  : read_geometry_in<2>(root, model == Model::axisymmetric);
}

void read_geometry(ParameterSection &root, const GeneralParameters &general)
{
  names_of_geometry(root, general);
}

void read_region(ParameterSection &root, const GeneralParameters &general)
{
  read_material(root.subsection("Materials").subsection("<region>"), model_of(general.model));
}

void read_strain_law_of_region(ParameterSection &root, const GeneralParameters &)
{
  ParameterSection region = root.subsection("Materials").subsection("<region>");
  StrainLawParameters().read(region, false);
  Prestretch().read(region);
}

/// Name and line of the laws of finite deformation.
std::vector<std::pair<std::string, std::string>> strain_law_names()
{
  std::vector<std::pair<std::string, std::string>> names;
  for (const StrainLawType &row : strain_law_types())
    names.emplace_back(row.name, row.description);
  return names;
}

void read_boundary(ParameterSection &root, const GeneralParameters &general)
{
  const Model model = model_of(general.model);
  read_boundary_conditions(root.subsection("Boundaries"), {"<boundary>"}, {"<region>"}, {{0, 0}},
                           n_dimensions(model), model == Model::axisymmetric);
}

void read_interior(ParameterSection &root, const GeneralParameters &general)
{
  InteriorData().read(root.subsection("Body force"), root.subsection("Initial state"), {"<region>"},
                      n_dimensions(model_of(general.model)));
}

void read_discretisation(ParameterSection &root, const GeneralParameters &general)
{
  DiscretisationParameters().read(root, general.discretisation);
}

void read_probe(ParameterSection &root, const GeneralParameters &)
{
  Probes<2>(MPI_COMM_SELF).read(root.subsection("Probes"), {"<boundary>"}, {"<region>"});
  MeasuredWavesEntries().read(root.subsection("Probes").subsection("<probe>"));
}

/// The sections in the order of the documentation: to document a further one, add a row.
std::vector<Source> sources()
{
  using Root = ParameterSection;
  using General = GeneralParameters;
  return {
      {"General",
       "At the top of the file, outside all subsections.",
       {},
       [](Root &, const General &) {},
       "",
       {}},
      {"Geometry and mesh",
       "The shape, whose type decides how its regions and boundaries are called, and its coarse "
       "mesh.",
       {},
       read_geometry,
       "Geometry/Type",
       geometry_types<2>()},
      {"Painted regions",
       "A family of entries, one for each region that is cut out of a geometry.",
       {"Geometry/Regions/<region>=x - 0.5"},
       read_geometry,
       "",
       {}},
      {"Materials",
       "A family: one subsection for each region of the geometry, called after it.",
       {},
       read_region,
       "Materials/<region>/Type",
       material_types()},
      {"Laws of finite deformation",
       "Entries of the solids among the materials with `Deformation = finite`.",
       {},
       read_strain_law_of_region,
       "Materials/<region>/Strain law",
       strain_law_names()},
      {"Wall directions",
       "What is along and around a wall, for its fibres and its prestretch, with `Deformation = "
       "finite`.",
       {},
       [](Root &root, const General &general)
       {
         WallDirectionsParameters().read(root.subsection("Wall directions"), {"<boundary>"},
                                         model_of(general.model));
       },
       "",
       {}},
      {"Boundaries",
       "A family: one subsection for each boundary of the geometry, called after it.",
       {},
       read_boundary,
       "Boundaries/<boundary>/Type",
       boundary_types()},
      {"Body force and initial state",
       "What acts inside the body, and the state at t = 0, which is rest unless it is given.",
       {},
       read_interior,
       "",
       {}},
      {"Discretisation",
       "How the equations are discretised in space, and how the systems are solved.",
       {},
       read_discretisation,
       "",
       {}},
      {"Flow",
       "Convection of the liquids, where Convection at the top of the file says so, and Newton's "
       "iteration of its steps.",
       {},
       [](Root &root, const General &)
       {
         Convection().read(root.subsection("Flow"));
         NewtonParameters().read(root.subsection("Newton"));
       },
       "",
       {}},
      {"Time",
       "The time steps, and the end.",
       {},
       [](Root &root, const General &) { TimeParameters().read(root.subsection("Time")); },
       "",
       {}},
      {"Steady",
       "How a body of fluid and solid together is stepped to a steady state.",
       {},
       [](Root &root, const General &)
       { SteadyParameters().read(root.subsection("Steady"), false); },
       "",
       {}},
      {"Periodic state",
       "A run of several beats, which are compared one with the next.",
       {},
       [](Root &root, const General &)
       { PeriodicStateParameters().read(root.subsection("Periodic state")); },
       "",
       {}},
      {"Modal",
       "Which of a body's modes of vibration are sought.",
       {},
       [](Root &root, const General &) { ModalParameters().read(root.subsection("Modal")); },
       "",
       {}},
      {"Harmonic",
       "At which frequencies a body is shaken, and by what.",
       {},
       [](Root &root, const General &)
       {
         HarmonicParameters().read(root.subsection("Harmonic"));
         for (const char *const name : {"Body force", "<boundary>"})
           HarmonicParameters::read_phase(name == std::string("<boundary>")
                                              ? root.subsection("Boundaries").subsection(name)
                                              : root.subsection(name));
       },
       "",
       {}},
      {"Resonances",
       "Which resonances of a body are sought, and how.",
       {"Resonances/Lowest frequency=1 Hz", "Resonances/Highest frequency=2 Hz"},
       [](Root &root, const General &)
       { ResonanceParameters().read(root.subsection("Resonances")); },
       "",
       {}},
      {"Periodic response",
       "How many harmonics a periodic state has.",
       {},
       [](Root &root, const General &)
       { PeriodicResponseParameters().read(root.subsection("Periodic response")); },
       "",
       {}},
      {"Pulse response",
       "How closely the loads of a pulse are followed.",
       {},
       [](Root &root, const General &)
       { PulseResponseParameters().read(root.subsection("Pulse response")); },
       "",
       {}},
      {"Comparison",
       "By which two ways a case is computed, on which meshes, and what counts as agreement.",
       {"Comparison/Expected/<quantity>=1 +- 1 %"},
       [](Root &root, const General &) { ComparisonParameters().read(root); },
       "",
       {}},
      {"Refinement study",
       "How the mesh becomes finer, how often, and to what errors are.",
       {"Refinement study/Reference/<quantity>=1", "Refinement study/Expected/<quantity>=1 +- 1 %"},
       [](Root &root, const General &) { RefinementStudyParameters().read(root); },
       "",
       {}},
      {"Identification",
       "Which numbers of the file are sought, and what is known of the noise.",
       {"Identification/Parameters/<number>/Entry=Geometry/Wall thickness",
        "Identification/Material tests/<test>/Material=wall",
        "Identification/Noise/<field>=from rest", "Identification/Expected noise/<field>=1 Pa",
        "Identification/Correlation time=1 ms", "Identification/Model error=simulation",
        "Identification/Entries of the other model/<entry>=1",
        "Identification/Expected/<quantity>=1 +- 1 %"},
       [](Root &root, const General &) { IdentificationParameters().read(root); },
       "",
       {}},
      {"Sweep",
       "Which entries take which values, and what the table has.",
       {"Sweep/Entries/<entry>=1, 2", "Sweep/Expected/<quantity>=1 +- 1 %"},
       [](Root &root, const General &) { SweepParameters().read(root); },
       "",
       {}},
      {"Spin coating",
       "How a tube is made.",
       {},
       [](Root &root, const General &) { SpinCoating::read(root.subsection("Spin coating")); },
       "",
       {}},
      {"Laboratory",
       "What is reported of a material, and its simulated tests.",
       {},
       [](Root &root, const General &)
       { LaboratoryParameters().read(root.subsection("Laboratory")); },
       "",
       {}},
      {"Material fit",
       "Tables of tests of a bar, and the law that is fitted to them.",
       {},
       [](Root &root, const General &)
       { MaterialFitParameters().read(root.subsection("Material fit")); },
       "",
       {}},
      {"Artery fit",
       "An inflation-extension test of an artery, and a family of what is sought in it: one "
       "subsection of Parameters for each, called as you like.",
       {"Artery fit/Parameters/<parameter>/Entries=<layer>/Fibre stiffness"},
       [](Root &root, const General &)
       { ArteryFitParameters().read(root.subsection("Artery fit")); },
       "",
       {}},
      {"Amplification",
       "Which schemes in time, Courant numbers and waves.",
       {},
       [](Root &root, const General &)
       { AmplificationParameters().read(root.subsection("Amplification")); },
       "",
       {}},
      {"Network",
       "Vessels in one dimension, elements without a length, and four families, one subsection "
       "each, called as you like: Vessels, Elements, Terminals (by the node of the loose end) and "
       "Stations.",
       {"Network/Vessels/<vessel>/From=<node>", "Network/Stations/<station>/Vessel=<vessel>"},
       [](Root &root, const General &) { NetworkParameters().read(root.subsection("Network")); },
       "",
       {}},
      {"Elements of a network",
       "What has no length in a network: between two nodes, or at one.",
       {},
       [](Root &root, const General &)
       {
         ElementEntries::read(
             root.subsection("Network").subsection("Elements").subsection("<element>"));
       },
       "Network/Elements/<element>/Type",
       ElementEntries::types()},
      {"Terminals of a network",
       "What stands at the loose ends of vessels, by the node.",
       {},
       [](Root &root, const General &) {
         TerminalEntries::read(
             root.subsection("Network").subsection("Terminals").subsection("<node>"));
       },
       "Network/Terminals/<node>/Type",
       TerminalEntries::types()},
      {"Wave theory",
       "Linear waves of a tube, as an analysis of their own or beside a transient one.",
       {},
       [](Root &root, const General &)
       { WaveTheoryParameters().read(root.subsection("Wave theory")); },
       "",
       {}},
      {"Adaptivity",
       "How the mesh follows the solution.",
       {},
       [](Root &root, const General &general)
       {
         // As Case reads it.
         const Motion motion = analyses().row(general.analysis).traits_2d.motion;
         AdaptationParameters().read(root.subsection("Adaptivity"), motion != Motion::steady);
       },
       "",
       {}},
      {"Output",
       "What is written, and when.",
       {},
       [](Root &root, const General &) { OutputParameters().read(root.subsection("Output")); },
       "",
       {}},
      {"Probes",
       "A family: one subsection for each probe, called as you like.",
       {"Probes/<probe>/Fields=velocity", "Probes/<probe>/Boundary=<boundary>"},
       read_probe,
       "",
       {}},
      {"Exact solution",
       "Functions with which the state at the end is compared.",
       {},
       [](Root &root, const General &) { ErrorNorms<2>().read(root.subsection("Exact solution")); },
       "",
       {}},
      {"Expected",
       "A family of entries: values that the run must meet, each with a verdict at its end.",
       {"Expected/<quantity>=1 +- 1 %"},
       [](Root &root, const General &) { read_expected(root.subsection("Expected")); },
       "",
       {}}};
}

std::string path_of(const CatalogueEntry &entry)
{
  std::vector<std::string> path = entry.section;
  path.push_back(entry.key);
  return join_path(path);
}

std::vector<std::string> split(const std::string &text, const std::string &separator)
{
  std::vector<std::string> items;
  for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + separator.size())
  {
    end = text.find(separator, begin);
    items.push_back(text.substr(begin, end - begin));
  }
  return items;
}

CatalogueEntry *find(Entries &entries, const std::string &path)
{
  const auto place = std::find_if(entries.begin(), entries.end(),
                                  [&path](const auto &entry) { return path_of(entry) == path; });
  return place == entries.end() ? nullptr : &*place;
}

/// The overrides with this entry set.
Overrides with(Overrides overrides, const std::string &path, const std::string &value)
{
  overrides.erase(std::remove_if(overrides.begin(), overrides.end(),
                                 [&path](const auto &text)
                                 { return text.compare(0, path.size() + 1, path + "=") == 0; }),
                  overrides.end());
  overrides.push_back(path + "=" + value);
  return overrides;
}

/// What a run with these entries declares; nothing if it refuses them.
Entries declared(const Source &source, const Overrides &overrides)
{
  ParameterFile file("", overrides);
  try
  {
    GeneralParameters general;
    ParameterSection root = file.root();
    general.read(root, analyses().types());
    source.read(root, general);
  }
  catch (const InputError &)
  {
    return {};
  }
  std::stringstream text;
  file.print(text, ParameterFile::Style::json);
  Entries entries;
  for (const auto &item : nlohmann::json::parse(text))
  {
    std::vector<std::string> path = split(item["path"], "/");
    const std::string key = path.back();
    path.pop_back();
    entries.push_back({path, key, item["default"], item["values"], item["unit"], item["text"], ""});
  }
  return entries;
}

/// Makes every other choice that `fresh`, some of the entries declared with `overrides`, allow.
/// Adds what then appears to `entries`, and to what does not always exist the condition.
void explore(const Source &source,
             const Overrides &overrides,
             const Entries &fresh,
             Entries &entries)
{
  for (const CatalogueEntry &choice : fresh)
  {
    const std::string path = path_of(choice);
    std::vector<std::pair<std::string, Entries>> runs;
    if (path != source.type_path && choice.values.find(", ") != std::string::npos)
      for (const std::string &value : split(choice.values, ", "))
      {
        runs.emplace_back(value, declared(source, with(overrides, path, value)));
        if (runs.back().second.empty())
          runs.pop_back();
      }
    std::vector<Entries> found(runs.size());
    for (unsigned int i = 0; i < runs.size(); ++i)
      for (CatalogueEntry &entry : runs[i].second)
      {
        std::string note;
        unsigned int n_present = 0;
        for (auto &run : runs)
          if (find(run.second, path_of(entry)) != nullptr)
          {
            note += (n_present++ == 0 ? choice.key + " = " : " or ") + run.first;
          }
        if (n_present == runs.size())
          continue;
        Entries first = fresh;
        if (find(first, path_of(entry)) == nullptr)
          found[i].push_back(entry);
        CatalogueEntry *known = find(entries, path_of(entry));
        if (known == nullptr)
        {
          entry.condition = find(entries, path)->condition;
          entries.push_back(entry);
          known = &entries.back();
        }
        if (known->condition.find(note) == std::string::npos)
          known->condition += (known->condition.empty() ? "" : ", ") + note;
      }
    for (unsigned int i = 0; i < runs.size(); ++i)
      if (!found[i].empty())
        explore(source, with(overrides, path, runs[i].first), found[i], entries);
  }
}

/// Adds what the geometry calls its parts in this model, if that is new.
void add_names(const Overrides &overrides,
               const std::string &model,
               std::vector<std::string> &lines)
{
  ParameterFile file("", with(overrides, "Model", model));
  GeneralParameters general;
  ParameterSection root = file.root();
  general.read(root, analyses().types());
  const std::string names = names_of_geometry(root, general);
  for (std::string &line : lines)
    if (line.size() > names.size() &&
        line.compare(line.size() - names.size() - 2, std::string::npos, ": " + names) == 0)
    {
      line.insert(line.size() - names.size() - 2, ", " + model);
      return;
    }
  lines.push_back(model + ": " + names);
}

CataloguePart
make_part(const Source &source, const std::string &type, const std::string &description)
{
  Overrides overrides = source.members;
  if (!source.type_path.empty())
    overrides.push_back(source.type_path + "=" + type);
  CataloguePart part{type, description, {}, {}, {}};
  for (const std::string &model : model_names())
  {
    const Entries entries = declared(source, with(overrides, "Model", model));
    if (entries.empty())
      continue;
    if (part.models.empty())
    {
      part.entries = entries;
      explore(source, with(overrides, "Model", model), entries, part.entries);
    }
    part.models.push_back(model);
    if (source.type_path == "Geometry/Type")
      add_names(overrides, model, part.names);
  }
  // Else the members of a family in the row of sources() are not what its reader accepts.
  Assert(!part.models.empty(), dealii::ExcInternalError());
  return part;
}

/// " Read with Analysis = modal."; empty where the table of analyses does not list the section.
std::string of_analyses(const std::string &section)
{
  std::string text;
  for (const AnalysisRow &row : analyses().rows())
    if (std::find(row.sections.begin(), row.sections.end(), section) != row.sections.end())
      text += (text.empty() ? " Read with Analysis = " : ", ") + row.name;
  return text.empty() ? "" : text + ".";
}

std::vector<CatalogueSection> make_catalogue()
{
  Entries listed;
  const auto remove_listed = [&listed](Entries &entries)
  {
    entries.erase(std::remove_if(entries.begin(), entries.end(),
                                 [&listed](const auto &entry)
                                 { return find(listed, path_of(entry)) != nullptr; }),
                  entries.end());
  };
  std::vector<CatalogueSection> catalogue;
  for (const Source &source : sources())
  {
    const std::string introduction = source.introduction + of_analyses(source.title);
    CatalogueSection section{source.title, "", {"", introduction, {}, {}, {}}, {}};
    if (source.types.empty())
      section.shared = make_part(source, "", introduction);
    else
    {
      section.type_key = split(source.type_path, "/").back();
      for (const auto &[type, description] : source.types)
        section.types.push_back(make_part(source, type, description));
      // What all types have alike is said once.
      for (const CatalogueEntry &entry : section.types.front().entries)
        if (std::all_of(section.types.begin(), section.types.end(),
                        [&entry](const CataloguePart &part) {
                          return std::find(part.entries.begin(), part.entries.end(), entry) !=
                                 part.entries.end();
                        }))
          section.shared.entries.push_back(entry);
    }
    remove_listed(section.shared.entries);
    listed.insert(listed.end(), section.shared.entries.begin(), section.shared.entries.end());
    Entries of_types;
    for (CataloguePart &part : section.types)
    {
      remove_listed(part.entries);
      of_types.insert(of_types.end(), part.entries.begin(), part.entries.end());
    }
    listed.insert(listed.end(), of_types.begin(), of_types.end());
    catalogue.push_back(section);
  }
  return catalogue;
}
} // namespace

bool CatalogueEntry::operator==(const CatalogueEntry &other) const
{
  return section == other.section && key == other.key && default_value == other.default_value &&
         values == other.values && unit == other.unit && text == other.text &&
         condition == other.condition;
}

const std::vector<CatalogueSection> &parameter_catalogue()
{
  static const std::vector<CatalogueSection> catalogue = make_catalogue();
  return catalogue;
}
} // namespace Continua
