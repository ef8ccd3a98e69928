#ifndef continua_postprocess_network_record_h
#define continua_postprocess_network_record_h

#include <continua/network/network.h>
#include <continua/network/network_parameters.h>
#include <continua/network/network_stations.h>
#include <continua/postprocess/record.h>
#include <continua/postprocess/run_table.h>

#include <mpi.h>

#include <memory>
#include <optional>
#include <vector>

namespace Continua
{
/**
 * The network at ends of a body (network.csv): pressure, flow rate and area at its stations, and
 * the volume of its liquid beside what has flowed in. Over the rows of the table the summary has
 * the largest and smallest values, and the largest error of the volume. Rank 0 writes the file.
 */
template <int dim>
class NetworkRecord : public Record<dim>
{
public:
  NetworkRecord(MPI_Comm communicator, std::shared_ptr<const NetworkParameters> parameters);

  void open(ContinuumSolver<dim> &solver, const std::string &folder, bool is_due) override;
  void resume(ContinuumSolver<dim> &solver, const std::string &folder, double time) override;
  void record(const RecordedStep<dim> &step) override;
  void finish(const RecordedEnd<dim> &end) override;
  static void name_quantities(const NetworkParameters &parameters, QuantityNames &names);
  void save(ArchiveWriter &archive) const override;
  void load(const ArchiveReader &archive) override;
  void flush_to_disk() override { run_table.flush_to_disk(); }
  std::optional<WrittenTable> table() const override { return run_table.written(); }

private:
  RunTable run_table;
  std::shared_ptr<const NetworkParameters> parameters;
  NetworkStations stations;
  double volume_at_start = 0.;           ///< [m^3]
  double largest_difference = 0.;        ///< volume - volume at the start - inflow [m^3]
  std::vector<double> largest, smallest; ///< by NetworkStations::columns()
  std::vector<double> row;

  std::vector<std::string> header() const;
  void add_row(const Network &network, double time, bool writes);
};
} // namespace Continua

#endif
