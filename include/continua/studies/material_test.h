#ifndef continua_studies_material_test_h
#define continua_studies_material_test_h

#include <continua/base/command_line.h>
#include <continua/base/parameter_section.h>
#include <continua/base/undefined.h>
#include <continua/inference/fit_model.h>
#include <continua/materials/model.h>
#include <continua/theory/bar_record.h>

#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/// A relaxation test of a bar of a material of the file: further data of an identification, or a
/// test of an experiment that is to be designed.
struct MaterialTest
{
  std::string name;              ///< as the user calls it
  std::string material = "wall"; ///< region whose material is tested
  BarRecord record;              ///< no values: it is to be made
  double deviation = undefined;  ///< of the noise, a share of each value [1]

  /// Declares and reads a child of the section Material tests. Throws InputError.
  void read(ParameterSection section);
  /// Whether there is a table.
  bool is_made() const { return !record.values.empty(); }
  /// The rules of a test; only a design may have one that is to be made, and needs its noise.
  /// Throws InputError.
  void check(ParameterSection section, bool is_design) const;
  /// Logarithms of the relaxation modulus in Pa, "NAME: relaxation" [1]; without values if it is to
  /// be made.
  DataRecord data_record() const;
};

/// Predicts the rows of material tests from entries of the file.
class MaterialTestModel
{
public:
  /// `command_line`: of the file, without its data.
  MaterialTestModel(CommandLine command_line, Model model, std::vector<MaterialTest> tests);

  bool is_empty() const { return tests.empty(); }
  /// Appends the rows of all tests for these entries, "Section/Key" and a value each, to a
  /// prediction without failure; or says why there are none.
  void append(const std::vector<std::pair<std::string, std::string>> &settings,
              FitModel::Prediction &prediction) const;

private:
  CommandLine command_line;
  Model model;
  std::vector<MaterialTest> tests;
};
} // namespace Continua

#endif
