#include <continua/laboratory/laboratory_parameters.h>

#include <continua/base/joined.h>

#include <algorithm>

namespace Continua
{
std::vector<std::string> LaboratoryParameters::test_names()
{
  return {"relaxation", "creep", "harmonic"};
}

bool LaboratoryParameters::has(const std::string &test) const
{
  return std::find(tests.begin(), tests.end(), test) != tests.end();
}

const Words<SpecimenShape> &specimen_words()
{
  static const Words<SpecimenShape> words = {{"cylinder", SpecimenShape::cylinder},
                                             {"cube", SpecimenShape::cube}};
  return words;
}

void LaboratoryParameters::check_tests(const ParameterSection &section) const
{
  const std::vector<std::string> names =
      is_large_strain ? LargeStrainParameters::test_names() : test_names();
  for (const std::string &test : tests)
  {
    if (std::find(names.begin(), names.end(), test) == names.end())
      section.refuse("Tests", "there is no test '" + test + "'",
                     "Give a list of " + joined(names) +
                         (is_large_strain ? "" : ", or others with Deformation = finite"));
    if (std::count(tests.begin(), tests.end(), test) > 1)
      section.refuse("Tests", "the test '" + test + "' is named twice", "Name each test once");
  }
}

bool LaboratoryParameters::has_steps() const
{
  return is_large_strain ? has("stretch relaxation") || has("shear relaxation") : !tests.empty();
}

void LaboratoryParameters::read(ParameterSection section)
{
  const Words<bool> deformations = {{"small", false}, {"finite", true}};
  add_choice(section, "Deformation", is_large_strain, deformations,
             "small - simulated tests with one element, by the linear solver; finite - tests of a "
             "hyperelastic law at a point.");
  section.add("Tests", tests,
              "A list of tests. At small deformations: relaxation (a strain that is loaded within "
              "a time and held), creep (a stress from t = 0 on) and harmonic (a sinusoidal "
              "strain); relaxation and creep last until Time/End time. At finite deformations: "
              "uniaxial, equibiaxial, planar, shear (curves of the stress), inflation (of a thin "
              "tube), stretch relaxation and shear relaxation (until Time/End time).");
  check_tests(section);
  section.add("Lowest frequency", lowest_frequency, Dimensions::frequency,
              "Lower end of the band over which the complex modulus is tabulated.",
              Range::positive());
  section.add("Highest frequency", highest_frequency, Dimensions::frequency,
              "Upper end of that band.", Range::positive());
  section.add("Points per decade", points_per_decade,
              "Rows of that table for each factor of ten [1].", 1, 1000);
  section.add("Fundamental frequency", fundamental, Dimensions::frequency,
              "Of the mean modulus: the mean of the storage modulus over the harmonics of this "
              "frequency, which is that of the excitation.",
              Range::positive());
  section.add("Harmonics", n_harmonics, "Number N of these harmonics [1].", 1);
  if (lowest_frequency >= highest_frequency)
    section.refuse(section.given("Lowest frequency") ? "Lowest frequency" : "Highest frequency",
                   "the band is empty",
                   "Give a lowest frequency (default 0.5 Hz) below the highest one (default 100 "
                   "Hz)");
  if (is_large_strain)
    large_strain.read(section, tests);
  else
    read_small_strain(section);
}

void LaboratoryParameters::read_small_strain(ParameterSection &section)
{
  add_choice(section, "Specimen", specimen, specimen_words(),
             "The one element of the simulated tests: a cylinder (axisymmetric) or a cube "
             "(three-dimensional); both find the same.");
  section.add("Strain", strain, Dimensions::none,
              "Strain at which relaxation is held, and amplitude of harmonic tests.",
              Range::positive());
  section.add("Loading time", loading_time, Dimensions::time,
              "Time within which the strain of a relaxation test rises evenly from zero; a whole "
              "number of time steps. Required by relaxation.",
              Range::positive());
  section.add("Stress", stress, Dimensions::pressure,
              "Stress of a creep test, there from t = 0 on. Required by creep.", Range::positive());
  section.add("Frequencies", frequencies, Dimensions::frequency,
              "Frequencies of the harmonic tests, one test each. Required by harmonic.",
              Range::positive());
  section.add("Steps per period", steps_per_period,
              "Time steps of a harmonic test in each of its periods [1]; the other tests take "
              "Time/Time step.",
              8);
  section.add("Periods", n_periods,
              "A harmonic test ends when storage and loss modulus of a period are those of the "
              "period before, at the latest after so many periods [1].",
              2);
  if (has("relaxation"))
    section.require("Loading time");
  if (has("creep"))
    section.require("Stress");
  if (has("harmonic"))
    section.require("Frequencies");
}
} // namespace Continua
