#ifndef continua_tests_inference_random_noise_h
#define continua_tests_inference_random_noise_h

#include <continua/signal/gsl_release.h>

#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>

#include <memory>
#include <vector>

/// Noise that is the same on each machine.
class RandomNoise
{
public:
  explicit RandomNoise(const unsigned long seed) : generator(gsl_rng_alloc(gsl_rng_mt19937))
  {
    gsl_rng_set(generator.get(), seed);
  }
  double normal() { return gsl_ran_gaussian_ziggurat(generator.get(), 1.); }
  std::vector<double> white(const unsigned int n)
  {
    std::vector<double> values(n);
    for (double &value : values)
      value = normal();
    return values;
  }
  /// Innovations of standard deviation 1, after 500 values that are left out.
  std::vector<double> autoregressive(const std::vector<double> &coefficients, const unsigned int n)
  {
    std::vector<double> values = white(n + 500);
    for (std::size_t i = 0; i < values.size(); ++i)
      for (std::size_t j = 0; j < coefficients.size() && j < i; ++j)
        values[i] += coefficients[j] * values[i - 1 - j];
    return {values.end() - n, values.end()};
  }

private:
  std::unique_ptr<gsl_rng, Continua::GslRelease<gsl_rng, gsl_rng_free>> generator;
};

#endif
