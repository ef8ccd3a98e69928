#ifndef continua_postprocess_mass_record_h
#define continua_postprocess_mass_record_h

#include <continua/postprocess/record.h>
#include <continua/postprocess/run_table.h>

#include <mpi.h>

#include <optional>
#include <vector>

namespace Continua
{
/**
 * The mass of the liquids on a mesh that moves beside what has flowed in (mass.csv), and the
 * largest difference over the mass at the start (`mass residual`), over the rows of the table. It
 * is an error of the step of time, and of the transfer where the mesh changes. Rank 0 writes the
 * file.
 */
template <int dim>
class MassRecord : public Record<dim>
{
public:
  explicit MassRecord(MPI_Comm communicator) : run_table(communicator) {}

  void open(ContinuumSolver<dim> &solver, const std::string &folder, bool is_due) override;
  void resume(ContinuumSolver<dim> &solver, const std::string &folder, double time) override;
  void record(const RecordedStep<dim> &step) override;
  void finish(const RecordedEnd<dim> &end) override;
  static void name_quantities(QuantityNames &names);
  void save(ArchiveWriter &archive) const override;
  void load(const ArchiveReader &archive) override;
  void flush_to_disk() override { run_table.flush_to_disk(); }
  std::optional<WrittenTable> table() const override { return run_table.written(); }

private:
  RunTable run_table;
  LiquidMass at_start;            ///< [kg]
  double largest_difference = 0.; ///< mass - mass at the start - inflow [kg]
  std::vector<double> row;

  static std::vector<std::string> header();
};
} // namespace Continua

#endif
