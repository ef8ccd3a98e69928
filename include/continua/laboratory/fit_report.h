#ifndef continua_laboratory_fit_report_h
#define continua_laboratory_fit_report_h

#include <continua/base/log.h>
#include <continua/base/quantity_names.h>
#include <continua/base/summary.h>
#include <continua/inference/fit_parameter.h>
#include <continua/inference/fit_result.h>

#include <string>
#include <vector>

namespace Continua
{
/// Parameters whose correlation is larger than this in magnitude are said to trade off [1].
constexpr double clear_correlation = 0.95;

/// Residuals as ordered as these are by chance only this often [1] are warned of.
constexpr double clear_order = 0.01;

/// Says what a fit has found: each number with its standard error and its interval of 95 % (at a
/// bound one-sided), angles in degrees, the directions that the data do not see, and the pairs that
/// trade off. The summary gets NAME and `standard error of NAME` in SI, of the probe `fit`.
void report_fit(const std::vector<FitParameter> &parameters,
                const FitResult &result,
                Log &log,
                Summary &summary);

/// What to warn of where residuals in the order of their rows are correlated (ljung_box_test()), so
/// that the standard errors, which assume independent errors of the rows, are too small; else
/// empty. `rows`: "the relaxation table".
std::string warning_of_order(const std::string &rows, const std::vector<double> &residuals);

/// Throws RunError if the search did not converge; `found` names what was sought.
void require_end(const FitResult &result, const std::string &found);

/// What report_fit() adds to the summary for a parameter of this name.
void name_fit_quantities(const std::string &parameter, QuantityNames &names);

/// correlation.csv: a column for each free parameter [1], and rows in the same order.
void write_correlation(const std::string &file,
                       const std::vector<FitParameter> &parameters,
                       const FitResult &result);

/// "0.29 %": a share as messages say it.
std::string percent(double share);
} // namespace Continua

#endif
