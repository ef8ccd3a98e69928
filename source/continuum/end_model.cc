#include <continua/continuum/end_model.h>

#include <continua/continuum/network_model.h>
#include <continua/continuum/outlet_model.h>

namespace Continua
{
std::unique_ptr<EndModel> make_end_model(const Outlet &outlet)
{
  if (outlet.network)
    return std::make_unique<NetworkModel>(outlet);
  return std::make_unique<OutletModel>(outlet);
}
} // namespace Continua
