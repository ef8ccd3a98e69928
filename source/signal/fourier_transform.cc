#include <continua/signal/fourier_transform.h>

#include <continua/signal/gsl_release.h>

#include <gsl/gsl_fft_halfcomplex.h>
#include <gsl/gsl_fft_real.h>

#include <memory>
#include <new>
#include <stdexcept>

namespace Continua
{
namespace
{
using FourierWorkspace =
    std::unique_ptr<gsl_fft_real_workspace,
                    GslRelease<gsl_fft_real_workspace, gsl_fft_real_workspace_free>>;
using RealTable = std::unique_ptr<gsl_fft_real_wavetable,
                                  GslRelease<gsl_fft_real_wavetable, gsl_fft_real_wavetable_free>>;
using HalfComplexTable =
    std::unique_ptr<gsl_fft_halfcomplex_wavetable,
                    GslRelease<gsl_fft_halfcomplex_wavetable, gsl_fft_halfcomplex_wavetable_free>>;
} // namespace

std::vector<std::complex<double>> fourier_transform(const std::vector<double> &samples)
{
  const std::size_t n = samples.size();
  if (n == 0)
    throw std::invalid_argument("there is no sample to transform");
  std::vector<double> data = samples;
  const FourierWorkspace workspace(gsl_fft_real_workspace_alloc(n));
  const RealTable table(gsl_fft_real_wavetable_alloc(n));
  if (!workspace || !table)
    throw std::bad_alloc();
  gsl_fft_real_transform(data.data(), 1, n, table.get(), workspace.get());

  // GSL's order: Re 0, Re 1, Im 1, Re 2, Im 2, ... and for even n at last Re n/2.
  std::vector<std::complex<double>> spectrum(n / 2 + 1);
  spectrum[0] = data[0];
  for (std::size_t k = 1; k <= n / 2; ++k)
    spectrum[k] = {data[2 * k - 1], 2 * k < n ? data[2 * k] : 0.};
  return spectrum;
}

std::vector<double> inverse_fourier_transform(const std::vector<std::complex<double>> &spectrum,
                                              const std::size_t n_samples)
{
  const std::size_t n = n_samples;
  if (n == 0 || spectrum.size() != n / 2 + 1)
    throw std::invalid_argument("the spectrum of n samples has n/2 + 1 entries");
  std::vector<double> data(n);
  data[0] = spectrum[0].real();
  for (std::size_t k = 1; k <= n / 2; ++k)
  {
    data[2 * k - 1] = spectrum[k].real();
    if (2 * k < n)
      data[2 * k] = spectrum[k].imag();
  }
  const FourierWorkspace workspace(gsl_fft_real_workspace_alloc(n));
  const HalfComplexTable table(gsl_fft_halfcomplex_wavetable_alloc(n));
  if (!workspace || !table)
    throw std::bad_alloc();
  gsl_fft_halfcomplex_inverse(data.data(), 1, n, table.get(), workspace.get());
  return data;
}

std::size_t next_power_of_two(const std::size_t n)
{
  std::size_t power = 1;
  while (power < n)
    power *= 2;
  return power;
}
} // namespace Continua
