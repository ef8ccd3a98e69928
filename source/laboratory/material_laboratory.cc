#include <continua/base/citations.h>
#include <continua/base/table_writer.h>
#include <continua/case/power_laws.h>
#include <continua/laboratory/entries_of_a_body.h>
#include <continua/laboratory/laboratory_tests.h>
#include <continua/laboratory/large_strain_tests.h>
#include <continua/laboratory/material_laboratory.h>
#include <continua/materials/mean_modulus.h>
#include <continua/materials/strain_law_types.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <memory>
#include <sstream>

namespace Continua
{
using dealii::numbers::PI;

MaterialLaboratory::MaterialLaboratory(const AnalysisInput &input) : Analysis(input)
{
  ParameterSection root = file.root();
  refuse_entries_of_a_body(root, general, "the specimen of the laboratory has its own kinematics",
                           "the specimen of the laboratory is one finite element",
                           "Remove it; Laboratory/Specimen is a cylinder or a cube");
  ParameterSection section = root.subsection("Laboratory");
  laboratory.read(section);
  read_material_of(root.subsection("Materials"));
  if (laboratory.has_steps())
  {
    time.read(root.subsection("Time"));
    if (time.is_adaptive())
      root.subsection("Time").refuse(
          "Time step control", "the laboratory's tests have steps of one size", "Remove the entry");
  }
  expected = read_expected(root.subsection("Expected"));
  // Before the checks across entries: a misspelt key is the likelier reason for them to fail.
  file.refuse_unknown();
  name_quantities();
  quantities.refuse_unknown(file, root.subsection("Expected"), expected);
  if (laboratory.has("relaxation") ||
      (laboratory.has_steps() && laboratory.large_strain.loading_time > 0.))
    check_loading_time(section);
  if (is_power_law())
    fit(root.subsection("Materials").subsection(name));
}

void MaterialLaboratory::read_material_of(ParameterSection materials)
{
  const std::vector<std::string> names = materials.subsections();
  if (names.size() != 1)
    materials.refuse("",
                     names.empty() ? "there is no material"
                                   : "there are " + std::to_string(names.size()) +
                                         " materials, and the laboratory has one specimen",
                     "Give one subsection, of any name, with a Type");
  name = names.front();
  std::vector<std::string> tests = LaboratoryParameters::test_names();
  if (laboratory.is_large_strain)
  {
    tests = LargeStrainParameters::test_names();
    tests.push_back("fit");
  }
  if (std::find(tests.begin(), tests.end(), name) != tests.end())
    materials.subsection(name).refuse("",
                                      "the summary calls what a test finds '" + name +
                                          "', so that no material can have that name",
                                      "Give it another name");
  ParameterSection section = materials.subsection(name);
  material = read_material(section, Model::three_dimensional);
  if (!material.is_solid())
    section.refuse("Type", "'" + material.type + "' is a fluid, which cannot be pulled",
                   "Give the law of a solid");
  if (is_power_law())
    table = read_relaxation_test(section);
  if (laboratory.is_large_strain)
    read_strain_law(section);
}

void MaterialLaboratory::read_strain_law(ParameterSection section)
{
  strain_law.read(section, material.is_incompressible());
  if (material.shear.viscosity > 0.)
    section.refuse("Viscosity", "tests at finite deformations know no viscosity beside the law",
                   "Take branches that relax (Type = prony), or Laboratory/Deformation = small");
  // The springs of a power law are there after its fit.
  if (!is_power_law() && material.long_term_shear_modulus() == 0.)
    section.refuse("Type",
                   "'" + material.type +
                       "' has no spring that holds, to which the strain law "
                       "would belong",
                   "Take Type = prony with a small Young's modulus");
  if (!laboratory.large_strain.tables.empty() && is_power_law())
    section.refuse("Type", "the constants of a power law are not fitted to curves",
                   "Take Type = hookean for the fit, or remove the tables of the laboratory");
  std::size_t n_rows = 0;
  for (const StretchTable &measured : laboratory.large_strain.tables)
    n_rows += measured.strain_measures.size();
  const std::size_t n_constants = 1 + strain_law_type(strain_law.type).constants.size();
  if (n_rows > 0 && n_rows <= n_constants)
    section.refuse("Strain law",
                   "the law has " + std::to_string(n_constants) +
                       " constants, and the tables of the laboratory have " +
                       std::to_string(n_rows) + " rows: more are needed to tell the noise, too",
                   "Give tables with more rows");
}

void MaterialLaboratory::check_loading_time(const ParameterSection &section) const
{
  const double loading_time =
      laboratory.is_large_strain ? laboratory.large_strain.loading_time : laboratory.loading_time;
  TimeControl control(time);
  while (!control.at_end() && control.time() < loading_time * (1. - 1e-6))
    control.next();
  if (std::abs(control.time() - loading_time) > 1e-6 * loading_time)
    section.refuse("Loading time",
                   "the loading ends at " + shortest_number(loading_time) +
                       " s, within a time step or after the end of the run",
                   "Give a whole number of time steps before Time/End time");
}

void MaterialLaboratory::fit(const ParameterSection &section)
{
  // What the tests see beside the band of the table: their duration and, of a step, a period of
  // ten.
  double lowest = laboratory.lowest_frequency, highest = laboratory.highest_frequency;
  for (const double frequency : laboratory.frequencies)
    if (laboratory.has("harmonic"))
    {
      lowest = std::min(lowest, frequency);
      highest = std::max(highest, frequency);
    }
  if (laboratory.has("relaxation") || laboratory.has("creep") ||
      (laboratory.is_large_strain && laboratory.has_steps()))
  {
    lowest = std::min(lowest, 1. / (2. * PI * time.end_time));
    highest = std::max(highest, 1. / (10. * time.smallest_step()));
  }
  const PronyFitParameters &asked = material.shear.power_law->prony_fit;
  if (asked.lowest_frequency > 0.)
    lowest = asked.lowest_frequency;
  if (asked.highest_frequency > 0.)
    highest = asked.highest_frequency;
  series = PowerLaws::fit(material, lowest, highest, section);
}

void MaterialLaboratory::name_quantities()
{
  for (const char *const quantity :
       {"storage modulus", "loss modulus", "tan delta", "mean modulus"})
    quantities.add(quantity, name);
  if (is_power_law())
    for (const char *const quantity : {"c", "n", "Prony fit error", "branches"})
      quantities.add(quantity, name);
  if (!table.file.empty())
    quantities.add("misfit of the relaxation table", name);
  if (laboratory.is_large_strain)
    LargeStrainTests::name_quantities(strain_law, laboratory.large_strain, laboratory.tests,
                                      quantities);
  else
    LaboratoryTests<2>::name_quantities(laboratory, is_power_law(), quantities);
}

void MaterialLaboratory::compute(const OutputDirectory &directory, Log &log, Summary &summary)
{
  const bool is_writer = dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
  summary.set_possible(quantities);
  summary.set("status", "finished");
  summary.set("specimen", laboratory.is_large_strain
                              ? "a point"
                              : word_of(specimen_words(), laboratory.specimen));
  summary.set("material", name + ", " + material.type);
  std::unique_ptr<LargeStrainTests> large_strain_tests;
  if (laboratory.is_large_strain)
  {
    large_strain_tests = std::make_unique<LargeStrainTests>(
        material, strain_law, laboratory.large_strain, time, directory, communicator, log, summary);
    // First of all: what is said of the material is then that of the fit.
    large_strain_tests->fit_tables(material);
  }
  report(log, summary);
  if (is_writer)
  {
    write_modulus(directory);
    write_branches(directory);
    if (!table.file.empty())
      write_table(directory);
  }
  if (large_strain_tests)
    large_strain_tests->perform(laboratory.tests);
  else if (laboratory.specimen == SpecimenShape::cylinder)
    simulate<2>(directory, log, summary);
  else
    simulate<3>(directory, log, summary);
  bool all_passed = true;
  for (const std::string &verdict : summary.check(expected, all_passed))
    log.line(verdict);
  summary.set("warnings", log.warnings());
  if (is_writer)
  {
    summary.write(directory.file("summary.json"));
    Citations().write(directory.file("citation.bib"));
  }
}

void MaterialLaboratory::report(Log &log, Summary &summary) const
{
  const std::complex<double> young =
      material.complex_young_modulus(2. * PI * laboratory.fundamental);
  std::ostringstream text;
  text.precision(6);
  if (is_power_law())
  {
    text << name << ": relaxation modulus " << material.shear.power_law->modulus << " Pa (t/1 s)^-"
         << material.shear.power_law->exponent;
    if (!table.file.empty())
      text << ", fitted to " << table.times.size() - table.first_used << " of "
           << table.times.size() << " rows of the table within " << std::setprecision(2)
           << fit_relaxation_test(table).misfit << " (root mean square)" << std::setprecision(6);
    log.line(text.str());
    for (const std::string &warning :
         {table.file.empty() ? std::string()
                             : warning_of_relaxation_table(name, fit_relaxation_test(table).misfit),
          table.file.empty() ? std::string() : warning_of_better_series(name, table),
          warning_of_prony_series(name, series.error)})
      if (!warning.empty())
        log.warning(warning);
    summary.add({"c", material.shear.power_law->modulus, "Pa", name});
    summary.add({"n", material.shear.power_law->exponent, "1", name});
    if (!table.file.empty())
      summary.add({"misfit of the relaxation table", fit_relaxation_test(table).misfit, "1", name});
    text.str("");
    text.precision(3);
    text << name << ": a spring and " << series.moduli.size()
         << (series.moduli.size() == 1 ? " branch" : " branches") << " follow the power law from "
         << series.lowest_frequency << " to " << series.highest_frequency << " Hz within ";
    text.precision(2);
    text << series.error;
    log.line(text.str());
    summary.add({"Prony fit error", series.error, "1", name});
    summary.add({"branches", static_cast<double>(series.moduli.size()), "1", name});
  }
  summary.add({"storage modulus", young.real(), "Pa", name});
  summary.add({"loss modulus", young.imag(), "Pa", name});
  summary.add({"tan delta", young.imag() / young.real(), "1", name});
  const double mean = mean_modulus(material, laboratory.fundamental, laboratory.n_harmonics);
  summary.add({"mean modulus", mean, "Pa", name});
  text.str("");
  text.precision(6);
  text << name << ": mean modulus " << mean << " Pa over " << laboratory.n_harmonics
       << " harmonics of " << laboratory.fundamental << " Hz";
  log.line(text.str());
}

void MaterialLaboratory::write_modulus(const OutputDirectory &directory) const
{
  std::vector<std::string> header = {"frequency [Hz]", "storage modulus [Pa]", "loss modulus [Pa]",
                                     "tan delta [1]"};
  if (is_power_law())
    header.insert(header.end(), {"storage modulus of the Prony series [Pa]",
                                 "loss modulus of the Prony series [Pa]",
                                 "relative error of the Prony series [1]"});
  TableWriter table(directory.file("modulus.csv"), header);
  const UniaxialResponse branches(material);
  const double decades = std::log10(laboratory.highest_frequency / laboratory.lowest_frequency);
  const unsigned int n_intervals =
      std::max(1., std::ceil(decades * laboratory.points_per_decade - 1e-9));
  for (unsigned int i = 0; i <= n_intervals; ++i)
  {
    const double frequency = laboratory.lowest_frequency * std::pow(10., decades * i / n_intervals);
    const std::complex<double> young = material.complex_young_modulus(2. * PI * frequency);
    std::vector<double> row = {frequency, young.real(), young.imag(), young.imag() / young.real()};
    if (is_power_law())
    {
      const std::complex<double> of_series = branches.modulus(2. * PI * frequency);
      row.insert(row.end(), {of_series.real(), of_series.imag(), std::abs(of_series / young - 1.)});
    }
    table.row(row);
  }
  table.flush();
}

void MaterialLaboratory::write_branches(const OutputDirectory &directory) const
{
  // One row for each relaxation time, of the shear, of the volume change or of both; inf: a spring.
  std::vector<double> times;
  for (const Branch &branch : material.shear.branches)
    times.push_back(branch.relaxation_time);
  for (const BulkBranch &branch : material.compression.bulk_branches())
    times.push_back(branch.relaxation_time);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  TableWriter table(directory.file("prony.csv"),
                    {"relaxation time [s]", "shear modulus [Pa]", "bulk modulus [Pa]"});
  for (const double relaxation_time : times)
  {
    double shear = 0., bulk = 0.;
    for (const Branch &branch : material.shear.branches)
      if (branch.relaxation_time == relaxation_time)
        shear += branch.shear_modulus;
    for (const BulkBranch &branch : material.compression.bulk_branches())
      if (branch.relaxation_time == relaxation_time)
        bulk += branch.bulk_modulus;
    if (material.compression.bulk_branches().empty() && std::isinf(relaxation_time))
      bulk = 1. / material.inverse_bulk_modulus();
    table.row({relaxation_time, shear, bulk});
  }
  table.flush();
}

void MaterialLaboratory::write_table(const OutputDirectory &directory) const
{
  TableWriter rows(directory.file("relaxation-table.csv"),
                   {"time [s]", "modulus [Pa]", "modulus of the power law [Pa]", "fitted [1]"});
  for (std::size_t i = 0; i < table.times.size(); ++i)
  {
    const double law_time = table.law_time(i);
    rows.row({table.times[i], table.moduli[i],
              law_time > 0. ? material.shear.power_law->modulus *
                                  std::pow(law_time, -material.shear.power_law->exponent)
                            : std::numeric_limits<double>::quiet_NaN(),
              i < table.first_used ? 0. : 1.});
  }
  rows.flush();
}

template <int dim>
void MaterialLaboratory::simulate(const OutputDirectory &directory,
                                  Log &log,
                                  Summary &summary) const
{
  LaboratoryTests<dim> tests(material, laboratory, time, directory, communicator, log, summary);
  if (laboratory.has("relaxation"))
    tests.relaxation();
  if (laboratory.has("creep"))
    tests.creep();
  if (laboratory.has("harmonic"))
    tests.harmonic();
}
} // namespace Continua
