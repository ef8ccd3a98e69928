#ifndef continua_laboratory_material_text_h
#define continua_laboratory_material_text_h

#include <continua/theory/bar_law_fit.h>

#include <string>

namespace Continua
{
/// A parameter file of `Analysis = material` with the material that a fit has found, whose section
/// Materials can be pasted into the file of a run. Standard errors stand in comments. `density`
/// [kg/m^3].
std::string material_text(const BarLawFit &fit, double density);
} // namespace Continua

#endif
