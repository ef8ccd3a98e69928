#ifndef continua_postprocess_stations_h
#define continua_postprocess_stations_h

#include <continua/base/parameter_section.h>
#include <continua/continuum/continuum_solver.h>
#include <continua/mesh/vessel_branch.h>

#include <deal.II/grid/tria.h>

#include <array>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/**
 * What a user of a tube measures at stations along its axis: the entries `Stations`, `Branch`,
 * `Fluid`, `Pair distance` and `Pair` of a probe, and the fields that it then may have. The axis is
 * that of the vessel's branch, or the x axis where the geometry has none of its own. Each is a
 * sum of numbers that the solver can tell:
 *
 * - `pressure`: mean over the fluid's section [Pa];
 * - `axis pressure`: on the axis [Pa];
 * - `flow rate`: by the discrete balance of mass (see SectionFlow), of the whole tube, also where a
 *   part of its circumference is modelled [m^3/s];
 * - `velocity integral`: of the axial velocity over the section, of the whole tube [m^3/s];
 * - `wall distension`: change of the inner diameter, twice the mean radial displacement of the
 *   inner wall round the rim of the fluid's section [m];
 * - `pressure gradient`: difference between the section means of a pair, one pair distance apart,
 *   over that distance [Pa/m]; the station is the middle of the pair or its first section. Where
 *   the sections move, the distance grows as the line between their middles;
 * - `wall shear stress`: mean round the rim, on the fluid's side, positive when the fluid drags the
 *   wall downstream [Pa];
 * - `hoop stress`: mean over the section of the wall, which is every region but the fluid [Pa].
 */
template <int dim>
class Stations
{
public:
  /// A number as a sum of what the solver tells.
  struct Column
  {
    unsigned int station; ///< its place in positions()
    FieldComponent field;
    std::vector<std::pair<ProbeRequest<dim>, double>> terms; ///< with their factors
    /// Of a pressure gradient: from the first section to the second, undeformed [m], and by
    /// component how far the second one has moved against the first one, as a sum likewise.
    dealii::Tensor<1, dim> line;
    std::vector<std::vector<std::pair<ProbeRequest<dim>, double>>> movements;
  };

  /// Declares the entries and reads them.
  void add_entries(ParameterSection section);
  bool given() const { return !station_positions.empty(); }
  /// The probe's `Fields`, the regions' names by material id, and the branches of the geometry.
  /// Throws InputError.
  void set(const ParameterSection &section,
           const std::vector<std::string> &fields,
           const std::vector<std::string> &regions,
           const std::vector<VesselBranch<dim>> &branches);
  /// Refuses what the body does not have: a station, or the other one of a pair, outside the
  /// fluid; hoop stress where there is no wall; the axis pressure beside the axis. Finds what part
  /// of the circumference is modelled. Throws InputError.
  void check(const ParameterSection &section, const dealii::Triangulation<dim> &coarse_mesh);

  const std::vector<double> &positions() const { return station_positions; } ///< [m]
  const std::vector<std::string> &fields() const { return field_names; }
  unsigned int branch() const { return branch_index; } ///< its place in the geometry's
  double pair_distance() const { return distance; }    ///< [m]
  /// From a station to the first section of its pair [m]: 0 or less.
  double pair_offset() const { return pair == Pair::centred ? -0.5 * distance : 0.; }
  /// In which the first pulse passes: +1 downstream, -1 upstream, 0 by the loads.
  int direction() const { return pulse_direction; }
  /// All columns, by station and field. Integrals are of the part of the circumference that check()
  /// found; of the whole before.
  std::vector<Column> columns() const;
  /// "0.1 m".
  std::string label(unsigned int station) const;

private:
  std::vector<double> station_positions;
  std::vector<std::string> field_names;
  std::string branch_name;
  unsigned int branch_index = 0;
  std::shared_ptr<const VesselAxis<dim>> axis; ///< null: the x axis
  std::string fluid = "fluid";
  double distance = 17e-3;
  enum class Pair
  {
    centred,
    downstream
  };
  Pair pair = Pair::centred;
  int pulse_direction = 0;
  std::set<unsigned int> fluid_ids, wall_ids;
  double n_copies = 1.; ///< of the modelled part in the whole circumference

  bool has(const std::string &field) const;
  /// Finds the branch and its axis.
  void set_branch(const ParameterSection &section, const std::vector<VesselBranch<dim>> &branches);
  /// Between which positions the fluid is [m].
  std::array<double, 2> range(const dealii::Triangulation<dim> &coarse_mesh) const;
  ProbeRequest<dim> request(typename ProbeRequest<dim>::Kind kind,
                            const std::string &field,
                            const std::set<unsigned int> &region_ids,
                            double position) const;
};
} // namespace Continua

#endif
