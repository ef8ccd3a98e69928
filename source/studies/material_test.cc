#include <continua/studies/material_test.h>

#include <continua/base/parameter_file.h>
#include <continua/base/parameter_text.h>
#include <continua/case/theory/bar_tables.h>
#include <continua/materials/material.h>
#include <continua/studies/planned_run.h>

#include <cmath>
#include <exception>

namespace Continua
{
void MaterialTest::read(ParameterSection section)
{
  name = section.name();
  section.add("Material", material,
              "Region of the file whose material was tested, as a bar that is free at its sides.");
  section.add("Noise", deviation, Dimensions::none,
              "Standard deviation of the noise as a share of each value of the table, such as "
              "0.003. Not given: it is estimated from the residuals of the fit.",
              Range::positive());
  if (const auto test =
          BarRelaxation::read(section, "Remove the row, or change the sign of all values"))
    record = test->record;
  record.is_logarithmic = true;
}

DataRecord MaterialTest::data_record() const
{
  DataRecord result = record.data_record(deviation);
  result.name = name + ": " + record.name();
  return result;
}

MaterialTestModel::MaterialTestModel(CommandLine command_line,
                                     const Model model,
                                     std::vector<MaterialTest> tests)
    : command_line(std::move(command_line)), model(model), tests(std::move(tests))
{
}

void MaterialTestModel::append(const std::vector<std::pair<std::string, std::string>> &settings,
                               FitModel::Prediction &prediction) const
{
  if (tests.empty() || !prediction.failure.empty())
    return;
  CommandLine of_set = command_line;
  for (const auto &[path, value] : settings)
    set_entry(of_set, path, value);
  try
  {
    ParameterFile file(of_set.parameter_file, of_set.overrides);
    for (const MaterialTest &test : tests)
    {
      const Material material =
          read_material(file.root().subsection("Materials").subsection(test.material), model);
      for (const double value : test.record.scaled_prediction(material))
      {
        if (!std::isfinite(value))
          prediction.failure =
              "the material has no relaxation modulus that '" + test.name + "' could show";
        prediction.values.push_back(value);
      }
    }
  }
  catch (const std::exception &error)
  {
    prediction.failure = collapse_blanks(error.what());
  }
  if (!prediction.failure.empty())
    prediction.values.clear();
}
} // namespace Continua
