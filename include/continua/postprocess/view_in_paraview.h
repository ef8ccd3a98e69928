#ifndef continua_postprocess_view_in_paraview_h
#define continua_postprocess_view_in_paraview_h

#include <string>

namespace Continua
{
/**
 * The text of view-in-paraview.py, a Python script for ParaView 5.10 or later that opens the
 * fields.pvd beside it: solids deformed by their displacement times a factor that is shown, liquids
 * where they were, colours over the range of the whole run. `file`: its absolute path, which it
 * needs where ParaView does not say it.
 */
std::string view_in_paraview(const std::string &file);
} // namespace Continua

#endif
