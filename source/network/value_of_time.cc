#include <continua/network/value_of_time.h>

#include <continua/signal/waveform.h>

namespace Continua
{
ValueOfTime ValueOfTime::read(ParameterSection &section,
                              const std::string &key,
                              const Dimension &dimension,
                              const std::string &text)
{
  const Waveform waveform = Waveform::read(section, key, dimension, text, true);
  if (waveform.depends_on_space())
    section.refuse(key, "depends on x, y or z",
                   "Write it as a function of t: a node of a network has no place in space");
  return {[waveform](const double time)
          {
            const double origin[3] = {0., 0., 0.};
            return waveform(origin, time);
          },
          waveform.table_period()};
}
} // namespace Continua
