#ifndef continua_materials_power_law_fit_h
#define continua_materials_power_law_fit_h

#include <continua/materials/material.h>
#include <continua/materials/prony_series.h>

namespace Continua
{
/**
 * Gives a material with a power law the branches that follow its shear modulus from
 * `lowest_frequency` to `highest_frequency` [Hz], and where its volume change relaxes like its
 * shear the bulk branches in proportion and their sum as K. How many branches and how closely, its
 * `prony_fit` says. Materials whose laws differ by a factor get the same times, bit by bit. Returns
 * the series of the shear modulus [Pa].
 *
 * Throws std::range_error, with the error that is reached, if the branches do not meet the
 * tolerance, and std::domain_error if the law has no positive shear modulus somewhere in the band:
 * with an elastic bulk modulus K Young's modulus must stay below 9 K.
 */
PronySeries fit_power_law(Material &material, double lowest_frequency, double highest_frequency);

/// The branches of a series of the shear modulus, and where the volume change relaxes like the
/// shear those of the bulk modulus.
void take_branches(Material &material, const PronySeries &series);
} // namespace Continua

#endif
