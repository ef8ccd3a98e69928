#include <continua/boundary/boundary_part.h>

namespace Continua
{
bool BoundaryPart::is_zero() const
{
  for (const Waveform &component : vector)
    if (!component.is_zero())
      return false;
  return along_normal.is_zero();
}

bool BoundaryPart::depends_on_time() const
{
  if (flow)
    return flow->depends_on_time();
  for (const Waveform &component : vector)
    if (component.depends_on_time())
      return true;
  return along_normal.depends_on_time();
}
} // namespace Continua
