#include <continua/continuum/step_extremes.h>

#include <continua/base/collective.h>
#include <continua/base/input_error.h>
#include <continua/signal/expression.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace Continua
{
std::string reason_not_finite(const MPI_Comm communicator)
{
  for (const std::string &text : all_gather(communicator, Expression::value_not_finite()))
    if (!text.empty())
      return "; " + text;
  return "";
}

void set_extremes(const Step &step,
                  const DistributedVector &start,
                  const DistributedVector &at_level,
                  const DistributedVector &pressure,
                  StepReport &report)
{
  double largest_velocity = 0., largest_change = 0.;
  // A maximum passes over what is no number; 0 times it is no number either.
  double zero = 0.;
  const double *const solved = at_level.begin();
  const double *const old = start.begin();
  for (unsigned int i = 0; i < start.locally_owned_size(); ++i)
  {
    const double next = step.extrapolate ? 2. * solved[i] - old[i] : solved[i];
    largest_velocity = std::max(largest_velocity, std::abs(solved[i]));
    largest_change = std::max(largest_change, std::abs(next - old[i]));
    zero += 0. * solved[i];
  }
  for (const double pressure_entry : pressure)
    zero += 0. * pressure_entry;
  std::array<double, 3> extremes = {{largest_velocity, largest_change, zero == 0. ? 0. : 1.}};
  MPI_Allreduce(MPI_IN_PLACE, extremes.data(), 3, MPI_DOUBLE, MPI_MAX,
                start.get_mpi_communicator());
  if (extremes[2] > 0.)
  {
    std::ostringstream text;
    text << "the solution is not finite in the step to t = " << step.time << " s"
         << reason_not_finite(start.get_mpi_communicator());
    throw RunError(text.str());
  }
  report.largest_velocity = extremes[0];
  report.largest_change = extremes[1];
}
} // namespace Continua
