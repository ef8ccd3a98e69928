#include <continua/program/documentation.h>

#include <continua/base/parameter_text.h>
#include <continua/materials/model.h>
#include <continua/program/parameter_catalogue.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <sstream>

namespace Continua
{
namespace
{
using Entries = std::vector<CatalogueEntry>;

/// Calls `print` for the entries of each subsection, in the order in which these first occur.
void for_each_subsection(
    const Entries &entries,
    const std::function<void(const std::vector<std::string> &, const Entries &)> &print)
{
  std::vector<std::vector<std::string>> done;
  for (const CatalogueEntry &first : entries)
    if (std::find(done.begin(), done.end(), first.section) == done.end())
    {
      done.push_back(first.section);
      Entries together;
      std::copy_if(entries.begin(), entries.end(), std::back_inserter(together),
                   [&first](const CatalogueEntry &entry)
                   { return entry.section == first.section; });
      print(first.section, together);
    }
}

/// " Only with Model = axisymmetric"; empty where every model will do.
std::string restriction(const CataloguePart &part)
{
  if (part.type.empty() || part.models.size() == model_names().size())
    return "";
  std::string text;
  for (const std::string &model : part.models)
    text += (text.empty() ? " Only with Model = " : ", ") + model;
  return text + ".";
}

std::string sentence(const std::string &text)
{
  return text.empty() || text.back() == '.' ? text : text + ".";
}

void print_comment(std::ostream &out, const std::string &indent, const std::string &text)
{
  constexpr std::size_t width = 100;
  std::istringstream words(text);
  std::string line = indent + "#", word;
  while (words >> word)
  {
    if (line.size() + 1 + word.size() > width)
    {
      out << line << '\n';
      line = indent + "#";
    }
    line += " " + word;
  }
  out << line << '\n';
}

std::string with_condition(const CatalogueEntry &entry)
{
  return entry.condition.empty() ? "" : "Only with " + entry.condition + ". ";
}

void print_prm(std::ostream &out, const CatalogueSection &section, const CataloguePart &part)
{
  print_comment(out, "",
                section.title +
                    (part.type.empty() ? "" : ", " + section.type_key + " = " + part.type) + ": " +
                    sentence(part.description) + restriction(part));
  for (const std::string &line : part.names)
    print_comment(out, "", line);
  for_each_subsection(
      part.entries,
      [&](const std::vector<std::string> &path, const Entries &entries)
      {
        std::string indent;
        for (const std::string &name : path)
        {
          out << indent << "subsection " << name << '\n';
          indent += "  ";
        }
        for (const CatalogueEntry &entry : entries)
        {
          print_comment(out, indent,
                        with_condition(entry) + entry.text + " (" + entry.values + ")");
          out << indent << "set " << entry.key << " ="
              << (entry.default_value.empty() ? "" : " " + entry.default_value) << '\n';
        }
        while (!indent.empty())
        {
          indent.resize(indent.size() - 2);
          out << indent << "end\n";
        }
      });
  out << '\n';
}

/// Text in a cell of a markdown table, in which nothing is to be taken as markup.
std::string plain(const std::string &text)
{
  std::string escaped;
  for (const char letter : text)
  {
    if (std::string("\\|<>*_`$[]").find(letter) != std::string::npos)
      escaped += '\\';
    escaped += letter;
  }
  return escaped;
}

std::string code(const std::string &text)
{
  std::string escaped;
  for (const char letter : text)
    escaped += letter == '|' ? "\\|" : std::string(1, letter);
  return text.empty() ? "" : "`" + escaped + "`";
}

/// Where the text explains that word of an entry, as in "CHOICE - what it is"; npos if it does not.
std::size_t explanation_of(const std::string &word, const std::string &text)
{
  const std::string wanted = word + " - ";
  for (std::size_t at = text.find(wanted); at != std::string::npos; at = text.find(wanted, at + 1))
    if (at == 0 || (at > 1 && text[at - 1] == ' ' &&
                    std::string(":.;").find(text[at - 2]) != std::string::npos))
      return at;
  return std::string::npos;
}

/// The text in a cell, with a line for each choice that it explains.
std::string with_choices(const CatalogueEntry &entry)
{
  std::map<std::size_t, std::string> choices; ///< by their place in the text
  std::istringstream values(entry.values);
  for (std::string word; std::getline(values >> std::ws, word, ',');)
    if (const std::size_t at = explanation_of(word, entry.text); at != std::string::npos)
      choices[at] = word;
  if (choices.size() < 2)
    return plain(entry.text);
  std::string result = plain(entry.text.substr(0, choices.begin()->first));
  for (auto choice = choices.begin(); choice != choices.end(); ++choice)
  {
    const auto &[at, word] = *choice;
    const std::size_t begin = at + word.size() + 3, end = std::next(choice) == choices.end()
                                                              ? entry.text.size()
                                                              : std::next(choice)->first - 1;
    result += "<br>• " + code(word) + ": " + plain(entry.text.substr(begin, end - begin));
  }
  return result;
}

void print_markdown(std::ostream &out, const CataloguePart &part)
{
  if (!part.type.empty())
    out << "### " << part.type << '\n' << '\n';
  out << plain(sentence(part.description) + restriction(part)) << '\n' << '\n';
  for (const std::string &line : part.names)
    out << "* " << plain(line) << '\n';
  if (!part.names.empty())
    out << '\n';
  if (part.entries.empty())
    out << "No entries of its own.\n\n";
  for_each_subsection(part.entries,
                      [&](const std::vector<std::string> &path, const Entries &entries)
                      {
                        if (!path.empty())
                          out << "In " << code(join_path(path)) << ":\n\n";
                        out << "| Entry | Default | Values | Meaning |\n|---|---|---|---|\n";
                        for (const CatalogueEntry &entry : entries)
                          out << "| " << code(entry.key) << " | " << code(entry.default_value)
                              << " | " << plain(entry.values) << " | "
                              << plain(with_condition(entry)) << with_choices(entry) << " |\n";
                        out << '\n';
                      });
}

void add_json(nlohmann::ordered_json &list,
              const CatalogueSection &section,
              const CataloguePart &part)
{
  for (const CatalogueEntry &entry : part.entries)
  {
    std::vector<std::string> path = entry.section;
    path.push_back(entry.key);
    list.push_back({{"section", section.title},
                    {"type", part.type},
                    {"path", join_path(path)},
                    {"default", entry.default_value},
                    {"values", entry.values},
                    {"unit", entry.unit},
                    {"condition", entry.condition},
                    {"text", entry.text}});
  }
}
} // namespace

void print_documentation(std::ostream &out, const ParameterFile::Style style)
{
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  if (style == ParameterFile::Style::prm)
    out << "# Every entry that exists, with its default. This is no case: the types of a section "
           "follow one another.\n\n";
  if (style == ParameterFile::Style::markdown)
    out << "# Every entry\n\nAn entry without a default is left out unless its text says that it "
           "is required. Names in angle brackets stand for those of a family's members.\n\n";
  for (const CatalogueSection &section : parameter_catalogue())
  {
    if (style == ParameterFile::Style::prm)
      print_prm(out, section, section.shared);
    else if (style == ParameterFile::Style::markdown)
    {
      out << "## " << section.title << '\n' << '\n';
      print_markdown(out, section.shared);
    }
    else
      add_json(list, section, section.shared);
    for (const CataloguePart &part : section.types)
      if (style == ParameterFile::Style::prm)
        print_prm(out, section, part);
      else if (style == ParameterFile::Style::markdown)
        print_markdown(out, part);
      else
        add_json(list, section, part);
  }
  if (style == ParameterFile::Style::json)
    out << list.dump(2) << '\n';
}
} // namespace Continua
