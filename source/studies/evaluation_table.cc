#include <continua/studies/evaluation_table.h>

#include <continua/base/input_error.h>
#include <continua/base/parameter_text.h>
#include <continua/base/text_table.h>
#include <continua/base/units.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace Continua
{
namespace
{
/// A line of the checkpoint, without its end: the numbers of the set, the misfit, the purpose and
/// what came of it.
std::string line_of(const Evaluation &evaluation)
{
  std::string text;
  for (const double number : evaluation.set)
    text += shortest_number(number) + " ";
  text += shortest_number(evaluation.misfit) + " " + evaluation.purpose + " ";
  if (!evaluation.prediction.failure.empty())
    return text + "failed " + collapse_blanks(evaluation.prediction.failure);
  text += "predicted";
  for (const double value : evaluation.prediction.values)
    text += " " + shortest_number(value);
  // A line that a crash has cut has no end.
  return text + " .";
}

bool read_number(std::istream &stream, double &number)
{
  std::string text;
  if (!(stream >> text))
    return false;
  char *end = nullptr;
  number = std::strtod(text.c_str(), &end);
  return end != text.c_str() && *end == '\0';
}

/// Of a line; false if it is no whole one.
bool read_line(const std::string &line, const std::size_t n_numbers, Evaluation &evaluation)
{
  std::istringstream stream(line);
  evaluation.set.resize(n_numbers);
  for (double &number : evaluation.set)
    if (!read_number(stream, number))
      return false;
  std::string word;
  if (!read_number(stream, evaluation.misfit) || !(stream >> evaluation.purpose >> word))
    return false;
  if (word == "failed")
  {
    std::getline(stream, evaluation.prediction.failure);
    evaluation.prediction.failure = collapse_blanks(evaluation.prediction.failure);
    return !evaluation.prediction.failure.empty();
  }
  while (stream >> word && word != ".")
  {
    char *end = nullptr;
    evaluation.prediction.values.push_back(std::strtod(word.c_str(), &end));
    if (end == word.c_str() || *end != '\0')
      return false;
  }
  return word == "." && !evaluation.prediction.values.empty();
}
} // namespace

std::string EvaluationTable::why_not(const std::string &checkpoint, const std::string &identity)
{
  std::ifstream stream(checkpoint);
  std::string first;
  if (!std::getline(stream, first))
    return "there is nothing to go on from";
  return first == identity ? "" : "it was begun with another input or another program";
}

EvaluationTable::EvaluationTable(const OutputDirectory &directory,
                                 const std::vector<FitParameter> &parameters,
                                 const std::string &identity,
                                 const bool restart)
{
  const std::string file = directory.file("checkpoint/evaluations");
  if (restart)
    read(file, parameters.size());
  table.open(directory.file("evaluations.csv"));
  table << "evaluation [1],purpose";
  for (const FitParameter &parameter : parameters)
    table << "," << csv_cell(parameter.name + " [" + parameter.unit + "]");
  table << ",misfit [1],failure\n";
  for (const Evaluation &evaluation : known_ones)
    write_row(evaluation);
  checkpoint.open(file, restart ? std::ios::app : std::ios::trunc);
  if (!restart)
    checkpoint << identity << "\n" << std::flush;
}

void EvaluationTable::read(const std::string &file, const std::size_t n_numbers)
{
  std::uintmax_t n_bytes = 0;
  {
    std::ifstream stream(file, std::ios::binary);
    std::string line;
    std::getline(stream, line);
    n_bytes = line.size() + 1;
    Evaluation evaluation;
    for (; std::getline(stream, line); evaluation = Evaluation())
    {
      if (stream.eof() || !read_line(line, n_numbers, evaluation))
        break;
      known_ones.push_back(evaluation);
      n_bytes += line.size() + 1;
    }
  }
  // What stands behind the last whole line is computed anew.
  if (std::filesystem::file_size(file) > n_bytes)
    std::filesystem::resize_file(file, n_bytes);
}

void EvaluationTable::add(const Evaluation &evaluation)
{
  write_row(evaluation);
  checkpoint << line_of(evaluation) << "\n" << std::flush;
  if (!table || !checkpoint)
    throw RunError("cannot write evaluations.csv or checkpoint/evaluations: the disk refuses");
}

void EvaluationTable::write_row(const Evaluation &evaluation)
{
  table << ++n_written << "," << csv_cell(evaluation.purpose);
  for (const double number : evaluation.set)
    table << "," << csv_cell(number);
  table << "," << csv_cell(evaluation.misfit) << "," << csv_cell(evaluation.prediction.failure)
        << "\n"
        << std::flush;
}
} // namespace Continua
