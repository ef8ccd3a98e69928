#ifndef continua_studies_chosen_quantities_h
#define continua_studies_chosen_quantities_h

#include <continua/studies/run_series.h>

#include <string>
#include <vector>

namespace Continua
{
/// "PROBE: NAME", or "NAME" of the run as a whole.
std::string label_of(const Quantity &quantity);

/// The quantity of a run with that label; null if it has none.
const Quantity *find_quantity(const RunResult &run, const std::string &label);

/// Of the largest value of its unit: what solvers and sums leave in digits [1].
constexpr double round_off_share = 1e-10;

/// Whether a quantity tells of the computation (an error, a count) rather than of the body.
bool is_of_the_computation(const std::string &name);

/// Whether a label is asked for: by itself, or by the name of the quantity; if nothing is asked
/// for, each is but those of the computation.
bool is_chosen(const std::vector<std::string> &asked, const std::string &label);

/// Throws RunError for a quantity in `asked` ("PROBE: NAME", or "NAME" of whatever probe) that this
/// run has not; `entry`: where they stand.
void check_asked(const std::string &entry,
                 const std::vector<std::string> &asked,
                 const RunResult &run);

/// The labels of the runs' quantities that are asked for, in the order of the summaries; if none is
/// asked for, of all but those of the computation.
std::vector<std::string> chosen_labels(const std::vector<std::string> &asked,
                                       const std::vector<RunResult> &runs);
} // namespace Continua

#endif
