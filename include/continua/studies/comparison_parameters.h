#ifndef continua_studies_comparison_parameters_h
#define continua_studies_comparison_parameters_h

#include <continua/base/expected_value.h>
#include <continua/base/parameter_section.h>

#include <string>
#include <vector>

namespace Continua
{
/// The section Comparison: one case by two ways on a sequence of meshes.
struct ComparisonParameters
{
  std::string analysis = "automatic";   ///< of the runs; transient or steady after read()
  std::string entry = "Discretisation"; ///< path of the entry in which the two ways differ
  std::vector<std::string> values = {"taylor hood", "cell-wise"}; ///< its two values
  /// How often the cells of the file's mesh are divided, for each mesh, increasing.
  std::vector<unsigned int> meshes = {0, 1, 2};
  std::vector<unsigned int> second_meshes; ///< of the second way; equal to `meshes` unless given
  bool refine_time_step = false;           ///< divided as often as the cells
  std::vector<std::string> quantities;     ///< "PROBE: QUANTITY" or "QUANTITY"; empty: all
  double tolerance = 1.;                   ///< of the difference over the sum of the errors [1]
  double floor = 1e-8; ///< of the difference over the value [1]: what no error estimate can tell
  double largest_error = 0.5; ///< of both limits over the value [1]: above it there is no verdict
  std::vector<ExpectedValue> expected;

  /// Declares and reads; throws InputError. Needs the root to tell steady from transient.
  void read(ParameterSection root);
  /// What the two ways are called: the values, or key and value where that is a number.
  std::string name(unsigned int way) const;
  const std::vector<unsigned int> &meshes_of(unsigned int way) const
  {
    return way == 0 ? meshes : second_meshes;
  }
};
} // namespace Continua

#endif
