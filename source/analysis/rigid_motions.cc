#include <continua/analysis/rigid_motions.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>

#include <array>

namespace Continua
{
using namespace dealii;

template <int dim>
Tensor<1, dim> RigidMotion<dim>::operator()(const Point<dim> &point) const
{
  Tensor<1, dim> result;
  if (!rotates)
  {
    result[axis_number] = 1.;
    return result;
  }
  const Tensor<1, dim> arm = point - centre;
  // The two directions across the axis, in cyclic order.
  const unsigned int first = (axis_number + 1) % 3, second = (axis_number + 2) % 3;
  result[first] = -arm[second];
  result[second] = arm[first];
  return result;
}

template <int dim>
std::vector<RigidMotion<dim>> rigid_motions(const Point<dim> &centre, const bool axisymmetric)
{
  const std::array<const char *, 3> names = {{"x", "y", "z"}};
  std::vector<RigidMotion<dim>> motions;
  for (unsigned int d = 0; d < (axisymmetric ? 1 : dim); ++d)
    motions.push_back({names[d], false, 0., d, centre});
  if (!axisymmetric)
    for (unsigned int axis = (dim == 2 ? 2 : 0); axis < 3; ++axis)
      motions.push_back({names[axis], true, 0., axis, centre});
  return motions;
}

template <int dim>
std::vector<RigidMotion<dim>> rigid_motions(const parallel::TriangulationBase<dim> &triangulation,
                                            const Mapping<dim> &mapping,
                                            const Problem &problem)
{
  const bool axisymmetric = problem.model == Model::axisymmetric;
  const FE_Nothing<dim> element;
  const QGauss<dim> quadrature(4);
  FEValues<dim> values(mapping, element, quadrature, update_quadrature_points | update_JxW_values);
  // Mass, and its moments of first and second order.
  std::array<double, 1 + 2 * dim> sums{};
  for (const auto &cell : triangulation.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      values.reinit(cell);
      const double density = problem.materials[cell->material_id()].density;
      for (const unsigned int q : values.quadrature_point_indices())
      {
        const Point<dim> &point = values.quadrature_point(q);
        const double mass =
            density * values.JxW(q) * (axisymmetric ? 2. * numbers::PI * point[1] : 1.);
        sums[0] += mass;
        for (unsigned int d = 0; d < dim; ++d)
        {
          sums[1 + d] += mass * point[d];
          sums[1 + dim + d] += mass * point[d] * point[d];
        }
      }
    }
  MPI_Allreduce(MPI_IN_PLACE, sums.data(), static_cast<int>(sums.size()), MPI_DOUBLE, MPI_SUM,
                triangulation.get_communicator());

  Point<dim> centre;
  std::array<double, dim> spread; // int rho (x_d - centre_d)^2
  for (unsigned int d = 0; d < dim; ++d)
  {
    centre[d] = sums[1 + d] / sums[0];
    spread[d] = sums[1 + dim + d] - sums[0] * centre[d] * centre[d];
  }
  std::vector<RigidMotion<dim>> motions = rigid_motions<dim>(centre, axisymmetric);
  for (RigidMotion<dim> &motion : motions)
    motion.inertia =
        motion.rotates ? spread[(motion.axis_number + 1) % 3] + spread[(motion.axis_number + 2) % 3]
                       : sums[0];
  return motions;
}

template struct RigidMotion<2>;
template struct RigidMotion<3>;
template std::vector<RigidMotion<2>> rigid_motions(const Point<2> &, bool);
template std::vector<RigidMotion<3>> rigid_motions(const Point<3> &, bool);
template std::vector<RigidMotion<2>>
rigid_motions(const parallel::TriangulationBase<2> &, const Mapping<2> &, const Problem &);
template std::vector<RigidMotion<3>>
rigid_motions(const parallel::TriangulationBase<3> &, const Mapping<3> &, const Problem &);
} // namespace Continua
