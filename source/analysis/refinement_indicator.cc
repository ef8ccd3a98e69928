#include <continua/analysis/refinement_indicator.h>

#include <continua/mesh/geometric_indicators.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

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
