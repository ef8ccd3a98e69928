#ifndef continua_finite_element_terms_inflow_terms_h
#define continua_finite_element_terms_inflow_terms_h

#include <continua/continuum/problem.h>
#include <continua/finite_element/space/space.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/hp/fe_values.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace Continua
{
/// The values of a cell at its dofs.
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

/**
 * What acts on the open ends whose pressure is the total one where liquid flows in: besides the
 * pressure the traction
 *
 *   t = rho(p)/2 min(U . n, 0) U,
 *
 * times 1 - phase, as a term -int v . t of the momentum equation. The liquid that flows in along
 * the normal then has the pressure that is given less rho/2 U^2. With the skew form of convection
 * it takes the kinetic energy that the inflow would carry into the body, so that the energy of the
 * body is bounded (Bazilevs, Gohean, Hughes, Moser and Zhang, Comput. Methods Appl. Mech. Engrg.
 * 198 (2009) 3534; Bertoglio and Caiazzo, Comput. Mech. 54 (2014) 711). It is 0 where liquid flows
 * out. On a mesh that moves the end is the present one, and U - W flows through it.
 */
template <int dim>
class InflowTerms
{
public:
  using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

  /// Both must outlive it.
  InflowTerms(const Space<dim> &space, const Problem &problem);

  /// Whether the cell has a face at such an end.
  bool has_face(const Cell &cell) const;
  /// Adds the cell's rows of momentum [N].
  void
  add(const Cell &pressure_cell, const CellState<dim> &state, dealii::Vector<double> &momentum);
  /// Adds their derivative by the cell's velocities, then its pressures.
  void add_derivative(const Cell &pressure_cell,
                      const CellState<dim> &state,
                      dealii::FullMatrix<double> &matrix);

private:
  /// The state at a quadrature point of a face.
  struct Point
  {
    double weight = 0.; ///< with 1 - phase
    double density = 0., density_slope = 0.;
    double inflow = 0.; ///< min(U . n, 0) [m/s]
    dealii::Tensor<1, dim> velocity, normal;
  };

  const Space<dim> &space;
  const Problem &problem;
  const dealii::FiniteElement<dim> &scalar_element;
  const dealii::Quadrature<dim - 1> quadrature;
  dealii::FEFaceValues<dim> values;
  dealii::hp::FEFaceValues<dim> hp_pressure_values;
  const dealii::FEFaceValues<dim> *pressure_values = nullptr; ///< on the present face
  /// The faces of the ends, by boundary and region.
  std::vector<std::pair<dealii::types::boundary_id, dealii::types::material_id>> ends;

  bool is_end(const Cell &cell, unsigned int face) const;
  void visit(const Cell &pressure_cell, unsigned int face);
  Point point(const Cell &cell, const CellState<dim> &state, unsigned int q) const;
  /// Makes weight and normal those of the present place; returns (U - W) . n there [m/s].
  double move(Point &point, const CellState<dim> &state, unsigned int q) const;
};
} // namespace Continua

#endif
