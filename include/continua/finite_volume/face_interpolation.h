#ifndef continua_finite_volume_face_interpolation_h
#define continua_finite_volume_face_interpolation_h

#include <continua/finite_volume/value_space.h>

namespace Continua
{
/**
 * The value of a quantity on a face from the cells beside it (equations 3.1 to 3.5 of the thesis):
 * central is linear interpolation between the two centres; upwind takes the value of the cell the
 * mass flux comes from; blended is gamma central + (1 - gamma) upwind. A face that has a value of
 * its own has that.
 */
template <int dim>
class FaceInterpolation
{
public:
  /// `blending`: gamma [1], 1 central and 0 upwind.
  FaceInterpolation(const CellWiseMesh<dim> &mesh,
                    const ValueSpace<dim> &space,
                    double blending = 1.);

  /// The stencil of the value on a face, seen from one side. `flux` out of the owner: its sign is
  /// what upwinding needs.
  Stencil<double> operator()(unsigned int face, unsigned int side = 0, double flux = 0.) const;

private:
  const CellWiseMesh<dim> &mesh;
  const ValueSpace<dim> &space;
  double blending;
};
} // namespace Continua

#endif
