#include <continua/boundary/boundary_entries.h>

namespace Continua
{
void read_tangential(ParameterSection &section, BoundaryCondition &condition)
{
  add_choice(section, "Tangential", condition.tangential.kind,
             {{"free", BoundaryPart::Kind::traction}, {"fixed", BoundaryPart::Kind::velocity}},
             "Along the boundary: free of traction, or fixed (no velocity along it).");
}

void read_inflow_pressure(ParameterSection &section,
                          BoundaryCondition &condition,
                          const InflowPressure by_itself)
{
  condition.inflow_pressure = by_itself;
  add_choice(section, "Inflow pressure", condition.inflow_pressure,
             {{"static", InflowPressure::static_pressure}, {"total", InflowPressure::total}},
             "What the boundary's pressure is where liquid flows in, with convection: static - the "
             "pressure of the liquid there; total - that and half of its density times the square "
             "of its velocity, which bounds the energy that flows back in through an outlet.");
}
} // namespace Continua
