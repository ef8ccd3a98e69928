#include <continua/studies/identification.h>

#include <continua/base/input_error.h>
#include <continua/base/interruption.h>
#include <continua/base/joined.h>
#include <continua/base/name_choice.h>
#include <continua/base/version.h>
#include <continua/inference/least_squares_fit.h>
#include <continua/postprocess/writing_rank.h>
#include <continua/studies/evaluation_table.h>
#include <continua/studies/identification_report.h>
#include <continua/studies/run_pool.h>
#include <continua/studies/station_fit_model.h>
#include <continua/studies/theory_model.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <functional>

namespace Continua
{
namespace
{
unsigned int n_threads_of(const IdentificationParameters &parameters)
{
  return parameters.n_parallel > 0 ? parameters.n_parallel : RunPool::n_cores();
}
} // namespace

Identification::Identification(const AnalysisInput &input)
    : Analysis(input),
      analyses(input.analyses),
      n_dimensions(Continua::n_dimensions(model_of(general.model)))
{
  ParameterSection root = file.root();
  parameters.read(root);
  if (dealii::Utilities::MPI::n_mpi_processes(communicator) > 1)
    root.refuse("Analysis",
                "an identification starts its runs by itself, each on one rank, as many at a time "
                "as there are cores",
                "Start the program without mpirun");
  choose_model();
  if (n_dimensions == 2)
    read_case<2>();
  else
    read_case<3>();
  check_numbers();
  check_other_model();
  IdentificationReport::name_quantities(parameters, expected, quantities);
  quantities.refuse_unknown(file, section().subsection("Expected"), parameters.expected);
}

void Identification::choose_model()
{
  by_theory = parameters.model == PredictingModel::theory;
  if (parameters.model != PredictingModel::automatic)
    return;
  TheoryModel theory(analyses, command_line, n_dimensions, 1);
  by_theory = theory.why_not({}).empty();
}

template <int dim>
void Identification::read_case()
{
  const Case<dim> input = analyses.read_case<dim>(file, communicator, CaseUse::check,
                                                  by_theory ? "linear wave theory" : "transient");
  parameters.check(file.root());
  for (const StationsProbe &probe : input.probes.stations())
  {
    probes.push_back(probe.name);
    columns.push_back(
        {probe.name, static_cast<unsigned int>(probe.positions.size()), probe.fields});
  }
  if (probes.empty())
    file.root().subsection("Probes").refuse("", "an identification has no station to look at",
                                            "Add a probe with Stations, Fields and Measured");
  if (input.wave_theory.nonlinear)
    file.root()
        .subsection("Wave theory")
        .refuse("Nonlinear", "an identification takes linear theory or the run itself as its model",
                "Leave the entry out");
  read_sought();
  measured = StationRecords::measured(input, parameters, sought, section(), by_theory);
  if (parameters.is_design())
    expected = StationRecords::expected(input, parameters, section());
  read_tests();
  read_candidates();
}

void Identification::read_sought()
{
  ParameterSection family = section().subsection("Parameters");
  for (const SoughtNumber &number : parameters.sought)
    sought.push_back(find_sought_entry(file, family.subsection(number.name), number));
  for (std::size_t i = 0; i < sought.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (sought[i].entry.path() == sought[j].entry.path())
        family.subsection(parameters.sought[i].name)
            .refuse("Entry", "this number is sought twice", "Remove one of the two subsections");
  for (const SoughtEntry &number : sought)
    if (parameters.is_design() && !number.clock_of().empty())
      family.subsection(number.parameter.name)
          .refuse("Entry", "the clock of measurements is no number of an experiment to come",
                  "Remove the subsection, or the subsection 'Expected noise'");
  if (std::all_of(sought.begin(), sought.end(),
                  [](const SoughtEntry &number) { return number.parameter.is_held(); }))
    section().refuse(
        "Parameters", "nothing is sought",
        "Add 'subsection Parameters' with a subsection for each number, in which Entry "
        "names it");
}

void Identification::read_tests()
{
  ParameterSection materials = file.root().subsection("Materials");
  std::vector<MaterialTest> made;
  for (const MaterialTest &test : parameters.tests)
  {
    if (std::find(probes.begin(), probes.end(), test.name) != probes.end())
      section()
          .subsection("Material tests")
          .subsection(test.name)
          .refuse("", "a probe is called the same", "Rename one of them");
    if (!materials.has_subsection(test.material))
      section()
          .subsection("Material tests")
          .subsection(test.name)
          .refuse("Material", "the file has no material '" + test.material + "'",
                  choices(test.material, materials.subsections()));
    if (parameters.is_design())
      expected.records.push_back(test.data_record());
    // A design without data at the stations asks what they would add: there is nothing to fit.
    if (!test.is_made() || (parameters.is_design() && measured.sources.empty()))
      continue;
    measured.records.push_back(test.data_record());
    made.push_back(test);
  }
  tests = std::make_unique<MaterialTestModel>(model_of_tests(made));
}

MaterialTestModel Identification::model_of_tests(const std::vector<MaterialTest> &chosen) const
{
  return {without_data(command_line), model_of(general.model), chosen};
}

std::string Identification::origin_of(const unsigned int record) const
{
  const std::size_t n_of_stations = expected.sources.size();
  return record < n_of_stations ? expected.sources[record].probe_name
                                : parameters.tests[record - n_of_stations].name;
}

void Identification::read_candidates()
{
  std::vector<std::string> names = probes;
  for (const MaterialTest &test : parameters.tests)
    names.push_back(test.name);
  for (const std::string &name : parameters.candidates)
    if (std::find(names.begin(), names.end(), name) == names.end())
      section().refuse("Candidates",
                       "no probe with stations and no material test is called '" + name + "'",
                       choices(name, names));
  for (unsigned int r = 0; r < expected.records.size(); ++r)
    if (std::find(parameters.candidates.begin(), parameters.candidates.end(), origin_of(r)) !=
        parameters.candidates.end())
      candidates.push_back({r});
    else
      always.push_back(r);
  if (!parameters.candidates.empty() && candidates.size() < parameters.n_added)
    section().refuse("Records to add",
                     "there are only " + std::to_string(candidates.size()) + " candidates",
                     "Give a smaller number, or more stations and fields");
}

void Identification::check_numbers() const
{
  if (measured.records.empty() && !parameters.is_design())
    section().refuse("", "there are neither data nor an experiment to design",
                     "Give a probe with Stations the entry Measured, or add the subsection "
                     "'Expected noise'");
  unsigned int n_unknown = 0, n_priors = 0;
  for (const DataRecord &record : measured.records)
    n_unknown += record.noise.standard_deviation_is_known() ? 0 : 1;
  for (const SoughtEntry &number : sought)
    n_priors += number.parameter.prior ? 1 : 0;
  const std::size_t n_values = measured.n_values() + n_priors;
  if (!measured.records.empty() && n_values < sought.size() + n_unknown)
    section().refuse("Parameters",
                     "there are fewer data (" + std::to_string(n_values) +
                         ") than numbers that are sought (" + std::to_string(sought.size()) +
                         (n_unknown > 0 ? ", and the noise)" : ")"),
                     "Seek fewer numbers, or give more data");
}

void Identification::check_other_model() const
{
  if (parameters.other_model == OtherModel::none)
    return;
  if (measured.records.empty())
    section().refuse("Model error", "there are no data, and so no estimates that could be off",
                     "Give a probe the entry Measured, or remove the entry");
  if ((parameters.other_model == OtherModel::theory) == by_theory &&
      parameters.other_entries.empty())
    section().refuse("Model error", "it is the model of the fit, which has no bias to itself",
                     "Choose the other model, or add 'Entries of the other model'");
  if (n_dimensions == 2)
    read_other_case<2>();
  else
    read_other_case<3>();
}

template <int dim>
void Identification::read_other_case() const
{
  CommandLine of_other = without_data(command_line);
  set_entry(of_other, "Analysis",
            parameters.other_model == OtherModel::theory ? "linear wave theory" : "transient");
  for (const auto &[path, value] : parameters.other_entries)
    set_entry(of_other, path, value);
  try
  {
    ParameterFile other(of_other.parameter_file, of_other.overrides);
    analyses.read_case<dim>(other, communicator, CaseUse::check);
  }
  catch (const InputError &error)
  {
    section().refuse("Model error", std::string("with it the case is refused: ") + error.what(),
                     "");
  }
}

std::vector<std::string> Identification::outline() const
{
  std::vector<std::string> names;
  for (const SoughtEntry &number : sought)
    names.push_back(number.parameter.name);
  std::vector<std::string> lines = {std::string("analysis: identification by ") +
                                        (by_theory ? "linear wave theory" : "the simulation") +
                                        ", model: " + general.model,
                                    "sought: " + joined(names)};
  if (!measured.records.empty())
    lines.push_back("data: " + std::to_string(measured.records.size()) + " records with " +
                    std::to_string(measured.n_values()) + " values");
  if (parameters.is_design())
    lines.push_back("design: " + std::to_string(expected.records.size()) + " records, " +
                    std::to_string(candidates.size()) + " of them candidates");
  return lines;
}

std::string Identification::identity() const
{
  // What is asked, and of which model: a prediction of something else is no answer.
  std::string text = by_theory ? "theory" : "simulation";
  for (const SoughtEntry &number : sought)
    text += "; " + number.entry.path();
  for (const DataRecord &record : measured.records)
  {
    text += "; " + record.name;
    for (const double time : record.times)
      text += " " + shortest_number(time);
  }
  return file.identity({"Title", "Output", "Expected", "Identification"}) + " " +
         std::to_string(std::hash<std::string>()(text)) + " of " + version() + " " + revision();
}

void Identification::check_restart(const OutputDirectory &directory) const
{
  const std::string problem =
      EvaluationTable::why_not(directory.file("checkpoint/evaluations"), identity());
  if (!problem.empty())
    throw InputError({directory.path(), 0}, "--restart", problem,
                     "Begin anew with --overwrite, or go on with the file as it was");
}

std::unique_ptr<ForwardModel> Identification::make_model(const bool theory,
                                                         const OutputDirectory &directory,
                                                         const std::string &runs,
                                                         Log &log) const
{
  if (!theory)
    return std::make_unique<SimulationModel>(
        command_line, directory, columns, n_threads_of(parameters), runs, memory_of_simulation(),
        [&log](const std::string &text) { log.warning(text); });
  return std::make_unique<TheoryModel>(analyses, command_line, n_dimensions,
                                       n_threads_of(parameters));
}

double Identification::memory_of_simulation() const
{
  CommandLine checking = without_data(command_line);
  set_entry(checking, "Analysis", "transient");
  // Its own or of the other model, which has the same mesh in most cases.
  for (const auto &[path, value] : parameters.other_entries)
    set_entry(checking, path, value);
  checking.validate = true;
  ParameterFile of_run(checking.parameter_file, checking.overrides);
  return analyses.make(of_run, checking, communicator)->estimated_memory();
}

std::vector<FitParameter> Identification::fit_parameters() const
{
  std::vector<FitParameter> result;
  for (const SoughtEntry &number : sought)
    result.push_back(number.parameter);
  return result;
}

FitOptions Identification::fit_options() const
{
  FitOptions options;
  options.tolerance = parameters.tolerance;
  options.largest_n_evaluations = parameters.largest_n_evaluations;
  options.n_starts = parameters.n_starts;
  options.difference_step = parameters.difference_step;
  options.correlated_noise = parameters.correlated_noise;
  options.order_criterion = parameters.order_criterion;
  options.confidence = parameters.confidence;
  return options;
}

void Identification::compute(const OutputDirectory &directory, Log &log, Summary &summary)
{
  const std::unique_ptr<ForwardModel> model = make_model(by_theory, directory, "evaluation", log);
  IdentificationResults results;
  results.model = model->name();
  results.parameters = fit_parameters();
  log.line("Model: " + model->name());
  if (!measured.records.empty())
  {
    log.line("Data: " + std::to_string(measured.records.size()) + " records with " +
             std::to_string(measured.n_values()) + " values" +
             (measured.n_left_out > 0 ? "; " + std::to_string(measured.n_left_out) +
                                            " rows outside the time of the run are left out"
                                      : ""));
    StationFitModel of_data(*model, sought, measured, probes, {}, tests.get());
    for (const std::string &note : measured.notes)
      log.line(note);
    fit(of_data, directory, log, results);
  }
  if (parameters.is_design() && (!results.fit || results.fit->converged))
    design(*model, log, results);
  finish(directory, log, summary, results);
}
} // namespace Continua
