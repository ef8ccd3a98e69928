#include <continua/laboratory/wave_bar.h>

#include <continua/case/discretisation.h>
#include <continua/mesh/box_geometry.h>
#include <continua/signal/linear_recurrence.h>

#include <deal.II/base/numbers.h>
#include <deal.II/distributed/tria.h>

#include <algorithm>
#include <cmath>

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
} // namespace

WaveBar::WaveBar(const WaveScheme scheme, const unsigned int cells, const double courant_number)
    : scheme(scheme), cells(cells), courant_number(courant_number)
{
}

double WaveBar::theta() const
{
  return 2. * courant_number * std::sin(PI / cells);
}

Complex WaveBar::measured() const
{
  const WaveSchemeData &data = data_of(scheme);
  const unsigned int n_steps = data.n_start + 2 * data.n_factors;
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
  const std::vector<Complex> factors = recurrence_factors(states, data.n_factors);
  // As Amplification::of_wave(), of which it is the measurement.
  const double least = 1e-5 * std::abs(factors.front());
  const auto wave = std::find_if(factors.begin(), factors.end(),
                                 [least](const Complex value) { return value.imag() > least; });
  return wave == factors.end() ? factors.front() : *wave;
}

double WaveBar::speed_ratio(const Complex factor) const
{
  // Of a real negative number the sign of a zero decides.
  return std::abs(std::arg(factor)) * cells / (2. * PI * courant_number);
}
} // namespace Continua
