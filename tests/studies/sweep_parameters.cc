// The section Sweep: which runs it makes, what they are called, and what it refuses.

#include "../parameter_text.h"

#include <continua/base/input_error.h>
#include <continua/base/parameter_file.h>
#include <continua/studies/sweep_parameters.h>

#include "../unit_test.h"

namespace test_of_sweep_parameters
{
using namespace Continua;

namespace
{
SweepParameters sweep_of(const std::string &text)
{
  ParameterFile file = parameters_of("subsection Sweep\n" + text + "end\n");
  SweepParameters sweep;
  sweep.read(file.root());
  return sweep;
}

std::string entries(const std::string &lines)
{
  return "subsection Entries\n" + lines + "end\n";
}

std::string names(const SweepParameters &sweep)
{
  std::string result;
  for (unsigned int run = 0; run < sweep.n_runs(); ++run)
    result += (run == 0 ? "" : "; ") + sweep.name(run);
  return result;
}

void refuses(const std::string &name, const std::string &text, const std::string &pattern)
{
  check::throws<InputError>(
      name, [&text] { sweep_of(text); }, pattern);
}
} // namespace

UNIT_TEST(sweep_parameters)
{
  const std::string modulus = "set Materials/wall/Young's modulus = 1 MPa, 2 MPa\n",
                    thickness = "set Geometry/Wall thickness = 1 mm, 2 mm\n";
  check::equal(
      "a grid, the last entry first", names(sweep_of(entries(modulus + thickness))),
      "young's modulus 1 MPa, wall thickness 1 mm; young's modulus 1 MPa, wall thickness 2 "
      "mm; young's modulus 2 MPa, wall thickness 1 mm; young's modulus 2 MPa, wall "
      "thickness 2 mm");
  check::equal(
      "together", names(sweep_of("set Combine = together\n" + entries(modulus + thickness))),
      "young's modulus 1 MPa, wall thickness 1 mm; young's modulus 2 MPa, wall thickness 2 "
      "mm");
  check::equal(
      "keys that are the same",
      names(sweep_of("set Combine = together\n" + entries("set Materials/inner/Density = 1, 2\n"
                                                          "set Materials/outer/Density = 3, 4\n"
                                                          "set Model = a, b\n"))),
      "inner/Density 1, outer/Density 3, model a; inner/Density 2, outer/Density 4, model "
      "b");
  check::equal("a value with a colon",
               names(sweep_of(entries("set Time/Time step changes = 0 s : 1 ms\n"))),
               "time step changes 0 s 1 ms");
  const SweepParameters three =
      sweep_of(entries(modulus + thickness + "set Geometry/Length = 1 m to 3 m in 3\n"));
  const std::vector<unsigned int> last = {1, 1, 2}, middle = {0, 1, 2};
  check::is_true("places",
                 three.n_runs() == 12 && three.places(11) == last && three.places(5) == middle);
  check::is_true("nothing is swept yet", sweep_of("set Combine = grid\n").axes.empty());

  refuses("an empty list", entries("set Geometry/Length = \n"), "it lists no value");
  refuses("a reversed range", entries("set Geometry/Length = 2 m to 1 m in 3\n"),
          "Geometry/Length.*does not end above its beginning.*Write for example");
  refuses("unequal numbers together",
          "set Combine = together\n" + entries(modulus + "set Geometry/Length = 1 m\n"),
          "1 values go together with 2");
  refuses("an entry twice", entries("set Geometry/Length = 1 m\nset Geometry / Length = 2 m\n"),
          "swept twice");
  refuses("the analysis", entries("set Analysis = steady, modal\n"), "the sweep itself sets this");
  refuses("itself", entries("set Sweep/Combine = grid, together\n"), "the sweep itself sets this");
  refuses("too many", entries("set A = 1 to 2 in 101\nset B = 1 to 2 in 100\n"),
          "more than 10000 runs");
}
} // namespace test_of_sweep_parameters
