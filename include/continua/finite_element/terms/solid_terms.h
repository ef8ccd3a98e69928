#ifndef continua_finite_element_terms_solid_terms_h
#define continua_finite_element_terms_solid_terms_h

#include <continua/finite_element/terms/solid_inertia.h>
#include <continua/finite_element/terms/solid_pressure.h>
#include <continua/finite_element/terms/solid_stress.h>
#include <continua/finite_element/terms/solid_viscosity.h>
#include <continua/finite_element/terms/solid_volume.h>
#include <continua/finite_element/terms/term_list.h>

namespace Continua
{
/// All terms of a solid in finite deformation inside its cells. To add a term, add a row.
using SolidTerms = TermList<SolidStress, SolidViscosity, SolidPressure, SolidInertia, SolidVolume>;
} // namespace Continua

#endif
