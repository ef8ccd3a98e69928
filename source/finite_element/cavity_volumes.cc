#include <continua/finite_element/cavity_volumes.h>

#include <deal.II/base/mpi.h>

namespace Continua
{
using namespace dealii;

template <int dim>
CavityVolumes<dim>::CavityVolumes(const Space<dim> &space, const Problem &problem)
    : space(space), problem(problem), faces(space, problem, problem.cavities())
{
}

template <int dim>
void CavityVolumes<dim>::reinit()
{
  faces.reinit();
}

template <int dim>
double CavityVolumes<dim>::flux_factor(const unsigned int direction) const
{
  const bool is_in_plane = dim == 2 && !space.is_axisymmetric();
  return is_in_plane || direction > 0 ? 0.5 : 0.;
}

template <int dim>
Tensor<1, 3> CavityVolumes<dim>::flux_vector(const DeformedFacePoint<dim> &point,
                                             const Vector<double> &displacement) const
{
  const Tensor<1, dim> way = point.way(displacement);
  Tensor<1, 3> vector;
  for (unsigned int c = 0; c < dim; ++c)
    vector[c] = flux_factor(c) * (point.place[c] + way[c]);
  return vector;
}

template <int dim>
std::vector<double> CavityVolumes<dim>::volumes(const DistributedVector &displacement)
{
  faces.take(displacement);
  std::vector<double> sums(problem.cavities().size(), 0.);
  for (const auto &face : faces.all())
  {
    const Vector<double> &of_cell = faces.displacement_of(face);
    for (const DeformedFacePoint<dim> &point : face.points)
      sums[face.number] -= flux_vector(point, of_cell) * point.kinematics(of_cell).area(point.area);
  }
  Utilities::MPI::sum(sums, space.communicator, sums);
  return sums;
}

template <int dim>
void CavityVolumes<dim>::linearise(const unsigned int cavity,
                                   const DistributedVector &displacement,
                                   DistributedVector &derivative,
                                   DistributedVector &force)
{
  faces.take(displacement);
  faces.set_flow(cavity, force);
  force *= -1.;
  derivative = 0.;
  Vector<double> cell_derivative;
  for (const auto &face : faces.all())
  {
    if (face.number != cavity)
      continue;
    const Vector<double> &of_cell = faces.displacement_of(face);
    cell_derivative.reinit(of_cell.size());
    for (const DeformedFacePoint<dim> &point : face.points)
    {
      const Kinematics motion = point.kinematics(of_cell);
      const Tensor<1, 3> area = motion.area(point.area), flux = flux_vector(point, of_cell);
      const unsigned int n_functions = point.n_functions();
      for (unsigned int a = 0; a < n_functions; ++a)
      {
        const std::array<Tensor<1, 3>, dim> changes = point.area_derivatives(motion, area, a);
        for (unsigned int c = 0; c < dim; ++c)
          cell_derivative[c * n_functions + a] -=
              flux_factor(c) * area[c] * point.values[a] + flux * changes[c];
      }
    }
    space.velocity_hanging.distribute_local_to_global(cell_derivative, face.indices, derivative);
  }
  derivative.compress(VectorOperation::add);
}

template class CavityVolumes<2>;
template class CavityVolumes<3>;
} // namespace Continua
