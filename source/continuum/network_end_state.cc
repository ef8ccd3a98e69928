#include <continua/continuum/network_end_state.h>

namespace Continua
{
void NetworkEndState::visit(StateVisitor &visitor,
                            const unsigned int number,
                            NetworkEndState &before)
{
  visitor.levels({"network", number}, network.data(), before.network.data(), network.size());
  visitor.levels({"pressures of network", number}, pressures.data(), before.pressures.data(),
                 pressures.size());
  visitor.levels({"impedance of network", number}, z.data(), before.z.data(), z.size());
  visitor.levels({"flow rates of network", number}, flow_rates.data(), before.flow_rates.data(),
                 flow_rates.size());
  visitor.levels({"level pressures of network", number}, level_pressures.data(),
                 before.level_pressures.data(), level_pressures.size());
  visitor.levels({"flow slopes of network", number}, flow_slopes.data(), before.flow_slopes.data(),
                 flow_slopes.size());
  visitor.levels({"pressure slopes of network", number}, pressure_slopes.data(),
                 before.pressure_slopes.data(), pressure_slopes.size());
  visitor.levels({"interval of network", number}, &interval, &before.interval, 1);
  visitor.levels({"step of network", number}, &size, &before.size, 1);
  visitor.levels({"level of network", number}, &level, &before.level, 1);
  visitor.levels({"energy of network", number}, &energy, &before.energy, 1);
}
} // namespace Continua
