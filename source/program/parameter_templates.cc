#include <continua/base/atomic_file.h>
#include <continua/base/embedded_file.h>
#include <continua/base/input_error.h>
#include <continua/base/nearest_name.h>
#include <continua/program/parameter_templates.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace Continua
{
namespace
{
/// The files of parameter_files/new, sorted by name.
const EmbeddedFile template_files[] = {
#include <continua/program/parameter_templates.inc>
};

bool ends_with(const std::string &text, const std::string &ending)
{
  return text.size() >= ending.size() &&
         text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

std::string with_spaces(std::string name)
{
  std::replace(name.begin(), name.end(), '-', ' ');
  return name;
}

std::vector<ParameterTemplate> make_templates()
{
  const std::string ending = ".prm";
  std::vector<ParameterTemplate> result;
  for (const EmbeddedFile &file : template_files)
    if (ends_with(file.name, ending))
    {
      const std::string stem =
          std::string(file.name, std::string(file.name).size() - ending.size());
      ParameterTemplate entry;
      entry.name = with_spaces(stem);
      entry.text = file.text;
      const std::string mark = "# ";
      entry.description = entry.text.substr(mark.size(), entry.text.find('\n') - mark.size());
      for (const EmbeddedFile &other : template_files)
        if (!ends_with(other.name, ending) &&
            std::filesystem::path(other.name).stem().string() == stem)
          entry.files.emplace_back(other.name, other.text);
      result.push_back(entry);
    }
  return result;
}

/// The name of a file that a template reads, beside a parameter file with this stem: my.geo for my,
/// but the template's name for a stem that an entry might not give back.
std::string own_name_of(const std::string &name, const std::string &stem)
{
  const bool is_plain =
      std::all_of(stem.begin(), stem.end(),
                  [](const unsigned char letter)
                  { return std::isalnum(letter) != 0 || letter == '-' || letter == '_'; });
  return is_plain ? stem + std::filesystem::path(name).extension().string() : name;
}

/// The text with each occurrence of the name replaced by the other one.
std::string with_name(std::string text, const std::string &name, const std::string &other)
{
  for (std::size_t at = text.find(name); at != std::string::npos;
       at = text.find(name, at + other.size()))
    text.replace(at, name.size(), other);
  return text;
}

const ParameterTemplate &find_template(const std::string &name)
{
  std::vector<std::string> names;
  for (const ParameterTemplate &entry : parameter_templates())
  {
    if (entry.name == with_spaces(name))
      return entry;
    names.push_back(entry.name);
  }
  const std::string nearest = nearest_name(with_spaces(name), names);
  throw InputError({"command line", 0}, "--new " + name, "there is no such template",
                   (nearest.empty() ? "" : "Did you mean '" + nearest + "'? ") +
                       "continua --new lists them");
}
} // namespace

const std::vector<ParameterTemplate> &parameter_templates()
{
  static const std::vector<ParameterTemplate> templates = make_templates();
  return templates;
}

void print_templates(std::ostream &out)
{
  std::size_t width = 0;
  for (const ParameterTemplate &entry : parameter_templates())
    width = std::max(width, entry.name.size());
  out << "Templates of parameter files; continua --new NAME FILE.prm writes one:\n\n";
  for (const ParameterTemplate &entry : parameter_templates())
    out << "  " << entry.name << std::string(width + 2 - entry.name.size(), ' ')
        << entry.description << "\n";
}

void print_template(const std::string &name, std::ostream &out, std::ostream &notes)
{
  for (const ParameterTemplate &entry : parameter_templates())
    for (const auto &[file, text] : entry.files)
      if (file == name)
      {
        out << text;
        return;
      }
  const ParameterTemplate &entry = find_template(name);
  out << entry.text;
  for (const auto &file : entry.files)
    notes << "The file reads " << file.first << " of its own folder; to make it: continua --new "
          << file.first << " > " << file.first << "\n";
}

std::vector<std::string> write_template(const std::string &name, const std::string &file)
{
  const ParameterTemplate &entry = find_template(name);
  require_folder_of(file);
  const std::filesystem::path path = file;
  std::vector<std::pair<std::string, std::string>> files = {{file, entry.text}};
  for (const auto &[other, text] : entry.files)
  {
    // Named after the parameter file, so that two files of one template can stand in a folder.
    const std::string own_name = own_name_of(other, path.stem().string());
    files.front().second = with_name(files.front().second, other, own_name);
    files.emplace_back((path.parent_path() / own_name).string(), text);
  }
  for (std::size_t i = 1; i < files.size(); ++i)
    if (files[i].first == file)
      throw InputError({file, 0}, "", "the template '" + entry.name + "' reads a file of this name",
                       "Name the parameter file otherwise, such as my.prm");
  for (const auto &one : files)
    if (std::filesystem::exists(std::filesystem::symlink_status(one.first)))
      throw InputError({one.first, 0}, "", "the file exists, and --new overwrites nothing",
                       "Name another file, or remove this one");
  std::vector<std::string> written;
  for (const auto &[path, text] : files)
  {
    write_file_atomically(path, text);
    written.push_back(path);
  }
  return written;
}
} // namespace Continua
