#ifndef continua_postprocess_field_writer_h
#define continua_postprocess_field_writer_h

#include <continua/base/summary.h>
#include <continua/continuum/continuum_solver.h>

#include <mpi.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/**
 * The fields over the body for ParaView: fields.pvd, which lists the times, and the folder fields
 * with a NAME-00000.vtu for each, or on several ranks a NAME-00000.pvtu with a piece
 * NAME-00000.RANK.vtu each. The list is written after the files that it names, whole each time.
 * Methods are collective and throw RunError on all ranks when the disk refuses.
 */
template <int dim>
class FieldWriter
{
public:
  /// `folder`: the output folder, with a folder `fields` in it. `subdivisions` of each cell in each
  /// direction; `higher_order_cells`: they are drawn as one curved cell (Lagrange cells of VTK).
  FieldWriter(MPI_Comm communicator,
              const std::string &folder,
              unsigned int subdivisions,
              bool higher_order_cells,
              const std::string &name = "solution");

  /// Continues after a restart at `restart_time` [s]: entries up to it are kept.
  void resume(double restart_time);
  /// Writes the present state under `time` [s]; a second state at the same time replaces the first.
  void write(ContinuumSolver<dim> &solver, double time);
  /// Adds the fields' units to the summary; nothing if no field was written.
  void finish(Summary &summary) const;

private:
  void write_list() const;

  MPI_Comm communicator;
  std::string folder;
  unsigned int subdivisions;
  bool higher_order_cells;
  std::string name;
  std::vector<std::pair<double, std::string>> entries; ///< time [s] and file, from the folder
  std::map<std::string, std::string> units;            ///< of the fields
};
} // namespace Continua

#endif
