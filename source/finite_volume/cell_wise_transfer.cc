#include <continua/finite_volume/cell_wise_transfer.h>

#include <deal.II/distributed/tria_base.h>

#include <boost/range/iterator_range.hpp>

#include <cstring>

namespace Continua
{
using namespace dealii;

namespace
{
template <int dim>
parallel::DistributedTriangulationBase<dim> &distributed(parallel::TriangulationBase<dim> &mesh)
{
  return dynamic_cast<parallel::DistributedTriangulationBase<dim> &>(mesh);
}

/// The numbers whose bytes these are.
std::vector<double> numbers_in(const std::vector<char>::const_iterator begin,
                               const std::vector<char>::const_iterator end)
{
  std::vector<double> numbers(static_cast<std::size_t>(end - begin) / sizeof(double));
  if (!numbers.empty())
    std::memcpy(numbers.data(), &*begin, numbers.size() * sizeof(double));
  return numbers;
}
} // namespace

template <int dim>
void CellWiseTransfer<dim>::prepare(const std::vector<DistributedVector *> &velocities,
                                    const std::vector<DistributedVector *> &pressures)
{
  old_velocities.clear();
  old_pressures.clear();
  for (const DistributedVector *vector : velocities)
    old_velocities.push_back(reconstruction.ghosted_velocity(*vector));
  for (const DistributedVector *vector : pressures)
    old_pressures.push_back(reconstruction.ghosted_pressure(*vector));
  using Status = typename Triangulation<dim>::CellStatus;
  handle =
      distributed(space.mesh.triangulation)
          .register_data_attach(
              [this](const CellIterator &cell, const Status status)
              {
                return pack(status == Status::CELL_COARSEN ? mean_over(cell)
                                                           : data_of(space.mesh.cell_number(cell)));
              },
              false);
}

template <int dim>
void CellWiseTransfer<dim>::finish(const std::vector<DistributedVector *> &velocities,
                                   const std::vector<DistributedVector *> &pressures)
{
  using Status = typename Triangulation<dim>::CellStatus;
  distributed(space.mesh.triangulation)
      .notify_ready_to_unpack(
          handle,
          [&](const CellIterator &cell, const Status status,
              const boost::iterator_range<std::vector<char>::const_iterator> &bytes)
          {
            const CellData data = unpack(numbers_in(bytes.begin(), bytes.end()));
            if (status == Status::CELL_REFINE)
              for (unsigned int child = 0; child < cell->n_children(); ++child)
                set(space.mesh.cell_number(cell->child(child)), data, true, velocities, pressures);
            else
              set(space.mesh.cell_number(cell), data, false, velocities, pressures);
          });
  old_velocities.clear();
  old_pressures.clear();
}

template <int dim>
typename CellWiseTransfer<dim>::CellData
CellWiseTransfer<dim>::data_of(const unsigned int cell) const
{
  const FiniteVolume<dim> &volume = space.mesh.cells()[cell];
  CellData data;
  data.centre = volume.centre;
  for (const unsigned int number : volume.faces)
  {
    const VolumeFace<dim> &face = space.mesh.faces()[number];
    const unsigned int f = face.number_in_cell[space.mesh.side(number, cell)];
    if (!face.has_value())
      continue;
    data.face_areas[f] += face.plane_area;
    data.face_centres[f] += face.plane_area * face.centre;
  }
  for (unsigned int f = 0; f < n_faces; ++f)
    if (data.face_areas[f] > 0.)
      data.face_centres[f] /= data.face_areas[f];

  const auto add = [&](const ValueSpace<dim> &values, const GaussGradient<dim> &gradient,
                       const DistributedVector &vector, const unsigned int n_components)
  {
    for (unsigned int c = 0; c < n_components; ++c)
    {
      const auto entry = [&](const unsigned int value) { return vector(n_components * value + c); };
      Component component;
      component.value = entry(values.of_cell(cell));
      const auto gradient_of = [&](const unsigned int number)
      {
        Tensor<1, dim> sum;
        for (const auto &part : gradient(number))
          sum += entry(part.first) * part.second;
        return sum;
      };
      component.gradient = gradient_of(cell);
      for (const unsigned int number : volume.faces)
      {
        const VolumeFace<dim> &face = space.mesh.faces()[number];
        const unsigned int side = space.mesh.side(number, cell);
        const unsigned int f = face.number_in_cell[side];
        if (!face.has_value())
          continue;
        const double share = face.plane_area / data.face_areas[f];
        component.on_faces[f] += share * entry(values.of_face(number, side));
        // What both sides have in common belongs to the solid.
        const unsigned int owner =
            n_components == dim ? reconstruction.owner_along(number, cell) : cell;
        component.face_gradients[f] +=
            share * (owner == cell ? component.gradient : gradient_of(owner));
      }
      data.components.push_back(component);
    }
  };
  for (const DistributedVector &vector : old_velocities)
    add(space.velocities, space.velocity_gradient, vector, dim);
  for (const DistributedVector &vector : old_pressures)
    add(space.pressures, space.pressure_gradient, vector, 1);
  return data;
}

template <int dim>
typename CellWiseTransfer<dim>::CellData
CellWiseTransfer<dim>::mean_over(const CellIterator &parent) const
{
  CellData mean;
  mean.components.resize(dim * old_velocities.size() + old_pressures.size());
  double volume = 0.;
  for (unsigned int child = 0; child < parent->n_children(); ++child)
  {
    const unsigned int cell = space.mesh.cell_number(parent->child(child));
    const double weight = space.mesh.cells()[cell].volume;
    const CellData data = data_of(cell);
    volume += weight;
    mean.centre += weight * data.centre;
    for (unsigned int f = 0; f < n_faces; ++f)
    {
      mean.face_areas[f] += data.face_areas[f];
      mean.face_centres[f] += data.face_areas[f] * data.face_centres[f];
    }
    for (unsigned int i = 0; i < mean.components.size(); ++i)
    {
      mean.components[i].value += weight * data.components[i].value;
      mean.components[i].gradient += weight * data.components[i].gradient;
      for (unsigned int f = 0; f < n_faces; ++f)
      {
        mean.components[i].on_faces[f] += data.face_areas[f] * data.components[i].on_faces[f];
        mean.components[i].face_gradients[f] +=
            data.face_areas[f] * data.components[i].face_gradients[f];
      }
    }
  }
  mean.centre /= volume;
  for (unsigned int f = 0; f < n_faces; ++f)
    if (mean.face_areas[f] > 0.)
      mean.face_centres[f] /= mean.face_areas[f];
  for (Component &component : mean.components)
  {
    component.value /= volume;
    component.gradient /= volume;
    for (unsigned int f = 0; f < n_faces; ++f)
      if (mean.face_areas[f] > 0.)
      {
        component.on_faces[f] /= mean.face_areas[f];
        component.face_gradients[f] /= mean.face_areas[f];
      }
  }
  return mean;
}

template <int dim>
std::vector<char> CellWiseTransfer<dim>::pack(const CellData &data) const
{
  std::vector<double> values;
  const auto add = [&values](const Tensor<1, dim> &tensor)
  {
    for (unsigned int c = 0; c < dim; ++c)
      values.push_back(tensor[c]);
  };
  add(data.centre);
  for (unsigned int f = 0; f < n_faces; ++f)
  {
    values.push_back(data.face_areas[f]);
    add(data.face_centres[f]);
  }
  for (const Component &component : data.components)
  {
    values.push_back(component.value);
    add(component.gradient);
    values.insert(values.end(), component.on_faces.begin(), component.on_faces.end());
    for (const Tensor<1, dim> &of_face : component.face_gradients)
      add(of_face);
  }
  std::vector<char> bytes(values.size() * sizeof(double));
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

template <int dim>
typename CellWiseTransfer<dim>::CellData
CellWiseTransfer<dim>::unpack(const std::vector<double> &values) const
{
  auto next = values.begin();
  const auto take = [&next](Tensor<1, dim> &tensor)
  {
    for (unsigned int c = 0; c < dim; ++c)
      tensor[c] = *next++;
  };
  CellData data;
  take(data.centre);
  for (unsigned int f = 0; f < n_faces; ++f)
  {
    data.face_areas[f] = *next++;
    take(data.face_centres[f]);
  }
  while (next != values.end())
  {
    Component component;
    component.value = *next++;
    take(component.gradient);
    for (double &value : component.on_faces)
      value = *next++;
    for (Tensor<1, dim> &of_face : component.face_gradients)
      take(of_face);
    data.components.push_back(component);
  }
  return data;
}

template <int dim>
Tensor<1, dim> CellWiseTransfer<dim>::free_part(const unsigned int face,
                                                const Tensor<1, dim> &change) const
{
  const BoundaryCondition &condition = conditions[face_conditions.of_face(face).condition];
  const auto holds = [](const BoundaryPart &part)
  { return part.kind == BoundaryPart::Kind::velocity && !part.flow && part.is_zero(); };
  const Tensor<1, dim> &normal = space.mesh.faces()[face].normal;
  const Tensor<1, dim> along_normal = (change * normal) * normal;
  Tensor<1, dim> result;
  if (!holds(condition.normal))
    result += along_normal;
  if (!holds(condition.tangential))
    result += change - along_normal;
  return result;
}

template <int dim>
void CellWiseTransfer<dim>::set(const unsigned int cell,
                                const CellData &data,
                                const bool divided,
                                const std::vector<DistributedVector *> &velocities,
                                const std::vector<DistributedVector *> &pressures) const
{
  const FiniteVolume<dim> &volume = space.mesh.cells()[cell];
  auto component = data.components.begin();
  const auto fill =
      [&](const ValueSpace<dim> &values, DistributedVector &vector, const unsigned int n_components)
  {
    const auto first_entry = [&](const unsigned int value)
    { return vector.begin() + n_components * (value - values.first_owned()); };
    for (unsigned int c = 0; c < n_components; ++c)
      first_entry(values.of_cell(cell))[c] =
          component[c].value +
          (divided ? component[c].gradient * (volume.centre - data.centre) : 0.);
    for (const unsigned int number : volume.faces)
    {
      const VolumeFace<dim> &face = space.mesh.faces()[number];
      const unsigned int side = space.mesh.side(number, cell);
      // One value for two cells is the owner's.
      if (!face.has_value() ||
          (side == 1 && values.of_face(number, 0) == values.of_face(number, 1)))
        continue;
      const unsigned int f = face.number_in_cell[side];
      Assert(data.face_areas[f] > 0., ExcInternalError());
      Tensor<1, dim> offset = face.centre - data.face_centres[f];
      offset -= (offset * face.normal) * face.normal;
      Tensor<1, dim> change;
      for (unsigned int c = 0; c < n_components; ++c)
        change[c] = component[c].face_gradients[f] * offset;
      if (n_components == dim && face.at_boundary())
        change = free_part(number, change);
      for (unsigned int c = 0; c < n_components; ++c)
        first_entry(values.of_face(number, side))[c] = component[c].on_faces[f] + change[c];
    }
    component += n_components;
  };
  for (DistributedVector *vector : velocities)
    fill(space.velocities, *vector, dim);
  for (DistributedVector *vector : pressures)
    fill(space.pressures, *vector, 1);
}

template class CellWiseTransfer<2>;
template class CellWiseTransfer<3>;
} // namespace Continua
