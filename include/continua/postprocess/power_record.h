#ifndef continua_postprocess_power_record_h
#define continua_postprocess_power_record_h

#include <continua/boundary/outlet.h>
#include <continua/continuum/equation_term.h>
#include <continua/postprocess/record.h>
#include <continua/postprocess/run_table.h>

#include <mpi.h>

#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/**
 * The power balance over the run (power.csv): what loads and prescribed velocities put in, where it
 * goes in each material, what is missing, and the energies. Powers hold at the time at which the
 * scheme balances the step, energies at the step's end. Works on every rank alike; rank 0 writes
 * the file.
 */
template <int dim>
class PowerRecord : public Record<dim>
{
public:
  /// `regions`: names by material id; with more than one, each has its own columns. `relaxes`: of
  /// which of them stresses relax; none if empty. They have a column for what that turns into heat.
  /// `outlets` as in the problem; each has a column, and one more if it has stores of its own.
  /// `mesh_changes`: there is a column for the energy that came or went with transfers.
  /// `terms`: those of the problem's equations. `relaxation_is_known`: what relaxation turns into
  /// heat is at hand after each step. There, and where nothing relaxes, a column has what the
  /// scheme loses.
  PowerRecord(MPI_Comm communicator,
              const std::vector<std::string> &regions,
              const std::vector<bool> &relaxes = {},
              const std::vector<Outlet> &outlets = {},
              bool mesh_changes = false,
              const std::vector<EquationTermType> &terms = equation_terms(Problem()),
              bool relaxation_is_known = false);

  // As a record of a run: power.csv.
  void open(ContinuumSolver<dim> &solver, const std::string &folder, bool is_due) override;
  void resume(ContinuumSolver<dim> &solver, const std::string &folder, double time) override;
  void record(const RecordedStep<dim> &step) override;
  void change_mesh(const MeshChange<dim> &change) override;
  void finish(const RecordedEnd<dim> &end) override;

  /// Starts the file. Throws RunError on all ranks.
  void open(const std::string &file);
  /// Continues it after a restart at `restart_time` [s]; call load(), too.
  void open(const std::string &file, double restart_time);

  /// Takes the energy of the initial state, with which later ones are compared; not after a
  /// restart.
  void start(ContinuumSolver<dim> &solver);
  /// To be called after every step, so that the integrals over time are those of the scheme;
  /// `write`: also adds a row to the file and compares the energy. Collective; RunError on rank 0
  /// when the disk refuses.
  void record(ContinuumSolver<dim> &solver, const Step &step, bool write);
  /// The energies before and after the state was carried over to a new mesh.
  void record_transfer(const Energy &before, const Energy &after);

  /**
   * Closes the file and adds the quantities, all of them relative: `power residual` (largest
   * residual over the largest power exchanged), `energy residual` (integral of the residual over
   * time over the largest energy) and `total energy change` (largest deviation of the energy from
   * the initial one, which says something of a body without loads and losses); each only where
   * there is something to compare with. And in J, over the whole run, `work of the loads` and of
   * each region what it took of it: `kinetic energy taken`, `strain energy taken`, `compressive
   * energy taken`, `energy dissipated` (by viscosity). Where stresses relax, the taken energies are
   * those that the springs hold; what else they were given is `energy relaxed`, with what the
   * scheme damps in them. Of each outlet `energy left`, and where it has stores `energy
   * dissipated`: what it has not stored. Where the mesh changes `energy change by transfer`, their
   * sum: by this, too, the energy at the end differs from that at the start. `loss of the scheme`:
   * what the powers gave and the energies do not hold. Throws RunError on all ranks.
   */
  void finish(ContinuumSolver<dim> &solver, Summary &summary);
  /// The names of what finish() adds, with the arguments of the constructor.
  static void name_quantities(const std::vector<std::string> &regions,
                              const std::vector<bool> &relaxes,
                              const std::vector<Outlet> &outlets,
                              bool mesh_changes,
                              const std::vector<EquationTermType> &terms,
                              bool relaxation_is_known,
                              QuantityNames &names);

  /// Writes what is buffered of the file. Throws RunError on all ranks.
  void flush();
  /// As flush(), and waits until the disk has it.
  void flush_to_disk() override;
  std::optional<WrittenTable> table() const override;

  /// The sums and maxima of the steps so far, for a restart.
  void save(ArchiveWriter &archive) const override;
  void load(const ArchiveReader &archive) override;

private:
  struct Totals
  {
    double largest_residual = 0.;      ///< [W]
    double largest_exchanged = 0.;     ///< [W]
    double residual_energy = 0.;       ///< [J]
    double work = 0.;                  ///< of the loads [J]
    double initial_energy = 0.;        ///< [J]
    double largest_energy = 0.;        ///< [J]
    double largest_energy_change = 0.; ///< [J]
    double transfer = 0.;              ///< sum of the energy changes [J]
    double relaxed = 0.;               ///< by relaxation, as far as steps were asked for it [J]
  };
  std::vector<std::string> header() const;
  void compare(double energy);
  /// What the terms that store were given by the scheme's powers and do not hold [J]; negative if
  /// the scheme makes energy.
  double loss_of_scheme(const Energy &energy) const;
  void append(const Power &power, bool with_relaxation);
  bool region_relaxes(const unsigned int region) const
  {
    return region < relaxes.size() && relaxes[region];
  }

  RunTable run_table;
  std::vector<std::string> regions;
  std::vector<bool> relaxes;
  bool any_relaxes, knows_loss;
  bool mesh_changes;
  std::vector<EquationTermType> term_types;
  std::vector<std::string> outlet_names;
  std::vector<bool> outlet_stores; ///< whether they have stores of their own
  Totals totals;
  /// Energies at the start, and their changes by transfers, by term and region [J].
  std::vector<std::vector<double>> initial, transferred;
  std::vector<std::vector<double>> taken; ///< by region and term: powers over time [J]
  std::vector<OutletPower> given;         ///< to outlets, over time [J]
  std::vector<double> row;
};
} // namespace Continua

#endif
