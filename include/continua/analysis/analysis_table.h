#ifndef continua_analysis_analysis_table_h
#define continua_analysis_analysis_table_h

#include <continua/analysis/analysis.h>
#include <continua/case/analysis_traits.h>
#include <continua/case/case.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/// One analysis: a row of the table.
struct AnalysisRow
{
  std::string name;        ///< the value of the entry Analysis
  std::string description; ///< a line for the manual
  /// The sections that it reads, of those that not every analysis reads. A file in which another
  /// analysis's section stands is refused.
  std::vector<std::string> sections;
  /// Reads and checks the input. Throws InputError.
  std::unique_ptr<Analysis> (*make)(const AnalysisInput &input);
  /// Of an analysis that reads a case: what the reader knows of it; else the defaults.
  AnalysisTraits<2> traits_2d = {};
  AnalysisTraits<3> traits_3d = {};
  /// Of a study: reads and checks its section, which is the first of `sections` and may also stand
  /// in the file of each of the study's runs; else null.
  void (*read_section)(ParameterSection root) = nullptr;
  /// Of a study: its runs may be of any analysis, also of one that reads no case.
  bool performs_any = false;

  /// Whether it reads a case.
  bool has_case() const { return traits_2d.check != nullptr; }
  bool is_study() const { return read_section != nullptr; }
  template <int dim>
  const AnalysisTraits<dim> &traits() const
  {
    if constexpr (dim == 2)
      return traits_2d;
    else
      return traits_3d;
  }
};

/// The table of analyses. Its only instance is analyses(); who needs it below that is given it.
class AnalysisTable
{
public:
  explicit AnalysisTable(std::vector<AnalysisRow> rows);

  const std::vector<AnalysisRow> &rows() const { return all_rows; }
  /// Name and description of each, for the entry Analysis.
  std::vector<std::pair<std::string, std::string>> types() const;
  const AnalysisRow &row(const std::string &name) const;

  /// Reads the analysis that the file asks for. Throws InputError.
  std::unique_ptr<Analysis>
  make(ParameterFile &file, const CommandLine &command_line, MPI_Comm communicator) const;
  /// Reads the case of a file for an analysis that reads one; by default the file's own. Throws
  /// InputError.
  template <int dim>
  Case<dim> read_case(ParameterFile &file,
                      MPI_Comm communicator,
                      CaseUse use = CaseUse::run,
                      const std::string &analysis = "") const;

private:
  std::vector<AnalysisRow> all_rows;

  std::unique_ptr<Analysis>
  make_of(ParameterFile &file, const CommandLine &command_line, MPI_Comm communicator) const;
  template <int dim>
  Case<dim> case_of(ParameterFile &file,
                    MPI_Comm communicator,
                    CaseUse use,
                    const std::string &analysis) const;

  /// Throws InputError if a section stands in the file that is not read, but would be read by
  /// another analysis.
  void refuse_sections_of_others(ParameterSection root, const AnalysisRow &row) const;
};
} // namespace Continua

#endif
