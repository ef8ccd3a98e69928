#ifndef continua_boundary_boundary_part_h
#define continua_boundary_boundary_part_h

#include <continua/boundary/flow_profile.h>
#include <continua/signal/waveform.h>

#include <memory>
#include <vector>

namespace Continua
{
/**
 * Either the normal or the tangential half of what holds on a boundary. Its value is the vector
 * `vector + along_normal n` of which the half's own part counts; n is the outward normal.
 */
struct BoundaryPart
{
  enum class Kind
  {
    velocity, ///< prescribed [m/s]
    traction  ///< natural [Pa]
  };
  Kind kind = Kind::traction;
  std::vector<Waveform> vector; ///< Cartesian components; empty is zero
  Waveform along_normal; ///< normal part only; a pressure p stands here as -p with `negative`
  bool negative = false;
  /// Of a flow rate, else null: `along_normal` is the flow rate into the body [m^3/s], and the
  /// velocity along the normal is minus the profile's.
  std::shared_ptr<const FlowProfile> flow;
  /// Springs and dampers around the body, which add -(stiffness D + damping U) to the traction. D
  /// is the displacement from the undeformed body.
  double stiffness = 0.; ///< [Pa/m]
  double damping = 0.;   ///< [Pa s/m]

  bool is_zero() const;
  /// Whether the velocity is prescribed to be zero.
  bool is_fixed() const { return kind == Kind::velocity && is_zero(); }
  /// Whether it pushes back where the body moves.
  bool is_supported() const { return stiffness > 0. || damping > 0.; }
  /// Whether nothing acts on the half.
  bool is_free() const { return kind == Kind::traction && is_zero() && !is_supported(); }
  bool depends_on_time() const;
};
} // namespace Continua

#endif
