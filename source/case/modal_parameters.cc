#include <continua/case/modal_parameters.h>

namespace Continua
{
void ModalParameters::read(ParameterSection section)
{
  section.add("Number of modes", n_modes, "Modes that are sought [1].", 1);
  add_choice(section, "Which", which, {{"lowest", Which::lowest}, {"highest", Which::highest}},
             "lowest - those nearest to the Shift; highest - those of the mesh that "
             "vibrate fastest, of the cell-wise discretisation.");
  section.add("Shift", shift, Dimensions::frequency,
              "The modes nearest to this frequency are sought: at 0 the lowest. A body that can "
              "move freely needs one between 0 and its first mode.",
              Range::not_negative());
  if (highest() && section.given("Shift"))
    section.refuse("Shift", "the highest modes are sought without a shift", "Remove the entry");
}
} // namespace Continua
