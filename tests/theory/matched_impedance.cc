// The impedance of a tube that goes on, against closed forms of long waves: rho c/A of a wall held
// axially, a 2 x 2 matrix of an inviscid liquid in a membrane; what it resists is positive.

#include <continua/theory/matched_impedance.h>

#include "waves.h"

#include "../unit_test.h"

namespace test_of_matched_impedance
{
using namespace waves;

namespace
{
using Complex = std::complex<double>;
using Impedances = std::vector<dealii::FullMatrix<Complex>>;

const std::vector<double> frequencies = {0.5, 1., 2., 4., 8.};

/// Real and imaginary part of an entry are those of a resistance.
void close(const std::string &name,
           const Complex &value,
           const double reference,
           const double tolerance)
{
  check::absolute(name, std::abs(value / reference - 1.), 0., tolerance);
}

/// Inviscid liquid, wall held along its outside: rho c/A with Lame's psi for c. The wall's own end
/// does not matter to long waves.
void held()
{
  const double thickness = 1e-4, young = 8e6, radius = 0.01;
  TubeSection section = tube(radius, thickness, 1., young, 0.5, 1000., 1e-7);
  section.tethered = true;
  const double psi =
      thickness / radius * 1.5 + 2. * radius / (2. * radius + thickness) * (1. - 0.25);
  const double speed = std::sqrt(young * thickness / (2. * radius * 1000. * psi));
  const double reference = 1000. * speed / (pi * radius * radius);
  for (const auto &[name, end] :
       {std::make_pair("clamped", WallEnd::clamped), std::make_pair("free", WallEnd::free),
        std::make_pair("absorbing", WallEnd::absorbing)})
  {
    const Impedances impedances = matched_impedances(section, end, 1., frequencies);
    check::is_true(std::string("held wall, ") + name + " end: one port", impedances[0].m() == 1);
    close(std::string("held wall, ") + name + " end: rho c/A", impedances[1](0, 0), reference,
          5e-3);
  }
}

/// Long waves of an inviscid incompressible liquid in a membrane are dP/dz = -L dQ/dt,
/// dQ/dz = -C dP/dt with L = diag(rho/A, rho_s/A_w), C = 2 pi R^2/Y ((R/h, nu), (nu, h/R)). What
/// leaves has Z C Z = L.
void membrane()
{
  const double radius = 0.01, thickness = 1e-5, young = 60e6, nu = 0.45, density = 1000.,
               wall_density = 1100.;
  const TubeSection section = tube(radius, thickness, wall_density, young, nu, density, 0.);
  const double l1 = density / (pi * radius * radius),
               l2 = wall_density / (2. * pi * radius * thickness);
  const double factor = 2. * pi * radius * radius / young;
  // M = L^1/2 C L^1/2, its square root (M + d)/t with d = sqrt(det M) and t = sqrt(tr M + 2 d), and
  // Z = L^1/2 M^-1/2 L^1/2.
  const double m11 = l1 * factor * radius / thickness, m12 = std::sqrt(l1 * l2) * factor * nu,
               m22 = l2 * factor * thickness / radius;
  const double d = std::sqrt(m11 * m22 - m12 * m12), t = std::sqrt(m11 + m22 + 2. * d);
  const double r11 = (m11 + d) / t, r12 = m12 / t, r22 = (m22 + d) / t,
               determinant = r11 * r22 - r12 * r12;
  const Impedances impedances = matched_impedances(section, WallEnd::absorbing, 1., frequencies);
  check::is_true("membrane: two ports", impedances[1].m() == 2);
  close("membrane: Z_11", impedances[1](0, 0), l1 * r22 / determinant, 5e-3);
  close("membrane: Z_12", impedances[1](0, 1), -std::sqrt(l1 * l2) * r12 / determinant, 5e-3);
  close("membrane: Z_22", impedances[1](1, 1), l2 * r11 / determinant, 5e-3);

  // Without a port for the wall: the eigenvectors of M are the waves, (cos, sin) and (-sin, cos) of
  // an angle; scaled pressures are their speeds times the scaled flows, and the second wave comes
  // back so that the wall's flow (clamped) or pressure (free) is zero.
  const double angle = 0.5 * std::atan2(2. * m12, m11 - m22);
  const double cosine = std::pow(std::cos(angle), 2), sine = std::pow(std::sin(angle), 2);
  const double slow = 1. / std::sqrt(m11 * cosine + m12 * std::sin(2. * angle) + m22 * sine),
               fast = 1. / std::sqrt(m11 * sine - m12 * std::sin(2. * angle) + m22 * cosine);
  const Impedances free = matched_impedances(section, WallEnd::free, 1., frequencies);
  const Impedances clamped = matched_impedances(section, WallEnd::clamped, 1., frequencies);
  check::is_true("membrane, free end: one port", free[1].m() == 1);
  close("membrane, free end", free[1](0, 0), l1 * slow / (cosine - slow / fast * sine), 2e-3);
  close("membrane, clamped end", clamped[1](0, 0), l1 * (slow * cosine - fast * sine), 2e-3);
}

void passive(const std::string &name, const TubeSection &section)
{
  for (const WallEnd end : {WallEnd::clamped, WallEnd::free, WallEnd::absorbing})
  {
    bool positive = true;
    for (const dealii::FullMatrix<Complex> &z : matched_impedances(section, end, 1., frequencies))
    {
      positive = positive && z(0, 0).real() > 0.;
      if (z.m() > 1)
        positive = positive && z(1, 1).real() > 0. &&
                   z(0, 0).real() * z(1, 1).real() > z(0, 1).real() * z(0, 1).real();
    }
    check::is_true(name + ": resists", positive);
  }
}
} // namespace

UNIT_TEST(matched_impedance)
{
  held();
  membrane();
  TubeSection section = tube(12.5e-3, 0.1e-3, 880., 1.72e6, 0.49, 998., 1e-3);
  passive("tube A", section);
  section.layers[0] = Material();
  section.layers[0].density = 880.;
  section.layers[0].shear.power_law = PowerLaw{1.3e6, 0.065, {}, {}};
  passive("tube A, viscoelastic", section);
  // A rigid tube has the liquid's own speed.
  TubeSection rigid;
  rigid.inner_radius = 0.01;
  rigid.fluid.density = 1000.;
  rigid.fluid.shear.viscosity = 1e-9;
  rigid.fluid.compression = Compression::elastic(1. / 2.25e9);
  close("rigid wall: sqrt(rho K)/A",
        matched_impedances(rigid, WallEnd::absorbing, 1., frequencies)[1](0, 0),
        std::sqrt(1000. * 2.25e9) / (pi * 1e-4), 1e-3);
}
} // namespace test_of_matched_impedance
