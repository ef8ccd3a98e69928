#ifndef continua_postprocess_probe_entries_h
#define continua_postprocess_probe_entries_h

#include <continua/base/parameter_section.h>
#include <continua/base/words.h>
#include <continua/boundary/boundary_condition.h>
#include <continua/continuum/continuum_solver.h>
#include <continua/materials/model.h>
#include <continua/mesh/geometry.h>
#include <continua/postprocess/stations.h>

#include <deal.II/grid/tria.h>

#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/// What a run has not, and probes can ask for.
struct ProbeLimits
{
  bool is_cell_wise = false;       ///< no samples of fields
  bool is_modal = false;           ///< no step
  bool is_in_time = true;          ///< else no mean over time
  bool is_finite = false;          ///< deformation, in which the volume is no linear function
  std::vector<bool> is_solid = {}; ///< by material id: a mean is that of liquids on their walls
  bool mesh_moves = false;         ///< of liquids
};

template <int dim>
class ProbeChecks;

/**
 * One child of the section Probes: its entries, read and checked, and what they ask of a solver.
 * The order of calls: the constructor before there is a mesh, check() and check_limits() on the
 * coarse mesh, then recorded().
 */
template <int dim>
class ProbeEntries
{
public:
  enum class Place
  {
    point,
    boundary,
    interface,
    section,
    volume,
    stations
  };
  /// Each place by the entry that gives it.
  static const Words<Place> &place_words();

  /// Declares and reads the entries; `boundaries` and `regions` are the names by boundary and
  /// material id, `branches` and `interfaces` those of the geometry. Throws InputError.
  ProbeEntries(const ParameterSection &section,
               const std::vector<std::string> &boundaries,
               const std::vector<std::string> &regions,
               const std::vector<VesselBranch<dim>> &branches,
               const std::vector<NamedInterface> &interfaces);

  /// A number that is recorded: its field, with the unit of the number, and the solver's numbers of
  /// which it is the sum, with their factors.
  struct Recorded
  {
    FieldComponent field;
    std::vector<std::pair<ProbeRequest<dim>, double>> terms;
  };
  /// What a probe without stations records, out of the solver's `fields`. Throws InputError.
  std::vector<Recorded> recorded(const std::vector<FieldComponent> &fields, Model model) const;

  /// See Probes::check(). Throws InputError.
  void check(const dealii::Triangulation<dim> &coarse_mesh,
             const std::vector<FieldComponent> &fields,
             const std::set<std::pair<unsigned int, unsigned int>> &boundary_regions);
  /// Refuses what the run has not, and forces on boundaries of which each condition leaves all
  /// motion free. Throws InputError.
  void check_limits(const std::vector<BoundaryCondition> &conditions,
                    const ProbeLimits &limits,
                    const std::vector<FieldComponent> &fields) const;
  /// Whether it has a mean over time.
  bool asks_for_averages(const std::vector<FieldComponent> &fields) const;

  ParameterSection section;
  std::vector<std::string> fields; ///< as written
  Stations<dim> stations;
  bool signal_analysis = true;
  std::vector<double> modes; ///< start values [Hz]
  unsigned int last_periods = 0;
  Place place = Place::point;

private:
  friend class ProbeChecks<dim>;
  enum class Value
  {
    mean,
    integral
  };

  std::vector<double> point, reference_point;
  bool moves_with_mesh = true; ///< of points
  std::vector<std::string> boundaries, reference_boundaries, interface;
  std::map<unsigned int, std::string> names_of_boundaries; ///< by boundary id
  double position = std::numeric_limits<double>::quiet_NaN(),
         reference_position = std::numeric_limits<double>::quiet_NaN(); ///< of sections [m]
  std::string volume;                                                   ///< name of its region
  Value value = Value::mean;
  std::string region;
  unsigned int n_sign_changes = 0;
  unsigned int sign_change_coordinate = 0;
  std::vector<double> sign_change_range; ///< [m]
  ProbeRequest<dim> request;             ///< all but the field
  ProbeRequest<dim> reference;           ///< where values are taken off
  bool has_reference = false;

  void read_entries();
  void set_place();
  void set_requests(const std::vector<std::string> &known_boundaries,
                    const std::vector<std::string> &known_regions,
                    const std::vector<VesselBranch<dim>> &branches,
                    const std::vector<NamedInterface> &interfaces);
  /// The sides of an Interface, which is given by two regions, or by its name and the Region.
  void set_interface(const std::vector<std::string> &known_regions,
                     const std::vector<NamedInterface> &interfaces);
  /// Refuses the name of an interface where boundaries are named.
  void refuse_interfaces(const std::string &key,
                         const std::vector<std::string> &names,
                         const std::vector<NamedInterface> &interfaces) const;
  void set_boundaries(const std::string &key,
                      const std::vector<std::string> &names,
                      const std::vector<std::string> &known,
                      ProbeRequest<dim> &of_place);
  /// Whether the place is a boundary or an interface.
  bool is_on_wall() const { return place == Place::boundary || place == Place::interface; }
  /// The fields by component.
  std::vector<FieldComponent> components(const std::vector<FieldComponent> &fields) const;
  bool asks_for_forces() const;
};
} // namespace Continua

#endif
