#ifndef continua_laboratory_entries_of_a_body_h
#define continua_laboratory_entries_of_a_body_h

#include <continua/base/parameter_section.h>
#include <continua/case/case.h>

#include <string>

namespace Continua
{
/// Refuses `Model` and `Discretisation` in an analysis that has no body, for these reasons. Their
/// defaults pass: they stand in every file that --print-parameters writes. Throws InputError.
void refuse_entries_of_a_body(const ParameterSection &root,
                              const GeneralParameters &general,
                              const std::string &reason_of_model,
                              const std::string &reason_of_discretisation,
                              const std::string &remedy_of_model = "Remove it");
} // namespace Continua

#endif
