#ifndef continua_materials_model_h
#define continua_materials_model_h

#include <string>
#include <vector>

namespace Continua
{
/// The kinematics of the run: which components of the strain exist.
enum class Model
{
  plane_strain, ///< 2-D, eps_zz = 0; per metre of depth
  plane_stress, ///< 2-D, sigma_zz = 0, Hookean regions only; per metre of depth
  axisymmetric, ///< 2-D, x axial and y radial, no swirl; the whole circumference
  three_dimensional
};

/// The words of the parameter file, in the order of the enumeration.
const std::vector<std::string> &model_names();

/// The model of that name; the name must be one of model_names().
Model model_of(const std::string &name);

/// 2 or 3.
unsigned int n_dimensions(Model model);
} // namespace Continua

#endif
