#ifndef continua_case_wave_theory_parameters_h
#define continua_case_wave_theory_parameters_h

#include <continua/base/words.h>
#include <continua/theory/closed_form_waves.h>
#include <continua/theory/stream.h>

#include <vector>

namespace Continua
{
/// What the liquid meets at the outlet.
enum class FarEnd
{
  as_boundary, ///< what the boundary's condition says
  matched,     ///< the pressure wave's own impedance
  branches     ///< out of which nothing comes back
};

/// The section Wave theory: how the waves of a tube are computed in theory.
struct WaveTheoryParameters
{
  bool overlay = true;               ///< beside a run
  bool overlay_given = false;        ///< by the user, who is told if it cannot be had
  bool nonlinear = false;            ///< one-dimensional nonlinear theory stands beside it
  double nonlinear_cell_length = 0.; ///< of its cells at most [m]; 0: by the load
  WaveLevel level = WaveLevel::exact;
  FarEnd far_end = FarEnd::as_boundary;
  std::vector<double> branch_diameters;        ///< inner ones, of branches at the far end [m]
  std::vector<double> branch_wall_thicknesses; ///< [m]
  std::vector<double> branch_youngs_moduli;    ///< [Pa]
  unsigned int segments = 80;                  ///< of a tube that is not uniform
  unsigned int computed_sections = 0;          ///< of its segments; 0: by the tube's law
  double spectral_tolerance = 1e-5;            ///< of the inlet's spectrum
  double highest_frequency = 0.; ///< [Hz] of the dispersion table; 0: that of the inlet
  double mean_pressure = 0.;     ///< about which the waves run, with finite deformation [Pa]
  Stream stream;                 ///< a mean velocity of zero: there is none
  double stream_frequency = 0.;  ///< [Hz] of the waves in the viscous stream; 0: none

  /// Declares and reads; throws InputError.
  void read(ParameterSection section);
};
} // namespace Continua

#endif
