#include <continua/program/analyses.h>

#include <continua/analysis/analysis_of_case.h>
#include <continua/analysis/harmonic.h>
#include <continua/analysis/linear_wave_theory.h>
#include <continua/analysis/modal.h>
#include <continua/analysis/periodic_response.h>
#include <continua/analysis/pulse_response.h>
#include <continua/analysis/resonances.h>
#include <continua/analysis/steady.h>
#include <continua/analysis/transient.h>
#include <continua/laboratory/amplification_analysis.h>
#include <continua/laboratory/artery_fit.h>
#include <continua/laboratory/material_fit.h>
#include <continua/laboratory/material_laboratory.h>
#include <continua/laboratory/nonlinear_wave_theory.h>
#include <continua/laboratory/spin_coating_analysis.h>
#include <continua/studies/comparison.h>
#include <continua/studies/identification.h>
#include <continua/studies/refinement_study.h>
#include <continua/studies/sweep.h>

namespace Continua
{
namespace
{
template <typename Type>
std::unique_ptr<Analysis> make_analysis(const AnalysisInput &input)
{
  return std::make_unique<Type>(input);
}

/// A row without a case of its own.
template <typename Type>
AnalysisRow row_of(const std::string &name,
                   const std::string &description,
                   const std::vector<std::string> &sections)
{
  AnalysisRow row;
  row.name = name;
  row.description = description;
  row.sections = sections;
  row.make = make_analysis<Type>;
  return row;
}

/// A row of a study, with the parameters of its section.
template <typename Type, typename Parameters>
AnalysisRow
row_of_study(const std::string &name, const std::string &description, const std::string &section)
{
  AnalysisRow row = row_of<Type>(name, description, {section});
  row.read_section = [](ParameterSection root) { Parameters().read(root); };
  return row;
}
/// The row of the sweep, whose runs may be of any analysis but a study.
AnalysisRow row_of_sweep()
{
  AnalysisRow row =
      row_of_study<Sweep, SweepParameters>("sweep",
                                           "The same file for several values of its entries, side "
                                           "by side: one table, and curves or maps.",
                                           "Sweep");
  row.performs_any = true;
  return row;
}

/// The row of the periodic response, which passes over what Expected says of a run in time of the
/// same file.
AnalysisRow row_of_periodic_response()
{
  AnalysisRow row = row_of_case<PeriodicResponse>(
      "periodic response",
      "The state that periodic loads lead to after many periods, by its harmonics and without "
      "steps in time.",
      {"Periodic response", "Periodic state", "Steady", "Time", "Wall directions", "Network"},
      Motion::harmonic, true, false);
  row.traits_2d.name_quantities_of_others = &Transient<2>::name_quantities;
  row.traits_3d.name_quantities_of_others = &Transient<3>::name_quantities;
  return row;
}

/// The row of the pulse response, likewise.
AnalysisRow row_of_pulse_response()
{
  AnalysisRow row = row_of_case<PulseResponse>(
      "pulse response",
      "Motion of a linear body from rest under loads that vary in time, without steps in time.",
      {"Pulse response", "Time", "Network"}, Motion::harmonic, true, false);
  row.traits_2d.name_quantities_of_others = &Transient<2>::name_quantities;
  row.traits_3d.name_quantities_of_others = &Transient<3>::name_quantities;
  return row;
}

/// The row of the theory, which passes over what Expected says of a run of the same file.
AnalysisRow row_of_theory()
{
  AnalysisRow row = row_of_case<LinearWaveTheory>(
      "linear wave theory", "Linear waves of a tube at its stations, without a mesh.",
      {"Time", "Periodic state", "Adaptivity", "Wave theory", "Network", "Exact solution"},
      Motion::in_time, false, false);
  row.traits_2d.name_quantities_of_others = &Transient<2>::name_quantities;
  row.traits_3d.name_quantities_of_others = &Transient<3>::name_quantities;
  return row;
}
} // namespace

const AnalysisTable &analyses()
{
  // The flags of a case: whether it has fields, and checkpoints.
  static const AnalysisTable table(
      {row_of_case<Transient>("transient", "Steps through time.",
                              {"Time", "Steady", "Periodic state", "Adaptivity", "Wall directions",
                               "Wave theory", "Network", "Exact solution"},
                              Motion::in_time, true, true),
       row_of_case<Steady>("steady",
                           "State at rest: one solve for a body that is all solid or all fluid, "
                           "steps to a steady state for "
                           "a mixture.",
                           {"Steady", "Adaptivity", "Wall directions", "Network", "Exact solution"},
                           Motion::steady, true, false),
       row_of_case<Modal>("modal", "Frequencies and shapes of a solid body's free vibrations.",
                          {"Modal", "Network"}, Motion::vibrating, true, false),
       row_of_case<Harmonic>("harmonic",
                             "Motion at given frequencies, of a linear body or a small one about a "
                             "loaded state: responses, impedances, mean powers.",
                             {"Harmonic", "Steady", "Wall directions", "Network"}, Motion::harmonic,
                             true, false),
       row_of_case<Resonances>("resonances",
                               "Frequencies, damping and shapes of the free motions of solids and "
                               "liquids together.",
                               {"Resonances", "Steady", "Wall directions", "Network"},
                               Motion::harmonic, true, false),
       row_of_periodic_response(), row_of_pulse_response(), row_of_theory(),
       row_of_study<Comparison, ComparisonParameters>(
           "comparison",
           "The same case by both discretisations on several meshes: orders, limits and whether "
           "they agree.",
           "Comparison"),
       row_of_study<RefinementStudy, RefinementStudyParameters>(
           "refinement study",
           "The same case on finer and finer meshes, uniform and adaptive: errors, orders and what "
           "they cost.",
           "Refinement study"),
       row_of_study<Identification, IdentificationParameters>(
           "identification",
           "Numbers of the file, such as the modulus of a wall, from what was measured at "
           "stations, "
           "with their errors; or the errors that an experiment would give.",
           "Identification"),
       row_of_sweep(),
       row_of<SpinCoatingAnalysis>("spin coating",
                                   "How a tube is made: what the motors do along the rod.",
                                   {"Spin coating"}),
       row_of<MaterialLaboratory>(
           "material", "What a solid is like: its complex modulus, and simulated material tests.",
           {"Laboratory", "Time"}),
       row_of<MaterialFit>(
           "material fit",
           "The law of a solid from tables of relaxation, creep, storage and loss modulus.",
           {"Material fit"}),
       row_of<ArteryFit>(
           "artery fit",
           "Layers, fibres and opening angle of an artery from an inflation-extension test.",
           {"Artery fit"}),
       row_of<AmplificationAnalysis>(
           "amplification",
           "What schemes in time do to waves: damping and speed by Courant number and wavelength.",
           {"Amplification"}),
       row_of<NonlinearWaveTheory>(
           "nonlinear wave theory",
           "Waves of finite height in one dimension: vessels, networks of them, and what stands at "
           "their ends.",
           {"Network"})});
  return table;
}
} // namespace Continua
