#include <continua/case/harmonic_parameters.h>

#include <continua/base/input_error.h>

#include "../check.h"
#include "../parameter_text.h"
#include "../unit_test.h"

#include <cmath>

namespace test_of_harmonic_parameters
{
using namespace Continua;

UNIT_TEST(harmonic_parameters)
{
  ParameterFile file = parameters_of("subsection Harmonic\nset Frequencies = 3 kHz, 2 Hz, 8 Hz\n"
                                     "set Lowest frequency = 0.5 Hz\n"
                                     "set Highest frequency = 8 Hz\nset Number of frequencies = 5\n"
                                     "set Spacing = logarithmic\n"
                                     "set Field frequencies = 4 Hz, 0.003 MHz\nend\n"
                                     "subsection Body force\nset Phase = 90 deg\nend\n");
  HarmonicParameters parameters;
  parameters.read(file.root().subsection("Harmonic"));
  const std::vector<double> expected = {0.5, 1., 2., 4., 8., 3000.};
  check::is_true("each frequency once", parameters.frequencies.size() == expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k)
    check::relative("frequency", parameters.frequencies[k], expected[k], 1e-14);
  check::is_true("a field's frequency is one of them",
                 parameters.field_frequencies[0] == parameters.frequencies[3] &&
                     parameters.field_frequencies[1] == parameters.frequencies[5]);

  ParameterFile repeated =
      parameters_of("subsection Harmonic\nset Frequencies = 10 Hz\nset Lowest frequency = 1 Hz\n"
                    "set Highest frequency = 1 kHz\nset Number of frequencies = 4\n"
                    "set Spacing = logarithmic\nend\n");
  HarmonicParameters once;
  once.read(repeated.root().subsection("Harmonic"));
  check::is_true("round-off makes no second frequency",
                 once.frequencies.size() == 4 && once.frequencies[1] == 10.);
  parameters.read_phases(file.root(), {});
  check::relative("phase", parameters.body_force_phase, std::acos(-1.) / 2., 1e-15);
}
} // namespace test_of_harmonic_parameters
