#include <continua/analysis/response_errors.h>

#include <continua/base/input_error.h>
#include <continua/base/interruption.h>
#include <continua/base/log.h>
#include <continua/base/six_digits.h>
#include <continua/base/table_writer.h>
#include <continua/base/text_table.h>
#include <continua/base/undefined.h>
#include <continua/continuum/field_list.h>
#include <continua/mesh/partition.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace Continua
{
using namespace dealii;

namespace
{
/// Lines of the table on the screen.
constexpr std::size_t most_errors_shown = 10;

/// "estimated error of amplitude displacement x at 10 Hz"
std::string name_of_error(const std::string &what, const double frequency)
{
  return "estimated error of " + what + " at " + six_digits(frequency) + " Hz";
}
} // namespace

template <int dim>
ResponseErrors<dim>::ResponseErrors(Run<dim> &run)
    : run(run),
      file(run.file.changed(
          {{"Finite element/Velocity degree",
            std::to_string(run.input.discretisation.taylor_hood.space.velocity_degree + 1)}}))
{
  try
  {
    GeneralParameters general;
    // The default, and the one that the file asks for.
    general.read(file.root(), {{general.analysis, ""}, {run.input.general.analysis, ""}});
    richer = std::make_unique<Case<dim>>(file, general, run.input.analysis, run.input.communicator,
                                         CaseUse::run);
  }
  catch (const InputError &error)
  {
    file.root()
        .subsection("Harmonic")
        .refuse("Estimate errors",
                std::string("the case with elements of the next degree cannot be computed: ") +
                    error.what(),
                "Remove the entry, or change what it says");
  }
}

template <int dim>
std::map<double, std::vector<std::complex<double>>>
ResponseErrors<dim>::richer_values(const std::vector<ProbeResponse> &responses)
{
  // What is to be said of the case was said of the run.
  Log silent(run.input.communicator, false);
  refine(*richer->triangulation, richer->mesh.refinements);
  const std::unique_ptr<ContinuumSolver<dim>> solver =
      make_solver<dim>(*richer->triangulation, richer->problem, richer->discretisation, silent);
  solver->initialise();
  richer->probes.attach(*solver, richer->problem.model, richer->problem.mesh_moves);
  const std::unique_ptr<HarmonicSystem<dim>> system = solver->harmonic_system();
  HarmonicLoad total;
  for (const NamedLoad &load : named_loads(*richer, *system))
    total.add(1., load.load);
  std::vector<Complex> points;
  for (const ProbeResponse &response : responses)
    points.emplace_back(0., 2. * numbers::PI * response.frequency);
  std::map<double, std::vector<Complex>> values;
  system->solve_at(
      points, [&total](std::size_t) { return std::vector<HarmonicLoad>{total}; },
      [&](const std::size_t number, const std::vector<HarmonicLoad> &,
          const std::vector<HarmonicSolution> &solutions)
      {
        values[responses[number].frequency] = probe_values(*system, richer->probes, solutions[0]);
        SignalWatch::stop_if_asked(run.input.communicator,
                                   "after " + std::to_string(number + 1) +
                                       " estimates of errors; a harmonic analysis begins anew, "
                                       "with --overwrite");
      });
  run.log.detail("Errors of the responses by " + std::to_string(system->n_unknowns()) +
                 " unknowns of the next degree");
  return values;
}

template <int dim>
void ResponseErrors<dim>::add_response(const ProbeResponse &response,
                                       const std::vector<Complex> &values)
{
  for (unsigned int column = 0; column < response.values.size(); ++column)
  {
    const ProbeColumnName name = run.input.probes.name_of(column);
    const Complex value = response.values[column], richer_value = values[column];
    estimates.push_back({response.frequency, name.name, name.label(), "amplitude " + name.field,
                         run.input.probes.unit_of(column), std::abs(value),
                         std::abs(richer_value) - std::abs(value), true});
    // Between -pi and pi, whatever the turn of each.
    estimates.push_back({response.frequency, name.name, name.label(), "phase " + name.field, "rad",
                         std::arg(value), std::arg(richer_value * std::conj(value)), false});
  }
}

template <int dim>
void ResponseErrors<dim>::add_waves(const WaveFit &fit, const std::vector<Complex> &values)
{
  for (const StationsProbe &probe : run.input.probes.stations())
  {
    if (probe.name != fit.probe || fit.waves.waves.empty())
      continue;
    std::vector<std::vector<Complex>> fields(probe.fields.size());
    for (const std::vector<unsigned int> &of_station : probe.columns)
      for (std::size_t f = 0; f < fields.size() && f < of_station.size(); ++f)
        fields[f].push_back(values[of_station[f]]);
    TravellingWavesOptions options;
    options.n_waves = fit.waves.waves.size();
    for (const TravellingWave &wave : fit.waves.waves)
      options.start.push_back(wave.propagation);
    const TravellingWaves of_richer =
        fit_travelling_waves(probe.positions, fields, 2. * numbers::PI * fit.frequency, options);
    for (std::size_t w = 0; w < std::min(of_richer.waves.size(), fit.waves.waves.size()); ++w)
      for (const auto &[what, unit, number] :
           {std::tuple("speed", "m/s", &TravellingWave::speed),
            std::tuple("attenuation", "1/m", &TravellingWave::attenuation)})
        estimates.push_back({fit.frequency, probe.name, probe.name,
                             name_of_wave(options.n_waves, w) + what, unit,
                             fit.waves.waves[w].*number,
                             of_richer.waves[w].*number - fit.waves.waves[w].*number, true});
  }
}

template <int dim>
void ResponseErrors<dim>::estimate(const std::vector<ProbeResponse> &responses,
                                   const std::vector<WaveFit> &fits)
{
  SectionTimer::Scope scope(run.log.timer(), "estimates of errors");
  const std::map<double, std::vector<Complex>> values = richer_values(responses);
  for (const ProbeResponse &response : responses)
  {
    add_response(response, values.at(response.frequency));
    for (const WaveFit &fit : fits)
      if (fit.frequency == response.frequency)
        add_waves(fit, values.at(response.frequency));
  }
  write();
  add_quantities();
  show_largest();
}

template <int dim>
void ResponseErrors<dim>::write() const
{
  if (!run.is_writer)
    return;
  std::vector<std::string> header = {"frequency [Hz]"};
  std::map<double, std::map<std::string, double>> rows;
  for (const Estimate &estimate : estimates)
    for (const auto &[begin, number] :
         {std::pair("", estimate.value), std::pair("estimated error of ", estimate.error)})
    {
      const std::string column =
          estimate.name + ": " + begin + estimate.what + " [" + estimate.unit + "]";
      if (std::find(header.begin(), header.end(), column) == header.end())
        header.push_back(column);
      rows[estimate.frequency][column] = number;
    }
  TableWriter table(run.directory.file("errors.csv"), header);
  for (const auto &[frequency, of_columns] : rows)
  {
    std::vector<double> row = {frequency};
    for (std::size_t column = 1; column < header.size(); ++column)
    {
      const auto found = of_columns.find(header[column]);
      row.push_back(found == of_columns.end() ? undefined : found->second);
    }
    table.row(row);
  }
  table.flush();
}

template <int dim>
void ResponseErrors<dim>::add_quantities() const
{
  const std::vector<double> &listed = run.input.harmonic.listed;
  for (const Estimate &estimate : estimates)
    if (std::find(listed.begin(), listed.end(), estimate.frequency) != listed.end())
      run.summary.add({name_of_error(estimate.what, estimate.frequency), estimate.error,
                       estimate.unit, estimate.label});
}

template <int dim>
void ResponseErrors<dim>::show_largest() const
{
  const auto relative = [](const Estimate &estimate)
  { return std::abs(estimate.error / estimate.value); };
  // Of each number the frequency at which it is largest.
  std::map<std::string, const Estimate *> largest;
  for (const Estimate &estimate : estimates)
  {
    if (!estimate.has_size || !std::isfinite(relative(estimate)))
      continue;
    const Estimate *&kept = largest[estimate.name + ": " + estimate.what];
    if (kept == nullptr || relative(estimate) > relative(*kept))
      kept = &estimate;
  }
  std::vector<const Estimate *> order;
  for (const auto &[name, estimate] : largest)
    order.push_back(estimate);
  std::stable_sort(order.begin(), order.end(),
                   [&relative](const Estimate *const a, const Estimate *const b)
                   { return relative(*a) > relative(*b); });
  const std::size_t n_shown = std::min(order.size(), most_errors_shown);
  constexpr int n_digits_of_error = 2;
  std::vector<std::vector<std::string>> table = {
      {"largest estimated errors by the mesh", "frequency", "error", "of its value"}};
  for (std::size_t i = 0; i < n_shown; ++i)
    table.push_back({"  " + order[i]->name + ": " + order[i]->what,
                     six_digits(order[i]->frequency) + " Hz",
                     number_text(order[i]->error, n_digits_of_error) + " " + order[i]->unit,
                     number_text(100. * relative(*order[i]), n_digits_of_error) + " %"});
  for (const std::string &line : aligned_lines(table))
    run.log.note(line);
}

template <int dim>
void ResponseErrors<dim>::name_quantities(const Case<dim> &input, QuantityNames &names)
{
  if (!input.harmonic.estimates_errors)
    return;
  for (const double frequency : input.harmonic.listed)
  {
    for (const ProbeColumnName &name :
         input.probes.expected_columns(field_names<dim>(input.problem)))
      for (const char *const number : {"amplitude ", "phase "})
        names.add(name_of_error(number + name.field, frequency), name.label());
    for (const StationsProbe &probe : input.probes.stations())
    {
      if (!WaveNumberTable<dim>::has_enough_stations(input, probe))
        continue;
      for (unsigned int wave = 0; wave < input.harmonic.n_waves; ++wave)
        for (const char *const what : {"speed", "attenuation"})
          names.add(name_of_error(name_of_wave(input.harmonic.n_waves, wave) + what, frequency),
                    probe.name);
    }
  }
}

template class ResponseErrors<2>;
template class ResponseErrors<3>;
} // namespace Continua
