#include <continua/finite_volume/segregated_solve.h>

#include <continua/base/input_error.h>

#include <algorithm>
#include <sstream>
#include <utility>

namespace Continua
{
using namespace dealii;

template <int dim>
SegregatedSolve<dim>::SegregatedSolve(const CellWiseSystem<dim> &system, Sink sink)
    : system(system),
      sink(std::move(sink)),
      formulation(system.parameters.formulation),
      faces_balance(system.parameters.faces_balance()),
      equations(system),
      links(system, equations),
      predictor(system, equations, links),
      faces(system, equations, links),
      pressure_equation(system, equations, links, faces),
      momentum_residual(dim, system.space.communicator),
      continuity_residual(1, system.space.communicator),
      monitor(system.parameters.tolerance, system.parameters.maximum_corrections)
{
}

template <int dim>
void SegregatedSolve<dim>::reinit()
{
  equations.reinit();
  links.reinit(system.parameters.boundary_velocity_as == BoundaryVelocityAs::value);
  predictor.reinit();
  faces.reinit();
  if (formulation == Formulation::velocity_pressure)
    pressure_equation.reinit();
  for (Vector *const vector : {&right_side, &unknowns, &residual, &change, &products, &lack, &work})
    *vector = equations.vector();
}

template <int dim>
void SegregatedSolve<dim>::solve(const DistributedVector &momentum,
                                 const DistributedVector &mass,
                                 DistributedVector &velocity,
                                 DistributedVector &pressure,
                                 StepReport &report)
{
  equations.pack(momentum, mass, right_side);
  equations.pack(velocity, pressure, unknowns);
  unknowns.update_ghost_values();
  equations.residual(equations.face_momentum(), right_side, unknowns, residual);
  links.set_prescribed(residual, unknowns);
  unknowns.update_ghost_values();
  predictor.multiply(unknowns, products);
  if (formulation == Formulation::velocity_pressure)
    pressure_equation.multiply(unknowns, products);

  monitor.start();
  LoopCorrection correction;
  do
  {
    const unsigned int number = correction.number + 1;
    correction = correct();
    correction.number = number;
    if (sink)
      sink(correction);
  } while (monitor.goes_on(correction));

  report.corrections = correction.number;
  report.residual = correction.residual;
  report.cap_reached = !monitor.converged();
  if (report.cap_reached && system.parameters.at_cap == AtCap::fail)
  {
    std::ostringstream text;
    text
        << "the segregated loop reached its cap of " << correction.number
        << " corrections with a residual of " << correction.residual << " above the tolerance of "
        << system.parameters.tolerance
        << ". Take a smaller time step, a larger Cell-wise/Maximum corrections or Cell-wise/At the "
           "cap = warn";
    throw RunError(text.str());
  }
  equations.unpack(unknowns, velocity, pressure);
}

template <int dim>
LoopCorrection SegregatedSolve<dim>::correct()
{
  LoopCorrection correction;
  predict();
  correction.residual = momentum_residual.largest();
  correction.magnitude = momentum_residual.magnitude();
  if (formulation == Formulation::velocity_explicit_pressure)
    compute_pressure();
  else if (formulation == Formulation::velocity_pressure)
    correction.continuity = correct_pressure();
  return correction;
}

template <int dim>
void SegregatedSolve<dim>::predict()
{
  const unsigned int n_cell_rows = equations.cell_momentum().second;
  equations.residual({0, equations.face_momentum().second}, right_side, unknowns, residual);
  residual.update_ghost_values();
  links.add_to_cells(residual);
  momentum_residual.evaluate(n_cell_rows / dim, system.space.mesh.cell_dofs.n_dofs(),
                             residual.begin(), products.begin(), predictor.row_sums().data(),
                             unknowns.begin());
  predictor.solve(residual, change);
  for (unsigned int i = 0; i < n_cell_rows; ++i)
  {
    products.begin()[i] += residual.begin()[i];
    unknowns.begin()[i] += change.begin()[i];
  }
  change.update_ghost_values();
  links.follow(change, faces_balance ? nullptr : &residual, unknowns);
  unknowns.update_ghost_values();
  balance_faces();
}

template <int dim>
void SegregatedSolve<dim>::balance_faces()
{
  if (faces_balance)
    faces.solve(right_side, unknowns);
  else if (equations.has_pressure())
    faces.solve_pressures(right_side, unknowns);
  else
    return;
  unknowns.update_ghost_values();
}

template <int dim>
void SegregatedSolve<dim>::compute_pressure()
{
  const auto cells = equations.cell_mass();
  equations.residual(cells, right_side, unknowns, residual);
  for (unsigned int row = cells.first; row < cells.second; ++row)
    unknowns.begin()[row] += residual.begin()[row] / equations.entry(row, row);
  unknowns.update_ghost_values();
  balance_faces();
}

template <int dim>
double SegregatedSolve<dim>::correct_pressure()
{
  const unsigned int n_pressure_corrections = system.parameters.pressure_corrections;
  const auto cells = equations.cell_mass();
  std::fill_n(lack.begin(), equations.cell_momentum().second, 0.);
  for (unsigned int number = 0; number < n_pressure_corrections; ++number)
  {
    if (number > 0)
      update_by_diagonal();
    equations.residual(cells, right_side, unknowns, residual);
    continuity_residual.evaluate(cells.second - cells.first, system.space.mesh.cell_dofs.n_dofs(),
                                 residual.begin() + cells.first, products.begin() + cells.first,
                                 pressure_equation.row_sums().data(),
                                 unknowns.begin() + cells.first);
    // Is continuity satisfied?
    if (number > 0 && continuity_residual.largest() < system.parameters.tolerance)
      break;
    solve_pressure_equation();
  }
  return continuity_residual.largest();
}

template <int dim>
void SegregatedSolve<dim>::move_cells()
{
  const unsigned int n_cell_rows = equations.cell_momentum().second;
  for (unsigned int i = 0; i < n_cell_rows; ++i)
    unknowns.begin()[i] += change.begin()[i];
  change.update_ghost_values();
  links.follow(change, nullptr, unknowns);
  // The scale of the residual follows, and so does what the predictor's equations lack.
  predictor.multiply(change, work);
  for (unsigned int i = 0; i < n_cell_rows; ++i)
  {
    products.begin()[i] += work.begin()[i];
    lack.begin()[i] -= work.begin()[i];
  }
}

template <int dim>
void SegregatedSolve<dim>::update_by_diagonal()
{
  const std::vector<double> &inverse = pressure_equation.inverse_momentum();
  for (std::size_t cell = 0; cell < inverse.size(); ++cell)
    for (unsigned int c = 0; c < dim; ++c)
      change.begin()[dim * cell + c] = inverse[cell] * lack.begin()[dim * cell + c];
  move_cells();
  unknowns.update_ghost_values();
}

template <int dim>
void SegregatedSolve<dim>::solve_pressure_equation()
{
  const auto cells = equations.cell_mass();
  const auto momentum = equations.cell_momentum();
  pressure_equation.solve(residual, change);
  for (unsigned int i = cells.first; i < equations.face_pressure().second; ++i)
    unknowns.begin()[i] += change.begin()[i];
  for (unsigned int i = cells.first; i < cells.second; ++i)
    products.begin()[i] += residual.begin()[i];
  change.update_ghost_values();

  // U = H(U)/a_P - grad p / a_P: by the gradient of the pressure's change.
  std::fill_n(work.begin(), momentum.second, 0.);
  equations.add_pressure_gradient(momentum, -1., change, work);
  const std::vector<double> &inverse = pressure_equation.inverse_momentum();
  for (std::size_t cell = 0; cell < inverse.size(); ++cell)
    for (unsigned int c = 0; c < dim; ++c)
    {
      const double force = work.begin()[dim * cell + c];
      lack.begin()[dim * cell + c] += force;
      change.begin()[dim * cell + c] = inverse[cell] * force;
    }
  move_cells();
  unknowns.update_ghost_values();
  balance_faces();
}

template <int dim>
double SegregatedSolve<dim>::factor_entries() const
{
  return predictor.factor_entries() + pressure_equation.factor_entries();
}

template <int dim>
double SegregatedSolve<dim>::factor_memory() const
{
  return predictor.factor_memory() + pressure_equation.factor_memory();
}

template <int dim>
std::string SegregatedSolve<dim>::name() const
{
  return "segregated, " + predictor.name();
}

template class SegregatedSolve<2>;
template class SegregatedSolve<3>;
} // namespace Continua
