#include <continua/analysis/load_samples.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Continua
{
namespace
{
/// Of the largest load so far, below which what the shapes do not have is round-off.
constexpr double round_off_of_load = 1e-12;
} // namespace

template <int dim>
LoadSamples<dim>::LoadSamples(const HarmonicSystem<dim> &system,
                              const std::vector<double> &times,
                              const MPI_Comm communicator)
    : communicator(communicator), n_times(times.size())
{
  for (const HarmonicLoadSource &source : system.sources())
  {
    std::array<Part, 3> parts = {{{&HarmonicLoad::forces, true, {}, 0.},
                                  {&HarmonicLoad::velocities, true, {}, 0.},
                                  {&HarmonicLoad::ports, false, {}, 0.}}};
    const std::size_t first = shapes.size();
    for (std::size_t j = 0; j < (source.depends_on_time ? n_times : 1); ++j)
    {
      const HarmonicLoad sample = system.load_of(source, times[j]);
      for (Part &part : parts)
        add(sample, j, part);
    }
    // One sample stands for all times.
    for (std::size_t k = first; k < shapes.size() && !source.depends_on_time; ++k)
      histories[k].assign(n_times, histories[k][0]);
  }
}

template <int dim>
double LoadSamples<dim>::product(const Values &a, const Values &b, const Part &part) const
{
  double sum = 0.;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += a[i].real() * b[i].real();
  return part.is_of_ranks ? dealii::Utilities::MPI::sum(sum, communicator) : sum;
}

template <int dim>
void LoadSamples<dim>::add(const HarmonicLoad &sample, const std::size_t time, Part &part)
{
  Values left = sample.*part.values;
  part.largest = std::max(part.largest, std::sqrt(product(left, left, part)));
  if (!(part.largest > 0.))
    return;
  for (const std::size_t k : part.shapes)
  {
    const Values &shape = shapes[k].*part.values;
    const double factor = product(shape, left, part);
    histories[k][time] = factor;
    for (std::size_t i = 0; i < left.size(); ++i)
      left[i] -= factor * shape[i];
  }
  const double size = std::sqrt(product(left, left, part));
  if (size <= round_off_of_load * part.largest)
    return;
  for (Complex &value : left)
    value /= size;
  part.shapes.push_back(shapes.size());
  HarmonicLoad shape;
  shape.*part.values = left;
  shapes.push_back(shape);
  histories.emplace_back(n_times, 0.);
  histories.back()[time] = size;
}

template <int dim>
HarmonicLoad LoadSamples<dim>::sum(const std::vector<Complex> &amplitudes) const
{
  HarmonicLoad result;
  for (std::size_t k = 0; k < shapes.size(); ++k)
    result.add(amplitudes.at(k), shapes[k]);
  return result;
}

template class LoadSamples<2>;
template class LoadSamples<3>;
} // namespace Continua
