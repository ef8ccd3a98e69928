// Profiles of a flow rate: their means, and the womersley one against Womersley's solution and
// against Szymanski's start of a constant flow.

#include "../unit_test.h"

#include <continua/boundary/flow_profile.h>

#include <fstream>
#include <memory>

namespace test_of_flow_profile
{
using namespace Continua;

namespace
{
/// Velocity over Q0/(pi R^2) of a profile of a tube of radius 2.
double relative_velocity(const FlowProfile &profile, const double radius, const double time)
{
  const std::vector<double> shapes = profile.shapes(radius);
  const std::vector<double> &amplitudes = profile.amplitudes(time);
  double velocity = 0.;
  for (std::size_t m = 0; m < shapes.size(); ++m)
    velocity += shapes[m] * amplitudes[m];
  return velocity * 4. * M_PI;
}

/// Midpoint rule; the first shape has the mean 1 over the disc, the others 0.
double largest_error_of_means(const FlowProfile &profile)
{
  constexpr unsigned int n = 4000;
  std::vector<double> means(profile.shapes(0.).size(), 0.);
  for (unsigned int i = 0; i < n; ++i)
  {
    const double radius = (i + 0.5) / n;
    const std::vector<double> shapes = profile.shapes(radius);
    for (std::size_t m = 0; m < means.size(); ++m)
      means[m] += 2. * radius * shapes[m] / n;
  }
  means[0] -= 1.;
  double largest = 0.;
  for (const double mean : means)
    largest = std::max(largest, std::abs(mean));
  return largest;
}

Waveform formula(const std::string &text)
{
  return Waveform(Expression(text, Dimensions::none));
}
/// Velocity over Q0/A of a profile of a channel whose gap is 4.
double channel_velocity(const FlowProfile &profile, const double place, const double time)
{
  return relative_velocity(profile, place, time) / M_PI;
}

const FlowProfile::Section gap = {2., 0.5, {{0., 1., 0.}}, true, {{0., 1., 0.}}};

/// Womersley numbers 2 and 10 of half the gap at y/h = 0, 0.5, 0.9, in phase and a quarter of a
/// period behind: mpmath of (cosh L - cosh(L y/h))/(cosh L - sinh(L)/L), L = i^(1/2) alpha.
constexpr double channel_numbers[2] = {2., 10.};
constexpr double channel_places[3] = {0., 0.5, 0.9};
constexpr double channel_references[2][3][2] = {
    {{1.479865979, 0.0959087179}, {1.130889483, -0.01743010915}, {0.2929527914, -0.05651846041}},
    {{1.068712855, 0.08002373563}, {1.097786164, 0.09559352271}, {0.6949184871, -0.2918127}}};

/// A flow that is periodic from t = 0 on, with three times a mean flow.
void channels()
{
  const FlowProfile parabolic(FlowProfile::Shape::parabolic, 3., gap);
  check::relative("channel: middle", channel_velocity(parabolic, 0., 5.), 4.5, 1e-14);
  check::relative("channel: half-way", channel_velocity(parabolic, -0.5, 5.), 3.375, 1e-14);
  check::relative("channel: half of its section", parabolic.area(), 2., 1e-14);
  check::relative("channel: place", parabolic.shapes_at({{7., 2., 0.}})[0], 1.125, 1e-14);
  for (unsigned int a = 0; a < 2; ++a)
  {
    const double omega = channel_numbers[a] * channel_numbers[a], period = 2. * M_PI / omega;
    const FlowProfile profile(FlowProfile::Shape::womersley,
                              formula("3 + cos(" + std::to_string(omega) + "*t)"), gap,
                              {4., period, period / 1000., FlowPast::periodic, period});
    double error = 0.;
    for (unsigned int place = 0; place < 3; ++place)
      for (const unsigned int quarter : {0, 1})
      {
        const double eta = channel_places[place];
        error = std::max(error,
                         std::abs(channel_velocity(profile, eta, 0.25 * quarter * period) -
                                  4.5 * (1. - eta * eta) - channel_references[a][place][quarter]));
      }
    check::absolute("channel: number " + std::to_string(static_cast<int>(channel_numbers[a])),
                    error, 0., 1e-4);
    // The mean over one side of the gap is that over both.
    double mean = 0.;
    constexpr unsigned int n = 4000;
    for (unsigned int i = 0; i < n; ++i)
      mean += channel_velocity(profile, (i + 0.5) / n, 0.3 * period) / n;
    check::relative("channel: mean", mean, 3. + std::cos(0.6 * M_PI), 1e-5);
  }
}

void pasts()
{
  // What a tube does that was at rest is forgotten after a while; what is periodic is there at
  // once.
  const double omega = 25., period = 2. * M_PI / omega;
  const Waveform flow = formula("2 + sin(25*t)");
  const FlowProfile at_rest(FlowProfile::Shape::womersley, flow, {2., 1.},
                            {4., 9. * period, period / 1000.});
  const FlowProfile periodic(FlowProfile::Shape::womersley, flow, {2., 1.},
                             {4., 9. * period, period / 1000., FlowPast::periodic, period});
  double error = 0., first = 0.;
  for (const double radius : {0., 0.4, 0.8, 0.97})
    for (const double phase : {0., 0.3, 0.7})
    {
      const double late = relative_velocity(at_rest, radius, (8. + phase) * period);
      error = std::max(error, std::abs(relative_velocity(periodic, radius, phase * period) - late));
      first = std::max(first, std::abs(relative_velocity(at_rest, radius, phase * period) - late));
    }
  check::absolute("periodic from the start", error, 0., 1e-8);
  check::is_true("which a start from rest is not", first > 0.5);
  const FlowProfile steady(FlowProfile::Shape::womersley, flow, {2., 1.},
                           {4., 1., 1e-3, FlowPast::steady, 0.});
  check::relative("steady before the start", relative_velocity(steady, 0.5, 0.), 3., 1e-14);
  const FlowProfile constant(FlowProfile::Shape::womersley, 2., {2., 1.},
                             {4., 1., 1e-3, FlowPast::steady, 0.});
  check::relative("steady for ever", relative_velocity(constant, 0.5, 0.7), 3., 1e-14);
  Waveform of_period = flow;
  of_period.set_period(period, 2. * period);
  const FlowProfile with_mean(FlowProfile::Shape::womersley, of_period, {2., 1.},
                              {4., 1., 1e-3, FlowPast::periodic, period});
  check::relative("mean over a period", relative_velocity(with_mean, 0.5, mean_over_period), 3.,
                  1e-10);
}
} // namespace

UNIT_TEST(flow_profile)
{
  const FlowProfile flat(FlowProfile::Shape::flat, formula("3*t"), {2., 0.25});
  check::relative("flat: inside", relative_velocity(flat, 0.99, 5.), 15., 1e-14);
  check::absolute("flat: rim", relative_velocity(flat, 1., 5.), 0., 0.);
  check::relative("section", flat.area(), M_PI, 1e-15);
  const FlowProfile elsewhere(FlowProfile::Shape::parabolic, 3., {2., 1., {{1., -1., 3.}}});
  check::relative("elsewhere", elsewhere.shapes_at({{1., 0., 3.}})[0], 1.5, 1e-14);
  check::is_true("flat: in time",
                 flat.depends_on_time() &&
                     !FlowProfile(FlowProfile::Shape::flat, 3., {1., 1.}).depends_on_time());
  const FlowProfile parabolic(FlowProfile::Shape::parabolic, 3., {2., 1.});
  check::relative("parabolic: axis", relative_velocity(parabolic, 0., 5.), 6., 1e-14);
  check::relative("parabolic: half-way", relative_velocity(parabolic, 0.5, 5.), 4.5, 1e-14);
  check::absolute("parabolic: mean", largest_error_of_means(parabolic), 0., 1e-6);

  // Womersley numbers 2, 10 and 140 at r/R = 0, 0.5, 0.9, 0.99, once the start has died out: the
  // parts in phase with the flow rate and a quarter of a period behind, mpmath of
  // (J0(L) - J0(L r/R))/(J0(L) - 2 J1(L)/L), L = i^(3/2) alpha.
  const double numbers[3] = {2., 10., 140.};
  const double radii[4] = {0., 0.5, 0.9, 0.99};
  const double references[3][4][2] = {{{1.97288582, 0.162369885},
                                       {1.4974299, 0.0309808077},
                                       {0.384801133, -0.0446302292},
                                       {0.0403418337, -0.00636323363}},
                                      {{1.1317762, 0.170127366},
                                       {1.17905197, 0.199337344},
                                       {0.747484731, -0.279960997},
                                       {0.0864843778, -0.0639713077}},
                                      {{1.01010055, 0.010255553},
                                       {1.01010055, 0.010255553},
                                       {1.01014784, 0.010280472},
                                       {0.80629973, -0.307221239}}};
  for (unsigned int a = 0; a < 3; ++a)
  {
    // Of kinematic viscosity 4 and radius 2 the viscous time R^2/nu is 1.
    const double omega = numbers[a] * numbers[a], period = 2. * M_PI / omega;
    const double start = std::ceil((numbers[a] > 100. ? 0.1 : 1.) / period) * period;
    const FlowProfile profile(FlowProfile::Shape::womersley,
                              formula("cos(" + std::to_string(omega) + "*t)*(1-exp(-(40*t)^2))"),
                              {2., 1.}, {4., start + period, std::min(1e-3, period / 200.)});
    double error = 0.;
    for (unsigned int r = 0; r < 4; ++r)
      for (const unsigned int quarter : {0, 1})
        error = std::max(
            error, std::abs(relative_velocity(profile, radii[r], start + 0.25 * quarter * period) -
                            references[a][r][quarter]));
    check::absolute("womersley: number " + std::to_string(static_cast<int>(numbers[a])), error, 0.,
                    1e-4);
    check::absolute("womersley: means", largest_error_of_means(profile), 0., 1e-5);
    check::absolute("womersley: rim", relative_velocity(profile, 1., 0.3), 0., 0.);
  }

  // A flow rate that is constant from t = 0 on: flat at first, at last a parabola.
  const FlowProfile started(FlowProfile::Shape::womersley, 1., {2., 1.}, {4., 2., 1e-3});
  check::relative("start: flat", relative_velocity(started, 0.5, 1e-5), 1., 0.02);
  check::relative("start: parabola", relative_velocity(started, 0.5, 2.), 1.5, 1e-9);
  check::relative("beyond the end", relative_velocity(started, 0.5, 2.5), 1.5, 1e-9);
  check::is_true("start: in time", started.depends_on_time());
  check::is_true(
      "no flow",
      !FlowProfile(FlowProfile::Shape::womersley, 0., {2., 1.}, {4., 2., 1e-3}).depends_on_time());
  // The same at a time asked for again, and between the rows of its table.
  const double between = relative_velocity(started, 0.3, 0.05035);
  relative_velocity(started, 0.3, 1.7);
  check::absolute("any order of times", relative_velocity(started, 0.3, 0.05035), between, 0.);
  check::relative(
      "between rows", between,
      0.5 * (relative_velocity(started, 0.3, 0.0503) + relative_velocity(started, 0.3, 0.0504)),
      1e-5);
  channels();
  pasts();

  // Of a table: a cone.
  std::ofstream("flow-profile-test.csv") << "r [m], U [m/s]\n0, 1\n2, 0\n";
  const auto cone =
      std::make_shared<const ProfileTable>("flow-profile-test.csv", Interpolant::Kind::linear, "");
  const FlowProfile measured(FlowProfile::Shape::table, 3., {2., 1.}, FlowHistory(), cone);
  check::relative("table", relative_velocity(measured, 0.5, 0.), 4.5, 1e-14);
  check::absolute("table: rim", relative_velocity(measured, 1., 0.), 0., 0.);
  check::absolute("table: mean", largest_error_of_means(measured), 0., 1e-6);
}
} // namespace test_of_flow_profile
