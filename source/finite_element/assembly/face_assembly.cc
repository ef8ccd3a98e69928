#include <continua/finite_element/assembly/face_assembly.h>

#include <cstddef>

namespace Continua
{
using namespace dealii;

template <int dim>
void FaceAssembly<dim>::add(const DeformedFacePoint<dim> &shapes,
                            const double weight,
                            const TestedOnFace<dim> &tested,
                            Vector<double> &rows) const
{
  const std::size_t n_functions = shapes.n_functions();
  for (unsigned int c = 0; c < dim; ++c)
  {
    const double factor = weight * tested.by_value[c];
    for (std::size_t a = 0; a < n_functions; ++a)
      rows[c * n_functions + a] += factor * shapes.values[a];
  }
}

template <int dim>
void FaceAssembly<dim>::add_products(const DeformedFacePoint<dim> &shapes,
                                     const unsigned int component,
                                     const bool has_derivatives,
                                     FullMatrix<double> &matrix)
{
  const std::size_t n_functions = shapes.n_functions();
  row.resize(n_functions);
  for (unsigned int c = 0; c < dim; ++c)
  {
    for (std::size_t b = 0; b < n_functions; ++b)
    {
      row[b] = by_velocity[0][c] * shapes.values[b];
      for (unsigned int k = 0; has_derivatives && k < dim; ++k)
        row[b] += by_velocity[k + 1][c] * shapes.gradients[b][k];
    }
    for (std::size_t a = 0; a < n_functions; ++a)
    {
      // Most functions of the cell are 0 on the face.
      const double value = shapes.values[a];
      if (value == 0.)
        continue;
      double *const entries = &matrix(c * n_functions + a, component * n_functions);
      for (std::size_t b = 0; b < n_functions; ++b)
        entries[b] += value * row[b];
    }
  }
}

template <int dim>
void FaceAssembly<dim>::add_products_with_pressures(const DeformedFacePoint<dim> &shapes,
                                                    const std::vector<double> &pressure_values,
                                                    const Tensor<1, dim> &by_pressure,
                                                    FullMatrix<double> &matrix)
{
  const std::size_t n_functions = shapes.n_functions();
  for (unsigned int c = 0; c < dim; ++c)
    for (std::size_t a = 0; a < n_functions; ++a)
      for (std::size_t l = 0; l < pressure_values.size(); ++l)
        matrix(c * n_functions + a, dim * n_functions + l) +=
            by_pressure[c] * shapes.values[a] * pressure_values[l];
}

template class FaceAssembly<2>;
template class FaceAssembly<3>;
} // namespace Continua
