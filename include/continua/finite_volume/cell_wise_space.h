#ifndef continua_finite_volume_cell_wise_space_h
#define continua_finite_volume_cell_wise_space_h

#include <continua/finite_volume/surface_normal_gradient.h>
#include <continua/linear_algebra/distributed_vector.h>
#include <continua/materials/model.h>

#include <mpi.h>

#include <vector>

namespace Continua
{
/**
 * The cell-wise discretisation on one mesh: its cells and faces, the numbers of velocities (and of
 * every internal displacement) and of pressures, and the elementary operators on both.
 */
template <int dim>
class CellWiseSpace
{
public:
  CellWiseSpace(dealii::parallel::TriangulationBase<dim> &triangulation, Model model);

  /// Measures and numbers the present mesh.
  void distribute();
  /// The vertices of the cells of these materials are at `places` [m].
  void move(const VertexPlaces<dim> &places, const std::vector<bool> &materials_that_move);

  DistributedVector velocity_vector() const { return velocities.vector(dim); }
  DistributedVector pressure_vector() const { return pressures.vector(1); }
  /// Local index of the first component of a value that this rank owns.
  unsigned int local_velocity(const unsigned int value) const
  {
    return dim * (value - velocities.first_owned());
  }
  unsigned int local_pressure(const unsigned int value) const
  {
    return value - pressures.first_owned();
  }
  bool is_axisymmetric() const { return mesh.is_axisymmetric(); }

  /// The gradient on a face as the traction sees it: interpolated between two cells of a region; on
  /// a face with its own value that of the cell on the side, with its normal part replaced by the
  /// surface normal gradient (`replaced`) [1/m].
  Stencil<dealii::Tensor<1, dim>>
  velocity_face_gradient(unsigned int face, unsigned int side, bool replaced) const;
  /// u_r/r on a face and in a cell, as the factor of u_r; empty if not axisymmetric [1/m].
  Stencil<double> face_hoop(unsigned int face, unsigned int side) const;
  Stencil<double> cell_hoop(unsigned int cell) const;

  MPI_Comm communicator;
  CellWiseMesh<dim> mesh;
  ValueSpace<dim> velocities, pressures;
  GaussGradient<dim> velocity_gradient, pressure_gradient;
  SurfaceNormalGradient<dim> velocity_normal_gradient, pressure_normal_gradient;
};
} // namespace Continua

#endif
