#include <continua/base/interruption.h>
#include <continua/base/misfit.h>
#include <continua/base/unit_scale.h>
#include <continua/laboratory/laboratory_tests.h>
#include <continua/materials/relaxation_test.h>
#include <continua/postprocess/writing_rank.h>

#include <deal.II/base/numbers.h>

#include <gsl/gsl_multifit.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Continua
{
using dealii::numbers::PI;

namespace
{
std::string harmonic_name(const double frequency)
{
  return "harmonic at " + named_value(frequency, "Hz");
}

/// How far simulated and exact values are apart: the largest difference over the largest exact
/// value.
class Difference
{
public:
  void add(const double simulated, const double exact)
  {
    largest = std::max(largest, std::abs(simulated - exact));
    scale = std::max(scale, std::abs(exact));
  }
  double value() const { return largest / scale; }

private:
  double largest = 0., scale = 0.;
};

/// Least-squares fit of a sine and a cosine, with a constant and a drift for what has not died
/// away.
class SineFit
{
public:
  SineFit(const std::vector<double> &times, const double omega)
      : n(times.size()),
        matrix(gsl_matrix_alloc(n, 4)),
        covariance(gsl_matrix_alloc(4, 4)),
        values(gsl_vector_alloc(n)),
        result(gsl_vector_alloc(4)),
        work(gsl_multifit_linear_alloc(n, 4))
  {
    const double middle = 0.5 * (times.front() + times.back());
    for (std::size_t i = 0; i < n; ++i)
    {
      const double row[4] = {std::sin(omega * times[i]), std::cos(omega * times[i]), 1.,
                             (times[i] - middle) * omega};
      for (unsigned int j = 0; j < 4; ++j)
        gsl_matrix_set(matrix, i, j, row[j]);
    }
  }
  ~SineFit()
  {
    gsl_matrix_free(matrix);
    gsl_matrix_free(covariance);
    gsl_vector_free(values);
    gsl_vector_free(result);
    gsl_multifit_linear_free(work);
  }
  SineFit(const SineFit &) = delete;
  SineFit &operator=(const SineFit &) = delete;

  /// S + i C of S sin + C cos, the amplitude in exp(i omega t).
  std::complex<double> amplitude(const std::vector<double> &signal)
  {
    for (std::size_t i = 0; i < n; ++i)
      gsl_vector_set(values, i, signal[i]);
    double sum_of_squares = 0.;
    gsl_multifit_linear(matrix, values, result, covariance, &sum_of_squares, work);
    const std::complex<double> found = {gsl_vector_get(result, 0), gsl_vector_get(result, 1)};
    misfit = std::sqrt(sum_of_squares / n) / std::abs(found);
    return found;
  }

  double misfit = 0.; ///< of the last signal: root of the mean square, over the amplitude [1]

private:
  const std::size_t n;
  gsl_matrix *const matrix, *const covariance;
  gsl_vector *const values, *const result;
  gsl_multifit_linear_workspace *const work;
};

Expression in_time(const std::string &text)
{
  return Expression(text, Dimensions::none);
}
} // namespace

template <int dim>
LaboratoryTests<dim>::LaboratoryTests(const Material &material,
                                      const LaboratoryParameters &parameters,
                                      const TimeParameters &time,
                                      const OutputDirectory &directory,
                                      const MPI_Comm communicator,
                                      Log &log,
                                      Summary &summary)
    : material(material),
      parameters(parameters),
      time(time),
      directory(directory),
      communicator(communicator),
      is_writer(is_writing_rank(communicator)),
      log(log),
      summary(summary),
      response(material),
      law(material.has_power_law() ? PowerLawResponse{material.shear.power_law->modulus,
                                                      material.shear.power_law->exponent}
                                   : PowerLawResponse()),
      is_power_law(material.has_power_law())
{
}

template <int dim>
std::unique_ptr<TableWriter>
LaboratoryTests<dim>::table(const std::string &file, const std::vector<std::string> &header) const
{
  return is_writer ? std::make_unique<TableWriter>(file, header) : nullptr;
}

template <int dim>
void LaboratoryTests<dim>::stop_if_asked(const std::string &where) const
{
  SignalWatch::stop_if_asked(communicator, where + "; the tests begin anew, with --overwrite");
}

template <int dim>
void LaboratoryTests<dim>::relaxation()
{
  const double loading_time = parameters.loading_time;
  log.line("Relaxation: strain " + shortest_number(parameters.strain) + " loaded within " +
           shortest_number(loading_time) + " s, for " + shortest_number(time.end_time) + " s");
  Specimen specimen(material, Specimen::Control::strain_rate,
                    // The end of the loading is its last step's.
                    in_time("if(t <= " + shortest_number(loading_time * (1. + 1e-9)) + ", " +
                            shortest_number(parameters.strain / loading_time) + ", 0)"),
                    time, log);
  std::vector<std::string> header = {"time [s]", "strain [1]", "stress [Pa]",
                                     "stress of the closed solution [Pa]"};
  if (is_power_law)
    header.push_back("stress of the power law [Pa]");
  const auto rows = table(directory.file("relaxation.csv"), header);
  Difference from_branches, from_law;
  double largest = 0., last = 0.;
  RelaxationTest test_table;
  test_table.loading_time = loading_time;
  while (!specimen.at_end())
  {
    const Sample sample = specimen.advance();
    stop_if_asked("in the relaxation test");
    const double exact = response.ramp_stress(parameters.strain, loading_time, sample.time);
    std::vector<double> row = {sample.time, sample.strain, sample.stress, exact};
    from_branches.add(sample.stress, exact);
    if (is_power_law)
    {
      row.push_back(law.ramp_stress(parameters.strain, loading_time, sample.time));
      from_law.add(sample.stress, row.back());
    }
    largest = std::max(largest, sample.stress);
    last = sample.stress;
    if (sample.time >= loading_times_left_out * loading_time)
    {
      test_table.times.push_back(sample.time);
      test_table.moduli.push_back(sample.stress / parameters.strain);
    }
    if (rows)
      rows->row(row);
  }
  if (rows)
    rows->flush();
  const std::string test = "relaxation";
  summary.add({"largest stress", largest, "Pa", test});
  summary.add({"final stress", last, "Pa", test});
  summary.add({"largest difference from the closed solution", from_branches.value(), "1", test});
  if (!is_power_law)
    return;
  summary.add({"largest difference from the power law", from_law.value(), "1", test});
  // As c and n would be found from a measured table.
  if (test_table.times.size() >= 3)
  {
    const RelaxationFit fit = fit_relaxation_test(test_table);
    summary.add({"c", fit.modulus, "Pa", test});
    summary.add({"n", fit.exponent, "1", test});
  }
}

template <int dim>
void LaboratoryTests<dim>::creep()
{
  const double stress = parameters.stress;
  log.line("Creep: stress " + shortest_number(stress) + " Pa, for " +
           shortest_number(time.end_time) + " s");
  Specimen specimen(material, Specimen::Control::stress, Expression(stress), time, log);
  std::vector<std::string> header = {"time [s]", "stress [Pa]", "strain [1]",
                                     "strain of the closed solution [1]"};
  if (is_power_law)
    header.push_back("strain of the power law [1]");
  const auto rows = table(directory.file("creep.csv"), header);
  Difference from_branches, from_law;
  double last = 0.;
  while (!specimen.at_end())
  {
    const Sample sample = specimen.advance();
    stop_if_asked("in the creep test");
    const double exact = response.step_strain(stress, sample.time);
    std::vector<double> row = {sample.time, sample.stress, sample.strain, exact};
    from_branches.add(sample.strain, exact);
    if (is_power_law)
    {
      row.push_back(law.step_strain(stress, sample.time));
      from_law.add(sample.strain, row.back());
    }
    last = sample.strain;
    if (rows)
      rows->row(row);
  }
  if (rows)
    rows->flush();
  const std::string test = "creep";
  summary.add({"final strain", last, "1", test});
  summary.add({"largest difference from the closed solution", from_branches.value(), "1", test});
  if (is_power_law)
    summary.add({"largest difference from the power law", from_law.value(), "1", test});
}

template <int dim>
void LaboratoryTests<dim>::harmonic()
{
  const auto rows =
      table(directory.file("harmonic.csv"),
            {"frequency [Hz]", "storage modulus [Pa]", "loss modulus [Pa]", "tan delta [1]",
             "storage modulus of the law [Pa]", "loss modulus of the law [Pa]",
             "tan delta of the law [1]", "difference from the closed solution [1]", "periods [1]"});
  for (unsigned int i = 0; i < parameters.frequencies.size(); ++i)
  {
    std::vector<double> row;
    harmonic_test(parameters.frequencies[i], i + 1, row);
    if (rows)
      rows->row(row);
  }
  if (rows)
    rows->flush();
}

template <int dim>
void LaboratoryTests<dim>::harmonic_test(const double frequency,
                                         const unsigned int number,
                                         std::vector<double> &row)
{
  const double omega = 2. * PI * frequency, amplitude = parameters.strain;
  const unsigned int n_steps = parameters.steps_per_period;
  log.line("Harmonic test: strain " + shortest_number(amplitude) + " at " +
           named_value(frequency, "Hz"));
  TimeParameters steps = time;
  steps.time_step = 1. / (frequency * n_steps);
  steps.end_time = parameters.n_periods / frequency;
  steps.changes.clear();
  steps.jump_times.clear();
  Specimen specimen(
      material, Specimen::Control::strain_rate,
      in_time(shortest_number(amplitude * omega) + "*cos(" + shortest_number(omega) + "*t)"), steps,
      log);

  const auto rows =
      table(is_writer ? directory.file_of_case("harmonic-" + std::to_string(number) + ".csv") : "",
            {"time [s]", "strain [1]", "stress [Pa]", "stress of the closed solution [Pa]"});
  Difference from_branches;
  std::complex<double> modulus = 0.;
  double change = 1., misfit = 0.;
  unsigned int n_periods = 0;
  constexpr double periodic = 1e-7;
  while (!specimen.at_end() && change > periodic)
  {
    std::vector<double> times, strains, stresses;
    for (unsigned int i = 0; i < n_steps; ++i)
    {
      const Sample sample = specimen.advance();
      const double exact = response.sine_stress(amplitude, omega, sample.time);
      from_branches.add(sample.stress, exact);
      if (rows)
        rows->row({sample.time, sample.strain, sample.stress, exact});
      times.push_back(sample.time);
      strains.push_back(sample.strain);
      stresses.push_back(sample.stress);
    }
    ++n_periods;
    stop_if_asked("in the harmonic test at " + named_value(frequency, "Hz"));
    SineFit fit(times, omega);
    const std::complex<double> of_stress = fit.amplitude(stresses);
    misfit = fit.misfit;
    const std::complex<double> of_period = of_stress / fit.amplitude(strains);
    change = std::abs(of_period - modulus) / std::abs(of_period);
    modulus = of_period;
  }
  if (rows)
    rows->flush();

  const std::string test = harmonic_name(frequency);
  if (change > periodic)
  {
    std::ostringstream text;
    text << test << ": in the last of " << n_periods << " periods the modulus still changed by "
         << change << " of itself";
    log.warning(text.str());
  }
  if (const std::string warning = misfit_warning(test + ": the sine of the stress", misfit,
                                                 "root of the mean square, of its amplitude",
                                                 "Give more 'Periods', or more 'Steps per period'");
      !warning.empty())
    log.warning(warning);
  summary.add({"misfit of the sine", misfit, "1", test});
  const std::complex<double> exact = material.complex_young_modulus(omega);
  const double difference = std::abs(modulus / response.modulus(omega) - 1.);
  summary.add({"storage modulus", modulus.real(), "Pa", test});
  summary.add({"loss modulus", modulus.imag(), "Pa", test});
  summary.add({"tan delta", modulus.imag() / modulus.real(), "1", test});
  summary.add({"storage modulus of the law", exact.real(), "Pa", test});
  summary.add({"loss modulus of the law", exact.imag(), "Pa", test});
  summary.add({"tan delta of the law", exact.imag() / exact.real(), "1", test});
  summary.add({"difference of the modulus from the closed solution", difference, "1", test});
  summary.add({"largest difference from the closed solution", from_branches.value(), "1", test});
  if (is_power_law)
    summary.add({"difference of the modulus from the power law", std::abs(modulus / exact - 1.),
                 "1", test});
  summary.add({"periods", static_cast<double>(n_periods), "1", test});
  row = {frequency,
         modulus.real(),
         modulus.imag(),
         modulus.imag() / modulus.real(),
         exact.real(),
         exact.imag(),
         exact.imag() / exact.real(),
         difference,
         static_cast<double>(n_periods)};
}

template <int dim>
void LaboratoryTests<dim>::name_quantities(const LaboratoryParameters &parameters,
                                           const bool is_power_law,
                                           QuantityNames &names)
{
  const std::string from_solution = "largest difference from the closed solution",
                    from_law = "largest difference from the power law";
  const auto add = [&names](const std::string &test, const std::vector<std::string> &quantities)
  {
    for (const std::string &name : quantities)
      names.add(name, test);
  };
  if (parameters.has("relaxation"))
  {
    add("relaxation", {"largest stress", "final stress", from_solution});
    if (is_power_law)
      add("relaxation", {from_law, "c", "n"});
  }
  if (parameters.has("creep"))
  {
    add("creep", {"final strain", from_solution});
    if (is_power_law)
      add("creep", {from_law});
  }
  if (parameters.has("harmonic"))
    for (const double frequency : parameters.frequencies)
    {
      const std::string test = harmonic_name(frequency);
      add(test, {"storage modulus", "loss modulus", "tan delta", "storage modulus of the law",
                 "loss modulus of the law", "tan delta of the law",
                 "difference of the modulus from the closed solution", from_solution,
                 "misfit of the sine", "periods"});
      if (is_power_law)
        add(test, {"difference of the modulus from the power law"});
    }
}

template class LaboratoryTests<2>;
template class LaboratoryTests<3>;
} // namespace Continua
