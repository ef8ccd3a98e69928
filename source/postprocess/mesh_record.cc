#include <continua/base/input_error.h>
#include <continua/postprocess/mesh_record.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
template <int dim>
void MeshRecord<dim>::set(const SolverSizes &sizes)
{
  cells.present = sizes.n_cells;
  unknowns.present = 0.;
  for (const auto &field : sizes.n_dofs)
    unknowns.present += field.second;
  for (Count *count : {&cells, &unknowns})
    count->largest = std::max(count->largest, count->present);
}

template <int dim>
void MeshRecord<dim>::start(const SolverSizes &sizes, const double time)
{
  start_time = last_time = time;
  set(sizes);
}

template <int dim>
void MeshRecord<dim>::change(const SolverSizes &sizes,
                             const double time,
                             const double energy_before,
                             const double energy_after)
{
  for (Count *count : {&cells, &unknowns})
    count->times_time += (time - last_time) * count->present;
  last_time = time;
  n_changes += 1.;
  if (energy_before > 0.)
    largest_energy_change =
        std::max(largest_energy_change, std::abs(energy_after - energy_before) / energy_before);
  set(sizes);
}

template <int dim>
void MeshRecord<dim>::finish(const double time, Summary &summary) const
{
  summary.add({"mesh changes", n_changes, "1", ""});
  summary.add({"largest relative energy change by transfer", largest_energy_change, "1", ""});
  const auto add = [&](const std::string &name, const Count &count)
  {
    if (time > start_time)
      summary.add({name + " (mean)",
                   (count.times_time + (time - last_time) * count.present) / (time - start_time),
                   "1", ""});
    summary.add({name + " (largest)", count.largest, "1", ""});
  };
  add("cells", cells);
  add("unknowns", unknowns);
}

template <int dim>
void MeshRecord<dim>::name_quantities(QuantityNames &names)
{
  names.add("mesh changes");
  names.add("largest relative energy change by transfer");
  for (const std::string name : {"cells", "unknowns"})
  {
    names.add(name + " (mean)");
    names.add(name + " (largest)");
  }
}

template <int dim>
void MeshRecord<dim>::save(ArchiveWriter &archive) const
{
  archive.add("mesh record",
              std::vector<double>{start_time, last_time, cells.present, cells.largest,
                                  cells.times_time, unknowns.present, unknowns.largest,
                                  unknowns.times_time, n_changes, largest_energy_change});
}

template <int dim>
void MeshRecord<dim>::load(const ArchiveReader &archive)
{
  const std::vector<double> values = archive.values("mesh record");
  if (values.size() != 10)
    throw RunError("the checkpoint's mesh record is that of another version of the program");
  start_time = values[0];
  last_time = values[1];
  cells = {values[2], values[3], values[4]};
  unknowns = {values[5], values[6], values[7]};
  n_changes = values[8];
  largest_energy_change = values[9];
}

template class MeshRecord<2>;
template class MeshRecord<3>;
} // namespace Continua
