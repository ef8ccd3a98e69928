#ifndef continua_theory_tube_wave_theory_h
#define continua_theory_tube_wave_theory_h

#include <continua/theory/tube_chain.h>
#include <continua/theory/tube_wave_problem.h>
#include <continua/theory/wave_model.h>

#include <functional>
#include <vector>

namespace Continua
{
/**
 * The linear waves of a liquid-filled tube in time, by a synthesis of the exact harmonic ones of
 * TubeChain. A tube that divides meets the admittances of its branches, and the traction there
 * drives them; so all reflections between them are there.
 *
 * The transform runs along omega = 2 pi f - i shift: what would wrap round the window is smaller by
 * exp(-shift window). The spectrum is cut where the inlet's has fallen to `spectral_tolerance` of
 * its largest value, or at twice the least ring frequency of a wall (half of it for the formulas of
 * a membrane), with a cosine taper.
 */
class TubeWaveTheory : public WaveModel
{
public:
  using Complex = std::complex<double>;

  /// `inlet`: pressure [Pa] or flow rate [m^3/s] over time [s], zero before t = 0. `end_time` [s]:
  /// histories are wanted up to there. Exact waves are taken from `kept`, if there is one, and left
  /// there. Throws RunError if a wave cannot be followed.
  TubeWaveTheory(const TubeWaveProblem &problem,
                 const std::function<double(double)> &inlet,
                 double end_time,
                 double spectral_tolerance = 1e-5,
                 KeptWaves *kept = nullptr);

  /// What the time of the theory grows with [1].
  struct Work
  {
    double n_roots = 0.;          ///< of the dispersion equations, which are computed
    double n_segment_solves = 0.; ///< of one call of histories(): segments times frequencies
  };
  /// An estimate, in a small part of that time, of a theory made with these arguments.
  static Work work(const TubeWaveProblem &problem,
                   const std::function<double(double)> &inlet,
                   double end_time,
                   double spectral_tolerance);

  WaveSource source() const override { return WaveSource::linear_theory(); }
  std::vector<WaveHistory> histories(const std::vector<double> &stations,
                                     const std::vector<double> &times,
                                     unsigned int branch = 0) const override;

  double highest_frequency() const { return last_frequency; } ///< [Hz] kept of the spectrum
  double window() const { return period; }                    ///< [s]
  /// What of a signal wraps round, relative to its largest value.
  double wrap_round() const;

private:
  double period;                 ///< [s]
  double shift;                  ///< [1/s]
  double last_frequency;         ///< [Hz]
  unsigned int n_samples;        ///< a power of two
  std::vector<Complex> spectrum; ///< of the inlet, up to the last frequency
  /// A tube and the place of the one before it in the list.
  struct Chain
  {
    TubeChain waves;
    double length;      ///< [m]
    std::size_t before; ///< of the first: itself
    bool divides;
  };
  std::vector<Chain> chains; ///< each before its branches

  void add_chains(const TubeWaveProblem &problem, std::size_t before, KeptWaves *kept);
  /// The values at the stations of a chain at a frequency [Hz].
  std::vector<TubeChain::Values> values(double frequency,
                                        const Complex &inlet,
                                        unsigned int chain,
                                        const std::vector<double> &stations) const;
};
} // namespace Continua

#endif
