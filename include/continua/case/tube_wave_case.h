#ifndef continua_case_tube_wave_case_h
#define continua_case_tube_wave_case_h

#include <continua/case/case.h>
#include <continua/theory/tube_wave_theory.h>

#include <functional>
#include <string>

namespace Continua
{
/// A parameter file as wave theory sees it.
struct TubeWaveCase
{
  TubeWaveProblem problem;
  std::function<double(double)> inlet; ///< [Pa] or [m^3/s] over time [s]
};

/// Translates the case; returns why wave theory does not cover it, or nothing.
template <int dim>
std::string make_tube_wave_case(const Case<dim> &input, TubeWaveCase &wave_case);

/// The cross-section at z [m] of the case's tube, which must be one (see Geometry::tube_law()).
template <int dim>
TubeSection tube_section_at(const Case<dim> &input, double z);
} // namespace Continua

#endif
