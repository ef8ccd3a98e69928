#ifndef continua_tests_analysis_column_text_h
#define continua_tests_analysis_column_text_h

// A column between smooth walls as a parameter file, for the unit tests of the analyses: its
// longitudinal waves have the speed c = sqrt((K + 4/3 mu)/rho).

#include <string>

namespace column_text
{
/// Y = 2.6 GPa, nu = 0.3: K + 4/3 mu = 3.5 GPa; rho = 1400 kg/m^3.
constexpr double wave_speed = 1581.13883008419; ///< [m/s]

/// 1 m x 0.1 m in 10 x 1 cells, held at its left end. `entries`: whatever else the file has.
inline std::string column(const std::string &analysis, const std::string &entries)
{
  return "set Analysis = " + analysis +
         "\n"
         "set Model = plane strain\n"
         "subsection Geometry\nset Type = box\nset Size = 1 m, 0.1 m\nend\n"
         "subsection Mesh\nset Cells = 10, 1\nend\n"
         "subsection Materials\nsubsection body\nset Type = hookean\n"
         "set Density = 1400 kg/m^3\nset Young's modulus = 2.6 GPa\n"
         "set Poisson's ratio = 0.3\nend\nend\n"
         "subsection Boundaries\n"
         "subsection left\nset Type = roller\nend\nsubsection right\nset Type = free\nend\n"
         "subsection bottom\nset Type = roller\nend\nsubsection top\nset Type = roller\nend\n"
         "end\n" +
         entries;
}
} // namespace column_text

#endif
