#ifndef continua_continuum_outlet_coupling_h
#define continua_continuum_outlet_coupling_h

#include <continua/continuum/end_model.h>
#include <continua/continuum/operators.h>
#include <continua/continuum/power_balance.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/step_solution.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <memory>
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
 * virtual power, p = -phi . (A U + G p - f). With the inputs s, the outputs o = o0 + H s and the
 * models' p = p_plus + Z Q (EndModel),
 *
 *   [ I_p + I_Q H - Z (I_Q + I_p H) ] s = p_plus + (Z I_p - I_Q) o0,
 *
 * with I_p, I_Q ones at the ports of either kind. H and the responses belong to the factor of the
 * step's matrix and are made when that is; a step adds one sum over the ranks and no solve. Where a
 * model is not linear (a network) the small system is solved again with the p_plus and Z about the
 * flow rates that were found, until these stay: still without a solve of the body.
 *
 * On a mesh that moves q belongs to the present section and Q = q . (U - W), with the velocity W of
 * the mesh, but for absorbing ends, whose theory is linear: Q = q . U. There the pressures are a
 * part of the residual, p = p_plus + Z Q at each iterate, and a change at constant pressures is
 * completed by the responses to (I - Z H)^-1 Z (q . dU). The mesh stays at a port that holds the
 * flow rate. There U = phi Q, and the rows of momentum at its nodes count by their power with phi
 * alone, with the force -q p in them: what is left is phi . (f - N) - p. The equations above hold
 * for the changes of both kinds of ports, with the derivative of N in the place of A and G.
 */
class OutletCoupling
{
public:
  /// Both must outlive it.
  OutletCoupling(const Problem &problem, Operators &operators);

  bool is_empty() const { return problem.outlets.empty(); }
  /// The states of t = 0.
  void initialise();
  /// The ports on the present mesh; the states stay. After the operators' setup().
  void build();
  /// The body's responses by the step's matrix. Call after each new factor. The report gets the
  /// iterations of the solves.
  void respond(StepReport &report);

  /// Sets prescribed velocities at ports that hold the flow rate to zero.
  void leave_out_ports(DistributedVector &prescribed) const;
  /// Takes the right-hand side f of the momentum equation, without the prescribed velocities' part
  /// [N].
  void take_forces(const DistributedVector &momentum);
  /// Sets the ports' pressures to those that the flow rates at the step's start cause in it: what
  /// an iteration starts from.
  void predict(const Step &step, const DistributedVector &velocity_old);
  /// Of a mesh that moves: takes the ports' sections, flow rates and pressures at an iterate of a
  /// step. Collective.
  void measure(const StepSolution &iterate);
  // Of a mesh that moves.
  /// Sets the velocities of the ports that hold the flow rate to those of the last flow rates.
  void set_port_velocities(DistributedVector &velocity) const;
  /// Adds factor times the forces -q p of all ports to the residual of momentum of an iterate [N].
  void add_to_residual(double factor, DistributedVector &momentum) const;
  /// The power of rows of momentum with each port's phi, 0 of ports that hold pressures [Pa].
  /// Collective.
  std::vector<double> port_rows(const DistributedVector &momentum) const;
  /// Sets the rows at the nodes of ports that hold the flow rate to multiples of phi of that power.
  void set_port_rows(const std::vector<double> &rows, DistributedVector &momentum) const;
  /// Completes the change of an iterate at constant pressures and velocities of the ports to the
  /// one with the pressures that its flow rates cause, with the sections of the last measure().
  /// `rows`: port_rows() of its right side.
  void complete_change(const std::vector<double> &rows,
                       DistributedVector &velocity_change,
                       DistributedVector &pressure_change);
  /// Completes a step's solution without outlets to the one with them, all at the balanced level.
  /// `velocity_old` at its start.
  void couple(const Step &step,
              const DistributedVector &velocity_old,
              DistributedVector &velocity,
              DistributedVector &pressure);
  /// Adds factor times what the present pressures of the ports that hold pressures do to the body.
  void add_pressure_responses(double factor,
                              DistributedVector &velocity,
                              DistributedVector &pressure) const;
  /// Moves the states on to the end of the step, by the flow rates of the last couple().
  void finish_step(const Step &step);
  /// The run begins from a state at rest that was searched for: the mesh stays there.
  void start_steady();
  /// Completes a steady flow, with Z(0). Throws RunError if an outlet lets no steady flow pass.
  void couple_steady(double time, DistributedVector &velocity, DistributedVector &pressure);

  /// Adds factor times the forces that the ports that hold pressures exert at the balanced level,
  /// -q p [N].
  void add_forces(double factor, DistributedVector &forces) const;
  /// The same of the ports of one region.
  void add_forces_of(unsigned int region, double factor, DistributedVector &forces) const;
  /// Of each outlet, at the balanced level.
  void power(std::vector<OutletPower> &of_outlets) const;
  /// Stored by those outlets whose terms are stores [J].
  double energy() const;
  /// Pressure [Pa] and flow rate [m^3/s] of a port at the balanced level.
  double pressure(const unsigned int outlet, const unsigned int port) const
  {
    return pressures[first_port[outlet] + port];
  }
  double flow_rate(const unsigned int outlet, const unsigned int port) const
  {
    return flow_rates[first_port[outlet] + port];
  }
  /// The ports' pressures at the present time with the velocity there, by condition; 0 of
  /// conditions that are no port [Pa].
  std::vector<double> present_pressures(double time, const DistributedVector &velocity);
  /// Adds the forces of these pressures at ports whose traction is given [N].
  void
  add_present_forces(double time, const DistributedVector &velocity, DistributedVector &forces);
  /// The network at ends of the body in its present state, or null.
  const Network *network();
  /// Whether the pressure behind an outlet jumps between the two times [s].
  bool jumps(double begin, double end) const;

  /// Hands over all that a step changes.
  void visit(StateVisitor &visitor);

private:
  /// The entries of an owned vector that are not zero, by local index.
  using Sparse = std::vector<std::pair<unsigned int, double>>;
  struct Port
  {
    unsigned int outlet;
    unsigned int condition;
    bool holds_flow;
    bool moves_with_mesh;           ///< its flow rate is that past a mesh that moves
    Sparse flow;                    ///< q [m^2], of a mesh that moves at the last iterate
    Sparse velocity;                ///< phi [1/m^2]; of a port that holds the flow rate
    double square_of_velocity = 0.; ///< phi . phi [1/m^4]
    Sparse momentum_of_velocity, mass_of_velocity; ///< A^T phi and -G^T phi
    DistributedVector velocity_response, pressure_response;
    double force = 0.; ///< phi . f of this rank
  };

  const Problem &problem;
  Operators &operators;
  std::vector<Port> ports;
  std::vector<unsigned int> first_port;          ///< by outlet
  std::vector<std::unique_ptr<EndModel>> models; ///< by outlet
  dealii::FullMatrix<double> responses;          ///< H
  dealii::FullMatrix<double> impedances;         ///< Z of the step
  dealii::FullMatrix<double> inputs_of_rhs;      ///< inverse of the matrix above
  bool inputs_are_current = false;
  std::vector<double> pressures, flow_rates; ///< by port, at the balanced level [Pa], [m^3/s]
  std::vector<double> flow_rates_of_mesh;    ///< q . W, which is no part of them [m^3/s]
  /// The same at the present time: from step to step as the velocities go on.
  std::vector<double> present_flow_rates_of_mesh;
  // Work space of the step.
  std::vector<double> sums;
  DistributedVector section;
  dealii::Vector<double> outputs, completed, rhs, inputs, predicted;

  static Sparse sparse(const DistributedVector &vector);
  static double product(const Sparse &sparse, const DistributedVector &vector);
  /// Takes the ports' sections at a displacement of the mesh.
  void take_sections(const DistributedVector &mesh_displacement);
  /// The flow rates of a velocity through the sections at the present time, past the mesh, by port.
  std::vector<double> present_flow_rates(const DistributedVector &velocity);
  /// This rank's part of what a port gives back.
  double output(const Port &port,
                const DistributedVector &velocity,
                const DistributedVector &pressure) const;
  /// Takes Z and the predicted pressures of the models; `changed`: whether any Z has.
  void take_models(bool changed);
  /// Solves for the ports' pressures and flow rates, of outputs and predicted pressures.
  void solve_ports();
  /// Linearises the models about the flow rates; whether that has changed anything.
  bool correct_models();
  /// The same until nothing changes, and adds the responses.
  void add_responses(DistributedVector &velocity, DistributedVector &pressure);
};
} // namespace Continua

#endif
