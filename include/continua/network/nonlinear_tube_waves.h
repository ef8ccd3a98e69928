#ifndef continua_network_nonlinear_tube_waves_h
#define continua_network_nonlinear_tube_waves_h

#include <continua/network/network.h>
#include <continua/theory/tube_wave_problem.h>
#include <continua/theory/wave_model.h>

#include <functional>
#include <string>
#include <vector>

namespace Continua
{
/**
 * One-dimensional nonlinear theory of the tube that linear wave theory takes (TubeWaveProblem): a
 * Network of one vessel, or of a parent and the vessels into which it divides. The liquid has the
 * friction of Womersley's flow, the walls are those of TubeWall, so that small and long waves are
 * those of the level `womersley` (its thin wall for the levels of thin walls, else a thick one).
 * The sections of the problem are those without load; between the middles of its segments radius
 * and thicknesses are linear. How the ends of the walls are held has no place in one dimension.
 */
class NonlinearTubeWaves : public WaveModel
{
public:
  struct Settings
  {
    double cell_length = 0.;     ///< of the cells at most [m]
    double mean_pressure = 0.;   ///< about which all pressures and flow rates count [Pa]
    double courant_number = 0.8; ///< [1]
  };

  /// `inlet`: pressure [Pa] or flow rate [m^3/s] over time [s]. The load of an outlet has to be a
  /// resistance or a windkessel. Throws std::domain_error with the reason, a predicate of the tube
  /// ("has ..."), if there is no such theory of the problem.
  NonlinearTubeWaves(const TubeWaveProblem &problem,
                     const std::function<double(double)> &inlet,
                     const Settings &settings);

  WaveSource source() const override { return WaveSource::nonlinear_theory(); }
  /// Each call computes all waves from the start. After the time at which the theory has no state
  /// the values are NaN, and WaveHistory::end says when and why.
  std::vector<WaveHistory> histories(const std::vector<double> &stations,
                                     const std::vector<double> &times,
                                     unsigned int branch) const override;

  unsigned int n_cells() const; ///< of all vessels

private:
  // NOLINTNEXTLINE(bugprone-exception-escape): deal.II's matrix may throw when it is moved
  struct Tube
  {
    TubeWaveProblem problem;
    unsigned int from, to; ///< nodes
    unsigned int n_cells;
  };
  std::vector<Tube> tubes; ///< each before its branches
  std::function<double(double)> inlet;
  Settings settings;

  void add(const TubeWaveProblem &problem, unsigned int from);
  Network make() const;
};
} // namespace Continua

#endif
