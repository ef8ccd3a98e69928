#ifndef continua_laboratory_artery_fit_parameters_h
#define continua_laboratory_artery_fit_parameters_h

#include <continua/base/parameter_section.h>
#include <continua/laboratory/artery_model.h>

#include <string>
#include <vector>

namespace Continua
{
/// The sections `Artery fit` and `Materials`: an inflation-extension test of an artery, the ring
/// without load, its layers and what is sought of them.
struct ArteryFitParameters
{
  InflationTest test;
  TubeSection ring;                     ///< without load; layers as the file describes them
  std::vector<std::string> layer_names; ///< from the inside
  std::vector<ArteryParameter> parameters;
  double diameter_noise = 0.; ///< standard deviation [m]; 0: found from the residuals
  double force_noise = 0.;    ///< the same [N]
  unsigned int n_starts = 1;  ///< of the search

  /// Declares and reads the section `Artery fit`; throws InputError.
  void read(ParameterSection section);
  /// Reads the layers' materials and takes from them where the search begins; throws InputError.
  void read_layers(ParameterSection materials, ParameterSection section);

private:
  /// What the subsection of a parameter says.
  struct Request
  {
    std::vector<std::string> entries; ///< "media/Fibre stiffness"
    FitParameter fit;
  };
  std::vector<Request> requests;

  void read_parameter(ParameterSection section);
  void take_parameter(const Request &request, const ParameterSection &section);
};
} // namespace Continua

#endif
