#include <continua/base/input_error.h>
#include <continua/base/output_files.h>
#include <continua/postprocess/mass_record.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
namespace
{
constexpr char mass_table[] = "mass.csv", residual_name[] = "mass residual",
               archive_name[] = "mass record";
}

template <int dim>
std::vector<std::string> MassRecord<dim>::header()
{
  return {"time [s]", "mass of the liquids [kg]", "inflow [kg]", "residual [kg]"};
}

template <int dim>
void MassRecord<dim>::open(ContinuumSolver<dim> &solver,
                           const std::string &folder,
                           const bool /*is_due*/)
{
  run_table.open(output_file(folder, mass_table), header());
  // A search before the start has an inflow of its own.
  at_start = solver.liquid_mass();
}

template <int dim>
void MassRecord<dim>::resume(ContinuumSolver<dim> & /*solver*/,
                             const std::string &folder,
                             const double time)
{
  run_table.resume(output_file(folder, mass_table), header(), time);
}

template <int dim>
void MassRecord<dim>::record(const RecordedStep<dim> &step)
{
  if (!step.is_due)
    return;
  const LiquidMass mass = step.solver.liquid_mass();
  const double inflow = mass.inflow - at_start.inflow,
               difference = mass.present - at_start.present - inflow;
  largest_difference = std::max(largest_difference, std::abs(difference));
  row.assign({step.time, mass.present, inflow, difference});
  run_table.row(row);
}

template <int dim>
void MassRecord<dim>::finish(const RecordedEnd<dim> &end)
{
  run_table.flush();
  if (at_start.present > 0.)
    end.summary.add({residual_name, largest_difference / at_start.present, "1", ""});
}

template <int dim>
void MassRecord<dim>::name_quantities(QuantityNames &names)
{
  names.add(residual_name);
}

template <int dim>
void MassRecord<dim>::save(ArchiveWriter &archive) const
{
  archive.add(archive_name,
              std::vector<double>{at_start.present, at_start.inflow, largest_difference});
}

template <int dim>
void MassRecord<dim>::load(const ArchiveReader &archive)
{
  const std::vector<double> values = archive.values(archive_name);
  if (values.size() != 3)
    throw RunError("the checkpoint's record of the mass is that of another version of the program");
  at_start = {values[0], values[1]};
  largest_difference = values[2];
}

template class MassRecord<2>;
template class MassRecord<3>;
} // namespace Continua
