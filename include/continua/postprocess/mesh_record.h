#ifndef continua_postprocess_mesh_record_h
#define continua_postprocess_mesh_record_h

#include <continua/postprocess/record.h>

namespace Continua
{
/// The meshes of a run whose mesh follows the solution: how many, how large, and what carrying the
/// state from one to the next did to the energy.
template <int dim>
class MeshRecord : public Record<dim>
{
public:
  void open(ContinuumSolver<dim> &solver, const std::string & /*folder*/, bool /*is_due*/) override
  {
    start(solver.sizes(), 0.);
  }
  void change_mesh(const MeshChange<dim> &change_of_mesh) override
  {
    change(change_of_mesh.solver.sizes(), change_of_mesh.time, change_of_mesh.before.sum(),
           change_of_mesh.after.sum());
  }
  void finish(const RecordedEnd<dim> &end) override
  {
    finish(end.time_control.time(), end.summary);
  }

  /// The first mesh, at `time` [s].
  void start(const SolverSizes &sizes, double time);
  /// A new one, with the energies before and after the transfer [J].
  void change(const SolverSizes &sizes, double time, double energy_before, double energy_after);
  /**
   * Adds `mesh changes`, `largest relative energy change by transfer` (over the energy before),
   * `cells (mean)`, `cells (largest)`, `unknowns (mean)` and `unknowns (largest)`; means are over
   * the time until `time` [s].
   */
  void finish(double time, Summary &summary) const;
  /// The names of what finish() adds.
  static void name_quantities(QuantityNames &names);

  /// The numbers so far, for a restart.
  void save(ArchiveWriter &archive) const override;
  void load(const ArchiveReader &archive) override;

private:
  struct Count
  {
    double present = 0., largest = 0.;
    double times_time = 0.; ///< integral over the time of the meshes before [s]
  };
  double start_time = 0., last_time = 0.;
  Count cells, unknowns;
  double n_changes = 0.;
  double largest_energy_change = 0.; ///< relative

  void set(const SolverSizes &sizes);
};
} // namespace Continua

#endif
