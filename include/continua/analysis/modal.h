#ifndef continua_analysis_modal_h
#define continua_analysis_modal_h

#include <continua/analysis/rigid_motions.h>
#include <continua/analysis/run.h>
#include <continua/continuum/vibration_operator.h>
#include <continua/linear_algebra/eigenpairs.h>

#include <complex>
#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/// What a mode of vibration is like. Shapes have 1 m at their largest component.
struct Mode
{
  std::complex<double> eigenvalue; ///< omega^2 [1/s^2]
  double residual = 0.;            ///< relative, of the eigenvalue problem
  double frequency = 0.;           ///< [Hz]
  double growth_rate = 0.; ///< of exp(growth_rate t) [1/s]: 0 where the operator is symmetric
  double mass = 0.;        ///< x* M x [kg]
  double energy = 0.;      ///< elastic, of the real part [J]
  std::vector<double> direction_shares; ///< of the kinetic energy, by Cartesian direction
  /// By rigid motion r: x* M r / (x* M x), and |x* M r|^2 / (x* M x) over that of the whole body.
  std::vector<double> participations, inertia_shares;
};

/**
 * Free, undamped vibrations of a solid body: frequencies, shapes and what takes part in them.
 * modes.csv has a row for each, with the probes' values of its shape; fields.pvd lists the shapes
 * under the modes' numbers, and the imaginary part of a complex one half a number behind.
 */
template <int dim>
class Modal
{
public:
  explicit Modal(Run<dim> &run) : run(run) {}
  void perform();

  /// Free vibrations are those of elastic solids that give no energy away. Throws InputError.
  static void check(const Case<dim> &input, ParameterSection root);
  static void name_quantities(const Case<dim> &input, QuantityNames &names);

private:
  Run<dim> &run;
  std::unique_ptr<VibrationOperator<dim>> vibration;
  std::vector<RigidMotion<dim>> motions;
  std::vector<std::vector<double>> momenta; ///< M r of the motions
  std::vector<unsigned int> directions;     ///< of the unknowns
  double shift = 0.;                        ///< [1/s^2]

  void prepare();
  /// Throws Interrupted if a signal asks for it.
  void stop_if_asked(const std::string &phase) const;
  std::vector<Eigenpair> solve();
  Mode describe(const Eigenpair &pair, bool is_symmetric) const;
  /// "Mode 2: 3.2155 Hz, moves along y: ...".
  std::string text_of(unsigned int number, const Mode &mode) const;
  std::vector<std::string> header() const;
  std::vector<double> row(unsigned int number, const Mode &mode) const;
  void add_quantities(unsigned int number, const Mode &mode);
};
} // namespace Continua

#endif
