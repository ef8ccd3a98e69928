#include <continua/studies/material_test.h>

#include <continua/base/parameter_file.h>
#include <continua/base/parameter_text.h>
#include <continua/case/theory/bar_tables.h>
#include <continua/materials/material.h>
#include <continua/studies/planned_run.h>

#include <array>
#include <cmath>
#include <exception>

namespace Continua
{
void MaterialTest::read(ParameterSection section)
{
  name = section.name();
  section.add("Material", material,
              "Region of the file whose material is tested, as a bar that is free at its sides.");
  section.add("Noise", deviation, Dimensions::none,
              "Standard deviation of the noise as a share of each value of the table, such as "
              "0.003. Not given: it is estimated from the residuals of the fit; a design needs it.",
              Range::positive());
  double first_time = 0., last_time = 0.;
  unsigned int n_rows = 50;
  section.add("First time", first_time, Dimensions::time,
              "Of a test that is to be made: time of its first row after the strain is there.",
              Range::positive());
  section.add("Last time", last_time, Dimensions::time,
              "Of a test that is to be made: time of its last row.", Range::positive());
  section.add("Rows", n_rows,
              "Of a test that is to be made: its rows [1], at times of equal ratios.", 2, 100000);
  if (const auto test =
          BarRelaxation::read(section, "Remove the row, or change the sign of all values"))
    record = test->record;
  record.is_logarithmic = true;
  if (is_made() || !(last_time > first_time))
    return;
  for (unsigned int row = 0; row < n_rows; ++row)
    record.abscissae.push_back(first_time *
                               std::pow(last_time / first_time, double(row) / (n_rows - 1)));
}

void MaterialTest::check(ParameterSection section, const bool is_design) const
{
  const std::array<const char *, 3> of_a_plan = {{"First time", "Last time", "Rows"}};
  if (is_made() || !is_design)
    for (const char *const key : of_a_plan)
      if (section.given(key))
        section.refuse(key,
                       is_made() ? "the relaxation table has the times of the rows"
                                 : "a test that is to be made belongs to the design of an "
                                   "experiment",
                       is_made() ? "Remove the entry"
                                 : "Give a Relaxation table, or add the subsection 'Expected "
                                   "noise'");
  if (is_design)
    section.require("Noise");
  if (is_made())
    return;
  if (!is_design)
    section.require("Relaxation table");
  section.require("First time");
  section.require("Last time");
  if (record.abscissae.empty())
    section.refuse("Last time", "it is not later than First time", "Give a later time");
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
