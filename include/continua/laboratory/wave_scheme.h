#ifndef continua_laboratory_wave_scheme_h
#define continua_laboratory_wave_scheme_h

#include <continua/base/words.h>
#include <continua/finite_volume/cell_wise_parameters.h>
#include <continua/theory/amplification.h>
#include <continua/time_integration/time_control.h>

#include <optional>

namespace Continua
{
/// The schemes in time whose amplification can be asked for, on the compact stencil of the
/// cell-wise operators.
enum class WaveScheme
{
  displacement_euler,                         ///< equations 3.42, 3.96 of the thesis
  displacement_four_levels,                   ///< 3.43
  velocity_euler,                             ///< 3.44 with the trapezoidal rule 2.16; 3.111
  velocity_euler_implicit,                    ///< with the implicit update
  velocity_backward_differencing,             ///< 3.45, implicit update
  velocity_backward_differencing_trapezoidal, ///< trapezoidal update
  velocity_crank_nicolson
};

const Words<WaveScheme> &wave_scheme_words();

/// What a run is told of a scheme, and what the sequence of its states is made of.
struct WaveSchemeData
{
  Formulation formulation;
  Scheme scheme;
  std::optional<Update> update; ///< none: the scheme sets it
  unsigned int n_factors;       ///< eigenvalues of a step that are different from zero
  unsigned int n_start;         ///< steps of another scheme at the start
};

const WaveSchemeData &data_of(WaveScheme scheme);

/// What a step of the scheme does to a mode that has the angle theta = omega dt [rad] in it.
Amplification amplification_of(WaveScheme scheme, double theta);

/// The smallest theta [rad] from 0.01 to 1000 at which the part of a mode that lasts longest
/// changes its sign in every step; none where the scheme never does that.
std::optional<double> ringing_angle(WaveScheme scheme);
} // namespace Continua

#endif
