#ifndef continua_case_rules_feature_h
#define continua_case_rules_feature_h

#include <continua/case/case.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace Continua
{
/**
 * A choice that an input can make, and that rules name: an analysis, a model, a type of boundary.
 * One of the three functions says whether it is on: in the whole input, in some region, or on some
 * boundary.
 */
template <int dim>
struct Feature
{
  std::string name;
  /// The entry that turns it on, such as "Flow/Time treatment = explicit"; "<region>" and "<name>"
  /// stand for a region and for a member of Boundaries.
  std::string entry;
  bool (*is_on)(const Case<dim> &input) = nullptr;
  bool (*is_of_region)(const Case<dim> &input, const Material &material) = nullptr;
  bool (*is_of_boundary)(const Case<dim> &input, const BoundaryCondition &condition) = nullptr;
  /// Whether it also counts in an analysis without fields.
  bool counts_without_fields = false;
};

/// Features that belong together, with their heading in the manual.
template <int dim>
struct FeatureGroup
{
  std::string title;
  std::vector<Feature<dim>> features;
};

/// All features. To add one, add a row.
template <int dim>
const std::vector<FeatureGroup<dim>> &feature_groups();

/// An entry of a file, or a whole section where the key is empty.
struct EntryPlace
{
  std::vector<std::string> sections;
  std::string key;
};

/// Which features are on in one input, and where.
template <int dim>
class FeaturesOfCase
{
public:
  /// Both must live longer than this.
  FeaturesOfCase(const Case<dim> &input, ParameterSection root);

  /**
   * Where the file turns on what `name` says, or nothing if it is off: the name of a feature, "set
   * SECTION/KEY" for an entry that is given, or "subsection SECTION" for a section in which
   * something is given. Entries of the section of the other discretisation do not count, so that
   * one word of a file changes its discretisation.
   */
  std::optional<EntryPlace> place(const std::string &name);

private:
  const Case<dim> &input;
  ParameterSection root;
  std::map<std::string, std::optional<EntryPlace>> places; ///< those that were asked for

  std::optional<EntryPlace> find(const std::string &name) const;
  std::optional<EntryPlace> find_given(const std::string &entry) const;
};
} // namespace Continua

#endif
