#ifndef continua_postprocess_probe_fields_h
#define continua_postprocess_probe_fields_h

#include <continua/base/parameter_section.h>
#include <continua/continuum/continuum_solver.h>
#include <continua/materials/model.h>

#include <string>
#include <vector>

namespace Continua
{
/// What a volume has beside the fields: by how much it has grown.
extern const std::string volume_change;
/// What the surface of a cavity has beside the fields.
extern const std::string cavity_pressure, cavity_volume;

/// Whether the name is 'force' or one of its components.
bool is_force(const std::string &field);
bool is_of_cavity(const std::string &field);
/// Whether it is a mean over time.
bool is_average(const std::string &field);
/// Whether the field has a sign, and is evaluated point by point.
bool can_change_sign(const std::string &field);
/// What boundaries have beside the fields: the force of the body on them, by component.
template <int dim>
std::vector<FieldComponent> forces();
/// The field of that name, or all components of the vector or tensor of that name. Throws
/// InputError of the entry Fields.
std::vector<FieldComponent> expand(const ParameterSection &section,
                                   const std::string &word,
                                   const std::vector<FieldComponent> &fields);
/// The unit of a field integrated over a boundary, a section or a volume; in the plane, of a depth
/// of 1 m, over a line or an area.
std::string unit_of_integral(const std::string &unit, Model model, bool over_volume);
} // namespace Continua

#endif
