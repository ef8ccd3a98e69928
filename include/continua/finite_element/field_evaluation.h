#ifndef continua_finite_element_field_evaluation_h
#define continua_finite_element_field_evaluation_h

#include <continua/continuum/continuum_solver.h>
#include <continua/continuum/problem.h>
#include <continua/finite_element/branch_history.h>
#include <continua/finite_element/field_list.h>
#include <continua/finite_element/space.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/fe/fe_values.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/// The vectors that a field is computed from, at the present time; owned entries, hanging nodes not
/// set.
template <int dim>
struct State
{
  const DistributedVector &velocity;
  const DistributedVector &pressure;
  const BranchHistory &history;
};

/**
 * Stress of a material from the gradient of its nodal mixture w = eta U + sum_k mu_k D_k, since s =
 * 2 dev sym grad w: xx, yy, zz, xy, and in three dimensions xz, yz. zz is the hoop stress in
 * axisymmetry, the stress across the plane in plane strain, 0 in plane stress. [Pa]
 */
template <int dim>
std::array<double, 6> stress(const dealii::Tensor<2, dim> &mixture_gradient,
                             double mixture_hoop,
                             double pressure,
                             Model model);

/// Strain of the displacement from its gradient, in the same order, xy the half of the shear angle.
/// zz is the hoop strain in axisymmetry, 0 in plane strain, and in plane stress what keeps sigma_zz
/// zero. [1]
template <int dim>
std::array<double, 6> strain(const dealii::Tensor<2, dim> &displacement_gradient,
                             double hoop,
                             Model model,
                             const Material &material);

/// n.sigma from the stress [Pa].
template <int dim>
dealii::Tensor<1, dim> traction(const std::array<double, 6> &stress,
                                const dealii::Tensor<1, dim> &normal);

/**
 * Fields of the discrete solution as numbers: probes are linear in the state, so each is set up
 * once on a mesh as sparse weights on the owned dofs (hanging nodes resolved), and reading it is a
 * short sum.
 */
template <int dim>
class FieldEvaluation
{
public:
  FieldEvaluation(const Space<dim> &space, const Problem &problem);

  /// What there is to probe, with units.
  static std::vector<FieldComponent> fields(Model model);
  /// See ContinuumSolver::add_probe.
  unsigned int add(const ProbeRequest<dim> &request);
  /// Sets the probes up again on a new mesh.
  void rebuild();
  void evaluate(const State<dim> &state, std::vector<double> &values) const;

  /// The mixture eta U + sum_k mu_k D_k of a material with ghosts, for evaluation on cells [Pa m].
  DistributedVector ghosted_mixture(const State<dim> &state, unsigned int region) const;
  /// L2 norm of the difference to functions; see ContinuumSolver::error_norm.
  double error_norm(const State<dim> &state,
                    const std::string &field,
                    const std::vector<Expression> &exact,
                    double time) const;

private:
  enum class Source
  {
    velocity,
    displacement,
    mixture, ///< of one region
    pressure
  };
  /// Weights on the owned entries of one vector.
  struct Weights
  {
    Source source;
    unsigned int region;               ///< of a mixture
    std::vector<unsigned int> indices; ///< local
    std::vector<double> values;
  };
  struct Probe
  {
    ProbeRequest<dim> request;
    FieldDefinition<dim> field;
    std::vector<Weights> weights;
  };
  class Collector;
  using CellIterator = typename dealii::Triangulation<dim>::cell_iterator;

  void build(Probe &probe) const;
  bool counts(const ProbeRequest<dim> &request, const CellIterator &cell) const;
  /// Each adds the values of the field at points times their weights to the sums; returns what the
  /// weights add up to over all ranks, 0 if there is no point.
  double add_point(const Probe &probe, Collector &collector) const;
  double add_boundary(const Probe &probe, Collector &collector) const;
  double add_section(const Probe &probe, Collector &collector) const;
  /// Adds the field at points of the unit cell, and at a quadrature point, times weights.
  void add_values(const FieldDefinition<dim> &field,
                  const CellIterator &cell,
                  const dealii::Quadrature<dim> &points,
                  const std::vector<double> &weights,
                  Collector &collector) const;
  void add_value(const FieldDefinition<dim> &field,
                 const CellIterator &cell,
                 const dealii::FEValuesBase<dim> &values,
                 const dealii::FEValuesBase<dim> &pressure_values,
                 unsigned int q,
                 double weight,
                 Collector &collector) const;

  const Space<dim> &space;
  const Problem &problem;
  const std::vector<FieldDefinition<dim>> definitions;
  std::vector<Probe> probes;
  mutable std::vector<double> sums; ///< work space
};
} // namespace Continua

#endif
