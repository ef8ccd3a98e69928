#ifndef continua_case_before_the_run_preflight_input_h
#define continua_case_before_the_run_preflight_input_h

#include <continua/case/case.h>
#include <continua/theory/tube_section.h>
#include <continua/time_integration/step.h>

#include <array>
#include <string>
#include <vector>

namespace Continua
{
/// What the pre-flight report is computed from.
struct PreflightInput
{
  /// One region of the body.
  struct Region
  {
    std::string name;
    Material material;
    double largest_cell = 0.;  ///< longest extent of a cell along an axis [m]
    double smallest_cell = 0.; ///< shortest edge of a cell [m]
  };
  /// One end of a tube.
  struct End
  {
    TubeSection section;
    std::string boundary;       ///< name of the fluid's boundary there
    bool flow_is_given = false; ///< the velocity along the axis is prescribed, else the pressure
    std::shared_ptr<const Outlet> outlet; ///< of the whole tube; null if there is none
    bool wall_is_clamped = false;
    bool rim_is_held = false; ///< by the section of the liquid, whose velocity along it is given
    double wall_cell = 0.;    ///< largest axial extent of the wall's cells there [m]
  };

  std::vector<Region> regions;
  unsigned int velocities_per_cell = 2; ///< along an edge
  Step step;                            ///< the regular one of the scheme
  double end_time = 0.;                 ///< [s]

  std::string load;      ///< name of the boundary whose load varies; empty if none does
  double frequency = 0.; ///< [Hz] of that load (energy_frequency); 0: none
  bool load_jumps = false;

  bool is_tube = false;
  bool starts_loaded = false; ///< of a wall in finite deformation: the sections are without load
  std::array<End, 2> ends;    ///< of a tube: where the load is, and the far one
  double length = 0.;         ///< [m]
  double axial_cell = 0.;     ///< largest axial extent of the fluid's cells [m]
  double normal_cell = 0.;    ///< largest thickness of the fluid's cells at the wall [m]
};

/// Whether the case has both a fluid and a solid.
template <int dim>
bool has_fluid_and_solid(const Case<dim> &input);

/**
 * Collects it from a transient case. Sizes are those of the coarse cells divided by 2 for each
 * refinement of Mesh/Refinements; an adaptive mesh may have smaller ones. The load is the first
 * condition of the file on a fluid's boundary (else on any) that depends on time. Its component
 * that varies most, in the middle of the boundary, is sampled over the run, four times a step.
 */
template <int dim>
PreflightInput preflight_input(const Case<dim> &input);
} // namespace Continua

#endif
