#ifndef continua_base_parameter_printer_h
#define continua_base_parameter_printer_h

#include <continua/base/parameter_store.h>

#include <map>
#include <ostream>
#include <string>

namespace Continua
{
/// What ParameterFile::print() writes, one function for each of its styles. Internal to it.

/// In the layout of deal.II's ParameterHandler, but an entry that the user has not set stands as a
/// comment: some entries are refused where they have no meaning, were it their default. Of the
/// documentation all is set. `copies`: as in ParameterFile::print().
void print_prm(std::ostream &out,
               const ParameterStore &store,
               const std::map<std::string, std::string> &copies);
void print_json(std::ostream &out, const ParameterStore &store);
void print_markdown(std::ostream &out, const ParameterStore &store);
} // namespace Continua

#endif
