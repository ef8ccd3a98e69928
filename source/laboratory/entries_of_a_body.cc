#include <continua/laboratory/entries_of_a_body.h>

namespace Continua
{
void refuse_entries_of_a_body(const ParameterSection &root,
                              const GeneralParameters &general,
                              const std::string &reason_of_model,
                              const std::string &reason_of_discretisation,
                              const std::string &remedy_of_model)
{
  if (general.model != GeneralParameters().model)
    root.refuse("Model", reason_of_model, remedy_of_model);
  if (general.discretisation != GeneralParameters().discretisation)
    root.refuse("Discretisation", reason_of_discretisation, "Remove it");
}
} // namespace Continua
