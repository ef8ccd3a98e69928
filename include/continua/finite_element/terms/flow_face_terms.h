#ifndef continua_finite_element_terms_flow_face_terms_h
#define continua_finite_element_terms_flow_face_terms_h

#include <continua/finite_element/terms/given_traction.h>
#include <continua/finite_element/terms/inflow_traction.h>
#include <continua/finite_element/terms/term_list.h>

namespace Continua
{
/// All terms of a liquid on its faces. To add a term, add a row.
using FlowFaceTerms = TermList<GivenTraction, InflowTraction>;
} // namespace Continua

#endif
