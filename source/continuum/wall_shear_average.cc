#include <continua/continuum/wall_shear_average.h>

#include <algorithm>

namespace Continua
{
void WallShearAverage::reinit()
{
  if (!is_on())
    return;
  const DistributedVector zero = operators.velocity_vector();
  for (DistributedVector *vector : {&next, &between, &magnitudes})
    vector->reinit(zero);
}

void WallShearAverage::visit(StateVisitor &visitor)
{
  if (!is_on())
    return;
  visitor.vector("wall shear stress", StateKind::velocity, present);
  visitor.vector("integral of the wall shear stress", StateKind::velocity, sum);
  visitor.vector("integral of its magnitude", StateKind::velocity, magnitude_sum);
  visitor.value("time of the average", time);
}

void WallShearAverage::start(const State &state)
{
  if (!is_on())
    return;
  sum = 0.;
  magnitude_sum = 0.;
  time = 0.;
  operators.wall_shear()->set(state, present);
}

void WallShearAverage::follow_mesh(const State &state)
{
  if (!is_on())
    return;
  operators.wall_shear()->set(state, present);
  // Nodes that are new inside the liquid have got values between those of a wall and 0.
  operators.wall_shear()->keep_walls_alone(sum);
  operators.wall_shear()->keep_walls_alone(magnitude_sum);
}

void WallShearAverage::advance(const Step &step, const State &state)
{
  if (!is_on())
    return;
  operators.wall_shear()->set(state, next);
  const double size = step.time - step.time_old,
               begin = std::max(step.time_old, problem.wall_shear_window.begin),
               end = std::min(step.time, problem.wall_shear_window.end);
  if (size > 0. && end > begin)
  {
    add((begin - step.time_old) / size, 0.5 * (end - begin));
    add((end - step.time_old) / size, 0.5 * (end - begin));
    time += end - begin;
  }
  present.equ(1., next);
}

void WallShearAverage::add(const double fraction, const double weight)
{
  between.equ(1. - fraction, present);
  between.add(fraction, next);
  sum.add(weight, between);
  operators.wall_shear()->set_magnitudes(between, magnitudes);
  magnitude_sum.add(weight, magnitudes);
}
} // namespace Continua
