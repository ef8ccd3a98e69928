#ifndef continua_continuum_discretisation_h
#define continua_continuum_discretisation_h

#include <continua/continuum/continuum_solver.h>
#include <continua/continuum/field_probes.h>
#include <continua/continuum/harmonic_state.h>
#include <continua/continuum/harmonic_system.h>
#include <continua/continuum/operators.h>
#include <continua/continuum/vibration_operator.h>

#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/// A discretisation of the continuum: its operators, and what it knows of its mesh and fields. What
/// a method does is said in ContinuumSolver under the same name.
template <int dim>
class Discretisation : public Operators
{
public:
  virtual const dealii::Mapping<dim> &mapping() const
  {
    return dealii::StaticMappingQ1<dim>::mapping;
  }
  virtual FieldProbes<dim> &probes() = 0;
  /// Takes this rank's solids into the extremes, and sets the sizes of the liquid. Collective.
  virtual void take_motion(const State &state, MotionExtremes &extremes) = 0;
  /// Of a mesh that moves. Collective.
  virtual LiquidMass liquid_mass(const State & /*state*/) { return {}; }
  virtual std::map<std::string, std::string> add_output(const State &state,
                                                        dealii::DataOut<dim> &data_out) = 0;
  /// `port_pressures`: of the outlets' ports, by boundary condition; 0 of others [Pa]. `time` [s].
  virtual void indicators(const IndicatorRequest &request,
                          const State &state,
                          const std::vector<double> &port_pressures,
                          double time,
                          dealii::Vector<float> &per_cell) = 0;
  virtual double error_norm(const State &state,
                            ComparedField field,
                            const std::vector<Expression> &exact,
                            double time) = 0;
  virtual void report_corrections(const std::function<void(const LoopCorrection &)> & /*sink*/) {}
  /// `state` is changed by VibrationOperator::set_shape().
  virtual std::unique_ptr<VibrationOperator<dim>> vibration(const VibratingState &state) = 0;
  /// `state` is changed by HarmonicSystem::show().
  virtual std::unique_ptr<HarmonicSystem<dim>> harmonic_system(const HarmonicState & /*state*/)
  {
    return nullptr;
  }
};
} // namespace Continua

#endif
