// The tables of IdentificationReport.

#include <continua/studies/identification_report.h>

#include <continua/base/atomic_file.h>
#include <continua/base/citations.h>
#include <continua/base/text_table.h>

#include <cmath>

namespace Continua
{
namespace
{
std::string column(const std::string &name, const std::string &unit)
{
  return csv_cell(name + " [" + unit + "]");
}

/// A finite number; nothing where there is none.
std::string cell_of(const double value)
{
  return std::isfinite(value) ? csv_cell(value) : std::string();
}
} // namespace

void IdentificationReport::write(const OutputDirectory &directory) const
{
  if (results.fit)
  {
    write_file_atomically(directory.file("identification.csv"), numbers_table());
    write_file_atomically(directory.file("correlation.csv"), correlation_table());
    write_file_atomically(directory.file("fit.csv"), fit_table());
  }
  if (!results.profiles.empty())
    write_file_atomically(directory.file("profiles.csv"), profiles_table());
  if (results.errors_of_file || !results.choices.empty())
    write_file_atomically(directory.file("expected-errors.csv"), expected_errors_table());
  if (results.synthetic)
    write_file_atomically(directory.file("synthetic.csv"), synthetic_table());
  Citations citations;
  if (results.model == "linear wave theory")
    citations.add("arb");
  citations.write(directory.file("citation.bib"));
}

std::string IdentificationReport::numbers_table() const
{
  const FitResult &fit = *results.fit;
  std::string text = "parameter,entry,unit,estimate,standard error,lower limit,upper limit,start,"
                     "lower bound,upper bound,state,bias,bias over standard error [1]\n";
  for (std::size_t j = 0; j < sought.size(); ++j)
  {
    const FitParameter &parameter = results.parameters[j];
    text += csv_cell(parameter.name) + "," + csv_cell(sought[j].entry.path()) + "," +
            csv_cell(parameter.unit);
    for (const double value :
         {fit.estimates[j], fit.standard_errors[j], fit.intervals[j].lower, fit.intervals[j].upper,
          parameter.start, parameter.lower, parameter.upper})
      text += "," + cell_of(value);
    text += std::string(",") + (parameter.is_held()                  ? "held"
                                : fit.at_bound[j]                    ? "at bound"
                                : std::isinf(fit.standard_errors[j]) ? "not seen"
                                                                     : "free");
    text += results.bias ? "," + cell_of(results.bias->bias[j]) + "," +
                               cell_of(results.bias->over_standard_error[j])
                         : ",,";
    text += "\n";
  }
  return text;
}

std::string IdentificationReport::correlation_table() const
{
  const FitResult &fit = *results.fit;
  std::string text = "parameter";
  for (const unsigned int number : fit.free)
    text += "," + csv_cell(results.parameters[number].name);
  text += "\n";
  for (std::size_t i = 0; i < fit.free.size(); ++i)
  {
    text += csv_cell(results.parameters[fit.free[i]].name);
    for (std::size_t k = 0; k < fit.free.size(); ++k)
      text += "," + cell_of(fit.correlation(i, k));
    text += "\n";
  }
  return text;
}

std::string IdentificationReport::fit_table() const
{
  std::string text = "record,unit,time [s],measured,fitted,residual,noise\n";
  for (std::size_t r = 0; r < measured.records.size(); ++r)
  {
    const DataRecord &record = measured.records[r];
    const RecordFit &fit = results.fit->records[r];
    for (std::size_t i = 0; i < record.size(); ++i)
    {
      text += csv_cell(record.name) + "," + csv_cell(record.unit);
      for (const double value : {record.times[i] + results.shifts[r], record.values[i],
                                 fit.prediction[i], fit.residuals[i], fit.noise.standard_deviation})
        text += "," + cell_of(value);
      text += "\n";
    }
  }
  return text;
}

std::string IdentificationReport::profiles_table() const
{
  std::string text = "parameter,unit,value,misfit [1],threshold [1]";
  for (const FitParameter &parameter : results.parameters)
    text += "," + column(parameter.name, parameter.unit);
  text += "\n";
  for (const auto &[number, profile] : results.profiles)
    for (const Profile::Point &point : profile.points)
    {
      const FitParameter &parameter = results.parameters[number];
      text += csv_cell(parameter.name) + "," + csv_cell(parameter.unit) + "," +
              cell_of(point.value) + "," + cell_of(point.misfit) + "," + cell_of(profile.threshold);
      for (const double estimate : point.estimates)
        text += "," + cell_of(estimate);
      text += "\n";
    }
  return text;
}

std::string IdentificationReport::expected_errors_table() const
{
  std::string text = "rank [1],added,position [m],field,second position [m],second field,"
                     "log determinant [1]";
  for (const FitParameter &parameter : results.parameters)
    text += "," + column(parameter.name + ": standard error", parameter.unit);
  text += "\n";
  const auto add_errors = [&](const ExpectedErrors::Errors &errors)
  {
    text += "," + cell_of(errors.log_determinant);
    for (const double error : errors.standard_errors)
      text += "," + cell_of(error);
    text += "\n";
  };
  if (results.errors_of_file)
  {
    text += "0,,,,,";
    add_errors(*results.errors_of_file);
  }
  for (const auto &[name, errors] : results.errors_of_parts)
  {
    text += "0," + csv_cell(name) + ",,,,";
    add_errors(errors);
  }
  for (std::size_t i = 0; i < results.choices.size(); ++i)
  {
    const DesignChoice &choice = results.choices[i];
    text += std::to_string(i + 1) + "," + csv_cell(added(choice));
    for (std::size_t k = 0; k < 2; ++k)
    {
      const bool is_named = choice.records.size() <= 2 && k < choice.records.size();
      if (!is_named)
        text += ",,";
      else if (const unsigned int record = choice.records[k]; record >= expected.sources.size())
        text += ",," + csv_cell(expected.records[record].name); // a material test has no place
      else
        text += "," + cell_of(expected.sources[record].position) + "," +
                csv_cell(expected.sources[record].field_name);
    }
    add_errors(choice.errors);
  }
  return text;
}

std::string IdentificationReport::synthetic_table() const
{
  std::string text = "experiment [1]";
  for (const FitParameter &parameter : results.parameters)
    for (const char *const what :
         {": estimate", ": standard error", ": lower limit", ": upper limit"})
      text += "," + column(parameter.name + what, parameter.unit);
  text += ",misfit [1]\n";
  for (std::size_t i = 0; i < results.synthetic->fits.size(); ++i)
  {
    const FitResult &fit = results.synthetic->fits[i];
    text += std::to_string(i + 1);
    for (std::size_t j = 0; j < sought.size(); ++j)
      for (const double value : {fit.estimates[j], fit.standard_errors[j], fit.intervals[j].lower,
                                 fit.intervals[j].upper})
        text += "," + cell_of(value);
    text += "," + cell_of(fit.misfit) + "\n";
  }
  return text;
}
} // namespace Continua
