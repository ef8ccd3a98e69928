#include <continua/studies/theory_model.h>

#include <continua/base/interruption.h>
#include <continua/base/parameter_text.h>
#include <continua/studies/planned_run.h>
#include <continua/theory/ball.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <new>
#include <thread>

namespace Continua
{
namespace
{
/// A case as theory sees it.
template <int dim>
struct TheoryCase
{
  std::unique_ptr<ParameterFile> file; ///< which the probes refer to
  std::unique_ptr<Case<dim>> input;
  TubeWaveCase wave_case;
  std::string failure;
};

template <int dim>
TheoryCase<dim> read_theory_case(const AnalysisTable &analyses,
                                 CommandLine command_line,
                                 const std::vector<std::pair<std::string, std::string>> &settings)
{
  TheoryCase<dim> result;
  for (const auto &[path, value] : settings)
    set_entry(command_line, path, value);
  try
  {
    result.file =
        std::make_unique<ParameterFile>(command_line.parameter_file, command_line.overrides);
    // A coarse mesh is enough: theory takes nothing from it.
    result.input.reset(
        new Case<dim>(analyses.read_case<dim>(*result.file, MPI_COMM_SELF, CaseUse::check)));
    result.failure = make_tube_wave_case(*result.input, result.wave_case);
  }
  catch (const std::bad_alloc &)
  {
    throw; // it says nothing of the numbers
  }
  catch (const std::exception &error)
  {
    result.failure = collapse_blanks(error.what());
  }
  return result;
}

/// At times before the start the tube is at rest.
StationHistories waves_at(const StationsProbe &probe,
                          const TubeWaveTheory &theory,
                          const TubeWaveCase &wave_case,
                          const std::vector<double> &times)
{
  const std::size_t n_before = std::lower_bound(times.begin(), times.end(), 0.) - times.begin();
  StationHistories histories =
      station_waves(probe, theory, wave_case,
                    std::vector<double>(times.begin() + n_before, times.end()))
          .histories;
  for (auto &of_station : histories)
    for (std::vector<double> &of_field : of_station)
      of_field.insert(of_field.begin(), n_before, 0.);
  return histories;
}

template <int dim>
ForwardAnswer
answer_of(const TheoryCase<dim> &asked, const ForwardQuestion &question, KeptWaves &kept)
{
  ForwardAnswer answer;
  answer.failure = asked.failure;
  if (!answer.failure.empty())
    return answer;
  try
  {
    const Case<dim> &input = *asked.input;
    const TubeWaveTheory theory(asked.wave_case.problem, asked.wave_case.inlet, input.time.end_time,
                                input.wave_theory.spectral_tolerance, &kept);
    const std::vector<StationsProbe> &probes = input.probes.stations();
    for (std::size_t p = 0; p < probes.size(); ++p)
      answer.histories.push_back(waves_at(probes[p], theory, asked.wave_case, question.times[p]));
  }
  catch (const std::bad_alloc &)
  {
    throw;
  }
  catch (const std::exception &error)
  {
    answer.histories.clear();
    answer.failure = collapse_blanks(error.what());
  }
  return answer;
}
} // namespace

TheoryModel::TheoryModel(const AnalysisTable &analyses,
                         const CommandLine &of_file,
                         const unsigned int n_dimensions,
                         const unsigned int n_threads)
    : analyses(analyses),
      command_line(without_data(of_file)),
      n_dimensions(n_dimensions),
      n_threads(std::max(1u, n_threads))
{
  set_entry(command_line, "Analysis", "linear wave theory");
}

std::vector<ForwardAnswer> TheoryModel::answers(const std::vector<ForwardQuestion> &questions)
{
  return n_dimensions == 2 ? answers_of<2>(questions) : answers_of<3>(questions);
}

std::string TheoryModel::why_not(const std::vector<std::pair<std::string, std::string>> &settings)
{
  return n_dimensions == 2 ? read_theory_case<2>(analyses, command_line, settings).failure
                           : read_theory_case<3>(analyses, command_line, settings).failure;
}

template <int dim>
std::vector<ForwardAnswer> TheoryModel::answers_of(const std::vector<ForwardQuestion> &questions)
{
  std::vector<ForwardAnswer> answers(questions.size());
  const unsigned int n = std::min<std::size_t>(n_threads, questions.size());
  std::atomic<std::size_t> next(0);
  std::vector<TheoryCase<dim>> cases;
  // What calls MPI is done on this thread.
  for (const ForwardQuestion &question : questions)
    cases.push_back(read_theory_case<dim>(analyses, command_line, question.settings));
  // By question, each of which is of one thread: a vector of bool would share its words.
  std::vector<char> lacks_memory(questions.size(), 0);
  const auto work = [&]()
  {
    for (std::size_t i = next++; i < questions.size() && SignalWatch::pending() == 0; i = next++)
      try
      {
        answers[i] = answer_of<dim>(cases[i], questions[i], kept);
      }
      catch (const std::bad_alloc &)
      {
        lacks_memory[i] = 1;
      }
  };
  std::vector<std::thread> threads;
  for (unsigned int i = 1; i < n; ++i)
    threads.emplace_back(
        [&work]()
        {
          work();
          release_memory_of_balls();
        });
  work();
  for (std::thread &thread : threads)
    thread.join();
  // The memory may be enough for each of them alone; else the fit ends, since it says nothing of
  // the numbers.
  for (std::size_t i = 0; i < questions.size() && SignalWatch::pending() == 0; ++i)
    if (lacks_memory[i] != 0)
      answers[i] = answer_of<dim>(cases[i], questions[i], kept);
  SignalWatch::stop_if_asked(MPI_COMM_SELF, "in an evaluation of linear wave theory");
  return answers;
}
} // namespace Continua
