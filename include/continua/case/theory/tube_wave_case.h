#ifndef continua_case_theory_tube_wave_case_h
#define continua_case_theory_tube_wave_case_h

#include <continua/case/case.h>
#include <continua/theory/tube_wave_theory.h>

#include <functional>
#include <string>

namespace Continua
{
/// A parameter file as wave theory sees it. The theory's inlet is the end with the load. The
/// branches of a vessel that divides have the same numbers here as in Geometry::branches().
struct TubeWaveCase
{
  TubeWaveProblem problem;
  std::function<double(double)> inlet; ///< [Pa] or [m^3/s], into the tube, over time [s]
  bool from_outlet = false;            ///< the load is at the outlet of the body

  /// From a station of the body to its place in the theory [m], and back.
  double place(double station) const { return from_outlet ? problem.length() - station : station; }
  /// +1 if the theory's direction is that from the inlet of the body to its outlet, or -1.
  double direction() const { return from_outlet ? -1. : 1.; }
};

/// Why the case is no tube full of liquid with a wall of solids, or a rigid one; or nothing. The
/// outside may be loaded, supported and held axially. A vessel that divides is a tube, too.
template <int dim>
std::string why_no_tube_of_liquid(const Case<dim> &input);

/// Translates the case; returns why wave theory does not cover it, or nothing.
template <int dim>
std::string make_tube_wave_case(const Case<dim> &input, TubeWaveCase &wave_case);

/// In which direction along a branch of the vessel the first pulse travels, by the ends that are
/// loaded with a pressure or a flow rate: +1 if its positions increase, or -1. Also of a case that
/// theory does not cover; +1 if nothing or both ends are loaded.
template <int dim>
double direction_of_pulse(const Case<dim> &input, unsigned int branch);

/// The condition of a boundary where it meets a region, or null.
template <int dim>
const BoundaryCondition *
find_condition(const Case<dim> &input, const std::string &boundary, unsigned int region);

/// How the wall is held at the end with that boundary's name: clamped, free or absorbing, all its
/// layers alike. `wall_end` stays where there is no wall. Returns why it is none of these, or
/// nothing.
template <int dim>
std::string read_wall_end(const Case<dim> &input, const std::string &boundary, WallEnd &wall_end);

/// The cross-section at z [m] of the case's tube, or of a branch of its vessel, with that law, as
/// waves find it. About a loaded state it is LoadedTube::section_about(), and throws as that does.
template <int dim>
TubeSection tube_section_at(const Case<dim> &input, const TubeLaw &law, double z);

/// The same in the shape of the mesh.
template <int dim>
TubeSection tube_section_of_mesh(const Case<dim> &input, const TubeLaw &law, double z);

/// Sets how the outer surface of a section is held and supported.
void set_hold(const BoundaryCondition &outside, TubeSection &section);
} // namespace Continua

#endif
