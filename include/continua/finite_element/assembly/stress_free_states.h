#ifndef continua_finite_element_assembly_stress_free_states_h
#define continua_finite_element_assembly_stress_free_states_h

#include <continua/continuum/problem.h>
#include <continua/continuum/state_visitor.h>
#include <continua/continuum/stress_free_state.h>
#include <continua/finite_element/assembly/wall_potentials.h>
#include <continua/finite_element/space/quadrature_cells.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/distributed_vector.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace Continua
{
/// What the solids are like when they are free of stress, at all quadrature points: where a
/// material has fibres or a prestretch, or the unloaded shape X + D0 is another than the mesh.
template <int dim>
class StressFreeStates
{
public:
  using Cell = QuadratureCell<dim>;

  /// All must outlive it.
  StressFreeStates(const Space<dim> &space,
                   const Problem &problem,
                   const dealii::Quadrature<dim> &quadrature,
                   const QuadratureCells<dim> &cells);

  /// The mesh has changed; the cells know it already.
  void reinit();
  /// Whether the stress-free volume is another than that of the mesh.
  bool have_other_volume() const { return has_other_volume; }
  /// Null: it is that of the mesh.
  const StressFreeState *at(const Cell &cell, const unsigned int q) const
  {
    return states.empty() ? nullptr : &states[&cell - cells.all().data()][q];
  }
  /// How much of the prestretch there is, 0 to 1.
  void set_share(double share);

  /// D0, a part of the state where it is looked for, else null [m].
  const DistributedVector *unloaded_displacement() const
  {
    return problem.finds_unloaded_shape() ? &unloaded : nullptr;
  }
  void set_unloaded_displacement(const DistributedVector &of_unloaded);
  /// Makes D0 = -D in a step that looks for it. Collective.
  void unload_by(const DistributedVector &displacement);
  /// Sets the entries of D0 of a cell; only where it is looked for.
  void set_unloaded(const Cell &cell, dealii::Vector<double> &entries) const
  {
    set_entries(cell.velocity_places, ghosted_unloaded, entries);
  }
  void visit_state(StateVisitor &visitor);
  /// The state was read or carried over. Collective.
  void take_state();
  const DistributedVector *wall_potentials() const
  {
    return potentials.exist() ? &potentials.potentials() : nullptr;
  }

private:
  const Space<dim> &space;
  const Problem &problem;
  const dealii::Quadrature<dim> quadrature;
  const QuadratureCells<dim> &cells;
  WallPotentials<dim> potentials;
  DistributedVector unloaded, ghosted_unloaded, velocity_work;
  const bool has_other_volume;
  double share = 1.;                                ///< of the prestretch
  std::vector<std::vector<StressFreeState>> states; ///< [cell][point]

  void set_states();
};
} // namespace Continua

#endif
