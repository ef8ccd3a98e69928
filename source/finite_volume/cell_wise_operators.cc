#include <continua/finite_volume/cell_wise_operators.h>

#include <continua/finite_volume/sparse_rows.h>

#include <stdexcept>

namespace Continua
{
using namespace dealii;

TractionCoefficients traction_coefficients(const Material &material,
                                           const CellWiseParameters &parameters)
{
  TractionCoefficients result;
  // A fluid's stress has one modulus; what its stencil could be made of is its viscosity.
  if (material.shear.branches.empty())
    return result;
  const double shear_modulus = material.instantaneous_shear_modulus();
  const bool pressure_is_apart = parameters.has_pressure();
  StencilCoefficient choice = parameters.stencil_coefficient;
  if (choice == StencilCoefficient::automatic)
    choice = parameters.formulation == Formulation::velocity_pressure
                 ? StencilCoefficient::deviatoric
                 : StencilCoefficient::longitudinal;
  if (material.is_incompressible() &&
      (!pressure_is_apart || choice == StencilCoefficient::longitudinal))
    throw std::invalid_argument("an incompressible solid has no finite longitudinal modulus");
  const double bulk_ratio = 1. / (material.inverse_bulk_modulus() * shear_modulus);
  if (choice == StencilCoefficient::longitudinal)
    result.stencil_ratio = bulk_ratio + 4. / 3.;
  else if (choice == StencilCoefficient::deviatoric)
    result.stencil_ratio = 4. / 3.;
  if (!pressure_is_apart)
    result.trace_ratio = bulk_ratio - 2. / 3.;
  return result;
}

namespace
{
/// Puts the operators together, face by face and cell by cell.
template <int dim>
class Assembler
{
public:
  Assembler(const CellWiseSpace<dim> &space,
            const Problem &problem,
            const FaceConditions<dim> &conditions,
            const CellWiseParameters &parameters)
      : space(space),
        mesh(space.mesh),
        problem(problem),
        conditions(conditions),
        parameters(parameters),
        velocity_rows(space.velocities.owned(dim)),
        pressure_rows(space.pressures.owned(1))
  {
  }

  void assemble(const std::vector<bool> &regions,
                std::vector<CellWiseOperators> &operators,
                PressureClosure &closure)
  {
    operators.resize(problem.materials.size());
    closure.parts.resize(operators.size());
    closure.rows.clear();
    SparseRows rows(pressure_rows, pressure_rows, space.communicator);
    for (unsigned int region = 0; region < operators.size(); ++region)
    {
      PressureClosure::Part &part = closure.parts[region];
      if (regions[region])
      {
        part = {};
        assemble_region(region, operators[region], part);
      }
      closure.rows.insert(closure.rows.end(), part.rows.begin(), part.rows.end());
      for (const auto &entry : part.entries)
        rows.add(entry.row, entry.column, entry.value);
    }
    rows.move_to(closure.matrix);
  }

private:
  const CellWiseSpace<dim> &space;
  const CellWiseMesh<dim> &mesh;
  const Problem &problem;
  const FaceConditions<dim> &conditions;
  const CellWiseParameters &parameters;
  const IndexSet velocity_rows, pressure_rows;

  /// Adds factor times a tensor for each value to the rows of a value's equations.
  void add(SparseRows &rows,
           const unsigned int value,
           const double factor,
           const Stencil<Tensor<2, dim>> &stencil) const
  {
    for (const auto &[column, tensor] : stencil)
      for (unsigned int a = 0; a < dim; ++a)
        for (unsigned int b = 0; b < dim; ++b)
          if (tensor[a][b] != 0.)
            rows.add(dim * value + a, dim * column + b, factor * tensor[a][b]);
  }

  /// Adds factor times a vector times each pressure to the rows of a value's equations.
  void add(SparseRows &rows,
           const unsigned int value,
           const Tensor<1, dim> &vector,
           const Stencil<double> &stencil) const
  {
    for (const auto &[column, coefficient] : stencil)
      for (unsigned int a = 0; a < dim; ++a)
        if (vector[a] != 0.)
          rows.add(dim * value + a, column, vector[a] * coefficient);
  }

  /// Adds the product of a vector with each velocity to one row.
  void add_product(SparseRows &rows,
                   const unsigned int row,
                   const double factor,
                   const Stencil<Tensor<1, dim>> &stencil) const
  {
    for (const auto &[column, vector] : stencil)
      for (unsigned int a = 0; a < dim; ++a)
        if (vector[a] != 0.)
          rows.add(row, dim * column + a, factor * vector[a]);
  }

  /// What the equation of a face counts with: on the axis, which has no area, as in the plane.
  double weight(const FaceShape<dim> &surface) const
  {
    return surface.area > 0. ? surface.area : surface.plane_area;
  }

  void assemble_region(const unsigned int region,
                       CellWiseOperators &target,
                       PressureClosure::Part &closure)
  {
    const TractionCoefficients coefficients =
        traction_coefficients(problem.materials[region], parameters);
    const FaceTraction<dim> traction(space, coefficients.stencil_ratio, coefficients.trace_ratio,
                                     parameters.boundary_gradient == BoundaryGradient::replaced);
    SparseRows stiffness(velocity_rows, velocity_rows, space.communicator);
    SparseRows wide_stiffness(velocity_rows, velocity_rows, space.communicator);
    SparseRows gradient(velocity_rows, pressure_rows, space.communicator);
    SparseRows divergence(pressure_rows, velocity_rows, space.communicator);
    target.volume = space.velocity_vector();
    target.pressure_volume = space.pressure_vector();
    const bool with_wide = parameters.accumulated_term == AccumulatedTerm::inconsistent ||
                           parameters.power_operator == PowerOperator::wide;

    for (unsigned int cell = 0; cell < mesh.n_owned_cells(); ++cell)
    {
      const FiniteVolume<dim> &volume = mesh.cells()[cell];
      if (volume.material_id != region)
        continue;
      const unsigned int value = space.velocities.of_cell(cell);
      const unsigned int pressure = space.pressures.of_cell(cell);
      for (unsigned int c = 0; c < dim; ++c)
        target.volume.begin()[space.local_velocity(value) + c] = volume.volume;
      target.pressure_volume.begin()[space.local_pressure(pressure)] = volume.volume;
      if (space.is_axisymmetric())
      {
        // Stress round the axis pulls inwards.
        const double around = volume.volume / volume.radius;
        for (const auto &[column, vector] : traction.hoop(cell))
          for (unsigned int a = 0; a < dim; ++a)
            for (SparseRows *rows : {&stiffness, &wide_stiffness})
              rows->add(dim * value + 1, dim * column + a, around * vector[a]);
        gradient.add(dim * value + 1, pressure, -around);
      }
    }

    for (unsigned int face = 0; face < mesh.faces().size(); ++face)
    {
      const VolumeFace<dim> &surface = mesh.faces()[face];
      for (unsigned int side = 0; side < surface.n_sides(); ++side)
      {
        const unsigned int cell = surface.cell(side);
        const FiniteVolume<dim> &volume = mesh.cells()[cell];
        const bool owns_face = surface.has_value() && space.velocities.owns_face(face, side);
        if (volume.material_id != region || !(volume.is_owned || owns_face))
          continue;
        const Tensor<1, dim> normal = surface.outward(side);
        const FaceShape<dim> &shape = surface.shape(side);
        const Stencil<Tensor<2, dim>> stress = traction(face, side);
        const Stencil<double> pressure = space.pressure_gradient.face_value(face, side);
        Stencil<Tensor<2, dim>> wide_stress;
        if (with_wide)
          wide_stress = traction.wide(face, side);
        if (volume.is_owned)
        {
          const unsigned int value = space.velocities.of_cell(cell);
          add(stiffness, value, -shape.area, stress);
          add(wide_stiffness, value, -shape.area, wide_stress);
          add(gradient, value, shape.area * normal, pressure);
          Stencil<Tensor<1, dim>> flux;
          flux.add(Tensor<1, dim>(shape.area * normal),
                   space.velocity_gradient.face_value(face, side));
          add_product(divergence, space.pressures.of_cell(cell), 1., flux);
        }
        if (owns_face)
        {
          const unsigned int value = space.velocities.of_face(face, side);
          add(stiffness, value, weight(shape), stress);
          add(wide_stiffness, value, weight(shape), wide_stress);
          add(gradient, value, -weight(shape) * normal, pressure);
        }
        if (surface.has_value() && volume.is_owned)
          close_pressure(face, side, divergence, target, closure);
      }
    }
    stiffness.move_to(target.stiffness);
    if (with_wide)
      wide_stiffness.move_to(target.wide_stiffness);
    gradient.move_to(target.gradient);
    divergence.move_to(target.divergence);
  }

  /// How the pressure that a face has on one side is found.
  BoundaryPressure pressure_type(const unsigned int face, const unsigned int side) const
  {
    const VolumeFace<dim> &surface = mesh.faces()[face];
    // Where the pressure is computed from the displacement it is so everywhere.
    if (!parameters.has_pressure())
      return BoundaryPressure::definition;
    const BoundaryPressure type = parameters.boundary_pressure;
    // On the axis the pressure has no slope.
    if (surface.area == 0. || type == BoundaryPressure::zero_gradient)
      return BoundaryPressure::zero_gradient;
    if (parameters.formulation == Formulation::velocity_explicit_pressure)
      return BoundaryPressure::momentum;
    const bool traction_is_given =
        surface.at_boundary() && !conditions.of_face(face).normal_is_prescribed;
    // Where a fluid's velocity is given a change of its volume beside the wall says little of the
    // pressure; a solid's is as good there as where the traction is given.
    const bool of_solid =
        surface.at_boundary() &&
        !problem.materials[mesh.cells()[surface.cell(side)].material_id].shear.branches.empty();
    if (traction_is_given || (of_solid && type == BoundaryPressure::definition))
      return type;
    return BoundaryPressure::momentum;
  }

  /// Whether the cell has another face of the kind on its opposite side: then no slope can be
  /// extrapolated between the two.
  bool is_between_extrapolated(const unsigned int face, const unsigned int side) const
  {
    const Tensor<1, dim> normal = mesh.faces()[face].outward(side);
    const unsigned int cell = mesh.faces()[face].cell(side);
    for (const unsigned int other : mesh.cells()[cell].faces)
    {
      const VolumeFace<dim> &surface = mesh.faces()[other];
      const unsigned int other_side = mesh.side(other, cell);
      if (other != face && surface.has_value() && surface.outward(other_side) * normal < -0.5 &&
          pressure_type(other, other_side) == BoundaryPressure::momentum)
        return true;
    }
    return false;
  }

  /// The equation of the pressure that a face has on one side.
  void close_pressure(const unsigned int face,
                      const unsigned int side,
                      SparseRows &divergence,
                      CellWiseOperators &target,
                      PressureClosure::Part &closure)
  {
    const VolumeFace<dim> &surface = mesh.faces()[face];
    const unsigned int cell = surface.cell(side);
    const Tensor<1, dim> normal = surface.outward(side);
    const unsigned int row = space.pressures.of_face(face, side);
    BoundaryPressure type = pressure_type(face, side);
    if (type == BoundaryPressure::momentum && is_between_extrapolated(face, side))
      type = BoundaryPressure::zero_gradient;

    if (type == BoundaryPressure::definition)
    {
      const double volume = surface.shape(side).plane_area * (mesh.distance(face, side) * normal);
      target.pressure_volume.begin()[space.local_pressure(row)] = volume;
      add_product(divergence, row, volume,
                  space.velocity_face_gradient(
                      face, side, parameters.boundary_gradient == BoundaryGradient::replaced));
      for (const auto &[value, factor] : space.face_hoop(face, side))
        divergence.add(row, dim * value + 1, volume * factor);
      return;
    }
    closure.rows.push_back(space.local_pressure(row));
    closure.entries.push_back({row, row, 1.});
    closure.entries.push_back({row, space.pressures.of_cell(cell), -1.});
    if (type == BoundaryPressure::momentum)
    {
      const Tensor<1, dim> offset = mesh.distance(face, side);
      for (const auto &[value, g] : space.pressure_gradient(cell))
        closure.entries.push_back({row, value, -(offset * g)});
    }
  }
};
} // namespace

template <int dim>
void assemble_cell_operators(const CellWiseSpace<dim> &space,
                             const Problem &problem,
                             const FaceConditions<dim> &conditions,
                             const CellWiseParameters &parameters,
                             const std::vector<bool> &regions,
                             std::vector<CellWiseOperators> &operators,
                             PressureClosure &closure)
{
  Assembler<dim>(space, problem, conditions, parameters).assemble(regions, operators, closure);
}

template void assemble_cell_operators(const CellWiseSpace<2> &,
                                      const Problem &,
                                      const FaceConditions<2> &,
                                      const CellWiseParameters &,
                                      const std::vector<bool> &,
                                      std::vector<CellWiseOperators> &,
                                      PressureClosure &);
template void assemble_cell_operators(const CellWiseSpace<3> &,
                                      const Problem &,
                                      const FaceConditions<3> &,
                                      const CellWiseParameters &,
                                      const std::vector<bool> &,
                                      std::vector<CellWiseOperators> &,
                                      PressureClosure &);
} // namespace Continua
