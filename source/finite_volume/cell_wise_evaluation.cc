#include <continua/finite_volume/cell_wise_evaluation.h>

#include <continua/continuum/stress_and_strain.h>
#include <continua/mesh/cell_point.h>
#include <continua/mesh/plane_section.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace Continua
{
using namespace dealii;
using Source = ProbeWeights::Source;

template <int dim>
CellWiseEvaluation<dim>::CellWiseEvaluation(const CellWiseSpace<dim> &space, const Problem &problem)
    : FieldProbes<dim>(problem), space(space), linear(space, problem), mapping(2)
{
}

template <int dim>
void CellWiseEvaluation<dim>::build()
{
  linear.build();
  this->rebuild();
}

template <int dim>
bool CellWiseEvaluation<dim>::follows_mesh(const ProbeRequest<dim> &request,
                                           const FieldDefinition<dim> & /*field*/) const
{
  return problem.mesh_moves_between_steps &&
         request.kind != ProbeRequest<dim>::Kind::boundary_force;
}

template <int dim>
double CellWiseEvaluation<dim>::circumference(const Point<dim> &point) const
{
  return space.is_axisymmetric() ? 2. * numbers::PI * point[1] : 1.;
}

template <int dim>
ProbeWeights::Collector CellWiseEvaluation<dim>::collector() const
{
  return {space.velocity_vector(), space.pressure_vector(),
          static_cast<unsigned int>(problem.regions.size())};
}

template <int dim>
std::vector<CellPlace> CellWiseEvaluation<dim>::faces_at(const unsigned int cell,
                                                         const Point<dim> &unit_point,
                                                         const Point<dim> &point) const
{
  constexpr double tolerance = 1e-7;
  const FiniteVolume<dim> &volume = space.mesh.cells()[cell];
  std::vector<CellPlace> places;
  for (unsigned int f = 0; f < GeometryInfo<dim>::faces_per_cell; ++f)
  {
    if (std::abs(unit_point[f / 2] - f % 2) > tolerance)
      continue;
    // Of the pieces of a face with hanging nodes that, or those, whose middle is nearest.
    double nearest = std::numeric_limits<double>::max();
    std::vector<CellPlace> pieces;
    for (const unsigned int face : volume.faces)
    {
      const VolumeFace<dim> &surface = space.mesh.faces()[face];
      if (!surface.has_value() || surface.number_in_cell[space.mesh.side(face, cell)] != f)
        continue;
      const double distance = surface.shape(space.mesh.side(face, cell)).centre.distance(point);
      if (distance < nearest * (1. - tolerance))
        pieces.clear();
      if (distance < nearest * (1. + tolerance))
        pieces.push_back({cell, face});
      nearest = std::min(nearest, distance);
    }
    places.insert(places.end(), pieces.begin(), pieces.end());
  }
  return places;
}

template <int dim>
double CellWiseEvaluation<dim>::add_point(const ProbeRequest<dim> &request,
                                          const FieldDefinition<dim> &field,
                                          Collector &collector) const
{
  std::vector<CellPlace> cells, faces;
  std::map<unsigned int, Point<dim>> places; // by cell
  for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
  {
    const FiniteVolume<dim> &volume = space.mesh.cells()[cell];
    Point<dim> unit_point;
    if (!this->counts(request, volume.material_id) ||
        !cell_holds_point<dim>(mapping, volume.iterator, request.point, unit_point))
      continue;
    cells.push_back({cell, CellPlace::none});
    places[cell] = space.mesh.present_place(cell, unit_point, request.point);
    const std::vector<CellPlace> of_cell = faces_at(cell, unit_point, places[cell]);
    faces.insert(faces.end(), of_cell.begin(), of_cell.end());
  }
  const unsigned int n_faces = Utilities::MPI::sum(faces.size(), space.communicator);
  for (const CellPlace &place : n_faces > 0 ? faces : cells)
    add_value(field, place, places[place.cell], request.point, 1., collector);
  return n_faces > 0 ? n_faces : Utilities::MPI::sum(cells.size(), space.communicator);
}

template <int dim>
double CellWiseEvaluation<dim>::add_boundary(const ProbeRequest<dim> &request,
                                             const FieldDefinition<dim> &field,
                                             Collector &collector) const
{
  double area = 0.;
  for (unsigned int face = 0; face < space.mesh.faces().size(); ++face)
  {
    const VolumeFace<dim> &surface = space.mesh.faces()[face];
    if (!surface.at_boundary() || request.boundary_ids.count(surface.boundary_id) == 0)
      continue;
    const FiniteVolume<dim> &volume = space.mesh.cells()[surface.owner];
    if (!volume.is_owned || !this->counts(request, volume.material_id))
      continue;
    area += surface.area;
    add_value(field, {surface.owner, face}, surface.centre, surface.centre, surface.area,
              collector);
  }
  return Utilities::MPI::sum(area, space.communicator);
}

template <int dim>
double CellWiseEvaluation<dim>::add_section(const ProbeRequest<dim> &request,
                                            const FieldDefinition<dim> &field,
                                            Collector &collector) const
{
  const bool is_rim = request.kind == ProbeRequest<dim>::Kind::rim_mean;
  const PlaneSection<dim> section(mapping, space.mesh.triangulation,
                                  PlaneSection<dim>::Cells::active, request.region_ids,
                                  request.point, request.normal, 3, request.axis.get());
  double area = 0.;
  for (const auto &part : is_rim ? section.outer_rim() : section.parts())
  {
    const unsigned int cell = space.mesh.cell_number(part.cell);
    for (unsigned int q = 0; q < part.points.size(); ++q)
    {
      const Point<dim> &point = part.points[q];
      const double weight = part.quadrature.weight(q) * circumference(point);
      area += weight;
      std::vector<CellPlace> places;
      if (is_rim)
        places = faces_at(cell, part.quadrature.point(q), point);
      if (places.empty())
        places.push_back({cell, CellPlace::none});
      for (const CellPlace &place : places)
        add_value(field, place, point, point, weight / places.size(), collector);
    }
  }
  return Utilities::MPI::sum(area, space.communicator);
}

template <int dim>
double CellWiseEvaluation<dim>::add_volume(const ProbeRequest<dim> &request,
                                           const FieldDefinition<dim> &field,
                                           Collector &collector) const
{
  double volume = 0.;
  for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
  {
    const FiniteVolume<dim> &finite_volume = space.mesh.cells()[cell];
    if (!this->counts(request, finite_volume.material_id))
      continue;
    volume += finite_volume.volume;
    add_value(field, {cell, CellPlace::none}, finite_volume.centre, finite_volume.centre,
              finite_volume.volume, collector);
  }
  return Utilities::MPI::sum(volume, space.communicator);
}

template <int dim>
double CellWiseEvaluation<dim>::add_interface(const ProbeRequest<dim> &request,
                                              Collector &collector) const
{
  double area = 0.;
  for (unsigned int face = 0; face < space.mesh.faces().size(); ++face)
  {
    const VolumeFace<dim> &surface = space.mesh.faces()[face];
    if (!surface.is_interface)
      continue;
    for (const unsigned int side : {0, 1})
    {
      const FiniteVolume<dim> &volume = space.mesh.cells()[surface.cell(side)];
      if (!volume.is_owned || !this->counts(request, volume.material_id) ||
          this->counts(request, space.mesh.cells()[surface.cell(1 - side)].material_id))
        continue;
      area += surface.area;
      add_value(field_along<dim>(FieldDefinition<dim>::Quantity::displacement, surface.normal),
                {surface.cell(side), face}, surface.centre, surface.centre,
                side == 0 ? surface.area : -surface.area, collector);
    }
  }
  return Utilities::MPI::sum(area, space.communicator);
}

template <int dim>
double CellWiseEvaluation<dim>::add_force(const ProbeRequest<dim> &request,
                                          Collector &collector) const
{
  // The equation of a face with a value of its own is the balance of tractions there.
  DistributedVector &weights = collector.weights(Source::force);
  double area = 0.;
  for (unsigned int face = 0; face < space.mesh.faces().size(); ++face)
  {
    const VolumeFace<dim> &surface = space.mesh.faces()[face];
    if (!surface.has_value())
      continue;
    for (const unsigned int side : {0, 1})
    {
      if (surface.at_boundary() && side == 1)
        continue;
      const FiniteVolume<dim> &volume = space.mesh.cells()[surface.cell(side)];
      if (!volume.is_owned || !this->counts(request, volume.material_id))
        continue;
      const bool is_asked_for =
          surface.at_boundary() ? request.boundary_ids.count(surface.boundary_id) > 0
                                : request.neighbour_ids.count(
                                      space.mesh.cells()[surface.cell(1 - side)].material_id) > 0;
      // On the axis, which has no area, the balance counts with another weight.
      if (!is_asked_for || surface.area == 0.)
        continue;
      // Minus: the force on what holds the face.
      weights(dim * space.velocities.of_face(face, side) + request.component) += -1.;
      area += surface.area;
    }
  }
  return Utilities::MPI::sum(area, space.communicator);
}

template <int dim>
double CellWiseEvaluation<dim>::add_flow(const ProbeRequest<dim> &request,
                                         Collector &collector) const
{
  return add_section(request,
                     field_along<dim>(FieldDefinition<dim>::Quantity::velocity,
                                      request.normal / request.normal.norm()),
                     collector);
}

template <int dim>
void CellWiseEvaluation<dim>::add_value(const FieldDefinition<dim> &field,
                                        const CellPlace &place,
                                        const Point<dim> &point,
                                        const Point<dim> &undeformed,
                                        const double weight,
                                        Collector &collector) const
{
  using Quantity = typename FieldDefinition<dim>::Quantity;
  const unsigned int region = space.mesh.cells()[place.cell].material_id;
  const PlaneStressFactors plane_stress = problem.plane_stress(region);
  const std::array<double, 6> factors = field.factors(point);
  const auto combine = [&factors](const std::array<double, 6> &components)
  { return std::inner_product(factors.begin(), factors.end(), components.begin(), 0.); };
  // A sum of distributed vectors' entries is dear: those with weight 0 are left out.
  const auto add = [](DistributedVector &target, const unsigned int index, const double value)
  {
    if (value != 0.)
      target(index) += value;
  };

  if (field.quantity == Quantity::velocity || field.quantity == Quantity::displacement)
  {
    const bool is_velocity = field.quantity == Quantity::velocity;
    DistributedVector &target =
        collector.weights(is_velocity ? Source::velocity : Source::displacement);
    for (const auto &entry : is_velocity ? linear.velocity(place, point)
                                         : linear.displacement(place, point, undeformed))
      for (unsigned int c = 0; c < dim; ++c)
        add(target, dim * entry.first + c, weight * factors[c] * entry.second);
    return;
  }
  double of_pressure = plane_stress.pressure_factor;
  if (field.quantity != Quantity::pressure)
  {
    // Stress, strain and vorticity are linear in the gradient, so the weights are those of unit
    // entries.
    const bool is_strain = field.quantity == Quantity::strain,
               is_vorticity = field.quantity == Quantity::vorticity;
    const auto unit = [&](const Tensor<2, dim> &gradient, const double hoop)
    {
      return combine(is_vorticity ? vorticity<dim>(gradient)
                     : is_strain  ? strain<dim>(gradient, hoop, problem.model, plane_stress)
                                  : stress<dim>(gradient, hoop, 0., problem.model));
    };
    DistributedVector &target = is_strain      ? collector.weights(Source::displacement)
                                : is_vorticity ? collector.weights(Source::velocity)
                                               : collector.weights(Source::mixture, region);
    for (const auto &entry : linear.velocity_gradient(place))
      for (unsigned int c = 0; c < dim; ++c)
      {
        Tensor<2, dim> gradient;
        gradient[c] = entry.second;
        add(target, dim * entry.first + c, weight * unit(gradient, 0.));
      }
    for (const auto &entry : linear.hoop(place))
      add(target, dim * entry.first + 1, weight * unit(Tensor<2, dim>(), entry.second));
    if (is_strain || is_vorticity)
      return;
    of_pressure = combine(stress<dim>(Tensor<2, dim>(), 0., 1., problem.model));
  }
  for (const auto &entry : linear.pressure(place, point))
    add(collector.weights(Source::pressure), entry.first, weight * of_pressure * entry.second);
}

template <int dim>
DistributedVector CellWiseEvaluation<dim>::ghosted_mixture(const State &state,
                                                           const unsigned int region) const
{
  DistributedVector mixture = space.velocity_vector();
  set_mixture(state, region, problem.materials[region], mixture);
  return linear.ghosted_velocity(mixture);
}

template <int dim>
std::array<double, 6> CellWiseEvaluation<dim>::stress_at(const CellPlace &place,
                                                         const Point<dim> &point,
                                                         const DistributedVector &mixture,
                                                         const DistributedVector &pressure) const
{
  double hoop = 0.;
  for (const auto &entry : linear.hoop(place))
    hoop += entry.second * mixture(dim * entry.first + 1);
  return stress<dim>(linear.vector_gradient(linear.velocity_gradient(place), mixture), hoop,
                     linear.value(linear.pressure(place, point), pressure), problem.model);
}

template <int dim>
double CellWiseEvaluation<dim>::error_norm(const State &state,
                                           const ComparedField field,
                                           const std::vector<Expression> &exact,
                                           const double time) const
{
  const DistributedVector pressure = linear.ghosted_pressure(state.pressure);
  const std::vector<DistributedVector> vectors = vectors_of(
      field, problem, state.velocity, state.history.displacement(),
      [this](const DistributedVector &vector) { return linear.ghosted_velocity(vector); },
      [this, &state](const unsigned int region) { return ghosted_mixture(state, region); });

  // Well above the degree of the fields, so that the number is the error and not the quadrature's.
  const QGauss<dim> quadrature(4);
  FEValues<dim> values(space.mesh.element, quadrature,
                       update_quadrature_points | update_JxW_values);
  double sum = 0.;
  for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
  {
    const FiniteVolume<dim> &volume = space.mesh.cells()[cell];
    const double pressure_factor = problem.plane_stress(volume.material_id).pressure_factor;
    const CellPlace place{cell, CellPlace::none};
    values.reinit(volume.iterator);
    for (const unsigned int q : values.quadrature_point_indices())
    {
      const Point<dim> &point = values.quadrature_point(q);
      std::array<double, 6> present = {{0., 0., 0., 0., 0., 0.}};
      if (field == ComparedField::pressure)
        present[0] = pressure_factor * linear.value(linear.pressure(place, point), pressure);
      else if (field == ComparedField::stress)
        present = stress_at(place, point, vectors[volume.material_id], pressure);
      else
      {
        // In a cell; a displacement is another than a velocity on faces alone.
        const Tensor<1, dim> value =
            linear.vector_value(linear.velocity(place, point), vectors.front());
        for (unsigned int c = 0; c < dim; ++c)
          present[c] = value[c];
      }
      sum += squared_difference(present, exact, point, time) * values.JxW(q) * circumference(point);
    }
  }
  return std::sqrt(Utilities::MPI::sum(sum, space.communicator));
}

template class CellWiseEvaluation<2>;
template class CellWiseEvaluation<3>;
} // namespace Continua
