#include <continua/laboratory/laboratory_specimen.h>

#include <continua/finite_element/taylor_hood.h>
#include <continua/mesh/box_geometry.h>

namespace Continua
{
using namespace dealii;

namespace
{
/// The faces at the lower end of each direction slide on rollers (or are the axis); the upper one
/// along x is loaded, the others are free.
template <int dim>
Problem make_problem(const Material &material,
                     const typename LaboratorySpecimen<dim>::Control control,
                     const Expression &load)
{
  Problem problem;
  problem.communicator = MPI_COMM_SELF;
  problem.model = dim == 2 ? Model::axisymmetric : Model::three_dimensional;
  const BoxGeometry<dim> box({}, dim == 2);
  problem.regions = box.regions();
  problem.boundaries = box.boundaries();
  problem.materials = {material};
  problem.materials[0].density = 0.;
  for (unsigned int face = 0; face < problem.boundaries.size(); ++face)
  {
    BoundaryCondition condition;
    condition.name = problem.boundaries[face];
    condition.boundary_id = face;
    condition.region_ids = {0};
    if (face % 2 == 0)
      condition.normal.kind = BoundaryPart::Kind::velocity;
    else if (face == 1)
    {
      if (control == LaboratorySpecimen<dim>::Control::strain_rate)
        condition.normal.kind = BoundaryPart::Kind::velocity;
      condition.normal.along_normal = Waveform(load);
    }
    problem.conditions.push_back(condition);
  }
  return problem;
}

template <int dim>
std::unique_ptr<parallel::distributed::Triangulation<dim>> make_mesh()
{
  auto triangulation = std::make_unique<parallel::distributed::Triangulation<dim>>(MPI_COMM_SELF);
  typename BoxGeometry<dim>::Parameters box;
  box.cells.assign(dim, 1);
  BoxGeometry<dim>(box, dim == 2).create(*triangulation);
  return triangulation;
}

/// Without inertia nothing but the pressure resists a change of volume: the matrix needs pivots.
TaylorHoodParameters pivoting_solver()
{
  TaylorHoodParameters parameters;
  parameters.linear_solver.type = LinearSolverType::direct;
  parameters.linear_solver.direct_solver = DirectSolver::umfpack;
  return parameters;
}
} // namespace

template <int dim>
LaboratorySpecimen<dim>::LaboratorySpecimen(const Material &material,
                                            const Control control,
                                            const Expression &load,
                                            const TimeParameters &time,
                                            Log &log)
    : parameters(time),
      time_control(time),
      triangulation(make_mesh<dim>()),
      problem(make_problem<dim>(material, control, load)),
      solver(std::make_unique<TaylorHood<dim>>(*triangulation, problem, pivoting_solver(), log),
             problem,
             log)
{
  solver.initialise();
  for (const char *field : {"strain xx", "stress xx"})
  {
    ProbeRequest<dim> request;
    request.field = field;
    for (unsigned int d = 0; d < dim; ++d)
      request.point[d] = 0.5;
    solver.add_probe(request);
  }
}

template <int dim>
typename LaboratorySpecimen<dim>::Sample LaboratorySpecimen<dim>::advance()
{
  // As a transient analysis does it.
  const double start = time_control.time(), size = time_control.next_size();
  if (time_control.n_steps() > 0 && parameters.scheme != Scheme::euler_implicit &&
      solver.data_jump(start - 1e-6 * size, start + (1. - 1e-6) * size))
    time_control.restart();
  for (const Step &step : time_control.next())
    solver.advance(step);
  solver.evaluate_probes(probes);
  return {time_control.time(), probes[0], probes[1]};
}

template <int dim>
std::vector<typename LaboratorySpecimen<dim>::Sample> LaboratorySpecimen<dim>::run()
{
  std::vector<Sample> samples;
  while (!at_end())
    samples.push_back(advance());
  return samples;
}

template class LaboratorySpecimen<2>;
template class LaboratorySpecimen<3>;
} // namespace Continua
