#ifndef continua_case_case_h
#define continua_case_case_h

#include <continua/base/command_line.h>
#include <continua/base/expected_value.h>
#include <continua/base/parameter_file.h>
#include <continua/base/quantity_names.h>
#include <continua/case/absorbing_ends.h>
#include <continua/case/discretisation.h>
#include <continua/case/measured_waves.h>
#include <continua/case/modal_parameters.h>
#include <continua/case/power_laws.h>
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
#include <string>
#include <vector>

namespace Continua
{
/// The entries at the top of a parameter file, which decide what else is read.
struct GeneralParameters
{
  std::string title;
  std::string analysis = "transient";
  std::string model = "plane strain";
  std::string discretisation = "taylor hood";
  std::string convection = "none";

  void read(ParameterSection root);
};

/// How a body of fluid and solid is brought to rest in a steady analysis.
struct RestParameters
{
  double time_step = 1.; ///< [s]
  double tolerance =
      1e-8; ///< largest change of the velocity in a step over the largest velocity of all steps
  unsigned int maximum_steps = 1000;

  void read(ParameterSection section);
};

/**
 * A parameter file, read and checked: every struct of the run, the coarse mesh with its names, and
 * the physical problem. No work is done yet but the coarse mesh; whatever is wrong with the input
 * has been said by an InputError.
 */
template <int dim>
struct Case
{
  /// `restart`: the run goes on from a checkpoint, which has what the first part derived from the
  /// input.
  Case(ParameterFile &file, MPI_Comm communicator, bool restart);

  MPI_Comm communicator;
  bool restart;
  GeneralParameters general;
  MeshParameters mesh;
  AdaptationParameters adaptation;
  DiscretisationParameters discretisation;
  TimeParameters time;
  RestParameters rest;
  WaveTheoryParameters wave_theory;
  OutputParameters output;
  std::vector<ExpectedValue> expected;
  QuantityNames quantities; ///< that a run can state
  ErrorNorms<dim> error_norms;
  Probes<dim> probes;
  std::map<std::string, MeasuredWaves> measured_waves; ///< by the probe whose stations they are at
  std::unique_ptr<Geometry<dim>> geometry;
  std::unique_ptr<dealii::parallel::TriangulationBase<dim>> triangulation; ///< coarse
  Problem problem;
  PowerLaws power_laws;         ///< what the branches of `problem` come from in a run in time
  AbsorbingEnds absorbing_ends; ///< what some of its outlets come from in a run in time
  ModalParameters modal;
};
} // namespace Continua

#endif
