#ifndef continua_tests_mesh_curved_measures_h
#define continua_tests_mesh_curved_measures_h

// What the tests of geometries with curved surfaces measure, as a discretisation with curved cells
// sees it.

#include <continua/mesh/geometry.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace measures
{
template <int dim>
struct CurvedMeasures
{
  /// Of the active cells, with a mapping of that degree.
  CurvedMeasures(const Continua::Geometry<dim> &geometry,
                 const dealii::Triangulation<dim> &mesh,
                 const unsigned int degree)
      : CurvedMeasures(geometry.regions(), geometry.boundaries(), mesh, degree)
  {
  }
  CurvedMeasures(const std::vector<std::string> &regions,
                 const std::vector<std::string> &boundaries,
                 const dealii::Triangulation<dim> &mesh,
                 const unsigned int degree)
  {
    const dealii::MappingQ<dim> mapping(degree);
    const dealii::FE_Nothing<dim> element;
    dealii::FEValues<dim> values(mapping, element, dealii::QGauss<dim>(degree + 2),
                                 dealii::update_JxW_values | dealii::update_quadrature_points |
                                     dealii::update_jacobians);
    dealii::FEFaceValues<dim> face_values(mapping, element, dealii::QGauss<dim - 1>(degree + 2),
                                          dealii::update_JxW_values |
                                              dealii::update_normal_vectors |
                                              dealii::update_quadrature_points);
    for (const auto &cell : mesh.active_cell_iterators())
    {
      values.reinit(cell);
      for (const unsigned int q : values.quadrature_point_indices())
      {
        volumes[regions.at(cell->material_id())] += values.JxW(q);
        moment += values.JxW(q) * values.quadrature_point(q);
        const dealii::Tensor<2, dim> jacobian = values.jacobian(q);
        double lengths = 1.;
        for (unsigned int d = 0; d < dim; ++d)
          lengths *= (jacobian * dealii::Tensor<1, dim>(dealii::Point<dim>::unit_vector(d))).norm();
        least_determinant = std::min(least_determinant, dealii::determinant(jacobian) / lengths);
      }
      for (const unsigned int f : cell->face_indices())
        if (cell->at_boundary(f))
        {
          face_values.reinit(cell, f);
          const std::string &name = boundaries.at(cell->face(f)->boundary_id());
          for (const unsigned int q : face_values.quadrature_point_indices())
          {
            const dealii::Tensor<1, dim> area = face_values.JxW(q) * face_values.normal_vector(q);
            areas[name] += face_values.JxW(q);
            normals[name] += area;
            flux += face_values.quadrature_point(q) * area / dim;
          }
        }
    }
  }

  double volume() const
  {
    double sum = 0.;
    for (const auto &[name, value] : volumes)
      sum += value;
    return sum;
  }
  dealii::Tensor<1, dim> closure() const
  {
    dealii::Tensor<1, dim> sum;
    for (const auto &[name, value] : normals)
      sum += value;
    return sum;
  }

  /// By the names of regions and boundaries; in two dimensions areas and lengths.
  std::map<std::string, double> volumes, areas;
  std::map<std::string, dealii::Tensor<1, dim>> normals; ///< the sums of normals times area
  dealii::Tensor<1, dim> moment;                         ///< the sum of places times volume
  double flux = 0.;              ///< of the places through all boundaries, over dim: the volume
  double least_determinant = 1.; ///< of the cells' maps, over the lengths of the columns
};
} // namespace measures

#endif
