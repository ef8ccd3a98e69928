#include <continua/laboratory/artery_fit.h>

#include <continua/base/atomic_file.h>
#include <continua/base/citations.h>
#include <continua/base/misfit.h>
#include <continua/base/six_digits.h>
#include <continua/base/table_writer.h>
#include <continua/base/undefined.h>
#include <continua/inference/least_squares_fit.h>
#include <continua/laboratory/entries_of_a_body.h>
#include <continua/laboratory/fit_report.h>
#include <continua/postprocess/writing_rank.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Continua
{
namespace
{
std::vector<FitParameter> fit_parameters(const std::vector<ArteryParameter> &parameters)
{
  std::vector<FitParameter> list;
  for (const ArteryParameter &parameter : parameters)
    list.push_back(parameter.fit);
  return list;
}

/// Largest less smallest of what was measured.
double range_of(const DataRecord &record)
{
  const auto [least, largest] = std::minmax_element(record.values.begin(), record.values.end());
  return *largest - *least;
}

double or_unknown(const double noise)
{
  return noise > 0. ? noise : undefined;
}
} // namespace

ArteryFit::ArteryFit(const AnalysisInput &input) : Analysis(input)
{
  ParameterSection root = file.root();
  refuse_entries_of_a_body(root, general, "the tube of the table is round and even along its axis",
                           "the tube of the table has no mesh");
  const ParameterSection section = root.subsection("Artery fit");
  parameters.read(section);
  parameters.read_layers(root.subsection("Materials"), section);
  expected = read_expected(root.subsection("Expected"));
  file.refuse_unknown();
  check_rows(section);
  for (const ArteryParameter &parameter : parameters.parameters)
    name_fit_quantities(parameter.fit.name, quantities);
  quantities.add("misfit of the diameter", "fit");
  if (parameters.test.has_force)
    quantities.add("misfit of the axial force", "fit");
  quantities.refuse_unknown(file, root.subsection("Expected"), expected);
}

void ArteryFit::check_rows(const ParameterSection &section) const
{
  const std::size_t n_values = parameters.test.rows.size() * (parameters.test.has_force ? 2 : 1);
  if (n_values <= parameters.parameters.size())
    section.refuse("Table",
                   "there are " + std::to_string(parameters.parameters.size()) +
                       " parameters, and the table has " + std::to_string(n_values) +
                       " measured values: more than the parameters are needed",
                   "Give a table with more rows, or fewer parameters");
}

void ArteryFit::compute(const OutputDirectory &directory, Log &log, Summary &summary)
{
  summary.set_possible(quantities);
  summary.set("status", "finished");
  const InflationTest &test = parameters.test;
  log.line("Inflation-extension test: " + std::to_string(test.rows.size()) + " rows, " +
           (test.is_outer ? "outer" : "inner") + " diameter" +
           (test.has_force ? " and axial force" : ""));
  ArteryModel model(parameters.ring, parameters.parameters, test);
  const std::vector<FitParameter> sought = fit_parameters(parameters.parameters);
  FitOptions options;
  options.n_starts = parameters.n_starts;
  options.tolerance = 1e-5;
  const std::vector<DataRecord> records =
      test.data_records(or_unknown(parameters.diameter_noise), or_unknown(parameters.force_noise));
  const FitResult result = LeastSquaresFit(sought, records, model, options).solve();
  log.line("Found:");
  report_fit(sought, result, log, summary);
  const std::string units[] = {"m", "N"}, names[] = {"diameter", "axial force"};
  for (std::size_t i = 0; i < result.records.size(); ++i)
  {
    const double misfit = result.records[i].root_mean_square;
    std::ostringstream text;
    text.precision(3);
    text << "Misfit of the " << names[i] << ": " << misfit << " " << units[i]
         << " (root of the mean square)";
    log.line(text.str());
    summary.add({"misfit of the " + names[i], misfit, units[i], "fit"});
    const double range = range_of(records[i]);
    for (const std::string &warning :
         {misfit_warning("Artery fit: the " + names[i] + " of the tube",
                         range > 0. ? misfit / range : 0.,
                         "root of the mean square, over the range of the column",
                         "Check the radius, the layers and their thicknesses, and the units of "
                         "the table: the standard errors hold for a tube that is right"),
          warning_of_order("the " + names[i], result.records[i].whitened)})
      if (!warning.empty())
        log.warning(warning);
  }
  const bool is_writer = is_writing_rank(communicator);
  if (is_writer)
  {
    write_rows(directory.file("fit-inflation.csv"), result);
    write_correlation(directory.file("correlation.csv"), sought, result);
    if (result.converged)
      write_file_atomically(directory.file("materials.prm"),
                            materials_text(result, model.tube(result.estimates)));
  }
  if (result.converged)
    log.line("The layers stand in materials.prm, to be pasted into a parameter file");
  else
    summary.set("status", "failed");
  bool all_passed = true;
  for (const std::string &verdict : summary.check(expected, all_passed))
    log.line(verdict);
  summary.set("warnings", log.warnings());
  if (is_writer)
  {
    summary.write(directory.file("summary.json"));
    Citations().write(directory.file("citation.bib"));
  }
  require_end(result, "the artery");
}

void ArteryFit::write_rows(const std::string &file, const FitResult &result) const
{
  const InflationTest &test = parameters.test;
  const std::string name = test.is_outer ? "outer diameter" : "inner diameter";
  std::vector<std::string> header = {"axial stretch [1]", "pressure [Pa]", name + " [m]",
                                     name + " of the fit [m]",
                                     "residual of the diameter over the noise [1]"};
  if (test.has_force)
    header.insert(header.end(), {"axial force [N]", "axial force of the fit [N]",
                                 "residual of the axial force over the noise [1]"});
  TableWriter table(file, header);
  for (std::size_t i = 0; i < test.rows.size(); ++i)
  {
    const InflationRow &measured = test.rows[i];
    std::vector<double> row = {measured.axial_stretch, measured.pressure, measured.diameter,
                               result.records[0].prediction[i], result.records[0].whitened[i]};
    if (test.has_force)
      row.insert(row.end(), {measured.axial_force, result.records[1].prediction[i],
                             result.records[1].whitened[i]});
    table.row(row);
  }
  table.flush();
}

std::string ArteryFit::materials_text(const FitResult &result, const LoadedTube &tube) const
{
  std::ostringstream text;
  text << "# Layers as Analysis = artery fit has found them. The standard errors are:\n";
  for (std::size_t i = 0; i < result.estimates.size(); ++i)
  {
    const ArteryParameter &parameter = parameters.parameters[i];
    text << "#   " << parameter.fit.name << ": "
         << (std::isfinite(result.standard_errors[i])
                 ? parameter.entry->text(result.standard_errors[i])
                 : "none, it is at its bound or the table does not show it")
         << "\n";
  }
  const TubeSection &section = tube.section();
  text << "# The tube without load (with an opening angle: the opened ring) has the inner radius "
       << six_digits(section.inner_radius) << " m\n# and layers of";
  for (const double thickness : section.layer_thicknesses)
    text << " " << six_digits(thickness) << " m";
  text << ".\nsubsection Materials\n";
  for (std::size_t i = 0; i < section.layers.size(); ++i)
  {
    const Material &layer = section.layers[i];
    text << "  subsection " << parameters.layer_names[i] << "\n    set Type = hookean\n    set "
         << "Density = " << six_digits(layer.density) << " kg/m^3\n    set Poisson's ratio = 0.5\n"
         << "    set Strain law = " << layer.strain_law_parameters.type << "\n";
    for (const ArteryEntry &entry : artery_entries())
      if (entry.strain_law.empty() || entry.strain_law == layer.strain_law_parameters.type)
        text << "    set " << entry.key << " = " << entry.text(entry.value(layer)) << "\n";
    text << "  end\n";
  }
  text << "end\n";
  return text.str();
}
} // namespace Continua
