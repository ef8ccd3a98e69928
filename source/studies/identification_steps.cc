// The steps of Identification::compute().

#include <continua/studies/identification.h>

#include <continua/base/citations.h>
#include <continua/base/input_error.h>
#include <continua/base/interruption.h>
#include <continua/inference/least_squares_fit.h>
#include <continua/postprocess/writing_rank.h>
#include <continua/studies/evaluation_table.h>
#include <continua/studies/identification_report.h>
#include <continua/studies/station_fit_model.h>

#include <algorithm>
#include <functional>
#include <sstream>

namespace Continua
{
namespace
{
/// The numbers where the fit, or the design, stands.
std::vector<double> start_of(const std::vector<FitParameter> &parameters)
{
  std::vector<double> start;
  start.reserve(parameters.size());
  for (const FitParameter &parameter : parameters)
    start.push_back(parameter.start);
  return start;
}
} // namespace

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
  // Whatever fails later, the fit is there.
  IdentificationReport(sought, measured, expected, results).write(directory);
  const auto step = [&](const std::string &what, const std::function<void()> &perform)
  {
    try
    {
      perform();
    }
    catch (const Interrupted &)
    {
      throw;
    }
    catch (const std::exception &error)
    {
      results.failures.push_back(what + ": " + error.what());
    }
  };
  if (!results.fit->converged || results.fit->free.empty())
  {
    log.line(results.fit->converged
                 ? "Each number is held or at a bound: there are no profiles and no bias of it"
                 : "The fit did not converge: nothing else is computed at its last numbers");
    return;
  }
  if (parameters.profiles)
    step("profiles",
         [&]()
         {
           for (const unsigned int number : results.fit->free)
             results.profiles.emplace_back(
                 number, profile_likelihood(results.parameters, measured.records, model, options,
                                            *results.fit, number));
         });
  if (parameters.other_model != OtherModel::none)
    step("bias", [&]() { find_bias(directory, log, results); });
  if (parameters.n_experiments > 0)
    step("synthetic experiments", [&]() { repeat_fit(model, options, results); });
}

void Identification::repeat_fit(StationFitModel &model,
                                const FitOptions &options,
                                IdentificationResults &results) const
{
  std::vector<NoiseModel> noise;
  for (const RecordFit &record : results.fit->records)
    noise.push_back(record.noise);
  results.synthetic =
      SyntheticExperiments(results.parameters, results.fit->estimates, results.fit->standard_errors,
                           measured.records, noise, options)
          .perform(model, parameters.n_experiments, parameters.seed);
}

void Identification::find_bias(const OutputDirectory &directory,
                               Log &log,
                               IdentificationResults &results) const
{
  const bool theory = parameters.other_model == OtherModel::theory;
  const std::unique_ptr<ForwardModel> first = make_model(by_theory, directory, "bias", log),
                                      second = make_model(theory, directory, "other", log);
  const auto &other_entries = parameters.other_entries;
  results.other_model = second->name() + (other_entries.empty() ? "" : " with other entries");
  log.note("Computing the other model for the bias: " + results.other_model);
  const auto predicted =
      [&](ForwardModel &model, const std::vector<std::pair<std::string, std::string>> &entries)
  {
    StationFitModel of_data(model, sought, measured, probes, entries, tests.get());
    const FitModel::Prediction prediction = of_data.predict({results.fit->estimates}).front();
    if (!prediction.failure.empty())
      throw RunError("the bias cannot be told, since " + model.name() +
                     " fails at the estimates: " + prediction.failure);
    return prediction.values;
  };
  results.bias = model_bias(results.parameters, *results.fit, measured.records,
                            predicted(*first, {}), predicted(*second, other_entries));
}

std::vector<FitParameter>
Identification::parameters_of_design(const IdentificationResults &results) const
{
  std::vector<FitParameter> at = results.parameters;
  for (std::size_t j = 0; j < at.size() && results.fit; ++j)
    at[j].start = results.fit->estimates[j];
  return at;
}

void Identification::design(ForwardModel &model, Log &log, IdentificationResults &results) const
{
  const std::vector<FitParameter> at = parameters_of_design(results);
  log.line("Design: " + std::to_string(expected.records.size()) + " records, " +
           std::to_string(candidates.size()) + " of them candidates; errors at " +
           (results.fit ? "the estimates" : "the starts of the numbers"));
  const MaterialTestModel of_tests = model_of_tests(parameters.tests);
  StationFitModel of_design(model, sought, expected, probes, {}, &of_tests);
  const ExpectedErrors errors(at, expected.records, of_design, parameters.difference_step);
  if (!always.empty())
    results.errors_of_file = errors.of(always);
  find_errors_of_parts(errors, results);
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
  if (parameters.n_experiments > 0 && !results.synthetic)
    try_design(model, results);
}

void Identification::find_errors_of_parts(const ExpectedErrors &errors,
                                          IdentificationResults &results) const
{
  std::vector<unsigned int> waves, of_tests;
  for (const unsigned int record : always)
    (record < expected.sources.size() ? waves : of_tests).push_back(record);
  if (waves.empty() || of_tests.empty())
    return;
  results.errors_of_parts.emplace_back("waves alone", errors.of(waves));
  results.errors_of_parts.emplace_back("material tests alone", errors.of(of_tests));
}

void Identification::try_design(ForwardModel &model, IdentificationResults &results) const
{
  const std::vector<FitParameter> at = parameters_of_design(results);
  // Of the records that are there, or of the best choice.
  std::vector<unsigned int> chosen = always;
  const ExpectedErrors::Errors &errors_of_chosen =
      results.choices.empty() ? *results.errors_of_file : results.choices.front().errors;
  if (!results.choices.empty())
    chosen.insert(chosen.end(), results.choices.front().records.begin(),
                  results.choices.front().records.end());
  // Material tests stand behind the stations.
  const std::size_t n_of_stations = expected.sources.size();
  std::stable_partition(chosen.begin(), chosen.end(),
                        [n_of_stations](const unsigned int record)
                        { return record < n_of_stations; });
  StationRecords of_chosen;
  std::vector<MaterialTest> chosen_tests;
  std::vector<NoiseModel> noise;
  for (const unsigned int r : chosen)
  {
    of_chosen.records.push_back(expected.records[r]);
    if (r < n_of_stations)
      of_chosen.sources.push_back(expected.sources[r]);
    else
      chosen_tests.push_back(parameters.tests[r - n_of_stations]);
    noise.push_back(expected.records[r].noise);
    if (!parameters.noise_is_known)
      of_chosen.records.back().noise = NoiseModel();
  }
  const MaterialTestModel of_tests = model_of_tests(chosen_tests);
  StationFitModel of_experiments(model, sought, of_chosen, probes, {}, &of_tests);
  results.synthetic = SyntheticExperiments(at, start_of(at), errors_of_chosen.standard_errors,
                                           of_chosen.records, noise, fit_options())
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
  std::string failure;
  if (results.fit && !results.fit->converged)
    failure = "the fit did not converge: " + results.fit->stop_reason;
  for (const std::string &text : results.failures)
    failure += (failure.empty() ? "" : "; ") + text;
  summary.set("status", failure.empty() ? "finished" : "failed");
  if (!failure.empty())
    summary.set("failure", failure);
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
  if (!failure.empty())
    throw RunError(failure);
}
} // namespace Continua
