#ifndef continua_postprocess_output_parameters_h
#define continua_postprocess_output_parameters_h

#include <continua/base/parameter_section.h>
#include <continua/continuum/problem.h>
#include <continua/postprocess/schedule.h>

namespace Continua
{
/// The section Output: what a run writes, and how often.
struct OutputParameters
{
  double probe_interval = 0.;          ///< [s]; 0: every step
  double power_interval = 0.;          ///< [s]; 0: every step
  double field_interval = 0.;          ///< [s]; 0: none between start and end
  bool final_fields = true;            ///< whether the state at the end is drawn in any case
  double checkpoint_interval = 0.;     ///< [s]; 0: none
  unsigned int checkpoint_steps = 0;   ///< 0: none
  double checkpoint_wall_time = 1800.; ///< [s]; 0: none
  bool checkpoint_at_end = false;
  unsigned int subdivisions = 0; ///< of a cell in each direction in the fields; 0: as below
  bool higher_order_cells = false;
  unsigned int files_per_state = 0; ///< in the fields; 0: one a rank
  FurtherFields further_fields;
  /// Of the means over time; whether they are kept is not known here.
  WallShearWindow wall_shear_window;

  /// Declares and reads; throws InputError.
  void read(ParameterSection section);

  /// The subdivisions for elements of this degree: as many as the degree unless the user says
  /// otherwise.
  unsigned int subdivisions_for(unsigned int element_degree) const;

  /// When to write what, in a run that ends at `end_time` [s].
  Schedule probe_schedule(double end_time) const;
  Schedule power_schedule(double end_time) const;
  /// Every step.
  Schedule step_schedule(double end_time) const;
  Schedule field_schedule(double end_time) const;
  Schedule checkpoint_schedule(double end_time) const;
};
} // namespace Continua

#endif
