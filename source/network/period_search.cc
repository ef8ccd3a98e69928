#include <continua/network/period_search.h>

#include <continua/base/input_error.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
namespace
{
/// Of a number, over its size: a smaller range in a period is none.
constexpr double least_range = 1e-9;
} // namespace

PeriodSearch::PeriodSearch(Network &network, std::function<void(double)> advance)
    : network(network), advance(std::move(advance))
{
}

void PeriodSearch::set(const std::vector<double> &numbers)
{
  std::vector<double> copy = numbers;
  StateNumbers give(StateNumbers::Direction::give, copy);
  network.visit(give);
}

void PeriodSearch::begin()
{
  StateNumbers take(StateNumbers::Direction::take, at_begin);
  network.visit(take);
  lowest.clear();
  sample();
  times.clear();
}

void PeriodSearch::sample()
{
  times.push_back(network.time());
  std::vector<double> numbers;
  StateNumbers take(StateNumbers::Direction::take, numbers);
  network.visit_state(take);
  if (lowest.empty())
  {
    lowest = highest = numbers;
    n_state = numbers.size();
    scales.assign(n_state, 1.);
    for (const std::size_t place : take.flags())
      scales[place] = 0.;
    return;
  }
  for (std::size_t i = 0; i < n_state; ++i)
  {
    lowest[i] = std::fmin(lowest[i], numbers[i]);
    highest[i] = std::fmax(highest[i], numbers[i]);
  }
}

double PeriodSearch::residual()
{
  StateNumbers take(StateNumbers::Direction::take, at_end);
  network.visit(take);
  double sum = 0.;
  unsigned int n = 0;
  for (std::size_t i = 0; i < n_state; ++i)
  {
    const double range = highest[i] - lowest[i];
    if (scales[i] > 0.)
      scales[i] =
          range > least_range * std::fmax(std::abs(highest[i]), std::abs(lowest[i])) ? range : 0.;
    if (scales[i] == 0.)
      continue;
    sum += std::pow((at_end[i] - at_begin[i]) / scales[i], 2);
    ++n;
  }
  last_residual = n > 0 ? std::sqrt(sum / n) : 0.;
  return last_residual;
}

bool PeriodSearch::move()
{
  if (last_residual >= residual_of_move && residual_of_move > 0.)
  {
    residual_of_move = 0.;
    return false;
  }
  residual_of_move = last_residual;
  const auto state_of = [this](const std::vector<double> &numbers)
  { return std::vector<double>(numbers.begin(), numbers.begin() + n_state); };
  const auto with_state = [](std::vector<double> numbers, const std::vector<double> &state)
  {
    std::copy(state.begin(), state.end(), numbers.begin());
    return numbers;
  };
  const auto period = [&](const std::vector<double> &state)
  {
    set(with_state(at_begin, state));
    for (const double time : times)
      advance(time);
    std::vector<double> numbers;
    StateNumbers take(StateNumbers::Direction::take, numbers);
    network.visit_state(take);
    return numbers;
  };
  try
  {
    const std::vector<double> next =
        Shooting(scales).next(state_of(at_begin), state_of(at_end), period, periods);
    // A state is one only if a step goes on from it; the trial costs nothing beside a period.
    set(with_state(at_begin, next));
    advance(times.front());
    set(with_state(at_end, next));
  }
  catch (const StepFailure &)
  {
    set(at_end);
    return false;
  }
  ++iterations;
  return true;
}
} // namespace Continua
