#include <continua/continuum/load_list.h>

#include <continua/signal/jump.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace Continua
{
using namespace dealii;

LoadList::Item LoadList::along_normal(const unsigned int condition)
{
  return {nullptr, static_cast<int>(condition), true, -1, 1., false, {}, {}};
}

std::vector<LoadList::Item> LoadList::all_items() const
{
  std::vector<Item> all;
  const auto add = [&](const Waveform &waveform, const int condition, const bool normal_part,
                       const int component, const double sign, const bool times_density) {
    all.push_back({&waveform, condition, normal_part, component, sign, times_density, {}, {}});
  };
  for (unsigned int c = 0; c < problem.interior.body_force.size(); ++c)
    add(problem.interior.body_force[c], -1, false, c, 1., false);
  for (unsigned int c = 0; c < problem.interior.acceleration.size(); ++c)
    add(problem.interior.acceleration[c], -1, false, c, 1., true);
  for (unsigned int i = 0; i < problem.conditions.size(); ++i)
    for (const bool normal_part : {true, false})
    {
      const BoundaryPart &part =
          normal_part ? problem.conditions[i].normal : problem.conditions[i].tangential;
      if (part.kind != BoundaryPart::Kind::traction)
        continue;
      for (unsigned int c = 0; c < part.vector.size(); ++c)
        add(part.vector[c], i, normal_part, c, 1., false);
      if (normal_part)
        add(part.along_normal, i, true, -1, part.negative ? -1. : 1., false);
    }
  return all;
}

void LoadList::build()
{
  items.clear();
  constant = zero_forces();
  for (Item &item : all_items())
  {
    if (item.waveform->is_zero())
      continue;
    if (!item.waveform->depends_on_time())
    {
      integrate(item, item.waveform, 0., constant);
      continue;
    }
    if (!item.waveform->depends_on_space())
    {
      item.unit = zero_forces();
      integrate(item, nullptr, 0., item.unit);
    }
    watch_points(item);
    items.push_back(item);
  }
}

void LoadList::add(const double time, DistributedVector &forces) const
{
  forces.add(1., constant);
  const double origin[3] = {0., 0., 0.};
  for (const Item &item : items)
    if (item.waveform->depends_on_space())
      integrate(item, item.waveform, time, forces);
    else
      forces.add((*item.waveform)(origin, time), item.unit);
}

void LoadList::add_of(const int condition, const double time, DistributedVector &forces) const
{
  for (const Item &item : all_items())
    if (item.condition == condition && !item.waveform->is_zero())
      integrate(item, item.waveform, time, forces);
}

bool LoadList::jumps(const double begin, const double end) const
{
  bool found = false;
  for (const Item &item : items)
    for (const std::array<double, 3> &point : item.watched_points)
      found = found ||
              jumps_within([&](const double time) { return (*item.waveform)(point.data(), time); },
                           begin, end);
  return Utilities::MPI::max(found ? 1 : 0, problem.communicator) == 1;
}

void LoadList::watch_points(Item &item) const
{
  if (!item.waveform->depends_on_space())
  {
    item.watched_points.push_back({{0., 0., 0.}});
    return;
  }
  constexpr unsigned int n_watched = 8;
  const std::vector<std::array<double, 3>> points = places(item);
  const std::size_t n_points = std::min<std::size_t>(n_watched, points.size());
  for (std::size_t i = 0; i < n_points; ++i)
    item.watched_points.push_back(points[i * points.size() / n_points]);
}
} // namespace Continua
