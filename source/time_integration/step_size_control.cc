#include <continua/time_integration/step_size_control.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace Continua
{
namespace
{
/// Part of the tolerance that a new size aims at.
constexpr double aim = 0.5;
/// The longest wait for an increase, in multiples of the shortest.
constexpr unsigned int longest_wait = 32;

double rounded(const double error)
{
  if (!(error > 0.) || std::isinf(error))
    return error;
  const double unit = std::pow(10., std::floor(std::log10(error)) - 2.);
  return std::round(error / unit) * unit;
}
} // namespace

StepSizeControl::StepSizeControl(const StepSizeParameters &parameters)
    : parameters(parameters),
      // A bound that is a size itself may be so but for round-off.
      smallest_exponent(std::ceil(std::log2(parameters.smallest / parameters.first) - 1e-6)),
      largest_exponent(std::floor(std::log2(parameters.largest / parameters.first) + 1e-6)),
      factor_of_halving(std::ldexp(1., -static_cast<int>(parameters.order) - 1)),
      wait(parameters.steps_between_increases)
{
}

double StepSizeControl::size_of(const int exponent) const
{
  return std::ldexp(parameters.first, exponent);
}

bool StepSizeControl::judge(const double exact_error, const int used_exponent)
{
  double error = rounded(exact_error);
  if (!(error <= parameters.tolerance))
  {
    if (used_exponent <= smallest_exponent)
    {
      ++above_tolerance;
      change(used_exponent);
      return true;
    }
    // An increase that is taken back came too early.
    if (trial > 0)
      wait = std::min(2 * wait, longest_wait * parameters.steps_between_increases);
    trial = 0;
    int reduced = used_exponent;
    do
    {
      --reduced;
      error *= factor_of_halving;
    } while (!(error <= aim * parameters.tolerance) && reduced > smallest_exponent &&
             !std::isinf(error));
    change(reduced);
    ++rejected;
    return false;
  }
  if (trial > 0 && --trial == 0)
    wait = std::max(wait / 2, parameters.steps_between_increases);
  if (used_exponent != exponent)
    return true;
  small_errors = error <= aim * parameters.tolerance * factor_of_halving ? small_errors + 1 : 0;
  if (small_errors >= wait && exponent < largest_exponent)
  {
    change(exponent + 1);
    trial = wait;
  }
  return true;
}

void StepSizeControl::return_to_first()
{
  change(std::min(exponent, 0));
}

void StepSizeControl::change(const int new_exponent)
{
  exponent = new_exponent;
  smallest_used = std::min(smallest_used, exponent);
  small_errors = 0;
}

void StepSizeControl::save(ArchiveWriter &archive) const
{
  // Whole numbers that may be negative, exact as such.
  archive.add("step size", std::vector<double>{double(exponent), double(smallest_used),
                                               double(small_errors), double(wait), double(trial),
                                               double(rejected), double(above_tolerance)});
}

void StepSizeControl::load(const ArchiveReader &archive)
{
  const std::vector<double> values = archive.values("step size");
  exponent = static_cast<int>(values.at(0));
  smallest_used = static_cast<int>(values.at(1));
  small_errors = static_cast<unsigned int>(values.at(2));
  wait = static_cast<unsigned int>(values.at(3));
  trial = static_cast<unsigned int>(values.at(4));
  rejected = static_cast<unsigned int>(values.at(5));
  above_tolerance = static_cast<unsigned int>(values.at(6));
}
} // namespace Continua
