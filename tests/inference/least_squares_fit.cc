#include "../unit_test.h"
#include "function_model.h"

#include <continua/base/input_error.h>
#include <continua/inference/least_squares_fit.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace test_of_least_squares_fit
{
using namespace Continua;

namespace
{
using Values = std::vector<double>;

/// Of the Statistical Reference Datasets of the National Institute of Standards and Technology,
/// nonlinear regression (https://www.itl.nist.gov/div898/strd/nls/nls_main.shtml), with certified
/// values.
struct DataSet
{
  std::string name;
  Values x, y;
  std::vector<Values> starts;
  Values certified, certified_deviations;
  double certified_sum;
};

DataSet misra1a()
{
  return {"Misra1a",
          {77.6E0, 114.9E0, 141.1E0, 190.8E0, 239.9E0, 289.0E0, 332.8E0, 378.4E0, 434.8E0, 477.3E0,
           536.8E0, 593.1E0, 689.1E0, 760.0E0},
          {10.07E0, 14.73E0, 17.94E0, 23.93E0, 29.61E0, 35.18E0, 40.02E0, 44.82E0, 50.76E0, 55.05E0,
           61.01E0, 66.40E0, 75.47E0, 81.78E0},
          {{500., 0.0001}, {250., 0.0005}},
          {2.3894212918E+02, 5.5015643181E-04},
          {2.7070075241E+00, 7.2668688436E-06},
          1.2455138894E-01};
}

DataSet thurber()
{
  return {"Thurber",
          {-3.067E0, -2.981E0, -2.921E0, -2.912E0, -2.840E0, -2.797E0, -2.702E0, -2.699E0,
           -2.633E0, -2.481E0, -2.363E0, -2.322E0, -1.501E0, -1.460E0, -1.274E0, -1.212E0,
           -1.100E0, -1.046E0, -0.915E0, -0.714E0, -0.566E0, -0.545E0, -0.400E0, -0.309E0,
           -0.109E0, -0.103E0, 0.010E0,  0.119E0,  0.377E0,  0.790E0,  0.963E0,  1.006E0,
           1.115E0,  1.572E0,  1.841E0,  2.047E0,  2.200E0},
          {80.574E0,   84.248E0,   87.264E0,   87.195E0,   89.076E0,   89.608E0,   89.868E0,
           90.101E0,   92.405E0,   95.854E0,   100.696E0,  101.060E0,  401.672E0,  390.724E0,
           567.534E0,  635.316E0,  733.054E0,  759.087E0,  894.206E0,  990.785E0,  1090.109E0,
           1080.914E0, 1122.643E0, 1178.351E0, 1260.531E0, 1273.514E0, 1288.339E0, 1327.543E0,
           1353.863E0, 1414.509E0, 1425.208E0, 1421.384E0, 1442.962E0, 1464.350E0, 1468.705E0,
           1447.894E0, 1457.628E0},
          {{1000., 1000., 400., 40., 0.7, 0.3, 0.03}, {1300., 1500., 500., 75., 1., 0.4, 0.05}},
          {1.2881396800E+03, 1.4910792535E+03, 5.8323836877E+02, 7.5416644291E+01, 9.6629502864E-01,
           3.9797285797E-01, 4.9727297349E-02},
          {4.6647963344E+00, 3.9571156086E+01, 2.8698696102E+01, 5.5675370270E+00, 3.1333340687E-02,
           1.4984928198E-02, 6.5842344623E-03},
          5.6427082397E+03};
}

DataSet mgh09()
{
  return {"MGH09",
          {4.000000E+00, 2.000000E+00, 1.000000E+00, 5.000000E-01, 2.500000E-01, 1.670000E-01,
           1.250000E-01, 1.000000E-01, 8.330000E-02, 7.140000E-02, 6.250000E-02},
          {1.957000E-01, 1.947000E-01, 1.735000E-01, 1.600000E-01, 8.440000E-02, 6.270000E-02,
           4.560000E-02, 3.420000E-02, 3.230000E-02, 2.350000E-02, 2.460000E-02},
          {{25., 39., 41.5, 39.}, {0.25, 0.39, 0.415, 0.39}},
          {1.9280693458E-01, 1.9128232873E-01, 1.2305650693E-01, 1.3606233068E-01},
          {1.1435312227E-02, 1.9633220911E-01, 8.0842031232E-02, 9.0025542308E-02},
          3.0750560385E-04};
}

DataSet lanczos3()
{
  return {"Lanczos3",
          {0.00000E+00, 5.00000E-02, 1.00000E-01, 1.50000E-01, 2.00000E-01, 2.50000E-01,
           3.00000E-01, 3.50000E-01, 4.00000E-01, 4.50000E-01, 5.00000E-01, 5.50000E-01,
           6.00000E-01, 6.50000E-01, 7.00000E-01, 7.50000E-01, 8.00000E-01, 8.50000E-01,
           9.00000E-01, 9.50000E-01, 1.00000E+00, 1.05000E+00, 1.10000E+00, 1.15000E+00},
          {2.5134E+00, 2.0443E+00, 1.6684E+00, 1.3664E+00, 1.1232E+00, 0.9269E+00,
           0.7679E+00, 0.6389E+00, 0.5338E+00, 0.4479E+00, 0.3776E+00, 0.3197E+00,
           0.2720E+00, 0.2325E+00, 0.1997E+00, 0.1723E+00, 0.1493E+00, 0.1301E+00,
           0.1138E+00, 0.1000E+00, 0.0883E+00, 0.0783E+00, 0.0698E+00, 0.0624E+00},
          {{1.2, 0.3, 5.6, 5.5, 6.5, 7.6}, {0.5, 0.7, 3.6, 4.2, 4., 6.3}},
          {8.6816414977E-02, 9.5498101505E-01, 8.4400777463E-01, 2.9515951832E+00, 1.5825685901E+00,
           4.9863565084E+00},
          {1.7197908859E-02, 9.7041624475E-02, 4.1488663282E-02, 1.0766312506E-01, 5.8371576281E-02,
           3.4436403035E-02},
          1.6117193594E-08};
}
double exponential_rise(const Values &b, const double x)
{
  return b[0] * (1. - std::exp(-b[1] * x));
}

double cubic_ratio(const Values &b, const double x)
{
  return (b[0] + x * (b[1] + x * (b[2] + x * b[3]))) / (1. + x * (b[4] + x * (b[5] + x * b[6])));
}

double kowalik_osborne(const Values &b, const double x)
{
  return b[0] * (x * x + x * b[1]) / (x * x + x * b[2] + b[3]);
}

double three_exponentials(const Values &b, const double x)
{
  return b[0] * std::exp(-b[1] * x) + b[2] * std::exp(-b[3] * x) + b[4] * std::exp(-b[5] * x);
}

FunctionModel model_of(const Values &x, double (*function)(const Values &, double))
{
  return FunctionModel(
      [x, function](const Values &set)
      {
        Values result;
        for (const double place : x)
          result.push_back(function(set, place));
        return result;
      });
}

DataRecord record_of(const Values &x, const Values &y, const double deviation)
{
  DataRecord record;
  record.name = "y";
  record.unit = "1";
  record.times = x;
  record.values = y;
  record.noise.standard_deviation = deviation;
  return record;
}

std::vector<FitParameter> parameters_of(const Values &start, const FitParameter::Scale scale)
{
  std::vector<FitParameter> parameters;
  for (std::size_t j = 0; j < start.size(); ++j)
  {
    FitParameter parameter;
    parameter.name = "b" + std::to_string(j + 1);
    parameter.unit = "1";
    parameter.start = start[j];
    parameter.scale = scale;
    parameters.push_back(parameter);
  }
  return parameters;
}

FitOptions tight_options()
{
  FitOptions options;
  options.tolerance = 1e-9;
  options.difference_step = 1e-5;
  return options;
}

void compare(const DataSet &data,
             double (*function)(const Values &, double),
             const FitOptions &options,
             const FitParameter::Scale scale,
             const std::string &name)
{
  for (std::size_t s = 0; s < data.starts.size(); ++s)
  {
    FunctionModel model = model_of(data.x, function);
    LeastSquaresFit fit(parameters_of(data.starts[s], scale),
                        {record_of(data.x, data.y, undefined)}, model, options);
    const FitResult result = fit.solve();
    const std::string start = data.name + name + ", start " + std::to_string(s + 1) + ": ";
    check::is_true(start + "converged", result.converged);
    double of_estimates = 0.;
    double of_errors = 0.;
    for (std::size_t j = 0; j < data.certified.size(); ++j)
    {
      of_estimates = std::max(of_estimates, std::abs(result.estimates[j] / data.certified[j] - 1.));
      of_errors = std::max(of_errors,
                           std::abs(result.standard_errors[j] / data.certified_deviations[j] - 1.));
    }
    check::absolute(start + "estimates", of_estimates, 0., 1e-6);
    check::absolute(start + "standard deviations", of_errors, 0., 1e-5);
    double sum = 0.;
    for (const double residual : result.records[0].residuals)
      sum += residual * residual;
    check::relative(start + "sum of squares", sum, data.certified_sum, 1e-9);
    check::relative(start + "noise", result.records[0].noise.standard_deviation,
                    std::sqrt(data.certified_sum / (data.x.size() - data.certified.size())), 1e-8);
  }
}

void test_reference_data()
{
  const auto linear = FitParameter::Scale::linear;
  const auto logarithmic = FitParameter::Scale::logarithmic;
  compare(misra1a(), exponential_rise, tight_options(), linear, "");
  compare(misra1a(), exponential_rise, tight_options(), logarithmic, ", logarithmic");
  compare(thurber(), cubic_ratio, tight_options(), linear, "");
  compare(mgh09(), kowalik_osborne, tight_options(), logarithmic, ", logarithmic");
  compare(lanczos3(), three_exponentials, tight_options(), logarithmic, ", logarithmic");
  FitOptions options = tight_options();
  options.trust_region = TrustRegion::dogleg;
  compare(misra1a(), exponential_rise, options, linear, ", dogleg");
  options.trust_region = TrustRegion::levenberg_marquardt;
  compare(misra1a(), exponential_rise, options, linear, ", Levenberg-Marquardt");
}

/// y = a + b x, whose errors are known in closed form.
void test_straight_line()
{
  const Values x{0., 1., 2., 3., 4.};
  const Values y{1.1, 2.9, 5.2, 7.1, 8.7};
  FunctionModel model =
      model_of(x, [](const Values &b, const double at) { return b[0] + b[1] * at; });
  const auto parameters = parameters_of({1., 1.}, FitParameter::Scale::linear);
  const FitResult result =
      LeastSquaresFit(parameters, {record_of(x, y, 0.3)}, model, tight_options()).solve();
  // Slope Sxy/Sxx = 19.4/10, intercept 5 - 2 * 1.94.
  check::relative("slope", result.estimates[1], 1.94, 1e-9);
  check::relative("intercept", result.estimates[0], 1.12, 1e-9);
  check::relative("error of the slope", result.standard_errors[1], 0.3 / std::sqrt(10.), 1e-9);
  check::relative("error of the intercept", result.standard_errors[0],
                  0.3 * std::sqrt(1. / 5. + 4. / 10.), 1e-9);
  check::relative("correlation", result.correlation(0, 1), -2. / std::sqrt(6.), 1e-9);
  check::relative("normal interval", result.intervals[1].upper,
                  1.94 + 1.959963984540054 * 0.3 / std::sqrt(10.), 1e-9);
  // Squares of the residuals: sum 0.124. Chi-square with 3 degrees of freedom:
  // Q = erfc(sqrt(x/2)) + sqrt(2 x/pi) exp(-x/2).
  const double chi = 0.124 / 0.09;
  check::relative("chi-square", result.misfit, chi, 1e-8);
  check::relative("probability of the misfit", result.probability_of_misfit,
                  std::erfc(std::sqrt(chi / 2.)) + std::sqrt(2. * chi / M_PI) * std::exp(-chi / 2.),
                  1e-8);

  const FitResult unknown =
      LeastSquaresFit(parameters, {record_of(x, y, undefined)}, model, tight_options()).solve();
  check::relative("estimated noise", unknown.records[0].noise.standard_deviation,
                  std::sqrt(0.124 / 3.), 1e-6);
  check::relative("Student's interval", unknown.intervals[1].lower,
                  1.94 - 3.182446305284263 * std::sqrt(0.124 / 3. / 10.), 1e-6);
  check::is_true("no probability of an estimated noise", std::isnan(unknown.probability_of_misfit));

  // A prior of the slope is one more measurement of it: weights 10/0.09 and 1/0.04.
  auto with_prior = parameters;
  with_prior[1].prior = Prior{2.4, 0.2};
  with_prior[0].start = with_prior[0].lower = with_prior[0].upper = 1.12;
  const FitResult held =
      LeastSquaresFit(with_prior, {record_of(x, y, 0.3)}, model, tight_options()).solve();
  // With the intercept held: sum x^2 = 30, sum x (y - 1.12) = 58.2.
  const double weight = 30. / 0.09;
  check::relative("prior", held.estimates[1], (58.2 / 0.09 + 2.4 / 0.04) / (weight + 25.), 1e-9);
  check::relative("error with a prior", held.standard_errors[1], 1. / std::sqrt(weight + 25.),
                  1e-9);
  check::is_true("a held parameter has no error",
                 std::isnan(held.standard_errors[0]) && held.intervals[0].lower == 1.12);
}

void test_starts_and_replay()
{
  // sin(b x) with many minima: the start 3.5 leads to a wrong one, others within the bounds to 1.3.
  Values x, y;
  for (int i = 0; i < 60; ++i)
  {
    x.push_back(0.1 * i);
    y.push_back(std::sin(1.3 * x.back()) + 0.01 * (i % 3 - 1));
  }
  FunctionModel model =
      model_of(x, [](const Values &b, const double at) { return std::sin(b[0] * at); });
  auto parameters = parameters_of({3.5}, FitParameter::Scale::linear);
  parameters[0].lower = 0.1;
  parameters[0].upper = 4.;
  FitOptions options;
  std::vector<Evaluation> made;
  options.observer = [&](const Evaluation &evaluation) { made.push_back(evaluation); };
  const FitResult one =
      LeastSquaresFit(parameters, {record_of(x, y, 0.01)}, model, options).solve();
  check::is_true("another minimum", std::abs(one.estimates[0] - 1.3) > 0.5);
  options.n_starts = 8;
  made.clear();
  const FitResult many =
      LeastSquaresFit(parameters, {record_of(x, y, 0.01)}, model, options).solve();
  check::absolute("several starts", many.estimates[0], 1.3, 0.003);
  check::is_true("all starts are told", many.starts.size() == 8 && many.starts[0].start[0] == 3.5);
  check::is_true("observed evaluations", made.size() == many.n_evaluations);

  const unsigned int n_before = model.n_sets;
  options.known = made;
  const FitResult again =
      LeastSquaresFit(parameters, {record_of(x, y, 0.01)}, model, options).solve();
  check::is_true("a replay computes nothing", model.n_sets == n_before && again.n_evaluations == 0);
  check::is_true("a replay finds the same", again.estimates == many.estimates);

  options.known.resize(options.known.size() / 2);
  options.observer = {};
  LeastSquaresFit(parameters, {record_of(x, y, 0.01)}, model, options).solve();
  check::is_true("half a replay computes the other half",
                 model.n_sets - n_before == made.size() - options.known.size());
}

void test_refusals()
{
  const Values x{0., 1.};
  FunctionModel model =
      model_of(x, [](const Values &b, const double at) { return b[0] + b[1] * at; });
  auto parameters = parameters_of({1., 1.}, FitParameter::Scale::linear);
  check::throws<std::invalid_argument>(
      "no value left for the noise",
      [&]() {
        LeastSquaresFit(parameters, {record_of(x, {1., 2.}, undefined)}, model);
      },
      "2 values and priors cannot give 2 parameters and the noise");
  const FitResult exact =
      LeastSquaresFit(parameters, {record_of(x, {1., 3.}, 0.1)}, model, tight_options()).solve();
  check::relative("as many values as parameters", exact.estimates[1], 2., 1e-9);
  check::throws<std::invalid_argument>(
      "fewer values", [&]() { LeastSquaresFit(parameters, {record_of({0.}, {1.}, 1.)}, model); },
      "1 values and priors cannot give 2");
  for (FitParameter &parameter : parameters)
    parameter.lower = parameter.upper = parameter.start;
  check::throws<std::invalid_argument>(
      "all held",
      [&]() {
        LeastSquaresFit(parameters, {record_of(x, {1., 2.}, 1.)}, model);
      },
      "no parameter to be found");
  FunctionModel failing([](const Values &) -> Values
                        { throw std::runtime_error("it is too hot"); });
  check::throws<RunError>(
      "a model that fails at the start",
      [&]()
      {
        LeastSquaresFit(parameters_of({1.}, FitParameter::Scale::linear),
                        {record_of(x, {1., 2.}, 1.)}, failing)
            .solve();
      },
      "fails at the start: it is too hot");
  // Half of the space is closed, and the way of Gauss and Newton leads there.
  for (const TrustRegion trust_region :
       {TrustRegion::levenberg_marquardt, TrustRegion::geodesic_acceleration, TrustRegion::dogleg})
  {
    FunctionModel half(
        [](const Values &b) -> Values
        {
          if (b[0] > 3.)
            throw std::runtime_error("beyond 3");
          return {std::atan(b[0]), 0.5 * std::atan(b[0])};
        });
    FitOptions options = tight_options();
    options.trust_region = trust_region;
    auto parameter = parameters_of({-40.}, FitParameter::Scale::linear);
    const FitResult found =
        LeastSquaresFit(parameter, {record_of(x, {std::atan(2.5), 0.5 * std::atan(2.5)}, 0.1)},
                        half, options)
            .solve();
    check::relative("failures refuse steps", found.estimates[0], 2.5, 1e-6);
    // The other two do not step so far.
    if (trust_region == TrustRegion::levenberg_marquardt)
      check::is_true("failures are told", found.n_failures > 0 && !found.notes.empty() &&
                                              check::matches(found.notes[0], "failed.*beyond 3"));
  }
}

/// The model has values on a line of its parameters only, so that it has no derivatives.
void test_without_derivatives()
{
  const Values x = {0., 1., 2.};
  FunctionModel line(
      [&x](const Values &b) -> Values
      {
        if (b[0] != b[1])
          throw std::runtime_error("beside the line");
        return x;
      });
  auto parameters = parameters_of({1., 1.}, FitParameter::Scale::linear);
  const FitResult found =
      LeastSquaresFit(parameters, {record_of(x, {0.1, 1., 2.}, 0.1)}, line, tight_options())
          .solve();
  check::is_true("it did not converge", !found.converged);
  check::is_true("there are free ones", found.free.size() == 2);
  check::is_true("no standard errors", std::isnan(found.standard_errors[0]));
  check::is_true("a correlation of their size",
                 found.correlation.m() == 2 && found.correlation.n() == 2 &&
                     std::isnan(found.correlation(0, 1)) && std::isnan(found.covariance(1, 1)));
  check::is_true("and a note", std::any_of(found.notes.begin(), found.notes.end(),
                                           [](const std::string &note)
                                           { return check::matches(note, "no standard errors"); }));
}
} // namespace

UNIT_TEST(least_squares_fit)
{
  test_without_derivatives();
  test_reference_data();
  test_straight_line();
  test_starts_and_replay();
  test_refusals();
}
} // namespace test_of_least_squares_fit
