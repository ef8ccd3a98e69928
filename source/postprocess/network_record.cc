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

struct StationField
{
  const char *name, *unit;
  double Vessel::Values::*value;
};
constexpr StationField station_values[] = {{"pressure", "Pa", &Vessel::Values::pressure},
                                           {"flow rate", "m^3/s", &Vessel::Values::flow},
                                           {"area", "m^2", &Vessel::Values::area}};
constexpr std::size_t n_network_fields = 3;
} // namespace

template <int dim>
NetworkRecord<dim>::NetworkRecord(const MPI_Comm communicator,
                                  std::shared_ptr<const NetworkParameters> parameters)
    : run_table(communicator),
      parameters(std::move(parameters)),
      largest(n_network_fields * this->parameters->stations.size(),
              -std::numeric_limits<double>::infinity()),
      smallest(largest.size(), std::numeric_limits<double>::infinity())
{
}

template <int dim>
std::vector<std::string> NetworkRecord<dim>::header() const
{
  std::vector<std::string> names = {"time [s]"};
  for (const NetworkParameters::Station &station : parameters->stations)
    for (const StationField &field : station_values)
      names.push_back(station.name + ": " + field.name + " [" + field.unit + "]");
  names.insert(names.end(), {"volume [m^3]", "inflow [m^3]"});
  return names;
}

template <int dim>
void NetworkRecord<dim>::add_row(const Network &network, const double time, const bool writes)
{
  row.assign({time});
  for (std::size_t s = 0; s < parameters->stations.size(); ++s)
  {
    const NetworkParameters::Station &station = parameters->stations[s];
    const Vessel::Values values = network.vessel(station.vessel_number).values(station.position);
    for (std::size_t f = 0; f < n_network_fields; ++f)
    {
      const double value = values.*station_values[f].value;
      largest[n_network_fields * s + f] = std::max(largest[n_network_fields * s + f], value);
      smallest[n_network_fields * s + f] = std::min(smallest[n_network_fields * s + f], value);
      row.push_back(value);
    }
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
  for (std::size_t s = 0; s < parameters->stations.size(); ++s)
    for (std::size_t f = 0; f < n_network_fields; ++f)
    {
      const std::string name = station_values[f].name, unit = station_values[f].unit,
                        &station = parameters->stations[s].name;
      end.summary.add({"largest " + name, largest[n_network_fields * s + f], unit, station});
      end.summary.add({"smallest " + name, smallest[n_network_fields * s + f], unit, station});
    }
  end.summary.add({network_volume_name, largest_difference / volume_at_start, "1", ""});
}

template <int dim>
void NetworkRecord<dim>::name_quantities(const NetworkParameters &parameters, QuantityNames &names)
{
  for (const NetworkParameters::Station &station : parameters.stations)
    for (const StationField &field : station_values)
      for (const std::string kind : {"largest ", "smallest "})
        names.add(kind + field.name, station.name);
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
