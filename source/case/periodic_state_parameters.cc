#include <continua/case/periodic_state_parameters.h>

namespace Continua
{
void PeriodicStateParameters::read(ParameterSection section)
{
  is_on = true;
  section.add("Period", period, Dimensions::time,
              "Length of a beat [s]. Left out: the period of the tables that are repeated (After "
              "the table = repeat).",
              Range::positive());
  section.add("Probes", probes,
              "Probes that are compared from beat to beat: PROBE, or PROBE: FIELD of one with "
              "several fields. Required.");
  section.add("Tolerance", tolerance, Dimensions::none,
              "The beats have settled when in each of these probes a beat differs from the one "
              "before, at any time of the beat, by no more than this part of the beat's range "
              "(largest less smallest value).",
              Range::positive());
  section.add("Stop", stops,
              "Whether the run ends when the beats have settled; else it goes on to Time/End "
              "time.");
  section.require("Probes");
}
} // namespace Continua
