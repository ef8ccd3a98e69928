#include <continua/studies/identification_report.h>

#include <continua/base/text_table.h>
#include <continua/base/undefined.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Continua
{
namespace
{
/// Choices that the log names.
constexpr std::size_t n_choices_in_log = 5;

/// A value to the second digit of its error that counts.
std::string estimate_text(const double value, const double error)
{
  if (!std::isfinite(error) || error <= 0. || value == 0.)
    return number_text(value, 5);
  const int n_digits = static_cast<int>(std::floor(std::log10(std::abs(value)))) -
                       static_cast<int>(std::floor(std::log10(error))) + 2;
  return number_text(value, std::clamp(n_digits, 2, 9));
}

std::string error_text(const double error)
{
  return std::isfinite(error) ? number_text(error, 2) : "-";
}

std::string share_text(const double part)
{
  return number_text(100. * part, 3) + " %";
}

std::string bound_text(const double value, const bool is_bound, const double error)
{
  return estimate_text(value, error) + (is_bound ? " (bound)" : "");
}
} // namespace

IdentificationReport::IdentificationReport(const std::vector<SoughtEntry> &sought,
                                           const StationRecords &measured,
                                           const StationRecords &expected,
                                           const IdentificationResults &results)
    : sought(sought), measured(measured), expected(expected), results(results)
{
}

std::vector<std::string> IdentificationReport::lines() const
{
  std::vector<std::string> all;
  if (results.fit)
    add_fit_lines(all);
  if (results.errors_of_file || !results.choices.empty())
    add_design_lines(all);
  if (results.synthetic)
    add_synthetic_lines(all);
  return all;
}

void IdentificationReport::add_fit_lines(std::vector<std::string> &all) const
{
  const FitResult &fit = *results.fit;
  all.push_back("Fit: " + fit.stop_reason);
  std::vector<std::vector<std::string>> table = {
      {"number", "unit", "estimate", "standard error", "lower limit", "upper limit"}};
  for (std::size_t j = 0; j < sought.size(); ++j)
  {
    const double error = fit.standard_errors[j];
    const ConfidenceInterval &interval = fit.intervals[j];
    table.push_back(
        {results.parameters[j].name, results.parameters[j].unit,
         estimate_text(fit.estimates[j], error) + (fit.at_bound[j] ? " (at its bound)" : ""),
         error_text(error), bound_text(interval.lower, interval.lower_is_bound, error),
         bound_text(interval.upper, interval.upper_is_bound, error)});
  }
  for (const std::string &line : aligned_lines(table))
    all.push_back(line);
  for (std::size_t i = 0; i < fit.free.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (std::abs(fit.correlation(i, k)) > 0.9)
        all.push_back("'" + results.parameters[fit.free[k]].name + "' and '" +
                      results.parameters[fit.free[i]].name + "': their errors are correlated by " +
                      number_text(fit.correlation(i, k), 3));
  table = {{"record", "unit", "residuals", "noise", "treatment", "white"}};
  for (std::size_t r = 0; r < fit.records.size(); ++r)
  {
    const RecordFit &record = fit.records[r];
    const double probability = record.whiteness.probability;
    table.push_back({measured.records[r].name, measured.records[r].unit,
                     number_text(record.root_mean_square, 3),
                     number_text(record.noise.standard_deviation, 3) +
                         (record.noise_is_estimated ? " (estimated)" : ""),
                     record.treatment,
                     std::isnan(probability) ? "-"
                     : probability < 0.01    ? "no"
                                             : "yes"});
  }
  for (const std::string &line : aligned_lines(table))
    all.push_back(line);
  for (const auto &[number, profile] : results.profiles)
  {
    const double error = fit.standard_errors[number];
    all.push_back(
        "By its profile '" + results.parameters[number].name + "' lies between " +
        bound_text(profile.interval.lower, profile.interval.lower_is_bound, error) + " and " +
        bound_text(profile.interval.upper, profile.interval.upper_is_bound, error) + " " +
        results.parameters[number].unit + (profile.remark.empty() ? "" : ": " + profile.remark));
  }
  if (!results.bias)
    return;
  all.push_back("Bias if " + results.other_model +
                " were right, which no larger noise covers (estimate less truth):");
  table = {{"number", "unit", "bias", "over the standard error"}};
  for (std::size_t j = 0; j < sought.size(); ++j)
    table.push_back({results.parameters[j].name, results.parameters[j].unit,
                     error_text(results.bias->bias[j]),
                     error_text(results.bias->over_standard_error[j])});
  for (const std::string &line : aligned_lines(table))
    all.push_back(line);
}

std::string IdentificationReport::added(const DesignChoice &choice) const
{
  std::string text;
  for (const unsigned int record : choice.records)
    text += (text.empty() ? "" : "; ") + expected.records[record].name;
  return text;
}

void IdentificationReport::add_design_lines(std::vector<std::string> &all) const
{
  std::vector<std::vector<std::string>> table = {{"expected standard errors"}};
  for (const FitParameter &parameter : results.parameters)
    table.front().push_back(with_unit(parameter.name, parameter.unit));
  const auto row = [&](const std::string &name, const ExpectedErrors::Errors &errors)
  {
    table.push_back({name});
    for (const double error : errors.standard_errors)
      table.back().push_back(std::isfinite(error) ? number_text(error, 3) : "not seen");
  };
  if (results.errors_of_file)
    row("the file's records", *results.errors_of_file);
  for (const auto &[name, errors] : results.errors_of_parts)
    row("of these the " + name, errors);
  for (std::size_t i = 0; i < results.choices.size(); ++i)
    if (i < n_choices_in_log || i + 1 == results.choices.size())
      row((i + 1 == results.choices.size() && i > 0 ? "worst: " : "with ") +
              added(results.choices[i]),
          results.choices[i].errors);
  for (const std::string &line : aligned_lines(table))
    all.push_back(line);
}

void IdentificationReport::add_synthetic_lines(std::vector<std::string> &all) const
{
  const SyntheticExperiments::Outcome &outcome = *results.synthetic;
  all.push_back(
      std::to_string(outcome.fits.size()) + " synthetic experiments" +
      (outcome.n_failed > 0 ? ", " + std::to_string(outcome.n_failed) + " more failed" : ""));
  std::vector<std::vector<std::string>> table = {{"number", "mean error / standard error",
                                                  "spread / standard error",
                                                  "intervals with the truth"}};
  for (std::size_t j = 0; j < sought.size(); ++j)
  {
    const SyntheticExperiments::OfParameter &of = outcome.parameters[j];
    table.push_back({results.parameters[j].name, number_text(of.mean_error, 2),
                     number_text(of.spread, 3), share_text(of.coverage)});
    if (of.n_at_bound > 0)
      table.back().back() += " (" + std::to_string(of.n_at_bound) + " experiments end at a bound)";
  }
  for (const std::string &line : aligned_lines(table))
    all.push_back(line);
}

std::vector<std::string> IdentificationReport::warnings() const
{
  std::vector<std::string> all;
  const auto add_flat = [&all](const std::vector<FlatDirection> &directions)
  {
    for (const FlatDirection &direction : directions)
      all.push_back(direction.sentence);
  };
  if (results.fit)
  {
    for (const std::string &note : results.fit->notes)
      all.push_back(note);
  }
  if (results.errors_of_file)
    add_flat(results.errors_of_file->flat_directions);
  if (results.synthetic && results.synthetic->interpolation_error > 0.1)
    all.push_back("the model bends within the region of confidence: its interpolation for the "
                  "synthetic experiments is off by " +
                  number_text(results.synthetic->interpolation_error, 2) + " of the noise");
  return all;
}

void IdentificationReport::name_quantities(const IdentificationParameters &parameters,
                                           const StationRecords & /*expected*/,
                                           QuantityNames &names)
{
  for (const SoughtNumber &number : parameters.sought)
    for (const char *const name :
         {"estimate", "standard error", "lower limit", "upper limit", "lower limit by the profile",
          "upper limit by the profile", "bias", "bias over standard error",
          "expected standard error", "expected standard error by waves alone",
          "expected standard error by material tests alone",
          "expected standard error with the best", "expected standard error with the worst",
          "mean synthetic error", "synthetic spread", "synthetic coverage"})
      names.add(name, number.name);
  for (const char *const name :
       {"misfit", "degrees of freedom", "evaluations", "failed evaluations", "flat directions",
        "interpolation error", "failed synthetic experiments"})
    names.add(name);
}

void IdentificationReport::add_quantities(Summary &summary) const
{
  const auto add = [&](const std::string &name, const double value, const std::string &unit,
                       const std::string &probe)
  {
    if (std::isfinite(value))
      summary.add({name, value, unit, probe});
  };
  const auto count = [&](const std::string &name, const double value) {
    summary.add({name, value, "1", ""});
  };
  for (std::size_t j = 0; j < sought.size(); ++j)
  {
    const std::string &name = results.parameters[j].name, &unit = results.parameters[j].unit;
    if (results.fit)
    {
      add("estimate", results.fit->estimates[j], unit, name);
      add("standard error", results.fit->standard_errors[j], unit, name);
      add("lower limit", results.fit->intervals[j].lower, unit, name);
      add("upper limit", results.fit->intervals[j].upper, unit, name);
    }
    if (results.bias)
    {
      add("bias", results.bias->bias[j], unit, name);
      add("bias over standard error", results.bias->over_standard_error[j], "1", name);
    }
    if (results.errors_of_file)
      add("expected standard error", results.errors_of_file->standard_errors[j], unit, name);
    for (const auto &[part, errors] : results.errors_of_parts)
      add("expected standard error by " + part, errors.standard_errors[j], unit, name);
    if (!results.choices.empty())
    {
      add("expected standard error with the best",
          results.choices.front().errors.standard_errors[j], unit, name);
      add("expected standard error with the worst",
          results.choices.back().errors.standard_errors[j], unit, name);
    }
    if (results.synthetic)
    {
      const SyntheticExperiments::OfParameter &of = results.synthetic->parameters[j];
      add("mean synthetic error", of.mean_error, "1", name);
      add("synthetic spread", of.spread, "1", name);
      add("synthetic coverage", of.coverage, "1", name);
    }
  }
  for (const auto &[number, profile] : results.profiles)
  {
    const FitParameter &parameter = results.parameters[number];
    add("lower limit by the profile", profile.interval.lower, parameter.unit, parameter.name);
    add("upper limit by the profile", profile.interval.upper, parameter.unit, parameter.name);
  }
  if (results.fit)
  {
    add("misfit", results.fit->misfit, "1", "");
    count("degrees of freedom", results.fit->degrees_of_freedom);
    count("evaluations", results.fit->n_evaluations);
    count("failed evaluations", results.fit->n_failures);
    count("flat directions", static_cast<double>(results.fit->flat_directions.size()));
  }
  else if (results.errors_of_file)
    count("flat directions", static_cast<double>(results.errors_of_file->flat_directions.size()));
  if (results.synthetic)
  {
    add("interpolation error", results.synthetic->interpolation_error, "1", "");
    count("failed synthetic experiments", results.synthetic->n_failed);
  }
}
} // namespace Continua
