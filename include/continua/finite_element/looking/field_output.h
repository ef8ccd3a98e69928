#ifndef continua_finite_element_looking_field_output_h
#define continua_finite_element_looking_field_output_h

#include <continua/finite_element/looking/field_evaluation.h>
#include <continua/finite_element/looking/wall_shear_stress.h>

#include <deal.II/fe/fe_system.h>
#include <deal.II/numerics/data_out.h>

#include <map>
#include <string>
#include <vector>

namespace Continua
{
/// The fields of a picture: velocity and displacement as they are, pressure and stress cell by cell
/// of degree k - 1 (so that they jump where they do), and phase, material id and rank. Vorticity, Q
/// criterion (cell by cell) and what belongs to walls (at their nodes, 0 elsewhere) if they are
/// asked for.
template <int dim>
class FieldOutput
{
public:
  FieldOutput(const Space<dim> &space,
              const Problem &problem,
              const FieldEvaluation<dim> &evaluation,
              WallShearStress<dim> &wall_shear,
              const MetricHistory<dim> *metrics = nullptr);

  /// Adds the fields to `data_out`; they live until the next call. Returns name -> unit.
  std::map<std::string, std::string> add(const State &state, dealii::DataOut<dim> &data_out);

private:
  /// Sets and adds the fields of walls.
  void add_wall_fields(const State &state,
                       dealii::DataOut<dim> &data_out,
                       std::map<std::string, std::string> &units_of_fields);

  /// Sets the 3x3 gradients of a vector at the points of a cell.
  void set_gradients(const dealii::FEValues<dim> &values,
                     const DistributedVector &vector,
                     std::vector<dealii::Tensor<2, 3>> &target) const;
  /// Sets those of the velocity there, by the present place where the region is deformed.
  void set_velocity_gradients(const dealii::FEValues<dim> &values,
                              bool is_deformed,
                              std::vector<dealii::Tensor<2, 3>> &target) const;
  /// Sets the directions of the wall there.
  void set_directions(const dealii::FEValues<dim> &values,
                      std::vector<TubeDirections> &directions) const;
  /// Sets Cauchy's stresses at the points of a cell in finite deformation [Pa].
  void set_finite_stresses(const dealii::FEValues<dim> &values,
                           const std::vector<dealii::Vector<double>> &pressures,
                           unsigned int region,
                           const DistributedVector &metric_mixture,
                           const std::vector<TubeDirections> &directions,
                           std::vector<std::array<double, 6>> &stresses) const;

  /// Sets a field of numbers, with ghosts, to the first component at each node.
  void set_numbers(const DistributedVector &vectors, DistributedVector &numbers);

  const Space<dim> &space;
  const Problem &problem;
  const FieldEvaluation<dim> &evaluation;
  WallShearStress<dim> &wall_shear;
  const MetricHistory<dim> *metrics; ///< null where nothing relaxes in finite deformation
  std::vector<std::string> names;    ///< of the fields cell by cell
  std::vector<std::string> units;
  dealii::FESystem<dim> cell_element;
  dealii::DoFHandler<dim> cell_dofs;
  dealii::DoFHandler<dim> node_dofs; ///< of numbers at the velocity's nodes
  DistributedVector velocity, displacement, unloaded_displacement, wall_potentials, cell_fields;
  DistributedVector shear, average_shear, oscillation; ///< at the nodes of walls
  dealii::Vector<float> phase, material_id, rank;
};
} // namespace Continua

#endif
