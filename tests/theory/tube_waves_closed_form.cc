// The closed formulas against scripts/references/waves/closed_form_theory.py, which finds the membrane's
// wave number by a root search at high precision and psi from Lame's cylinder.

#include <continua/theory/tube_waves_closed_form.h>

#include "../unit_test.h"

#include <stdexcept>

namespace test_of_tube_waves_closed_form
{
using namespace Continua;

namespace
{
void close(const std::string &name, const Complex value, const Complex reference)
{
  check::absolute(name, std::abs(value - reference) / std::abs(reference), 0., 1e-13);
}

ClosedFormTube make(const double radius, const double h, const double rho_s, const double nu)
{
  ClosedFormTube tube;
  tube.tube.inner_radius = radius;
  tube.tube.wall_thickness = h;
  tube.tube.poissons_ratio = nu;
  tube.tube.density = 998.;
  tube.tube.inverse_bulk_modulus = 1. / 2.2e9;
  tube.viscosity = 1e-3;
  tube.wall_density = rho_s;
  return tube;
}

void at(const std::string &name,
        const ClosedFormTube &tube,
        const Complex omega,
        const Complex modulus,
        const Complex inviscid,
        const Complex viscous,
        const Complex held,
        const Complex free)
{
  close(name + ", membrane", inviscid_membrane_wave_number(tube, omega, modulus), inviscid);
  close(name + ", viscous membrane", membrane_wave_number(tube, omega, modulus), viscous);
  close(name + ", closed formula, held",
        closed_form_wave_number(tube, omega, modulus, Anchoring::throughout), held);
  close(name + ", closed formula", closed_form_wave_number(tube, omega, modulus), free);
}
} // namespace

UNIT_TEST(tube_waves_closed_form)
{
  const double two_pi = 6.28318530717958648;
  const ClosedFormTube a = make(0.0125, 1e-4, 880., 0.49);
  at("slow", a, 0.1, 1.72e6, 0.038086499413911094, {0.044361984133970451, -0.0097681357465378183},
     {0.038897027795532921, -0.0085647983303945636},
     {0.042220509403038286, -0.0044277773020405072});
  at("20 Hz", a, 20. * two_pi, 1.72e6, 48.983722941035997,
     {49.231144233986891, -0.2499431737549665}, {43.166355677245235, -0.21915265438738417},
     {49.319383661127807, -0.14210810966255938});
  at("200 Hz", a, 200. * two_pi, 1.72e6, 1679.0116534753185,
     {1681.6936397697005, -2.6905785406109412}, {1474.5256671151159, -2.3591259571293072},
     {1687.1982316205361, -1.5366023287523077});
  at("viscoelastic", a, Complex(20., -0.5) * two_pi, {1.72e6, 1.7e5},
     {48.715152812728221, -3.7925983844345136}, {48.945189100471604, -4.0574341347962243},
     {42.915628094431441, -3.5575898754075365}, {49.039849742418374, -3.9582510039777475});
  at("thick wall", make(5e-3, 1e-3, 1200., 0.3), 167. * two_pi, 3e5, 216.60677548660333,
     {217.55335915429573, -0.95492090503259753}, {226.84946747052229, -0.99572490916804385},
     {234.94587207275255, -0.74327570692790408});

  check::is_true("no frequency", closed_form_wave_number(a, 0., 1.72e6) == Complex(0.));
  // The ring frequency sqrt(1.72e6/880)/0.0125 = 3536.8 1/s.
  check::is_true("below the ring frequency",
                 inviscid_membrane_wave_number(a, 3536., 1.72e6).real() > 0.);
  check::throws<std::domain_error>(
      "above the ring frequency", [&a] { membrane_wave_number(a, 3537., 1.72e6); }, "ring");
}
} // namespace test_of_tube_waves_closed_form
