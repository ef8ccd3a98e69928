#include <continua/laboratory/material_fit.h>

#include <continua/base/atomic_file.h>
#include <continua/base/citations.h>
#include <continua/base/misfit.h>
#include <continua/base/table_writer.h>
#include <continua/laboratory/entries_of_a_body.h>
#include <continua/laboratory/fit_report.h>
#include <continua/laboratory/material_text.h>
#include <continua/postprocess/writing_rank.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Continua
{
namespace
{
/// Root of the mean square of all residuals, over the units of their noise [1].
double misfit_of(const BarLawFit &fit)
{
  double sum = 0.;
  std::size_t n = 0;
  for (const RecordFit &record : fit.result.records)
  {
    sum += record.residuals.size() * record.root_mean_square * record.root_mean_square;
    n += record.residuals.size();
  }
  return std::sqrt(sum / n);
}

std::string one_decimal(const double value)
{
  std::ostringstream text;
  text.setf(std::ios::fixed);
  text.precision(1);
  text << value;
  return text.str();
}

/// What the file of a record's fit is called.
std::string fit_file(const BarRecord &record)
{
  return record.quantity == BarQuantity::relaxation ? "fit-relaxation.csv"
         : record.quantity == BarQuantity::creep    ? "fit-creep.csv"
                                                    : "fit-moduli.csv";
}

/// `of_record`: its residuals over the units of the noise, divided by the noise found.
void write_record(const std::string &file,
                  const BarRecord &record,
                  const RecordFit &of_record,
                  const Material &material)
{
  const std::vector<double> predicted = record.predicted(material);
  if (record.quantity == BarQuantity::modulus)
  {
    TableWriter table(
        file, {"frequency [Hz]", "storage modulus [Pa]", "storage modulus of the fit [Pa]",
               "residual of the storage modulus over the noise [1]", "loss modulus [Pa]",
               "loss modulus of the fit [Pa]", "residual of the loss modulus over the noise [1]"});
    for (std::size_t i = 0; i + 1 < predicted.size(); i += 2)
      table.row({record.abscissae[i], record.values[i], predicted[i], of_record.whitened[i],
                 record.values[i + 1], predicted[i + 1], of_record.whitened[i + 1]});
    table.flush();
    return;
  }
  const bool is_creep = record.quantity == BarQuantity::creep;
  const std::string name = is_creep ? "compliance" : "relaxation modulus",
                    unit = " [" + record.unit() + "]";
  TableWriter table(
      file, {"time [s]", name + unit, name + " of the fit" + unit, "residual over the noise [1]"});
  for (std::size_t i = 0; i < predicted.size(); ++i)
    table.row({record.abscissae[i], record.values[i], predicted[i], of_record.whitened[i]});
  table.flush();
}

void write_branches_tried(const std::string &file, const std::vector<BarLawFit> &of_branches)
{
  const double least = best_of(of_branches).criterion;
  TableWriter table(
      file, {"branches [1]", "constants [1]", "misfit [1]", "criterion above the best [1]"});
  for (const BarLawFit &fit : of_branches)
    table.row({static_cast<double>(fit.law->n_branches()),
               static_cast<double>(fit.parameters.size()), misfit_of(fit), fit.criterion - least});
  table.flush();
}

/// Storage and loss moduli are curves of their own.
void warn_of_order(const BarRecord &record, const RecordFit &of_record, Log &log)
{
  const unsigned int n_curves = record.quantity == BarQuantity::modulus ? 2 : 1;
  for (unsigned int curve = 0; curve < n_curves; ++curve)
  {
    std::vector<double> residuals;
    for (std::size_t i = curve; i < of_record.whitened.size(); i += n_curves)
      residuals.push_back(of_record.whitened[i]);
    const std::string column = n_curves == 1 ? ""
                               : curve == 0  ? " (storage modulus)"
                                             : " (loss modulus)";
    if (const std::string warning =
            warning_of_order("the " + record.name() + " table" + column, residuals);
        !warning.empty())
      log.warning(warning);
  }
}
} // namespace

MaterialFit::MaterialFit(const AnalysisInput &input) : Analysis(input)
{
  ParameterSection root = file.root();
  refuse_entries_of_a_body(root, general, "the bar of the tables has its own kinematics",
                           "a fit of tables has no mesh");
  const ParameterSection section = root.subsection("Material fit");
  parameters.read(section);
  expected = read_expected(root.subsection("Expected"));
  file.refuse_unknown();
  if (parameters.records.empty())
    section.refuse_missing("there is no table",
                           "Add 'set Relaxation table = FILE', 'set Creep table = FILE' or 'set "
                           "Modulus table = FILE'");
  check_law(section);
  name_quantities();
  quantities.refuse_unknown(file, root.subsection("Expected"), expected);
}

std::string MaterialFit::key_of_choice() const
{
  return parameters.n_branches > 0 ? "Branches" : "Law";
}

void MaterialFit::check_law(const ParameterSection &section) const
{
  if (!parameters.law)
    return;
  const BarLaw &law = *parameters.law;
  const std::size_t n_constants = law.constants().size();
  if (parameters.n_values() <= n_constants)
    section.refuse(key_of_choice(),
                   law.description() + " has " + std::to_string(n_constants) +
                       " constants, and the tables have " + std::to_string(parameters.n_values()) +
                       " values that can be used: more than the constants are needed to tell the "
                       "noise, too",
                   parameters.n_branches > 0 ? "Give tables with more rows, or fewer branches"
                                             : "Give tables with more rows, or another law");
  if (!law.is_shown_by_relaxation() &&
      std::all_of(parameters.records.begin(), parameters.records.end(),
                  [](const BarRecord &record)
                  { return record.quantity == BarQuantity::relaxation; }))
    section.refuse("Law",
                   "a relaxation table does not tell the viscosity of " + law.description() +
                       ", whose stress is constant from the end of the loading on",
                   "Add a creep table or a modulus table, or take another law");
}

void MaterialFit::name_quantities()
{
  for (const std::string &type : bar_law_types())
  {
    quantities.add("misfit", type);
    quantities.add("criterion above the best", type);
    const auto law = make_bar_law(type, parameters.poissons_ratio, parameters.most_branches);
    if (!parameters.law || parameters.law->type() == type)
      for (const BarLawConstant &constant : law->constants())
        name_fit_quantities(constant.name, quantities);
  }
  quantities.add("branches", "fit");
  for (const BarRecord &record : parameters.records)
    quantities.add("misfit of the " + record.name() + " table", "fit");
}

std::vector<BarLawFit> MaterialFit::fit_all(const std::vector<BarLawFit> &of_branches,
                                            Log &log) const
{
  // The Prony series stands for those of other numbers of branches.
  std::vector<BarLawFit> all, series;
  for (const BarLawFit &fit : of_branches)
    (fit.law->n_branches() > 0 ? series : all).push_back(fit);
  if (!series.empty())
    all.push_back(simplest_of(series));
  const bool has_more_than_relaxation = std::any_of(
      parameters.records.begin(), parameters.records.end(),
      [](const BarRecord &record) { return record.quantity != BarQuantity::relaxation; });
  for (const std::string &type : bar_law_types())
  {
    const auto law = make_bar_law(type, parameters.poissons_ratio);
    if (law->is_series())
      continue;
    if (!law->is_shown_by_relaxation() && !has_more_than_relaxation)
    {
      log.line("left out: " + law->description() +
               ", whose viscosity a relaxation table does not "
               "tell");
      continue;
    }
    if (parameters.n_values() <= law->constants().size())
      continue;
    try
    {
      const BarLawFit fit = fit_bar_law(start_of_scan(law, parameters.records), parameters.records);
      if (fit.result.converged)
        all.push_back(fit);
      else
        log.line("left out: " + law->description() +
                 ", whose fit did not come to its end: " + fit.result.stop_reason);
    }
    catch (const RunError &error)
    {
      log.line("left out: " + law->description() + ": " + error.what());
    }
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const BarLawFit &a, const BarLawFit &b)
                   { return a.criterion < b.criterion; });
  return all;
}

BarLawFit MaterialFit::chosen(const std::vector<BarLawFit> &of_branches,
                              const std::vector<BarLawFit> &all) const
{
  if (!parameters.law)
    return all.front();
  if (parameters.n_branches > 0)
  {
    for (const BarLawFit &fit : of_branches)
      if (fit.law->n_branches() == parameters.n_branches)
        return fit;
    const std::vector<BarLawStart> starts =
        starts_of_prony(parameters.poissons_ratio, parameters.records, parameters.n_branches);
    if (starts.back().law->n_branches() == parameters.n_branches)
      return fit_bar_law(starts.back(), parameters.records);
    throw RunError("the tables do not show " + std::to_string(parameters.n_branches) +
                   " branches: of all relaxation times between and beside those of the rows, the "
                   "least squares without negative moduli keep " +
                   std::to_string(starts.back().law->n_branches()) + "; set fewer Branches, or 0");
  }
  for (const BarLawFit &fit : all)
    if (fit.law->type() == parameters.law->type())
      return fit;
  if (parameters.law->n_branches() > 0)
    throw RunError("no Prony series could be fitted to the tables");
  // Left out of the comparison: its tables tell how far the search came.
  return fit_bar_law(start_of_scan(parameters.law, parameters.records), parameters.records);
}

void MaterialFit::compare(const BarLawFit &chosen,
                          const std::vector<BarLawFit> &all,
                          Log &log,
                          Summary &summary) const
{
  const BarLawFit &best = all.front();
  log.line("Laws by Schwarz's criterion, less that of the best, and by their misfit (root of the "
           "mean square):");
  for (const BarLawFit &fit : all)
  {
    log.line("  " + one_decimal(fit.criterion - best.criterion) + ", " + percent(misfit_of(fit)) +
             ": " + fit.law->description());
    summary.add({"misfit", misfit_of(fit), "1", fit.law->type()});
    summary.add({"criterion above the best", fit.criterion - best.criterion, "1", fit.law->type()});
  }
  if (chosen.criterion - best.criterion > clear_difference)
    log.warning("Material fit/" + key_of_choice() + ": " + chosen.law->description() +
                " misses by " + percent(misfit_of(chosen)) + ", " + best.law->description() +
                " by " + percent(misfit_of(best)) +
                ". By Schwarz's criterion the second one is better by " +
                one_decimal(chosen.criterion - best.criterion) + ", where " +
                one_decimal(clear_difference) + " is very clear");
  const std::string warning =
      misfit_warning("Material fit: " + chosen.law->description(), misfit_of(chosen),
                     "root of the mean square", "Such a material does not follow this law");
  if (!warning.empty())
    log.warning(warning);
}

void MaterialFit::write(const OutputDirectory &directory,
                        const BarLawFit &chosen,
                        const std::vector<BarLawFit> &of_branches) const
{
  const Material material = chosen.law->material(chosen.result.estimates);
  for (std::size_t i = 0; i < parameters.records.size(); ++i)
    write_record(directory.file(fit_file(parameters.records[i])), parameters.records[i],
                 chosen.result.records[i], material);
  if (!of_branches.empty())
    write_branches_tried(directory.file("branches.csv"), of_branches);
  write_correlation(directory.file("correlation.csv"), chosen.parameters, chosen.result);
  if (chosen.result.converged)
    write_file_atomically(directory.file("material.prm"),
                          material_text(chosen, parameters.density));
}

void MaterialFit::compute(const OutputDirectory &directory, Log &log, Summary &summary)
{
  summary.set_possible(quantities);
  summary.set("status", "finished");
  for (std::size_t i = 0; i < parameters.records.size(); ++i)
  {
    const BarRecord &record = parameters.records[i];
    const std::size_t n_rows =
        record.values.size() / (record.quantity == BarQuantity::modulus ? 2 : 1);
    log.line(parameters.keys[i] + ": " + std::to_string(n_rows) + " rows" +
             (parameters.n_left_out[i] > 0
                  ? ", without " + std::to_string(parameters.n_left_out[i]) +
                        (record.loading_time > 0. ? " up to the end of the loading" : " at time 0")
                  : ""));
  }
  const std::vector<BarLawFit> of_branches = fit_prony_series_to_bar(
      parameters.poissons_ratio, parameters.records, parameters.most_branches);
  const std::vector<BarLawFit> all = fit_all(of_branches, log);
  if (all.empty())
    throw RunError("no law could be fitted to the tables");
  const BarLawFit found = chosen(of_branches, all);
  compare(found, all, log, summary);
  log.line("Found: " + found.law->description());
  report_fit(found.parameters, found.result, log, summary);
  for (std::size_t i = 0; i < parameters.records.size(); ++i)
    warn_of_order(parameters.records[i], found.result.records[i], log);
  summary.set("law", found.law->type());
  summary.add({"branches", static_cast<double>(found.law->n_branches()), "1", "fit"});
  for (std::size_t i = 0; i < parameters.records.size(); ++i)
    summary.add(
        {"misfit of the " + parameters.records[i].name() + " table", found.misfits[i], "1", "fit"});
  const bool is_writer = is_writing_rank(communicator);
  if (is_writer)
    write(directory, found, of_branches);
  if (found.result.converged)
    log.line("The material stands in material.prm, to be pasted into a parameter file");
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
  require_end(found.result, found.law->description());
}
} // namespace Continua
