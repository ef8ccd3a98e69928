#ifndef continua_theory_tube_chain_h
#define continua_theory_tube_chain_h

#include <continua/theory/kept_waves.h>
#include <continua/theory/tube_wave_problem.h>
#include <continua/theory/wave_families.h>

#include <complex>
#include <memory>
#include <utility>
#include <vector>

namespace Continua
{
/**
 * The harmonic waves of a tube that is a chain of uniform segments, at one frequency on the line
 * omega = 2 pi f - i shift: in each segment the pressure wave, the axial wave of the wall and the
 * bending waves run both ways; at a joint of two segments liquid and wall are continuous (traction,
 * flow, displacements, rotation and the wall's forces, with what the liquid does on the step of a
 * taper), at an end they are what it prescribes. Joints and ends are resolved from the far end by
 * reflection matrices (only decaying exponentials occur), so all reflections are there.
 */
class TubeChain
{
public:
  using Complex = std::complex<double>;

  /// The branches of `problem` do not count: see `load` of solve(). Throws RunError if a wave
  /// cannot be followed up to `last_frequency` [Hz]; `shift` in 1/s. Exact waves are taken from
  /// `kept`, if there is one, and left there.
  TubeChain(const TubeWaveProblem &problem,
            double shift,
            double last_frequency,
            KeptWaves *kept = nullptr);
  TubeChain(TubeChain &&) = default;

  /// The segments whose waves are computed; those of the others are theirs, or between them.
  static std::vector<std::size_t> computed_segments(const TubeWaveProblem &problem);

  /// What the waves are at one place.
  struct Values
  {
    Complex pressure;          ///< mean over the liquid's section [Pa]
    Complex axis_pressure;     ///< [Pa]
    Complex flow_rate;         ///< [m^3/s]
    Complex wall_distension;   ///< change of the inner diameter [m]
    Complex wall_shear_stress; ///< of the liquid on the wall, positive downstream [Pa]
    Complex hoop_stress;       ///< mean over the wall's section [Pa]
    Complex traction;          ///< normal, -sigma_zz, mean over the liquid's section [Pa]

    void scale(const Complex &factor);
  };
  /// The waves at one frequency, for a unit of what drives the inlet.
  struct Solution
  {
    std::vector<std::vector<WaveMode>> modes; ///< of each segment
    /// Their amplitudes: forward at the start of a segment, backward at its end.
    std::vector<std::vector<Complex>> forward, backward;
  };
  /// `frequency` in Hz; the inlet has 1 Pa or 1 m^3/s. `load`: traction over flow rate of a divided
  /// outlet [Pa s/m^3].
  Solution solve(double frequency, const Complex &load = 0.) const;
  /// At a place along the tube [m].
  Values values(const Solution &solution, double position) const;

private:
  const TubeWaveProblem problem;
  const double shift;
  std::vector<std::shared_ptr<const WaveFamilies>> waves; ///< of the sections that are computed
  /// Of each segment: sections and weights that its waves are interpolated from.
  std::vector<std::vector<std::pair<std::size_t, double>>> sections_of;

  void compute_sections(double last_frequency, KeptWaves *kept);
  /// The waves of all segments at a frequency [Hz].
  std::vector<std::vector<WaveMode>> modes_at(double frequency) const;
};
} // namespace Continua

#endif
