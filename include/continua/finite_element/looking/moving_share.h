#ifndef continua_finite_element_looking_moving_share_h
#define continua_finite_element_looking_moving_share_h

#include <continua/continuum/field_probes.h>
#include <continua/finite_element/looking/field_samples.h>

#include <deal.II/base/tensor.h>

namespace Continua
{
/// What a point has in a probe that follows the mesh: a part of a volume, of an area, or of a line.
/// `direction`: of a line that of the rim's normal in its plane, of a face its normal.
template <int dim>
SampledShare moving_share(const ProbeRequest<dim> &request,
                          const dealii::Tensor<1, dim> &direction);
} // namespace Continua

#endif
