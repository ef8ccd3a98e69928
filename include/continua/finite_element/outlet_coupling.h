#ifndef continua_finite_element_outlet_coupling_h
#define continua_finite_element_outlet_coupling_h

#include <continua/continuum/continuum_solver.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/state_visitor.h>
#include <continua/finite_element/boundary_constraints.h>
#include <continua/finite_element/loads.h>
#include <continua/finite_element/step_system.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <utility>
#include <vector>

namespace Continua
{
/**
 * The outlets of a problem, coupled implicitly: every step is balanced with the pressures that its
 * own flow rates cause.
 *
 * A step's equations are solved without outlets first; to that solution a few others, the responses
 * of the body to each port alone, are added in the amounts that the outlets' equations ask for. For
 * a port that holds the pressure p the response is that to the force -q p, q_i = int v_i . n; what
 * it gives back is its flow rate q . U. For a port that holds the flow rate Q it is the response to
 * the prescribed velocity phi Q, where the flow of phi is 1; what it gives back is its pressure by
 * virtual power, p = -phi . (A U - B^T P - f). With the inputs s, the outputs o = o0 + H s and the
 * outlets' p = p_plus + Z Q, where Z = direct + sum_k residue_k (velocity coefficient of x_k),
 *
 *   [ I_p + I_Q H - Z (I_Q + I_p H) ] s = p_plus + (Z I_p - I_Q) o0,
 *
 * with I_p, I_Q ones at the ports of either kind. H and the responses belong to the factor of the
 * step's matrix and are made when that is; a step adds one sum over the ranks and no solve.
 */
template <int dim>
class OutletCoupling
{
public:
  /// All must outlive it.
  OutletCoupling(const Space<dim> &space,
                 const Problem &problem,
                 const Loads<dim> &loads,
                 const BoundaryConstraints<dim> &constraints);

  bool is_empty() const { return ports.empty(); }
  /// The states of t = 0.
  void initialise();
  /// The ports on the present mesh; the states stay. After loads and constraints are built.
  void build();
  /// The body's responses by the step's matrix. Call after each new factor.
  void respond(StepSystem<dim> &system);

  /// Sets prescribed velocities at ports that hold the flow rate to zero.
  void leave_out_ports(DistributedVector &prescribed) const;
  /// Takes the right-hand side f of the momentum equation, without the prescribed velocities' part
  /// and not restricted [N].
  void take_forces(const DistributedVector &momentum);
  /// Completes a step's solution without outlets to the one with them, all at the balanced level,
  /// and moves the states on to the end of the step. `velocity_old` at its start.
  void couple(const Step &step,
              const DistributedVector &velocity_old,
              DistributedVector &velocity,
              DistributedVector &pressure);
  /// The same of a steady flow, with Z(0). Throws RunError if an outlet lets no steady flow pass.
  void couple_steady(double time, DistributedVector &velocity, DistributedVector &pressure);

  /// Adds factor times the forces that the ports that hold pressures exert at the balanced level,
  /// -q p [N].
  void add_forces(double factor, DistributedVector &forces) const;
  /// Of each outlet, at the balanced level.
  void power(std::vector<OutletPower> &of_outlets) const;
  /// Stored by those outlets whose terms are stores [J].
  double energy() const;
  /// Pressure [Pa] and flow rate [m^3/s] of a port at the balanced level.
  double pressure(const unsigned int outlet, const unsigned int port) const
  {
    return ports[first_port[outlet] + port].pressure;
  }
  double flow_rate(const unsigned int outlet, const unsigned int port) const
  {
    return ports[first_port[outlet] + port].flow_rate;
  }
  /// The ports' pressures at the present time with the velocity there, by condition; 0 of
  /// conditions that are no port [Pa].
  std::vector<double> present_pressures(double time, const DistributedVector &velocity) const;
  /// Whether the pressure behind an outlet jumps between the two times [s].
  bool jumps(double begin, double end) const;

  /// Hands over all that a step changes.
  void visit(StateVisitor &visitor);

private:
  /// The entries of an owned vector that are not zero, by local index.
  using Sparse = std::vector<std::pair<unsigned int, double>>;
  /// One first-order response x_k of an outlet, by port [m^3].
  struct State
  {
    dealii::Vector<double> present, older, balanced;
    dealii::Vector<double> rate; ///< dx_k/dt as the step has it [m^3/s]
  };
  struct Port
  {
    unsigned int outlet;
    bool holds_flow;
    Sparse flow;     ///< q [m^2]
    Sparse velocity; ///< phi [1/m^2]; of a port that holds the flow rate
    Sparse momentum_of_velocity, mass_of_velocity; ///< A phi and B phi
    DistributedVector velocity_response, pressure_response;
    double force = 0.;                    ///< phi . f of this rank
    double pressure = 0., flow_rate = 0.; ///< at the balanced level
  };

  const Space<dim> &space;
  const Problem &problem;
  const Loads<dim> &loads;
  const BoundaryConstraints<dim> &constraints;
  std::vector<Port> ports;
  std::vector<unsigned int> first_port;     ///< by outlet
  std::vector<std::vector<State>> states;   ///< by outlet and term
  dealii::FullMatrix<double> responses;     ///< H
  dealii::FullMatrix<double> impedances;    ///< Z of the step
  dealii::FullMatrix<double> inputs_of_rhs; ///< inverse of the matrix above
  std::vector<double> present_coefficients; ///< that inputs_of_rhs belongs to
  bool impedances_are_set = false;
  // Work space of the step.
  std::vector<double> sums, coefficients; ///< of x_k, by outlet and term
  dealii::Vector<double> outputs, rhs, inputs, predicted;
  static Sparse sparse(const DistributedVector &vector);
  static double product(const Sparse &sparse, const DistributedVector &vector);
  /// This rank's part of what a port gives back.
  double output(const Port &port,
                const DistributedVector &velocity,
                const DistributedVector &pressure) const;
  /// Makes Z and what follows from it where the velocity coefficients, by outlet and term, are new.
  void set_impedances();
  /// Solves for the ports' pressures and flow rates, of outputs and predicted pressures, and adds
  /// the responses.
  void add_responses(DistributedVector &velocity, DistributedVector &pressure);
};
} // namespace Continua

#endif
