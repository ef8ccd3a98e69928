#include <continua/base/parameter_file.h>
#include <continua/base/parameter_store.h>

#include <deal.II/base/utilities.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace Continua
{
namespace
{
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

void print_markdown(std::ostream &out, const ParameterStore &store)
{
  bool first = true;
  for (const std::vector<std::string> &section : store.sections)
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

void print_json(std::ostream &out, const ParameterStore &store)
{
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ParameterStore::Declaration &entry : store.declarations)
  {
    std::vector<std::string> path = entry.section;
    path.push_back(entry.key);
    nlohmann::ordered_json item;
    item["path"] = join_path(path);
    item["value"] = entry.value;
    item["default"] = entry.default_value;
    item["values"] = entry.values;
    item["unit"] = entry.unit;
    item["text"] = entry.documentation();
    list.push_back(item);
  }
  out << list.dump(2) << '\n';
}

/// As ParameterHandler does, but what the user has not set stands as a comment: some entries are
/// refused where they have no meaning, were it their default. Of the documentation all is set.
void print_prm(std::ostream &out, ParameterStore &store)
{
  std::stringstream printed;
  store.handler.print_parameters(printed, dealii::ParameterHandler::PRM |
                                              dealii::ParameterHandler::KeepDeclarationOrder);
  std::vector<std::string> path;
  for (std::string line; std::getline(printed, line);)
  {
    const std::size_t start = std::min(line.find_first_not_of(' '), line.size());
    const auto begins_with = [&](const std::string &word)
    { return line.compare(start, word.size(), word) == 0; };
    if (begins_with("subsection "))
      path.push_back(dealii::Utilities::trim(line.substr(start + std::strlen("subsection "))));
    else if (line.substr(start) == "end")
      path.pop_back();
    else if (begins_with("set ") && !store.is_documentation)
    {
      const std::size_t key = start + std::strlen("set ");
      const ParameterText::Section *const section = store.text.find(path);
      const ParameterText::Entry *const entry =
          section == nullptr
              ? nullptr
              : section->entry(dealii::Utilities::trim(line.substr(key, line.find('=') - key)));
      if (entry == nullptr || entry->value().empty())
        line.insert(start, "# ");
    }
    out << line << '\n';
  }
}

/// FNV-1a with 64 bit: G. Fowler, L. C. Noll, K.-P. Vo, as in IETF RFC 9923.
std::string hash(const std::string &text)
{
  std::uint64_t value = 14695981039346656037ULL;
  for (const unsigned char byte : text)
    value = (value ^ byte) * 1099511628211ULL;
  std::string digits(16, '0');
  for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit, value /= 16)
    *digit = "0123456789abcdef"[value % 16];
  return digits;
}

/// Whether `path` is `place` or lies in it.
bool lies_in(const std::string &path, std::string place)
{
  while (!place.empty() && place.back() == '/')
    place.pop_back();
  return path.compare(0, place.size(), place) == 0 &&
         (path.size() == place.size() || path[place.size()] == '/');
}
} // namespace

ParameterFile::ParameterFile() : store(std::make_unique<ParameterStore>())
{
  store->is_documentation = true;
}

ParameterFile::ParameterFile(const std::string &path, const std::vector<std::string> &overrides)
    : store(std::make_unique<ParameterStore>())
{
  store->is_documentation = path.empty();
  store->text = ParameterText(path, overrides);
}

ParameterFile::~ParameterFile() = default;
ParameterFile::ParameterFile(ParameterFile &&) noexcept = default;
ParameterFile &ParameterFile::operator=(ParameterFile &&) noexcept = default;

ParameterSection ParameterFile::root()
{
  return ParameterSection(*this, {});
}

void ParameterFile::refuse_unknown() const
{
  const std::vector<InputError> errors = store->unknown();
  if (errors.empty())
    return;
  std::string text;
  for (const InputError &error : errors)
    text += (text.empty() ? "" : "\n") + std::string(error.what());
  throw InputError({}, "", text, "");
}

std::vector<std::string> ParameterFile::input_files() const
{
  std::vector<std::string> files = store->text.files();
  files.insert(files.end(), store->input_files.begin(), store->input_files.end());
  return files;
}

void ParameterFile::print(std::ostream &out, const Style style) const
{
  switch (style)
  {
  case Style::prm:
    print_prm(out, *store);
    break;
  case Style::json:
    print_json(out, *store);
    break;
  case Style::markdown:
    print_markdown(out, *store);
    break;
  }
}

std::string ParameterFile::identity_text(const std::vector<std::string> &left_out) const
{
  std::vector<std::string> lines;
  for (const ParameterStore::Declaration &entry : store->declarations)
  {
    std::vector<std::string> names = entry.section;
    names.push_back(entry.key);
    const std::string path = join_path(names);
    if (std::none_of(left_out.begin(), left_out.end(),
                     [&path](const std::string &place) { return lies_in(path, place); }))
      lines.push_back(path + "=" + entry.resolved + "\n");
  }
  // A table is part of the case by what it says, not by its name.
  for (const std::string &name : store->input_files)
  {
    std::ifstream file(name, std::ios::binary);
    std::ostringstream content;
    content << file.rdbuf();
    lines.push_back("content of " + std::filesystem::path(name).filename().string() + "=" +
                    hash(content.str()) + "\n");
  }
  std::sort(lines.begin(), lines.end());
  std::string text;
  for (const std::string &line : lines)
    text += line;
  return text;
}

std::string ParameterFile::identity(const std::vector<std::string> &left_out) const
{
  return hash(identity_text(left_out));
}
} // namespace Continua
