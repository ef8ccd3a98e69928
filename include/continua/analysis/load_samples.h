#ifndef continua_analysis_load_samples_h
#define continua_analysis_load_samples_h

#include <continua/continuum/harmonic_system.h>

#include <mpi.h>

#include <complex>
#include <cstddef>
#include <vector>

namespace Continua
{
/**
 * The loads of a file over time, as few shapes in space with a history each: at every time the load
 * is the sum of factors times shapes. Forces, prescribed velocities and pressures of ports have
 * shapes of their own. Shapes are found one after the other: what is left of a load after all
 * shapes so far, if it is more than round-off, is a further one.
 */
template <int dim>
class LoadSamples
{
public:
  using Complex = std::complex<double>;

  /// `times` [s]. Collective.
  LoadSamples(const HarmonicSystem<dim> &system,
              const std::vector<double> &times,
              MPI_Comm communicator);

  std::size_t n_shapes() const { return shapes.size(); }
  /// The factors of a shape, by time [1].
  const std::vector<double> &factors(const std::size_t shape) const { return histories[shape]; }
  /// The sum of all shapes, each times its number.
  HarmonicLoad sum(const std::vector<Complex> &amplitudes) const;

private:
  using Values = std::vector<Complex>;
  /// One of the vectors of a load: its shapes, and its largest sample so far.
  struct Part
  {
    Values HarmonicLoad::*values;
    bool is_of_ranks; ///< each rank has its own entries; else all have all
    std::vector<std::size_t> shapes;
    double largest;
  };
  MPI_Comm communicator;
  std::size_t n_times;
  std::vector<HarmonicLoad> shapes;           ///< each has one part, of length one
  std::vector<std::vector<double>> histories; ///< by shape, by time

  void add(const HarmonicLoad &sample, std::size_t time, Part &part);
  double product(const Values &a, const Values &b, const Part &part) const;
};
} // namespace Continua

#endif
