#ifndef continua_finite_element_looking_wall_shear_stress_h
#define continua_finite_element_looking_wall_shear_stress_h

#include <continua/continuum/wall_shear.h>
#include <continua/finite_element/looking/field_samples.h>

#include <array>
#include <map>
#include <vector>

namespace Continua
{
/**
 * The wall shear stress at the nodes of the walls: minus the tangential part of n.sigma in the
 * liquid, with the normal n out of it, which is what the liquid exerts on the wall. Walls are the
 * boundaries of liquids whose velocity is prescribed in full and is zero along the normal, and the
 * interfaces of liquids with solids. At a node that several faces share it is their mean.
 */
template <int dim>
class WallShearStress : public WallShear
{
public:
  /// All must outlive it.
  WallShearStress(const Space<dim> &space, const Problem &problem)
      : space(space), problem(problem), samples(space, problem), state(space, problem)
  {
  }

  /// Finds the walls on the present mesh if they are asked for, in the output or over time.
  void reinit();
  void set(const State &present, DistributedVector &shear) override;
  void set_magnitudes(const DistributedVector &vectors,
                      DistributedVector &magnitudes) const override;
  void keep_walls_alone(DistributedVector &vector) const override;

private:
  /// Of this rank.
  struct WallNode
  {
    std::array<unsigned int, dim> indices; ///< local, of the components
    std::vector<unsigned int> samples;     ///< one for each face that has it
  };

  const Space<dim> &space;
  const Problem &problem;
  FieldSamples<dim> samples;
  SampledState<dim> state;
  std::vector<WallNode> nodes;
  mutable std::vector<double> kept; ///< work space

  /// By the global index of the first component; while the nodes are listed.
  std::map<dealii::types::global_dof_index, unsigned int> number_of_node;

  using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;
  /// Whether a face of a cell is a liquid's at a wall.
  bool is_wall(const Cell &cell, unsigned int face) const;
  /// Out of the cell at a point of its face.
  static dealii::Tensor<1, dim>
  normal_of(const dealii::FEValues<dim> &values, unsigned int q, unsigned int face);
  /// The global indices of the components at each node of the velocity.
  std::vector<std::array<dealii::types::global_dof_index, dim>> nodes_of(const Cell &cell) const;
  typename dealii::DoFHandler<dim>::active_cell_iterator pressure_cell(const Cell &cell) const;
  /// Adds a point of a cell's face to a node, if that is this rank's.
  void add_sample(const Cell &cell,
                  unsigned int face,
                  const dealii::FEValues<dim> &values,
                  const dealii::FEValuesBase<dim> &pressure_values,
                  unsigned int q,
                  const std::array<dealii::types::global_dof_index, dim> &indices);
  /// Adds the nodes of a face with hanging nodes that are not the cell's own.
  void add_nodes_of_coarser_neighbour(const Cell &cell, unsigned int face);
};
} // namespace Continua

#endif
