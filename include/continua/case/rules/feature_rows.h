#ifndef continua_case_rules_feature_rows_h
#define continua_case_rules_feature_rows_h

#include <continua/case/rules/feature.h>

namespace Continua
{
/// A row of a feature of the whole input; the arguments are the members of Feature.
template <int dim>
Feature<dim> of_input(const std::string &name,
                      const std::string &entry,
                      bool (*is_on)(const Case<dim> &),
                      const bool counts_without_fields = false)
{
  return {name, entry, is_on, nullptr, nullptr, counts_without_fields};
}

/// The same of a region.
template <int dim>
Feature<dim> of_region(const std::string &name,
                       const std::string &entry,
                       bool (*is_of_region)(const Case<dim> &, const Material &))
{
  return {name, entry, nullptr, is_of_region, nullptr, false};
}

/// The same of a boundary.
template <int dim>
Feature<dim> of_boundary(const std::string &name,
                         const std::string &entry,
                         bool (*is_of_boundary)(const Case<dim> &, const BoundaryCondition &),
                         const bool counts_without_fields = false)
{
  return {name, entry, nullptr, nullptr, is_of_boundary, counts_without_fields};
}

template <int dim>
bool is_in_time(const Case<dim> &input)
{
  return input.analysis.motion == Motion::in_time;
}

template <int dim>
bool is_taylor_hood(const Case<dim> &input)
{
  return !input.discretisation.is_cell_wise();
}

template <int dim>
bool has_formulation(const Case<dim> &input, const Formulation formulation)
{
  return input.discretisation.is_cell_wise() &&
         input.discretisation.cell_wise.formulation == formulation;
}

// The groups of feature_groups().
template <int dim>
FeatureGroup<dim> analyses_as_features();
template <int dim>
FeatureGroup<dim> models_as_features();
template <int dim>
FeatureGroup<dim> liquids_as_features();
template <int dim>
FeatureGroup<dim> solids_as_features();
template <int dim>
FeatureGroup<dim> meshes_as_features();
template <int dim>
FeatureGroup<dim> boundaries_as_features();
template <int dim>
FeatureGroup<dim> steps_as_features();
template <int dim>
FeatureGroup<dim> solvers_as_features();
} // namespace Continua

#endif
