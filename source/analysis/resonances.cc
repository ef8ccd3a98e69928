#include <continua/analysis/resonances.h>

#include <continua/analysis/harmonic_checks.h>
#include <continua/analysis/harmonic_tables.h>
#include <continua/base/collective.h>
#include <continua/base/input_error.h>
#include <continua/base/interruption.h>
#include <continua/base/undefined.h>
#include <continua/linear_algebra/singular_matrix.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Continua
{
using namespace dealii;

namespace
{
using Complex = std::complex<double>;

/// Resonances that have quantities in the summary.
constexpr unsigned int most_named = 100;
/// A smaller one is round-off.
constexpr double least_damping_ratio = 1e-9;
/// By this angle the contour of the count goes round the axis, where a body without damping has
/// its modes [rad].
constexpr double angle_beyond_axis = 0.02;
constexpr std::size_t most_evaluations = 600;
/// The largest damping ratio of a motion that the tube behind an absorbing end answers to.
constexpr double largest_ratio_of_ends = 0.93;
/// The sector in which equal resonances are counted, over |s|, to either side.
constexpr double widest_round_one = 1e-3;

/// Makes the largest displacement a real one of 1 m. The first of equal ones counts, on the first
/// rank that has one.
void normalise(HarmonicSolution &shape, const MPI_Comm communicator)
{
  Complex largest = 0.;
  // Round-off must not choose between components that symmetry makes equal.
  for (const Complex &value : shape.displacement)
    if (std::abs(value) > (1. + 1e-6) * std::abs(largest))
      largest = value;
  const std::vector<double> real = all_gather(communicator, largest.real());
  const std::vector<double> imaginary = all_gather(communicator, largest.imag());
  Complex chosen = 0.;
  for (std::size_t rank = 0; rank < real.size(); ++rank)
    if (const Complex value(real[rank], imaginary[rank]);
        std::abs(value) > (1. + 1e-6) * std::abs(chosen))
      chosen = value;
  HarmonicSolution scaled;
  scaled.s = shape.s;
  scaled.add(1. / chosen, shape);
  shape = scaled;
}

/// The boundaries that may have a unit load: those with a traction, and outlets.
template <int dim>
std::vector<unsigned int> unit_loads_of(const Problem &problem, const HarmonicSystem<dim> &system)
{
  std::vector<unsigned int> result;
  for (unsigned int c = 0; c < problem.conditions.size(); ++c)
  {
    const bool is_port =
        std::find(system.ports().begin(), system.ports().end(), c) != system.ports().end();
    // A force makes no work on a port, whose pressure is part of the answer.
    if (!is_port && problem.conditions[c].normal.kind == BoundaryPart::Kind::traction)
      result.push_back(c);
  }
  return result;
}
} // namespace

template <int dim>
void Resonances<dim>::check(const Case<dim> &input, ParameterSection root)
{
  check_harmonic_probes(input, root, remedy_of_harmonic);
  if (input.problem.is_nonlinear())
  {
    check_loaded_state(input, root, remedy_of_harmonic);
    check_no_loads_of_state_in_time(input, root, remedy_of_harmonic);
    ParameterSection output = root.subsection("Output");
    if (input.output.final_fields && output.given("Final fields"))
      output.refuse("Final fields",
                    "about a state in finite deformation no fields of the shapes are written",
                    "Remove the entry, and give probes");
  }
  else
    check_no_mean_pressure(input.problem, root, remedy_of_harmonic);
  for (const BoundaryCondition &condition : input.problem.conditions)
    if (condition.type == BoundaryType::absorbing &&
        input.resonances.largest_damping_ratio > largest_ratio_of_ends)
      root.subsection("Resonances")
          .refuse("Largest damping ratio",
                  "the waves behind the absorbing end '" + condition.name +
                      "' are known up to a damping ratio of 0.93",
                  "Give 0.93 or less");
}

template <int dim>
void Resonances<dim>::name_quantities(const Case<dim> &, QuantityNames &names)
{
  names.add("resonances");
  names.add("resonances by winding");
  names.add("largest residual");
  for (unsigned int k = 1; k <= most_named; ++k)
    for (const char *const what :
         {"frequency", "natural frequency", "damping ratio", "quality factor"})
      names.add("resonance " + std::to_string(k) + " " + what);
}

template <int dim>
void Resonances<dim>::perform()
{
  this->start();
  Case<dim> &input = run.input;
  ResonanceSearch<dim> search(*system, input.resonances, unit_loads_of(input.problem, *system),
                              input.communicator, run.log);
  std::vector<Resonance> found;
  {
    SectionTimer::Scope scope(run.log.timer(), "resonances");
    found = search.find();
  }
  std::ostringstream text;
  text << search.n_frequencies() << " frequencies, " << search.n_candidates() << " candidates, "
       << found.size() << (found.size() == 1 ? " resonance" : " resonances");
  run.log.detail(text.str());
  if (!search.responses_are_known())
    run.log.warning("the responses are not known between the frequencies (a difference of " +
                    std::to_string(search.difference()) +
                    " of the largest): resonances may be missing. Give a narrower band, or more "
                    "Resonances/Most frequencies");
  write(found);
  if (input.resonances.counts)
    count(found);
  run.summary.set("frequencies", static_cast<double>(search.n_frequencies()));
  run.summary.set("candidates", static_cast<double>(search.n_candidates()));
  run.citations.add("aaa");
  this->finish(0.);
}

template <int dim>
void Resonances<dim>::write(std::vector<Resonance> &found)
{
  Case<dim> &input = run.input;
  const std::unique_ptr<TableWriter> table = this->complex_table(
      "resonances.csv",
      {"resonance [1]", "frequency [Hz]", "natural frequency [Hz]", "damping ratio [1]",
       "quality factor [1]", "Re s [1/s]", "Im s [1/s]", "residual [1]"});
  double largest_residual = 0.;
  std::vector<std::string> texts;
  for (std::size_t k = 0; k < found.size(); ++k)
  {
    Resonance &resonance = found[k];
    normalise(resonance.shape, input.communicator);
    largest_residual = std::max(largest_residual, resonance.residual);
    const bool is_damped = std::abs(resonance.damping_ratio()) > least_damping_ratio;
    this->add_row(table,
                  {k + 1., resonance.frequency(), resonance.natural_frequency(),
                   resonance.damping_ratio(), is_damped ? resonance.quality_factor() : undefined,
                   resonance.s.real(), resonance.s.imag(), resonance.residual},
                  probe_values(*system, input.probes, resonance.shape));
    if (input.output.final_fields && !input.problem.is_nonlinear())
      this->write_fields(resonance.shape, k + 1.);
    std::ostringstream text;
    text.precision(5);
    text << "Resonance " << k + 1 << ": " << resonance.frequency() << " Hz, ";
    if (is_damped)
      text << "damping ratio " << resonance.damping_ratio() << ", quality factor "
           << resonance.quality_factor();
    else
      text << "no damping";
    run.log.line(text.str());
    texts.push_back(text.str());
    if (k >= most_named)
      continue;
    const std::string name = "resonance " + std::to_string(k + 1) + " ";
    run.summary.add({name + "frequency", resonance.frequency(), "Hz", ""});
    run.summary.add({name + "natural frequency", resonance.natural_frequency(), "Hz", ""});
    run.summary.add({name + "damping ratio", resonance.damping_ratio(), "1", ""});
    if (is_damped)
      run.summary.add({name + "quality factor", resonance.quality_factor(), "1", ""});
    else
      run.summary.add_absence(name + "quality factor", "", "the resonance has no damping");
  }
  if (table)
    table->flush();
  this->finish_fields();
  run.summary.set("resonances", texts);
  run.summary.add({"resonances", static_cast<double>(found.size()), "1", ""});
  run.summary.add({"largest residual", largest_residual, "1", ""});
}

template <int dim>
WindingNumber Resonances<dim>::turns_round(const PlaneSector &sector)
{
  const auto logarithm = [this](const Complex s)
  {
    SignalWatch::stop_if_asked(run.input.communicator,
                               "in the count of resonances; the search begins anew, with "
                               "--overwrite");
    try
    {
      system->factor(s);
    }
    catch (const SingularMatrix &)
    {
      system->factor(s * (1. + 1e-9));
    }
    return system->determinant().logarithm;
  };
  return winding_number(logarithm, sector, most_evaluations);
}

template <int dim>
int Resonances<dim>::multiplicity(const std::vector<Resonance> &found, const std::size_t number)
{
  const Complex s = found[number].s;
  double width = widest_round_one;
  for (std::size_t other = 0; other < found.size(); ++other)
    if (other != number)
      width = std::min(width, 0.3 * std::abs(found[other].s / s - 1.));
  const WindingNumber turns = turns_round({std::abs(s) * (1. - width), std::abs(s) * (1. + width),
                                           std::arg(s) - width, std::arg(s) + width});
  return turns.is_known ? std::max(1, turns.number) : 1;
}

template <int dim>
void Resonances<dim>::count(const std::vector<Resonance> &found)
{
  const ResonanceParameters &parameters = run.input.resonances;
  SectionTimer::Scope scope(run.log.timer(), "count");
  const WindingNumber winding =
      turns_round({2. * numbers::PI * parameters.lowest, 2. * numbers::PI * parameters.highest,
                   0.5 * numbers::PI - angle_beyond_axis,
                   0.5 * numbers::PI + std::asin(parameters.largest_damping_ratio)});
  if (!winding.is_known)
  {
    run.log.warning(
        "the number of resonances was not found by the winding of the determinant, in " +
        std::to_string(winding.n_evaluations) + " factors: one may lie on the edge of the band");
    run.summary.add_absence("resonances by winding", "",
                            "the phase of the determinant was not followed round the band");
    return;
  }
  run.log.line("By the winding of the determinant: " + std::to_string(winding.number));
  run.log.detail("The winding took " + std::to_string(winding.n_evaluations) + " factors");
  run.summary.add({"resonances by winding", static_cast<double>(winding.number), "1", ""});
  const int n_found = static_cast<int>(found.size());
  const std::string numbers_of_both = "the band has " + std::to_string(winding.number) +
                                      " resonances by the winding of the determinant, and " +
                                      std::to_string(n_found) + " were found: ";
  if (winding.number < n_found)
    run.log.warning(numbers_of_both +
                    "the determinant has poles in the band, such as those of an absorbing end");
  if (winding.number <= n_found)
    return;
  // The symmetry of a body may make several of them equal.
  int n_with_equals = 0;
  for (std::size_t k = 0; k < found.size(); ++k)
  {
    const int n_equal = multiplicity(found, k);
    n_with_equals += n_equal;
    if (n_equal > 1)
      run.log.line("Resonance " + std::to_string(k + 1) + " stands for " + std::to_string(n_equal) +
                   " equal ones");
  }
  if (winding.number > n_with_equals)
    throw RunError(numbers_of_both + std::to_string(winding.number - n_with_equals) +
                   " are missing. resonances.csv keeps those that were found. Give more "
                   "Resonances/Loads in a region, a smaller Tolerance or a narrower band; or set "
                   "Count = false to take them without a count.");
}

template class Resonances<2>;
template class Resonances<3>;
} // namespace Continua
