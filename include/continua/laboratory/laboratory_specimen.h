#ifndef continua_laboratory_laboratory_specimen_h
#define continua_laboratory_laboratory_specimen_h

#include <continua/base/log.h>
#include <continua/continuum/discrete_continuum.h>
#include <continua/continuum/problem.h>
#include <continua/signal/expression.h>
#include <continua/time_integration/time_control.h>

#include <deal.II/distributed/tria.h>

#include <memory>
#include <vector>

namespace Continua
{
/**
 * A block of one element, 1 m long and wide, that is pulled along x, free at its sides and without
 * inertia, stepped by the solver of the program. `dim` 2: axisymmetric, a cylinder; 3: a cube.
 * Every rank has a block of its own, so that all of them find the same.
 */
template <int dim>
class LaboratorySpecimen
{
public:
  /// What is given on the face that is pulled, as a function of time: the rate of strain [1/s] or
  /// the stress [Pa].
  enum class Control
  {
    strain_rate,
    stress
  };
  struct Sample
  {
    double time = 0.;   ///< [s]
    double strain = 0.; ///< along the axis [1]
    double stress = 0.; ///< along the axis [Pa]
  };

  /// `material`: a solid with branches. Time and scheme as in a transient analysis.
  LaboratorySpecimen(const Material &material,
                     Control control,
                     const Expression &load,
                     const TimeParameters &time,
                     Log &log);

  bool at_end() const { return time_control.at_end(); }
  /// One time step; the state at its end. Throws RunError.
  Sample advance();
  /// All steps to the end time; the first sample is that of the first step.
  std::vector<Sample> run();

private:
  const TimeParameters parameters;
  TimeControl time_control;
  const std::unique_ptr<dealii::parallel::distributed::Triangulation<dim>> triangulation;
  Problem problem;
  DiscreteContinuum<dim> solver;
  std::vector<double> probes;
};
} // namespace Continua

#endif
