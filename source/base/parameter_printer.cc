#include <continua/base/parameter_printer.h>
#include <continua/base/quoted_name.h>

#include <deal.II/base/utilities.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace Continua
{
namespace
{
using Path = std::vector<std::string>;
/// Names of input files by their absolute paths.
using Names = std::map<std::string, std::string>;

/// A cell of a markdown table.
std::string cell(const std::string &text)
{
  std::string escaped;
  for (const char letter : text)
  {
    if (letter == '|')
      escaped += '\\';
    escaped += letter;
  }
  return escaped;
}

std::string code_cell(const std::string &text)
{
  return text.empty() ? "" : "`" + cell(text) + "`";
}

std::string blanks(const std::size_t n)
{
  return std::string(n, ' ');
}

/// Whether the line sets the entry. One without a value and without a default is not set, nor one
/// with which the printed file would be refused.
bool stands_as_set(const ParameterStore &store, const ParameterStore::Declaration &entry)
{
  if (store.is_documentation)
    return true;
  if (std::find(store.passed_over.begin(), store.passed_over.end(), entry.path()) !=
      store.passed_over.end())
    return false;
  const ParameterText::Entry *const given = store.given(entry.section, entry.key);
  return given != nullptr && !(given->value().empty() && entry.default_value.empty());
}

/// The value as the line holds it: a path may need another name.
std::string printed_value(const ParameterStore &store,
                          const ParameterStore::Declaration &entry,
                          const Names &copies)
{
  const std::string value = store.value(entry);
  if (!entry.is_input_file)
    return value;
  // Other readers of the file know no quotes.
  const std::string path = without_quotes(value);
  if (path == value && can_be_a_value(value))
    return value;
  if (const auto copy = copies.find(path); copy != copies.end())
    return copy->second;
  const std::string relative =
      std::filesystem::path(path).lexically_relative(std::filesystem::current_path()).string();
  if (quoted_name(relative, "#") == relative && can_be_a_value(relative))
    return relative;
  if (!can_be_a_value(value))
    throw InputError(store.given(entry.section, entry.key)->origin(), join_path(entry.path()),
                     "no parameter file can hold the path '" + path + "': it is no line of UTF-8",
                     "Rename the folder, or call the program in the folder of the file");
  return value;
}

void print_prm_entries(std::ostream &out,
                       const ParameterStore &store,
                       const Names &copies,
                       const std::vector<const ParameterStore::Declaration *> &entries,
                       const std::string &indent)
{
  constexpr unsigned int width = 78;
  std::size_t longest_key = 0, longest_value = 0;
  const auto key_of = [](const ParameterStore::Declaration &entry)
  { return quoted_name(entry.key, "#="); };
  std::vector<std::string> values;
  for (const ParameterStore::Declaration *const entry : entries)
  {
    values.push_back(printed_value(store, *entry, copies));
    longest_key = std::max(longest_key, key_of(*entry).size());
    longest_value = std::max(longest_value, values.back().size());
  }
  bool first = true;
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    const ParameterStore::Declaration *const entry = entries[i];
    if (const std::string text = entry->full_documentation(); !text.empty())
    {
      out << (first ? "" : "\n");
      first = false;
      for (const std::string &line :
           dealii::Utilities::break_text_into_lines(text, width - indent.size() - 2))
        out << indent << "# " << line << '\n';
    }
    const std::string &value = values[i];
    out << indent << (stands_as_set(store, *entry) ? "" : "# ") << "set " << key_of(*entry)
        << blanks(longest_key - key_of(*entry).size() + 1) << "= " << value;
    if (value != entry->default_value)
      out << blanks(longest_value - value.size() + 1) << "# default: " << entry->default_value;
    out << '\n';
  }
}

/// A section that the user has not opened is there for its entries only.
bool is_printed(const ParameterStore &store, const Path &section)
{
  return store.text.find(section) != nullptr ||
         std::any_of(store.declarations.begin(), store.declarations.end(),
                     [&section](const ParameterStore::Declaration &entry)
                     {
                       return entry.section.size() >= section.size() &&
                              std::equal(section.begin(), section.end(), entry.section.begin());
                     });
}

void print_prm_section(std::ostream &out,
                       const ParameterStore &store,
                       const Names &copies,
                       const Path &section)
{
  const std::string indent = blanks(2 * section.size());
  std::vector<const ParameterStore::Declaration *> entries;
  for (const ParameterStore::Declaration &entry : store.declarations)
    if (entry.section == section)
      entries.push_back(&entry);
  print_prm_entries(out, store, copies, entries, indent);

  bool first = true;
  for (const std::string &name : store.subsections(section))
  {
    Path child = section;
    child.push_back(name);
    if (!is_printed(store, child))
      continue;
    out << (first && !entries.empty() ? "\n\n" : "") << indent << "subsection "
        << quoted_name(name, "#") << '\n';
    first = false;
    print_prm_section(out, store, copies, child);
    out << indent << "end\n\n" << (section.empty() ? "\n" : "");
  }
}
} // namespace

void print_prm(std::ostream &out, const ParameterStore &store, const Names &copies)
{
  out << "# Listing of Parameters\n# ---------------------\n";
  print_prm_section(out, store, copies, {});
}

void print_json(std::ostream &out, const ParameterStore &store)
{
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ParameterStore::Declaration &entry : store.declarations)
  {
    nlohmann::ordered_json item;
    item["path"] = join_path(entry.path());
    item["value"] = store.value(entry);
    item["default"] = entry.default_value;
    item["values"] = entry.values;
    item["unit"] = entry.unit;
    item["text"] = entry.documentation();
    list.push_back(item);
  }
  // The name of a file may have any bytes.
  out << list.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}

void print_markdown(std::ostream &out, const ParameterStore &store)
{
  bool first = true;
  for (const Path &section : store.sections)
  {
    if (store.keys(section).empty())
      continue;
    out << (first ? "" : "\n") << "## " << (section.empty() ? "Top level" : join_path(section))
        << "\n\n| Entry | Default | Values | Meaning |\n|---|---|---|---|\n";
    first = false;
    for (const ParameterStore::Declaration &entry : store.declarations)
      if (entry.section == section)
        out << "| " << code_cell(entry.key) << " | " << code_cell(entry.default_value) << " | "
            << cell(entry.values) << " | " << cell(entry.documentation()) << " |\n";
  }
}
} // namespace Continua
