#include <continua/finite_element/looking/moving_share.h>

namespace Continua
{
using namespace dealii;

template <int dim>
SampledShare moving_share(const ProbeRequest<dim> &request, const Tensor<1, dim> &direction)
{
  using Kind = typename ProbeRequest<dim>::Kind;
  SampledShare result;
  Tensor<1, 3> normal, across;
  for (unsigned int c = 0; c < dim; ++c)
  {
    normal[c] = request.is_section() ? request.normal[c] / request.normal.norm() : direction[c];
    across[c] = direction[c];
  }
  switch (request.kind)
  {
  case Kind::volume_mean:
  case Kind::volume_integral:
    result.kind = SampledShare::Kind::volume;
    break;
  case Kind::rim_mean:
    // In the plane of a model in two dimensions it is a point, whose line runs across the plane.
    result.kind = SampledShare::Kind::line;
    result.direction = cross_product_3d(normal, across);
    break;
  default:
    result.kind = SampledShare::Kind::area;
    result.direction = normal;
  }
  return result;
}

template SampledShare moving_share(const ProbeRequest<2> &, const Tensor<1, 2> &);
template SampledShare moving_share(const ProbeRequest<3> &, const Tensor<1, 3> &);
} // namespace Continua
