#include <continua/studies/station_fit_model.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Continua
{
StationFitModel::StationFitModel(ForwardModel &model,
                                 const std::vector<SoughtEntry> &sought,
                                 const StationRecords &records,
                                 const std::vector<std::string> &probes,
                                 std::vector<std::pair<std::string, std::string>> other_entries,
                                 const MaterialTestModel *const tests)
    : model(model),
      sought(sought),
      records(records),
      other_entries(std::move(other_entries)),
      tests(tests),
      clocks(probes.size(), none),
      times(probes.size())
{
  for (unsigned int p = 0; p < probes.size(); ++p)
    for (unsigned int i = 0; i < sought.size(); ++i)
      if (sought[i].clock_of() == probes[p])
        clocks[p] = i;
  for (std::size_t r = 0; r < records.sources.size(); ++r)
  {
    std::vector<double> &all = times[records.sources[r].probe];
    all.insert(all.end(), records.records[r].times.begin(), records.records[r].times.end());
  }
  for (std::vector<double> &all : times)
  {
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
  }
  for (std::size_t r = 0; r < records.sources.size(); ++r)
  {
    const std::vector<double> &all = times[records.sources[r].probe];
    places.emplace_back();
    for (const double time : records.records[r].times)
      places.back().push_back(std::lower_bound(all.begin(), all.end(), time) - all.begin());
  }
}

double StationFitModel::shift_of(const unsigned int record, const std::vector<double> &set) const
{
  if (record >= records.sources.size())
    return 0.; // of a material test
  const unsigned int clock = clocks[records.sources[record].probe];
  return clock == none ? 0. : set[clock];
}

std::vector<std::pair<std::string, std::string>>
StationFitModel::settings(const std::vector<double> &set) const
{
  std::vector<NumericEntry> entries;
  std::vector<double> numbers;
  for (std::size_t i = 0; i < sought.size(); ++i)
    if (sought[i].clock_of().empty())
    {
      entries.push_back(sought[i].entry);
      numbers.push_back(set[i]);
    }
  std::vector<std::pair<std::string, std::string>> result = other_entries;
  const auto of_numbers = NumericEntry::settings(entries, numbers);
  result.insert(result.end(), of_numbers.begin(), of_numbers.end());
  return result;
}

ForwardQuestion StationFitModel::question(const std::vector<double> &set) const
{
  ForwardQuestion result;
  result.settings = settings(set);
  result.times = times;
  for (std::size_t p = 0; p < times.size(); ++p)
    if (clocks[p] != none)
      for (double &time : result.times[p])
        time += set[clocks[p]];
  return result;
}

FitModel::Prediction StationFitModel::prediction(const ForwardAnswer &answer) const
{
  Prediction result;
  result.failure = answer.failure;
  if (!result.failure.empty())
    return result;
  for (std::size_t r = 0; r < records.sources.size(); ++r)
  {
    const RecordSource &source = records.sources[r];
    const std::vector<double> &history =
        answer.histories[source.probe][source.station][source.field];
    for (const std::size_t place : places[r])
      result.values.push_back(history[place]);
  }
  return result;
}

std::vector<FitModel::Prediction>
StationFitModel::predict(const std::vector<std::vector<double>> &sets)
{
  std::vector<ForwardQuestion> questions;
  std::vector<std::size_t> asked; // by question: the set
  std::vector<Prediction> predictions(sets.size());
  for (std::size_t i = 0; i < sets.size(); ++i)
  {
    // What the file does not accept is not asked for.
    for (std::size_t n = 0; n < sought.size(); ++n)
      if (!sought[n].entry.accepts(sets[i][n]))
        predictions[i].failure =
            "'" + sought[n].entry.path() + "' does not accept " + shortest_number(sets[i][n]);
    if (!predictions[i].failure.empty())
      continue;
    questions.push_back(question(sets[i]));
    asked.push_back(i);
  }
  const std::vector<ForwardAnswer> answers = model.answers(questions);
  for (std::size_t q = 0; q < answers.size(); ++q)
  {
    predictions[asked[q]] = prediction(answers[q]);
    if (tests != nullptr)
      tests->append(questions[q].settings, predictions[asked[q]]);
  }
  return predictions;
}
} // namespace Continua
