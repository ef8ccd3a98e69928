#ifndef continua_materials_bulk_relaxation_h
#define continua_materials_bulk_relaxation_h

#include <continua/materials/material.h>

namespace Continua
{
/**
 * Gives every spring of the shear one of the volume change with the same relaxation time and
 * K_k = mu_k 2(1 + nu)/(3(1 - 2 nu)), so that Poisson's ratio is nu at all frequencies and times.
 * nu = 0.5 leaves the material incompressible.
 */
void relax_volume_as_shear(Material &material, double poissons_ratio);
} // namespace Continua

#endif
