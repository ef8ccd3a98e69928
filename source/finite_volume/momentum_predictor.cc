#include <continua/finite_volume/momentum_predictor.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
using namespace dealii;

template <int dim>
MomentumPredictor<dim>::MomentumPredictor(const CellSystem<dim> &system,
                                          const SplitEquations<dim> &equations,
                                          const FaceLinks<dim> &links)
    : system(system), equations(equations), links(links)
{
}

template <int dim>
void MomentumPredictor<dim>::find_couplings()
{
  const CellSpace<dim> &space = system.space;
  const CellMesh<dim> &mesh = space.mesh;
  couplings.clear();
  const auto add = [&](const unsigned int f, const double stiffness)
  {
    const VolumeFace<dim> &surface = mesh.faces()[f];
    Coupling coupling;
    for (unsigned int side = 0; side < 2; ++side)
    {
      coupling.cells[side] = equations.velocity_index(space.velocities.of_cell(surface.cell(side)));
      coupling.numbers[side] = mesh.cells()[surface.cell(side)].number;
    }
    coupling.stiffness = stiffness;
    couplings.push_back(coupling);
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
  const CellSpace<dim> &space = system.space;
  const CellMesh<dim> &mesh = space.mesh;
  const CellCoefficients &coefficients = system.coefficients();
  sums.assign(dim * mesh.n_owned_cells(), 0.);
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
std::size_t MomentumPredictor<dim>::n_matrix_entries() const
{
  return system.space.mesh.n_owned_cells() + couplings.size();
}

template <int dim>
void MomentumPredictor<dim>::factorize(const unsigned int component, SymmetricFactor &factor) const
{
  const CellMesh<dim> &mesh = system.space.mesh;
  SymmetricTriplets matrix;
  matrix.n = static_cast<int>(mesh.cell_dofs.n_dofs());
  const auto add = [&](const unsigned int row, const unsigned int column, const double value)
  {
    matrix.rows.push_back(static_cast<int>(std::max(row, column)));
    matrix.columns.push_back(static_cast<int>(std::min(row, column)));
    matrix.values.push_back(value);
  };
  std::vector<int> owned;
  const unsigned int n_owned = mesh.n_owned_cells();
  for (unsigned int cell = 0; cell < n_owned; ++cell)
  {
    const unsigned int number = mesh.cells()[cell].number;
    owned.push_back(static_cast<int>(number));
    add(number, number, sums[dim * cell + component]);
  }
  for (const Coupling &coupling : couplings)
    for (unsigned int side = 0; side < 2; ++side)
      if (coupling.cells[side] < dim * n_owned)
      {
        add(coupling.numbers[side], coupling.numbers[side], coupling.stiffness);
        // Between two ranks the first cell's puts it in.
        if (side == 0)
          add(coupling.numbers[0], coupling.numbers[1], -coupling.stiffness);
      }
  factor.factorize(matrix, owned);
}

template <int dim>
void MomentumPredictor<dim>::reinit()
{
  find_couplings();
  set_row_sums();
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
    factors.push_back(make_symmetric_factor(DirectSolver::automatic, true, n_matrix_entries(),
                                            system.space.communicator));
    factorize(c, *factors.back());
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
void MomentumPredictor<dim>::multiply(const Vector &x, Vector &product) const
{
  const double *const u = x.begin();
  double *const y = product.begin();
  const std::size_t n_owned = sums.size();
  for (std::size_t i = 0; i < n_owned; ++i)
    y[i] = sums[i] * u[i];
  for (const Coupling &coupling : couplings)
    for (unsigned int side = 0; side < 2; ++side)
      if (coupling.cells[side] < n_owned)
        for (unsigned int c = 0; c < dim; ++c)
          y[coupling.cells[side] + c] +=
              coupling.stiffness * (u[coupling.cells[side] + c] - u[coupling.cells[1 - side] + c]);
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
