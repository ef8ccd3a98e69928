#ifndef continua_finite_element_terms_cell_state_h
#define continua_finite_element_terms_cell_state_h

#include <deal.II/lac/vector.h>

namespace Continua
{
/// The values of a cell of a liquid at its dofs.
template <int dim>
struct CellState
{
  const dealii::Vector<double> &velocity; ///< component by component [m/s]
  const dealii::Vector<double> &pressure; ///< [Pa]
  // Of a mesh that moves, else null.
  const dealii::Vector<double> *mesh_displacement = nullptr; ///< component by component [m]
  const dealii::Vector<double> *mesh_velocity = nullptr;     ///< likewise [m/s]

  /// Scalar functions of a component.
  unsigned int n_functions() const { return velocity.size() / dim; }
  unsigned int place(const unsigned int component, const unsigned int function) const
  {
    return component * n_functions() + function;
  }
};
} // namespace Continua

#endif
