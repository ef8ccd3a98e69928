#include <continua/analysis/analysis_table.h>

#include <continua/base/quantity_names.h>
#include <continua/base/rank_agreement.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <exception>

namespace Continua
{
namespace
{
/// What `make` makes of the file. If the file expects a quantity that is impossible, and is valid
/// without the changes of the command line, it is made again without this expectation.
/// `check_plain` reads the file without the changes and throws InputError.
template <typename Make, typename Check>
auto passing_over_impossible(ParameterFile &file, const Make &make, const Check &check_plain)
{
  try
  {
    return make(file);
  }
  catch (const ImpossibleQuantity &)
  {
    if (file.text().changes().empty())
      throw;
    const std::exception_ptr impossible = std::current_exception();
    try
    {
      check_plain();
    }
    catch (const ImpossibleQuantity &)
    {
      // This one is misspelt: the user is to see it, and not what the changes exclude.
      throw;
    }
    catch (const InputError &)
    {
      // Without the changes the file is no valid input and says nothing.
      std::rethrow_exception(impossible);
    }
  }
  file.pass_over_impossible();
  return make(file);
}

bool reads(const AnalysisRow &row, const std::string &section)
{
  return std::find(row.sections.begin(), row.sections.end(), section) != row.sections.end();
}
} // namespace

AnalysisTable::AnalysisTable(std::vector<AnalysisRow> rows) : all_rows(std::move(rows)) {}

std::vector<std::pair<std::string, std::string>> AnalysisTable::types() const
{
  std::vector<std::pair<std::string, std::string>> result;
  for (const AnalysisRow &row : all_rows)
    result.emplace_back(row.name, row.description);
  return result;
}

const AnalysisRow &AnalysisTable::row(const std::string &name) const
{
  const auto place = std::find_if(all_rows.begin(), all_rows.end(),
                                  [&name](const AnalysisRow &row) { return row.name == name; });
  AssertThrow(place != all_rows.end(), dealii::ExcMessage("no analysis '" + name + "'"));
  return *place;
}

void AnalysisTable::refuse_sections_of_others(ParameterSection root, const AnalysisRow &row) const
{
  for (const std::string &section : root.subsections())
  {
    std::string others;
    bool is_read = reads(row, section);
    for (const AnalysisRow &other : all_rows)
      if (reads(other, section))
      {
        others += (others.empty() ? "" : " or ") + other.name;
        is_read = is_read || (other.is_study() && (row.has_case() || other.performs_any));
      }
    if (is_read || others.empty())
      continue;
    ParameterSection unread = root.subsection(section);
    if (root.sets_in_subsection(section))
      unread.refuse("", "Analysis = " + row.name + " does not read this section",
                    "Remove it, or set Analysis = " + others);
  }
}

std::unique_ptr<Analysis> AnalysisTable::make(ParameterFile &file,
                                              const CommandLine &command_line,
                                              const MPI_Comm communicator) const
{
  return passing_over_impossible(
      file, [&](ParameterFile &read) { return make_of(read, command_line, communicator); },
      [&]
      {
        CommandLine without_changes = command_line;
        without_changes.overrides.clear();
        without_changes.validate = true;
        without_changes.restart = false;
        ParameterFile unchanged(command_line.parameter_file);
        make_of(unchanged, without_changes, communicator);
      });
}

std::unique_ptr<Analysis> AnalysisTable::make_of(ParameterFile &file,
                                                 const CommandLine &command_line,
                                                 const MPI_Comm communicator) const
{
  GeneralParameters general;
  general.read(file.root(), types());
  const AnalysisRow &chosen = row(general.analysis);
  if (!chosen.is_study())
    refuse_sections_of_others(file.root(), chosen);
  // The file of a study may be run alone, too; who reads a case reads these sections itself.
  if (!chosen.is_study() && !chosen.has_case())
    for (const AnalysisRow &study : all_rows)
      if (study.performs_any && file.root().has_subsection(study.sections.front()))
        study.read_section(file.root());
  std::unique_ptr<Analysis> analysis =
      chosen.make({file, general, command_line, communicator, *this});
  require_same_input(file, communicator);
  return analysis;
}

template <int dim>
Case<dim> AnalysisTable::read_case(ParameterFile &file,
                                   const MPI_Comm communicator,
                                   const CaseUse use,
                                   const std::string &analysis) const
{
  return passing_over_impossible(
      file, [&](ParameterFile &read) { return case_of<dim>(read, communicator, use, analysis); },
      [&]
      {
        GeneralParameters general;
        general.read(file.root(), types());
        // Of a study, which chooses the analysis of its runs.
        ParameterFile unchanged(file.text().files().front(), {"Analysis=" + general.analysis});
        case_of<dim>(unchanged, communicator, CaseUse::check, analysis);
      });
}

template <int dim>
Case<dim> AnalysisTable::case_of(ParameterFile &file,
                                 const MPI_Comm communicator,
                                 const CaseUse use,
                                 const std::string &analysis) const
{
  ParameterSection root = file.root();
  GeneralParameters general;
  general.read(root, types());
  const AnalysisRow &chosen = row(analysis.empty() ? general.analysis : analysis);
  refuse_sections_of_others(root, chosen);
  // The file of a study may be run alone, too.
  for (const AnalysisRow &study : all_rows)
    if (study.is_study() && root.has_subsection(study.sections.front()))
      study.read_section(root);
  return Case<dim>(file, general, chosen.traits<dim>(), communicator, use);
}

template Case<2>
AnalysisTable::read_case(ParameterFile &, MPI_Comm, CaseUse, const std::string &) const;
template Case<3>
AnalysisTable::read_case(ParameterFile &, MPI_Comm, CaseUse, const std::string &) const;
} // namespace Continua
