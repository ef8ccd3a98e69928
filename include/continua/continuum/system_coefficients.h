#ifndef continua_continuum_system_coefficients_h
#define continua_continuum_system_coefficients_h

#include <continua/continuum/problem.h>
#include <continua/time_integration/step.h>

#include <vector>

namespace Continua
{
/// What the linear system of a step is made of, by material id.
struct SystemCoefficients
{
  std::vector<double> mass;            ///< a0 rho [kg/(m^3 s)]
  std::vector<double> stiffness;       ///< alpha, equation 7.4 [Pa s]
  std::vector<double> compressibility; ///< 1/(K b) [1/(Pa s)]
  /// Of the supports, with which they multiply a velocity: b of D = D_plus + b U [s], and 1.
  double support_stiffness = 0., support_damping = 0.;
  /// Regions whose terms are not linear: of them the system has nothing but the supports, not even
  /// B. Empty: there is none.
  std::vector<bool> left_out = {};
  /// Of steady equations, whose coefficients are so far apart that a direct solve needs a step of
  /// refinement.
  bool finds_steady_state = false;

  /// But for round-off: time steps of one size are not equal to the last bit.
  bool operator==(const SystemCoefficients &other) const;

  /// Takes those of a step with small strains and without convection.
  void set(const Problem &problem, const Step &step);
  void leave_out(unsigned int region);
  bool has(const unsigned int region) const { return left_out.empty() || !left_out[region]; }
  /// Takes those of a body at rest that is all solid (displacement for velocity, mu for alpha, 1/K
  /// for compressibility) or of a steady flow, where dp/dt = 0 and compressibility has no part.
  void set_steady(const Problem &problem);
};
} // namespace Continua

#endif
