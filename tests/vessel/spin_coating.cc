#include <continua/base/parameter_file.h>
#include <continua/vessel/spin_coating.h>

#include "../unit_test.h"

#include <filesystem>
#include <fstream>

namespace test_of_spin_coating
{
using namespace Continua;

namespace
{
SpinCoating read(const std::string &entries)
{
  std::ofstream("spin-coating.prm") << "subsection Spin coating\n" << entries << "end\n";
  ParameterFile file("spin-coating.prm");
  const SpinCoating coating = SpinCoating::read(file.root().subsection("Spin coating"));
  file.refuse_unknown();
  return coating;
}
} // namespace

UNIT_TEST(spin_coating)
{
  const SpinCoating coating = read("set Concentration = 25 %\nset Flow rate = 6 ml/min\n");
  // Section A.2: 1600 counts of the trolley are 1 mm.
  check::relative("counts a millimetre",
                  coating.trolley_speed(0.02, 1e-4) / coating.trolley_velocity(0.02, 1e-4), 1.6e6,
                  1e-14);
  // 6 ml/min = 100 mm^3/s of solution are 25 mm^3/s of wall; a millimetre of A is 7.853982 mm^3.
  check::relative("trolley", coating.trolley_velocity(0.025, 1e-4), 25e-3 / 7.853982, 1e-7);
  // Equation A.11: 2000/4000 times 2.5 mm over 2 mm.
  check::relative("rod by the trolley's speed",
                  coating.rod_speed(0.025, 1e-4) / coating.trolley_speed(0.025, 1e-4), 0.625,
                  1e-14);
  // Once around for 2 mm.
  check::relative("rod", coating.rod_speed(0.025, 1e-4),
                  2000. * coating.trolley_velocity(0.025, 1e-4) / 2e-3, 1e-14);

  // The wall's volume is pi (D + h) h L, on the mean diameter if D is linear; a quarter of the
  // solution becomes wall.
  const double straight = M_PI * 0.0251 * 1e-4 * 0.446 / 0.25,
               tapered = M_PI * 0.0188 * 5e-5 * 0.446 / 0.25;
  check::relative("straight tube", coating.tapered_volume(0.025, 0.025, 1e-4, 1e-4, 0.446),
                  straight, 1e-11);
  check::relative("tapered tube", coating.tapered_volume(0.025, 0.0125, 5e-5, 5e-5, 0.446), tapered,
                  1e-11);
  check::relative("tube E", coating.table(TubeLaw::thesis('E')).back().volume, tapered, 1e-11);
  // C: h(x) = h* D/D*, the integral of pi D h is pi h* D^2 L log(2) / D(0), and of pi h^2
  // pi h*^2 D^2 L / (D*(0) D*(L)).
  const double c_wall =
      M_PI * 0.446 * (5e-5 * 0.025 * 0.025 / 0.0125 * std::log(2.) + 5e-5 * 5e-5 * 2.);
  check::relative("tube C", coating.table(TubeLaw::thesis('C')).back().volume, c_wall / 0.25, 1e-6);
  check::relative("duration", coating.duration(2e-7), 2., 1e-14);

  // The defaults give figure A.4, tube C: about 6800 to 3400 and 4200 to 2100 counts/s.
  const SpinCoating by_default = read("");
  const std::vector<SpinCoating::Row> rows = by_default.table(TubeLaw::thesis('C').stretched(0.03));
  check::is_true("rows", rows.size() == 447);
  check::relative("last position", rows.back().position, 0.446, 1e-14);
  check::relative("middle", rows[223].thickness, 0.2e-3 / 3., 1e-13);
  check::relative("trolley at the inlet", rows.front().trolley_speed, 6800., 0.01);
  check::relative("trolley at the outlet", rows.back().trolley_speed, 3400., 0.01);
  check::relative("rod at the inlet", rows.front().rod_speed, 4200., 0.02);
  check::relative("rod at the outlet", rows.back().rod_speed, 2100., 0.02);
  check::relative("volume so far", rows.back().volume, c_wall / 0.2, 1e-6);
  check::relative("time so far", rows.back().time, rows.back().volume / (5e-6 / 60.), 1e-14);
  check::absolute("nothing yet", rows.front().volume, 0., 0.);

  // 446 mm are 44 increments of at most 10 mm and a rest; the volume is that of finer rows.
  const std::vector<SpinCoating::Row> coarse =
      read("set Position increment = 10 mm\n").table(TubeLaw::thesis('C').stretched(0.03));
  check::is_true("rows of a larger increment", coarse.size() == 46);
  check::relative("their distance", coarse[1].position, 0.446 / 45., 1e-14);
  check::relative("their volume", coarse.back().volume, c_wall / 0.2, 1e-3);

  check::throws<InputError>(
      "concentration", [] { read("set Concentration = 25\n"); },
      "spin-coating.prm:2: 'Spin coating/Concentration'");
  check::throws<InputError>(
      "stripe", [] { read("set Stripe distance = 0\n"); }, "spin-coating.prm:2: .*Stripe distance");
  std::filesystem::remove("spin-coating.prm");
}
} // namespace test_of_spin_coating
