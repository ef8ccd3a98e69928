// Against scripts/references/waves/stream_waves.py, which has no Chebyshev points and no matrices, and
// against the formulas of a liquid at rest.

#include <continua/theory/stream_waves.h>
#include <continua/theory/womersley.h>

#include "../unit_test.h"

#include <cmath>
#include <stdexcept>

namespace test_of_stream_waves
{
using namespace Continua;

namespace
{
using Direction = StreamWaves::Direction;

/// With and against the stream on a mesh that stays, the same on a moving wall.
struct Which
{
  std::string name;
  Direction direction;
  StreamWall wall;
};
const Which all[] = {{"with, stays", Direction::with_stream, StreamWall::mesh_that_stays},
                     {"against, stays", Direction::against_stream, StreamWall::mesh_that_stays},
                     {"with, moving", Direction::with_stream, StreamWall::moving},
                     {"against, moving", Direction::against_stream, StreamWall::moving}};

Stream plug_of(const double velocity)
{
  return {velocity, StreamProfile::plug, 2.};
}

Stream power_law_of(const double velocity, const double exponent)
{
  return {velocity, StreamProfile::power_law, exponent};
}

void test_long_waves()
{
  const auto compare = [](const std::string &name, const Stream &stream,
                          const double distensibility, const double inverse_bulk_modulus,
                          const std::vector<double> &speeds)
  {
    const StreamWaves waves(stream, 0.01, 1000., 0., inverse_bulk_modulus);
    for (unsigned int i = 0; i < 4; ++i)
      check::relative(name + ", " + all[i].name,
                      waves.long_wave_speed(distensibility, all[i].direction, all[i].wall),
                      speeds[i], 1e-12);
  };
  compare("plug", plug_of(0.5), 4e-5, 0., {5.256246098625, -4.756246098625, 5.5, -4.5});
  compare("compressible plug", plug_of(0.5), 4e-5, 1e-5,
          {4.77660585712, -4.17660585712, 4.972135955, -3.972135955});
  compare("plug in a rigid tube", plug_of(10.), 0., 1e-7, {110., -90., 110., -90.});
  compare("Poiseuille", power_law_of(0.5, 2.), 4e-5, 0.,
          {5.52493781056, -4.52493781056, 5.52493781056, -4.52493781056});
  compare("exponent 7", power_law_of(0.5, 7.), 4e-5, 1e-5,
          {4.981967918213, -3.983326193389, 4.981967918213, -3.983326193389});
}

void test_viscous_waves()
{
  const auto compare = [](const std::string &name, const Stream &stream, const double viscosity,
                          const Complex distensibility, const double inverse_bulk_modulus,
                          const double frequency, const std::vector<Complex> &wave_numbers)
  {
    const StreamWaves waves(stream, 0.01, 1000., viscosity, inverse_bulk_modulus);
    for (unsigned int i = 0; i < 4; ++i)
    {
      const Complex k =
          waves.wave_number(2. * M_PI * frequency, distensibility, all[i].direction, all[i].wall);
      check::absolute(name + ", " + all[i].name, std::abs(k - wave_numbers[i]), 0.,
                      1e-10 * std::abs(k));
    }
  };
  compare("viscous Poiseuille", power_law_of(0.25, 2.), 4e-3, 4e-5, 0., 10.,
          {{12.15621015482, -0.211356043152},
           {-13.45771972063, 0.2545250112565},
           {12.13696489789, -0.1909897476871},
           {-13.4837067967, 0.2819088845761}});
  compare("viscous, exponent 8", power_law_of(0.5, 8.), 4e-3, 4e-5, 1e-5, 1.,
          {{1.337798551682, -0.08486060370812},
           {-1.654258895262, 0.09061344392494},
           {1.311636015483, -0.05132538330051},
           {-1.701566372315, 0.1438334931952}});
  compare("viscoelastic", power_law_of(0.5, 2.), 1e-3, {4e-5, -4e-6}, 0., 30.,
          {{34.31559498854, -1.700710043072},
           {-41.92541252749, 2.539243510666},
           {34.28939281553, -1.669145868766},
           {-41.97143110787, 2.598030135248}});
}

void test_at_rest()
{
  // Womersley's wave, at a small and at a large number of his.
  for (const double frequency : {0.1, 500.})
  {
    const double omega = 2. * M_PI * frequency;
    const Complex k = Womersley(0.01, 1000., 4e-3).wave_number(omega, 5.);
    const StreamWaves waves(power_law_of(0., 2.), 0.01, 1000., 4e-3, 0.);
    const Complex with =
        waves.wave_number(omega, 4e-5, Direction::with_stream, StreamWall::mesh_that_stays);
    const Complex against =
        waves.wave_number(omega, 4e-5, Direction::against_stream, StreamWall::moving);
    check::absolute("at rest, with", std::abs(with - k), 0., 1e-10 * std::abs(k));
    check::absolute("at rest, against", std::abs(against + k), 0., 1e-10 * std::abs(k));
  }
}

void test_refusals()
{
  check::throws<std::domain_error>(
      "a fast plug",
      []()
      {
        StreamWaves(plug_of(6.), 0.01, 1000., 0., 0.)
            .long_wave_speed(4e-5, Direction::against_stream, StreamWall::moving);
      },
      "no wave runs against it");
  check::relative(
      "a fast plug on a mesh that stays",
      StreamWaves(plug_of(6.), 0.01, 1000., 0., 0.)
          .long_wave_speed(4e-5, Direction::against_stream, StreamWall::mesh_that_stays),
      3. - std::sqrt(34.), 1e-12);
  check::throws<std::domain_error>(
      "no wave",
      []()
      {
        StreamWaves(plug_of(1.), 0.01, 1000., 0., 0.)
            .long_wave_speed(0., Direction::with_stream, StreamWall::moving);
      },
      "carries no wave");
  check::throws<std::invalid_argument>(
      "exponent", []() { StreamWaves(power_law_of(1., 1.), 0.01, 1000., 0., 0.); }, "2 or more");
  check::throws<std::invalid_argument>(
      "no viscosity",
      []()
      {
        StreamWaves(power_law_of(1., 2.), 0.01, 1000., 0., 0.)
            .wave_number(1., 4e-5, Direction::with_stream, StreamWall::moving);
      },
      "slips");
}
} // namespace

UNIT_TEST(stream_waves)
{
  test_long_waves();
  test_viscous_waves();
  test_at_rest();
  test_refusals();
}
} // namespace test_of_stream_waves
