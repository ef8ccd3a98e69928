#include <continua/case/power_laws.h>

#include <continua/base/misfit.h>
#include <continua/base/units.h>
#include <continua/materials/power_law_fit.h>
#include <continua/theory/bar_law_fit.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace Continua
{
std::string warning_of_relaxation_table(const std::string &region, const double misfit)
{
  return misfit_warning("Materials/" + region + "/Relaxation table: the power law", misfit,
                        "root of the mean square",
                        "Such a material follows no power law: give the part of the table that "
                        "matters to the run, or a Type = prony");
}

std::string warning_of_prony_series(const std::string &region, const double error)
{
  return misfit_warning("Materials/" + region + ": the Prony series of the power law", error,
                        "the largest relative error of the modulus",
                        "Set a smaller Fit tolerance, or leave it out");
}

std::string warning_of_better_series(const std::string &region, const RelaxationTest &test)
{
  // The rows of the power law's fit.
  BarRecord record;
  record.loading_time = test.loading_time;
  record.abscissae.assign(test.times.begin() + test.first_used, test.times.end());
  record.values.assign(test.moduli.begin() + test.first_used, test.moduli.end());
  record.noise_units = record.values;
  record.is_logarithmic = true;
  constexpr double poissons_ratio = 0.5; // the moduli are Young's, whatever it is
  constexpr unsigned int most_branches = 8;
  std::ostringstream text;
  try
  {
    const BarLawFit line =
        fit_bar_law(start_of_scan(make_bar_law("power law", poissons_ratio), {record}), {record});
    const BarLawFit series =
        simplest_of(fit_prony_series_to_bar(poissons_ratio, {record}, most_branches));
    if (series.law->n_branches() == 0 || line.criterion - series.criterion <= clear_difference)
      return "";
    text.precision(2);
    text << "Materials/" << region << "/Relaxation table: the power law misses by "
         << 100. * line.misfits[0] << " % (root of the mean square), " << series.law->description()
         << " by " << 100. * series.misfits[0]
         << " %. By Schwarz's criterion the series is very clearly better. Fit the table with "
            "'Analysis = material fit', and take the entries of its material.prm";
  }
  catch (const std::exception &)
  {
    return ""; // too few rows to compare laws, or one of them cannot be fitted
  }
  return text.str();
}

void PowerLaws::note_table(const std::string &region, const ParameterSection &section)
{
  const RelaxationTest test = read_relaxation_test(section);
  tables[region] = fit_relaxation_test(test);
  tests[region] = test;
}

void PowerLaws::report_tables(Log &log, Summary &summary) const
{
  for (const auto &[region, fit] : tables)
  {
    std::ostringstream text;
    text.precision(4);
    text << region << ": the relaxation table follows " << fit.modulus << " Pa (t/1 s)^-"
         << fit.exponent << ", root of the mean square misfit " << fit.misfit;
    log.line(text.str());
    if (const std::string warning = warning_of_relaxation_table(region, fit.misfit);
        !warning.empty())
      log.warning(warning);
    if (const std::string warning = warning_of_better_series(region, tests.at(region));
        !warning.empty())
      log.warning(warning);
    summary.add({"c", fit.modulus, "Pa", region});
    summary.add({"n", fit.exponent, "1", region});
    summary.add({"misfit of the relaxation table", fit.misfit, "1", region});
  }
}

void PowerLaws::name_quantities(QuantityNames &names) const
{
  for (const auto &[region, fit] : tables)
    for (const char *const name : {"c", "n", "misfit of the relaxation table"})
      names.add(name, region);
}

void PowerLaws::fit(Problem &problem, const TimeParameters &time, ParameterSection materials)
{
  smallest_step = time.smallest_step();
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
  {
    Material &material = problem.materials[region];
    if (!material.has_power_law())
      continue;
    const ParameterSection section = materials.subsection(problem.regions[region]);
    const PronyFitParameters &asked = material.shear.power_law->prony_fit;
    const double highest =
        asked.highest_frequency > 0. ? asked.highest_frequency : 1. / (10. * smallest_step);
    // A run of a few steps has no band of its own.
    const double lowest =
        asked.lowest_frequency > 0.
            ? asked.lowest_frequency
            : std::min(1. / (2. * dealii::numbers::PI * time.end_time), 0.1 * highest);
    series[problem.regions[region]] = fit(material, lowest, highest, section);
  }
}

PronySeries PowerLaws::fit(Material &material,
                           const double lowest_frequency,
                           const double highest_frequency,
                           const ParameterSection &section)
{
  const PronyFitParameters &asked = material.shear.power_law->prony_fit;
  const auto band = [&]()
  {
    return "from " + shortest_number(lowest_frequency) + " to " +
           shortest_number(highest_frequency) + " Hz";
  };
  if (lowest_frequency >= highest_frequency)
    section.refuse(asked.lowest_frequency > 0. ? "Lowest frequency" : "Highest frequency",
                   "the band of the Prony fit is empty: " + band(),
                   "Give a lowest frequency below the highest one, or leave them out");
  try
  {
    return fit_power_law(material, lowest_frequency, highest_frequency);
  }
  catch (const std::domain_error &error)
  {
    section.refuse("Bulk modulus", error.what(),
                   "Give a bulk modulus K of which 9 K is above Young's modulus in the whole "
                   "band, or 'Volumetric relaxation = as the shear'");
  }
  catch (const std::range_error &error)
  {
    section.refuse(asked.n_branches > 0 ? "Branches" : "Fit tolerance",
                   std::string(error.what()) + ", " + band() + "; the tolerance is " +
                       shortest_number(asked.tolerance),
                   "Give more branches, a larger 'Fit tolerance' or a narrower band ('Lowest "
                   "frequency', 'Highest frequency')");
  }
}

void PowerLaws::report_series(Log &log, Summary &summary) const
{
  for (const auto &[region, prony] : series)
  {
    std::ostringstream text;
    text.precision(4);
    text << region << ": a spring and " << prony.moduli.size()
         << (prony.moduli.size() == 1 ? " branch" : " branches") << " follow the power law from "
         << prony.lowest_frequency << " to " << prony.highest_frequency << " Hz within ";
    text.precision(2);
    text << prony.error;
    log.line(text.str());
    if (prony.highest_frequency > 0.5 / smallest_step)
    {
      std::ostringstream warning;
      warning << "Materials/" << region << "/Highest frequency: the Prony fit reaches to "
              << prony.highest_frequency << " Hz, but a time step of " << smallest_step
              << " s has no frequencies above " << 0.5 / smallest_step << " Hz";
      log.warning(warning.str());
    }
    if (const std::string warning = warning_of_prony_series(region, prony.error); !warning.empty())
      log.warning(warning);
    summary.add({"Prony fit error", prony.error, "1", region});
    std::map<std::string, double> values = {{"lowest frequency [Hz]", prony.lowest_frequency},
                                            {"highest frequency [Hz]", prony.highest_frequency},
                                            {"largest error [1]", prony.error},
                                            {"spring [Pa]", prony.spring}};
    for (std::size_t k = 0; k < prony.moduli.size(); ++k)
    {
      const std::string number = std::to_string(k + 1);
      values["branch " + number + ": modulus [Pa]"] = prony.moduli[k];
      values["branch " + number + ": relaxation time [s]"] = prony.times[k];
    }
    summary.set("Prony series of the shear modulus of " + region, values);
  }
}

void PowerLaws::save(ArchiveWriter &archive) const
{
  for (const auto &[region, prony] : series)
  {
    const std::string name = "Prony series of " + region + ": ";
    archive.add(name + "moduli", prony.moduli);
    archive.add(name + "times", prony.times);
    archive.add(name + "spring, band and error",
                std::vector<double>{prony.spring, prony.lowest_frequency, prony.highest_frequency,
                                    prony.error});
  }
}

void PowerLaws::load(const ArchiveReader &archive, Problem &problem, const TimeParameters &time)
{
  smallest_step = time.smallest_step();
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
  {
    if (!problem.materials[region].has_power_law())
      continue;
    PronySeries &prony = series[problem.regions[region]];
    const std::string name = "Prony series of " + problem.regions[region] + ": ";
    const std::vector<double> others = archive.values(name + "spring, band and error");
    prony = {others.at(0),
             archive.values(name + "moduli"),
             archive.values(name + "times"),
             others.at(1),
             others.at(2),
             others.at(3)};
    take_branches(problem.materials[region], prony);
  }
}
} // namespace Continua
