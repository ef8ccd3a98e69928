#ifndef continua_materials_mean_modulus_h
#define continua_materials_mean_modulus_h

#include <continua/materials/material.h>

namespace Continua
{
/**
 * The modulus by which elastic theory replaces a viscoelastic solid: the mean of Re Y(omega) over
 * the harmonics omega = 2 pi i f, i = 1 ... N, of a signal's fundamental f [Hz] (equation 5.7 of
 * the thesis) [Pa]. The thesis counts i from 0 and divides by N + 1; the constant part, of which a
 * power law has no modulus, is left out here. N is 40 in the thesis, which does not say its f.
 */
double mean_modulus(const Material &material, double fundamental, unsigned int n_harmonics = 40);
} // namespace Continua

#endif
