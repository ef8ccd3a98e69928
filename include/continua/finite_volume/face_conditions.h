#ifndef continua_finite_volume_face_conditions_h
#define continua_finite_volume_face_conditions_h

#include <continua/boundary/boundary_condition.h>
#include <continua/finite_volume/cell_wise_space.h>
#include <continua/finite_volume/swept_volumes.h>
#include <continua/linear_algebra/distributed_vector.h>

#include <array>
#include <vector>

namespace Continua
{
/**
 * What the boundary conditions are on the boundary faces of this rank: the directions in which the
 * face's velocity is prescribed, what it is, and the traction in the others. Every face has a value
 * of its own, so faces cannot contradict each other.
 */
template <int dim>
class FaceConditions
{
public:
  struct Face
  {
    unsigned int face = 0;            ///< of the mesh
    unsigned int index = 0;           ///< local, of its velocity's first component
    unsigned int condition = 0;       ///< its number
    double weight = 0.;               ///< of its equations: area, on the axis plane area
    std::array<double, 3> place = {}; ///< of its undeformed centre, which formulas have [m]
    /// Projector on the directions in which the velocity is prescribed.
    dealii::Tensor<2, dim> prescribed;
    bool normal_is_prescribed = false;
    std::vector<double> flow_shapes; ///< of a flow rate; else empty
  };

  FaceConditions(const CellWiseSpace<dim> &space, const std::vector<BoundaryCondition> &conditions);

  /// Finds the faces of the present mesh, which is at rest.
  void build();
  /// Takes the present shapes of the faces. Whether directions in which a velocity is prescribed
  /// have turned on a rank.
  bool take_shapes();
  const std::vector<Face> &faces() const { return boundary_faces; }
  /// The one of a boundary face of the mesh that belongs to an owned cell.
  const Face &of_face(const unsigned int face) const
  {
    return boundary_faces[number_of_face[face]];
  }

  /// The prescribed velocity at those faces, in the prescribed directions [m/s]; other entries
  /// stay.
  void evaluate(double time, DistributedVector &velocity) const;
  /// Gives a liquid whose mesh moves with it the normal velocity by which the face sweeps its
  /// volume, so that nothing passes [m/s].
  void follow(const SweptVolumes<dim> &swept_volumes, DistributedVector &velocity) const;
  bool is_homogeneous() const { return homogeneous; }
  /// Sets the prescribed directions of a vector of equations to zero.
  void clear_prescribed(DistributedVector &vector) const;
  /// Gives a velocity what is prescribed, in its directions.
  void set_prescribed(const DistributedVector &prescribed, DistributedVector &velocity) const;
  /// The prescribed directions of a velocity, other entries zero.
  void prescribed_part(const DistributedVector &velocity, DistributedVector &part) const;
  /// The traction that is prescribed on a face, in the other directions [Pa].
  dealii::Tensor<1, dim> traction(const Face &face, double time) const;
  /// Whether a prescribed velocity jumps between the two times [s].
  bool jumps(double begin, double end) const;

private:
  const CellWiseSpace<dim> &space;
  const std::vector<BoundaryCondition> &conditions;
  std::vector<Face> boundary_faces;
  std::vector<unsigned int> number_of_face;
  bool homogeneous = true;

  dealii::Tensor<1, dim> prescribed_velocity(const Face &face, double time) const;
  void set_flow_shapes(unsigned int condition);
};
} // namespace Continua

#endif
