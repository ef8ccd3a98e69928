#include <continua/laboratory/artery_fit_parameters.h>

#include <continua/base/angle_entry.h>
#include <continua/base/joined.h>
#include <continua/materials/model.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Continua
{
namespace
{
std::vector<std::string> keys_of_arteries()
{
  std::vector<std::string> keys;
  for (const ArteryEntry &entry : artery_entries())
    keys.push_back(entry.key);
  return keys;
}

/// "media" and "Fibre stiffness" of "media/Fibre stiffness".
std::pair<std::string, std::string> layer_and_key(const std::string &path)
{
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? std::make_pair(std::string(), path)
                                    : std::make_pair(path.substr(0, slash), path.substr(slash + 1));
}

void read_bound(ParameterSection &section,
                const ArteryEntry &entry,
                const std::string &key,
                double &value)
{
  const std::string text = key == "Lower bound" ? "Smallest value that is tried, in the unit of "
                                                  "the entry."
                                                : "Largest value that is tried, in the unit of the "
                                                  "entry.";
  if (entry.is_angle)
    add_angle(section, key, value, text);
  else
    section.add(key, value, entry.dimension, text, Range{entry.lower, entry.upper});
}
} // namespace

void ArteryFitParameters::read(ParameterSection section)
{
  std::string file;
  section.add_input_file("Table", file,
                         "A csv file of an inflation-extension test with the columns axial stretch "
                         "(length over that of the ring without load), pressure, outer diameter or "
                         "inner diameter, and axial force (of a transducer at the closed end: that "
                         "of the wall less the pressure on the end), which may be missing; units "
                         "in its header. Required.");
  double inner_radius = std::numeric_limits<double>::quiet_NaN();
  section.add("Inner radius", inner_radius, Dimensions::length,
              "Inner radius of the closed ring without load, at axial stretch 1. With an opening "
              "angle the length of the closed ring is that of the opened one. Required.",
              Range::positive());
  section.add("Layers", layer_names,
              "Names of the layers in the section Materials, from the inside. Required.");
  section.add("Layer thicknesses", ring.layer_thicknesses, Dimensions::length,
              "Thicknesses of these layers in the closed ring without load. Required.",
              Range::positive());
  section.add("Diameter noise", diameter_noise, Dimensions::length,
              "Standard deviation of the measured diameters; 0: found from what the fit leaves.",
              Range::not_negative());
  section.add("Force noise", force_noise, Dimension{1, 1, -2},
              "Standard deviation of the measured axial forces; 0: found from what the fit leaves.",
              Range::not_negative());
  section.add("Starts", n_starts,
              "Places from which the search begins: that of the materials, and others that are "
              "spread over the bounds [1].",
              1, 100);
  for (const char *const key : {"Table", "Inner radius", "Layers", "Layer thicknesses"})
    section.require(key);
  if (layer_names.size() != ring.layer_thicknesses.size())
    section.refuse("Layer thicknesses",
                   "there are " + std::to_string(layer_names.size()) + " layers and " +
                       std::to_string(ring.layer_thicknesses.size()) + " thicknesses",
                   "Give one thickness for each layer");
  ring.inner_radius = inner_radius;
  ParameterSection family = section.subsection("Parameters");
  for (const std::string &name : family.subsections())
    read_parameter(family.subsection(name));
  if (!file.empty())
    test = read_inflation_test(file);
  if (section.given("Force noise") && !file.empty() && !test.has_force)
    section.refuse("Force noise", "the table has no column 'axial force'", "Remove it");
}

void ArteryFitParameters::read_parameter(ParameterSection section)
{
  Request request;
  section.add("Entries", request.entries,
              "Entries that have this number, a list of LAYER/ENTRY, such as media/Fibre "
              "stiffness; an entry is one of " +
                  joined(keys_of_arteries()) + ". Required.");
  section.require("Entries");
  const ArteryEntry *entry = nullptr;
  for (const std::string &path : request.entries)
  {
    const std::string key = layer_and_key(path).second;
    const ArteryEntry *const found = find_artery_entry(key);
    if (found == nullptr || layer_and_key(path).first.empty())
      section.refuse("Entries", "'" + path + "' is no entry of a layer that a test determines",
                     "Write LAYER/ENTRY, where the entry is one of " + joined(keys_of_arteries()));
    if (entry != nullptr && found != entry)
      section.refuse("Entries", "'" + entry->key + "' and '" + key + "' cannot be one number",
                     "Give entries of one name");
    entry = found;
  }
  if (entry == nullptr)
    return;
  request.fit.name = section.name();
  request.fit.unit = entry->unit();
  request.fit.scale = entry->scale;
  request.fit.lower = entry->lower;
  request.fit.upper = entry->upper;
  read_bound(section, *entry, "Lower bound", request.fit.lower);
  read_bound(section, *entry, "Upper bound", request.fit.upper);
  if (!(request.fit.lower < request.fit.upper))
    section.refuse(section.given("Lower bound") ? "Lower bound" : "Upper bound",
                   "the lower bound is not below the upper one",
                   "Give a lower bound below the upper one");
  if (request.fit.lower < entry->lower || request.fit.upper > entry->upper)
    section.refuse(request.fit.lower < entry->lower ? "Lower bound" : "Upper bound",
                   "an entry '" + entry->key + "' lies between " + entry->text(entry->lower) +
                       " and " + entry->text(entry->upper),
                   "Give a bound between both");
  requests.push_back(request);
}

void ArteryFitParameters::read_layers(ParameterSection materials, ParameterSection section)
{
  for (const std::string &name : layer_names)
  {
    if (!materials.has_subsection(name))
      section.refuse("Layers", "there is no material '" + name + "'",
                     "Give it a subsection of Materials, or correct the name");
    if (std::count(layer_names.begin(), layer_names.end(), name) > 1)
      section.refuse("Layers", "the layer '" + name + "' is named twice",
                     "Give each layer a material of its own");
    ParameterSection of_layer = materials.subsection(name);
    Material material = read_material(of_layer, Model::three_dimensional);
    const bool is_elastic =
        material.is_solid() && !material.relaxes() && material.shear.viscosity == 0.;
    if (!is_elastic || !material.is_incompressible())
      of_layer.refuse(is_elastic ? "Poisson's ratio" : "Type",
                      "the wall of this test is elastic and incompressible",
                      "Set Type = hookean and Poisson's ratio = 0.5");
    read_strain_law(of_layer, material);
    if (of_layer.given("Axial prestretch"))
      of_layer.refuse("Axial prestretch", "the table has the axial stretches", "Remove it");
    ring.layers.push_back(material);
  }
  materials.refuse_unknown_members(layer_names, "layer");
  if (requests.empty())
    section.refuse_missing("there is no parameter to find",
                           "Add 'subsection Parameters' with a subsection for each, of any name, "
                           "such as 'set Entries = " +
                               layer_names.front() + "/Fibre stiffness'");
  ParameterSection family = section.subsection("Parameters");
  for (const Request &request : requests)
    take_parameter(request, family.subsection(request.fit.name));
}

void ArteryFitParameters::take_parameter(const Request &request, const ParameterSection &section)
{
  ArteryParameter parameter;
  parameter.fit = request.fit;
  for (const std::string &path : request.entries)
  {
    const auto [layer, key] = layer_and_key(path);
    const auto place = std::find(layer_names.begin(), layer_names.end(), layer);
    if (place == layer_names.end())
      section.refuse("Entries", "there is no layer '" + layer + "'",
                     "The layers are " + joined(layer_names));
    parameter.layers.push_back(place - layer_names.begin());
    parameter.entry = find_artery_entry(key);
    const Material &material = ring.layers[parameter.layers.back()];
    if (!parameter.entry->strain_law.empty() &&
        parameter.entry->strain_law != material.strain_law_parameters.type)
      section.refuse("Entries",
                     "the strain law '" + material.strain_law_parameters.type + "' of the layer '" +
                         layer + "' has no entry '" + key + "'",
                     "Take an entry of this law, or another law for the layer");
    if (std::count(request.entries.begin(), request.entries.end(), path) > 1)
      section.refuse("Entries", "'" + path + "' is named twice", "Name each entry once");
    const double first = parameter.entry->value(ring.layers[parameter.layers.front()]),
                 value = parameter.entry->value(material);
    if (std::abs(value - first) > 1e-9 * std::abs(first))
      section.refuse("Entries",
                     "the layers have '" + key + "' = " + parameter.entry->text(first) + " and " +
                         parameter.entry->text(value) + ", and the search begins with one number",
                     "Give the layers the same value in Materials");
    for (const ArteryParameter &other : parameters)
      if (other.entry == parameter.entry &&
          std::count(other.layers.begin(), other.layers.end(), parameter.layers.back()) > 0)
        section.refuse("Entries",
                       "'" + path + "' belongs to the parameter '" + other.fit.name + "', too",
                       "Name each entry once");
  }
  parameter.fit.start = parameter.entry->value(ring.layers[parameter.layers.front()]);
  if (parameter.fit.start < parameter.fit.lower || parameter.fit.start > parameter.fit.upper)
    section.refuse("Entries",
                   "the search begins at " + parameter.entry->text(parameter.fit.start) +
                       ", the value of the material, which is outside of the bounds " +
                       parameter.entry->text(parameter.fit.lower) + " and " +
                       parameter.entry->text(parameter.fit.upper),
                   "Give the material another value, or the parameter other bounds");
  parameters.push_back(parameter);
}
} // namespace Continua
