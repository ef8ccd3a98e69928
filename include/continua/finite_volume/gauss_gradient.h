#ifndef continua_finite_volume_gauss_gradient_h
#define continua_finite_volume_gauss_gradient_h

#include <continua/finite_volume/face_interpolation.h>

namespace Continua
{
/**
 * The gradient of a quantity in a cell by Gauss's theorem, sum over the faces of area n value over
 * the volume (equation 3.6), with plane areas in axisymmetry (what curvature adds, the hoop strain
 * u_r/r, is not a gradient). Where the line of centres misses the middle of a face (skewed cells,
 * hanging nodes) the central value is corrected by the offset times an interpolated gradient that
 * is itself exact for linear functions, so that linear functions have their exact gradient on every
 * mesh of flat-faced cells. Made once on a mesh, for the cells of this rank and its ghosts.
 */
template <int dim>
class GaussGradient
{
public:
  GaussGradient(const CellWiseMesh<dim> &mesh, const ValueSpace<dim> &space);

  /// Makes the stencils on the present mesh; collective.
  void build();

  /// Of a cell, owned or ghost [1/m].
  const Stencil<dealii::Tensor<1, dim>> &operator()(const unsigned int cell) const
  {
    return of_cell[cell];
  }
  /// Interpolated between the two cells of a face (equation 3.13); of the cell on `side` where the
  /// face has a value of its own.
  Stencil<dealii::Tensor<1, dim>> on_face(unsigned int face, unsigned int side = 0) const;
  /// The value on a face, with the correction for skewness.
  Stencil<double> face_value(unsigned int face, unsigned int side = 0) const;

private:
  using Gradients = std::vector<Stencil<dealii::Tensor<1, dim>>>;

  /// From where the line of centres meets the plane of a face to the face's centre [m]; 0 where it
  /// is so but for round-off, and on faces with their own value.
  dealii::Tensor<1, dim> offset(unsigned int face) const;
  /// Exact for linear functions: least squares over the values beyond the cell's faces.
  Stencil<dealii::Tensor<1, dim>> least_squares(unsigned int cell) const;
  /// Interpolated between the two cells of a face without a value.
  Stencil<dealii::Tensor<1, dim>> between(unsigned int face, const Gradients &gradients) const;
  /// Fetches those of the ghosts.
  void exchange(Gradients &gradients) const;

  const CellWiseMesh<dim> &mesh;
  const ValueSpace<dim> &space;
  Gradients of_cell;
  Gradients first; ///< for the correction of skewness: of cells beside faces that need it
};
} // namespace Continua

#endif
