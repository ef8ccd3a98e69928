#include <continua/analysis/refinement_indicator.h>

#include <continua/base/input_error.h>
#include <continua/base/units.h>
#include <continua/continuum/step_extremes.h>
#include <continua/mesh/geometric_indicators.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
using namespace dealii;

namespace
{
template <int dim>
Vector<float> single_indicator(const Indicator indicator,
                               const Case<dim> &input,
                               ContinuumSolver<dim> &solver,
                               const double time)
{
  if (indicator == Indicator::interface_band)
  {
    std::vector<bool> is_solid;
    for (const Material &material : input.problem.materials)
      is_solid.push_back(material.is_solid());
    return interface_band(*input.triangulation, is_solid, input.adaptation.band_width);
  }
  if (indicator == Indicator::expression)
    return expression_indicator(*input.triangulation, input.adaptation.expression, time);
  IndicatorRequest request;
  request.kind = indicator == Indicator::kelly ? IndicatorRequest::Kind::kelly
                                               : IndicatorRequest::Kind::traction_jump;
  request.field = input.adaptation.kelly_field;
  Vector<float> per_cell;
  solver.indicators(request, per_cell);
  return per_cell;
}

/// No cell could be chosen by an indicator that is no number. Collective; throws RunError.
template <int dim>
void refuse_not_finite(const Triangulation<dim> &triangulation,
                       const MPI_Comm communicator,
                       const Indicator indicator,
                       const double time,
                       const Vector<float> &per_cell)
{
  unsigned int n_not_finite = 0;
  for (const auto &cell : triangulation.active_cell_iterators())
    if (cell->is_locally_owned() && !std::isfinite(per_cell[cell->active_cell_index()]))
      ++n_not_finite;
  n_not_finite = Utilities::MPI::sum(n_not_finite, communicator);
  if (n_not_finite > 0)
    throw RunError(std::string(indicator == Indicator::expression ? "'Adaptivity/Expression'"
                                                                  : "a refinement indicator") +
                   " is not finite in " + std::to_string(n_not_finite) + " cells at t = " +
                   shortest_number(time) + " s" + reason_not_finite(communicator));
}

/// Without what is negative, over the largest value of all ranks.
template <int dim>
void normalise(const Triangulation<dim> &triangulation,
               const MPI_Comm communicator,
               Vector<float> &per_cell)
{
  float largest = 0.f;
  for (const auto &cell : triangulation.active_cell_iterators())
    if (cell->is_locally_owned())
      largest = std::max(largest, per_cell[cell->active_cell_index()]);
  largest = Utilities::MPI::max(largest, communicator);
  for (float &value : per_cell)
    value = largest > 0.f ? std::max(value, 0.f) / largest : 0.f;
}
} // namespace

template <int dim>
Vector<float>
refinement_indicator(const Case<dim> &input, ContinuumSolver<dim> &solver, const double time)
{
  const AdaptationParameters &adaptation = input.adaptation;
  const bool combined = adaptation.indicators.size() > 1;
  Vector<float> sum(input.triangulation->n_active_cells());
  for (unsigned int i = 0; i < adaptation.indicators.size(); ++i)
  {
    Vector<float> per_cell = single_indicator(adaptation.indicators[i], input, solver, time);
    refuse_not_finite(*input.triangulation, input.communicator, adaptation.indicators[i], time,
                      per_cell);
    if (combined ||
        (adaptation.strategy == AdaptationStrategy::threshold && !adaptation.is_geometric()))
      normalise(*input.triangulation, input.communicator, per_cell);
    sum.add(adaptation.weights[i], per_cell);
  }
  return sum;
}

template Vector<float> refinement_indicator(const Case<2> &, ContinuumSolver<2> &, double);
template Vector<float> refinement_indicator(const Case<3> &, ContinuumSolver<3> &, double);
} // namespace Continua
