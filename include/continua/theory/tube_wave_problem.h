#ifndef continua_theory_tube_wave_problem_h
#define continua_theory_tube_wave_problem_h

#include <continua/theory/closed_form_waves.h>
#include <continua/theory/impedance.h>
#include <continua/theory/tube_section.h>
#include <continua/theory/wall_end.h>

#include <vector>

namespace Continua
{
/// A piece of a tube that wave theory takes for uniform.
struct TubeSegment
{
  double length = 0.; ///< [m]
  TubeSection section;
};

/// A tube with its ends, and the branches behind it.
// NOLINTNEXTLINE(bugprone-exception-escape): deal.II's matrix may throw when it is moved
struct TubeWaveProblem
{
  enum class Inlet
  {
    pressure, ///< normal traction -p on the liquid's section [Pa]
    flow_rate ///< into the tube [m^3/s]
  };
  enum class Outlet
  {
    closed,  ///< no flow
    open,    ///< no traction
    matched, ///< the pressure wave's own impedance: it leaves, but for what the wall's end demands
    absorbing, ///< what a long tube behind would do: no pressure wave comes back, and where the
               ///< wall's end is absorbing too, none at all
    loaded,    ///< a given impedance, such as that of branches
    divided    ///< the tube divides into `branches`
  };
  WaveLevel level = WaveLevel::exact;
  std::vector<TubeSegment> segments;
  /// In a chain of more segments of different sections, exact waves are computed for so many of
  /// them (the first and the last one among them) and interpolated along the chain between these.
  unsigned int n_computed_sections = 6;
  Inlet inlet = Inlet::pressure;
  Outlet outlet = Outlet::closed;
  Impedance load; ///< traction over flow rate of a loaded outlet; one port
  /// What a divided outlet goes on in. Their inlets have the traction of the outlet, and together
  /// take its flow rate. Exact waves demand that all walls are held axially.
  std::vector<TubeWaveProblem> branches;
  WallEnd wall_inlet_end = WallEnd::clamped;
  WallEnd wall_outlet_end = WallEnd::clamped;

  double length() const; ///< of the tube itself [m]
};
} // namespace Continua

#endif
