#ifndef continua_case_case_h
#define continua_case_case_h

#include <continua/base/command_line.h>
#include <continua/base/expected_value.h>
#include <continua/base/parameter_file.h>
#include <continua/base/quantity_names.h>
#include <continua/case/analysis_traits.h>
#include <continua/case/discretisation.h>
#include <continua/case/harmonic_parameters.h>
#include <continua/case/measured_waves.h>
#include <continua/case/modal_parameters.h>
#include <continua/case/periodic_response_parameters.h>
#include <continua/case/periodic_state_parameters.h>
#include <continua/case/power_laws.h>
#include <continua/case/pulse_response_parameters.h>
#include <continua/case/resonance_parameters.h>
#include <continua/case/theory/absorbing_ends.h>
#include <continua/case/wave_theory_parameters.h>
#include <continua/continuum/problem.h>
#include <continua/mesh/adaptation.h>
#include <continua/mesh/geometry.h>
#include <continua/mesh/mesh_parameters.h>
#include <continua/postprocess/error_norms.h>
#include <continua/postprocess/output_parameters.h>
#include <continua/postprocess/probes.h>
#include <continua/time_integration/time_control.h>

#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace Continua
{
struct NetworkParameters;

/// The entries at the top of a parameter file, which decide what else is read.
struct GeneralParameters
{
  std::string title;
  std::string analysis = "transient";
  std::string model = "plane strain";
  std::string discretisation = "taylor hood";
  std::string convection = "none";
  Deformation deformation = Deformation::small;
  UnloadedShape unloaded_shape = UnloadedShape::mesh;
  MeshMotionKind mesh_motion = MeshMotionKind::hyperelastic;

  /// `analyses`: name and description of those that exist. Throws InputError.
  void read(ParameterSection root,
            const std::vector<std::pair<std::string, std::string>> &analyses);
};

/// What a case is read for.
enum class CaseUse
{
  run,
  restart, ///< a run that goes on from a checkpoint, which holds what the first part has fitted:
           ///< nothing is fitted again
  check    ///< nothing but to find what is wrong with it
};

/// An entry of the file by which responses are differentiated, and what the case is with other
/// values of it.
struct EntryChange
{
  SensitivityEntry entry;
  /// By node of its formula: the problem, and the phases of its loads, see HarmonicParameters.
  std::vector<Problem> problems;
  std::vector<HarmonicParameters> phases;
};

/// How a body is brought to rest.
struct SteadyParameters
{
  double time_step = 1.;        ///< [s]
  bool finds_first_step = true; ///< nobody has given the time step: the first may be any fraction
  /// Largest change of the velocity in a step over the largest velocity of all steps, and of the
  /// state in a static step over the state.
  double tolerance = 1e-8;
  unsigned int maximum_steps = 1000;
  double time_step_growth = 1.; ///< largest ratio of a step to the one before it [1]
  unsigned int load_steps = 1;  ///< in which the loads come
  double time_of_loads = 0.;    ///< [s], of a steady analysis

  /// `with_convection`: the steps grow by themselves.
  void read(ParameterSection section, bool with_convection);
};

/**
 * A parameter file, read and checked: the parameters of each concept, the coarse mesh with the
 * names of its parts, and the physical problem. The constructor finds whatever is wrong with the
 * input and throws an InputError.
 *
 * Reading is not only reading. In this order the constructor also
 * - makes the geometry and the coarse mesh (gmsh may run for that), and moves its vertices where
 *   Mesh/Distortion asks for it; for a check alone, no more than some 100,000 coarse cells of a
 *   geometry that the program knows;
 * - refuses what would need more memory than there is, before it makes the mesh;
 * - reads every table and every mesh that the file names;
 * - fits a law to each relaxation table, and in a transient analysis Prony series to power laws;
 * - computes the profiles of flow rates and the areas of outlets by integrals over the coarse mesh;
 * - in a transient analysis computes the impedance of each absorbing end of a tube at the
 *   frequencies of the run's band, and fits a sum of first-order responses to it, which can take
 *   seconds;
 * - looks for the cell of the coarse mesh that holds each probe.
 *
 * It neither refines the mesh, nor numbers unknowns, nor writes a file.
 */
template <int dim>
struct Case
{
  /// `general`: the entries at the top of the file, which are read already. `analysis`: for which
  /// the case is read; of a study that of its runs.
  Case(ParameterFile &file,
       const GeneralParameters &general,
       const AnalysisTraits<dim> &analysis,
       MPI_Comm communicator,
       CaseUse use);

  MPI_Comm communicator;
  bool restart;
  GeneralParameters general;
  AnalysisTraits<dim> analysis;
  MeshParameters mesh;
  AdaptationParameters adaptation;
  DiscretisationParameters discretisation;
  TimeParameters time;
  SteadyParameters steady;
  PeriodicStateParameters periodic_state; ///< of a run in time
  WaveTheoryParameters wave_theory;
  OutputParameters output;
  std::vector<ExpectedValue> expected;
  /// The lines of Expected that another analysis of the file can have, and this one cannot.
  std::vector<std::string> expected_of_other_analyses;
  /// Columns of the probes, whose values of all steps are kept; known when the probes are checked.
  unsigned int n_histories = 0;
  QuantityNames quantities; ///< that the analysis can state
  ErrorNorms<dim> error_norms;
  Probes<dim> probes;
  std::map<std::string, MeasuredWaves> measured_waves; ///< by the probe whose stations they are at
  std::unique_ptr<Geometry<dim>> geometry;
  MeshExtent extent; ///< of the coarse mesh that a run has
  std::unique_ptr<dealii::parallel::TriangulationBase<dim>> triangulation; ///< coarse
  Problem problem;
  PowerLaws power_laws; ///< what the branches of `problem` come from in a run in time
  std::shared_ptr<const NetworkParameters>
      network;                  ///< at ends of the body in a run in time, or null
  AbsorbingEnds absorbing_ends; ///< what some of its outlets come from in a run in time
  ModalParameters modal;
  HarmonicParameters harmonic;            ///< of a harmonic analysis
  std::vector<EntryChange> entry_changes; ///< of Harmonic/Sensitivities
  ResonanceParameters resonances;
  PeriodicResponseParameters periodic_response;
  PulseResponseParameters pulse_response;

private:
  /// The (boundary, region) pairs that the coarse mesh has.
  std::set<std::pair<unsigned int, unsigned int>> boundary_regions;

  // The parts of the constructor, in their order.
  void read_body(ParameterFile &file); ///< geometry, materials
  void read_equations(ParameterFile &file);
  void read_analysis(ParameterSection root);
  void read_results(ParameterSection root);
  void make_coarse_mesh(const ParameterSection &mesh_section, CaseUse use);
  void read_boundaries(ParameterSection root);
  void prepare_loads(ParameterSection root); ///< profiles, outlets, fits
  void prepare_results(ParameterSection root);
  void prepare_entry_changes(ParameterFile &file);
  void name_all_quantities(ParameterFile &file);

  void read_materials(ParameterSection root, Problem &of_file) const;
  /// The problem of the file with other numbers of materials, boundaries and the body force, on the
  /// same mesh; sets the phases of its loads.
  Problem changed_problem(ParameterFile &changed, HarmonicParameters &phases);
  std::vector<bool> are_regions_solid() const;
};
} // namespace Continua

#endif
