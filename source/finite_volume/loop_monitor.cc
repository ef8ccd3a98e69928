#include <continua/finite_volume/loop_monitor.h>

#include <continua/base/input_error.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Continua
{
LoopMonitor::LoopMonitor(const double tolerance, const unsigned int maximum_corrections)
    : tolerance(tolerance), maximum_corrections(maximum_corrections)
{
  history.reserve(maximum_corrections);
}

void LoopMonitor::start()
{
  history.clear();
  is_converged = false;
  n_growths = 0;
}

bool LoopMonitor::goes_on(const LoopCorrection &correction)
{
  constexpr unsigned int most_growths = 10;
  constexpr double largest_growth = 1e4;
  const double before = history.empty() ? correction.magnitude : history.back().magnitude;
  smallest = history.empty() ? correction.magnitude : std::min(smallest, correction.magnitude);
  history.push_back(correction);
  n_growths = correction.magnitude > before ? n_growths + 1 : 0;

  // The scaled residual of a loop that diverges stays below 1, the sum does not.
  is_converged = correction.residual < tolerance && correction.continuity < tolerance;
  if (!is_converged &&
      (!std::isfinite(correction.residual) || !std::isfinite(correction.continuity) ||
       n_growths >= most_growths || correction.magnitude > largest_growth * smallest))
    diverges();
  return !is_converged && history.size() < maximum_corrections;
}

void LoopMonitor::diverges() const
{
  constexpr std::size_t n_shown = 6;
  std::ostringstream text;
  text << "the segregated loop diverges; residuals of its corrections "
       << std::max<std::size_t>(history.size(), n_shown) - n_shown + 1 << " to " << history.size()
       << ":";
  for (std::size_t i = history.size() - std::min(history.size(), n_shown); i < history.size(); ++i)
    text << " " << history[i].residual << " (" << history[i].magnitude << " N)";
  text
      << ". Take a smaller time step, another Cell-wise/Stencil coefficient, or Cell-wise/Solution "
         "= coupled, which has no such limit";
  throw RunError(text.str());
}
} // namespace Continua
