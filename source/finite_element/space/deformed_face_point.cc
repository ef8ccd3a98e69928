#include <continua/finite_element/space/deformed_face_point.h>

namespace Continua
{
using namespace dealii;

template <int dim>
Kinematics DeformedFacePoint<dim>::kinematics(const Vector<double> &displacement) const
{
  Tensor<2, dim> gradient;
  double radial = 0.;
  for (unsigned int a = 0; a < n_functions(); ++a)
  {
    for (unsigned int c = 0; c < dim; ++c)
      gradient[c] += displacement[c * n_functions() + a] * gradients[a];
    radial += displacement[n_functions() + a] * values[a];
  }
  return Kinematics(whole_gradient<dim>(gradient, radial * hoop));
}

template <int dim>
Tensor<1, dim> DeformedFacePoint<dim>::value_of(const Vector<double> &entries) const
{
  Tensor<1, dim> sum;
  for (unsigned int c = 0; c < dim; ++c)
    for (unsigned int a = 0; a < n_functions(); ++a)
      sum[c] += entries[c * n_functions() + a] * values[a];
  return sum;
}

template <int dim>
std::array<Tensor<1, 3>, dim> DeformedFacePoint<dim>::area_derivatives(
    const Kinematics &motion, const Tensor<1, 3> &present_area, const unsigned int function) const
{
  Tensor<2, 3> by_reference;
  for (unsigned int c = 0; c < dim; ++c)
    by_reference[0][c] = gradients[function][c];
  const Tensor<1, 3> slope = motion.gradient(by_reference)[0]; // by the present place
  const double of_hoop = values[function] * hoop * motion.inverse()[2][2];
  std::array<Tensor<1, 3>, dim> derivatives;
  for (unsigned int d = 0; d < dim; ++d)
  {
    // d(n da) = div(du) n da - (grad du)^T n da.
    const double divergence = slope[d] + (d == 1 ? of_hoop : 0.);
    derivatives[d] = divergence * present_area;
    derivatives[d] -= present_area[d] * slope;
    if (d == 1)
      derivatives[d][2] -= of_hoop * present_area[2];
  }
  return derivatives;
}

template <int dim>
std::vector<DeformedFacePoint<dim>> deformed_face_points(const Space<dim> &space,
                                                         const FEFaceValues<dim> &values)
{
  std::vector<DeformedFacePoint<dim>> points(values.n_quadrature_points);
  for (unsigned int q = 0; q < points.size(); ++q)
  {
    DeformedFacePoint<dim> &point = points[q];
    point.place = values.quadrature_point(q);
    const double size = values.JxW(q) * space.circumference(point.place);
    for (unsigned int c = 0; c < dim; ++c)
      point.area[c] = size * values.normal_vector(q)[c];
    point.hoop = space.is_axisymmetric() ? 1. / point.place[1] : 0.;
    for (unsigned int a = 0; a < values.dofs_per_cell; ++a)
    {
      point.values.push_back(values.shape_value(a, q));
      point.gradients.push_back(values.shape_grad(a, q));
    }
  }
  return points;
}

template struct DeformedFacePoint<2>;
template struct DeformedFacePoint<3>;
template std::vector<DeformedFacePoint<2>> deformed_face_points(const Space<2> &,
                                                                const FEFaceValues<2> &);
template std::vector<DeformedFacePoint<3>> deformed_face_points(const Space<3> &,
                                                                const FEFaceValues<3> &);
} // namespace Continua
