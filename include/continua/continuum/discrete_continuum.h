#ifndef continua_continuum_discrete_continuum_h
#define continua_continuum_discrete_continuum_h

#include <continua/base/log.h>
#include <continua/continuum/discretisation.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/time_stepping.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Continua
{
/// The continuum on a discretisation, which steps through time: the one solver there is.
template <int dim>
class DiscreteContinuum : public ContinuumSolver<dim>
{
public:
  /// `problem` and `log` must outlive the solver.
  DiscreteContinuum(std::unique_ptr<Discretisation<dim>> discretisation,
                    const Problem &problem,
                    Log &log);

  void initialise() override;
  void stop_solids() override { stepping.stop_solids(); }
  void start_from_present_state() override { stepping.start_from_present_state(); }
  void begin_unloaded_shape() override { stepping.begin_unloaded_shape(); }
  void keep_unloaded_shape() override { stepping.keep_unloaded_shape(); }
  StepReport advance(const Step &step) override { return stepping.advance(step); }
  void report_corrections(const std::function<void(const LoopCorrection &)> &sink) override
  {
    discretisation->report_corrections(sink);
  }
  void solve_steady(const double time) override { stepping.solve_steady(time); }
  bool steady_is_direct() const override { return stepping.steady_is_direct(); }
  std::unique_ptr<VibrationOperator<dim>> vibration() override;
  std::unique_ptr<HarmonicSystem<dim>> harmonic_system() override;
  void begin_averages() override { stepping.begin_averages(); }
  void add_to_averages(const double duration) override { stepping.add_to_averages(duration); }
  StepError step_error() override { return stepping.step_error(); }
  void keep_state() override { stepping.keep_state(); }
  void return_to_kept_state() override { stepping.return_to_kept_state(); }
  bool data_jump(const double begin, const double end) const override
  {
    return stepping.data_jumps(begin, end);
  }
  std::vector<FieldComponent> fields() const override;
  unsigned int add_probe(const ProbeRequest<dim> &request) override;
  void evaluate_probes(std::vector<double> &values) override;
  PowerBalance power_balance(const bool relaxation) override
  {
    return stepping.power_balance(relaxation);
  }
  const Network *network() override { return stepping.network(); }
  Energy energy() override { return stepping.energy(); }
  double divergence() override;
  MotionExtremes motion_extremes() override;
  LiquidMass liquid_mass() override { return discretisation->liquid_mass(stepping.state()); }
  const dealii::Mapping<dim> &mapping() const override { return discretisation->mapping(); }
  std::map<std::string, std::string> add_output(dealii::DataOut<dim> &data_out) override;
  void indicators(const IndicatorRequest &request, dealii::Vector<float> &per_cell) override;
  void prepare_refinement() override { stepping.prepare_refinement(); }
  void transfer() override;
  void save(ArchiveWriter &archive) const override { stepping.save(archive); }
  void load(const ArchiveReader &archive) override { stepping.load(archive); }
  double
  error_norm(ComparedField field, const std::vector<Expression> &exact, double time) override;
  SolverSizes sizes() const override { return discretisation->sizes(); }

private:
  const Problem &problem;
  std::unique_ptr<Discretisation<dim>> discretisation;
  TimeStepping stepping;
  /// Local indices of the velocities of liquids on the present mesh, once they are asked for.
  std::optional<std::vector<unsigned int>> velocities_of_liquids;
};
} // namespace Continua

#endif
