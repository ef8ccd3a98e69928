#include <continua/finite_element/solvers/interface_compliance.h>

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace Continua
{
using namespace dealii;

template <int dim>
DistributedVector interface_compliance(
    const Space<dim> &space,
    const std::vector<unsigned int> &nodes,
    const DistributedVector &load,
    const double volume,
    const std::function<void(DistributedVector &velocity, const DistributedVector &force)> &inverse)
{
  DistributedVector compliance = space.velocity_vector(), velocity = compliance, wave = compliance;
  inverse(velocity, load);
  double area = 0.;
  for (std::size_t k = 0; k < nodes.size(); k += dim)
  {
    double work = 0., square = 0.;
    for (std::size_t c = k; c < k + dim; ++c)
    {
      work += velocity.begin()[nodes[c]] * load.begin()[nodes[c]];
      square += load.begin()[nodes[c]] * load.begin()[nodes[c]];
    }
    area += std::sqrt(square);
    // The corner of a wall that turns may move against the pressure.
    if (square > 0.)
      for (std::size_t c = k; c < k + dim; ++c)
        compliance.begin()[nodes[c]] = std::max(0., work / square);
  }
  area = Utilities::MPI::sum(area, space.communicator);

  std::map<types::global_dof_index, Point<dim>> points;
  DoFTools::map_dofs_to_support_points(space.mapping, space.velocity_dofs, points);
  double reduction = 1.;
  for (unsigned int direction = 0; direction < dim; ++direction)
  {
    for (unsigned int i = 0; i < load.locally_owned_size(); ++i)
    {
      const double x = points.at(space.velocity_owned.nth_index_in_set(i))[direction];
      wave.begin()[i] = load.begin()[i] * std::cos(2. * area / volume * x);
    }
    inverse(velocity, wave);
    const double work = velocity * wave;
    velocity.equ(1., wave);
    velocity.scale(compliance);
    const double uniform_work = velocity * wave;
    if (uniform_work > 0.)
      reduction = std::min(reduction, std::max(0., work / uniform_work));
  }
  compliance *= reduction;
  return compliance;
}

template DistributedVector
interface_compliance(const Space<2> &,
                     const std::vector<unsigned int> &,
                     const DistributedVector &,
                     double,
                     const std::function<void(DistributedVector &, const DistributedVector &)> &);
template DistributedVector
interface_compliance(const Space<3> &,
                     const std::vector<unsigned int> &,
                     const DistributedVector &,
                     double,
                     const std::function<void(DistributedVector &, const DistributedVector &)> &);
} // namespace Continua
