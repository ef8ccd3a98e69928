#include <continua/continuum/kept_state.h>

#include <algorithm>

namespace Continua
{
/// Copies the state; the copies grow to what is there.
class KeptState::Copy : public NumbersVisitor
{
public:
  explicit Copy(KeptState &kept) : kept(kept) {}
  void take_levels(double *const present, double *const older, const std::size_t n) override
  {
    copy(present, n, kept.present, n_levels);
    copy(older, n, kept.older, n_levels);
    n_levels += n;
  }
  void take_values(double *const numbers, const std::size_t n) override
  {
    copy(numbers, n, kept.others, n_others);
    n_others += n;
  }

private:
  KeptState &kept;
  std::size_t n_levels = 0, n_others = 0;

  static void
  copy(const double *const from, const std::size_t n, Numbers &to, const std::size_t first)
  {
    if (to.size() < first + n)
      to.resize(first + n);
    std::copy(from, from + n, to.begin() + first);
  }
};

class KeptState::Return : public NumbersVisitor
{
public:
  explicit Return(const KeptState &kept) : kept(kept) {}
  void take_levels(double *const present, double *const older, const std::size_t n) override
  {
    std::copy_n(kept.present.begin() + n_levels, n, present);
    std::copy_n(kept.older.begin() + n_levels, n, older);
    n_levels += n;
  }
  void take_values(double *const numbers, const std::size_t n) override
  {
    std::copy_n(kept.others.begin() + n_others, n, numbers);
    n_others += n;
  }

private:
  const KeptState &kept;
  std::size_t n_levels = 0, n_others = 0;
};

/// older = the mean of the three levels by weights.
class KeptState::Move : public NumbersVisitor
{
public:
  Move(const KeptState &kept, const StepErrorEstimate::Weights &weights)
      : kept(kept), weights(weights)
  {
  }
  void take_levels(double *const present, double *const older, const std::size_t n) override
  {
    const double *const eldest = kept.eldest.data() + n_levels;
    for (std::size_t i = 0; i < n; ++i)
      older[i] = weights[0] * present[i] + weights[1] * older[i] + weights[2] * eldest[i];
    n_levels += n;
  }
  void take_values(double *, std::size_t) override {}

private:
  const KeptState &kept;
  const StepErrorEstimate::Weights weights;
  std::size_t n_levels = 0;
};

/// Exchanges the older level with other numbers.
class KeptState::Exchange : public NumbersVisitor
{
public:
  explicit Exchange(Numbers &numbers) : numbers(numbers) {}
  void take_levels(double *, double *const older, const std::size_t n) override
  {
    std::swap_ranges(older, older + n, numbers.begin() + n_levels);
    n_levels += n;
  }
  void take_values(double *, std::size_t) override {}

private:
  Numbers &numbers;
  std::size_t n_levels = 0;
};

void KeptState::forget()
{
  for (Numbers *const numbers : {&present, &older, &eldest, &others})
    numbers->clear();
  estimate = kept_estimate = StepErrorEstimate();
}

void KeptState::keep()
{
  in_use = true;
  eldest.swap(older);
  Copy copy(*this);
  state(copy);
  // After the first time there is nothing that could be two steps old.
  eldest.resize(older.size());
  kept_estimate = estimate;
}

void KeptState::give_back()
{
  Return give(*this);
  state(give);
  estimate = kept_estimate;
}

bool KeptState::move_older_level(const Step &step)
{
  if (!in_use || !estimate.wants_another_level(step))
    return false;
  Move move(*this, estimate.weights_of_level(step.older_distance));
  state(move);
  return true;
}

void KeptState::advance(const Step &step)
{
  if (in_use)
    estimate.advance(step);
}

void KeptState::velocity_error(const double *const velocity,
                               double *const error,
                               const std::size_t n) const
{
  const StepErrorEstimate::Weights &weights = estimate.prediction();
  const double factor = estimate.factor();
  for (std::size_t i = 0; i < n; ++i)
    error[i] = factor * (velocity[i] - weights[0] * present[i] - weights[1] * older[i] -
                         weights[2] * eldest[i]);
}

void KeptState::save(ArchiveWriter &archive, StateVisitor &save_older) const
{
  if (!in_use || older.empty())
    return;
  // The older level of the last step's start is the eldest of the next one.
  Numbers numbers = older;
  for (unsigned int i = 0; i < 2; ++i)
  {
    Exchange exchange(numbers);
    state(exchange);
    if (i == 0)
      state(save_older);
  }
  estimate.save(archive);
}

void KeptState::load(const ArchiveReader &archive, StateVisitor &load_older)
{
  if (!StepErrorEstimate::is_in(archive))
    return;
  state(load_older);
  keep();
  estimate.load(archive);
}
} // namespace Continua
