#include <continua/finite_volume/cell_ports.h>

namespace Continua
{
template <int dim>
DistributedVector CellPorts<dim>::flow_profile(const unsigned int condition) const
{
  DistributedVector profile = space.velocity_vector();
  for (const auto &face : conditions.faces())
    if (face.condition == condition)
      for (unsigned int c = 0; c < dim; ++c)
        profile.begin()[face.index + c] =
            face.flow_shapes.front() * space.mesh.faces()[face.face].normal[c];
  return profile;
}

template class CellPorts<2>;
template class CellPorts<3>;
} // namespace Continua
