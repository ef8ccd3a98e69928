// How good the closed formulas are: against the exact dispersion of a viscous compressible liquid
// in a thick elastic wall, in the ranges and within the bounds that their descriptions state.

#include <continua/theory/exact_dispersion.h>
#include <continua/theory/tube_waves_closed_form.h>

#include "../unit_test.h"

namespace test_of_closed_form_against_exact
{
using namespace Continua;

namespace
{
struct Tube
{
  std::string name;
  double radius, thickness, poissons_ratio, youngs_modulus, density;
  bool held;
};

TubeSection section_of(const Tube &tube)
{
  TubeSection section;
  section.inner_radius = tube.radius;
  section.tethered = tube.held;
  section.fluid.density = 998.;
  section.fluid.compression = Compression::elastic(1. / 2.2e9);
  section.fluid.shear.viscosity = 1e-3;
  Material wall;
  wall.density = tube.density;
  wall.compression =
      Compression::elastic(3. * (1. - 2. * tube.poissons_ratio) / tube.youngs_modulus);
  Branch spring;
  spring.shear_modulus = 0.5 * tube.youngs_modulus / (1. + tube.poissons_ratio);
  wall.shear.branches.push_back(spring);
  section.layer_thicknesses = {tube.thickness};
  section.layers = {wall};
  return section;
}

double speed_error(const Complex k, const Complex exact)
{
  return exact.real() / k.real() - 1.;
}
double attenuation_error(const Complex k, const Complex exact)
{
  return k.imag() / exact.imag() - 1.;
}
} // namespace

UNIT_TEST(closed_form_against_exact)
{
  const std::vector<Tube> tubes = {{"h/R 0.008", 0.0125, 1e-4, 0.49, 1.72e6, 880., false},
                                   {"h/R 0.008, held", 0.0125, 1e-4, 0.49, 1.72e6, 880., true},
                                   {"h/R 0.05", 0.01, 5e-4, 0.45, 1e6, 1000., false},
                                   {"h/R 0.1", 0.01, 1e-3, 0.45, 1e6, 1000., false},
                                   {"h/R 0.2", 5e-3, 1e-3, 0.3, 3e5, 1200., false}};
  for (const Tube &tube : tubes)
  {
    const ExactDispersion dispersion(section_of(tube));
    const ClosedFormTube closed_form{
        {tube.radius, tube.thickness, tube.poissons_ratio, 998., 1. / 2.2e9}, 1e-3, tube.density};
    const double membrane_bound = tube.thickness < 0.01 * tube.radius   ? 0.005
                                  : tube.thickness < 0.15 * tube.radius ? 0.06
                                                                        : 0.09;
    bool speeds = true, attenuations = true, membrane_speeds = true, membrane_attenuations = true;
    for (const double f : {2., 5., 10., 20.})
    {
      const Complex omega = 2. * M_PI * f;
      const Complex k =
          closed_form_wave_number(closed_form, omega, tube.youngs_modulus,
                                  tube.held ? Anchoring::throughout : Anchoring::expansion_joints);
      const Complex membrane = membrane_wave_number(closed_form, omega, tube.youngs_modulus);
      Complex exact;
      speeds = speeds && dispersion.find_root(omega, k, exact) &&
               std::abs(speed_error(k, exact)) < 0.006;
      attenuations =
          attenuations && attenuation_error(k, exact) > -0.13 && attenuation_error(k, exact) < 0.;
      membrane_speeds = membrane_speeds && std::abs(speed_error(membrane, exact)) < membrane_bound;
      membrane_attenuations = membrane_attenuations && attenuation_error(membrane, exact) > 0.15 &&
                              attenuation_error(membrane, exact) < 0.71;
    }
    check::is_true(tube.name + ", speed of the closed formula", speeds);
    check::is_true(tube.name + ", attenuation of the closed formula", attenuations);
    if (!tube.held)
    {
      check::is_true(tube.name + ", speed of the membrane", membrane_speeds);
      check::is_true(tube.name + ", attenuation of the membrane", membrane_attenuations);
    }
  }
}
} // namespace test_of_closed_form_against_exact
