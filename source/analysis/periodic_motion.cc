#include <continua/analysis/periodic_motion.h>

#include <deal.II/base/numbers.h>

#include <complex>

namespace Continua
{
template <int dim>
void PeriodicMotion<dim>::show(const double time)
{
  for (std::size_t k = 0; k < harmonics.size(); ++k)
    harmonics[k].factor = std::polar(1., 2. * dealii::numbers::PI * (k + 1.) * time / period);
  // show_sum() takes one list: the mean stands behind the harmonics meanwhile.
  const std::size_t n_harmonics = harmonics.size();
  harmonics.insert(harmonics.end(), mean.begin(), mean.end());
  system.show_sum(harmonics);
  harmonics.resize(n_harmonics);
}

template class PeriodicMotion<2>;
template class PeriodicMotion<3>;
} // namespace Continua
