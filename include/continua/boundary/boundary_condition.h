#ifndef continua_boundary_boundary_condition_h
#define continua_boundary_boundary_condition_h

#include <continua/boundary/absorbing_end_parameters.h>
#include <continua/boundary/boundary_part.h>
#include <continua/boundary/outlet.h>
#include <continua/signal/waveform.h>

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/// The rows of the table of conditions, see boundary_types().
enum class BoundaryType
{
  fixed,
  velocity,
  traction,
  pressure,
  cavity,
  support,
  flow_rate,
  resistance,
  windkessel,
  network,
  absorbing,
  roller,
  axis,
  free,
  mixed
};

/// Which pressure a boundary's is where liquid that is convected flows in.
enum class InflowPressure
{
  static_pressure, ///< p
  total            ///< p + rho/2 U^2
};

/// What a mesh that moves does on a boundary of a liquid.
enum class MeshCondition
{
  automatic, ///< by the rule of BoundaryCondition::mesh_slides()
  slides,    ///< along a plane normal to an axis
  fixed,
  follows ///< the velocity that is prescribed there, or one of its own
};

/// A flow rate whose distribution over the section is free: one unknown pressure acts on it.
struct FreeFlow
{
  Waveform rate;        ///< into the whole tube, of time alone [m^3/s], in the plane [m^2/s]
  double fraction = 1.; ///< of the section that the mesh has [1]
};

/// What holds on one boundary (of one region, or of all that touch it).
struct BoundaryCondition
{
  std::string name; ///< the child of Boundaries it was read from
  BoundaryType type = BoundaryType::free;
  unsigned int boundary_id = 0;
  std::set<unsigned int> region_ids; ///< regions whose faces it holds for
  BoundaryPart normal;
  BoundaryPart tangential;
  /// Of a plane model, whose flow rates [m^2/s] are those of a unit of depth.
  bool is_in_plane = false;
  /// Of a flow rate, given or an outlet's.
  std::optional<FlowProfile::Shape> profile;
  std::shared_ptr<const ProfileTable> profile_table; ///< of a profile from a table, else null
  FlowPast past = FlowPast::at_rest;                 ///< of a womersley profile
  double period = 0.;                                ///< [s] of a periodic past
  /// Of an outlet, else null: what was read, for the whole tube. It has no port where the tube
  /// itself has to tell the impedance (absorbing), and where a network stands. Its pressure is no
  /// part of `normal`.
  std::shared_ptr<const Outlet> outlet;
  AbsorbingEndParameters absorbing; ///< of Type = absorbing
  std::string node;                 ///< of Type = network: of the network, at the boundary
  InflowPressure inflow_pressure = InflowPressure::static_pressure;
  /// Of a cavity: the volume that it encloses over the undeformed one [1], of time alone.
  Waveform volume_ratio = Waveform(1.);
  std::optional<FreeFlow> free_flow;

  MeshCondition mesh = MeshCondition::automatic;
  /// Of a mesh that follows: Cartesian components, by the undeformed place [m/s]; empty: that of
  /// the liquid.
  std::vector<Waveform> mesh_velocity;

  /// Whether a mesh that moves may slide along the boundary where it is plane. By itself where no
  /// section has to keep its shape: not at walls and prescribed velocities.
  bool mesh_slides() const
  {
    if (mesh != MeshCondition::automatic)
      return mesh == MeshCondition::slides;
    return !is_wall() && (normal.kind == BoundaryPart::Kind::traction || normal.is_fixed()) &&
           (tangential.kind == BoundaryPart::Kind::traction || tangential.is_fixed());
  }
  /// Whether a mesh that moves has the velocity that is prescribed for the liquid.
  bool liquid_carries_mesh() const
  {
    return mesh == MeshCondition::follows && mesh_velocity.empty();
  }
  /// Whether the velocity is prescribed in full, and no liquid passes: it is 0 along the normal, or
  /// the mesh follows it.
  bool is_wall() const
  {
    const bool is_closed =
        normal.is_fixed() || (liquid_carries_mesh() && normal.kind == BoundaryPart::Kind::velocity);
    return is_closed && tangential.kind == BoundaryPart::Kind::velocity;
  }
  /// Whether the boundary encloses a volume that is given, with a pressure that is unknown.
  bool is_cavity() const { return type == BoundaryType::cavity; }
  /// Whether an unknown pressure acts, since a volume or a flow rate is given.
  bool has_unknown_pressure() const { return is_cavity() || free_flow.has_value(); }
  /// Whether what is around the body supports it.
  bool is_supported() const { return normal.is_supported() || tangential.is_supported(); }
  /// A sentence for the log where the prescribed value at t = 0 is not zero at `point` (three
  /// coordinates [m]), so that a body at rest meets a jump; else empty.
  std::string initial_jump(const double *point) const;
  /// Whether a table of this boundary begins with a value that counts beside its range.
  bool table_begins_with_jump() const;
  /// What is to be said of its tables in a run to `end_time` [s], each sentence once.
  std::vector<Waveform::Remark> table_remarks(double end_time) const;

private:
  /// All that it has, for what is said of tables.
  std::vector<const Waveform *> waveforms() const;
};
} // namespace Continua

#endif
