#include <continua/case/harmonic_parameters.h>

#include <continua/base/angle_entry.h>
#include <continua/base/nearly_equal.h>
#include <continua/base/six_digits.h>
#include <continua/base/words.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace Continua
{
namespace
{
enum class FrequencySpacing
{
  linear,
  logarithmic
};

/// Of sorted frequencies, as they are written where the range has one but for round-off. Refuses
/// two of the list with one name.
void remove_repetitions(const std::vector<double> &listed,
                        std::vector<double> &frequencies,
                        const ParameterSection &section)
{
  std::set<std::string> names;
  for (const double frequency : std::set<double>(listed.begin(), listed.end()))
    if (!names.insert(six_digits(frequency)).second)
      section.refuse("Frequencies",
                     "two of them are both " + six_digits(frequency) +
                         " Hz in the names of quantities, which have six digits",
                     "Give one of them, or both as a range");
  for (double &frequency : frequencies)
    for (const double written : listed)
      if (nearly_equal(written, frequency))
        frequency = written;
  frequencies.erase(std::unique(frequencies.begin(), frequencies.end()), frequencies.end());
}
} // namespace

void HarmonicParameters::read(ParameterSection section)
{
  section.add("Frequencies", listed, Dimensions::frequency,
              "Frequencies of the motion, in any order. A solid that is held may have 0, its state "
              "at rest. The summary has amplitude and phase of each probe at these.",
              Range::not_negative());
  frequencies = listed;
  add_range(section);
  if (frequencies.empty())
    section.require("Frequencies");
  std::sort(frequencies.begin(), frequencies.end());
  remove_repetitions(listed, frequencies, section);
  section.add("Field frequencies", field_frequencies, Dimensions::frequency,
              "Frequencies, of those above, at which the fields are written, as real and imaginary "
              "part. Empty: none.",
              Range::not_negative());
  for (double &frequency : field_frequencies)
  {
    const auto found = std::find_if(frequencies.begin(), frequencies.end(),
                                    [frequency](const double candidate)
                                    { return nearly_equal(candidate, frequency); });
    if (found == frequencies.end())
      section.refuse("Field frequencies",
                     six_digits(frequency) + " Hz is none of the frequencies of the motion",
                     "Add it to Frequencies");
    frequency = *found;
  }
  section.add("Unit load at", unit_load,
              "Name of the one boundary that has a load, of size one: a pressure of 1 Pa on it, 1 "
              "Pa behind an outlet, 1 m^3/s into the body at a flow rate without a profile. The "
              "loads of the file are left out then; velocities that it prescribes are zero. Empty: "
              "the loads of the file, whose entries are amplitudes.");
  section.add("Waves at stations", n_waves,
              "Waves that go both ways along a tube and are fitted to the values at three stations "
              "of a probe or more: 1 - the pressure wave; 2 - the axial wave of a free wall beside "
              "it, which needs five stations [1].",
              1, 2);
  section.add(
      "Estimate errors", estimates_errors,
      "Whether the errors of the responses by the mesh are estimated: by the same case with "
      "elements of the next degree, which is solved at each frequency, too, and takes "
      "several times as long.");
  sensitivities.read(section.subsection("Sensitivities"));
}

void HarmonicParameters::add_range(ParameterSection section)
{
  unsigned int n = 51;
  FrequencySpacing spacing = FrequencySpacing::linear;
  section.add("Lowest frequency", lowest, Dimensions::frequency, "First frequency of a range.",
              Range::positive());
  section.add("Highest frequency", highest, Dimensions::frequency,
              "Last frequency of a range. Without one there are the Frequencies alone.",
              Range::positive());
  section.add(
      "Number of frequencies", n,
      "Of the range, its ends included; with a Response tolerance the most that it gets [1].", 2);
  add_choice(section, "Spacing", spacing,
             {{"linear", FrequencySpacing::linear}, {"logarithmic", FrequencySpacing::logarithmic}},
             "How the frequencies of the range follow each other: linear - at equal distances; "
             "logarithmic - at equal ratios.");
  is_logarithmic = spacing == FrequencySpacing::logarithmic;
  section.add("Response tolerance", response_tolerance, Dimensions::none,
              "The range gets further frequencies, where the responses of the probes bend, until a "
              "rational approximation differs from new ones by no more than this part of the "
              "largest response [1]. 0: the range stays as it is.",
              Range::not_negative());
  if (!section.given("Highest frequency"))
  {
    for (const char *key :
         {"Lowest frequency", "Number of frequencies", "Spacing", "Response tolerance"})
      if (section.given(key))
        section.refuse(key, "the range has no end",
                       "Give 'Highest frequency', or remove the entry");
    return;
  }
  section.require("Lowest frequency");
  if (lowest >= highest)
    section.refuse("Lowest frequency", "it is not below the highest frequency", "Give a lower one");
  if (response_tolerance > 0.)
  {
    most_frequencies = section.given("Number of frequencies") ? n : most_frequencies;
    frequencies.push_back(lowest);
    frequencies.push_back(highest);
    return;
  }
  for (unsigned int k = 0; k < n; ++k)
  {
    const double part = static_cast<double>(k) / (n - 1);
    frequencies.push_back(k == 0       ? lowest
                          : k == n - 1 ? highest
                          : spacing == FrequencySpacing::linear
                              ? lowest + part * (highest - lowest)
                              : lowest * std::pow(highest / lowest, part));
  }
}

double HarmonicParameters::read_phase(ParameterSection section)
{
  double phase = 0.;
  add_angle(section, "Phase", phase,
            "With Analysis = harmonic, by which angle the load is ahead: it is the real part of "
            "its amplitude times exp(i (2 pi f t + phase)).");
  return phase;
}

void HarmonicParameters::read_phases(ParameterSection root,
                                     const std::vector<BoundaryCondition> &conditions)
{
  for (const BoundaryCondition &condition : conditions)
    phases.push_back(read_phase(root.subsection("Boundaries").subsection(condition.name)));
  body_force_phase = read_phase(root.subsection("Body force"));
}
} // namespace Continua
