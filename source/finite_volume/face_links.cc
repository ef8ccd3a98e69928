#include <continua/finite_volume/face_links.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
using namespace dealii;

template <int dim>
FaceLinks<dim>::FaceLinks(const CellWiseSystem<dim> &system, const SplitEquations<dim> &equations)
    : system(system), equations(equations)
{
}

template <int dim>
void FaceLinks<dim>::reinit(const bool by_value)
{
  const CellWiseSpace<dim> &space = system.space;
  const CellWiseMesh<dim> &mesh = space.mesh;
  const CellWiseCoefficients &coefficients = system.coefficients();
  std::vector<double> moduli;
  for (unsigned int region = 0; region < system.problem.materials.size(); ++region)
    moduli.push_back(
        coefficients.stiffness[region] *
        traction_coefficients(system.problem.materials[region], system.parameters).stencil_ratio);

  all.clear();
  scales.clear();
  for (unsigned int f = 0; f < mesh.faces().size(); ++f)
  {
    const VolumeFace<dim> &surface = mesh.faces()[f];
    if (!surface.has_value())
      continue;
    Link link;
    link.face = f;
    link.velocity = equations.velocity_index(space.velocities.of_face(f, 0));
    link.is_owned = space.velocities.owns_face(f, 0);
    link.n_sides = surface.n_sides();
    const double weight = surface.area > 0. ? surface.area : surface.plane_area;
    link.weight_ratio = surface.area / weight;
    for (unsigned int side = 0; side < link.n_sides; ++side)
    {
      const FiniteVolume<dim> &cell = mesh.cells()[surface.cell(side)];
      link.cells[side] = equations.velocity_index(space.velocities.of_cell(surface.cell(side)));
      link.cell_is_owned[side] = cell.is_owned;
      link.stiffness[side] = moduli[cell.material_id] * weight /
                             std::abs((surface.centre - cell.centre) * surface.normal);
    }
    const double sum = link.stiffness[0] + link.stiffness[1];
    // Without any viscosity a face goes with its cell.
    if (sum > 0.)
      link.share = {{link.stiffness[0] / sum, link.stiffness[1] / sum}};
    link.compliance = sum > 0. ? 1. / sum : 0.;
    link.free = unit_symmetric_tensor<dim>();
    double scale = 0.;
    if (surface.at_boundary())
    {
      const auto &condition = system.conditions.of_face(f);
      link.free -= condition.prescribed;
      if (condition.prescribed.norm_square() > 0.)
        scale = system.scale(condition);
    }
    // A component that is neither free nor prescribed, on an oblique face with a condition of each
    // kind, keeps its last value.
    for (unsigned int c = 0; c < dim; ++c)
      link.follows[c] = link.free[c][c] > 1. - 1e-12 && !(by_value && surface.at_boundary());
    if (surface.at_boundary())
      set_hold(link);
    all.push_back(link);
    scales.push_back(scale);
  }
}

template <int dim>
void FaceLinks<dim>::set_hold(Link &link) const
{
  const CellWiseSpace<dim> &space = system.space;
  const VolumeFace<dim> &surface = space.mesh.faces()[link.face];
  link.hold.fill(link.weight_ratio * link.stiffness[0]);
  if (!equations.has_pressure() || !system.conditions.of_face(link.face).normal_is_prescribed)
    return;
  const unsigned int region = space.mesh.cells()[surface.owner].material_id;
  const unsigned int pressure = space.local_pressure(space.pressures.of_face(link.face, 0));
  const double compressibility = system.coefficients().compressibility[region];
  if (system.operators[region].pressure_volume.begin()[pressure] == 0. || compressibility == 0.)
    return;
  const double normal_stiffness =
      (4. / 3. * system.coefficients().stiffness[region] + 1. / compressibility) * surface.area /
      (surface.distance * surface.normal);
  for (unsigned int c = 0; c < dim; ++c)
    if (std::abs(surface.normal[c]) > 1e-12)
      link.hold[c] = std::max(link.hold[c], normal_stiffness);
}

template <int dim>
void FaceLinks<dim>::add_to_cells(Vector &residual) const
{
  double *const r = residual.begin();
  for (const Link &link : all)
    for (unsigned int side = 0; side < link.n_sides; ++side)
      if (link.cell_is_owned[side])
        for (unsigned int c = 0; c < dim; ++c)
          if (link.follows[c])
            r[link.cells[side] + c] += link.weight_ratio * link.share[side] * r[link.velocity + c];
}

template <int dim>
void FaceLinks<dim>::follow(const Vector &change, const Vector *residual, Vector &unknowns) const
{
  const double *const d = change.begin();
  double *const x = unknowns.begin();
  for (const Link &link : all)
  {
    if (!link.is_owned)
      continue;
    Tensor<1, dim> move;
    for (unsigned int side = 0; side < link.n_sides; ++side)
      for (unsigned int c = 0; c < dim; ++c)
        move[c] += link.share[side] * d[link.cells[side] + c];
    if (residual != nullptr)
      for (unsigned int c = 0; c < dim; ++c)
        move[c] += link.compliance * residual->begin()[link.velocity + c];
    move = link.free * move;
    for (unsigned int c = 0; c < dim; ++c)
      x[link.velocity + c] += move[c];
  }
}

template <int dim>
void FaceLinks<dim>::set_prescribed(const Vector &residual, Vector &unknowns) const
{
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const Link &link = all[i];
    if (!link.is_owned || scales[i] == 0.)
      continue;
    Tensor<1, dim> lack;
    for (unsigned int c = 0; c < dim; ++c)
      lack[c] = residual.begin()[link.velocity + c] / scales[i];
    lack -= link.free * lack;
    for (unsigned int c = 0; c < dim; ++c)
      unknowns.begin()[link.velocity + c] += lack[c];
  }
}

template class FaceLinks<2>;
template class FaceLinks<3>;
} // namespace Continua
