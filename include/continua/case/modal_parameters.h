#ifndef continua_case_modal_parameters_h
#define continua_case_modal_parameters_h

#include <continua/base/parameter_section.h>

#include <string>

namespace Continua
{
/// The section Modal: which of a body's modes of vibration are sought.
struct ModalParameters
{
  unsigned int n_modes = 6;
  double shift = 0.;            ///< frequency [Hz] next to which they are sought
  std::string which = "lowest"; ///< or highest

  void read(ParameterSection section);
  bool highest() const { return which == "highest"; }
};
} // namespace Continua

#endif
