#include <continua/case/rules/feature_rows.h>

#include <deal.II/base/exceptions.h>

#include <string_view>

namespace Continua
{
namespace
{
constexpr std::string_view word_of_entry = "set ", word_of_section = "subsection ";
constexpr std::string_view any_region = "<region>", any_boundary = "<name>";

bool begins_with(const std::string &text, const std::string_view beginning)
{
  return text.compare(0, beginning.size(), beginning) == 0;
}

/// "A/B/KEY = value" with `member` in the place of the name in angle brackets.
EntryPlace place_of_entry(const std::string &entry, const std::string &member)
{
  EntryPlace place;
  std::string path = entry.substr(0, entry.find(" = "));
  for (std::size_t slash = path.find('/'); slash != std::string::npos; slash = path.find('/'))
  {
    const std::string name = path.substr(0, slash);
    place.sections.push_back(name == any_region || name == any_boundary ? member : name);
    path.erase(0, slash + 1);
  }
  place.key = path;
  return place;
}

ParameterSection section_of(const ParameterSection &root, const std::vector<std::string> &names)
{
  ParameterSection section = root;
  for (const std::string &name : names)
    section = section.subsection(name);
  return section;
}
} // namespace

template <int dim>
FeaturesOfCase<dim>::FeaturesOfCase(const Case<dim> &input, ParameterSection root)
    : input(input), root(std::move(root))
{
}

template <int dim>
std::optional<EntryPlace> FeaturesOfCase<dim>::place(const std::string &name)
{
  const auto [found, is_new] = places.emplace(name, std::nullopt);
  if (is_new)
    found->second = find(name);
  return found->second;
}

template <int dim>
std::optional<EntryPlace> FeaturesOfCase<dim>::find_given(const std::string &entry) const
{
  if (input.discretisation.is_cell_wise()
          ? begins_with(entry, "Linear solver/") || begins_with(entry, "Finite element/")
          : begins_with(entry, "Cell-wise/"))
    return {};
  std::vector<std::string> members = {""};
  if (entry.find(any_region) != std::string::npos)
    members = input.problem.regions;
  else if (entry.find(any_boundary) != std::string::npos)
  {
    members.clear();
    for (const BoundaryCondition &condition : input.problem.conditions)
      members.push_back(condition.name);
  }
  for (const std::string &member : members)
    if (EntryPlace at = place_of_entry(entry, member); section_of(root, at.sections).given(at.key))
      return at;
  return {};
}

template <int dim>
std::optional<EntryPlace> FeaturesOfCase<dim>::find(const std::string &name) const
{
  if (begins_with(name, word_of_entry))
    return find_given(name.substr(word_of_entry.size()));
  if (begins_with(name, word_of_section))
  {
    EntryPlace at = place_of_entry(name.substr(word_of_section.size()), "");
    if (!section_of(root, at.sections).sets_in_subsection(at.key))
      return {};
    at.sections.push_back(at.key);
    at.key.clear();
    return at;
  }
  for (const FeatureGroup<dim> &group : feature_groups<dim>())
    for (const Feature<dim> &feature : group.features)
    {
      if (feature.name != name)
        continue;
      if (!input.analysis.has_fields && !feature.counts_without_fields)
        return {};
      if (feature.is_on != nullptr && feature.is_on(input))
        return place_of_entry(feature.entry, "");
      if (feature.is_of_region != nullptr)
        for (unsigned int region = 0; region < input.problem.regions.size(); ++region)
          if (feature.is_of_region(input, input.problem.materials[region]))
            return place_of_entry(feature.entry, input.problem.regions[region]);
      if (feature.is_of_boundary != nullptr)
        for (const BoundaryCondition &condition : input.problem.conditions)
          if (feature.is_of_boundary(input, condition))
            return place_of_entry(feature.entry, condition.name);
      return {};
    }
  Assert(false, dealii::ExcMessage("A rule names the feature '" + name + "', which no row has."));
  return {};
}

template <int dim>
const std::vector<FeatureGroup<dim>> &feature_groups()
{
  static const std::vector<FeatureGroup<dim>> groups = {
      analyses_as_features<dim>(), models_as_features<dim>(), liquids_as_features<dim>(),
      solids_as_features<dim>(),   meshes_as_features<dim>(), boundaries_as_features<dim>(),
      steps_as_features<dim>(),    solvers_as_features<dim>()};
  return groups;
}

template const std::vector<FeatureGroup<2>> &feature_groups();
template const std::vector<FeatureGroup<3>> &feature_groups();
template class FeaturesOfCase<2>;
template class FeaturesOfCase<3>;
} // namespace Continua
