#ifndef continua_finite_element_linear_solver_parameters_h
#define continua_finite_element_linear_solver_parameters_h

#include <continua/base/parameter_section.h>

#include <string>

namespace Continua
{
/// The section Linear solver.
struct LinearSolverParameters
{
  std::string type = "automatic";          ///< automatic, direct or iterative
  std::string direct_solver = "automatic"; ///< automatic, cholmod, mumps or umfpack
  unsigned int refinement_steps = 0;
  unsigned int kept_factors = 2;
  // Of the iterative solver.
  double tolerance = 1e-8;
  unsigned int maximum_iterations = 500;
  unsigned int restart_length = 60;
  std::string schur_complement = "automatic"; ///< automatic, cahouet-chabard or simple
  std::string stiff_block = "automatic";      ///< automatic, direct or algebraic multigrid
  std::string fluid_block = "automatic";      ///< automatic, relaxation or algebraic multigrid

  void read(ParameterSection section);
};
} // namespace Continua

#endif
