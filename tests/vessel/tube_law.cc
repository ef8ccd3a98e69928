#include <continua/base/parameter_file.h>
#include <continua/vessel/tube_law.h>

#include "../unit_test.h"

#include <filesystem>
#include <fstream>

namespace test_of_tube_law
{
using namespace Continua;

namespace
{
TubeLaw read(const std::string &entries)
{
  std::ofstream("tube-law.prm") << "subsection Geometry\n" << entries << "end\n";
  ParameterFile file("tube-law.prm");
  const TubeLaw law = TubeLaw::read(file.root().subsection("Geometry"));
  file.refuse_unknown();
  return law;
}

TubeLaw read_table(const std::string &content, const std::string &entries = "")
{
  std::ofstream("tube-law.csv") << content;
  return read("set Law = table\nset Table = tube-law.csv\n" + entries);
}

void refused(const std::string &name, const std::string &entries, const std::string &pattern)
{
  check::throws<InputError>(
      name, [&] { read(entries); }, "tube-law.prm:" + pattern);
}

void refused_table(const std::string &name, const std::string &content, const std::string &pattern)
{
  check::throws<InputError>(
      name, [&] { read_table(content); }, "tube-law.csv:" + pattern);
}

/// Ends and middle in mm, in the order D(0), D(L/2), D(L), h(0), h(L/2), h(L).
void tube(const std::string &name, const TubeLaw &law, const std::vector<double> &expected)
{
  double error = 0.;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const double z = 0.5 * i * law.length();
    error = std::max(error, std::abs(1e3 * law.inner_diameter(z) / expected[i] - 1.));
    error = std::max(error, std::abs(1e3 * law.wall_thickness(z) / expected[i + 3] - 1.));
  }
  check::absolute(name, error, 0., 1e-13);
}

void test_thesis()
{
  // Table A.3; in the middle D is 18.75 mm, h of C 0.05 * 25 / 18.75 and of F 0.1 * 18.75 / 25.
  tube("A", read("set Law = A\n"), {25., 25., 25., 0.1, 0.1, 0.1});
  tube("B", read("set Law = B\n"), {25., 25., 25., 0.05, 0.05, 0.05});
  tube("C", read("set Law = C\n"), {25., 25., 25., 0.05, 0.2 / 3., 0.1});
  tube("D", read("set Law = D\n"), {25., 18.75, 12.5, 0.1, 0.1, 0.1});
  tube("E", read("set Law = E\n"), {25., 18.75, 12.5, 0.05, 0.05, 0.05});
  tube("F", read("set Law = F\n"), {25., 18.75, 12.5, 0.1, 0.075, 0.05});
  std::string uniform;
  bool length = true;
  for (const char letter : std::string("ABCDEF"))
  {
    const TubeLaw law = TubeLaw::thesis(letter);
    uniform += law.is_uniform() ? law.name() : "";
    length &= law.length() == 0.446;
  }
  check::equal("uniform ones", uniform, "AB");
  check::is_true("446 mm", length);
  // C has E's, and F has A's h/D everywhere: the wave speeds of Moens and Korteweg are alike.
  const auto ratio = [](const char letter, const double z)
  {
    const TubeLaw law = TubeLaw::thesis(letter);
    return law.wall_thickness(z) / law.inner_diameter(z);
  };
  check::relative("C as E", ratio('C', 0.3), ratio('E', 0.3), 1e-14);
  check::relative("F as A", ratio('F', 0.3), ratio('A', 0.3), 1e-14);

  const TubeLaw aorta = read("set Law = aorta\nset Wall thickness = 2 mm\n");
  tube("aorta", aorta, {40., 31., 22., 2., 2., 2.});
  check::relative("length of the aorta", aorta.length(), 0.315, 1e-15);
  check::equal("name of the aorta", aorta.name(), "aorta");
}

void test_own()
{
  const TubeLaw uniform =
      read("set Inner diameter = 10 mm\nset Wall thickness = 1 mm\nset Length = 0.8 m\n");
  tube("uniform", uniform, {10., 10., 10., 1., 1., 1.});
  check::relative("length", uniform.length(), 0.8, 1e-15);
  check::is_true("is uniform", uniform.is_uniform() && uniform.name() == "uniform");
  check::is_true("without a file",
                 TubeLaw().length() == TubeLaw::uniform(0.1, 0.02, 1e-3).length());
  const std::string taper = "set Law = taper\nset Inner diameter = 10 mm\nset Wall thickness = 1 "
                            "mm\nset Length = 0.8 m\n";
  tube("taper of the diameter", read(taper + "set Outlet diameter = 6 mm\n"),
       {10., 8., 6., 1., 1., 1.});
  tube("taper of the wall", read(taper + "set Outlet wall thickness = 2 mm\n"),
       {10., 10., 10., 1., 1.5, 2.});
  check::is_true("taper without one", read(taper).is_uniform());

  const std::string rows = "0, 0.5, 10\n5, 0.6, 20\n10, 0.7, 10\n";
  const std::string header = "position [cm], wall thickness [mm], inner diameter [mm]\n";
  tube("table", read_table(header + rows), {10., 20., 10., 0.5, 0.6, 0.7});
  check::relative("length of the table", read_table(header + rows).length(), 0.1, 1e-15);
  check::relative("linear", read_table(header + rows).inner_diameter(0.025), 15e-3, 1e-14);
  // Hermite's cubic with the slopes 4 (limited to three times the secant: no) and 0 at the ends of
  // an interval in which D rises from 10 to 20: (15 + (4 - 0) * 5 / 8).
  check::relative("cubic",
                  read_table(header + rows, "set Interpolation = cubic\n").inner_diameter(0.025),
                  17.5e-3, 1e-14);
  check::is_true("uniform table", read_table(header + "0, 1, 2\n3, 1, 2\n").is_uniform() &&
                                      !read_table(header + rows).is_uniform());
}

void test_pre_strain()
{
  const TubeLaw law = read("set Law = E\nset Axial pre-strain = 3 %\n");
  check::relative("length", law.length(), 1.03 * 0.446, 1e-14);
  check::relative("diameter", law.inner_diameter(law.length()), 12.5e-3 / std::sqrt(1.03), 1e-14);
  check::relative("thickness", law.wall_thickness(0.2), 0.05e-3 / std::sqrt(1.03), 1e-14);
  // pi (D + h) h L is the wall's volume.
  const TubeLaw made = TubeLaw::uniform(0.8, 10e-3, 1e-3);
  const TubeLaw stretched = made.stretched(0.21);
  check::relative("volume",
                  (stretched.inner_diameter(0.) + stretched.wall_thickness(0.)) *
                      stretched.wall_thickness(0.) * stretched.length(),
                  11e-3 * 1e-3 * 0.8, 1e-13);
  check::relative("as made", stretched.as_made().inner_diameter(0.), 10e-3, 1e-15);
  check::relative("twice", stretched.stretched(0.1).length(), 1.331 * 0.8, 1e-13);
}

void test_layers()
{
  check::equal("one layer", read("").layer_names().at(0), "wall");
  const TubeLaw law =
      read("set Wall layers = intima, media, adventitia\nset Layer fractions = 10 %, 60 %, 30 %\n");
  check::equal("layer", law.layer_names().at(1), "media");
  check::relative("fraction", law.layer_fractions().at(2), 0.3, 1e-14);
  check::relative("equal parts", read("set Wall layers = a, b, c\n").layer_fractions().at(0),
                  1. / 3., 1e-14);
  refused("no layer", "set Wall layers = a,,b\n", "2: 'Geometry/Wall layers'");
  refused("fluid", "set Wall layers = wall, fluid\n", "2: 'Geometry/Wall layers'.*fluid");
  refused("same name", "set Wall layers = a, b, a\n", "2: 'Geometry/Wall layers'.*'a'");
  refused("fractions", "set Wall layers = a, b\nset Layer fractions = 1\n",
          "3: 'Geometry/Layer fractions'.*1 numbers for 2 layers");
  refused("sum", "set Wall layers = a, b\nset Layer fractions = 0.5, 0.6\n",
          "3: 'Geometry/Layer fractions'.*1.1, not 1");
  const TubeLaw rigid = read("set Inner diameter = 20 mm\nset Wall layers = none\n");
  check::is_true("rigid", rigid.is_rigid() && rigid.layer_names().empty() && !law.is_rigid());
  check::absolute("rigid: no thickness", rigid.wall_thickness(0.), 0., 0.);
  check::relative("rigid: diameter", rigid.inner_diameter(0.), 20e-3, 1e-15);
  const TubeLaw rigid_table = read_table(
      "position [cm], inner diameter [mm]\n0, 10\n5, 20\n10, 10\n", "set Wall layers = none\n");
  check::relative("rigid table: diameter", rigid_table.inner_diameter(0.025), 15e-3, 1e-14);
  check::absolute("rigid table: no thickness", rigid_table.wall_thickness(0.05), 0., 0.);
  refused("none beside others", "set Wall layers = a, none\n", "2: 'Geometry/Wall layers'.*alone");
  refused("fractions of none", "set Wall layers = none\nset Layer fractions = 1\n",
          "3: 'Geometry/Layer fractions'.*no wall");
  refused("thickness of none", "set Wall thickness = 1 mm\nset Wall layers = none\n",
          "2: 'Geometry/Wall thickness'.*no wall");
  refused("negative", "set Wall layers = a, b\nset Layer fractions = 1.5, -0.5\n",
          "3: 'Geometry/Layer fractions'");
}

void test_refusals()
{
  refused("no such law", "set Law = G\n", "2: 'Geometry/Law'");
  refused("length of A", "set Law = A\nset Length = 1 m\n", "3: 'Geometry/Length'.*Law = A");
  refused("length of the aorta", "set Law = aorta\nset Wall thickness = 1 mm\nset Length = 1 m\n",
          "4: 'Geometry/Length'.*aorta.*'Wall thickness'");
  refused("wall of the aorta", "set Law = aorta\n", "1: 'Geometry'.*Wall thickness.*missing");
  refused("outlet of a uniform tube", "set Outlet diameter = 1 m\n",
          "2: 'Geometry/Outlet diameter'.*Law = uniform");
  refused("length of a table", "set Law = table\nset Table = tube-law.csv\nset Length = 1 m\n",
          "4: 'Geometry/Length'.*Law = table");
  refused("no table", "set Law = table\n", "1: 'Geometry'.*Table.*missing");
  refused("no such table", "set Law = table\nset Table = nowhere.csv\n", "3: 'Geometry/Table'");
  refused("negative diameter", "set Inner diameter = -1 mm\n", "2: 'Geometry/Inner diameter'");
  refused("outlet closed", "set Law = taper\nset Outlet diameter = 0 mm\n",
          "3: 'Geometry/Outlet diameter'");
  refused("pre-strain", "set Axial pre-strain = -100 %\n", "2: 'Geometry/Axial pre-strain'");

  const std::string header = "position [mm], inner diameter [mm], wall thickness [mm]\n";
  refused_table("no unit", "position [mm], inner diameter, wall thickness [mm]\n0,1,1\n1,1,1\n",
                "1: 'inner diameter'.*no unit");
  refused_table("missing column", "position [mm], diameter [mm]\n0,1\n1,1\n",
                "1: 'inner diameter'.*'diameter'");
  refused_table("not from 0", header + "1, 10, 1\n2, 10, 1\n", "2: 'position'.*first.*not 0");
  refused_table("not increasing", header + "0, 10, 1\n2, 10, 1\n2, 10, 1\n",
                "4: 'position'.*2 is not larger");
  refused_table("one row", header + "0, 10, 1\n", ".*1 rows");
  refused_table("closed somewhere", header + "0, 10, 1\n2, 0, 1\n",
                "3: 'inner diameter'.*not positive at the position 0.002 m");
  refused_table("no wall somewhere", header + "0, 10, 1\n2, 10, -1\n4, 10, 1\n",
                "3: 'wall thickness'.*not positive at the position 0.002 m");
}
} // namespace

UNIT_TEST(tube_law)
{
  test_thesis();
  test_own();
  test_pre_strain();
  test_layers();
  test_refusals();
  std::filesystem::remove("tube-law.prm");
  std::filesystem::remove("tube-law.csv");
}
} // namespace test_of_tube_law
