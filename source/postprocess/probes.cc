#include <continua/base/input_error.h>
#include <continua/base/nearest_name.h>
#include <continua/base/parameter_text.h>
#include <continua/mesh/cell_point.h>
#include <continua/postprocess/probes.h>

#include <continua/postprocess/writing_rank.h>
#include <continua/signal/signal_analysis.h>
#include <deal.II/fe/mapping_q.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <stdexcept>

namespace Continua
{
namespace
{
/// The first row of probes.csv.
std::vector<std::string> header(const std::vector<std::string> &column_names)
{
  std::vector<std::string> names = {"time [s]"};
  names.insert(names.end(), column_names.begin(), column_names.end());
  return names;
}

std::string joined(const std::vector<std::string> &names)
{
  std::string text;
  for (const std::string &name : names)
    text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "none" : text;
}

/// "Did you mean 'tip'? There are: tip, root".
std::string choices(const std::string &name, const std::vector<std::string> &candidates)
{
  const std::string near = nearest_name(name, candidates);
  return (near.empty() ? "" : "Did you mean '" + near + "'? ") + "There are: " + joined(candidates);
}

/// The number of a published name; refuses one that does not exist.
unsigned int find_name(const ParameterSection &section,
                       const std::string &key,
                       const std::string &name,
                       const std::vector<std::string> &names)
{
  const auto place = std::find(names.begin(), names.end(), name);
  if (place == names.end())
    section.refuse(key, "the mesh has no '" + name + "'", choices(name, names));
  return static_cast<unsigned int>(place - names.begin());
}

/// The field of that name, or all components of the vector or tensor of that name.
std::vector<FieldComponent> expand(const ParameterSection &section,
                                   const std::string &word,
                                   const std::vector<FieldComponent> &fields)
{
  std::vector<FieldComponent> components;
  for (const FieldComponent &field : fields)
    if (field.name == word)
      return {field};
    else if (field.name.compare(0, word.size() + 1, word + " ") == 0)
      components.push_back(field);
  if (components.empty())
  {
    std::vector<std::string> names;
    for (const FieldComponent &field : fields)
      names.push_back(field.name);
    section.refuse("Fields", "there is no field '" + word + "'",
                   choices(word, names) +
                       "; without the component: all components of a vector or tensor");
  }
  return components;
}

/// The unit of a field integrated over a boundary.
std::string unit_of_integral(const std::string &unit, const Model model)
{
  Dimension dimension;
  unit_factor(unit, dimension);
  const bool line = model == Model::plane_strain || model == Model::plane_stress;
  dimension.length += line ? 1 : 2;
  return dimension.unit();
}
} // namespace

template <int dim>
Probes<dim>::Probes(const MPI_Comm communicator) : communicator(communicator)
{
}

template <int dim>
void Probes<dim>::read_entries(Probe &probe) const
{
  ParameterSection &section = probe.section;
  section.add("Fields", probe.fields,
              "What to record: fields (displacement y), or vectors and tensors with all their "
              "components (displacement)");
  section.add("Point", probe.point, Dimensions::length,
              "Coordinates of the point in the undeformed body [m]");
  section.add("Boundary", probe.boundary, "Instead of a point: name of a boundary");
  section.add_choice("Value", probe.value, {"mean", "integral"},
                     "What to record of the fields on the boundary");
  section.add("Region", probe.region,
              "Whose side counts where a field jumps between regions; empty: any");
  section.add("Signal analysis", probe.signal_analysis,
              "Whether to look for maxima, frequency and decay in the histories at the end");
  section.add("Modes", probe.modes, Dimensions::frequency,
              "Frequencies near those of a sum of damped sines that is fitted to the histories "
              "[Hz]; empty: no such fit",
              Range::positive());
}

template <int dim>
void Probes<dim>::read(ParameterSection section,
                       const std::vector<std::string> &boundaries,
                       const std::vector<std::string> &regions)
{
  for (const std::string &name : section.subsections())
  {
    const ParameterSection child = section.subsection(name);
    Probe probe{child, {}, {}, "", "mean", "", true, {}, {}, 0};
    read_entries(probe);

    if (probe.fields.empty())
      child.refuse("Fields", "the probe has no field", "Write for example 'set Fields = velocity'");
    if (probe.point.empty() == probe.boundary.empty())
      child.refuse(probe.point.empty() ? "" : "Boundary",
                   probe.point.empty() ? "the probe has no place"
                                       : "the probe has a point and a boundary",
                   "Give either Point or Boundary");
    if (!probe.point.empty() && probe.point.size() != dim)
      child.refuse("Point", "the point has " + std::to_string(probe.point.size()) + " coordinates",
                   "Give " + std::to_string(dim) + " of them, separated by commas");
    if (probe.boundary.empty() && child.given("Value"))
      child.refuse("Value", "a point has neither a mean nor an integral",
                   "Leave the entry out, or give Boundary instead of Point");
    if (!probe.signal_analysis && !probe.modes.empty())
      child.refuse("Modes", "frequencies are fitted only in the signal analysis",
                   "Leave the entry out, or set Signal analysis = true");

    using Kind = typename ProbeRequest<dim>::Kind;
    if (probe.boundary.empty())
      for (unsigned int d = 0; d < dim; ++d)
        probe.request.point[d] = probe.point[d];
    else
    {
      probe.request.kind = probe.value == "mean" ? Kind::boundary_mean : Kind::boundary_integral;
      probe.request.boundary_id = find_name(child, "Boundary", probe.boundary, boundaries);
    }
    if (!probe.region.empty())
      probe.request.region_id = static_cast<int>(find_name(child, "Region", probe.region, regions));
    probes.push_back(probe);
  }
}

template <int dim>
void Probes<dim>::attach(ContinuumSolver<dim> &continuum_solver, const Model model)
{
  solver = &continuum_solver;
  const std::vector<FieldComponent> fields = solver->fields();
  for (unsigned int p = 0; p < probes.size(); ++p)
  {
    Probe &probe = probes[p];
    std::vector<std::string> names;
    for (const std::string &word : probe.fields)
      for (FieldComponent field : expand(probe.section, collapse_blanks(word), fields))
      {
        if (std::find(names.begin(), names.end(), field.name) != names.end())
          probe.section.refuse("Fields", "'" + field.name + "' is recorded twice",
                               "Name every field once");
        names.push_back(field.name);
        probe.request.field = field.name;
        if (probe.request.kind == ProbeRequest<dim>::Kind::boundary_integral)
          field.unit = unit_of_integral(field.unit, model);
        try
        {
          columns.push_back({p, field, solver->add_probe(probe.request), {}});
        }
        catch (const std::invalid_argument &error)
        {
          probe.section.refuse(
              probe.boundary.empty() ? "Point" : "Boundary", error.what(),
              probe.boundary.empty()
                  ? "Give a point of the undeformed body, in the Region if there is one"
                  : "Give a boundary on which the field exists, next to the Region if there is "
                    "one");
        }
      }
    probe.n_columns = static_cast<unsigned int>(names.size());
  }
}

template <int dim>
void Probes<dim>::check(
    const dealii::Triangulation<dim> &coarse_mesh,
    const std::vector<FieldComponent> &fields,
    const std::set<std::pair<unsigned int, unsigned int>> &boundary_regions) const
{
  // Of a high degree, since a coarse cell may stand for a large part of a circle.
  const dealii::MappingQ<dim> mapping(6);
  for (const Probe &probe : probes)
  {
    for (const std::string &word : probe.fields)
      expand(probe.section, collapse_blanks(word), fields);
    if (!probe.boundary.empty())
    {
      bool exists = false;
      for (const auto &pair : boundary_regions)
        exists = exists || (pair.first == probe.request.boundary_id &&
                            (probe.request.region_id < 0 ||
                             pair.second == static_cast<unsigned int>(probe.request.region_id)));
      if (!exists)
        probe.section.refuse("Region",
                             "the boundary '" + probe.boundary + "' has no face in this region",
                             "Name a region that touches the boundary, or none");
      continue;
    }
    bool inside = false;
    dealii::Point<dim> unit_point;
    for (const auto &cell : coarse_mesh.cell_iterators_on_level(0))
      inside =
          inside || ((probe.request.region_id < 0 ||
                      cell->material_id() == static_cast<unsigned int>(probe.request.region_id)) &&
                     cell_holds_point<dim>(mapping, cell, probe.request.point, unit_point));
    if (!inside)
      probe.section.refuse("Point", "the point is not inside the mesh",
                           "Give a point of the undeformed body, in the Region if there is one");
  }
}

template <int dim>
std::vector<std::string> Probes<dim>::column_names() const
{
  std::vector<std::string> names;
  for (const Column &column : columns)
    names.push_back(probes[column.probe].section.name() + ": " + column.field.name + " [" +
                    column.field.unit + "]");
  return names;
}

template <int dim>
void Probes<dim>::open(const std::string &file)
{
  if (columns.empty())
    return;
  on_writing_rank(communicator,
                  [&]() { table = std::make_unique<TableWriter>(file, header(column_names())); });
}

template <int dim>
void Probes<dim>::open(const std::string &file, const double restart_time)
{
  if (columns.empty())
    return;
  on_writing_rank(communicator,
                  [&]()
                  {
                    table =
                        std::make_unique<TableWriter>(file, header(column_names()), restart_time);
                    read_history(file);
                  });
  record_times = dealii::Utilities::MPI::broadcast(communicator, record_times);
  for (Column &column : columns)
    column.values = dealii::Utilities::MPI::broadcast(communicator, column.values);
}

template <int dim>
void Probes<dim>::read_history(const std::string &file)
{
  std::ifstream stream(file, std::ios::binary);
  std::string line;
  std::getline(stream, line); // the header, which the table writer has checked
  while (std::getline(stream, line))
  {
    const char *begin = line.data();
    const char *const end = begin + line.size();
    for (unsigned int i = 0; i <= columns.size(); ++i)
    {
      double value = 0.;
      const std::from_chars_result result = std::from_chars(begin, end, value);
      const bool complete =
          i < columns.size() ? result.ptr != end && *result.ptr == ',' : result.ptr == end;
      if (result.ec != std::errc() || !complete)
        throw RunError("cannot continue '" + file + "': the row '" + line + "' is damaged");
      (i == 0 ? record_times : columns[i - 1].values).push_back(value);
      begin = result.ptr + 1;
    }
  }
}

template <int dim>
void Probes<dim>::record(const double time)
{
  if (columns.empty())
    return;
  solver->evaluate_probes(solver_values);
  record_times.push_back(time);
  row.assign(1, time);
  for (Column &column : columns)
  {
    column.values.push_back(solver_values[column.solver_probe]);
    row.push_back(column.values.back());
  }
  if (table)
    table->row(row);
}

template <int dim>
void Probes<dim>::add_quantities(const Column &column,
                                 Summary &summary,
                                 std::vector<std::string> &warnings) const
{
  const Probe &probe = probes[column.probe];
  const std::string &field = column.field.name;
  const std::string &unit = column.field.unit;
  const std::string label =
      probe.section.name() + (probe.n_columns > 1 ? ": " + field : std::string());
  const auto add = [&](const std::string &name, const double value, const std::string &unit_of_it)
  {
    if (!std::isnan(value))
      summary.add({name, value, unit_of_it, label});
  };

  if (record_times.size() > 1)
  {
    const SignalAnalysis signal = analyse_signal(record_times, column.values);
    add("maximum " + field, signal.maximum, unit);
    add("time of maximum " + field, signal.time_of_maximum, "s");
    add("minimum " + field, signal.minimum, unit);
    add("time of minimum " + field, signal.time_of_minimum, "s");
    add("first maximum " + field, signal.first_maximum, unit);
    add("time of first maximum " + field, signal.time_of_first_maximum, "s");
    add("mean " + field, signal.mean, unit);
    add("frequency", signal.frequency_zero_crossings, "Hz");
    add("frequency of the fit", signal.frequency_fit, "Hz");
    add("decay per oscillation", signal.decay_per_oscillation_fit, "1");
    add("fit residual", signal.fit_residual, "1");
  }
  add("final " + field, column.values.back(), unit);

  if (probe.modes.empty())
    return;
  // An offset, and four numbers a mode.
  const bool enough = record_times.size() > 1 + 4 * probe.modes.size();
  const DampedSineFit fit =
      enough ? fit_damped_sines(record_times, column.values, probe.modes) : DampedSineFit();
  if (!enough || !fit.converged)
  {
    warnings.push_back("the modes could not be fitted to " + field + " of the probe '" +
                       probe.section.name() +
                       "': " + (enough ? "the fit did not converge" : "it has too few rows"));
    return;
  }
  for (unsigned int m = 0; m < fit.components.size(); ++m)
  {
    const DampedSine &mode = fit.components[m];
    const std::string name = "mode " + std::to_string(m + 1);
    add(name + " frequency", mode.frequency, "Hz");
    add(name + " decay per oscillation", std::exp(-mode.decay_rate / mode.frequency), "1");
    add(name + " amplitude", mode.amplitude, unit);
  }
  add("modes residual", fit.residual, "1");
}

template <int dim>
std::vector<std::string> Probes<dim>::finish(Summary &summary)
{
  on_writing_rank(communicator,
                  [&]()
                  {
                    if (table)
                      table->flush();
                  });
  std::vector<std::string> warnings;
  if (!record_times.empty())
    for (const Column &column : columns)
      if (probes[column.probe].signal_analysis)
        add_quantities(column, summary, warnings);
  return warnings;
}

template class Probes<2>;
template class Probes<3>;
} // namespace Continua
