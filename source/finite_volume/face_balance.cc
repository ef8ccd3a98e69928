#include <continua/finite_volume/face_balance.h>

#include <deal.II/lac/full_matrix.h>

#include <cmath>

namespace Continua
{
using namespace dealii;

template <int dim>
FaceBalance<dim>::FaceBalance(const CellWiseSystem<dim> &system,
                              const SplitEquations<dim> &equations,
                              const FaceLinks<dim> &links)
    : system(system), equations(equations), links(links)
{
}

template <int dim>
void FaceBalance<dim>::reinit()
{
  residual = equations.vector();
  all_pressures.clear();
  if (equations.has_pressure())
    find_pressures();
  invert_blocks();
}

template <int dim>
void FaceBalance<dim>::find_pressures()
{
  const CellWiseSpace<dim> &space = system.space;
  const CellWiseMesh<dim> &mesh = space.mesh;
  for (unsigned int f = 0; f < mesh.faces().size(); ++f)
  {
    const VolumeFace<dim> &surface = mesh.faces()[f];
    for (unsigned int side = 0; surface.has_value() && side < surface.n_sides(); ++side)
    {
      const FiniteVolume<dim> &cell = mesh.cells()[surface.cell(side)];
      if (!cell.is_owned)
        continue;
      FacePressure face_pressure;
      const unsigned int value = space.pressures.of_face(f, side);
      face_pressure.pressure = equations.pressure_index(value);
      face_pressure.cell = equations.pressure_index(space.pressures.of_cell(surface.cell(side)));
      const double own = equations.entry(face_pressure.pressure, face_pressure.pressure);
      face_pressure.inverse = own != 0. ? 1. / own : 0.;
      face_pressure.normal_is_free =
          surface.at_boundary() && !system.conditions.of_face(f).normal_is_prescribed;
      face_pressure.from_definition =
          system.operators[cell.material_id].pressure_volume.begin()[space.local_pressure(value)] >
          0.;
      all_pressures.push_back(face_pressure);
    }
  }
}

template <int dim>
void FaceBalance<dim>::invert_blocks()
{
  const CellWiseSpace<dim> &space = system.space;
  const CellWiseMesh<dim> &mesh = space.mesh;
  blocks.clear();
  for (const auto &link : links.links())
  {
    if (!link.is_owned)
      continue;
    Block block;
    block.velocity = link.velocity;
    FullMatrix<double> matrix(dim + 1, dim + 1);
    for (unsigned int a = 0; a < dim; ++a)
      for (unsigned int b = 0; b < dim; ++b)
        matrix(a, b) = equations.entry(link.velocity + a, link.velocity + b);
    matrix(dim, dim) = 1.;
    const VolumeFace<dim> &surface = mesh.faces()[link.face];
    if (equations.has_pressure() && link.n_sides == 1 &&
        !system.conditions.of_face(link.face).normal_is_prescribed && surface.area > 0.)
    {
      const unsigned int value = space.pressures.of_face(link.face, 0);
      const unsigned int row = equations.pressure_index(value);
      const unsigned int region = mesh.cells()[surface.owner].material_id;
      for (unsigned int a = 0; a < dim; ++a)
        matrix(a, dim) = equations.entry(link.velocity + a, row);
      if (system.operators[region].pressure_volume.begin()[space.local_pressure(value)] > 0.)
      {
        block.pressure = row;
        for (unsigned int b = 0; b < dim; ++b)
          matrix(dim, b) = equations.entry(row, link.velocity + b);
        matrix(dim, dim) = equations.entry(row, row);
      }
      else
      {
        for (unsigned int b = 0; b < dim; ++b)
          matrix(dim, b) = surface.normal[b] / (surface.distance * surface.normal);
        matrix(dim, dim) = system.coefficients().compressibility[region];
      }
    }
    matrix.gauss_jordan();
    for (unsigned int a = 0; a <= dim; ++a)
      for (unsigned int b = 0; b <= dim; ++b)
        block.inverse[a * (dim + 1) + b] = matrix(a, b);
    blocks.push_back(block);
  }
}

template <int dim>
void FaceBalance<dim>::solve(const Vector &right_side, Vector &unknowns)
{
  constexpr unsigned int none = numbers::invalid_unsigned_int;
  equations.residual(equations.face_momentum(), right_side, unknowns, residual);
  if (equations.has_pressure())
    equations.residual(equations.face_pressure(), right_side, unknowns, residual);
  const double *const r = residual.begin();
  double *const x = unknowns.begin();
  for (const Block &block : blocks)
  {
    std::array<double, dim + 1> lack = {};
    for (unsigned int c = 0; c < dim; ++c)
      lack[c] = r[block.velocity + c];
    if (block.pressure != none)
      lack[dim] = r[block.pressure];
    for (unsigned int a = 0; a <= dim; ++a)
    {
      double change = 0.;
      for (unsigned int b = 0; b <= dim; ++b)
        change += block.inverse[a * (dim + 1) + b] * lack[b];
      if (a < dim)
        x[block.velocity + a] += change;
      else if (block.pressure != none)
        x[block.pressure] += change;
    }
  }
  // What the others obey has no velocity of a face in it that is still to be found.
  for (const FacePressure &face_pressure : all_pressures)
    if (!(face_pressure.from_definition && face_pressure.normal_is_free))
      x[face_pressure.pressure] += face_pressure.inverse * r[face_pressure.pressure];
}

template <int dim>
void FaceBalance<dim>::solve_pressures(const Vector &right_side, Vector &unknowns)
{
  equations.residual(equations.face_pressure(), right_side, unknowns, residual);
  for (const FacePressure &face_pressure : all_pressures)
    unknowns.begin()[face_pressure.pressure] +=
        face_pressure.inverse * residual.begin()[face_pressure.pressure];
}

template class FaceBalance<2>;
template class FaceBalance<3>;
} // namespace Continua
