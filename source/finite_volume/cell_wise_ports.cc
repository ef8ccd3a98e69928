#include <continua/finite_volume/cell_wise_ports.h>

namespace Continua
{
template <int dim>
DistributedVector CellWisePorts<dim>::flow_profile(const unsigned int condition) const
{
  DistributedVector profile = space.velocity_vector();
  for (const auto &face : conditions.faces())
    if (face.condition == condition)
      for (unsigned int c = 0; c < dim; ++c)
        profile.begin()[face.index + c] =
            face.flow_shapes.front() * space.mesh.faces()[face.face].normal[c];
  return profile;
}

template class CellWisePorts<2>;
template class CellWisePorts<3>;
} // namespace Continua
