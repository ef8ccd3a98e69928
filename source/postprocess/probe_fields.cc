#include <continua/postprocess/probe_fields.h>

#include <continua/base/name_choice.h>
#include <continua/base/units.h>

namespace Continua
{
const std::string volume_change = "volume change";

template <int dim>
std::vector<FieldComponent> forces()
{
  const char *const names[] = {"force x", "force y", "force z"};
  std::vector<FieldComponent> components;
  for (unsigned int d = 0; d < dim; ++d)
    components.push_back({names[d], "Pa"});
  return components;
}

bool is_force(const std::string &field)
{
  return field == "force" || field.compare(0, 6, "force ") == 0;
}

const std::string cavity_pressure = "cavity pressure", cavity_volume = "cavity volume";

bool is_of_cavity(const std::string &field)
{
  return field == cavity_pressure || field == cavity_volume;
}

bool is_average(const std::string &field)
{
  return field == "time-averaged wall shear stress" || field == "oscillatory shear index" ||
         field == "relative residence time";
}

bool can_change_sign(const std::string &field)
{
  for (const char *const family :
       {"velocity ", "radial velocity", "axial velocity", "pressure", "stress ", "hoop stress",
        "wall shear stress", "vorticity ", "Q criterion"})
    if (field.compare(0, std::string(family).size(), family) == 0)
      return true;
  return false;
}

std::vector<FieldComponent> expand(const ParameterSection &section,
                                   const std::string &word,
                                   const std::vector<FieldComponent> &fields)
{
  std::vector<FieldComponent> components;
  for (const FieldComponent &field : fields)
    if (field.name == word)
      return {field};
    else if (field.name.compare(0, word.size() + 1, word + " ") == 0)
      components.push_back(field);
  if (components.empty())
  {
    std::vector<std::string> names;
    names.reserve(fields.size());
    for (const FieldComponent &field : fields)
      names.push_back(field.name);
    section.refuse("Fields", "there is no field '" + word + "'",
                   choices(word, names) +
                       "; without the component: all components of a vector or tensor");
  }
  return components;
}

std::string unit_of_integral(const std::string &unit, const Model model, const bool over_volume)
{
  Dimension dimension;
  unit_factor(unit, dimension);
  const bool is_plane = model == Model::plane_strain || model == Model::plane_stress;
  dimension.length += (over_volume ? 3 : 2) - (is_plane ? 1 : 0);
  return dimension.unit();
}

template std::vector<FieldComponent> forces<2>();
template std::vector<FieldComponent> forces<3>();
} // namespace Continua
