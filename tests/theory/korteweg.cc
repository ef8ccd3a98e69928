// psi against Lame's cylinder solved for its constants by scripts/references/waves/closed_form_theory.py,
// and speeds computed there.

#include <continua/theory/korteweg.h>

#include "../unit_test.h"

namespace test_of_korteweg
{
using namespace Continua;

UNIT_TEST(korteweg)
{
  const Anchoring anchorings[] = {Anchoring::upstream, Anchoring::throughout,
                                  Anchoring::expansion_joints};
  const std::string names[] = {"upstream", "throughout", "expansion joints"};
  const double thick_tube[] = {1.0327272727272727, 1.0872727272727273, 1.1690909090909091};
  const double tube_a[] = {0.76391203187250996, 0.76879250996015936, 1.0079359362549801};
  const double steel_pipe[] = {1203.8244165007765, 1191.6186304746828, 1173.986669640456};
  const double thin[] = {0.755, 0.7599, 1.};
  LongWaveTube pipe;
  pipe.inner_radius = 0.25;
  pipe.wall_thickness = 0.01;
  pipe.poissons_ratio = 0.3;
  pipe.density = 1000.;
  pipe.inverse_bulk_modulus = 1. / 2.1e9;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const std::string name = names[i];
    const Anchoring anchoring = anchorings[i];
    check::relative(name + ", Lame",
                    anchoring_coefficient(anchoring, WallTheory::thick, 5e-3, 1e-3, 0.3),
                    thick_tube[i], 1e-14);
    check::relative(name + ", Lame, tube A",
                    anchoring_coefficient(anchoring, WallTheory::thick, 0.0125, 1e-4, 0.49),
                    tube_a[i], 1e-14);
    check::relative(name + ", thin wall",
                    anchoring_coefficient(anchoring, WallTheory::thin, 0.0125, 1e-4, 0.49), thin[i],
                    1e-14);
    check::absolute(name + ", thin limit",
                    anchoring_coefficient(anchoring, WallTheory::thick, 1., 1e-9, 0.49), thin[i],
                    2e-9);
    check::relative(name + ", steel pipe",
                    korteweg_speed(pipe, 2.07e11, anchoring, WallTheory::thick).real(),
                    steel_pipe[i], 1e-14);
  }
  // sqrt(2.1e9/1000).
  check::relative("sound", acoustic_speed(1000., 1. / 2.1e9), 1449.1376746189438, 1e-14);
  check::is_true("incompressible", std::isinf(acoustic_speed(1000., 0.)));
  check::relative("stiff wall: sound",
                  korteweg_speed(pipe, 1e30, Anchoring::throughout, WallTheory::thin).real(),
                  1449.1376746189438, 1e-12);

  // Y h / D = 0.04 MPa of the thesis's tube A: c = sqrt(0.04e6/998) = 6.3309 m/s (its 6.3).
  LongWaveTube tube;
  tube.inner_radius = 0.0125;
  tube.wall_thickness = 1e-4;
  tube.density = 998.;
  check::relative("Moens and Korteweg", moens_korteweg_speed(tube, 1e7).real(), 6.330889378329184,
                  1e-14);
  check::relative("Korteweg, thin, joints",
                  korteweg_speed(tube, 1e7, Anchoring::expansion_joints, WallTheory::thin).real(),
                  6.330889378329184, 1e-14);
  // sqrt(3 + 4i) = 2 + i.
  const Complex complex = moens_korteweg_speed(tube, {3e7, 4e7}) / 6.330889378329184;
  check::absolute("viscoelastic", std::abs(complex - Complex(2., 1.)), 0., 1e-13);
  check::absolute(
      "impedance",
      std::abs(characteristic_impedance(1000., {5., 1.}, 0.001) / 1e6 - Complex(5., 1.)), 0.,
      1e-14);
}
} // namespace test_of_korteweg
