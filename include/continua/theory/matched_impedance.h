#ifndef continua_theory_matched_impedance_h
#define continua_theory_matched_impedance_h

#include <continua/theory/exact_dispersion.h>
#include <continua/theory/wall_end.h>

#include <deal.II/lac/full_matrix.h>

#include <complex>
#include <vector>

namespace Continua
{
/**
 * The impedance of the end of a tube out of which the waves leave as if the tube went on: pressures
 * p_i [Pa] at the ports over the flow rates Q_j [m^3/s] out of them. The first port is the liquid's
 * section; the second one, if the wall's end is absorbing and the tube has an axial wave, is the
 * wall's end, with p = -axial force/A_w and Q = A_w times its axial velocity, A_w [m^2] its area.
 *
 * Pressure and axial wave (of unit amplitude) arrive, neither is sent back, and what else the end's
 * wall demands (see zero_quantities()) is met by the waves that die out near it: those of bending,
 * and, where there is no port for it, the axial wave that the end sends back. With a column for
 * each arriving wave, Z = P Q^-1. Waves are orthogonal to each other by reciprocity, so Z is
 * symmetric up to what p and the axial velocity vary over a section; the symmetric part is
 * returned.
 *
 * `modes`: the waves at omega [1/s], Im omega <= 0, in the order of ExactDispersion.
 */
dealii::FullMatrix<std::complex<double>> matched_impedance(const std::vector<WaveMode> &modes,
                                                           WallEnd wall,
                                                           const std::complex<double> &omega,
                                                           double wall_area);

/// The same at omega = 2 pi f - i shift for frequencies f [Hz], increasing, four at least, with a
/// shift [1/s] > 0. Throws RunError if a wave is lost.
std::vector<dealii::FullMatrix<std::complex<double>>> matched_impedances(
    const TubeSection &section, WallEnd wall, double shift, const std::vector<double> &frequencies);
} // namespace Continua

#endif
