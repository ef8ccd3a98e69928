#ifndef continua_finite_element_terms_flow_terms_h
#define continua_finite_element_terms_flow_terms_h

#include <continua/finite_element/terms/flow_convection.h>
#include <continua/finite_element/terms/flow_inertia.h>
#include <continua/finite_element/terms/flow_pressure.h>
#include <continua/finite_element/terms/flow_viscosity.h>
#include <continua/finite_element/terms/flow_volume.h>
#include <continua/finite_element/terms/grad_div.h>
#include <continua/finite_element/terms/streamline.h>
#include <continua/finite_element/terms/term_list.h>

namespace Continua
{
/// All terms of a liquid inside its cells. To add a term, add a row.
using FlowTerms =
    TermList<FlowInertia, FlowConvection, GradDiv, FlowViscosity, FlowPressure, FlowVolume>;
/// The same with the streamline-upwind term; their point is a StreamlinePoint.
using StreamlineFlowTerms = TermList<FlowInertia,
                                     FlowConvection,
                                     GradDiv,
                                     FlowViscosity,
                                     FlowPressure,
                                     FlowVolume,
                                     Streamline>;
} // namespace Continua

#endif
