#ifndef continua_network_vessel_h
#define continua_network_vessel_h

#include <continua/network/flow_law.h>
#include <continua/network/vessel_memory.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/// What a vessel is made of. z [m] is the distance from its start, from 0 to `length`.
struct VesselDescription
{
  std::string name;
  double length = 0.;          ///< [m]
  unsigned int n_cells = 0;    ///< of equal length
  double height_at_start = 0.; ///< above the reference of the pressure of gravity [m]
  double height_at_end = 0.;   ///< [m]; between them it is linear
};

/// Where and why a vessel cannot go on.
struct VesselProblem
{
  double position = 0.; ///< z [m]
  std::string text, remedy;
};

/**
 * Area A and flow rate Q of the liquid along a vessel whose wall gives way,
 *
 *     dA/dt + dQ/dz = 0,
 *     dQ/dt + d(alpha Q^2/A)/dz + A/rho d(p + rho g height)/dz = -friction Q/A,
 *
 * with the pressure p(A, z) of a wall law whose numbers may vary along z continuously. Finite
 * volumes of second order in space; in time the two stages of the strong-stability-preserving
 * Runge-Kutta method (S. Gottlieb, C.-W. Shu, E. Tadmor, SIAM Rev. 43 (2001) 89).
 *
 * The scheme is path-conservative (C. Pares, SIAM J. Numer. Anal. 44 (2006) 300). Linear in a cell
 * are the flow rate and the head, p + rho g height + rho alpha U^2/2, with central slopes in a
 * smooth wave and those of B. van Leer's limiter elsewhere; so steady states without friction, at
 * rest and with flow, stay as they are to round-off for any wall along z. A jump at a face is
 * divided by two waves (A. Harten, P. D. Lax, B. van Leer, SIAM Rev. 25 (1983) 35). Across it the
 * integral of A dp is that of Simpson, which is exact for the square-root law. Inside a cell the
 * integral of alpha U dQ + A dH/rho is that of Simpson with Q and H linear. So momentum is
 * conserved in a uniform tube up to a small error at jumps, which does not vanish with the cells:
 * about 1e-6 of what the ends give where the area doubles.
 *
 * A wall that relaxes and a friction that remembers (VesselMemory) change the flow rates in
 * implicit stages, before the explicit ones. Waves and heads are those of the wall law then; the
 * pressure of the memory is added at the ends.
 *
 * The flow must be slower than the wave. A cell on whose faces the linear head and flow rate have
 * no such state has constant ones.
 */
class Vessel
{
public:
  enum class End
  {
    start, ///< z = 0
    end    ///< z = length
  };
  /// Area [m^2] and flow rate towards the end [m^3/s].
  struct State
  {
    double area = 0., flow = 0.;
  };

  explicit Vessel(const VesselDescription &description);
  virtual ~Vessel() = default;
  Vessel(const Vessel &) = delete;
  Vessel &operator=(const Vessel &) = delete;

  const std::string &name() const { return description.name; }
  double length() const { return description.length; }
  unsigned int n_cells() const { return description.n_cells; }
  double cell_length() const { return description.length / description.n_cells; }
  double height(double z) const; ///< [m]

  /// Mean values of the cells [m^2], [m^3/s].
  const std::vector<double> &areas() const { return area; }
  const std::vector<double> &flows() const { return flow; }
  /// Volume of the liquid [m^3].
  double volume() const;
  /// Kinetic energy of the liquid, of the mean velocity, its energy of height, and that of the wall
  /// law from the area A0 on [J].
  double energy() const;
  /// The pressure [Pa], flow rate [m^3/s], area [m^2] and shear stress on the wall, positive
  /// towards the end [Pa], at z [m], linear between the centres of the cells and the ends. What the
  /// friction remembers is in a cell alike everywhere, and is that of the middle of the last step:
  /// the shear stress is of first order in the step.
  struct Values
  {
    double pressure, flow, area, wall_shear_stress;
  };
  Values values(double z) const;
  /// The state that the end had last.
  const State &end_state(const End end) const { return of_end(end).state; }

  /// Before the first step: how the wall relaxes. Throws std::invalid_argument.
  void set_relaxation(const WallRelaxation &relaxation);
  /// None without set_relaxation(); a Network sees to it where the wall of another vessel relaxes
  /// or the friction remembers.
  VesselMemory *memory() { return past.get(); }
  bool wall_relaxes() const { return past && past->wall_relaxes(); }

  /// At rest under a pressure [Pa] where the height is zero. Throws std::domain_error if there is
  /// no area for it.
  void start_at_rest(double pressure);
  /// A steady flow [m^3/s] towards the end, from a pressure [Pa] at the start: the pressure at the
  /// end [Pa], and the state. Throw std::domain_error where the wall has no such state.
  virtual double steady_end_pressure(double flow, double start_pressure) const = 0;
  virtual void start_steady(double flow, double start_pressure) = 0;
  /// Any state, of the centres of the cells [m^2], [m^3/s].
  void set(const std::vector<double> &areas, const std::vector<double> &flows);

  /// An end in an implicit stage: it has the pressure [Pa] less `impedance` [Pa s/m^3] times the
  /// flow rate out of it that is more than VesselMemory::flow_inside(); and rho alpha U^2/2 [Pa].
  struct LinearEnd
  {
    double pressure, impedance, dynamic_pressure;
  };
  virtual LinearEnd linear_end(End end) const = 0;
  /// The implicit stage, with a memory: begin, then the flow rates of the ends are found, then end.
  void begin_memory_stage(bool second, double step);
  void end_memory_stage(double start_flow, double end_flow);
  /// After advance(): what the memory gives.
  void add_memory(bool second, double step);
  /// Of the memory [Pa].
  double memory_pressure(const End end) const
  {
    return past ? past->pressure(end == End::start ? 0 : n_cells()) : 0.;
  }

  /// Hands over what a step changes.
  void visit(StateNumbers &numbers);

  /// The largest step [s] for a Courant number 1, also of the friction.
  virtual double largest_step() const = 0;
  /// Keeps the state as that of the begin of a step.
  void begin_step();
  /// Finds the states on both sides of each face, and those inside the ends. False if there is none
  /// at a face: problem() then says why, and the vessel cannot go on.
  [[nodiscard]] virtual bool reconstruct() = 0;
  /// One stage with a step of `step` [s] after reconstruct() and set_end(): the new state is
  /// `share` times the state at the begin of the step, and (1 - share) times the state after the
  /// stage.
  virtual void advance(double step, double share) = 0;
  /// Why the state, or that of reconstruct() at a face, is none: a closed tube, a flow as fast as
  /// the wave, a pressure that the wall cannot bear. Empty text: it is one.
  virtual VesselProblem problem() const = 0;

  // What a node needs to know of an end.
  /// Inside the end, after reconstruct().
  const State &trace(const End end) const { return of_end(end).trace; }
  void set_end(const End end, const State &state) { of_end(end).state = state; }
  virtual double pressure(End end, double area) const = 0;  ///< [Pa]
  virtual double stiffness(End end, double area) const = 0; ///< dp/dA [Pa/m^2]
  /// Which no area reaches [Pa]; infinite if there is none.
  virtual double largest_pressure(End end) const = 0;
  /// [m^2]; from a near one.
  virtual double area_at(End end, double pressure, double start) const = 0;
  virtual const FlowLaw &flow_law() const = 0;

protected:
  struct EndStates
  {
    State trace, state;
  };
  VesselDescription description;
  std::vector<double> area, flow;         ///< of the cells
  std::vector<double> old_area, old_flow; ///< at the begin of the step
  std::unique_ptr<VesselMemory> past;

  const EndStates &of_end(const End end) const { return ends[end == End::start ? 0 : 1]; }
  EndStates &of_end(const End end) { return ends[end == End::start ? 0 : 1]; }
  /// [Pa] at the centre of a cell.
  virtual double pressure_at_centre(unsigned int cell, double area) const = 0;
  virtual double stiffness_at_face(unsigned int face, double area) const = 0; ///< [Pa/m^2]
  /// The integral of the pressure of the wall law over the area, from A0 on [J/m].
  virtual double wall_energy(unsigned int cell, double area) const = 0;

private:
  EndStates ends[2];
};

/// A vessel with a wall law for each place: `wall(z)` for z [m] is of the type Wall
/// (square_root_wall.h, neo_hookean_wall.h, tabulated_wall.h).
template <typename Wall>
std::unique_ptr<Vessel> make_vessel(const VesselDescription &description,
                                    const FlowLaw &flow_law,
                                    const std::function<Wall(double)> &wall);
} // namespace Continua

#endif
