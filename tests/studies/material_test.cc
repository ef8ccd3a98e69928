// Relaxation tests as data of an identification: against the exponentials of an incompressible
// Prony series.

#include <continua/base/input_error.h>
#include <continua/studies/material_test.h>

#include "../parameter_text.h"
#include "../unit_test.h"

#include <cmath>
#include <fstream>

namespace test_of_material_test
{
using namespace Continua;

namespace
{
const std::string table = "material_test_of_the_test.csv";

const std::string text = "subsection Materials\n"
                         "  subsection wall\n"
                         "    set Type = prony\n"
                         "    set Density = 1000 kg/m^3\n"
                         "    set Young's modulus = 300 kPa\n"
                         "    set Poisson's ratio = 0.5\n"
                         "    set Shear moduli = 20 kPa\n"
                         "    set Relaxation times = 2 s\n"
                         "  end\n"
                         "end\n"
                         "subsection Tests\n"
                         "  subsection strip\n"
                         "    set Relaxation table = material_test_of_the_test.csv\n"
                         "    set Strain = 0.02\n"
                         "    set Noise = 0.01\n"
                         "  end\n"
                         "  subsection to come\n"
                         "    set First time = 1 s\n"
                         "    set Last time = 100 s\n"
                         "    set Rows = 3\n"
                         "    set Noise = 0.01\n"
                         "  end\n"
                         "end\n";

/// Young's modulus that relaxes by a branch of the shear modulus [Pa].
double exact(const double young, const double shear, const double time)
{
  return young + 3. * shear * std::exp(-time / 2.);
}
} // namespace

UNIT_TEST(material_test)
{
  std::ofstream(table) << "time [s], stress [kPa]\n0, 7\n1, 6.5\n4, 6.2\n9, 6\n";
  ParameterFile file = parameters_of(text);
  MaterialTest test;
  test.read(file.root().subsection("Tests").subsection("strip"));
  const DataRecord data = test.data_record();
  check::equal("name", data.name, "strip: relaxation");
  check::is_true("the row of the start is left out", data.values.size() == 3);
  check::absolute("its value", data.values[1], std::log(6.2e3 / 0.02), 1e-12);
  check::absolute("its noise", data.noise.standard_deviation, 0.01, 0.);

  CommandLine command_line;
  command_line.parameter_file = parameter_file_of_the_test;
  const MaterialTestModel model(command_line, Model::axisymmetric, {test});
  FitModel::Prediction prediction{{1.}, ""};
  model.append({{"Materials/wall/Young's modulus", "400 kPa"}}, prediction);
  check::is_true("behind the values that are there",
                 prediction.values.size() == 4 && prediction.values[0] == 1.);
  double largest = 0.;
  for (unsigned int i = 0; i < 3; ++i)
    largest = std::max(
        largest, std::abs(prediction.values[i + 1] - std::log(exact(400e3, 20e3, data.times[i]))));
  check::absolute("its exponentials", largest, 0., 1e-10);

  MaterialTest to_come;
  to_come.read(file.root().subsection("Tests").subsection("to come"));
  const DataRecord planned = to_come.data_record();
  check::is_true("a test to come has times and no values", !to_come.is_made() && test.is_made() &&
                                                               planned.values.empty() &&
                                                               planned.times.size() == 3);
  check::absolute("its times have equal ratios", planned.times[1], 10., 1e-12);
  FitModel::Prediction of_plan{{}, ""};
  MaterialTestModel(command_line, Model::axisymmetric, {to_come}).append({}, of_plan);
  check::absolute("its prediction", of_plan.values.at(0), std::log(exact(300e3, 20e3, 1.)), 1e-10);

  FitModel::Prediction refused{{1.}, ""};
  model.append({{"Materials/wall/Young's modulus", "-1 kPa"}}, refused);
  check::is_true("a modulus that the file refuses",
                 refused.values.empty() && check::matches(refused.failure, "Young's modulus"));
  FitModel::Prediction failed{{}, "the wave is lost"};
  model.append({}, failed);
  check::equal("a failure stays", failed.failure, "the wave is lost");
}
} // namespace test_of_material_test
