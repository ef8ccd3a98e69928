#include <continua/base/nearest_name.h>
#include <continua/base/parameter_store.h>
#include <continua/base/quoted_name.h>

#include <algorithm>

namespace Continua
{
namespace
{
std::string quoted_list(const std::vector<std::string> &names)
{
  std::string list;
  for (const std::string &name : names)
    list += (list.empty() ? "'" : ", '") + quoted_name(name, "#/=") + "'";
  return list;
}
} // namespace

std::vector<std::string> ParameterStore::Declaration::path() const
{
  std::vector<std::string> names = section;
  names.push_back(key);
  return names;
}

std::string ParameterStore::Declaration::documentation() const
{
  // Some texts name a unit themselves, in the place where it is read best.
  if (unit.empty() || text.find('[') != std::string::npos)
    return text;
  return text + (text.empty() ? "[" : " [") + unit + "]";
}

std::string ParameterStore::Declaration::full_documentation() const
{
  Declaration described = *this;
  if (values != "text" && values != "number")
    described.text += " (" + values + ")";
  return described.documentation();
}

void ParameterStore::enter(const std::vector<std::string> &section)
{
  for (const std::string &name : section)
    handler.enter_subsection(name);
}

void ParameterStore::leave(const std::vector<std::string> &section)
{
  for (std::size_t i = 0; i < section.size(); ++i)
    handler.leave_subsection();
}

void ParameterStore::declare_section(const std::vector<std::string> &path)
{
  std::vector<std::string> ancestor;
  for (std::size_t i = 0; i <= path.size(); ++i)
  {
    if (!is_declared(ancestor))
      sections.push_back(ancestor);
    if (i < path.size())
      ancestor.push_back(path[i]);
  }
  enter(path);
  leave(path);
}

void ParameterStore::declare(const Declaration &declaration,
                             const dealii::Patterns::PatternBase &pattern)
{
  declare_section(declaration.section);
  const auto existing =
      std::find_if(declarations.begin(), declarations.end(),
                   [&declaration](const auto &other) {
                     return other.section == declaration.section && other.key == declaration.key;
                   });
  if (existing == declarations.end())
    declarations.push_back(declaration);
  else
    *existing = declaration;

  enter(declaration.section);
  handler.declare_entry(declaration.key, declaration.default_value, pattern,
                        declaration.full_documentation());
  leave(declaration.section);
}

void ParameterStore::set(const Declaration &declaration, const std::string &value)
{
  enter(declaration.section);
  handler.set(declaration.key, value);
  leave(declaration.section);
}

std::string ParameterStore::value(const Declaration &declaration) const
{
  return handler.get(declaration.section, declaration.key);
}

void ParameterStore::add_input_file(const std::string &path)
{
  const auto contains = [&path](const std::vector<std::string> &files)
  { return std::find(files.begin(), files.end(), path) != files.end(); };
  if (!contains(input_files) && !contains(text.files()))
    input_files.push_back(path);
}

const ParameterText::Entry *ParameterStore::given(const std::vector<std::string> &section,
                                                  const std::string &key) const
{
  const ParameterText::Section *const found = text.find(section);
  return found == nullptr ? nullptr : found->entry(key);
}

bool ParameterStore::is_declared(const std::vector<std::string> &path) const
{
  return std::find(sections.begin(), sections.end(), path) != sections.end();
}

bool ParameterStore::is_declared(const std::vector<std::string> &path, const std::string &key) const
{
  return std::any_of(declarations.begin(), declarations.end(),
                     [&](const Declaration &d) { return d.section == path && d.key == key; });
}

std::vector<std::string> ParameterStore::keys(const std::vector<std::string> &path) const
{
  std::vector<std::string> names;
  for (const Declaration &declaration : declarations)
    if (declaration.section == path)
      names.push_back(declaration.key);
  return names;
}

std::vector<std::string> ParameterStore::subsections(const std::vector<std::string> &path) const
{
  std::vector<std::string> names;
  for (const std::vector<std::string> &section : sections)
    if (section.size() == path.size() + 1 && std::equal(path.begin(), path.end(), section.begin()))
      names.push_back(section.back());
  return names;
}

std::vector<InputError> ParameterStore::unknown() const
{
  std::vector<InputError> errors;
  find_unknown(text.root(), {}, errors);
  return errors;
}

void ParameterStore::find_unknown(const ParameterText::Section &section,
                                  const std::vector<std::string> &path,
                                  std::vector<InputError> &errors) const
{
  const std::string prefix = path.empty() ? "" : join_path(path) + "/";
  for (const ParameterText::Entry &entry : section.entries)
    if (!is_declared(path, entry.key))
      errors.emplace_back(entry.origin(), prefix + entry.key, "unknown entry",
                          suggestion(path, entry.key));
  for (const ParameterText::Section &child : section.sections)
  {
    std::vector<std::string> child_path = path;
    child_path.push_back(child.name);
    if (is_declared(child_path))
      find_unknown(child, child_path, errors);
    else
      errors.emplace_back(child.origin, prefix + child.name, "unknown subsection",
                          suggestion(path, child.name));
  }
}

std::string ParameterStore::suggestion(const std::vector<std::string> &path,
                                       const std::string &name) const
{
  const std::vector<std::string> own_keys = keys(path);
  const std::vector<std::string> own_sections = subsections(path);
  // The right name as the wrong kind of thing.
  if (std::find(own_keys.begin(), own_keys.end(), name) != own_keys.end())
    return "Write 'set " + name + " = VALUE': it is an entry, not a subsection";
  if (std::find(own_sections.begin(), own_sections.end(), name) != own_sections.end())
    return "Write 'subsection " + name + "': it is a subsection, not an entry";

  std::vector<std::string> names = own_keys;
  names.insert(names.end(), own_sections.begin(), own_sections.end());
  const std::string nearest = nearest_name(name, names);
  if (!nearest.empty())
    return "Did you mean '" + quoted_name(nearest, "#/=") + "'?";

  // The right name in the wrong place.
  for (const Declaration &declaration : declarations)
    if (declaration.key == name)
      return declaration.section.empty()
                 ? "There is a '" + name + "' outside all subsections"
                 : "There is a '" + name + "' in '" + join_path(declaration.section) + "'";

  if (names.empty())
    return "Nothing can be set here";
  std::string there_is = "There is here";
  if (!own_keys.empty())
    there_is += " " + quoted_list(own_keys);
  if (!own_sections.empty())
    there_is +=
        std::string(own_keys.empty() ? "" : ";") + " the subsections " + quoted_list(own_sections);
  return there_is;
}
} // namespace Continua
