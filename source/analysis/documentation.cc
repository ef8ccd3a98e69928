#include <continua/analysis/documentation.h>

#include <continua/analysis/case.h>
#include <continua/boundary/boundary_condition.h>
#include <continua/materials/material.h>
#include <continua/mesh/geometry.h>

namespace Continua
{
void print_documentation(std::ostream &out, ParameterFile::Style)
{
  out << "";
}
} // namespace Continua
