#include <continua/vessel/wall_layers.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Continua
{
WallLayers WallLayers::read(ParameterSection geometry)
{
  WallLayers layers;
  std::vector<std::string> &names = layers.names;
  std::vector<double> parts;
  geometry.add("Wall layers", names,
               "The names of the wall's layers from the inner to the outer one; each is a region. "
               "'none': the vessel is rigid, it has no wall, and the boundary 'outside' is that of "
               "the fluid, with Type = fixed");
  geometry.add("Layer fractions", parts, Dimensions::none,
               "Each layer's part of the wall thickness, from the inner to the outer one; their "
               "sum is 1. Without it, all layers are equally thick [1]",
               Range::positive());
  if (names.empty())
    geometry.refuse("Wall layers", "the list is empty", "Give at least one name, or 'none'");
  if (names == std::vector<std::string>{"none"})
  {
    if (geometry.given("Layer fractions"))
      geometry.refuse("Layer fractions", "the vessel has no wall (Wall layers = none)",
                      "Remove the entry or name the layers");
    return {{}, {}};
  }
  for (auto name = names.begin(); name != names.end(); ++name)
    if (*name == "none")
      geometry.refuse("Wall layers", "'none' stands beside other names",
                      "Give 'none' alone, for a rigid vessel, or the names of layers");
    else if (*name == "fluid")
      geometry.refuse("Wall layers", "'fluid' is the name of the region inside the wall",
                      "Give the layer another name");
    else if (std::find(names.begin(), name, *name) != name)
      geometry.refuse("Wall layers", "two layers have the name '" + *name + "'",
                      "Give every layer a name of its own");
  if (!geometry.given("Layer fractions"))
    parts.assign(names.size(), 1. / names.size());
  if (parts.size() != names.size())
    geometry.refuse("Layer fractions",
                    std::to_string(parts.size()) + " numbers for " + std::to_string(names.size()) +
                        " layers",
                    "Give one number for each of 'Wall layers'");
  const double sum = std::accumulate(parts.begin(), parts.end(), 0.);
  // What decimal digits of thirds leave over.
  if (std::abs(sum - 1.) > 1e-5)
    geometry.refuse("Layer fractions",
                    "their sum is " + shortest_number(std::round(1e6 * sum) / 1e6) + ", not 1",
                    "Give the parts of the whole wall thickness");
  for (double &part : parts)
    part /= sum;
  layers.fractions = parts;
  return layers;
}
} // namespace Continua
