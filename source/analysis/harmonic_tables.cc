#include <continua/analysis/harmonic_tables.h>

#include <continua/base/six_digits.h>
#include <continua/base/undefined.h>
#include <continua/continuum/field_list.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
namespace
{
/// A station that moves by this part of another one stands still.
constexpr double round_off = 1e-12;
/// Of a plane model for a depth of 1 m.
constexpr const char *unit_of_impedance = "Pa s/m^3";

/// "at 10 Hz".
std::string at_frequency(const double frequency)
{
  return " at " + six_digits(frequency) + " Hz";
}

void add_polar(const std::complex<double> &value, std::vector<double> &row)
{
  row.push_back(std::abs(value));
  row.push_back(std::arg(value));
}

/// Names of the four numbers of a complex one, "NAME: FIELD amplitude [UNIT]".
void add_names(const std::string &label, const std::string &unit, std::vector<std::string> &names)
{
  names.push_back(label + " amplitude [" + unit + "]");
  names.push_back(label + " phase [rad]");
  names.push_back(label + " real part [" + unit + "]");
  names.push_back(label + " imaginary part [" + unit + "]");
}

void add_numbers(const std::complex<double> &value, std::vector<double> &row)
{
  add_polar(value, row);
  row.push_back(value.real());
  row.push_back(value.imag());
}
} // namespace

template <int dim>
std::vector<NamedLoad> named_loads(const Case<dim> &input, HarmonicSystem<dim> &system)
{
  const HarmonicParameters &harmonic = input.harmonic;
  const auto turned = [](const HarmonicLoad &load, const double phase)
  {
    HarmonicLoad result;
    result.add(std::polar(1., phase), load);
    return result;
  };
  std::vector<NamedLoad> loads;
  if (!harmonic.unit_load.empty())
  {
    for (unsigned int c = 0; c < input.problem.conditions.size(); ++c)
      if (input.problem.conditions[c].name == harmonic.unit_load)
        loads.push_back({harmonic.unit_load, static_cast<int>(c),
                         turned(system.unit_load(c), harmonic.phases[c])});
  }
  else
    for (const HarmonicLoadSource &source : system.sources())
      loads.push_back({source.name, source.condition,
                       turned(system.load_of(source, 0.),
                              source.condition < 0 ? harmonic.body_force_phase
                                                   : harmonic.phases[source.condition])});
  return loads;
}

template <int dim>
std::vector<std::complex<double>>
probe_values(HarmonicSystem<dim> &system, Probes<dim> &probes, const HarmonicSolution &solution)
{
  // What is no number is about a state, too, and makes no number of the response.
  if (const double part = system.part_for_differences(solution); part != 0.)
  {
    // What the state itself has is no part of the response, which is a derivative.
    const auto derivative = [&](const std::complex<double> factor)
    {
      system.show(solution, part * factor);
      std::vector<double> values = probes.present_values();
      system.show(solution, -part * factor);
      const std::vector<double> others = probes.present_values();
      for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = (values[i] - others[i]) / (2. * part);
      return values;
    };
    const std::vector<double> real = derivative(1.), imaginary = derivative({0., -1.});
    std::vector<std::complex<double>> values;
    for (std::size_t i = 0; i < real.size(); ++i)
      values.emplace_back(real[i], imaginary[i]);
    return values;
  }
  // The imaginary part first, so that the real one is what the solver shows.
  system.show(solution, {0., -1.});
  const std::vector<double> imaginary = probes.present_values();
  system.show(solution, 1.);
  const std::vector<double> real = probes.present_values();
  std::vector<std::complex<double>> values;
  for (std::size_t i = 0; i < real.size(); ++i)
    values.emplace_back(real[i], imaginary[i]);
  return values;
}

template <int dim>
HarmonicTables<dim>::HarmonicTables(Run<dim> &run,
                                    HarmonicSystem<dim> &system,
                                    const std::vector<NamedLoad> &loads)
    : run(run), system(system), loads(loads)
{
  for (std::size_t l = 0; l < loads.size(); ++l)
    if (loads[l].condition >= 0)
      ends.push_back(
          {loads[l].name, static_cast<unsigned int>(loads[l].condition), static_cast<int>(l)});
  for (const unsigned int condition : system.ports())
    if (std::none_of(ends.begin(), ends.end(),
                     [condition](const End &end) { return end.condition == condition; }))
      ends.push_back({run.input.problem.conditions[condition].name, condition, -1});
  for (const StationsProbe &probe : run.input.probes.stations())
    for (std::size_t station = 1; station < probe.columns.size(); ++station)
      for (std::size_t field = 0; field < probe.columns[station].size(); ++field)
      {
        const unsigned int column = probe.columns[station][field];
        const ProbeColumnName name = run.input.probes.name_of(column);
        ratios.push_back({name.name + ": " + name.field, column, probe.columns[0][field]});
      }
  if (run.is_writer)
    open();
}

template <int dim>
void HarmonicTables<dim>::open()
{
  const Problem &problem = run.input.problem;
  const auto make = [this](const std::string &file, std::vector<std::string> names)
  {
    names.insert(names.begin(), "frequency [Hz]");
    return std::make_unique<TableWriter>(run.directory.file(file), names);
  };
  const Probes<dim> &probes = run.input.probes;
  std::vector<std::string> names;
  for (unsigned int column = 0; column < probes.n_columns(); ++column)
    add_names(probes.name_of(column).name + ": " + probes.name_of(column).field,
              probes.unit_of(column), names);
  if (!names.empty())
    response = make("response.csv", names);
  names.clear();
  for (const End &end : ends)
    add_names(end.name + (end.load >= 0 ? ": input impedance" : ": impedance of the outlet"),
              unit_of_impedance, names);
  if (!names.empty())
    impedance = make("impedance.csv", names);
  names.clear();
  for (const Ratio &ratio : ratios)
  {
    names.push_back(ratio.name + " ratio [1]");
    names.push_back(ratio.name + " phase [rad]");
  }
  if (!names.empty())
    transfer = make("transfer.csv", names);
  names.clear();
  for (const NamedLoad &load : loads)
    names.push_back("given by " + load.name + " [W]");
  for (const std::string &region : problem.regions)
    for (const char *kind : {"viscosity", "relaxation", "supports"})
      names.push_back(region + ": " + kind + " [W]");
  for (const unsigned int condition : system.ports())
    names.push_back("taken behind " + problem.conditions[condition].name + " [W]");
  names.emplace_back("residual [W]");
  power = make("mean-power.csv", names);
}

template <int dim>
void HarmonicTables<dim>::record(const double frequency,
                                 const HarmonicSolution &solution,
                                 const HarmonicLoad &total)
{
  responses.push_back({frequency, probe_values(system, run.input.probes, solution)});
  const std::vector<Complex> &values = responses.back().values;
  std::vector<double> row = {frequency}, of_ratios = {frequency};
  for (const Complex &value : values)
    add_numbers(value, row);
  for (const Ratio &ratio : ratios)
  {
    // To nothing, such as the displacement of a station that is held, there is no ratio.
    const bool is_nothing =
        std::abs(values[ratio.reference]) <= round_off * std::abs(values[ratio.column]);
    add_polar(is_nothing ? Complex(undefined, undefined)
                         : values[ratio.column] / values[ratio.reference],
              of_ratios);
  }
  if (response)
    response->row(row);
  if (transfer)
    transfer->row(of_ratios);
  record_impedances(frequency, solution, total);
  record_powers(frequency, solution, total);
}

template <int dim>
void HarmonicTables<dim>::record_impedances(const double frequency,
                                            const HarmonicSolution &solution,
                                            const HarmonicLoad &total)
{
  std::vector<double> row = {frequency};
  for (const End &end : ends)
  {
    const Complex flow_rate = system.flow_rate(end.condition, solution);
    // Without a flow there is none.
    Complex of_end(undefined, undefined);
    if (flow_rate != 0. && end.load >= 0)
      of_end = 2. * system.power_of(loads[end.load].load, solution, total) / std::norm(flow_rate);
    else if (flow_rate != 0. && end.load < 0)
      for (std::size_t port = 0; port < system.ports().size(); ++port)
        if (system.ports()[port] == end.condition)
          of_end = solution.port_pressures[port] / flow_rate;
    add_numbers(of_end, row);
    const auto &listed = run.input.harmonic.listed;
    if (std::isnan(of_end.real()) ||
        std::find(listed.begin(), listed.end(), frequency) == listed.end())
      continue;
    run.summary.add(
        {"impedance" + at_frequency(frequency), std::abs(of_end), unit_of_impedance, end.name});
    run.summary.add(
        {"phase of impedance" + at_frequency(frequency), std::arg(of_end), "rad", end.name});
  }
  if (impedance)
    impedance->row(row);
}

template <int dim>
void HarmonicTables<dim>::record_powers(const double frequency,
                                        const HarmonicSolution &solution,
                                        const HarmonicLoad &total)
{
  const HarmonicPowers powers = system.powers(solution, total);
  std::vector<double> row = {frequency};
  // What the loads move to and fro counts, too: without damping nothing is taken.
  double scale = powers.taken();
  for (const NamedLoad &load : loads)
  {
    const Complex given = system.power_of(load.load, solution, total);
    row.push_back(given.real());
    scale += std::abs(given);
  }
  for (const HarmonicPower &region : powers.regions)
    row.insert(row.end(), {region.viscosity, region.relaxation, region.supports});
  row.insert(row.end(), powers.ports.begin(), powers.ports.end());
  const double residual = powers.given() - powers.taken();
  row.push_back(residual);
  if (scale > 0.)
    largest_imbalance = std::max(largest_imbalance, std::abs(residual) / scale);
  if (power)
    power->row(row);
}

template <int dim>
void HarmonicTables<dim>::finish()
{
  for (TableWriter *const table : {response.get(), impedance.get(), transfer.get(), power.get()})
    if (table != nullptr)
      table->flush();
  const Probes<dim> &probes = run.input.probes;
  const std::vector<double> &listed = run.input.harmonic.listed;
  for (unsigned int column = 0; column < probes.n_columns(); ++column)
  {
    const ProbeColumnName name = probes.name_of(column);
    const std::string &unit = probes.unit_of(column), label = name.label();
    double largest = -1., at = 0.;
    for (const ProbeResponse &at_frequency_of : responses)
    {
      const Complex value = at_frequency_of.values[column];
      const double frequency = at_frequency_of.frequency;
      if (std::abs(value) > largest)
      {
        largest = std::abs(value);
        at = frequency;
      }
      if (std::find(listed.begin(), listed.end(), frequency) == listed.end())
        continue;
      const std::string where = ' ' + name.field + at_frequency(frequency);
      run.summary.add({"amplitude" + where, std::abs(value), unit, label});
      run.summary.add({"phase" + where, std::arg(value), "rad", label});
      run.summary.add({"real part" + where, value.real(), unit, label});
      run.summary.add({"imaginary part" + where, value.imag(), unit, label});
    }
    run.summary.add({"largest amplitude " + name.field, largest, unit, label});
    run.summary.add({"frequency of largest amplitude " + name.field, at, "Hz", label});
  }
  run.summary.add({"largest imbalance of mean powers", largest_imbalance, "1", ""});
}

template <int dim>
void HarmonicTables<dim>::name_quantities(const Case<dim> &input, QuantityNames &names)
{
  for (const ProbeColumnName &name : input.probes.expected_columns(field_names<dim>(input.problem)))
  {
    names.add("largest amplitude " + name.field, name.label());
    names.add("frequency of largest amplitude " + name.field, name.label());
    for (const double frequency : input.harmonic.listed)
      for (const char *number : {"amplitude ", "phase ", "real part ", "imaginary part "})
        names.add(number + name.field + at_frequency(frequency), name.label());
  }
  for (const BoundaryCondition &condition : input.problem.conditions)
    for (const double frequency : input.harmonic.listed)
    {
      names.add("impedance" + at_frequency(frequency), condition.name);
      names.add("phase of impedance" + at_frequency(frequency), condition.name);
    }
  names.add("largest imbalance of mean powers");
}

template std::vector<NamedLoad> named_loads(const Case<2> &, HarmonicSystem<2> &);
template std::vector<NamedLoad> named_loads(const Case<3> &, HarmonicSystem<3> &);
template std::vector<std::complex<double>>
probe_values(HarmonicSystem<2> &, Probes<2> &, const HarmonicSolution &);
template std::vector<std::complex<double>>
probe_values(HarmonicSystem<3> &, Probes<3> &, const HarmonicSolution &);
template class HarmonicTables<2>;
template class HarmonicTables<3>;
} // namespace Continua
