#ifndef continua_theory_tube_wave_theory_h
#define continua_theory_tube_wave_theory_h

#include <continua/theory/closed_form_waves.h>
#include <continua/theory/impedance.h>
#include <continua/theory/wall_end.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/// A piece of a tube that wave theory takes for uniform.
struct TubeSegment
{
  double length = 0.; ///< [m]
  TubeSection section;
};

/// A tube with its ends.
struct TubeWaveProblem
{
  enum class Inlet
  {
    pressure, ///< normal traction -p on the liquid's section [Pa]
    flow_rate ///< into the tube [m^3/s]
  };
  enum class Outlet
  {
    closed,  ///< no flow
    open,    ///< no traction
    matched, ///< the pressure wave's own impedance: it leaves, but for what the wall's end demands
    absorbing, ///< what a long tube behind would do: no pressure wave comes back, and where the
               ///< wall's end is absorbing too, none at all
    loaded     ///< a given impedance, such as that of branches
  };
  WaveLevel level = WaveLevel::exact;
  std::vector<TubeSegment> segments;
  /// In a chain of more segments of different sections, exact waves are computed for so many of
  /// them (the first and the last one among them) and interpolated along the chain between these.
  unsigned int n_computed_sections = 6;
  Inlet inlet = Inlet::pressure;
  Outlet outlet = Outlet::closed;
  Impedance load; ///< traction over flow rate of a loaded outlet; one port
  WallEnd wall_inlet_end = WallEnd::clamped;
  WallEnd wall_outlet_end = WallEnd::clamped;

  double length() const; ///< [m]
};

/// What wave theory says at one station over time.
struct WaveHistory
{
  std::vector<double> pressure;          ///< mean over the liquid's section [Pa]
  std::vector<double> axis_pressure;     ///< [Pa]
  std::vector<double> flow_rate;         ///< [m^3/s]
  std::vector<double> wall_distension;   ///< change of the inner diameter [m]
  std::vector<double> wall_shear_stress; ///< of the liquid on the wall, positive downstream [Pa]
  std::vector<double> hoop_stress;       ///< mean over the wall's section [Pa]
};

/**
 * The linear waves of a liquid-filled tube in time, by a synthesis of the exact harmonic ones: in
 * each uniform segment the pressure wave, the axial wave of the wall and the bending waves run both
 * ways; at a joint of two segments liquid and wall are continuous (traction, flow, displacements,
 * rotation and the wall's forces, with what the liquid does on the step of a taper), at an end they
 * are what it prescribes. Joints and ends are resolved from the far end by reflection matrices
 * (only decaying exponentials occur), so all reflections are there.
 *
 * The transform runs along omega = 2 pi f - i shift: what would wrap round the window is smaller by
 * exp(-shift window). The spectrum is cut where the inlet's has fallen to `spectral_tolerance` of
 * its largest value, or at twice the ring frequency of the wall (half of it for the formulas of a
 * membrane), with a cosine taper.
 */
class TubeWaveTheory
{
public:
  using Complex = std::complex<double>;

  /// `inlet`: pressure [Pa] or flow rate [m^3/s] over time [s], zero before t = 0. `end_time` [s]:
  /// histories are wanted up to there. Throws RunError if a wave cannot be followed.
  TubeWaveTheory(const TubeWaveProblem &problem,
                 const std::function<double(double)> &inlet,
                 double end_time,
                 double spectral_tolerance = 1e-5);

  /// The histories at the stations z [m] at these times [s].
  std::vector<WaveHistory> histories(const std::vector<double> &stations,
                                     const std::vector<double> &times) const;

  double highest_frequency() const { return last_frequency; } ///< [Hz] kept of the spectrum
  double window() const { return period; }                    ///< [s]
  /// What of a signal wraps round, relative to its largest value.
  double wrap_round() const;

private:
  /// Amplitudes of the waves of each segment at one frequency: forward at its start, backward at
  /// its end.
  struct Amplitudes
  {
    std::vector<std::vector<Complex>> forward, backward;
  };
  TubeWaveProblem problem;
  double period;                                    ///< [s]
  double shift;                                     ///< [1/s]
  double last_frequency;                            ///< [Hz]
  unsigned int n_samples;                           ///< a power of two
  std::vector<Complex> spectrum;                    ///< of the inlet, up to the last frequency
  std::vector<std::unique_ptr<WaveFamilies>> waves; ///< of the sections that are computed
  /// Of each segment: sections and weights that its waves are interpolated from.
  std::vector<std::vector<std::pair<std::size_t, double>>> sections_of;

  std::vector<Complex> transform_inlet(const std::function<double(double)> &inlet,
                                       double end_time) const;
  void compute_sections();
  /// The waves of all segments at a frequency [Hz].
  void evaluate(double frequency, std::vector<std::vector<WaveMode>> &modes) const;

  Amplitudes
  amplitudes(Complex inlet, const std::vector<std::vector<WaveMode>> &modes, Complex omega) const;
};
} // namespace Continua

#endif
