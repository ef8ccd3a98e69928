// A layered wall as a membrane: averages of its layers by hand, over frequency where they relax.

#include <continua/theory/tube_section.h>

#include "../unit_test.h"

namespace test_of_tube_section
{
using namespace Continua;

namespace
{
Material solid(const double density, const double youngs_modulus, const double poissons_ratio)
{
  Material material;
  material.density = density;
  material.compression = Compression::elastic(3. * (1. - 2. * poissons_ratio) / youngs_modulus);
  Branch spring;
  spring.shear_modulus = 0.5 * youngs_modulus / (1. + poissons_ratio);
  material.shear.branches.push_back(spring);
  return material;
}
} // namespace

UNIT_TEST(tube_section)
{
  TubeSection section;
  section.layer_thicknesses = {1e-3, 3e-3};
  section.layers = {solid(1000., 1e6, 0.3), solid(1200., 2e6, 0.5)};
  const std::complex<double> omega = 100.;
  check::relative("thickness", section.wall_thickness(), 4e-3, 1e-14);
  // pi (14^2 - 10^2) mm^2
  check::relative("area of the wall", section.wall_area(), 96e-6 * 3.14159265358979323846, 1e-14);
  check::relative("density", section.wall_density(), 1150., 1e-14);
  check::relative("modulus", section.membrane_modulus(omega).real(), 1.75e6, 1e-12);
  // (0.3 * 1 + 0.5 * 2 * 3) / (1 + 2 * 3)
  check::relative("Poisson's ratio", section.poisson_ratio(omega).real(), 3.3 / 7., 1e-12);
  check::absolute("elastic: no loss", section.membrane_modulus(omega).imag(), 0., 1e-6);

  // An incompressible wall has Y = 3 mu: a spring that relaxes within 1/omega adds 3 mu (1 + i)/2.
  Branch branch;
  branch.shear_modulus = 1e5;
  branch.relaxation_time = 0.01;
  section.layer_thicknesses = {2e-3};
  section.layers = {solid(1200., 2e6, 0.5)};
  section.layers[0].shear.branches.push_back(branch);
  check::relative("storage modulus", section.membrane_modulus(omega).real(), 2.15e6, 1e-12);
  check::relative("loss modulus", section.membrane_modulus(omega).imag(), 1.5e5, 1e-12);
  check::relative("incompressible", section.poisson_ratio(omega).real(), 0.5, 1e-12);

  // Without a support hoop and membrane are one. With it, the traction of a section that widens by
  // u: E h u/R^2 of the membrane and k u (R + h)/R of the outer surface.
  check::relative("hoop alone", section.hoop_modulus(omega).real(), 2.15e6, 1e-12);
  TubeSection other = section;
  check::is_true("equal", section == other);
  const double radius = section.inner_radius, thickness = 2e-3;
  other.radial_stiffness = 3e7;
  other.radial_damping = 2e4;
  const auto traction = [&](const std::complex<double> &modulus)
  { return modulus * thickness / (radius * radius); };
  const std::complex<double> of_support =
      traction(other.hoop_modulus(omega)) - traction(other.membrane_modulus(omega));
  check::relative("hoop with a support", of_support.real(), 3e7 * (radius + thickness) / radius,
                  1e-9);
  check::relative("its damping", of_support.imag(), 2e6 * (radius + thickness) / radius, 1e-9);
  check::is_true("supported otherwise", !(section == other));
  // Held axially, Korteweg's formula divides the modulus by 1 - nu^2, which the support is free of.
  other.tethered = true;
  check::relative("held and supported",
                  (other.hoop_modulus(omega) - other.membrane_modulus(omega)).imag() / 0.75,
                  2e6 * radius * (radius + thickness) / thickness, 1e-6);
  other = section;
  other.layers[0].shear.branches[1].relaxation_time = 0.02;
  check::is_true("another relaxation", !(section == other));
  other = section;
  other.tethered = true;
  check::is_true("held otherwise", !(section == other));
  other = section;
  other.layer_thicknesses[0] = 1e-3;
  check::is_true("thinner", !(section == other));
  section.layers[0].compression = Compression::relaxing({BulkBranch{1e7, 0.01}});
  other = section;
  check::is_true("equal with bulk branches", section == other);
  other.layers[0].compression = Compression::relaxing({BulkBranch{1e7, 0.02}});
  check::is_true("another relaxation of the volume", !(section == other));
  other.layers[0].compression = Compression::elastic(1e-7);
  check::is_true("no relaxation of the volume", !(section == other));
}
} // namespace test_of_tube_section
