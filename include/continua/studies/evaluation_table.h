#ifndef continua_studies_evaluation_table_h
#define continua_studies_evaluation_table_h

#include <continua/base/output_directory.h>
#include <continua/inference/evaluation.h>
#include <continua/inference/fit_parameter.h>

#include <fstream>
#include <string>
#include <vector>

namespace Continua
{
/**
 * All evaluations of a fit, on disk: evaluations.csv for the reader, and checkpoint/evaluations
 * with the predictions, from which a restart goes on without computing anything twice.
 */
class EvaluationTable
{
public:
  /// `identity`: of what the predictions depend on. With `restart` the evaluations that the folder
  /// has, of the same identity, are known. Throws RunError when the disk refuses.
  EvaluationTable(const OutputDirectory &directory,
                  const std::vector<FitParameter> &parameters,
                  const std::string &identity,
                  bool restart);

  const std::vector<Evaluation> &known() const { return known_ones; }
  void add(const Evaluation &evaluation);

  /// Why a restart cannot use what the folder has; empty if it can.
  static std::string why_not(const std::string &checkpoint, const std::string &identity);

private:
  std::vector<Evaluation> known_ones;
  std::ofstream table, checkpoint;
  unsigned int n_written = 0;

  void read(const std::string &file, std::size_t n_numbers);
  void write_row(const Evaluation &evaluation);
};
} // namespace Continua

#endif
