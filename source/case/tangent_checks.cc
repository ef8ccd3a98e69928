#include <continua/case/tangent_checks.h>

namespace Continua
{
void refuse_what_tangents_leave_idle(const LinearSolverType type, ParameterSection root)
{
  if (ParameterSection solver = root.subsection("Linear solver"); solver.given("Tolerance"))
    solver.refuse("Tolerance",
                  "with convection or finite deformation the iterative solver finds corrections of "
                  "Newton's iteration, which end at Newton/Krylov tolerance",
                  "Remove it");
  if (type != LinearSolverType::iterative)
    return;
  for (const char *const key : {"Slow iteration", "Tangent products", "Most Krylov iterations"})
    if (ParameterSection newton = root.subsection("Newton"); newton.given(key))
      newton.refuse(key,
                    "Linear solver/Type = iterative makes no use of it: each iteration has the "
                    "tangent of its own state",
                    "Remove it, or set Linear solver/Type = direct");
}
} // namespace Continua
