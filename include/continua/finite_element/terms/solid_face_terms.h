#ifndef continua_finite_element_terms_solid_face_terms_h
#define continua_finite_element_terms_solid_face_terms_h

#include <continua/finite_element/terms/follower_pressure.h>
#include <continua/finite_element/terms/term_list.h>

namespace Continua
{
/// All terms of a solid in finite deformation on its faces. To add a term, add a row.
using SolidFaceTerms = TermList<FollowerPressure>;
} // namespace Continua

#endif
