#include <continua/materials/prony_fit_parameters.h>

namespace Continua
{
void PronyFitParameters::read(ParameterSection &section)
{
  section.add("Branches", n_branches,
              "Branches of the fitted Prony series beside its spring [1]; 0 takes as few as meet "
              "the fit tolerance.",
              0, 40);
  section.add(
      "Lowest frequency", lowest_frequency, Dimensions::frequency,
      "Lower end of the band of the fit; 0: 1/(2 pi) of the inverse of the run's end time, but at "
      "most a tenth of the upper end.",
      Range::not_negative());
  section.add("Highest frequency", highest_frequency, Dimensions::frequency,
              "Upper end of the band of the fit; 0: the frequency of ten time steps a period.",
              Range::not_negative());
  section.add("Fit tolerance", tolerance, Dimensions::none,
              "Largest relative error of the fitted complex modulus over the band.",
              Range::positive());
}
} // namespace Continua
