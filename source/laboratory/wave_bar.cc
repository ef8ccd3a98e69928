#include <continua/laboratory/wave_bar.h>

#include <continua/case/discretisation.h>
#include <continua/mesh/box_geometry.h>
#include <continua/signal/linear_recurrence.h>

#include <deal.II/base/numbers.h>
#include <deal.II/distributed/tria.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Continua
{
using dealii::numbers::PI;

namespace
{
/// Waves along the bar have the speed 1 m/s.
Problem make_problem()
{
  Problem problem;
  problem.communicator = MPI_COMM_SELF;
  problem.model = Model::plane_strain;
  const BoxGeometry<2> box({}, false);
  problem.regions = box.regions();
  problem.boundaries = box.boundaries();
  Material material;
  material.type = "hookean";
  material.density = 1.;
  material.shear.branches = {{0.5}};
  material.compression = Compression::elastic(3.);
  problem.materials = {material};
  for (unsigned int face = 0; face < problem.boundaries.size(); ++face)
  {
    BoundaryCondition condition;
    condition.name = problem.boundaries[face];
    condition.type = BoundaryType::roller;
    condition.boundary_id = face;
    condition.region_ids = {0};
    condition.normal.kind = BoundaryPart::Kind::velocity;
    problem.conditions.push_back(condition);
  }
  problem.interior.initial_velocity = {Expression("sin(2*pi*x)", Dimensions::velocity),
                                       Expression(0.)};
  return problem;
}

/// States behind those that a recurrence is made of.
constexpr unsigned int n_checked = 2;

/// Whether the recurrence of the factors leads from each state but the first ones to the next.
bool follows(const std::vector<double> &states, const std::vector<Complex> &factors)
{
  // (x - G_1)(x - G_2)..., the lowest power first.
  std::vector<Complex> polynomial = {1.};
  for (const Complex factor : factors)
  {
    polynomial.insert(polynomial.begin(), 0.);
    for (std::size_t j = 0; j + 1 < polynomial.size(); ++j)
      polynomial[j] -= factor * polynomial[j + 1];
  }
  const std::size_t order = factors.size();
  for (std::size_t i = states.size() - order - n_checked; i + order < states.size(); ++i)
  {
    Complex sum = 0.;
    double scale = 0.;
    for (std::size_t j = 0; j <= order; ++j)
    {
      sum += polynomial[j] * states[i + j];
      scale = std::max(scale, std::abs(states[i + j]));
    }
    if (!(std::abs(sum) <= 1e-6 * scale))
      return false;
  }
  return true;
}
} // namespace

WaveBar::WaveBar(const WaveScheme scheme, const unsigned int cells, const double courant_number)
    : scheme(scheme), cells(cells), courant_number(courant_number)
{
}

double WaveBar::theta() const
{
  return 2. * courant_number * std::sin(PI / cells);
}

std::optional<Complex> WaveBar::measured(const Complex expected) const
{
  const WaveSchemeData &data = data_of(scheme);
  const unsigned int n_steps = data.n_start + 2 * data.n_factors + n_checked;
  TimeParameters time;
  time.scheme = data.scheme;
  time.update = data.update;
  time.smooth_start = false;
  time.time_step = courant_number / cells;
  time.end_time = n_steps * time.time_step;

  dealii::parallel::distributed::Triangulation<2> triangulation(MPI_COMM_SELF);
  BoxGeometry<2>::Parameters box;
  box.cells = {cells, 1};
  box.size = {1., 1. / cells};
  BoxGeometry<2>(box, false).create(triangulation);
  const Problem problem = make_problem();
  DiscretisationParameters discretisation;
  discretisation.type = "cell-wise";
  discretisation.cell_wise.formulation = data.formulation;
  Log silent(MPI_COMM_SELF, false);
  const auto solver = make_solver<2>(triangulation, problem, discretisation, silent);
  solver->initialise();
  ProbeRequest<2> request;
  // The unknown: of a difference of its levels a root may be missing.
  request.field = data.formulation == Formulation::displacement ? "displacement x" : "velocity x";
  request.point = dealii::Point<2>(0.5 / cells, 0.5 / cells);
  solver->add_probe(request);

  TimeControl control(time);
  std::vector<double> states, values;
  while (!control.at_end())
  {
    for (const Step &step : control.next())
      solver->advance(step);
    solver->evaluate_probes(values);
    if (control.n_steps() > data.n_start)
      states.push_back(values[0]);
  }
  std::vector<Complex> factors;
  try
  {
    factors = recurrence_factors(states, data.n_factors);
  }
  catch (const std::invalid_argument &)
  {
    return std::nullopt;
  }
  if (!follows(states, factors))
    return std::nullopt;
  return *std::min_element(factors.begin(), factors.end(),
                           [expected](const Complex a, const Complex b)
                           { return std::abs(a - expected) < std::abs(b - expected); });
}

double WaveBar::speed_ratio(const Complex factor) const
{
  // Of a real negative number the sign of a zero decides.
  return std::abs(std::arg(factor)) * cells / (2. * PI * courant_number);
}
} // namespace Continua
