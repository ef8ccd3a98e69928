#ifndef continua_studies_swept_axis_h
#define continua_studies_swept_axis_h

#include <continua/base/numeric_entry.h>
#include <continua/base/parameter_file.h>
#include <continua/studies/sweep_parameters.h>

#include <optional>
#include <string>
#include <vector>

namespace Continua
{
/// One entry of a sweep: what the section says, and what the file knows of it.
struct SweptAxis
{
  /// Finds the entry of a file that was read before. A path that is no number's may be one of
  /// words, of a list as a whole, or of an entry that only the values of others bring about: the
  /// input of the runs says whether it is right. Throws InputError, as said of `section`, for a
  /// place that the list has not, and for values that are no numbers of the entry's dimension.
  SweptAxis(const ParameterFile &file,
            const ParameterSection &section,
            const SweepParameters::Axis &axis);

  std::string path;
  std::vector<std::string> values;   ///< as they are written
  std::vector<std::string> texts;    ///< for the entry: the same, but whole paths of input files
  std::optional<NumericEntry> entry; ///< of numbers
  std::vector<double> numbers;       ///< then the values [SI]

  /// What is set to give the entry a value: the path without a place in a list.
  const std::string &path_of_entry() const { return entry ? entry->path_of_entry() : path; }
  /// A value as the table has it: a number in SI, or a word.
  std::string in_table(std::size_t number) const;
};
} // namespace Continua

#endif
