#ifndef continua_finite_volume_cell_wise_evaluation_h
#define continua_finite_volume_cell_wise_evaluation_h

#include <continua/continuum/field_probes.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/state.h>
#include <continua/finite_volume/linear_reconstruction.h>

#include <deal.II/fe/mapping_q.h>

#include <array>
#include <string>
#include <vector>

namespace Continua
{
/**
 * The probes of the cell-wise discretisation, and other values of its fields, by linear
 * reconstruction. At a point that faces with values of their own hold (on the boundary, between two
 * materials) the mean over those is taken, elsewhere that over the cells that hold it; means and
 * integrals over a boundary are those of the faces' values, over a section of the cells'. Stresses
 * are those of a cell's gradient, or of a face's.
 */
template <int dim>
class CellWiseEvaluation : public FieldProbes<dim>
{
public:
  CellWiseEvaluation(const CellWiseSpace<dim> &space, const Problem &problem);

  /// On the present mesh; sets the probes up again.
  void build();
  /// The mesh has moved.
  void take_shapes() { linear.build(); }
  /// The mixture eta U + sum_k mu_k D_k of a material, and the state's vectors, with ghosts.
  DistributedVector ghosted_mixture(const State &state, unsigned int region) const;
  const LinearReconstruction<dim> &reconstruction() const { return linear; }
  /// Stress of a cell or on a face from its material's mixture and its pressure, both with ghosts,
  /// at a point [Pa].
  std::array<double, 6> stress_at(const CellPlace &place,
                                  const dealii::Point<dim> &point,
                                  const DistributedVector &mixture,
                                  const DistributedVector &pressure) const;
  /// L2 norm of the difference to functions; see ContinuumSolver::error_norm.
  double error_norm(const State &state,
                    ComparedField field,
                    const std::vector<Expression> &exact,
                    double time) const;

private:
  using Collector = ProbeWeights::Collector;
  using CellIterator = typename dealii::Triangulation<dim>::cell_iterator;
  using FieldProbes<dim>::problem;

  Collector collector() const override;
  bool follows_mesh(const ProbeRequest<dim> &request,
                    const FieldDefinition<dim> &field) const override;
  double add_point(const ProbeRequest<dim> &request,
                   const FieldDefinition<dim> &field,
                   Collector &collector) const override;
  double add_boundary(const ProbeRequest<dim> &request,
                      const FieldDefinition<dim> &field,
                      Collector &collector) const override;
  double add_section(const ProbeRequest<dim> &request,
                     const FieldDefinition<dim> &field,
                     Collector &collector) const override;
  double add_volume(const ProbeRequest<dim> &request,
                    const FieldDefinition<dim> &field,
                    Collector &collector) const override;
  double add_interface(const ProbeRequest<dim> &request, Collector &collector) const override;
  double add_force(const ProbeRequest<dim> &request, Collector &collector) const override;
  double add_flow(const ProbeRequest<dim> &request, Collector &collector) const override;
  /// The faces with their own value, of a cell, that hold a point given in its unit cell.
  std::vector<CellPlace> faces_at(unsigned int cell,
                                  const dealii::Point<dim> &unit_point,
                                  const dealii::Point<dim> &point) const;
  /// Adds the field at a point, times a weight; `undeformed` is another on a mesh that moves.
  void add_value(const FieldDefinition<dim> &field,
                 const CellPlace &place,
                 const dealii::Point<dim> &point,
                 const dealii::Point<dim> &undeformed,
                 double weight,
                 Collector &collector) const;
  /// 2 pi r in axisymmetry, else 1.
  double circumference(const dealii::Point<dim> &point) const;

  const CellWiseSpace<dim> &space;
  LinearReconstruction<dim> linear;
  /// Where points are looked for: cells are curved there as the geometry is.
  const dealii::MappingQ<dim> mapping;
};
} // namespace Continua

#endif
