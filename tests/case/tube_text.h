#ifndef continua_tests_case_tube_text_h
#define continua_tests_case_tube_text_h

// A tube of liquid as a parameter file, for the unit tests of what is made of a case.

#include <string>

namespace tube_text
{
/// A short axisymmetric tube, R = 5 mm, h = 1 mm, 0.8 m long, in 20 x 4 cells of liquid and one of
/// wall across, divided once. `inlet`, `outlet`, `wall_outlet`: the entries of those boundaries.
inline std::string tube(const std::string &inlet,
                        const std::string &outlet = "set Type = fixed\n",
                        const std::string &wall_outlet = "set Type = fixed\n",
                        const std::string &outside = "set Type = free\n")
{
  return "set Analysis = transient\n"
         "set Model = axisymmetric\n"
         "subsection Geometry\n"
         "set Type = tube\nset Law = uniform\nset Inner diameter = 10 mm\n"
         "set Wall thickness = 1 mm\nset Length = 0.8 m\n"
         "end\n"
         "subsection Mesh\n"
         "set Axial cells = 20\nset Axial grading = 1\nset Radial cells = 4\n"
         "set Radial grading = 1\nset Wall cells = 1\nset Refinements = 1\n"
         "end\n"
         "subsection Materials\n"
         "subsection fluid\nset Type = newtonian\nset Density = 1000 kg/m^3\n"
         "set Bulk modulus = 2.2 GPa\nset Viscosity = 1 mPa s\nend\n"
         "subsection wall\nset Type = hookean\nset Density = 1100 kg/m^3\n"
         "set Young's modulus = 1.2 MPa\nset Poisson's ratio = 0.49\nend\n"
         "end\n"
         "subsection Boundaries\n"
         "subsection inlet\n" +
         inlet + "end\nsubsection outlet\n" + outlet +
         "end\n"
         "subsection wall inlet end\nset Type = fixed\nend\n"
         "subsection wall outlet end\n" +
         wall_outlet + "end\nsubsection outside\n" + outside +
         "end\n"
         "subsection axis\nset Type = axis\nend\n"
         "end\n"
         "subsection Time\n"
         "set Scheme = crank nicolson\nset Time step = 0.5 ms\nset End time = 0.5 s\n"
         "end\n";
}

/// Of an inlet: a pulse of 50 ms.
inline std::string pulse()
{
  return "set Type = pressure\nset Waveform = sine squared pulse\nset Amplitude = 1 kPa\n"
         "set Duration = 50 ms\n";
}
} // namespace tube_text

#endif
