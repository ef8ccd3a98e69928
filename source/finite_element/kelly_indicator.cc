#include <continua/finite_element/face_pieces.h>
#include <continua/finite_element/kelly_indicator.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/hp/fe_values.h>

#include <cmath>
#include <vector>

namespace Continua
{
using namespace dealii;

namespace
{
/// Derivatives along the outward normal on one side of a face, by component at each point.
template <int dim>
class SideDerivatives
{
public:
  using Cell = typename DoFHandler<dim>::active_cell_iterator;

  SideDerivatives(const Space<dim> &space,
                  const DoFHandler<dim> &dofs,
                  const DistributedVector &field)
      : dofs(dofs),
        field(field),
        n_points(QGauss<dim - 1>(space.degree() + 1).size()),
        n_components(dofs.get_fe(0).n_components()),
        face_values(space.mappings,
                    dofs.get_fe_collection(),
                    hp::QCollection<dim - 1>(QGauss<dim - 1>(space.degree() + 1)),
                    update_gradients | update_quadrature_points | update_JxW_values |
                        update_normal_vectors),
        subface_values(space.mappings,
                       dofs.get_fe_collection(),
                       hp::QCollection<dim - 1>(QGauss<dim - 1>(space.degree() + 1)),
                       update_gradients | update_quadrature_points | update_JxW_values |
                           update_normal_vectors),
        gradients(n_points, std::vector<Tensor<1, dim>>(n_components)),
        derivatives(n_points, std::vector<double>(n_components))
  {
  }
  const std::vector<std::vector<double>> &face(const Cell &cell, const unsigned int f)
  {
    face_values.reinit(cell, f);
    return compute(face_values.get_present_fe_values());
  }
  const std::vector<std::vector<double>> &
  subface(const Cell &cell, const unsigned int f, const unsigned int piece)
  {
    subface_values.reinit(cell, f, piece);
    return compute(subface_values.get_present_fe_values());
  }
  /// Of the face or piece looked at last.
  const FEValuesBase<dim> &last() const { return *last_values; }

private:
  const DoFHandler<dim> &dofs;
  const DistributedVector &field;
  const unsigned int n_points, n_components;
  hp::FEFaceValues<dim> face_values;
  hp::FESubfaceValues<dim> subface_values;
  std::vector<std::vector<Tensor<1, dim>>> gradients;
  std::vector<std::vector<double>> derivatives;
  const FEValuesBase<dim> *last_values = nullptr;

  const std::vector<std::vector<double>> &compute(const FEValuesBase<dim> &values)
  {
    // A pressure has no part in the components of other regions: their gradients are zero.
    values.get_function_gradients(field, gradients);
    for (unsigned int q = 0; q < n_points; ++q)
      for (unsigned int c = 0; c < n_components; ++c)
        derivatives[q][c] = gradients[q][c] * values.normal_vector(q);
    last_values = &values;
    return derivatives;
  }
};

template <int dim>
void kelly_indicators(const Space<dim> &space,
                      const DoFHandler<dim> &dofs,
                      const DistributedVector &field,
                      Vector<float> &per_cell)
{
  SideDerivatives<dim> here(space, dofs, field), there(space, dofs, field);
  // The normals of the two sides are opposite.
  const auto jump = [&](const std::vector<std::vector<double>> &one,
                        const std::vector<std::vector<double>> &other)
  {
    double sum = 0.;
    for (unsigned int q = 0; q < one.size(); ++q)
      for (unsigned int c = 0; c < one[q].size(); ++c)
        sum += std::pow(one[q][c] + other[q][c], 2) * here.last().JxW(q) *
               space.measure(here.last().quadrature_point(q));
    return sum;
  };
  per_cell.reinit(space.triangulation.n_active_cells());
  for (const auto &cell : dofs.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      double square = 0.;
      for (const unsigned int f : cell->face_indices())
        if (!cell->at_boundary(f) && cell->neighbor(f)->material_id() == cell->material_id())
          square += cell->diameter() / 24. * sum_over_pieces(cell, f, here, there, jump);
      per_cell[cell->active_cell_index()] = std::sqrt(square);
    }
}
} // namespace

template <int dim>
void kelly_indicators_of_velocity(const Space<dim> &space,
                                  const DistributedVector &velocity,
                                  Vector<float> &per_cell)
{
  kelly_indicators(space, space.velocity_dofs, space.ghosted_velocity(velocity), per_cell);
}

template <int dim>
void kelly_indicators_of_pressure(const Space<dim> &space,
                                  const DistributedVector &pressure,
                                  Vector<float> &per_cell)
{
  kelly_indicators(space, space.pressure_dofs, space.ghosted_pressure(pressure), per_cell);
}

template void
kelly_indicators_of_velocity(const Space<2> &, const DistributedVector &, Vector<float> &);
template void
kelly_indicators_of_velocity(const Space<3> &, const DistributedVector &, Vector<float> &);
template void
kelly_indicators_of_pressure(const Space<2> &, const DistributedVector &, Vector<float> &);
template void
kelly_indicators_of_pressure(const Space<3> &, const DistributedVector &, Vector<float> &);
} // namespace Continua
