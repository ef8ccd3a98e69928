#include <continua/laboratory/fit_report.h>

#include <continua/base/input_error.h>
#include <continua/base/table_writer.h>
#include <continua/base/units.h>
#include <continua/inference/whiteness_test.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

namespace Continua
{
namespace
{
/// Without an exponent where that is short.
std::string rounded(const double value, const int digits)
{
  std::ostringstream text;
  text.precision(digits);
  text << value;
  return std::isfinite(value) ? shortest_number(std::stod(text.str())) : text.str();
}

/// To a hundredth of its standard error, of which further digits say nothing.
std::string to_error(const double value, const double error)
{
  const int power = static_cast<int>(std::floor(std::log10(0.01 * error)));
  std::ostringstream text;
  text.setf(std::ios::fixed);
  text.precision(std::clamp(-power, 0, 17));
  const double step = std::pow(10., power);
  text << (power > 0 ? step * std::round(value / step) : value);
  return text.str();
}

/// Of a number in SI, as messages say it: angles in degrees, like in parameter files.
std::string with_unit(const FitParameter &parameter)
{
  return parameter.unit == "1" ? "" : parameter.unit == "rad" ? " deg" : " " + parameter.unit;
}

double in_unit_of_messages(const FitParameter &parameter)
{
  return parameter.unit == "rad" ? 180. / dealii::numbers::PI : 1.;
}

/// "Young's modulus 400512 +- 620 Pa (95 %: 399300 to 401700 Pa)", at a bound "below 12 Pa".
std::string sentence_of(const FitParameter &parameter, const FitResult &result, const std::size_t i)
{
  const std::string unit = with_unit(parameter);
  const double factor = in_unit_of_messages(parameter), estimate = factor * result.estimates[i],
               error = factor * result.standard_errors[i];
  ConfidenceInterval interval = result.intervals[i];
  interval.lower *= factor;
  interval.upper *= factor;
  std::string text = parameter.name + " ";
  if (std::isfinite(error) && error > 0.)
    return text + to_error(estimate, error) + " +- " + rounded(error, 2) + unit +
           " (95 %: " + rounded(interval.lower, 4) + " to " + rounded(interval.upper, 4) + unit +
           ")";
  text += rounded(estimate, 6) + unit;
  if (!result.at_bound[i])
    return text +
           (std::isnan(error) ? ", without a standard error" : ", which the data do not see");
  text += ", at its bound";
  if (!interval.upper_is_bound)
    return text + " (95 %: below " + rounded(interval.upper, 4) + unit + ")";
  if (!interval.lower_is_bound)
    return text + " (95 %: above " + rounded(interval.lower, 4) + unit + ")";
  return text;
}
} // namespace

std::string percent(const double share)
{
  return rounded(100. * share, 2) + " %";
}

void name_fit_quantities(const std::string &parameter, QuantityNames &names)
{
  names.add(parameter, "fit");
  names.add("standard error of " + parameter, "fit");
}

void report_fit(const std::vector<FitParameter> &parameters,
                const FitResult &result,
                Log &log,
                Summary &summary)
{
  for (std::size_t i = 0; i < parameters.size(); ++i)
  {
    log.line("  " + sentence_of(parameters[i], result, i));
    summary.add({parameters[i].name, result.estimates[i], parameters[i].unit, "fit"});
    if (std::isfinite(result.standard_errors[i]))
      summary.add({"standard error of " + parameters[i].name, result.standard_errors[i],
                   parameters[i].unit, "fit"});
    else
      summary.add_absence("standard error of " + parameters[i].name, "fit",
                          "the number is at its bound, or the data do not see it");
  }
  std::set<std::string> of_directions;
  for (const FlatDirection &direction : result.flat_directions)
  {
    of_directions.insert(direction.sentence);
    log.warning(direction.sentence);
  }
  for (const std::string &doubt : result.doubts)
    log.warning(doubt);
  for (const std::string &note : result.notes)
    if (of_directions.count(note) == 0 &&
        std::count(result.doubts.begin(), result.doubts.end(), note) == 0)
      log.line(note);
  for (std::size_t i = 0; i < result.free.size(); ++i)
    for (std::size_t j = i + 1; j < result.free.size(); ++j)
      if (const double correlation = result.correlation(i, j);
          std::abs(correlation) > clear_correlation)
        log.line(
            "'" + parameters[result.free[i]].name + "' and '" + parameters[result.free[j]].name +
            "' trade off: with more of the one the data fit " +
            (correlation > 0. ? "more" : "less") + " of the other nearly as well (correlation " +
            rounded(correlation, 3) + "); what fixes one of them sharpens the other");
}

std::string warning_of_order(const std::string &rows, const std::vector<double> &residuals)
{
  const WhitenessTest test = ljung_box_test(residuals);
  if (!(test.probability < clear_order))
    return "";
  return "what the fit leaves of " + rows +
         " is no independent error of each row, as the standard errors assume: neighbouring rows "
         "miss in the same way (probability " +
         rounded(test.probability, 2) +
         ", Ljung and Box). The model does not follow the table, or the errors of neighbouring "
         "rows are alike: the standard errors are too small";
}

void require_end(const FitResult &result, const std::string &found)
{
  if (!result.converged)
    throw RunError("the fit of " + found + " did not come to its end: " + result.stop_reason +
                   ". The tables have the last values of the search");
}

void write_correlation(const std::string &file,
                       const std::vector<FitParameter> &parameters,
                       const FitResult &result)
{
  std::vector<std::string> header;
  for (const unsigned int i : result.free)
    header.push_back(parameters[i].name + " [1]");
  if (header.empty())
    return;
  TableWriter table(file, header);
  for (std::size_t i = 0; i < result.free.size(); ++i)
  {
    std::vector<double> row;
    for (std::size_t j = 0; j < result.free.size(); ++j)
      row.push_back(result.correlation(i, j));
    table.row(row);
  }
  table.flush();
}
} // namespace Continua
