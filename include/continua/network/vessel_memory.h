#ifndef continua_network_vessel_memory_h
#define continua_network_vessel_memory_h

#include <continua/network/flow_law.h>
#include <continua/network/state_numbers.h>
#include <continua/network/wall_relaxation.h>

#include <vector>

namespace Continua
{
/**
 * What depends on the past in a vessel: the pressure of a wall that relaxes, on the faces of the
 * cells, and the friction that remembers, in the cells. It changes the flow rates alone,
 *
 *     dQ/dt = -A/rho dq/dz - sum_j kappa_j (Q - w_j),   dw_j/dt = rate_j (Q - w_j),
 *     q = -damping_time dp/dA dQ/dz + sum_k q_k,        dq_k/dt = -share_k dp/dA dQ/dz - q_k/tau_k.
 *
 * These are implicit, by the method SSP2(2,2,2) of L. Pareschi and G. Russo (J. Sci. Comput. 25
 * (2005) 129): its explicit stages are those of the vessel, the implicit ones are L-stable, and the
 * whole is of second order. So the step has no limit from the viscosity of the wall. A wall that
 * has relaxed has q = 0 exactly.
 *
 * The flow rates of a stage are linear in those at the two ends, which the nodes find
 * (MemoryNodes).
 */
class VesselMemory
{
public:
  /// A value that depends on the flow rates at the start and the end of the vessel.
  struct Affine
  {
    double constant = 0., of_start = 0., of_end = 0.;
    double at(const double start, const double end) const
    {
      return constant + of_start * start + of_end * end;
    }
  };

  /// `cell_length` [m]; at least 2 cells where the wall relaxes. Throws std::invalid_argument.
  VesselMemory(unsigned int n_cells,
               double cell_length,
               const FlowLaw &law,
               const WallRelaxation &relaxation);

  bool wall_relaxes() const { return !relaxation.is_elastic(); }
  /// The wall has relaxed, and the liquid has these flow rates for long.
  void start_at_rest(const std::vector<double> &flows);
  /// Keeps the state as that of the begin of a step.
  void begin_step();
  /// An implicit stage of a step [s] from the areas [m^2] and flow rates [m^3/s] of the cells after
  /// the explicit one, and dp/dA on the faces [Pa/m^2].
  void begin_stage(bool second,
                   double step,
                   const std::vector<double> &areas,
                   const std::vector<double> &flows,
                   const std::vector<double> &stiffnesses);
  /// Of the stage: the flow rate [m^3/s] that a line through the two outer cells has on the end,
  /// and the pressure of the memory there [Pa].
  Affine flow_inside(bool at_end) const;
  Affine end_pressure(bool at_end) const;
  /// Takes the flow rates of the ends, and sets those of the cells.
  void end_stage(double start_flow, double end_flow, std::vector<double> &flows);
  /// After the explicit part of a stage, with the flow rates of the ends in it: adds what the
  /// memory gives to those of the cells.
  void
  add(bool second, double step, double start_flow, double end_flow, std::vector<double> &flows);
  /// Hands over what a step changes.
  void visit(StateNumbers &numbers);
  /// Of a share of the modulus that acts at once in a step of `step` [s], for the speed of waves
  /// [1].
  double fast_share(double step) const;

  /// On a face, of the last stage or at the end of the last step [Pa].
  double pressure(const unsigned int face) const { return pressures[face]; }
  double pressure_in_cell(const unsigned int cell) const
  {
    return 0.5 * (pressures[cell] + pressures[cell + 1]);
  }
  /// What the memory of a cell takes from dQ/dt at an area [m^2], in the middle of the last step
  /// [m^3/s^2].
  double friction(unsigned int cell, double area) const;

private:
  unsigned int n;
  double cell_length;
  FlowLaw law;
  WallRelaxation relaxation;
  /// By branch and face, and by mode and cell: now, at the begin of the step, and the rates of
  /// change of the two stages.
  struct States
  {
    std::vector<double> now, old, rates[2];
  };
  std::vector<States> branches, modes;
  std::vector<double> pressures;        ///< of the faces
  std::vector<double> flow_rates_of[2]; ///< dQ/dt of the stages
  // Of the stage.
  unsigned int stage = 0;
  double implicit_step = 0.; ///< [s]
  std::vector<double> stage_areas, explicit_flows, viscosities, known, stiffness;
  std::vector<Affine> cells;

  /// dQ/dz on a face [m^2/s], by the flow rates of the cells and the ends.
  template <typename Value>
  Affine flow_slope(unsigned int face, const Value &flow) const;
  double friction_rate(unsigned int mode, double area) const;
  double friction_weight(unsigned int mode, double area) const;
  void eliminate();
};
} // namespace Continua

#endif
