#include <continua/finite_element/looking/traction_jump.h>

#include <continua/finite_element/conditions/loads.h>
#include <continua/finite_element/looking/field_samples.h>
#include <continua/finite_element/space/face_pieces.h>
#include <continua/finite_element/space/present_diameter.h>
#include <continua/mesh/coordinates.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/hp/fe_values.h>

#include <cmath>
#include <map>

namespace Continua
{
using namespace dealii;

namespace
{
const UpdateFlags flags = update_values | update_gradients | update_quadrature_points |
                          update_JxW_values | update_normal_vectors;

/// Tractions on one side of a face, from the fields of the cell on that side; of a deformed region
/// those of the present shape.
template <int dim>
class SideTractions
{
public:
  SideTractions(const Space<dim> &space,
                const Problem &problem,
                const MetricHistory<dim> *const metrics,
                const SampledState<dim> &state)
      : space(space),
        problem(problem),
        state(state),
        samples(space, problem, metrics),
        quadrature(space.face_quadrature(space.degree() + 1)),
        face_values(space.mapping, space.velocity_element, quadrature, flags),
        subface_values(space.mapping, space.velocity_element, quadrature, flags),
        pressure_face_values(space.mappings,
                             space.pressure_elements,
                             hp::QCollection<dim - 1>(quadrature),
                             update_values),
        pressure_subface_values(space.mappings,
                                space.pressure_elements,
                                hp::QCollection<dim - 1>(quadrature),
                                update_values),
        values(quadrature.size(), Vector<double>(dim)),
        gradients(quadrature.size(), std::vector<Tensor<1, dim>>(dim)),
        pressures(quadrature.size(), Vector<double>(space.pressure_elements.n_components())),
        tractions(quadrature.size()),
        normals(quadrature.size()),
        places(quadrature.size()),
        face_weights(quadrature.size())
  {
  }

  using Cell = typename DoFHandler<dim>::active_cell_iterator;

  /// n.sigma of this cell with its own outward normal, on a face or on one of its children.
  const std::vector<Tensor<1, dim>> &face(const Cell &cell, const unsigned int f)
  {
    face_values.reinit(cell, f);
    pressure_face_values.reinit(pressure_cell(cell), f);
    return compute(cell, face_values, pressure_face_values.get_present_fe_values());
  }
  const std::vector<Tensor<1, dim>> &
  subface(const Cell &cell, const unsigned int f, const unsigned int subface)
  {
    subface_values.reinit(cell, f, subface);
    pressure_subface_values.reinit(pressure_cell(cell), f, subface);
    return compute(cell, subface_values, pressure_subface_values.get_present_fe_values());
  }
  // Of the face or child looked at last.
  const FEValuesBase<dim> &undeformed() const { return *last_values; }
  const Tensor<1, dim> &normal(const unsigned int q) const { return normals[q]; }
  /// Of a mesh that moves the present one.
  const Point<dim> &place(const unsigned int q) const { return places[q]; }
  /// [m^2, in the plane m]
  double weight(const unsigned int q) const { return face_weights[q]; }

private:
  const Space<dim> &space;
  const Problem &problem;
  const SampledState<dim> &state;
  FieldSamples<dim> samples;
  Quadrature<dim - 1> quadrature;
  FEFaceValues<dim> face_values;
  FESubfaceValues<dim> subface_values;
  hp::FEFaceValues<dim> pressure_face_values;
  hp::FESubfaceValues<dim> pressure_subface_values;
  std::vector<Vector<double>> values;
  std::vector<std::vector<Tensor<1, dim>>> gradients;
  std::vector<Vector<double>> pressures;
  std::vector<Tensor<1, dim>> tractions, normals;
  std::vector<Point<dim>> places;
  std::vector<double> face_weights;
  const FEValuesBase<dim> *last_values = nullptr;

  Cell pressure_cell(const Cell &cell) const
  {
    return Cell(&space.triangulation, cell->level(), cell->index(), &space.pressure_dofs);
  }
  const std::vector<Tensor<1, dim>> &compute(const Cell &cell,
                                             const FEValuesBase<dim> &fe_values,
                                             const FEValuesBase<dim> &pressure_values)
  {
    last_values = &fe_values;
    for (unsigned int q = 0; q < tractions.size(); ++q)
    {
      normals[q] = fe_values.normal_vector(q);
      places[q] = fe_values.quadrature_point(q);
      face_weights[q] = fe_values.JxW(q) * space.circumference(fe_values.quadrature_point(q));
    }
    if (problem.is_deformed(cell->material_id()))
      compute_deformed(cell, fe_values, pressure_values);
    else
      compute_linear(cell->material_id(), fe_values, pressure_values);
    return tractions;
  }
  void compute_linear(const unsigned int region,
                      const FEValuesBase<dim> &fe_values,
                      const FEValuesBase<dim> &pressure_values)
  {
    fe_values.get_function_values(state.mixtures[region], values);
    fe_values.get_function_gradients(state.mixtures[region], gradients);
    pressure_values.get_function_values(state.pressure, pressures);
    for (unsigned int q = 0; q < tractions.size(); ++q)
    {
      Tensor<2, dim> gradient;
      for (unsigned int c = 0; c < dim; ++c)
        gradient[c] = gradients[q][c];
      const double r = fe_values.quadrature_point(q)[1];
      double hoop = space.is_axisymmetric() ? (r > 0. ? values[q][1] / r : gradient[1][1]) : 0.;
      if (const auto &curve = problem.materials[region].shear.flow_curve; curve)
      {
        const double factor = thinning<dim>(*curve, gradient, hoop, problem.model);
        gradient *= factor;
        hoop *= factor;
      }
      tractions[q] =
          traction<dim>(stress<dim>(gradient, hoop, pressures[q][space.pressure_component(region)],
                                    problem.model),
                        normals[q]);
    }
  }
  void compute_deformed(const Cell &cell,
                        const FEValuesBase<dim> &fe_values,
                        const FEValuesBase<dim> &pressure_values)
  {
    samples.clear();
    for (unsigned int q = 0; q < tractions.size(); ++q)
    {
      SampledShare share;
      share.kind = SampledShare::Kind::area;
      for (unsigned int c = 0; c < dim; ++c)
        share.direction[c] = normals[q][c];
      samples.add(cell, fe_values, pressure_values, q, normals[q], {}, face_weights[q], share);
      tractions[q] = samples.traction_at(state, q);
      normals[q] = samples.normal(state, q);
      places[q] = samples.place(state, q);
      face_weights[q] = samples.weight(state, q);
    }
  }
};

/// What follows the face of a deformed body [Pa].
template <int dim>
double
prescribed_pressure(const BoundaryCondition &condition, const Point<dim> &place, const double time)
{
  const BoundaryPart &part = condition.normal;
  return part.kind == BoundaryPart::Kind::traction && part.negative
             ? part.along_normal(coordinates(place).data(), time)
             : 0.;
}

/// By which what is around the body pushes back.
template <int dim>
Tensor<1, dim> support_traction(const BoundaryCondition &condition,
                                const Tensor<1, dim> &normal,
                                const Vector<double> &displacement,
                                const Vector<double> &velocity)
{
  Tensor<1, dim> d, u;
  for (unsigned int c = 0; c < dim; ++c)
  {
    d[c] = displacement[c];
    u[c] = velocity[c];
  }
  const auto push_back = [](const BoundaryPart &part, const Tensor<1, dim> &of_displacement,
                            const Tensor<1, dim> &of_velocity)
  { return -part.stiffness * of_displacement - part.damping * of_velocity; };
  const Tensor<1, dim> normal_d = (d * normal) * normal, normal_u = (u * normal) * normal;
  return push_back(condition.normal, normal_d, normal_u) +
         push_back(condition.tangential, d - normal_d, u - normal_u);
}
} // namespace

template <int dim>
void traction_jump_indicators(const Space<dim> &space,
                              const Problem &problem,
                              const MetricHistory<dim> *const metrics,
                              const State &state,
                              const std::vector<double> &outlet_pressures,
                              const double time,
                              Vector<float> &per_cell)
{
  SampledState<dim> sampled(space, problem, metrics);
  sampled.reinit();
  sampled.take(state);
  SideTractions<dim> here(space, problem, metrics, sampled),
      there(space, problem, metrics, sampled);
  DistributedVector displacement, velocity;
  if (problem.has_supports())
  {
    displacement = space.ghosted_velocity(state.history.displacement());
    velocity = space.ghosted_velocity(state.velocity);
  }
  std::vector<Vector<double>> displacements, velocities;
  std::vector<double> port_pressures = outlet_pressures;
  const std::vector<unsigned int> unknown = problem.unknown_pressures();
  for (unsigned int i = 0; i < unknown.size(); ++i)
    port_pressures[unknown[i]] = (*state.cavities)[i].pressure;

  std::map<std::pair<unsigned int, unsigned int>, const BoundaryCondition *> condition_of;
  for (const BoundaryCondition &condition : problem.conditions)
    for (const unsigned int region : condition.region_ids)
      condition_of[{condition.boundary_id, region}] = &condition;

  // int |n.sigma + n'.sigma'|^2 over a face; the normals of the two sides are opposite.
  const auto jump =
      [&](const std::vector<Tensor<1, dim>> &one, const std::vector<Tensor<1, dim>> &other)
  {
    double sum = 0.;
    for (unsigned int q = 0; q < one.size(); ++q)
      sum += (one[q] + other[q]).norm_square() * here.weight(q);
    return sum;
  };

  per_cell.reinit(space.triangulation.n_active_cells());
  for (const auto &cell : space.velocity_dofs.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      double square = 0.;
      for (const unsigned int f : cell->face_indices())
      {
        const double length = problem.has_deformed_regions()
                                  ? present_diameter<dim>(cell->face(f), sampled.displacement)
                                  : cell->face(f)->diameter();
        if (cell->face(f)->at_boundary())
        {
          const BoundaryCondition &condition =
              *condition_of.at({cell->face(f)->boundary_id(), cell->material_id()});
          const auto &present = here.face(cell, f);
          const FEValuesBase<dim> &values = here.undeformed();
          if (condition.is_supported())
          {
            displacements.assign(values.n_quadrature_points, Vector<double>(dim));
            velocities = displacements;
            values.get_function_values(displacement, displacements);
            values.get_function_values(velocity, velocities);
          }
          for (const unsigned int q : values.quadrature_point_indices())
          {
            // The axis has no area.
            if (!(here.weight(q) > 0.))
              continue;
            const Tensor<1, dim> &normal = here.normal(q),
                                 &undeformed_normal = values.normal_vector(q);
            const Point<dim> &place = values.quadrature_point(q);
            Tensor<1, dim> difference;
            // Only the halves that are given as a traction can be missed.
            const Tensor<1, dim> along = (present[q] * normal) * normal;
            if (condition.normal.kind == BoundaryPart::Kind::traction)
              difference += along + port_pressures[&condition - problem.conditions.data()] * normal;
            if (condition.tangential.kind == BoundaryPart::Kind::traction)
              difference += present[q] - along;
            const auto given = [&](const Point<dim> &at, const Tensor<1, dim> &of_normal)
            { return Loads<dim>::prescribed_traction(condition, at, of_normal, time); };
            if (problem.is_deformed(cell->material_id()) &&
                !problem.materials[cell->material_id()].is_solid())
              difference -= given(here.place(q), normal);
            else
            {
              // A pressure acts on the present area, all else on the undeformed one.
              const double pressure = prescribed_pressure(condition, place, time);
              Tensor<1, dim> dead = given(place, undeformed_normal) + pressure * undeformed_normal;
              if (condition.is_supported())
                dead +=
                    support_traction(condition, undeformed_normal, displacements[q], velocities[q]);
              const double undeformed_area = values.JxW(q) * space.circumference(place);
              difference -= undeformed_area / here.weight(q) * dead - pressure * normal;
            }
            square += length * difference.norm_square() * here.weight(q);
          }
        }
        else
          square += 0.5 * length * sum_over_pieces(cell, f, here, there, jump);
      }
      per_cell[cell->active_cell_index()] = std::sqrt(square);
    }
}

template void traction_jump_indicators(const Space<2> &,
                                       const Problem &,
                                       const MetricHistory<2> *,
                                       const State &,
                                       const std::vector<double> &,
                                       double,
                                       Vector<float> &);
template void traction_jump_indicators(const Space<3> &,
                                       const Problem &,
                                       const MetricHistory<3> *,
                                       const State &,
                                       const std::vector<double> &,
                                       double,
                                       Vector<float> &);
} // namespace Continua
