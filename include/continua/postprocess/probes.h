#ifndef continua_postprocess_probes_h
#define continua_postprocess_probes_h

#include <continua/base/parameter_section.h>
#include <continua/base/summary.h>
#include <continua/base/units.h>
#include <continua/boundary/boundary_condition.h>
#include <continua/continuum/continuum_solver.h>
#include <continua/materials/model.h>
#include <continua/postprocess/probe_entries.h>
#include <continua/postprocess/run_table.h>
#include <continua/postprocess/stations.h>

#include <deal.II/grid/tria.h>

#include <mpi.h>

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/// What a column of probes.csv is called.
struct ProbeColumnName
{
  std::string probe; ///< in the parameter file
  std::string name;  ///< of the probe, with the station
  std::string field;
  bool alone; ///< the only field of that name

  /// What the summary calls it.
  std::string label() const { return alone ? name : name + ": " + field; }
  /// Whether "PROBE" or "PROBE: FIELD" names it, of a probe with stations also all of them. A
  /// position may have another unit.
  bool is_meant_by(const std::string &text) const
  {
    const std::string in_si = with_value_in_si(text);
    return text == probe || in_si == name || text == probe + ": " + field ||
           in_si == name + ": " + field || text == name || text == name + ": " + field;
  }
};

/// A probe with stations, for what looks at waves along a tube.
struct StationsProbe
{
  ParameterSection section; ///< of the parameter file, for messages about it
  std::string name;
  std::vector<double> positions;   ///< [m]
  std::vector<std::string> fields; ///< see Stations
  unsigned int branch;             ///< of the geometry's, along which they stand
  double pair_distance;            ///< [m], of the pressure gradients
  double pair_offset;              ///< from a station to the first section of its pair [m]
  int direction;                   ///< of the first pulse: +1, -1, or 0 for that of the loads
  /// The column in Probes of a station and a field.
  std::vector<std::vector<unsigned int>> columns;
};

/**
 * The section Probes: a named family, each child a point of the undeformed body, boundaries, a
 * plane section, an interface, the volume of a region or the stations of a tube, where fields are
 * recorded over time in probes.csv (columns "NAME: FIELD [UNIT]", of stations "NAME 0.1 m: FIELD
 * [UNIT]"), and what these histories say of an oscillation. The order of calls: read() before there
 * is a solver, attach() when it is initialised, open(), record() as often as wanted, finish(). All
 * are collective; the histories are kept on every rank, the file is written by rank 0.
 */
template <int dim>
class Probes
{
public:
  explicit Probes(MPI_Comm communicator);

  /// Declares and reads the section; `boundaries` and `regions` are the names by boundary and
  /// material id, `branches` and `interfaces` those of the geometry. Throws InputError.
  void read(ParameterSection section,
            const std::vector<std::string> &boundaries,
            const std::vector<std::string> &regions,
            const std::vector<VesselBranch<dim>> &branches = {},
            const std::vector<NamedInterface> &interfaces = {});
  /// Refuses, before there is a solver, a field that is not among `fields`, a point that no cell
  /// of the coarse mesh holds (in the region, if one is named), a boundary that the region does not
  /// touch, a section without area and stations outside the tube; `boundary_regions` are the
  /// (boundary, region) pairs that exist. Finds what part of a tube's circumference is modelled.
  /// Throws InputError.
  void check(const dealii::Triangulation<dim> &coarse_mesh,
             const std::vector<FieldComponent> &fields,
             const std::set<std::pair<unsigned int, unsigned int>> &boundary_regions);
  /// Refuses what the run has not, and forces on boundaries of which each condition in `conditions`
  /// leaves all motion free. After check(), with the same `fields`. Throws InputError.
  void check_limits(const std::vector<BoundaryCondition> &conditions,
                    const ProbeLimits &limits,
                    const std::vector<FieldComponent> &fields) const;
  /// The columns that attach() will make, in their order. After check(), with the same `fields`.
  std::vector<ProbeColumnName> expected_columns(const std::vector<FieldComponent> &fields) const;
  /// Whether any has a mean over time. After check(), with the same `fields`.
  bool asks_for_averages(const std::vector<FieldComponent> &fields) const;
  /// Asks the solver, which must live as long as this, for the values. Throws InputError for a
  /// field that it has not and a point outside the mesh. `model` gives integrals their unit: over
  /// a line (per metre of depth) or an area; `mesh_moves`: so that stations come nearer or go
  /// apart.
  void attach(ContinuumSolver<dim> &solver, Model model, bool mesh_moves = false);

  /// Starts the file; without columns there is none. Throws RunError on all ranks.
  void open(const std::string &file);
  /// Continues after a restart at `restart_time` [s]: the file is cut there, and the histories are
  /// what it then holds, double by double.
  void open(const std::string &file, double restart_time);

  /// The values of all columns in the present state [SI], not recorded.
  std::vector<double> present_values();
  /// Records the present state under `time` [s]. RunError on rank 0 when the disk refuses.
  void record(double time);
  /// Records values of all columns [SI] that are not those of the present state.
  void record(double time, const std::vector<double> &values);

  /**
   * Closes the file and adds the quantities of every column with signal analysis, in SI, as far as
   * they exist: `maximum FIELD`, `time of maximum FIELD`, `minimum FIELD`, `time of minimum FIELD`,
   * `first maximum FIELD`, `time of first maximum FIELD`, `mean FIELD`, `frequency` (zero
   * crossings), `frequency of the fit`, `decay per oscillation` (ratio of successive maxima), `fit
   * residual` (relative), for each start value in Modes `mode N frequency`, `mode N decay per
   * oscillation`, `mode N amplitude` (at t = 0) and with them `modes residual`, with Last periods
   * `mean FIELD of the last periods`, `middle ...` and `amplitude FIELD of the last periods`,
   * `frequency of the last periods`, `change of amplitude of the last periods`, and `final FIELD`;
   * after a single record, `final FIELD` only. Their probe is NAME, or "NAME: FIELD" if it has
   * several fields, and of stations "NAME 0.1 m" in place of NAME. Returns what the user should be
   * warned of. Throws RunError on all ranks.
   */
  std::vector<std::string> finish(Summary &summary);
  /// The names of what finish() adds after check(), with the same `fields`; `is_steady`: of a run
  /// with one record.
  void name_quantities(const std::vector<FieldComponent> &fields,
                       bool is_steady,
                       QuantityNames &names) const;
  /// Writes what is buffered of the file. Throws RunError on all ranks.
  void flush();
  /// As flush(), and waits until the disk has it.
  void flush_to_disk();
  /// What is written of the file; none on a rank that does not write it.
  std::optional<WrittenTable> table() const;

  /// "NAME: FIELD [UNIT]" of every column.
  std::vector<std::string> column_names() const;
  unsigned int n_columns() const { return static_cast<unsigned int>(columns.size()); }
  ProbeColumnName name_of(unsigned int column) const;
  /// The solver's probes, and the factors of their sum, that a column is on a mesh that stays.
  const std::vector<std::pair<unsigned int, double>> &terms_of(const unsigned int column) const
  {
    return columns[column].terms;
  }
  const std::string &unit_of(const unsigned int column) const { return columns[column].field.unit; }
  /// The history: times [s], and the values of a column [SI].
  const std::vector<double> &times() const { return record_times; }
  const std::vector<double> &values(unsigned int column) const { return columns[column].values; }
  /// The probes with stations; read() knows them, attach() their columns.
  const std::vector<StationsProbe> &stations() const { return stations_probes; }

private:
  /// The solver's numbers and their factors.
  using Terms = std::vector<std::pair<unsigned int, double>>;
  struct Column
  {
    unsigned int probe;   ///< its place in `probes`
    std::string name;     ///< of the probe, with the station
    FieldComponent field; ///< with the unit of the column
    bool alone;           ///< the only one of that name
    Terms terms;
    std::vector<double> values;
    /// See Stations::Column; empty where the sections stay.
    dealii::Tensor<1, dim> line;
    std::vector<Terms> movements;
  };

  std::vector<ProbeColumnName> columns_of(const ProbeEntries<dim> &probe,
                                          const std::vector<FieldComponent> &fields) const;
  void attach_fields(unsigned int probe, Model model);
  void attach_stations(unsigned int probe, Model model, bool mesh_moves);
  /// The sum of the solver's present numbers.
  double sum_of(const Terms &terms) const;
  /// Asks the solver for the numbers; what it cannot tell is refused as the probe's place.
  Terms add_to_solver(const ProbeEntries<dim> &probe,
                      const std::vector<std::pair<ProbeRequest<dim>, double>> &requests);
  /// Fills the histories from a file.
  void read_history(const std::string &file);
  void
  add_quantities(const Column &column, Summary &summary, std::vector<std::string> &warnings) const;

  MPI_Comm communicator;
  ContinuumSolver<dim> *solver = nullptr;
  std::vector<ProbeEntries<dim>> probes;
  std::vector<Column> columns;
  std::vector<StationsProbe> stations_probes;
  std::vector<double> record_times;
  RunTable run_table;
  std::vector<double> solver_values;
  std::vector<double> row;
};
} // namespace Continua

#endif
