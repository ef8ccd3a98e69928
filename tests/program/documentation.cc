// The printed documentation: complete, and in three forms.

#include <continua/boundary/boundary_condition.h>
#include <continua/boundary/boundary_types.h>
#include <continua/materials/material.h>
#include <continua/mesh/geometry.h>
#include <continua/program/analyses.h>
#include <continua/program/documentation.h>
#include <continua/program/parameter_catalogue.h>

#include <deal.II/base/mpi.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "../unit_test.h"

namespace test_of_documentation
{
namespace
{
using namespace Continua;

std::string printed(const ParameterFile::Style style)
{
  std::ostringstream out;
  print_documentation(out, style);
  return out.str();
}

bool contains(const std::string &text, const std::string &part)
{
  return text.find(part) != std::string::npos;
}

// Made when first asked for, in main: before that the library's own data may not be there yet.
const std::string &markdown()
{
  static const std::string text = printed(ParameterFile::Style::markdown);
  return text;
}

const nlohmann::json &entries()
{
  static const nlohmann::json list = nlohmann::json::parse(printed(ParameterFile::Style::json));
  return list;
}

/// The entry of that path, of a type; null if there is none.
nlohmann::json entry(const std::string &path, const std::string &type = "")
{
  for (const auto &item : entries())
    if (item["path"] == path && item["type"] == type)
      return item;
  return {};
}

/// Whether each type of a table has its heading, in the section of that title.
void check_types(const std::string &title,
                 const std::vector<std::pair<std::string, std::string>> &types)
{
  const std::size_t begin = markdown().find("## " + title + "\n");
  const std::string section = markdown().substr(begin, markdown().find("\n## ", begin) - begin);
  bool all = begin != std::string::npos;
  for (const auto &type : types)
    all = all && contains(section, "\n### " + type.first + "\n");
  check::is_true("types of " + title, all);
}

/// Whether what a run reads is documented, once the members of families have their stand-ins.
template <int dim>
void check_complete(const std::string &name, const std::string &text)
{
  std::ofstream("documentation-test.prm") << text;
  ParameterFile file("documentation-test.prm");
  const Case<dim> input = analyses().read_case<dim>(file, MPI_COMM_WORLD);
  std::stringstream run;
  file.print(run, ParameterFile::Style::json);
  bool all = true;
  for (const auto &item : nlohmann::json::parse(run))
  {
    std::string path = item["path"];
    path = std::regex_replace(path, std::regex("^Materials/[^/]+"), "Materials/<region>");
    path = std::regex_replace(path, std::regex("^Boundaries/[^/]+"), "Boundaries/<boundary>");
    path = std::regex_replace(path, std::regex("^Probes/[^/]+"), "Probes/<probe>");
    path =
        std::regex_replace(path, std::regex("^Geometry/Regions/.+"), "Geometry/Regions/<region>");
    path = std::regex_replace(path, std::regex("Pressures/.+"), "Pressures/<region>");
    path = std::regex_replace(path, std::regex("^Expected/.+"), "Expected/<quantity>");
    bool found = false;
    for (const auto &documented : entries())
      found = found || documented["path"] == path;
    if (!found)
      std::cout << "not documented: " << path << std::endl;
    all = all && found;
  }
  check::is_true(name, all);
}

std::string boundaries(const std::vector<std::string> &names)
{
  std::string text = "subsection Boundaries\n";
  for (const std::string &name : names)
    text += "subsection " + name + "\nset Type = " +
            (name == "axis"          ? name
             : name == "clamped end" ? "fixed"
                                     : "free") +
            "\nend\n";
  return text + "end\n";
}
} // namespace

UNIT_TEST(documentation)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  for (const char *title :
       {"General", "Geometry and mesh", "Painted regions", "Materials", "Boundaries",
        "Body force and initial state", "Discretisation", "Time", "Steady", "Periodic state",
        "Modal", "Spin coating", "Laboratory", "Wave theory", "Adaptivity", "Output", "Probes",
        "Exact solution", "Expected"})
    check::is_true(title, contains(markdown(), std::string("## ") + title + "\n"));
  check::is_true("choices as a list",
                 contains(markdown(), "What is done: <br>• `transient`: Steps through time.<br>• "
                                      "`steady`: State at rest"));
  check::is_true("a text without choices",
                 contains(markdown(), "What the run is called in summaries and legends. |"));
  check_types("Geometry and mesh", geometry_types<2>());
  check_types("Materials", material_types());
  check_types("Boundaries", boundary_types());
  for (const auto &type : analyses().types())
    check::is_true("analysis " + type.first,
                   contains(entry("Analysis")["values"].get<std::string>(), type.first));

  check::equal("entry of one type", entry("Materials/<region>/Shear moduli", "prony")["unit"],
               "Pa");
  check::is_true("not of another", entry("Materials/<region>/Shear moduli", "maxwell").is_null());
  check::is_true("shared by all types", !entry("Materials/<region>/Density").is_null());
  check::equal("choice", entry("Boundaries/<boundary>/Table", "pressure")["condition"],
               "Waveform = table");
  check::equal("choice in a choice", entry("Boundaries/<boundary>/Pressure", "mixed")["condition"],
               "Normal = pressure, Waveform = formula");
  check::equal("model", entry("Mesh/Grading z", "box")["condition"], "Model = three-dimensional");
  check::equal("analysis", entry("Adaptivity/Cycles")["condition"], "Analysis = steady");
  check::equal("family of entries", entry("Geometry/Regions/<region>")["values"], "text");
  check::is_true("default", entry("Time/Scheme")["default"] == "backward differencing");

  for (const CatalogueSection &section : parameter_catalogue())
    for (const CataloguePart &part : section.types)
    {
      if (part.type == "newtonian")
        check::is_true("models of a material",
                       part.models == std::vector<std::string>(
                                          {"plane strain", "axisymmetric", "three-dimensional"}));
      if (part.type == "beam")
        check::equal("names of a geometry", part.names.front(),
                     "plane strain, plane stress: regions: beam; boundaries: clamped end, free "
                     "end, bottom, top");
    }

  std::istringstream prm(printed(ParameterFile::Style::prm));
  int depth = 0, n_entries = 0;
  bool nested = true;
  for (std::string line; std::getline(prm, line);)
  {
    line.erase(0, line.find_first_not_of(' '));
    depth += line.compare(0, 11, "subsection ") == 0 ? 1 : line == "end" ? -1 : 0;
    n_entries += line.compare(0, 4, "set ") == 0 ? 1 : 0;
    nested = nested && depth >= 0;
  }
  check::is_true("subsections are closed", nested && depth == 0);
  check::is_true("as many entries in prm as in json",
                 n_entries == static_cast<int>(entries().size()));

  check_complete<2>(
      "transient run",
      "set Model = axisymmetric\nsubsection Geometry\nset Type = tube\n"
      "subsection Regions\nset stent = x - 0.09\nend\nend\n"
      "subsection Materials\nsubsection fluid\nset Type = newtonian\n"
      "set Density = 1\nset Viscosity = 1\nset Bulk modulus = 1\nend\n"
      "subsection wall\nset Type = prony\nset Density = 1\nset Young's modulus = 1\n"
      "set Poisson's ratio = 0.4\nset Shear moduli = 1\nset Relaxation times = 1\n"
      "end\nsubsection stent\nset Type = hookean\nset Density = 1\n"
      "set Young's modulus = 1\nset Poisson's ratio = 0.4\nend\nend\n"
      "subsection Time\nset Time step = 1\nset End time = 1\nend\n"
      "subsection Probes\nsubsection tip\nset Point = 0.05, 0\n"
      "set Fields = pressure\nend\nend\n"
      "subsection Expected\nset mean pressure = < 1\nend\n" +
          boundaries({"axis", "inlet", "outlet", "wall inlet end", "wall outlet end", "outside"}));
  check_complete<3>("steady run",
                    "set Model = three-dimensional\nset Analysis = steady\n"
                    "subsection Geometry\nset Type = beam\nend\n"
                    "subsection Materials\nsubsection beam\nset Type = kelvin-voigt\n"
                    "set Density = 1\nset Viscosity = 1\nset Young's modulus = 1\n"
                    "set Poisson's ratio = 0.4\nend\nend\n" +
                        boundaries({"clamped end", "free end", "bottom", "top", "front", "back"}));
  check_complete<2>("modal run", "set Analysis = modal\nsubsection Geometry\nset Type = beam\nend\n"
                                 "subsection Materials\nsubsection beam\nset Type = hookean\n"
                                 "set Density = 1\nset Young's modulus = 1\n"
                                 "set Poisson's ratio = 0.4\nend\nend\n" +
                                     boundaries({"clamped end", "free end", "bottom", "top"}));
  std::filesystem::remove("documentation-test.prm");
}
} // namespace test_of_documentation
