// Profiles that were measured: their shape over the mean, and tables that do not cover a section.

#include "../unit_test.h"

#include <continua/base/input_error.h>
#include <continua/boundary/profile_table.h>

#include <fstream>

namespace test_of_profile_table
{
using namespace Continua;

namespace
{
const std::string profile_path = "profile-table-test.csv";

ProfileTable profile(const std::string &content,
                     const Interpolant::Kind kind = Interpolant::Kind::linear,
                     const std::string &column = "")
{
  std::ofstream(profile_path, std::ios::binary) << content;
  return ProfileTable(profile_path, kind, column);
}

void refused(const std::string &name,
             const std::string &content,
             const std::string &pattern,
             const double radius,
             const bool is_channel)
{
  check::throws<InputError>(
      name, [&]() { profile(content).check(radius, is_channel); }, pattern);
}
} // namespace

UNIT_TEST(profile_table)
{
  // A cone: its mean over the disc is a third of its height, over the gap a half.
  const std::string cone = "r [mm], U [cm/s]\n0, 12\n10, 0\n";
  const ProfileTable table = profile(cone);
  table.check(0.01, false);
  check::relative("cone: centre", table.shape(0., 0.01, false), 3., 1e-14);
  check::relative("cone: half-way", table.shape(0.005, 0.01, false), 1.5, 1e-14);
  check::relative("cone: in a channel", table.shape(-0.005, 0.01, true), 1., 1e-14);
  // Of a smaller section: (1 - r/2) over 2 (1/2 - 1/6).
  check::relative("cone: up to half of it", table.shape(0., 0.005, false), 1.5, 1e-14);
  // The cubic is exact for what is straight.
  check::relative("cubic",
                  profile("r [mm], U [cm/s]\n0, 12\n3, 8.4\n10, 0\n", Interpolant::Kind::cubic)
                      .shape(0.005, 0.01, false),
                  1.5, 1e-13);
  check::relative(
      "chosen column",
      profile("r [mm], U [cm/s], V [m/s]\n0, 12, 1\n10, 0, 1\n", Interpolant::Kind::linear, "V")
          .shape(0.005, 0.01, false),
      1., 1e-14);
  // From one wall of a channel to the other, with all of the flow on one side.
  const ProfileTable shear = profile("y [mm], U [m/s]\n-10, 0\n10, 4\n");
  shear.check(0.01, true);
  check::relative("two sides", shear.shape(0.005, 0.01, true), 1.5, 1e-14);
  check::relative("the other side", shear.shape(-0.005, 0.01, true), 0.5, 1e-14);

  refused("too short", cone, "profile-table-test.csv:3: .*ends at 10 mm.*radius 12 mm.*wall", 0.012,
          false);
  refused("too short for a gap", cone, ":3: .*half of the gap is 12 mm", 0.012, true);
  refused("without a centre", "r [mm], U [m/s]\n2, 1\n10, 0\n",
          ":2: .*begins at 2 mm.*from the centre", 0.01, false);
  refused("without the other wall", "r [mm], U [m/s]\n-5, 1\n10, 0\n",
          ":2: .*begins at -5 mm.*other wall", 0.01, true);
  refused("negative radius", "r [mm], U [m/s]\n-10, 0\n10, 4\n", ":2: .*is negative", 0.01, false);
  refused("no flow", "r [mm], U [m/s]\n-10, -2\n10, 2\n", ":3: .*nothing through", 0.01, true);
  check::throws<InputError>(
      "no columns", [] { profile("r [mm]\n0\n1\n"); }, ":1: .*one column");
  check::throws<InputError>(
      "two columns", [] { profile("r [mm], U [m/s], V [m/s]\n0,1,1\n1,0,0\n"); },
      ":1: .*several columns: 'U', 'V'.*'Profile column'");
  check::throws<InputError>(
      "wrong unit", [] { profile("r [mm], U [mm]\n0,1\n1,0\n"); }, ":1: ");
  check::throws<InputError>(
      "back again", [] { profile("r [mm], U [m/s]\n1,1\n0,0\n"); }, ":3: .*distance.*not larger");
}
} // namespace test_of_profile_table
