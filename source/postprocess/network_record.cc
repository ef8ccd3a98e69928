#include <continua/base/input_error.h>
#include <continua/base/output_files.h>
#include <continua/postprocess/network_record.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Continua
{
namespace
{
constexpr char network_table[] = "network.csv", network_archive_name[] = "network record",
               network_volume_name[] = "largest error of the network's volume";
} // namespace

template <int dim>
NetworkRecord<dim>::NetworkRecord(const MPI_Comm communicator,
                                  std::shared_ptr<const NetworkParameters> parameters)
    : run_table(communicator),
      parameters(std::move(parameters)),
      stations(*this->parameters),
      largest(stations.n_columns(), -std::numeric_limits<double>::infinity()),
      smallest(largest.size(), std::numeric_limits<double>::infinity())
{
}

template <int dim>
std::vector<std::string> NetworkRecord<dim>::header() const
{
  std::vector<std::string> names = {"time [s]"};
  for (const std::string &column : stations.columns())
    names.push_back(column);
  names.insert(names.end(), {"volume [m^3]", "inflow [m^3]"});
  return names;
}

template <int dim>
void NetworkRecord<dim>::add_row(const Network &network, const double time, const bool writes)
{
  row.assign({time});
  stations.append_values(network, row);
  for (std::size_t i = 0; i < largest.size(); ++i)
  {
    largest[i] = std::max(largest[i], row[i + 1]);
    smallest[i] = std::min(smallest[i], row[i + 1]);
  }
  largest_difference =
      std::max(largest_difference, std::abs(network.volume() - volume_at_start - network.inflow()));
  row.insert(row.end(), {network.volume(), network.inflow()});
  if (writes)
    run_table.row(row);
}

template <int dim>
void NetworkRecord<dim>::open(ContinuumSolver<dim> &solver,
                              const std::string &folder,
                              const bool is_due)
{
  run_table.open(output_file(folder, network_table), header());
  const Network &network = *solver.network();
  volume_at_start = network.volume();
  add_row(network, 0., is_due);
}

template <int dim>
void NetworkRecord<dim>::resume(ContinuumSolver<dim> & /*solver*/,
                                const std::string &folder,
                                const double time)
{
  run_table.resume(output_file(folder, network_table), header(), time);
}

template <int dim>
void NetworkRecord<dim>::record(const RecordedStep<dim> &step)
{
  if (step.ends_step)
    add_row(*step.solver.network(), step.time, step.is_due);
}

template <int dim>
void NetworkRecord<dim>::finish(const RecordedEnd<dim> &end)
{
  run_table.flush();
  std::size_t column = 0;
  for (std::size_t s = 0; s < stations.n_stations(); ++s)
    for (const NetworkStations::Field &field : stations.fields(s))
    {
      if (field.has_extremes)
      {
        end.summary.add({"largest " + field.name, largest[column], field.unit, stations.name(s)});
        end.summary.add({"smallest " + field.name, smallest[column], field.unit, stations.name(s)});
      }
      ++column;
    }
  end.summary.add({network_volume_name, largest_difference / volume_at_start, "1", ""});
}

template <int dim>
void NetworkRecord<dim>::name_quantities(const NetworkParameters &parameters, QuantityNames &names)
{
  const NetworkStations stations(parameters);
  for (std::size_t s = 0; s < stations.n_stations(); ++s)
    for (const NetworkStations::Field &field : stations.fields(s))
      for (const std::string kind : {"largest ", "smallest "})
        if (field.has_extremes)
          names.add(kind + field.name, stations.name(s));
  names.add(network_volume_name);
}

template <int dim>
void NetworkRecord<dim>::save(ArchiveWriter &archive) const
{
  std::vector<double> values = {volume_at_start, largest_difference};
  values.insert(values.end(), largest.begin(), largest.end());
  values.insert(values.end(), smallest.begin(), smallest.end());
  archive.add(network_archive_name, values);
}

template <int dim>
void NetworkRecord<dim>::load(const ArchiveReader &archive)
{
  const std::vector<double> values = archive.values(network_archive_name);
  const std::size_t n = largest.size();
  if (values.size() != 2 + 2 * n)
    throw RunError("the checkpoint's record of the network is that of other stations");
  volume_at_start = values[0];
  largest_difference = values[1];
  std::copy_n(values.begin() + 2, n, largest.begin());
  std::copy_n(values.begin() + 2 + n, n, smallest.begin());
}

template class NetworkRecord<2>;
template class NetworkRecord<3>;
} // namespace Continua
