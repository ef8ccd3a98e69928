#include <continua/finite_volume/displacement_levels.h>

#include <cmath>

namespace Continua
{
void DisplacementLevels::start(const DistributedVector &displacement,
                               const DistributedVector &velocity,
                               const double size)
{
  for (unsigned int i = 0; i < levels.size(); ++i)
  {
    levels[i].equ(1., displacement);
    levels[i].add(-(i * size), velocity);
  }
  size_old = size;
  n_equal = levels.size() - 1;
}

DisplacementLevels::Derivatives DisplacementLevels::derivatives(const Step &step,
                                                                const bool second_order) const
{
  Derivatives result;
  const double size = step.size();
  const bool equal = std::abs(size - size_old) < 1e-9 * size;
  if (second_order && equal && n_equal >= 2)
  {
    const double scale = 1. / (size * size);
    result.second_own = 2. * scale;
    result.second_known = {{-5. * scale, 4. * scale, -scale}};
    // Of the same order, for what is reported as the velocity.
    result.first_own = 1.5 / size;
    result.first_known = {{-2. / size, 0.5 / size, 0.}};
    return result;
  }
  // With the velocity of the last step for what D_oo stands for.
  const double ratio = size / size_old;
  const double scale = 1. / (size * size);
  result.second_own = scale;
  result.second_known = {{-(1. + ratio) * scale, ratio * scale, 0.}};
  result.first_own = 1. / size;
  result.first_known = {{-1. / size, 0., 0.}};
  return result;
}

void DisplacementLevels::combine(const std::array<double, 3> &known, DistributedVector &sum) const
{
  sum.equ(known[0], levels[0]);
  for (unsigned int i = 1; i < levels.size(); ++i)
    if (known[i] != 0.)
      sum.add(known[i], levels[i]);
}

void DisplacementLevels::advance(const Step &step, const DistributedVector &displacement)
{
  n_equal = std::abs(step.size() - size_old) < 1e-9 * step.size() ? n_equal + 1 : 1;
  size_old = step.size();
  levels[2].swap(levels[1]);
  levels[1].swap(levels[0]);
  levels[0].equ(1., displacement);
}

void DisplacementLevels::visit(StateVisitor &visitor)
{
  for (unsigned int i = 0; i < levels.size(); ++i)
    visitor.vector({"displacement level", i}, StateKind::velocity, levels[i]);
  visitor.value("distance of displacement levels", size_old);
  visitor.value("number of displacement levels", n_equal);
}
} // namespace Continua
