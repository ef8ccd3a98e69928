#include <continua/program/rules_page.h>

#include <continua/base/joined.h>
#include <continua/case/rules/feature.h>
#include <continua/case/rules/rule.h>
#include <continua/program/analyses.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <vector>

namespace Continua
{
namespace
{
std::vector<Feature<2>> all_features()
{
  std::vector<Feature<2>> features;
  for (const FeatureGroup<2> &group : feature_groups<2>())
    features.insert(features.end(), group.features.begin(), group.features.end());
  return features;
}

bool has(const std::vector<std::string> &names, const std::string &name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The number of the first rule by which two features exclude each other, from 1; 0 if there is
/// none.
unsigned int rule_of(const std::string &first, const std::string &second)
{
  for (unsigned int number = 0; number < rules().size(); ++number)
  {
    const Rule &rule = rules()[number];
    if ((has(rule.refused, first) && has(rule.with, second)) ||
        (has(rule.refused, second) && has(rule.with, first)))
      return number + 1;
  }
  return 0;
}

/// "Flow/Time treatment" of "Flow/Time treatment = explicit".
std::string path_of(const std::string &entry)
{
  return entry.substr(0, entry.find(" = "));
}

/// Whether `analysis` is one that does not read the section of `other`.
bool leaves_out(const Feature<2> &analysis, const Feature<2> &other)
{
  const std::string prefix = "Analysis = ";
  if (analysis.entry.compare(0, prefix.size(), prefix) != 0)
    return false;
  const std::string section = other.entry.substr(0, other.entry.find('/'));
  if (section.size() == other.entry.size() ||
      has(analyses().row(analysis.entry.substr(prefix.size())).sections, section))
    return false;
  return std::any_of(analyses().rows().begin(), analyses().rows().end(),
                     [&section](const AnalysisRow &row) { return has(row.sections, section); });
}

/// Whether an entry stands with its value, "KEY = value".
bool has_value(const std::string &entry)
{
  return entry.find(" = ") != std::string::npos;
}

/// Whether no file can have both.
bool are_apart(const Feature<2> &first, const Feature<2> &second)
{
  const bool are_values_of_one_entry = path_of(first.entry) == path_of(second.entry) &&
                                       first.entry != second.entry &&
                                       first.entry.find('<') == std::string::npos &&
                                       has_value(first.entry) && has_value(second.entry);
  return are_values_of_one_entry || leaves_out(first, second) || leaves_out(second, first);
}

/// Text in a cell of a markdown table.
std::string cell(const std::string &text)
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

std::string as_sentence(std::string text)
{
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return cell(text) + ".";
}

std::string names_joined(const std::vector<std::string> &names)
{
  std::string text;
  for (const std::string &name : names)
  {
    const bool is_entry =
        name.compare(0, 4, "set ") == 0 || name.compare(0, 11, "subsection ") == 0;
    text += (text.empty() ? "" : ", ") + (is_entry ? "`" + name + "`" : name);
  }
  return text;
}

/// The features that some rule names together with another feature.
std::vector<Feature<2>> features_of_matrix()
{
  const std::vector<Feature<2>> all = all_features();
  std::vector<Feature<2>> result;
  for (const Feature<2> &feature : all)
    if (std::any_of(all.begin(), all.end(),
                    [&feature](const Feature<2> &other)
                    { return rule_of(feature.name, other.name) > 0; }))
      result.push_back(feature);
  return result;
}

void print_features(std::ostream &out)
{
  unsigned int number = 0;
  std::vector<std::string> numbered;
  for (const Feature<2> &feature : features_of_matrix())
    numbered.push_back(feature.name);
  for (const FeatureGroup<2> &group : feature_groups<2>())
  {
    out << "\n### " << group.title << "\n\n| | feature | entry |\n|---|---|---|\n";
    for (const Feature<2> &feature : group.features)
      out << "| " << (has(numbered, feature.name) ? std::to_string(++number) : "") << " | "
          << feature.name << " | `" << feature.entry << "` |\n";
  }
}

void print_matrix(std::ostream &out)
{
  const std::vector<Feature<2>> features = features_of_matrix();
  out << "\n| |";
  for (unsigned int column = 1; column < features.size(); ++column)
    out << ' ' << column << " |";
  out << "\n|---|";
  for (unsigned int column = 1; column < features.size(); ++column)
    out << "---|";
  out << '\n';
  for (unsigned int row = 1; row < features.size(); ++row)
  {
    out << "| " << row + 1 << "&nbsp;" << features[row].name << " |";
    for (unsigned int column = 0; column + 1 < features.size(); ++column)
    {
      const unsigned int rule =
          column < row ? rule_of(features[row].name, features[column].name) : 0;
      out << (rule > 0 ? " " + std::to_string(rule)
              : column < row && are_apart(features[row], features[column]) ? std::string(" –")
                                                                           : std::string())
          << " |";
    }
    out << '\n';
  }
}

void print_sentences(std::ostream &out)
{
  out << "\n| | this | does not go with | because | remedy |\n|---|---|---|---|---|\n";
  for (unsigned int number = 0; number < rules().size(); ++number)
  {
    const Rule &rule = rules()[number];
    out << "| " << number + 1 << " | " << names_joined(rule.refused) << " | " << joined(rule.with)
        << " | " << as_sentence(rule.reason) << " | " << as_sentence(rule.remedy) << " |\n";
  }
}

void print_page(std::ostream &out)
{
  out << "# What goes with what\n\n"
         "The program wrote this page (`continua --print-rules`) from the table by which it checks "
         "each parameter file. A file that has two features which exclude each other is refused "
         "before the run, with the sentence of the table, the line and the entry. Further checks "
         "depend on numbers, on the mesh or on what one boundary has; the pages of the manual name "
         "them. A test makes files of two features each, where one small body can have both, and "
         "compares what the program says, and of which entry, with this page; rules that no such "
         "file shows have tests of their own.\n\n"
         "## The features\n\n"
         "An entry turns a feature on. `<region>` and `<name>` stand for a region and for a "
         "boundary.\n";
  print_features(out);
  out << "\n## The matrix\n\n"
         "A number is that of the sentence below by which the two exclude each other. A dash: no "
         "file can have both, since they are values of one entry, or the analysis does not read "
         "the section of the other. An empty field: the two go together.\n";
  print_matrix(out);
  out << "\n## The sentences\n\n"
         "`set` and `subsection` are entries and sections that the file gives, and of which the "
         "run would make no use.\n";
  print_sentences(out);
}

void print_json(std::ostream &out)
{
  nlohmann::ordered_json features = nlohmann::ordered_json::array(),
                         table = nlohmann::ordered_json::array(),
                         apart = nlohmann::ordered_json::array();
  for (const FeatureGroup<2> &group : feature_groups<2>())
    for (const Feature<2> &feature : group.features)
      features.push_back(
          {{"name", feature.name}, {"group", group.title}, {"entry", feature.entry}});
  for (const Rule &rule : rules())
    table.push_back({{"refused", rule.refused},
                     {"with", rule.with},
                     {"reason", rule.reason},
                     {"remedy", rule.remedy}});
  const std::vector<Feature<2>> all = all_features();
  for (unsigned int second = 0; second < all.size(); ++second)
    for (unsigned int first = 0; first < second; ++first)
      if (are_apart(all[first], all[second]))
        apart.push_back({all[first].name, all[second].name});
  out << nlohmann::ordered_json{{"features", features}, {"rules", table}, {"apart", apart}}.dump(2)
      << '\n';
}
} // namespace

void print_rules(std::ostream &out, const ParameterFile::Style style)
{
  if (style == ParameterFile::Style::json)
    print_json(out);
  else
    print_page(out);
}
} // namespace Continua
