#ifndef continua_finite_volume_cell_wise_parameters_h
#define continua_finite_volume_cell_wise_parameters_h

#include <continua/base/parameter_section.h>

#include <string>

namespace Continua
{
/// Which unknowns the cell-wise path solves for.
enum class Formulation
{
  displacement,               ///< D (equation 3.36)
  velocity,                   ///< U, stress from the accumulated D (3.39)
  velocity_explicit_pressure, ///< U, with p computed from U (3.40, 2.25)
  velocity_pressure           ///< U and p (3.41, 3.58)
};

/// How the pressure of a boundary face is found.
enum class BoundaryPressure
{
  momentum,      ///< by the gradient of the owner's momentum equation (3.74 to 3.76)
  definition,    ///< from the divergence on the face (3.72)
  force_balance, ///< from the normal traction (3.73)
  zero_gradient  ///< the owner's
};

/// The section Cell-wise. Where the thesis's scheme and the one that is right differ, `Variant`
/// sets what the other entries are by default.
struct CellWiseParameters
{
  std::string variant = "continua";
  std::string formulation = "velocity-pressure";
  std::string solution = "coupled";
  std::string accumulated_term = "consistent";
  std::string rhie_chow = "increment";
  std::string stencil_coefficient = "automatic";
  std::string pressure_update = "as the displacement";
  std::string boundary_pressure = "definition";
  std::string boundary_pressure_as = "value";
  std::string boundary_velocity_as = "automatic";
  std::string boundary_gradient = "replaced";
  std::string power_operator = "scheme";
  double tolerance = 1e-8; ///< of the residual of the segregated loop [1]
  unsigned int maximum_corrections = 50;
  unsigned int pressure_corrections = 2;
  std::string cap = "warn";
  bool residual_history = false;

  /// Declares and reads; throws InputError.
  void read(ParameterSection section);

  Formulation formulation_type() const;
  BoundaryPressure boundary_pressure_type() const;
  /// Whether the pressure is apart from the other stresses.
  bool has_pressure() const
  {
    return formulation_type() == Formulation::velocity_pressure ||
           formulation_type() == Formulation::velocity_explicit_pressure;
  }
  /// Whether the segregated loop solves the faces' own equations face by face.
  bool faces_balance() const
  {
    return boundary_velocity_as == "balance" ||
           (boundary_velocity_as == "automatic" &&
            formulation_type() == Formulation::velocity_pressure);
  }
  bool is_segregated() const { return solution == "segregated"; }
};
} // namespace Continua

#endif
