#ifndef continua_continuum_continuum_solver_h
#define continua_continuum_continuum_solver_h

#include <continua/base/archive.h>
#include <continua/continuum/compared_field.h>
#include <continua/continuum/harmonic_system.h>
#include <continua/continuum/liquid_mass.h>
#include <continua/continuum/motion_extremes.h>
#include <continua/continuum/power_balance.h>
#include <continua/continuum/vibration_operator.h>
#include <continua/mesh/indicator_field.h>
#include <continua/mesh/vessel_axis.h>
#include <continua/signal/expression.h>
#include <continua/time_integration/step.h>

#include <deal.II/base/point.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/data_out.h>

#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace Continua
{
class Network;

/// A field that can be probed or drawn, by the word of the parameter file.
struct FieldComponent
{
  std::string name; ///< "displacement y"
  std::string unit; ///< "m"
};

/// A number that follows from the state: a field's value at a point, or its mean or integral over a
/// boundary, over the interface of two regions or over the section of the undeformed body by a
/// plane. Of a body that
/// is modelled in part (a quarter of a tube) integrals are over that part; in axisymmetry they are
/// over the whole circumference.
template <int dim>
struct ProbeRequest
{
  enum class Kind
  {
    point,
    boundary_mean,
    boundary_integral,
    section_mean,
    section_integral,
    rim_mean, ///< over the rim of a section that faces away from its point: a tube's inner wall
    /// Flow rate along the normal of a section, by the discrete equation of mass balance where the
    /// discretisation has one; there is no field.
    section_flow,
    volume_mean, ///< over the regions
    volume_integral,
    /// By how much the volume of the regions has grown by the motion of their surface with other
    /// regions; there is no field.
    volume_change,
    /// The force of the body on what holds its boundaries, or of the regions on those across an
    /// interface, which Taylor-Hood elements have; there is no field.
    boundary_force,
    cavity_pressure, ///< of the cavity that the boundary encloses; there is no field
    cavity_volume,
    /// A coordinate at which the field changes its sign along a boundary or an interface [m]; NaN
    /// where there is none.
    sign_change
  };
  Kind kind = Kind::point;
  std::string field;        ///< one of the solver's fields(), but for the kinds that have none
  dealii::Point<dim> point; ///< [m]; for points, and one of the plane for sections
  /// Of a point of a deformed body: that it stays where it is in space, and does not go with the
  /// mesh. NaN while the body is elsewhere.
  bool is_fixed_in_space = false;
  /// Of the plane, for sections; of any length.
  dealii::Tensor<1, dim> normal = dealii::Point<dim>::unit_vector(0);
  /// The axis of the vessel through `point` along `normal`, of which alone the section is; null for
  /// all that the plane cuts.
  std::shared_ptr<const VesselAxis<dim>> axis;
  std::set<unsigned int> boundary_ids; ///< for boundaries
  /// For an interface in the place of a boundary: the regions on its other side. The values and the
  /// force are those of the side of `region_ids`, and the normal points out of them. A force may be
  /// that on both together, an interface and boundaries of these regions.
  std::set<unsigned int> neighbour_ids;
  unsigned int component = 0; ///< of a force, and of the coordinate of a change of sign
  /// Of a change of sign: which one in the order of the coordinate, from 0, and between which
  /// coordinates [m].
  unsigned int number = 0;
  std::pair<double, double> range = {-std::numeric_limits<double>::infinity(),
                                     std::numeric_limits<double>::infinity()};
  /// The regions whose side counts (a field may jump); empty: any that is there.
  std::set<unsigned int> region_ids;

  /// Whether the unit is that of the field over a line, an area or a volume.
  bool is_integral() const
  {
    return kind == Kind::boundary_integral || kind == Kind::section_integral ||
           kind == Kind::volume_integral;
  }
  bool is_section() const
  {
    return kind == Kind::section_mean || kind == Kind::section_integral || kind == Kind::rim_mean;
  }
  /// Whether the kind itself is what is asked for.
  bool has_no_field() const
  {
    return kind == Kind::section_flow || kind == Kind::volume_change ||
           kind == Kind::boundary_force || is_of_cavity();
  }
  bool is_of_cavity() const { return kind == Kind::cavity_pressure || kind == Kind::cavity_volume; }
};

/// What a step tells.
struct StepReport
{
  unsigned int factors = 0; ///< that had to be made
  double largest_velocity =
      0.; ///< [m/s], largest component of the step's velocity; never NaN: that throws
  double largest_change = 0.; ///< [m/s], largest component of its change in the step
  /// Of a static step: the largest part of what a region has by which the step has changed it [1],
  /// of a solid's displacement and of the forces of a liquid's velocity.
  double steady_change = 0.;
  /// Of a solver that corrects its solution in a loop: how often it did so, else 0.
  unsigned int corrections = 0;
  double residual = 0.;     ///< [1] with which the loop ended, in its own scale
  bool cap_reached = false; ///< the loop ended at its cap of corrections, above its tolerance
  /// Of an iterative linear solver, of all its solves in the step.
  unsigned int linear_iterations = 0;
};

/// One pass of a solver that corrects its solution in a loop.
struct LoopCorrection
{
  double time = 0.;        ///< of the end of the step [s]
  unsigned int number = 0; ///< in the step, from 1
  double residual = 0.;    ///< of the momentum equations at its start, scaled [1]
  double continuity = 0.;  ///< of the equation of state at the end, scaled [1]; 0 without pressure
  double magnitude = 0.;   ///< sum |b - A x| of the momentum equations at its start [N]
};

/// What tells where the mesh is too coarse.
struct IndicatorRequest
{
  enum class Kind
  {
    /// Of n.sigma across faces, inside a region and across interfaces, and of its difference from
    /// the load at a boundary.
    traction_jump,
    /// Of the normal derivative of a field across the faces inside each region (Kelly, Gago,
    /// Zienkiewicz and Babuska, 1983).
    kelly
  };
  Kind kind = Kind::traction_jump;
  IndicatorField field = IndicatorField::velocity; ///< of Kelly's indicator
};

/// The local error of the last step's velocity as the scheme's order lets it be estimated.
struct StepError
{
  bool is_known = false; ///< not in the first steps after a start, a jump or a change of the mesh
  double kinetic_energy = 0.; ///< that the error of the velocity would have as a motion [J]
};

/// Sizes of the discrete problem.
struct SolverSizes
{
  unsigned long long n_cells = 0;
  std::map<std::string, unsigned long long> n_dofs; ///< by field
  double factor_entries = 0.;
  double factor_memory = 0.; ///< bytes over all ranks
  std::string linear_solver;
  std::string reason_of_linear_solver; ///< why it was taken
};

/**
 * The continuum on its mesh: what analyses and postprocessors know of it. Methods are collective
 * over the communicator. State and time: the solver holds the fields; when to step, write, refine
 * or save is the analysis's business.
 */
template <int dim>
class ContinuumSolver
{
public:
  virtual ~ContinuumSolver() = default;

  /// Sets the spaces and operators up on the present mesh and the initial state on it.
  virtual void initialise() = 0;
  /// One step; throws RunError if the result is not finite or the solve failed.
  virtual StepReport advance(const Step &step) = 0;
  /// The solids come to rest where they are: their velocity is 0.
  virtual void stop_solids() {}
  /// Takes the present state, which is at rest or steady, for that of t = 0, with nothing before
  /// it.
  virtual void start_from_present_state() = 0;
  /// With Problem::finds_unloaded_shape(): the steps that follow, with Step::finds_unloaded_shape,
  /// search for the unloaded shape, from the one that is known (at first that of the mesh).
  virtual void begin_unloaded_shape() {}
  /// The search has ended: the body is in the shape of the mesh, in balance and at rest.
  virtual void keep_unloaded_shape() {}
  /// `sink` gets each correction of a solver that makes some, on all ranks, as soon as it is made;
  /// also those of a step that is undone or fails.
  virtual void report_corrections(const std::function<void(const LoopCorrection &)> & /*sink*/) {}
  /// One solve without time for a body that is all solid (displacement) or all fluid (velocity),
  /// loads taken at `time`.
  virtual void solve_steady(double time) = 0;
  /// Whether solve_steady applies, or the mixture has to be stepped to a steady state.
  virtual bool steady_is_direct() const = 0;
  /// The free vibrations of a body that is all solid and does not relax; null if the discretisation
  /// has none. The solver must outlive it.
  virtual std::unique_ptr<VibrationOperator<dim>> vibration() { return nullptr; }
  /// The linear body in motion exp(s t); null if the discretisation has none. The solver must
  /// outlive it.
  virtual std::unique_ptr<HarmonicSystem<dim>> harmonic_system() { return nullptr; }
  /// The averages over time begin anew with the present state.
  virtual void begin_averages() = 0;
  /// A time [s] has led to the present state, which others than steps have set.
  virtual void add_to_averages(double duration) = 0;
  /// Estimate for the last step, from the velocities that were kept with keep_state().
  virtual StepError step_error() = 0;
  /// Keeps the present state in memory for return_to_kept_state() and for step_error(): call before
  /// each step whose error is asked for.
  virtual void keep_state() = 0;
  /// Goes back to the state kept last: a step is undone.
  virtual void return_to_kept_state() = 0;
  /// Whether a load or prescribed velocity jumps between the two times [s].
  virtual bool data_jump(double begin, double end) const = 0;

  /// What can be probed.
  virtual std::vector<FieldComponent> fields() const = 0;
  /// Adds a probe and returns its number; throws std::invalid_argument (on all ranks) if the point
  /// is outside the mesh, the section has no area or the field is unknown. Probes stay when the
  /// mesh changes.
  virtual unsigned int add_probe(const ProbeRequest<dim> &request) = 0;
  /// The values of all probes, in SI, on every rank.
  virtual void evaluate_probes(std::vector<double> &values) = 0;

  /// The network of vessels at ends of the body in its present state, until the next step; null if
  /// there is none.
  virtual const Network *network() { return nullptr; }

  /// Of the last step; `relaxation`: with what relaxation turns into heat, which costs a product
  /// for each branch.
  virtual PowerBalance power_balance(bool relaxation) = 0;
  virtual Energy energy() = 0;
  /// Largest |div U| weakly (|B U| over M_p, [1/s]): what an incompressible material must keep at
  /// round-off.
  virtual double divergence() = 0;

  /// How far the present state is from rest; the same on every rank.
  virtual MotionExtremes motion_extremes() = 0;
  /// Of the liquids, where the mesh moves; the same on every rank.
  virtual LiquidMass liquid_mass() = 0;

  /// The shape of the cells, for drawing: straight unless the discretisation has another.
  virtual const dealii::Mapping<dim> &mapping() const
  {
    return dealii::StaticMappingQ1<dim>::mapping;
  }
  /// Adds the output fields to `data_out` (they stay valid until the next call); returns name ->
  /// unit.
  virtual std::map<std::string, std::string> add_output(dealii::DataOut<dim> &data_out) = 0;

  /// An indicator for each active cell; only owned ones count. Traction jump: in N/m^(1/2) in 2-D.
  virtual void indicators(const IndicatorRequest &request, dealii::Vector<float> &per_cell) = 0;
  /// Call after cells are flagged and before the triangulation refines, and after; all history is
  /// transferred.
  virtual void prepare_refinement() = 0;
  virtual void transfer() = 0;

  /// This rank's state, bit by bit.
  virtual void save(ArchiveWriter &archive) const = 0;
  virtual void load(const ArchiveReader &archive) = 0;

  /// L2 norm of the difference between a field and given functions of (x, y, z, t), one a
  /// component; absolute, SI. Collective.
  virtual double
  error_norm(ComparedField field, const std::vector<Expression> &exact, double time) = 0;

  virtual SolverSizes sizes() const = 0;
};
} // namespace Continua

#endif
