#include <continua/base/input_file.h>
#include <continua/base/nearest_name.h>
#include <continua/base/parameter_text.h>
#include <continua/base/quoted_name.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <stdexcept>

namespace Continua
{
namespace
{
/// `a` holds against `b` if a's file includes, over however many steps, b's.
bool overrides(const ParameterText::Setting &a, const ParameterText::Setting &b)
{
  return a.inclusions.size() < b.inclusions.size() &&
         std::equal(a.inclusions.begin(), a.inclusions.end(), b.inclusions.begin());
}

std::string place(const Origin &origin)
{
  return origin.file + (origin.line > 0 ? ":" + std::to_string(origin.line) : "");
}

/// Whether an `unset` takes back anything in the section.
bool takes_back(const ParameterText::Setting &unset, const ParameterText::Section &section)
{
  const auto is_taken_back = [&unset](const ParameterText::Setting &setting)
  { return overrides(unset, setting); };
  return std::any_of(section.entries.begin(), section.entries.end(),
                     [&](const auto &entry) {
                       return std::any_of(entry.settings.begin(), entry.settings.end(),
                                          is_taken_back);
                     }) ||
         std::any_of(section.sections.begin(), section.sections.end(),
                     [&](const auto &child) { return takes_back(unset, child); });
}

/// What files set in the section.
std::vector<std::string> names_in_files(const ParameterText::Section &section)
{
  const auto is_in_file = [](const ParameterText::Setting &setting)
  { return !setting.inclusions.empty() && !setting.is_unset; };
  std::vector<std::string> names;
  for (const ParameterText::Entry &entry : section.entries)
    if (std::any_of(entry.settings.begin(), entry.settings.end(), is_in_file))
      names.push_back(entry.key);
  for (const ParameterText::Section &child : section.sections)
    if (std::any_of(child.openings.begin(), child.openings.end(), is_in_file))
      names.push_back(child.name);
  return names;
}

/// Throws InputError for an `unset` that takes nothing back.
void check_unsets(const ParameterText::Section &section, const std::string &path)
{
  const auto refuse = [&section](const ParameterText::Setting &unset, const std::string &path_of_it,
                                 const std::string &name)
  {
    if (!unset.inclusions.empty())
      throw InputError(unset.origin, path_of_it,
                       "there is nothing to unset: no included file sets it",
                       "Remove the line, or correct the name");
    const std::string nearest = nearest_name(name, names_in_files(section));
    throw InputError(unset.origin, path_of_it,
                     "there is nothing to unset: the file does not set it",
                     nearest.empty() ? "Remove the option, or correct the name. A name that has a "
                                       "'/' stands between double quotes"
                                     : "Did you mean '" + nearest + "'?");
  };
  for (const ParameterText::Entry &entry : section.entries)
    for (const ParameterText::Setting &setting : entry.settings)
      if (setting.is_unset &&
          std::none_of(entry.settings.begin(), entry.settings.end(),
                       [&setting](const auto &other) { return overrides(setting, other); }))
        refuse(setting, path + entry.key, entry.key);
  for (const ParameterText::Section &child : section.sections)
  {
    for (const ParameterText::Setting &unset : child.unsets)
      if (!takes_back(unset, child))
        refuse(unset, path + child.name, child.name);
    check_unsets(child, path + child.name + "/");
  }
}

/// Drops what an `unset` takes back in the section, and the sections in it that this leaves empty.
void take_back(const ParameterText::Setting &unset, ParameterText::Section &section)
{
  const auto drop = [&unset](std::vector<ParameterText::Setting> &settings)
  {
    settings.erase(std::remove_if(settings.begin(), settings.end(),
                                  [&unset](const auto &setting)
                                  { return overrides(unset, setting); }),
                   settings.end());
  };
  drop(section.openings);
  for (ParameterText::Entry &entry : section.entries)
    drop(entry.settings);
  for (ParameterText::Section &child : section.sections)
    take_back(unset, child);
  section.sections.erase(
      std::remove_if(section.sections.begin(), section.sections.end(),
                     [](const auto &child)
                     {
                       return child.openings.empty() && child.sections.empty() &&
                              std::all_of(child.entries.begin(), child.entries.end(),
                                          [](const auto &entry) { return entry.settings.empty(); });
                     }),
      section.sections.end());
}

/// Leaves the entry the one setting that holds, or none if it is unset.
void settle(ParameterText::Entry &entry, const std::string &path)
{
  std::vector<ParameterText::Setting> highest;
  for (const ParameterText::Setting &setting : entry.settings)
    if (std::none_of(entry.settings.begin(), entry.settings.end(),
                     [&setting](const auto &other) { return overrides(other, setting); }))
      highest.push_back(setting);
  const auto words = [](const ParameterText::Setting &setting)
  { return setting.is_unset ? "unset" : "'" + setting.value + "'"; };
  for (const ParameterText::Setting &setting : highest)
    if (words(setting) != words(highest.front()))
      throw InputError(setting.origin, path + entry.key,
                       "is " + words(setting) + " here, but " + words(highest.front()) + " in " +
                           place(highest.front().origin) + ", and neither file includes the other",
                       "Set it in the file that includes both, or in one of them only");
  entry.settings.clear();
  if (!highest.empty() && !highest.front().is_unset)
    entry.settings.push_back(highest.front());
}

/// The same for every entry of the section; a section that an `unset` leaves empty goes, unless the
/// file of the `unset` opens it itself.
void settle(ParameterText::Section &section, const std::string &path)
{
  for (ParameterText::Section &child : section.sections)
  {
    for (const ParameterText::Setting &unset : child.unsets)
      take_back(unset, child);
    settle(child, path + child.name + "/");
  }
  for (ParameterText::Entry &entry : section.entries)
    settle(entry, path);
  section.entries.erase(std::remove_if(section.entries.begin(), section.entries.end(),
                                       [](const auto &entry) { return entry.settings.empty(); }),
                        section.entries.end());
  section.sections.erase(std::remove_if(section.sections.begin(), section.sections.end(),
                                        [](const auto &child) {
                                          return child.openings.empty() && child.entries.empty() &&
                                                 child.sections.empty();
                                        }),
                         section.sections.end());
}

void add_setting(ParameterText::Section &section,
                 const std::string &path,
                 const std::string &key,
                 const ParameterText::Setting &setting)
{
  ParameterText::Entry &entry = section.get_entry(key);
  for (const ParameterText::Setting &earlier : entry.settings)
    if (earlier.inclusions == setting.inclusions)
      throw InputError(setting.origin, path,
                       std::string("is ") +
                           (setting.is_unset == earlier.is_unset
                                ? std::string(setting.is_unset ? "unset" : "set") + " a second time"
                                : "set and unset in one file") +
                           "; the first is in line " + std::to_string(earlier.origin.line),
                       "Remove one of the two");
  entry.settings.push_back(setting);
}

/// What nobody needs, but a damaged file may have; each level, file and line takes time or memory.
constexpr std::size_t most_levels = 50;
constexpr unsigned int most_inclusions = 1000;
constexpr unsigned int most_statements = 40000;

/// Logical lines: without comments, joined at backslashes, blanks collapsed; each with the number
/// of its first line.
std::vector<std::pair<unsigned int, std::string>>
logical_lines(const std::vector<std::string> &input)
{
  std::vector<std::pair<unsigned int, std::string>> lines;
  bool continued = false;
  for (std::size_t i = 0; i < input.size(); ++i)
  {
    std::string line = collapse_blanks(input[i].substr(0, find_unquoted(input[i], "#")));
    if (!continued)
      lines.emplace_back(static_cast<unsigned int>(i + 1), "");
    continued = !line.empty() && line.back() == '\\';
    if (continued)
      line.pop_back(); // a blank before the backslash stays
    lines.back().second += line;
  }
  for (auto &[number, text] : lines)
    text = collapse_blanks(text);
  return lines;
}

/// The line in quotes, for a message. Of an included file it is not shown: one that is named by
/// mistake may hold a secret.
std::string shown(const std::string &line, const bool is_included)
{
  constexpr std::size_t longest = 80;
  if (is_included)
    return "this line";
  return "'" + (line.size() > longest ? line.substr(0, longest) + "..." : line) + "'";
}

void refuse_deep(const Origin &place, const std::size_t n_levels)
{
  if (n_levels > most_levels)
    throw InputError(place, "",
                     "there are more than " + std::to_string(most_levels) +
                         " sections or included files one inside the other",
                     "Close the sections with 'end', and remove the includes that are too many");
}
} // namespace

const std::string ParameterText::command_line = "command line (--set)";

std::string collapse_blanks(const std::string &text)
{
  const std::vector<bool> quoted = quoted_letters(text);
  std::string result;
  bool has_blank = false;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (!quoted[i] && std::isspace(static_cast<unsigned char>(text[i])) != 0)
      has_blank = true;
    else
    {
      if (has_blank && !result.empty())
        result += ' ';
      has_blank = false;
      result += text[i];
    }
  return result;
}

bool can_be_a_value(const std::string &text)
{
  return find_unquoted(text, "#") == std::string::npos && collapse_blanks(text) == text &&
         (text.empty() || text.back() != '\\') && problem_of_text(text).empty();
}

std::string join_path(const std::vector<std::string> &names)
{
  std::string path;
  for (const std::string &name : names)
    path += (path.empty() ? "" : "/") + quoted_name(name, "#/=");
  return path;
}

const ParameterText::Entry *ParameterText::Section::entry(const std::string &key) const
{
  const auto found =
      std::find_if(entries.begin(), entries.end(), [&key](const Entry &e) { return e.key == key; });
  return found == entries.end() ? nullptr : &*found;
}

const ParameterText::Section *ParameterText::Section::section(const std::string &section_name) const
{
  const auto found = std::find_if(sections.begin(), sections.end(),
                                  [&](const Section &s) { return s.name == section_name; });
  return found == sections.end() ? nullptr : &*found;
}

ParameterText::Entry &ParameterText::Section::get_entry(const std::string &key)
{
  for (Entry &existing : entries)
    if (existing.key == key)
      return existing;
  entries.push_back({key, {}});
  return entries.back();
}

ParameterText::Section &ParameterText::Section::get_section(const std::string &section_name,
                                                            const Origin &place)
{
  for (Section &existing : sections)
    if (existing.name == section_name)
      return existing;
  sections.push_back({section_name, place, {}, {}, {}, {}});
  return sections.back();
}

ParameterText::ParameterText(const std::string &path, const std::vector<std::string> &overrides)
{
  top.origin = {path, 0};
  std::vector<std::string> stack;
  if (!path.empty())
    read(path, {}, top, {n_inclusions++}, stack);
  for (const std::string &text : overrides)
  {
    const bool is_set = find_unquoted(text, "=") != std::string::npos;
    change_list +=
        (change_list.empty() ? "" : ", ") + std::string(is_set ? "--set " : "--unset ") + text;
    if (is_set)
      set_from_command_line(text);
    else
      unset_from_command_line(text);
  }
  check_unsets(top, "");
  settle(top, "");
}

void ParameterText::set(const std::string &override_text)
{
  set_from_command_line(override_text);
  settle(top, "");
}

const ParameterText::Section *ParameterText::find(const std::vector<std::string> &path) const
{
  const Section *section = &top;
  for (const std::string &name : path)
    if (section != nullptr)
      section = section->section(name);
  return section;
}

void ParameterText::read(const std::string &path,
                         const Origin &includer,
                         Section &section,
                         const std::vector<unsigned int> &inclusions,
                         std::vector<std::string> &stack)
{
  std::error_code no_access; // what cannot be looked at counts as missing
  const std::string canonical = std::filesystem::weakly_canonical(path, no_access).string();
  if (std::find(stack.begin(), stack.end(), canonical) != stack.end())
    throw InputError(includer, "include",
                     "'" + path + "' includes itself, directly or through others",
                     "Remove one of the includes");
  refuse_deep(includer, stack.size());
  if (n_inclusions > most_inclusions)
    throw InputError(includer, "include",
                     "there are more than " + std::to_string(most_inclusions) + " includes",
                     "Include each file once");
  std::string content;
  try
  {
    content = read_input_file(path, "parameter file");
  }
  catch (const std::invalid_argument &problem)
  {
    throw InputError(includer, includer.file.empty() ? "" : "include", problem.what(),
                     includer.file.empty()
                         ? "Check its name; it is relative to the working directory"
                         : "Check its name; it is relative to the including file");
  }
  if (std::find(files_read.begin(), files_read.end(), path) == files_read.end())
    files_read.push_back(path);
  stack.push_back(canonical);

  // Sections that are open; an ancestor stays where it is in memory while a descendant grows.
  std::vector<Section *> open{&section};
  std::vector<Origin> opened_at;
  std::vector<std::string> names;
  const bool is_included = stack.size() > 1;
  for (const auto &[number, line] : logical_lines(lines_of_text(content, path)))
  {
    if (line.empty())
      continue;
    const Origin here{path, number};
    if (++n_statements > most_statements)
      throw InputError(here, "",
                       "there are more than " + std::to_string(most_statements) + " statements",
                       "Leave out what is not needed");
    // It would continue the next line wherever the text is written again.
    if (line.back() == '\\')
      throw InputError(here, "",
                       (is_included ? "this line" : "the line " + shown(line, false)) +
                           " ends with a backslash that no further line follows",
                       "Write one backslash at the end of each line that goes on, and none at the "
                       "end of the last");
    const std::size_t blank = line.find(' ');
    const std::string keyword = line.substr(0, blank);
    const std::string rest = blank == std::string::npos ? "" : line.substr(blank + 1);
    if (keyword == "subsection" || keyword == "SUBSECTION")
    {
      if (rest.empty())
        throw InputError(here, "", "a subsection has no name",
                         "Write 'subsection NAME'. A name with a '#' stands between double quotes: "
                         "'subsection \"#1\"'");
      open.push_back(&open.back()->get_section(without_quotes(rest), here));
      open.back()->openings.push_back({"", here, inclusions});
      opened_at.push_back(here);
      names.push_back(without_quotes(rest));
      refuse_deep(here, names.size());
    }
    else if (line == "end" || line == "END")
    {
      if (opened_at.empty())
        throw InputError(here, "", "this 'end' closes no subsection",
                         "Remove it, or look for a 'subsection' that is missing above");
      open.pop_back();
      opened_at.pop_back();
      names.pop_back();
    }
    else if (keyword == "set" || keyword == "SET")
    {
      const std::size_t equals = find_unquoted(rest, "=");
      const std::string key = without_quotes(collapse_blanks(rest.substr(0, equals)));
      if (equals == std::string::npos || key.empty())
        throw InputError(here, "",
                         shown(line, is_included) +
                             (equals == std::string::npos ? " has no '='" : " has no key"),
                         "Write 'set KEY = VALUE'");
      std::vector<std::string> entry_path = names;
      entry_path.push_back(key);
      add_setting(*open.back(), join_path(entry_path), key,
                  {collapse_blanks(rest.substr(equals + 1)), here, inclusions});
    }
    else if (keyword == "unset" || keyword == "UNSET")
    {
      const std::string word = "subsection ";
      const bool is_section = rest.compare(0, word.size(), word) == 0;
      const std::string name = without_quotes(is_section ? rest.substr(word.size()) : rest);
      const bool has_equals = find_unquoted(rest, "=") != std::string::npos;
      if (name.empty() || name == "subsection" || has_equals)
        throw InputError(here, "",
                         shown(line, is_included) + (has_equals ? " has an '='" : " has no name"),
                         "Write 'unset KEY' or 'unset subsection NAME'");
      const Setting unset{"", here, inclusions, true};
      std::vector<std::string> entry_path = names;
      entry_path.push_back(name);
      if (is_section)
        open.back()->get_section(name, here).unsets.push_back(unset);
      else
        add_setting(*open.back(), join_path(entry_path), name, unset);
    }
    else if (keyword == "include" || keyword == "INCLUDE")
    {
      if (rest.empty())
        throw InputError(here, "include", "there is no file name", "Write 'include FILE'");
      std::vector<unsigned int> deeper = inclusions;
      deeper.push_back(n_inclusions++);
      const std::filesystem::path directory = std::filesystem::path(path).parent_path();
      read((directory / without_quotes(rest)).lexically_normal().string(), here, *open.back(),
           deeper, stack);
    }
    else
      throw InputError(here, "", shown(line, is_included) + " cannot be understood",
                       "A line is 'subsection NAME', 'set KEY = VALUE', 'end', 'include FILE', "
                       "'unset KEY', 'unset subsection NAME' or a comment that starts with '#'");
  }
  if (!opened_at.empty())
    throw InputError(opened_at.back(), join_path(names),
                     "this subsection is not closed before the file ends",
                     "Write 'end' after its last entry");
  stack.pop_back();
}

namespace
{
/// "A/B/C" of the command line as names. Throws InputError.
std::vector<std::string>
names_of(const std::string &path, const Origin &here, const std::string &remedy)
{
  if (const std::string problem = problem_of_text(path); !problem.empty())
    throw InputError(here, "", "'" + path + "' " + problem, "Write it in plain UTF-8");
  std::vector<std::string> names;
  for (const std::string &part : split_unquoted(path, '/'))
    names.push_back(without_quotes(collapse_blanks(part)));
  if (std::any_of(names.begin(), names.end(), [](const auto &name) { return name.empty(); }))
    throw InputError(here, "", "'" + path + "' has an empty name", remedy);
  refuse_deep(here, names.size());
  return names;
}
} // namespace

void ParameterText::take(Entry &entry, const std::string &path, const Setting &setting)
{
  const auto earlier = std::find_if(entry.settings.begin(), entry.settings.end(),
                                    [](const Setting &other) { return other.inclusions.empty(); });
  if (earlier == entry.settings.end())
  {
    entry.settings.push_back(setting);
    return;
  }
  note_list.push_back("the command line " +
                      (earlier->is_unset ? "takes out '" + path + "'"
                                         : "sets '" + path + "' to '" + earlier->value + "'") +
                      " and then " +
                      (setting.is_unset    ? "takes it out"
                       : earlier->is_unset ? "sets it to '" + setting.value + "'"
                                           : "to '" + setting.value + "'") +
                      "; the last one holds");
  *earlier = setting;
}

void ParameterText::set_from_command_line(const std::string &override_text)
{
  const Origin here{command_line, 0};
  const std::size_t equals = find_unquoted(override_text, "=");
  if (equals == std::string::npos)
    throw InputError(here, "", "'" + override_text + "' has no '='",
                     "Write --set \"Section/Key=value\"");
  const std::vector<std::string> names =
      names_of(override_text.substr(0, equals), here, "Write --set \"Section/Key=value\"");
  const std::string value = collapse_blanks(override_text.substr(equals + 1));
  if (const std::string problem = problem_of_text(value); !problem.empty())
    throw InputError(here, "", "'" + override_text + "' " + problem, "Write it in plain UTF-8");
  // What a file could not hold could not be printed for a later run either.
  if (!can_be_a_value(value))
    throw InputError(here, join_path(names),
                     "the value '" + value + "' holds a '#' or ends with a backslash",
                     "Leave it out: in a parameter file it would start a comment or continue "
                     "the line. A name with a '#' stands between double quotes");
  Section *section = &top;
  for (std::size_t i = 0; i + 1 < names.size(); ++i)
    section = &section->get_section(names[i], here);
  take(section->get_entry(names.back()), join_path(names), {value, here, {}});
}

void ParameterText::unset_from_command_line(const std::string &path)
{
  const Origin here{"command line (--unset)", 0};
  const std::vector<std::string> names =
      names_of(path, here, "Write --unset \"Section/Key\" or --unset \"Section\"");
  Section *parent = &top;
  for (std::size_t i = 0; i + 1 < names.size(); ++i)
    parent = &parent->get_section(names[i], here);
  const Setting unset{"", here, {}, true};
  if (parent->section(names.back()) != nullptr)
    parent->get_section(names.back(), here).unsets.push_back(unset);
  else
    take(parent->get_entry(names.back()), join_path(names), unset);
}
} // namespace Continua
