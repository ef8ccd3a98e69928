#ifndef continua_case_modal_parameters_h
#define continua_case_modal_parameters_h

#include <continua/base/words.h>

namespace Continua
{
/// The section Modal: which of a body's modes of vibration are sought.
struct ModalParameters
{
  enum class Which
  {
    lowest,
    highest
  };
  unsigned int n_modes = 6;
  double shift = 0.; ///< frequency [Hz] next to which they are sought
  Which which = Which::lowest;

  void read(ParameterSection section);
  bool highest() const { return which == Which::highest; }
};
} // namespace Continua

#endif
