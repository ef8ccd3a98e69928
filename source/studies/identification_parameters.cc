#include <continua/studies/identification_parameters.h>

#include <continua/base/words.h>

#include <algorithm>

namespace Continua
{
namespace
{
Words<PredictingModel> predicting_model_words()
{
  return {{"automatic", PredictingModel::automatic},
          {"linear wave theory", PredictingModel::theory},
          {"simulation", PredictingModel::simulation}};
}

Words<OtherModel> other_model_words()
{
  return {{"none", OtherModel::none},
          {"linear wave theory", OtherModel::theory},
          {"simulation", OtherModel::simulation}};
}

Words<FitParameter::Scale> scale_words()
{
  return {{"linear", FitParameter::Scale::linear},
          {"logarithmic", FitParameter::Scale::logarithmic}};
}

Words<CorrelatedNoise> correlated_noise_words()
{
  return {{"autoregressive", CorrelatedNoise::autoregressive},
          {"as given", CorrelatedNoise::as_given},
          {"sandwich", CorrelatedNoise::sandwich},
          {"enlarged", CorrelatedNoise::enlarged}};
}

Words<OrderCriterion> order_criterion_words()
{
  return {{"corrected akaike", OrderCriterion::corrected_akaike},
          {"bayesian", OrderCriterion::bayesian}};
}

void read_fit(ParameterSection &section, IdentificationParameters &parameters)
{
  section.add("Confidence", parameters.confidence, Dimensions::none,
              "Of the intervals: the part of repeated experiments whose interval has the true "
              "value.",
              Range{0.5, 1., false, true});
  section.add("Tolerance", parameters.tolerance, Dimensions::none,
              "The fit ends when a further step would be shorter than this many standard errors.",
              Range::positive());
  section.add("Largest number of evaluations", parameters.largest_n_evaluations,
              "Evaluations of the model after which the fit gives up [1].", 1);
  section.add("Starts", parameters.n_starts,
              "From how many places the fit starts: the given one, and others spread between the "
              "bounds; the best fit is taken [1].",
              1, 1000);
  section.add(
      "Difference step", parameters.difference_step, Dimensions::none,
      "Half the distance of the two runs of a derivative: on a logarithmic scale as a part of "
      "the number, else of the smaller one of the number and of its size (start or range).",
      Range{1e-8, 0.1});
  section.add("Profiles", parameters.profiles,
              "Whether the misfit over each number is told, with the others fitted anew: the "
              "interval that needs no linear model.");
  section.add("Parallel runs", parameters.n_parallel,
              "Evaluations of the model side by side; 0: as many as there are cores [1].");
}

void read_noise(ParameterSection &section, IdentificationParameters &parameters)
{
  parameters.noise.deviations = section.subsection("Noise").add_free_entries(
      "Standard deviation of the noise of a field (pressure = 0.2 mmHg) or of one record (stations "
      "0.1 m: pressure = 0.3 mmHg), with a unit of the field; or 'from rest': its correlation in "
      "time is that of the rows before Rest until, its deviation that of the residuals. What is "
      "not "
      "named is estimated from the residuals of the fit.");
  section.add(
      "Rest until", parameters.rest_until, Dimensions::time,
      "The pulse arrives later than this time of the tables at each record whose noise comes "
      "'from rest': the rows before it are at rest.");
  section.add("Correlation time", parameters.correlation_time, Dimensions::time,
              "Of noise that is given as a number: its correlation falls as exp(-t/this time), as "
              "behind a low-pass filter of the bandwidth 1/(2 pi this time); 0: white.",
              Range::not_negative());
  add_choice(section, "Correlated noise", parameters.correlated_noise, correlated_noise_words(),
             "What is done where the residuals are correlated in time: autoregressive - a model of "
             "the noise is fitted to them and the fit repeated (generalised least squares); as "
             "given - nothing; sandwich - the covariance by Newey and West; enlarged - errors "
             "enlarged by the largest spectral density, which is conservative.");
  add_choice(section, "Order criterion", parameters.order_criterion, order_criterion_words(),
             "By which the order of an autoregressive model is chosen.");
}

void read_design(ParameterSection &section, IdentificationParameters &parameters)
{
  parameters.expected_noise.deviations =
      section.subsection("Expected noise")
          .add_free_entries(
              "Standard deviation of the noise that a field (pressure = 0.2 mmHg) or a record "
              "(stations 0.1 m: pressure = 0.3 mmHg) will have, with a unit of the field: the "
              "section asks for the errors that the experiment would give, without any data.");
  section.add("Sampling interval", parameters.sampling_interval, Dimensions::time,
              "Of the records of an experiment that is to be designed; 0: Time/Time step.",
              Range::not_negative());
  section.add(
      "Candidates", parameters.candidates,
      "Probes whose stations and fields may be added to the experiment, and material tests: "
      "each of their records is ranked.");
  section.add("Records to add", parameters.n_added,
              "How many candidates are added together: all sets of so many are ranked [1].", 1, 4);
  section.add("Criterion", parameters.criterion,
              "By what candidates are ranked: the name of a sought number, whose standard error is "
              "to be small; or determinant - the volume of the region of confidence of all.");
}
} // namespace

void SoughtNumber::read(ParameterSection section)
{
  name = section.name();
  section.add("Entry", entry,
              "The entry of this file that is sought, with its sections (Materials/wall/Young's "
              "modulus), of a list with the place of the number (Materials/wall/Shear moduli 2).");
  section.add("Lower", lower,
              "Lower bound, with a unit of the entry; empty: that of the entry itself.");
  section.add("Upper", upper,
              "Upper bound, with a unit of the entry; empty: that of the entry itself.");
  section.add("Start", start, "Where the search starts; empty: the value of the entry.");
  add_choice(section, "Scale", scale, scale_words(),
             "How far apart two values are: linear - by their difference; logarithmic - by their "
             "ratio, for positive numbers.");
  section.add("Prior mean", prior_mean,
              "What is known of the number from elsewhere: its mean, with a unit of the entry; "
              "empty: nothing.");
  section.add(
      "Prior standard deviation", prior_standard_deviation,
      "What is known of the number from elsewhere: its standard deviation, with a unit of "
      "the entry. On a logarithmic scale the logarithm is normal, with this over the mean.");
  section.require("Entry");
}

void IdentificationParameters::read(ParameterSection root)
{
  ParameterSection section = root.subsection("Identification");
  add_choice(section, "Model", model, predicting_model_words(),
             "What predicts the measurements: linear wave theory; simulation - the file's own run "
             "in time, with its steps and its mesh; automatic - the theory where it covers the "
             "case, else the simulation.");
  ParameterSection family = section.subsection("Parameters");
  for (const std::string &name : family.subsections())
  {
    sought.emplace_back();
    sought.back().read(family.subsection(name));
  }
  ParameterSection tests_family = section.subsection("Material tests");
  for (const std::string &name : tests_family.subsections())
  {
    tests.emplace_back();
    tests.back().read(tests_family.subsection(name));
  }
  read_noise(section, *this);
  read_fit(section, *this);
  add_choice(section, "Model error", other_model, other_model_words(),
             "Another model, whose difference from the first one at the estimates is told as a "
             "bias of each number: by how much it would be off if the other model were right.");
  ParameterSection others = section.subsection("Entries of the other model");
  other_entries = others.add_free_entries(
      "A line for each entry that the other model has in place of the file's own: its path, as in "
      "--set, and its value (Materials/wall/Type = hookean).");
  read_design(section, *this);
  section.add("Synthetic experiments", n_experiments,
              "After the fit or the design: experiments with the estimates as the truth and noise "
              "drawn anew, each of which is fitted. Their spread checks errors and intervals [1].",
              0, 100000);
  section.add("Seed", seed, "Of the noise of synthetic experiments [1].");
  section.add(
      "Synthetic noise is known", noise_is_known,
      "Of synthetic experiments for Expected noise: whether their fits are given the noise, "
      "or have to estimate its deviation and its correlation from the residuals.");
  expected = read_expected(section.subsection("Expected"));
}

void IdentificationParameters::check(ParameterSection root) const
{
  ParameterSection section = root.subsection("Identification");
  if (!other_entries.empty() && other_model == OtherModel::none)
    section.subsection("Entries of the other model")
        .refuse(other_entries.front().first, "there is no other model",
                "Set Model error, or remove the entry");
  for (const MaterialTest &test : tests)
    test.check(section.subsection("Material tests").subsection(test.name), is_design());
  const auto is_from_rest = [](const auto &deviation) { return deviation.second == "from rest"; };
  if (std::any_of(noise.deviations.begin(), noise.deviations.end(), is_from_rest))
    section.require("Rest until");
  else if (section.given("Rest until"))
    section.refuse("Rest until", "no noise is to come from rest",
                   "Write 'from rest' for a field in Noise, or remove the entry");
  if (is_design() && !section.given("Correlation time"))
    section.refuse("Expected noise",
                   "nothing says how the noise is correlated in time: with white noise any "
                   "experiment would become exact by faster sampling",
                   "Set Correlation time, 1/(2 pi bandwidth) of the instruments; 0: white noise");
  for (const char *const key : {"Sampling interval", "Candidates", "Records to add", "Criterion"})
    if (section.given(key) && !is_design())
      section.refuse(key, "there is no experiment to design: nothing says its noise",
                     "Add the subsection 'Expected noise', or remove the entry");
  if (criterion != "determinant" &&
      std::none_of(sought.begin(), sought.end(),
                   [&](const SoughtNumber &number) { return number.name == criterion; }))
    section.refuse("Criterion", "no sought number is called '" + criterion + "'",
                   "Write 'determinant', or the name of a subsection of Parameters");
}
} // namespace Continua
