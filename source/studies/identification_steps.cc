// The steps of Identification::compute().

#include <continua/studies/identification.h>

#include <continua/base/citations.h>
#include <continua/base/input_error.h>
#include <continua/inference/autoregressive_model.h>
#include <continua/inference/least_squares_fit.h>
#include <continua/postprocess/writing_rank.h>
#include <continua/studies/evaluation_table.h>
#include <continua/studies/identification_report.h>
#include <continua/studies/station_fit_model.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace Continua
{
namespace
{
/// A pulse has arrived where the prediction is more than this part of its largest value.
constexpr double arrived = 1e-3;
/// Rows at rest from which noise can be told.
constexpr std::size_t fewest_rows_at_rest = 20;

/// The numbers where the fit, or the design, stands.
std::vector<double> start_of(const std::vector<FitParameter> &parameters)
{
  std::vector<double> start;
  for (const FitParameter &parameter : parameters)
    start.push_back(parameter.start);
  return start;
}

/// What the model says of each record at a set.
std::vector<std::vector<double>> predictions_of(FitModel &model,
                                                const std::vector<DataRecord> &records,
                                                const std::vector<double> &set)
{
  const FitModel::Prediction prediction = model.predict({set}).front();
  if (!prediction.failure.empty())
    throw RunError("the model fails: " + prediction.failure);
  return by_record(records, prediction.values);
}

/// The values before the pulse arrives.
std::vector<double> rest_of(const DataRecord &record, const std::vector<double> &prediction)
{
  double largest = 0.;
  for (const double value : prediction)
    largest = std::max(largest, std::abs(value));
  std::vector<double> rest;
  for (std::size_t i = 0; i < prediction.size() && std::abs(prediction[i]) <= arrived * largest; ++i)
    rest.push_back(record.values[i]);
  return rest;
}
} // namespace

void Identification::set_noise_from_rest(StationFitModel &model, Log &log)
{
  if (std::none_of(measured.sources.begin(), measured.sources.end(),
                   [](const RecordSource &source) { return source.noise_from_rest; }))
    return;
  const std::vector<std::vector<double>> predictions =
      predictions_of(model, measured.records, start_of(fit_parameters()));
  for (std::size_t r = 0; r < measured.records.size(); ++r)
  {
    if (!measured.sources[r].noise_from_rest)
      continue;
    DataRecord &record = measured.records[r];
    const std::vector<double> rest = rest_of(record, predictions[r]);
    if (rest.size() < fewest_rows_at_rest)
      throw RunError("'" + record.name + "' has " + std::to_string(rest.size()) +
                     " rows before the pulse arrives, and its noise from rest needs " +
                     std::to_string(fewest_rows_at_rest) +
                     ": give a number in Identification/Noise, or more rows");
    const bool in_time =
        record.interval > 0. && parameters.correlated_noise != CorrelatedNoise::as_given;
    const AutoregressiveModel found =
        in_time ? fit_autoregressive_model_of_best_order(rest, parameters.order_criterion, true)
                : fit_autoregressive_model(rest, 0, true);
    record.noise.standard_deviation = found.standard_deviation;
    record.noise.autoregressive = found.coefficients;
    std::ostringstream text;
    text.precision(3);
    text << "Noise of '" << record.name << "' from " << rest.size()
         << " rows before the pulse: " << found.standard_deviation << " " << record.unit << ", "
         << record.noise.description();
    log.line(text.str());
  }
}

void Identification::fit(StationFitModel &model,
                         const OutputDirectory &directory,
                         Log &log,
                         IdentificationResults &results)
{
  EvaluationTable table(directory, results.parameters, identity(), command_line.restart);
  if (!table.known().empty())
    log.line(std::to_string(table.known().size()) + " evaluations were made before");
  FitOptions options = fit_options();
  options.known = table.known();
  unsigned int n = table.known().size();
  options.observer = [&](const Evaluation &evaluation)
  {
    table.add(evaluation);
    ++n;
    std::ostringstream text;
    text << "evaluation " << n << " (" << evaluation.purpose << "): ";
    if (evaluation.prediction.failure.empty())
      text << "misfit " << evaluation.misfit;
    else
      text << "failed: " << evaluation.prediction.failure;
    log.detail(text.str());
  };
  results.fit = LeastSquaresFit(results.parameters, measured.records, model, options).solve();
  for (unsigned int r = 0; r < measured.records.size(); ++r)
    results.shifts.push_back(model.shift_of(r, results.fit->estimates));
  if (parameters.profiles)
    for (const unsigned int number : results.fit->free)
      results.profiles.emplace_back(number,
                                    profile_likelihood(results.parameters, measured.records, model,
                                                       options, *results.fit, number));
  if (parameters.n_experiments == 0)
    return;
  std::vector<NoiseModel> noise;
  for (const RecordFit &record : results.fit->records)
    noise.push_back(record.noise);
  results.synthetic =
      SyntheticExperiments(results.parameters, results.fit->estimates,
                           results.fit->standard_errors, measured.records, noise, options)
          .perform(model, parameters.n_experiments, parameters.seed);
}

void Identification::find_bias(const OutputDirectory &directory,
                               Log &log,
                               IdentificationResults &results) const
{
  const bool theory = parameters.other_model == OtherModel::theory;
  const std::unique_ptr<ForwardModel> first = make_model(by_theory, directory, "bias"),
                                      second = make_model(theory, directory, "other");
  const auto &further = parameters.other_entries;
  results.other_model = second->name() + (further.empty() ? "" : " with other entries");
  log.note("Computing the other model for the bias: " + results.other_model);
  const auto predicted = [&](ForwardModel &model,
                             const std::vector<std::pair<std::string, std::string>> &entries)
  {
    StationFitModel of_data(model, sought, measured, probes, entries);
    const FitModel::Prediction prediction =
        of_data.predict({results.fit->estimates}).front();
    if (!prediction.failure.empty())
      throw RunError("the bias cannot be told, since " + model.name() +
                     " fails at the estimates: " + prediction.failure);
    return prediction.values;
  };
  results.bias = model_bias(results.parameters, *results.fit, measured.records,
                            predicted(*first, {}), predicted(*second, further));
}

void Identification::design(ForwardModel &model, Log &log, IdentificationResults &results) const
{
  std::vector<FitParameter> at = results.parameters;
  for (std::size_t j = 0; j < at.size() && results.fit; ++j)
    at[j].start = results.fit->estimates[j];
  log.line("Design: " + std::to_string(expected.records.size()) + " records, " +
           std::to_string(candidates.size()) + " of them candidates; errors at " +
           (results.fit ? "the estimates" : "the starts of the numbers"));
  StationFitModel of_design(model, sought, expected, probes);
  const ExpectedErrors errors(at, expected.records, of_design, parameters.difference_step);
  if (!always.empty())
    results.errors_of_file = errors.of(always);
  unsigned int criterion = ExpectedErrors::by_determinant;
  for (unsigned int j = 0; j < at.size(); ++j)
    if (at[j].name == parameters.criterion)
      criterion = j;
  if (!candidates.empty())
    for (const ExpectedErrors::Choice &choice :
         errors.rank(always, candidates, parameters.n_added, criterion))
    {
      results.choices.push_back({{}, choice.errors});
      for (const unsigned int candidate : choice.candidates)
        results.choices.back().records.push_back(candidates[candidate].front());
    }
  if (parameters.n_experiments == 0 || results.synthetic || !results.errors_of_file)
    return;
  // Of the records that are there.
  StationRecords of_file;
  std::vector<NoiseModel> noise;
  for (const unsigned int r : always)
  {
    of_file.records.push_back(expected.records[r]);
    of_file.sources.push_back(expected.sources[r]);
    noise.push_back(expected.records[r].noise);
    if (!parameters.noise_is_known)
      of_file.records.back().noise = NoiseModel();
  }
  StationFitModel of_experiments(model, sought, of_file, probes);
  results.synthetic =
      SyntheticExperiments(at, start_of(at), results.errors_of_file->standard_errors,
                           of_file.records, noise, fit_options())
          .perform(of_experiments, parameters.n_experiments, parameters.seed);
}

void Identification::finish(const OutputDirectory &directory,
                            Log &log,
                            Summary &summary,
                            const IdentificationResults &results) const
{
  const IdentificationReport report(sought, measured, expected, results);
  for (const std::string &line : report.lines())
    log.line(line);
  for (const std::string &warning : report.warnings())
    log.warning(warning);
  summary.set_possible(quantities);
  const bool is_found = !results.fit || results.fit->converged;
  summary.set("status", is_found ? "finished" : "failed");
  if (!is_found)
    summary.set("failure", results.fit->stop_reason);
  summary.set("model", general.model);
  summary.set("model of the data", results.model);
  std::vector<std::string> names;
  for (const FitParameter &parameter : results.parameters)
    names.push_back(parameter.name);
  summary.set("parameters", names);
  report.add_quantities(summary);
  bool all_passed = true;
  for (const std::string &verdict : summary.check(parameters.expected, all_passed))
    log.line(verdict);
  summary.set("warnings", log.warnings());
  report.write(directory);
  summary.write(directory.file("summary.json"));
  if (!is_found)
    throw RunError("the fit has not come to an end: " + results.fit->stop_reason);
}
} // namespace Continua
