#include <continua/finite_volume/momentum_predictor.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
using namespace dealii;

template <int dim>
MomentumPredictor<dim>::MomentumPredictor(const CellWiseSystem<dim> &system,
                                          const SplitEquations<dim> &equations,
                                          const FaceLinks<dim> &links)
    : system(system), equations(equations), links(links), matrix(system.space.mesh)
{
}

template <int dim>
void MomentumPredictor<dim>::find_couplings()
{
  const CellWiseSpace<dim> &space = system.space;
  const CellWiseMesh<dim> &mesh = space.mesh;
  const auto add = [&](const unsigned int f, const double stiffness)
  {
    const VolumeFace<dim> &face = mesh.faces()[f];
    matrix.couple(face,
                  {{equations.velocity_index(space.velocities.of_cell(face.cell(0))),
                    equations.velocity_index(space.velocities.of_cell(face.cell(1)))}},
                  stiffness);
  };
  for (unsigned int f = 0; f < mesh.faces().size(); ++f)
  {
    const VolumeFace<dim> &surface = mesh.faces()[f];
    if (surface.has_value())
      continue;
    const unsigned int region = mesh.cells()[surface.owner].material_id;
    const double modulus =
        system.coefficients().stiffness[region] *
        traction_coefficients(system.problem.materials[region], system.parameters).stencil_ratio;
    add(f, modulus * surface.area / (surface.distance * surface.normal));
  }
  // The face between two materials is eliminated: its links in series.
  for (const auto &link : links.links())
    if (link.n_sides == 2)
      add(link.face, link.weight_ratio * link.stiffness[0] * link.stiffness[1] * link.compliance);
}

template <int dim>
void MomentumPredictor<dim>::set_row_sums()
{
  const CellWiseSpace<dim> &space = system.space;
  const CellWiseMesh<dim> &mesh = space.mesh;
  const CellWiseCoefficients &coefficients = system.coefficients();
  std::vector<double> &sums = matrix.row_sums();
  for (unsigned int cell = 0; cell < mesh.n_owned_cells(); ++cell)
  {
    const FiniteVolume<dim> &volume = mesh.cells()[cell];
    for (unsigned int c = 0; c < dim; ++c)
      sums[dim * cell + c] = coefficients.mass[volume.material_id] * volume.volume;
    // The vector Laplacian's hoop term, with the same coefficient.
    if (space.is_axisymmetric())
      sums[dim * cell + 1] +=
          coefficients.stiffness[volume.material_id] *
          traction_coefficients(system.problem.materials[volume.material_id], system.parameters)
              .stencil_ratio *
          volume.volume / (volume.radius * volume.radius);
  }
  for (const auto &link : links.links())
    if (link.n_sides == 1)
      for (unsigned int c = 0; c < dim; ++c)
        if (!link.follows[c])
          sums[link.cells[0] + c] += link.hold[c];
}

template <int dim>
void MomentumPredictor<dim>::reinit()
{
  matrix.reinit(0, dim);
  find_couplings();
  set_row_sums();
  const std::vector<double> &sums = matrix.row_sums();
  const unsigned int n_owned = system.space.mesh.n_owned_cells();
  component.resize(n_owned);
  factors.clear();
  for (unsigned int c = 0; c < dim; ++c)
  {
    unsigned int same = 0;
    while (same < c)
    {
      bool differs = false;
      for (unsigned int cell = 0; cell < n_owned && !differs; ++cell)
        differs = std::abs(sums[dim * cell + c] - sums[dim * cell + same]) >
                  1e-12 * std::abs(sums[dim * cell + same]);
      if (Utilities::MPI::max(differs ? 1 : 0, system.space.communicator) == 0)
        break;
      ++same;
    }
    if (same < c)
    {
      factor_of[c] = factor_of[same];
      continue;
    }
    factor_of[c] = factors.size();
    factors.push_back(make_symmetric_factor(DirectSolver::automatic, true, matrix.n_entries(),
                                            system.space.communicator));
    matrix.factorize(c, *factors.back());
  }
}

template <int dim>
void MomentumPredictor<dim>::solve(const Vector &residual, Vector &change)
{
  const double *const r = residual.begin();
  double *const d = change.begin();
  for (unsigned int c = 0; c < dim; ++c)
  {
    for (std::size_t cell = 0; cell < component.size(); ++cell)
      component[cell] = r[dim * cell + c];
    factors[factor_of[c]]->solve(component);
    for (std::size_t cell = 0; cell < component.size(); ++cell)
      d[dim * cell + c] = component[cell];
  }
}

template <int dim>
double MomentumPredictor<dim>::factor_entries() const
{
  double sum = 0.;
  for (const auto &factor : factors)
    sum += factor->n_entries();
  return sum;
}

template <int dim>
double MomentumPredictor<dim>::factor_memory() const
{
  double sum = 0.;
  for (const auto &factor : factors)
    sum += factor->memory();
  return sum;
}

template <int dim>
std::string MomentumPredictor<dim>::name() const
{
  return factors.empty() ? "" : factors.front()->name();
}

template class MomentumPredictor<2>;
template class MomentumPredictor<3>;
} // namespace Continua
