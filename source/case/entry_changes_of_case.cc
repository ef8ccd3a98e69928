// What a case is with other values of its entries, see EntryChange.

#include <continua/case/case.h>

#include <continua/boundary/boundary_conditions.h>
#include <continua/boundary/flow_rates.h>
#include <continua/boundary/outlets.h>
#include <continua/continuum/field_list.h>

#include <utility>

namespace Continua
{
namespace
{
/// In plane stress Poisson's ratio is a part of what these fields are.
template <int dim>
void refuse_changed_probes(const Case<dim> &input,
                           const EntryChange &change,
                           const ParameterSection &section)
{
  const Problem &problem = input.problem;
  for (std::size_t region = 0; region < problem.plane_stress_factors.size(); ++region)
    // The last node is never the number itself; the first one is, where the entry is at a bound.
    if (change.problems.back().plane_stress_factors[region].pressure_factor !=
        problem.plane_stress_factors[region].pressure_factor)
      for (const ProbeColumnName &column : input.probes.expected_columns(field_names<dim>(problem)))
        if (column.field == "strain zz" || column.field.compare(0, 8, "pressure") == 0)
          section.refuse("Entries",
                         "in plane stress the field '" + column.field +
                             "' of a probe depends on '" + change.entry.entry.path() +
                             "' itself, which no derivative knows of",
                         "Remove the entry, or the field of the probe");
}

} // namespace

template <int dim>
void Case<dim>::prepare_entry_changes(ParameterFile &file)
{
  const ParameterSection section = file.root().subsection("Harmonic").subsection("Sensitivities");
  for (const SensitivityEntry &entry : SensitivityEntry::find(file, harmonic.sensitivities))
  {
    EntryChange change{entry, {}, {}};
    for (const double node : entry.formula.nodes)
      try
      {
        ParameterFile changed = file.changed(NumericEntry::settings({entry.entry}, {node}));
        change.phases.emplace_back();
        change.problems.push_back(changed_problem(changed, change.phases.back()));
      }
      catch (const InputError &error)
      {
        section.refuse("Entries",
                       "'" + entry.entry.path() +
                           "' cannot be a thousandth more and less: " + error.what(),
                       "Remove it here, or change the file so that it can");
      }
    refuse_changed_probes(*this, change, section);
    entry_changes.push_back(std::move(change));
  }
}

template <int dim>
Problem Case<dim>::changed_problem(ParameterFile &changed, HarmonicParameters &phases)
{
  ParameterSection root = changed.root(), boundaries = root.subsection("Boundaries");
  Problem other = problem;
  read_materials(root, other);
  other.interior = InteriorData();
  other.interior.read(root.subsection("Body force"), root.subsection("Initial state"),
                      problem.regions, dim);
  other.conditions =
      read_boundary_conditions(boundaries, problem.boundaries, problem.regions, boundary_regions,
                               dim, problem.model == Model::axisymmetric);
  phases.read_phases(root, other.conditions);
  set_flow_profiles(other.conditions, boundaries, *triangulation, other.materials,
                    {true, time.end_time, time.time_step});
  other.outlets = make_outlets(other.conditions, boundaries, *triangulation, other.materials);
  // The ends of tubes are those of a whole case.
  std::swap(problem, other);
  try
  {
    AbsorbingEnds().add(*this, root, restart);
  }
  catch (...)
  {
    std::swap(problem, other);
    throw;
  }
  std::swap(problem, other);
  return other;
}

template void Case<2>::prepare_entry_changes(ParameterFile &);
template void Case<3>::prepare_entry_changes(ParameterFile &);
} // namespace Continua
