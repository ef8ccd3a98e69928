#ifndef continua_continuum_outlet_coupling_h
#define continua_continuum_outlet_coupling_h

#include <continua/continuum/body_port.h>
#include <continua/continuum/end_models.h>
#include <continua/continuum/port_system.h>
#include <continua/continuum/power_balance.h>
#include <continua/continuum/step_solution.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace Continua
{
/**
 * The outlets of a problem, coupled implicitly: every step is balanced with the pressures that its
 * own flow rates cause.
 *
 * A step's equations are solved without outlets first; to that solution a few others, the responses
 * of the body to each port alone (BodyPort), are added in the amounts that the outlets' equations
 * ask for (PortSystem). H and the responses belong to the factor of the step's matrix and are made
 * when that is; a step adds one sum over the ranks and no solve. Where a model is not linear (a
 * network) the small system is solved again with the p_plus and Z about the flow rates that were
 * found, until these stay: still without a solve of the body.
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
  double energy() const { return models.energy(); }
  /// Pressure [Pa] and flow rate [m^3/s] of a port at the balanced level.
  double pressure(const unsigned int outlet, const unsigned int port) const
  {
    return pressures[models.first_port(outlet) + port];
  }
  double flow_rate(const unsigned int outlet, const unsigned int port) const
  {
    return flow_rates[models.first_port(outlet) + port];
  }
  /// The ports' pressures at the present time with the velocity there, by condition; 0 of
  /// conditions that are no port [Pa].
  std::vector<double> present_pressures(double time, const DistributedVector &velocity);
  /// Adds the forces of these pressures at ports whose traction is given [N].
  void
  add_present_forces(double time, const DistributedVector &velocity, DistributedVector &forces);
  /// The network at ends of the body in its present state, or null.
  const Network *network() { return models.network(); }
  /// Whether the pressure behind an outlet jumps between the two times [s].
  bool jumps(double begin, double end) const { return models.jumps(begin, end); }

  /// Hands over all that a step changes.
  void visit(StateVisitor &visitor);

private:
  const Problem &problem;
  Operators &operators;
  std::vector<BodyPort> ports;
  EndModels models;
  PortSystem system;
  std::vector<double> pressures, flow_rates; ///< by port, at the balanced level [Pa], [m^3/s]
  std::vector<double> flow_rates_of_mesh;    ///< q . W, which is no part of them [m^3/s]
  /// The same at the present time: from step to step as the velocities go on.
  std::vector<double> present_flow_rates_of_mesh;
  // Work space of the step.
  std::vector<double> sums;
  DistributedVector section;
  dealii::Vector<double> outputs, predicted;
  dealii::FullMatrix<double> impedances; ///< Z of the step

  /// Takes the ports' sections at a displacement of the mesh.
  void take_sections(const DistributedVector &mesh_displacement);
  /// The flow rates of a velocity through the sections at the present time, past the mesh, by port.
  std::vector<double> present_flow_rates(const DistributedVector &velocity);
  /// Takes Z and the predicted pressures of the models; `changed`: whether any Z has.
  void take_models(bool changed);
  /// Solves for the ports' pressures and flow rates, of outputs and predicted pressures; the inputs
  /// of the body.
  const dealii::Vector<double> &solve_ports();
  /// Solves for the ports until the models stay as they are, and adds the responses.
  void complete(DistributedVector &velocity, DistributedVector &pressure);
  void add_responses(const dealii::Vector<double> &inputs,
                     DistributedVector &velocity,
                     DistributedVector &pressure) const;
};
} // namespace Continua

#endif
