#include <continua/program/unknown_names.h>

#include <continua/base/nearest_name.h>
#include <continua/program/parameter_catalogue.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace Continua
{
namespace
{
/// A section of the catalogue, or all members of a family as one.
struct KnownSection
{
  std::set<std::string> keys;
  std::map<std::string, KnownSection> sections;

  bool knows(const std::string &key) const { return keys.count(key) > 0 || has_wildcard(keys); }

  /// Null if there is none of that name.
  const KnownSection *section(const std::string &name) const
  {
    if (const auto found = sections.find(name); found != sections.end())
      return &found->second;
    const auto family = std::find_if(sections.begin(), sections.end(),
                                     [](const auto &row) { return is_wildcard(row.first); });
    return family == sections.end() ? nullptr : &family->second;
  }

  /// "<region>" stands for the names that a case gives.
  static bool is_wildcard(const std::string &name) { return name.compare(0, 1, "<") == 0; }
  static bool has_wildcard(const std::set<std::string> &names)
  {
    return std::any_of(names.begin(), names.end(), is_wildcard);
  }
};

KnownSection known_names()
{
  KnownSection top;
  const auto add = [&top](const CataloguePart &part)
  {
    for (const CatalogueEntry &entry : part.entries)
    {
      KnownSection *section = &top;
      for (const std::string &name : entry.section)
        section = &section->sections[name];
      section->keys.insert(entry.key);
    }
  };
  for (const CatalogueSection &section : parameter_catalogue())
  {
    add(section.shared);
    for (const CataloguePart &part : section.types)
      add(part);
  }
  return top;
}

std::string suggestion(const std::string &name, const std::vector<std::string> &candidates)
{
  const std::string nearest = nearest_name(name, candidates);
  if (!nearest.empty())
    return "Did you mean '" + nearest + "'?";
  std::string list;
  for (const std::string &candidate : candidates)
    list += (list.empty() ? "'" : ", '") + candidate + "'";
  return list.empty() ? "Remove it" : "There is here " + list;
}

/// What no analysis knows: the path and the message of each.
using UnknownNames = std::vector<std::pair<std::string, std::string>>;

void find_unknown(const ParameterText::Section &section,
                  const KnownSection &known,
                  const std::string &path,
                  UnknownNames &unknown)
{
  const auto report = [&](const Origin &origin, const std::string &name, const std::string &what,
                          const std::vector<std::string> &candidates)
  {
    std::string remedy = suggestion(name, candidates);
    if (origin.file == ParameterText::command_line && nearest_name(name, candidates).empty())
      remedy += ". A name that has a '/' or a '=' stands between double quotes";
    unknown.emplace_back(path + name,
                         InputError(origin, path + name, "unknown " + what, remedy).what());
  };
  for (const ParameterText::Entry &entry : section.entries)
    if (!known.knows(entry.key))
      report(entry.origin(), entry.key, "entry", {known.keys.begin(), known.keys.end()});
  std::vector<std::string> sections;
  for (const auto &row : known.sections)
    sections.push_back(row.first);
  for (const ParameterText::Section &child : section.sections)
    if (const KnownSection *const known_child = known.section(child.name))
      find_unknown(child, *known_child, path + child.name + "/", unknown);
    else
      report(child.origin, child.name, "subsection", sections);
}
} // namespace

void refuse_unknown_names(const ParameterFile &file, const InputError &error)
{
  // The catalogue takes longer than all else.
  if (!file.has_undeclared())
    return;
  UnknownNames unknown;
  find_unknown(file.text().root(), known_names(), "", unknown);
  const std::string said = error.what();
  std::string text;
  for (const auto &[path, message] : unknown)
  {
    // Whoever found it knows more: a new name, or the entries of the type that was chosen.
    if (said.find("'" + path + "'") != std::string::npos)
      return;
    text += (text.empty() ? "" : "\n") + message;
  }
  if (!text.empty())
    throw InputError({}, "", text, "");
}
} // namespace Continua
