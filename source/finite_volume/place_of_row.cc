#include <continua/finite_volume/place_of_row.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace Continua
{
using namespace dealii;

namespace
{
/// The centre of the cell or face that a value of this rank belongs to, and the cell.
template <int dim>
std::pair<Point<dim>, unsigned int>
owner_of(const CellWiseSpace<dim> &space, const ValueSpace<dim> &values, const unsigned int value)
{
  const CellWiseMesh<dim> &mesh = space.mesh;
  for (unsigned int face = 0; face < mesh.faces().size(); ++face)
  {
    const VolumeFace<dim> &surface = mesh.faces()[face];
    for (unsigned int side = 0; surface.has_value() && side < surface.n_sides(); ++side)
      if (values.owns_face(face, side) && values.of_face(face, side) == value)
        return {surface.centre, surface.cell(side)};
  }
  const unsigned int cell = value - values.first_owned();
  return {mesh.cells()[cell].centre, cell};
}
} // namespace

template <int dim>
std::string place_of_largest_row(const CellWiseSpace<dim> &space,
                                 const DistributedVector &rows,
                                 const bool of_velocity,
                                 const std::vector<std::string> &regions)
{
  double largest = -1.;
  unsigned int row = 0;
  for (unsigned int i = 0; i < rows.locally_owned_size(); ++i)
  {
    const double size = std::isfinite(rows.begin()[i]) ? std::abs(rows.begin()[i])
                                                       : std::numeric_limits<double>::infinity();
    if (size > largest)
    {
      largest = size;
      row = i;
    }
  }
  const auto over_ranks = Utilities::MPI::min_max_avg(largest, space.communicator);
  std::string text;
  if (over_ranks.max_index == Utilities::MPI::this_mpi_process(space.communicator))
  {
    const ValueSpace<dim> &values = of_velocity ? space.velocities : space.pressures;
    const auto [point, cell] =
        owner_of(space, values, values.first_owned() + row / (of_velocity ? dim : 1));
    std::ostringstream words;
    words.precision(4);
    words << "in the region '" << regions[space.mesh.cells()[cell].material_id] << "' near (";
    for (unsigned int c = 0; c < dim; ++c)
      words << (c == 0 ? "" : ", ") << point[c];
    words << ") m";
    text = words.str();
  }
  return Utilities::MPI::broadcast(space.communicator, text, over_ranks.max_index);
}

template std::string place_of_largest_row(const CellWiseSpace<2> &,
                                          const DistributedVector &,
                                          bool,
                                          const std::vector<std::string> &);
template std::string place_of_largest_row(const CellWiseSpace<3> &,
                                          const DistributedVector &,
                                          bool,
                                          const std::vector<std::string> &);
} // namespace Continua
