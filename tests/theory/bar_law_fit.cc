// Laws from tables of a bar: the constants that made them, the number of branches, the criterion by
// hand, and what no table tells.

#include <continua/theory/bar_law_fit.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "../unit_test.h"

namespace test_of_bar_law_fit
{
using namespace Continua;

namespace
{
/// What a law shows, with noise of a share of each value.
BarRecord record_of(const BarLaw &law,
                    const std::vector<double> &constants,
                    const BarQuantity quantity,
                    const double noise,
                    const double loading_time = 0.)
{
  std::mt19937 generator(1);
  std::normal_distribution<double> normal;
  BarRecord record;
  record.quantity = quantity;
  record.loading_time = loading_time;
  record.is_logarithmic = quantity != BarQuantity::modulus;
  for (unsigned int i = 0; i < 40; ++i)
    for (unsigned int j = 0; j < (quantity == BarQuantity::modulus ? 2 : 1); ++j)
      record.abscissae.push_back((quantity == BarQuantity::modulus ? 1e-3 : 0.11) *
                                 std::pow(10., i / 13.));
  record.values = record.predicted(law.material(constants));
  for (std::size_t i = 0; i < record.values.size(); ++i)
  {
    const double size = quantity == BarQuantity::modulus
                            ? std::hypot(record.values[i - i % 2], record.values[i - i % 2 + 1])
                            : record.values[i];
    record.noise_units.push_back(size);
  }
  for (std::size_t i = 0; i < record.values.size(); ++i)
    record.values[i] += noise * record.noise_units[i] * normal(generator);
  return record;
}

void compare(const std::string &name,
             const BarLawFit &fit,
             const std::vector<double> &constants,
             const double tolerance)
{
  for (std::size_t k = 0; k < constants.size(); ++k)
    check::relative(name + ": " + fit.parameters[k].name, fit.result.estimates[k], constants[k],
                    tolerance);
}

/// Within four standard errors, which are not wide.
void compare_by_errors(const std::string &name,
                       const BarLawFit &fit,
                       const std::vector<double> &constants,
                       const double widest)
{
  for (std::size_t k = 0; k < constants.size(); ++k)
  {
    check::absolute(name + ": " + fit.parameters[k].name, fit.result.estimates[k], constants[k],
                    4. * fit.result.standard_errors[k]);
    check::is_true(name + ": standard error of " + fit.parameters[k].name,
                   fit.result.standard_errors[k] < widest * constants[k]);
  }
}
} // namespace

UNIT_TEST(bar_law_fit)
{
  const std::shared_ptr<const BarLaw> prony = make_series_of_bar(0.5, 2);
  const std::vector<double> series = {4e5, 80e3 / 3., 50e3, 10., 0.5};
  // Exact tables.
  for (const auto &[name, quantity, loading_time] :
       {std::make_tuple("relaxation", BarQuantity::relaxation, 0.1),
        std::make_tuple("step", BarQuantity::relaxation, 0.),
        std::make_tuple("creep", BarQuantity::creep, 0.),
        std::make_tuple("moduli", BarQuantity::modulus, 0.)})
  {
    const std::vector<BarRecord> records = {record_of(*prony, series, quantity, 0., loading_time)};
    for (const BarLawStart &start : starts_of_prony(0.5, records, 8))
      if (start.law->n_branches() == 2)
        compare(std::string("exact ") + name, fit_bar_law(start, records), series, 1e-5);
    const std::vector<BarRecord> noisy = {record_of(*prony, series, quantity, 0.003, loading_time)};
    const std::vector<BarLawFit> fits = fit_prony_series_to_bar(0.5, noisy, 8);
    check::equal(std::string("noisy ") + name + ": branches",
                 std::to_string(simplest_of(fits).law->n_branches()), "2");
    compare_by_errors(std::string("noisy ") + name, simplest_of(fits), series, 0.06);
    // The criterion by hand: n ln(sum of the squares/n) + constants ln n.
    double sum = 0.;
    const RecordFit &record = simplest_of(fits).result.records[0];
    for (const double residual : record.residuals)
      sum += residual * residual;
    const double n = record.residuals.size();
    check::relative(std::string("noisy ") + name + ": criterion", simplest_of(fits).criterion,
                    n * std::log(sum / n) + 5. * std::log(n), 1e-12);
    // A power law that is forced onto them.
    const BarLawFit line = fit_bar_law(start_of_scan(make_bar_law("power law"), noisy), noisy);
    check::is_true(std::string("noisy ") + name + ": a power law is very clearly worse",
                   line.criterion - simplest_of(fits).criterion > clear_difference &&
                       line.misfits[0] > 0.006);
  }
  // Laws with one time or exponent.
  const std::vector<std::pair<std::string, std::vector<double>>> laws = {
      {"kelvin-voigt", {4e5, 3e4}}, {"maxwell", {1e5, 5.}}, {"power law", {1.3e6, 0.065}}};
  for (const auto &[type, constants] : laws)
    for (const BarQuantity quantity : {BarQuantity::creep, BarQuantity::modulus})
    {
      const auto law = make_bar_law(type);
      const std::vector<BarRecord> records = {record_of(*law, constants, quantity, 0.)};
      compare(law->description() + " of " + records[0].name(),
              fit_bar_law(start_of_scan(law, records), records), constants, 1e-6);
    }
  // Two tables of different noise: each has its own.
  {
    const std::vector<BarRecord> both = {record_of(*prony, series, BarQuantity::relaxation, 0.003),
                                         record_of(*prony, series, BarQuantity::modulus, 0.03)};
    const BarLawFit fit = simplest_of(fit_prony_series_to_bar(0.5, both, 8));
    compare_by_errors("two tables", fit, series, 0.06);
    check::relative("two tables: noise of the relaxation", fit.misfits[0], 0.003, 0.3);
    check::relative("two tables: noise of the moduli", fit.misfits[1], 0.03, 0.3);
  }
  {
    // Of a series of three branches that is hardly better two are taken.
    std::vector<BarLawFit> three(3);
    for (unsigned int i = 0; i < 3; ++i)
      three[i].law = make_series_of_bar(0.5, i + 1);
    three[0].criterion = -100.;
    three[1].criterion = -298.5;
    three[2].criterion = -300.;
    check::equal("best", std::to_string(best_of(three).law->n_branches()), "3");
    check::equal("simplest", std::to_string(simplest_of(three).law->n_branches()), "2");
    three[1].criterion = -297.9;
    check::equal("no other is as good", std::to_string(simplest_of(three).law->n_branches()), "3");
  }
  {
    // Fifteen rows without noise from glass to rubber have no end of branches.
    BarRecord glass;
    for (unsigned int i = 0; i < 15; ++i)
    {
      glass.abscissae.push_back(std::pow(10., -3. + 0.4 * i));
      glass.values.push_back(1e6 + 1e9 / (1. + glass.abscissae.back()));
    }
    glass.noise_units = glass.values;
    glass.is_logarithmic = true;
    std::size_t most = 0;
    for (const BarLawFit &fit : fit_prony_series_to_bar(0.5, {glass}, 8))
      most = std::max(most, fit.parameters.size());
    check::equal("constants of fifteen values", std::to_string(most), "7");
  }
  BarRecord few = record_of(*prony, series, BarQuantity::relaxation, 0.003);
  few.abscissae.resize(5);
  few.values.resize(5);
  few.noise_units.resize(5);
  check::throws<std::invalid_argument>(
      "as many constants as rows",
      [&]() {
        fit_bar_law({prony, series}, {few});
      },
      "");
}
} // namespace test_of_bar_law_fit
