#include <continua/finite_element/solvers/iterative/grad_div_preconditioner.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
using namespace dealii;

template <int dim>
GradDivPreconditioner<dim>::GradDivPreconditioner(const Space<dim> &space) : space(space)
{
}

template <int dim>
bool GradDivPreconditioner<dim>::take(const std::vector<double> &viscosities,
                                      const StepPreconditioner<dim> &preconditioner)
{
  const std::vector<double> &viscosity_of_regions = preconditioner.coefficients.stiffness;
  double sums[] = {0., 0.}; // of the present viscosity with alpha, and of the change of gamma
  for (const auto &cell : space.pressure_dofs.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      const unsigned int i = cell->active_cell_index();
      const double present = grad_div.empty() ? 0. : grad_div[i];
      if (viscosities[i] == 0. && present == 0.)
        continue; // a solid
      sums[0] += cell->measure() * (present + viscosity_of_regions[cell->material_id()]);
      sums[1] += cell->measure() * std::abs(viscosities[i] - present);
    }
  Utilities::MPI::sum(sums, space.communicator, sums);
  if (!(sums[1] > smallest_change * sums[0]))
    return false;
  grad_div = viscosities;
  return true;
}

template <int dim>
void GradDivPreconditioner<dim>::add_to(StepPreconditioner<dim> &preconditioner) const
{
  if (grad_div.empty() || preconditioner.relaxation == nullptr)
    return;
  std::vector<double> augmentation = grad_div;
  for (double &gamma : augmentation)
    gamma *= share_of_grad_div;
  preconditioner.relaxation->set_volumetric_of_cells(augmentation);
  // The sum of the cells' parts of the mass form around each pressure, with 1/alpha and with
  // 1/(alpha + gamma).
  const SystemCoefficients &of_form = preconditioner.coefficients;
  DistributedVector before = space.pressure_vector(), roots = before;
  std::vector<types::global_dof_index> indices;
  for (const auto &cell : space.pressure_dofs.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      const double alpha = std::max(of_form.stiffness[cell->material_id()], 1e-100),
                   compressibility = of_form.compressibility[cell->material_id()],
                   gamma = augmentation[cell->active_cell_index()], volume = cell->measure();
      indices.resize(cell->get_fe().n_dofs_per_cell());
      cell->get_dof_indices(indices);
      before.add(indices,
                 std::vector<double>(indices.size(), volume * (1. / alpha + compressibility)));
      roots.add(indices, std::vector<double>(indices.size(),
                                             volume * (1. / (alpha + gamma) + compressibility)));
    }
  before.compress(VectorOperation::add);
  roots.compress(VectorOperation::add);
  for (unsigned int i = 0; i < roots.locally_owned_size(); ++i)
    roots.begin()[i] = std::sqrt(before.begin()[i] / roots.begin()[i]);
  preconditioner.schur_complement->scale_mass_inverse(roots);
}

template class GradDivPreconditioner<2>;
template class GradDivPreconditioner<3>;
} // namespace Continua
