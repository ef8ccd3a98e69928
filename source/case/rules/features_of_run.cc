#include <continua/case/rules/feature_rows.h>

#include <deal.II/base/mpi.h>

namespace Continua
{
namespace
{
template <int dim>
bool has_direct_solver(const Case<dim> &input, const DirectSolver solver)
{
  return is_taylor_hood(input) &&
         input.discretisation.taylor_hood.linear_solver.direct_solver == solver;
}
} // namespace

template <int dim>
FeatureGroup<dim> analyses_as_features()
{
  using Input = const Case<dim> &;
  return {"Analysis",
          {of_input<dim>("transient", "Analysis = transient",
                         [](Input input) { return input.analysis.is_transient(); }),
           of_input<dim>("steady", "Analysis = steady",
                         [](Input input) { return input.analysis.is_steady(); }),
           of_input<dim>("modal", "Analysis = modal",
                         [](Input input) { return input.analysis.is_modal(); }),
           of_input<dim>("highest modes", "Modal/Which = highest",
                         [](Input input)
                         { return input.analysis.is_modal() && input.modal.highest(); }),
           of_input<dim>("shift of modes", "Modal/Shift",
                         [](Input input)
                         { return input.analysis.is_modal() && input.modal.shift > 0.; }),
           of_input<dim>("harmonic", "Analysis = harmonic",
                         [](Input input) { return input.analysis.name == "harmonic"; }),
           of_input<dim>("resonances", "Analysis = resonances",
                         [](Input input) { return input.analysis.name == "resonances"; }),
           of_input<dim>("periodic response", "Analysis = periodic response",
                         [](Input input) { return input.analysis.name == "periodic response"; }),
           of_input<dim>("pulse response", "Analysis = pulse response",
                         [](Input input) { return input.analysis.name == "pulse response"; }),
           of_input<dim>("no steps in time", "Analysis",
                         [](Input input) { return !is_in_time(input); })}};
}

template <int dim>
FeatureGroup<dim> models_as_features()
{
  using Input = const Case<dim> &;
  return {
      "Model and discretisation",
      {of_input<dim>("plane stress", "Model = plane stress",
                     [](Input input) { return input.problem.model == Model::plane_stress; }),
       of_input<dim>("taylor hood", "Discretisation = taylor hood",
                     [](Input input) { return is_taylor_hood(input); }),
       of_input<dim>("velocity degree other than 2", "Finite element/Velocity degree",
                     [](Input input) {
                       return is_taylor_hood(input) &&
                              input.discretisation.taylor_hood.space.velocity_degree != 2;
                     }),
       of_input<dim>("cell-wise", "Discretisation = cell-wise",
                     [](Input input) { return input.discretisation.is_cell_wise(); }),
       of_input<dim>("displacement form", "Cell-wise/Formulation = displacement",
                     [](Input input) { return has_formulation(input, Formulation::displacement); }),
       of_input<dim>("velocity form", "Cell-wise/Formulation = velocity",
                     [](Input input) { return has_formulation(input, Formulation::velocity); }),
       of_input<dim>("explicit pressure form", "Cell-wise/Formulation = velocity explicit pressure",
                     [](Input input)
                     { return has_formulation(input, Formulation::velocity_explicit_pressure); }),
       of_input<dim>("velocity-pressure form", "Cell-wise/Formulation = velocity-pressure",
                     [](Input input)
                     { return has_formulation(input, Formulation::velocity_pressure); }),
       of_input<dim>("coupled solve", "Cell-wise/Solution = coupled",
                     [](Input input) {
                       return input.discretisation.is_cell_wise() &&
                              !input.discretisation.cell_wise.is_segregated();
                     }),
       of_input<dim>("segregated loop", "Cell-wise/Solution = segregated",
                     [](Input input) {
                       return input.discretisation.is_cell_wise() &&
                              input.discretisation.cell_wise.is_segregated();
                     }),
       of_input<dim>("longitudinal stencil", "Cell-wise/Stencil coefficient = longitudinal",
                     [](Input input)
                     {
                       return input.discretisation.is_cell_wise() &&
                              input.discretisation.cell_wise.stencil_coefficient ==
                                  StencilCoefficient::longitudinal;
                     }),
       of_input<dim>("inconsistent accumulated term", "Cell-wise/Accumulated term = inconsistent",
                     [](Input input)
                     {
                       return input.discretisation.is_cell_wise() &&
                              input.discretisation.cell_wise.accumulated_term ==
                                  AccumulatedTerm::inconsistent;
                     }),
       of_input<dim>("force balance of boundaries",
                     "Cell-wise/Pressure at boundaries = force balance",
                     [](Input input)
                     {
                       return input.discretisation.is_cell_wise() &&
                              input.discretisation.cell_wise.boundary_pressure ==
                                  BoundaryPressure::force_balance;
                     }),
       of_input<dim>("trapezoidal pressure", "Cell-wise/Pressure update = trapezoidal",
                     [](Input input)
                     {
                       return input.discretisation.is_cell_wise() &&
                              input.discretisation.cell_wise.pressure_update ==
                                  PressureUpdate::trapezoidal;
                     }),
       of_input<dim>("pressure unlike the displacement", "Cell-wise/Pressure update",
                     [](Input input)
                     {
                       const CellWiseParameters &parameters = input.discretisation.cell_wise;
                       return input.discretisation.is_cell_wise() && parameters.has_pressure() &&
                              parameters.pressure_update != PressureUpdate::as_displacement;
                     }),
       of_input<dim>(
           "power by the thesis's operators", "Cell-wise/Power operator = compact or wide",
           [](Input input)
           {
             return input.discretisation.is_cell_wise() &&
                    input.discretisation.cell_wise.power_operator != PowerOperator::scheme;
           })}};
}

template <int dim>
FeatureGroup<dim> steps_as_features()
{
  using Input = const Case<dim> &;
  return {
      "Time",
      {of_input<dim>("crank nicolson", "Time/Scheme = crank nicolson",
                     [](Input input)
                     { return is_in_time(input) && input.time.scheme == Scheme::crank_nicolson; }),
       of_input<dim>("trapezoidal update", "Time/Update = trapezoidal",
                     [](Input input) {
                       return is_in_time(input) && input.time.update_type() == Update::trapezoidal;
                     }),
       of_input<dim>("adaptive steps", "Time/Time step control = adaptive",
                     [](Input input) {
                       return (is_in_time(input) || input.analysis.is_harmonic()) &&
                              input.time.is_adaptive();
                     }),
       of_input<dim>("displacement form by backward differencing",
                     "Time/Scheme = backward differencing",
                     [](Input input)
                     {
                       return is_in_time(input) &&
                              input.time.scheme == Scheme::backward_differencing &&
                              has_formulation(input, Formulation::displacement);
                     }),
       of_input<dim>("steady start", "Initial state/Type = steady or mean",
                     [](Input input)
                     {
                       return (is_in_time(input) || input.analysis.is_steady()) &&
                              input.problem.interior.starts_steady_under_loads;
                     }),
       of_input<dim>("start from the shape of the mesh", "Initial state/Type = given",
                     [](Input input)
                     {
                       return is_in_time(input) &&
                              !input.problem.interior.starts_steady_under_loads &&
                              !input.problem.finds_unloaded_shape();
                     }),
       of_input<dim>("no unloaded shape in a steady flow", "Unloaded shape = mesh",
                     [](Input input) {
                       return input.analysis.is_steady() && !input.problem.finds_unloaded_shape();
                     })}};
}

template <int dim>
FeatureGroup<dim> solvers_as_features()
{
  using Input = const Case<dim> &;
  return {
      "Solvers and output",
      {of_input<dim>("iterative solver", "Linear solver/Type = iterative",
                     [](Input input)
                     {
                       return is_taylor_hood(input) &&
                              input.discretisation.taylor_hood.linear_solver.type ==
                                  LinearSolverType::iterative;
                     }),
       of_input<dim>("cholmod", "Linear solver/Direct solver = cholmod",
                     [](Input input) { return has_direct_solver(input, DirectSolver::cholmod); }),
       of_input<dim>("umfpack", "Linear solver/Direct solver = umfpack",
                     [](Input input) { return has_direct_solver(input, DirectSolver::umfpack); }),
       of_input<dim>("several ranks", "mpirun -n 2",
                     [](Input input)
                     { return dealii::Utilities::MPI::n_mpi_processes(input.communicator) > 1; }),
       of_input<dim>("matrix-free products", "Linear solver/Velocity product = matrix-free",
                     [](Input input)
                     {
                       return is_taylor_hood(input) &&
                              input.discretisation.taylor_hood.linear_solver.velocity_product ==
                                  VelocityProduct::matrix_free;
                     }),
       of_input<dim>("polynomial multigrid", "Linear solver/Stiff block = polynomial multigrid",
                     [](Input input)
                     {
                       return is_taylor_hood(input) &&
                              input.discretisation.taylor_hood.linear_solver.stiff_block ==
                                  StiffBlock::polynomial_multigrid;
                     }),
       of_input<dim>("checkpoints", "Output/Checkpoint interval",
                     [](Input input) { return input.output.checkpoint_interval > 0.; }),
       of_input<dim>("checkpoint at the end", "Output/Checkpoint at end = true",
                     [](Input input) { return input.output.checkpoint_at_end; }),
       of_input<dim>("analysis without checkpoints", "Analysis",
                     [](Input input) { return !input.analysis.has_checkpoints; }),
       of_input<dim>("averages of wall shear stress", "Output/Further fields",
                     [](Input input) { return input.output.further_fields.wall_shear_averages; })}};
}

template FeatureGroup<2> analyses_as_features();
template FeatureGroup<3> analyses_as_features();
template FeatureGroup<2> models_as_features();
template FeatureGroup<3> models_as_features();
template FeatureGroup<2> steps_as_features();
template FeatureGroup<3> steps_as_features();
template FeatureGroup<2> solvers_as_features();
template FeatureGroup<3> solvers_as_features();
} // namespace Continua
