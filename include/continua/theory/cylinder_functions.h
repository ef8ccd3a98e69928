#ifndef continua_theory_cylinder_functions_h
#define continua_theory_cylinder_functions_h

#include <continua/theory/ball.h>

namespace Continua
{
/**
 * J_0, J_1, Y_0 and Y_1 of one argument, which the layers of a tube need together.
 *
 * Of a small argument they are sums of one power series (Abramowitz and Stegun, Handbook of
 * Mathematical Functions, 1964, 9.1.10 and 9.1.13), whose omitted terms are a part of the bound of
 * the error. Of a larger one J_0, J_1 and Y_0 are Arb's. Y_1 follows from the Wronskian
 * J_1 Y_0 - J_0 Y_1 = 2/(pi z) (9.1.16). Four calls of Arb take five to ten times as long.
 */
struct CylinderFunctions
{
  Ball j0, j1, y0, y1;

  explicit CylinderFunctions(const Ball &argument);
};
} // namespace Continua

#endif
