#ifndef continua_studies_comparison_parameters_h
#define continua_studies_comparison_parameters_h

#include <continua/base/parameter_section.h>
#include <continua/studies/mesh_study_parameters.h>

#include <string>
#include <vector>

namespace Continua
{
/// The section Comparison: two variants of one case on a sequence of meshes. `analysis` is
/// transient or steady.
struct ComparisonParameters : MeshStudyParameters
{
  std::string entry = "Discretisation"; ///< path of the entry in which the variants differ
  std::vector<std::string> values = {"taylor hood", "cell-wise"}; ///< its two values
  /// How often the cells of the file's mesh are divided, for each mesh, increasing.
  std::vector<unsigned int> meshes = {0, 1, 2};
  std::vector<unsigned int>
      second_meshes;     ///< of the second variant; equal to `meshes` unless given
  double tolerance = 1.; ///< of the difference over the sum of the errors [1]
  double floor = 1e-8;   ///< of the difference over the value [1]: what no error estimate can tell
  double largest_error = 0.5; ///< of both limits over the value [1]: above it there is no verdict

  /// Declares and reads; throws InputError. Needs the root to tell steady from transient.
  void read(ParameterSection root);
  /// What the variants are called: the values, or key and value where that is a number.
  std::string name(unsigned int variant) const;
  const std::vector<unsigned int> &meshes_of(unsigned int variant) const
  {
    return variant == 0 ? meshes : second_meshes;
  }
};
} // namespace Continua

#endif
