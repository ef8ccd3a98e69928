#include <continua/base/input_file.h>
#include <continua/base/parameter_file.h>
#include <continua/base/parameter_printer.h>
#include <continua/base/parameter_store.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <stdexcept>

namespace Continua
{
namespace
{
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

/// All of an input file. Throws InputError if it can no longer be read.
std::string content_of(const std::string &file)
{
  try
  {
    return read_input_file(file);
  }
  catch (const std::invalid_argument &problem)
  {
    throw InputError({file, 0}, "", problem.what(), "Put the file back, and leave it as it is");
  }
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

ParameterFile
ParameterFile::changed(const std::vector<std::pair<std::string, std::string>> &settings) const
{
  ParameterFile result;
  result.store->is_documentation = store->is_documentation;
  result.store->text = store->text;
  for (const auto &[path, value] : settings)
    result.store->text.set(path + "=" + value);
  return result;
}

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

bool ParameterFile::has_undeclared() const
{
  return !store->unknown().empty();
}

void ParameterFile::pass_over_impossible()
{
  store->passes_over_impossible = true;
}

std::string ParameterFile::changes_that_exclude(const std::string &path_of_entry)
{
  if (!store->passes_over_impossible)
    return "";
  for (const ParameterStore::Declaration &declaration : store->declarations)
    if (join_path(declaration.path()) == path_of_entry)
    {
      const ParameterText::Entry *const entry = store->given(declaration.section, declaration.key);
      if (entry == nullptr || entry->origin().file == ParameterText::command_line)
        return "";
      store->passed_over.push_back(declaration.path());
      return store->text.changes();
    }
  return "";
}

const ParameterText &ParameterFile::text() const
{
  return store->text;
}

std::vector<std::string> ParameterFile::input_files() const
{
  std::vector<std::string> files = store->text.files();
  files.insert(files.end(), store->input_files.begin(), store->input_files.end());
  return files;
}

void ParameterFile::print(std::ostream &out,
                          const Style style,
                          const std::map<std::string, std::string> &copies) const
{
  switch (style)
  {
  case Style::prm:
    print_prm(out, *store, copies);
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
    const std::string path = join_path(entry.path());
    if (std::none_of(left_out.begin(), left_out.end(),
                     [&path](const std::string &place) { return lies_in(path, place); }))
      lines.push_back(path + "=" + entry.one_form(store->value(entry)) + "\n");
  }
  // A table is part of the case by what it says, not by its name.
  for (const std::string &name : store->input_files)
  {
    lines.push_back("content of " + std::filesystem::path(name).filename().string() + "=" +
                    hash(content_of(name)) + "\n");
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
