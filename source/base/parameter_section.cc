#include <continua/base/entry_pattern.h>
#include <continua/base/entry_type.h>
#include <continua/base/input_file.h>
#include <continua/base/nearest_name.h>
#include <continua/base/parameter_file.h>
#include <continua/base/parameter_section.h>
#include <continua/base/parameter_store.h>
#include <continua/base/quoted_name.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace Continua
{
namespace
{
/// How the handler is to hold the text of a user, where it is not as she wrote it. Throws
/// std::invalid_argument with the problem.
using Resolve = std::function<std::string(const std::string &)>;

/// Declares the entry, sets what the user gives, and takes the variable's value from the handler.
template <typename Value>
void declare_and_get(ParameterStore &store,
                     const ParameterSection &section,
                     const std::vector<std::string> &names,
                     const std::string &key,
                     const std::string &text,
                     const EntryType<Value> &type,
                     Value &variable,
                     const Resolve &resolve = {},
                     const bool is_input_file = false)
{
  const bool none_is_default = type.default_value.empty();
  const auto one_form = [read = type.read, write = type.write, none_is_default,
                         none = type.write(variable)](const std::string &value)
  { return value.empty() && none_is_default ? none : write(read(value)); };
  const ParameterStore::Declaration declaration{names,       key,           type.default_value,
                                                type.values, type.unit,     text,
                                                one_form,    is_input_file, type.number};
  store.declare(declaration,
                EntryPattern(type.values, type.may_be_empty || none_is_default, type.read));

  const ParameterText::Entry *const entry = store.given(names, key);
  // An empty text leaves a default of "none" as it is.
  if (entry != nullptr && !(entry->value().empty() && none_is_default))
  {
    try
    {
      if (entry->value().empty() && !type.may_be_empty)
        throw std::invalid_argument("there is no value");
      const std::string value = resolve ? resolve(entry->value()) : entry->value();
      // The handler would refuse the text, too, but not say why.
      type.read(value);
      store.set(declaration, value);
    }
    catch (const std::invalid_argument &exception)
    {
      section.refuse(key, exception.what(), type.remedy);
    }
  }
  const std::string value = store.value(declaration);
  if (!(value.empty() && none_is_default))
    variable = type.read(value);
}

/// Whether the section or one below it has an entry with a value.
bool sets_an_entry(const ParameterText::Section &section)
{
  return std::any_of(section.entries.begin(), section.entries.end(),
                     [](const auto &entry) { return !entry.value().empty(); }) ||
         std::any_of(section.sections.begin(), section.sections.end(), sets_an_entry);
}
} // namespace

ParameterSection::ParameterSection(ParameterFile &file, const std::vector<std::string> &path)
    : store(file.store.get()), names(path)
{
  store->declare_section(names);
}

void ParameterSection::add(const std::string &key,
                           double &value,
                           const Dimension &dimension,
                           const std::string &text,
                           const Range &range)
{
  declare_and_get(*store, *this, names, key, text, quantity_type(value, dimension, range), value);
}

void ParameterSection::add(const std::string &key,
                           std::vector<double> &values,
                           const Dimension &dimension,
                           const std::string &text,
                           const Range &range)
{
  declare_and_get(*store, *this, names, key, text, quantity_list_type(values, dimension, range),
                  values);
}

void ParameterSection::add(const std::string &key,
                           unsigned int &value,
                           const std::string &text,
                           const unsigned int lower,
                           const unsigned int upper)
{
  declare_and_get(*store, *this, names, key, text, integer_type(value, lower, upper), value);
}

void ParameterSection::add(const std::string &key, bool &value, const std::string &text)
{
  declare_and_get(*store, *this, names, key, text, truth_type(value), value);
}

void ParameterSection::add(const std::string &key, std::string &value, const std::string &text)
{
  declare_and_get(*store, *this, names, key, text, text_type(value), value);
}

void ParameterSection::add(const std::string &key,
                           std::vector<std::string> &values,
                           const std::string &text)
{
  declare_and_get(*store, *this, names, key, text, word_list_type(values), values);
}

void ParameterSection::add(const std::string &key,
                           std::vector<unsigned int> &values,
                           const std::string &text,
                           const unsigned int lower)
{
  declare_and_get(*store, *this, names, key, text, integer_list_type(values, lower), values);
}

void ParameterSection::add_choice(const std::string &key,
                                  std::string &value,
                                  const std::vector<std::string> &choices,
                                  const std::string &text)
{
  declare_and_get(*store, *this, names, key, text, choice_type(value, choices), value);
}

void ParameterSection::add_input_file(const std::string &key,
                                      std::string &path,
                                      const std::string &text)
{
  namespace filesystem = std::filesystem;
  const std::string naming_file = origin(key).file;
  const filesystem::path directory = naming_file == ParameterText::command_line
                                         ? filesystem::path()
                                         : filesystem::path(naming_file).parent_path();
  const bool is_given = given(key);
  const bool is_whole =
      is_given && (directory / without_quotes(store->given(names, key)->value())).is_absolute();
  // A printed file may stand in another directory, so the handler holds the whole path; messages
  // name the file from the working directory unless the user gives the whole path herself.
  EntryType<std::string> type = text_type(path);
  type.values = "file";
  type.remedy = naming_file == ParameterText::command_line
                    ? "Check its name; on the command line it is relative to the working directory"
                    : "Check its name; it is relative to the file that names it";
  type.read = [is_given, is_whole](const std::string &value)
  {
    const std::string file = without_quotes(value);
    return is_given && !is_whole
               ? filesystem::path(file).lexically_relative(filesystem::current_path()).string()
               : file;
  };
  type.write = [](const std::string &value) { return filesystem::path(value).filename().string(); };
  declare_and_get(
      *store, *this, names, key, text, type, path,
      [&directory](const std::string &name)
      {
        if (name.empty())
          return name;
        const filesystem::path named = (directory / without_quotes(name)).lexically_normal();
        check_input_file(named.string());
        return quoted_name(filesystem::absolute(named).lexically_normal().string(), "#");
      },
      is_given);
  if (is_given)
    store->add_input_file(path);
}

void ParameterSection::renamed(const std::string &old_key, const std::string &new_key)
{
  if (store->given(names, old_key) != nullptr)
    refuse(old_key, "this entry has a new name", "Write '" + new_key + "'");
}

bool ParameterSection::given(const std::string &key) const
{
  const ParameterText::Entry *const entry = store->given(names, key);
  return entry != nullptr && !entry->value().empty();
}

void ParameterSection::require(const std::string &key) const
{
  if (!given(key) && !store->is_documentation)
    refuse_missing("the entry '" + key + "' is missing", "Add 'set " + key + " = ...'");
}

Origin ParameterSection::origin(const std::string &key) const
{
  // The entry, or else its section, or else the nearest section around it that the user has, at
  // last the file.
  std::vector<std::string> path = names;
  if (const ParameterText::Entry *const entry = store->given(path, key))
    return entry->origin();
  while (store->text.find(path) == nullptr)
    path.pop_back();
  return store->text.find(path)->origin;
}

std::string ParameterSection::path() const
{
  return join_path(names);
}

std::string ParameterSection::name() const
{
  return names.empty() ? "" : names.back();
}

ParameterSection ParameterSection::subsection(const std::string &name)
{
  ParameterSection child = *this;
  child.names.push_back(name);
  store->declare_section(child.names);
  return child;
}

bool ParameterSection::has_subsection(const std::string &name) const
{
  const ParameterText::Section *const section = store->text.find(names);
  return section != nullptr && section->section(name) != nullptr;
}

bool ParameterSection::sets_in_subsection(const std::string &name) const
{
  const ParameterText::Section *const section = store->text.find(names);
  const ParameterText::Section *const child = section == nullptr ? nullptr : section->section(name);
  return child != nullptr && sets_an_entry(*child);
}

std::vector<std::string> ParameterSection::subsections() const
{
  std::vector<std::string> children;
  if (const ParameterText::Section *const section = store->text.find(names))
    for (const ParameterText::Section &child : section->sections)
      children.push_back(child.name);
  return children;
}

std::vector<std::pair<std::string, std::string>>
ParameterSection::add_free_entries(const std::string &text)
{
  std::vector<std::pair<std::string, std::string>> entries;
  if (const ParameterText::Section *const section = store->text.find(names))
    for (const ParameterText::Entry &entry : section->entries)
    {
      std::string value;
      add(entry.key, value, text);
      entries.emplace_back(entry.key, value);
    }
  return entries;
}

void ParameterSection::refuse_missing(const std::string &problem, const std::string &remedy) const
{
  throw MissingInput(origin(), path(), problem, remedy);
}

void ParameterSection::refuse_unknown_members(const std::vector<std::string> &members,
                                              const std::string &kind) const
{
  const ParameterText::Section *const section = store->text.find(names);
  if (section == nullptr)
    return;
  for (const ParameterText::Section &child : section->sections)
    if (std::find(members.begin(), members.end(), child.name) == members.end())
    {
      // As it can be written in a file and on the command line.
      const std::string special = "#/=";
      std::string list;
      for (const std::string &member : members)
        list += (list.empty() ? "'" : ", '") + quoted_name(member, special) + "'";
      const std::string nearest = nearest_name(child.name, members);
      throw InputError(
          child.origin, join_path(names) + (names.empty() ? "" : "/") + child.name,
          "there is no " + kind + " of this name",
          (nearest.empty() ? "" : "Did you mean '" + quoted_name(nearest, special) + "'? ") +
              ("There is " + list));
    }
}

void ParameterSection::refuse(const std::string &key,
                              const std::string &problem,
                              const std::string &remedy) const
{
  std::vector<std::string> full = names;
  if (!key.empty())
    full.push_back(key);
  throw InputError(origin(key), join_path(full), problem, remedy);
}
} // namespace Continua
