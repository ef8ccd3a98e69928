#include <continua/case/resonance_parameters.h>

namespace Continua
{
void ResonanceParameters::read(ParameterSection section)
{
  section.add("Lowest frequency", lowest, Dimensions::frequency,
              "Lowest natural frequency |s|/(2 pi) [Hz] of a resonance exp(s t) that is sought.",
              Range::positive());
  section.add("Highest frequency", highest, Dimensions::frequency,
              "Highest natural frequency [Hz] of a resonance that is sought.", Range::positive());
  section.add("Largest damping ratio", largest_damping_ratio, Dimensions::none,
              "What decays faster, with a larger -Re s/|s|, is no resonance [1].",
              {0., 0.99, true, false});
  section.add("Tolerance", tolerance, Dimensions::none,
              "The responses are computed at more and more frequencies until the rational "
              "approximation, whose poles are the first guesses, differs at new frequencies by no "
              "more than this part of the largest response [1]. The resonances themselves are "
              "exact whatever it is.",
              Range::positive());
  section.add("Most frequencies", most_frequencies,
              "At which responses are computed; then the search goes on with a warning [1].", 8);
  section.add("Loads in a region", loads_in_a_region,
              "Random loads in each region whose responses are computed, beside a unit load at "
              "each boundary that may have one [1]. A resonance that none of them excites is not "
              "found.",
              1);
  section.add("Count", counts,
              "Whether the number of resonances is found a second time, by the winding of the "
              "determinant round the band.");
  for (const char *key : {"Lowest frequency", "Highest frequency"})
    section.require(key);
  if (lowest >= highest)
    section.refuse("Lowest frequency", "it is not below the highest frequency", "Give a lower one");
}
} // namespace Continua
