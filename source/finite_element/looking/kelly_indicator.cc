#include <continua/finite_element/looking/kelly_indicator.h>
#include <continua/finite_element/motion/kinematics_at.h>
#include <continua/finite_element/space/face_pieces.h>
#include <continua/finite_element/space/present_diameter.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/hp/fe_values.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace Continua
{
using namespace dealii;

namespace
{
const UpdateFlags flags_of_motion = update_values | update_gradients | update_quadrature_points;

/// Derivatives along the outward normal on one side of a face, by component at each point; on a
/// mesh that moves by the present place along the present normal.
template <int dim>
class SideDerivatives
{
public:
  using Cell = typename DoFHandler<dim>::active_cell_iterator;

  SideDerivatives(const Space<dim> &space,
                  const DoFHandler<dim> &dofs,
                  const DistributedVector &field,
                  const DistributedVector *const mesh_displacement)
      : space(space),
        dofs(dofs),
        field(field),
        mesh_displacement(mesh_displacement),
        n_points(space.face_quadrature(space.degree() + 1).size()),
        n_components(dofs.get_fe(0).n_components()),
        face_values(space.mappings,
                    dofs.get_fe_collection(),
                    hp::QCollection<dim - 1>(space.face_quadrature(space.degree() + 1)),
                    update_gradients | update_quadrature_points | update_JxW_values |
                        update_normal_vectors),
        subface_values(space.mappings,
                       dofs.get_fe_collection(),
                       hp::QCollection<dim - 1>(space.face_quadrature(space.degree() + 1)),
                       update_gradients | update_quadrature_points | update_JxW_values |
                           update_normal_vectors),
        motion_face_values(space.mapping,
                           space.velocity_element,
                           space.face_quadrature(space.degree() + 1),
                           flags_of_motion),
        motion_subface_values(space.mapping,
                              space.velocity_element,
                              space.face_quadrature(space.degree() + 1),
                              flags_of_motion),
        indices(space.velocity_element.n_dofs_per_cell()),
        gradients(n_points, std::vector<Tensor<1, dim>>(n_components)),
        derivatives(n_points, std::vector<double>(n_components)),
        face_weights(n_points)
  {
  }
  const std::vector<std::vector<double>> &face(const Cell &cell, const unsigned int f)
  {
    face_values.reinit(cell, f);
    if (mesh_displacement != nullptr)
      motion_face_values.reinit(velocity_cell(cell), f);
    return compute(cell, face_values.get_present_fe_values(), motion_face_values);
  }
  const std::vector<std::vector<double>> &
  subface(const Cell &cell, const unsigned int f, const unsigned int piece)
  {
    subface_values.reinit(cell, f, piece);
    if (mesh_displacement != nullptr)
      motion_subface_values.reinit(velocity_cell(cell), f, piece);
    return compute(cell, subface_values.get_present_fe_values(), motion_subface_values);
  }
  /// Of the points of the face or piece looked at last [m^2, in the plane m].
  const std::vector<double> &weights() const { return face_weights; }

private:
  const Space<dim> &space;
  const DoFHandler<dim> &dofs;
  const DistributedVector &field;
  const DistributedVector *const mesh_displacement; ///< null where the mesh stays
  const unsigned int n_points, n_components;
  hp::FEFaceValues<dim> face_values;
  hp::FESubfaceValues<dim> subface_values;
  FEFaceValues<dim> motion_face_values;
  FESubfaceValues<dim> motion_subface_values;
  std::vector<types::global_dof_index> indices;
  std::vector<std::vector<Tensor<1, dim>>> gradients;
  std::vector<std::vector<double>> derivatives;
  std::vector<double> face_weights;

  Cell velocity_cell(const Cell &cell) const
  {
    return Cell(&space.triangulation, cell->level(), cell->index(), &space.velocity_dofs);
  }
  const std::vector<std::vector<double>> &
  compute(const Cell &cell, const FEValuesBase<dim> &values, const FEValuesBase<dim> &motion_values)
  {
    // A pressure has no part in the components of other regions: their gradients are zero.
    values.get_function_gradients(field, gradients);
    if (mesh_displacement != nullptr)
      velocity_cell(cell)->get_dof_indices(indices);
    for (unsigned int q = 0; q < n_points; ++q)
    {
      Tensor<1, dim> along = values.normal_vector(q);
      face_weights[q] = values.JxW(q) * space.circumference(values.quadrature_point(q));
      if (mesh_displacement != nullptr)
        move(kinematics_at(space, motion_values, q, indices, *mesh_displacement), along,
             face_weights[q]);
      for (unsigned int c = 0; c < n_components; ++c)
        derivatives[q][c] = gradients[q][c] * along;
    }
    return derivatives;
  }
  /// Makes the normal F^-1 n, along which the gradient by the undeformed place is the derivative
  /// along the present normal n, and the weight that of da.
  static void move(const Kinematics &motion, Tensor<1, dim> &along, double &weight)
  {
    Tensor<1, 3> normal;
    for (unsigned int c = 0; c < dim; ++c)
      normal[c] = along[c];
    normal = motion.area(normal);
    weight *= normal.norm();
    normal = motion.inverse() * (normal / normal.norm());
    for (unsigned int c = 0; c < dim; ++c)
      along[c] = normal[c];
  }
};

template <int dim>
void kelly_indicators(const Space<dim> &space,
                      const DoFHandler<dim> &dofs,
                      const DistributedVector &field,
                      const DistributedVector *const mesh_displacement,
                      Vector<float> &per_cell)
{
  const DistributedVector ghosted = mesh_displacement != nullptr
                                        ? space.ghosted_velocity(*mesh_displacement)
                                        : DistributedVector();
  const DistributedVector *const displacement = mesh_displacement != nullptr ? &ghosted : nullptr;
  SideDerivatives<dim> here(space, dofs, field, displacement),
      there(space, dofs, field, displacement);
  // The normals of the two sides are opposite.
  const auto jump = [&](const std::vector<std::vector<double>> &one,
                        const std::vector<std::vector<double>> &other)
  {
    double sum = 0.;
    for (unsigned int q = 0; q < one.size(); ++q)
      for (unsigned int c = 0; c < one[q].size(); ++c)
        sum += std::pow(one[q][c] + other[q][c], 2) * here.weights()[q];
    return sum;
  };
  per_cell.reinit(space.triangulation.n_active_cells());
  for (const auto &cell : dofs.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      const double diameter =
          displacement == nullptr
              ? cell->diameter()
              : present_diameter<dim>(
                    typename DoFHandler<dim>::active_cell_iterator(
                        &space.triangulation, cell->level(), cell->index(), &space.velocity_dofs),
                    *displacement);
      double square = 0.;
      for (const unsigned int f : cell->face_indices())
        if (!cell->at_boundary(f) && cell->neighbor(f)->material_id() == cell->material_id())
          square += diameter / 24. * sum_over_pieces(cell, f, here, there, jump);
      per_cell[cell->active_cell_index()] = std::sqrt(square);
    }
}
} // namespace

template <int dim>
void kelly_indicators_of_velocity(const Space<dim> &space,
                                  const DistributedVector &velocity,
                                  const DistributedVector *const mesh_displacement,
                                  Vector<float> &per_cell)
{
  kelly_indicators(space, space.velocity_dofs, space.ghosted_velocity(velocity), mesh_displacement,
                   per_cell);
}

template <int dim>
void kelly_indicators_of_pressure(const Space<dim> &space,
                                  const DistributedVector &pressure,
                                  const DistributedVector *const mesh_displacement,
                                  Vector<float> &per_cell)
{
  kelly_indicators(space, space.pressure_dofs, space.ghosted_pressure(pressure), mesh_displacement,
                   per_cell);
}

template void kelly_indicators_of_velocity(const Space<2> &,
                                           const DistributedVector &,
                                           const DistributedVector *,
                                           Vector<float> &);
template void kelly_indicators_of_velocity(const Space<3> &,
                                           const DistributedVector &,
                                           const DistributedVector *,
                                           Vector<float> &);
template void kelly_indicators_of_pressure(const Space<2> &,
                                           const DistributedVector &,
                                           const DistributedVector *,
                                           Vector<float> &);
template void kelly_indicators_of_pressure(const Space<3> &,
                                           const DistributedVector &,
                                           const DistributedVector *,
                                           Vector<float> &);
} // namespace Continua
