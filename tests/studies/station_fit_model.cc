// From numbers of a file to predictions of records: entries, clocks, and what the file does not
// accept.

#include <continua/base/input_error.h>
#include <continua/studies/station_fit_model.h>

#include "../unit_test.h"

#include <cmath>
#include <cstdlib>

namespace test_of_station_fit_model
{
using namespace Continua;

namespace
{
/// Two probes; at a station s of probe p the field is modulus * (t + 10 p + s). Fails above 9 Pa.
class Ramp : public ForwardModel
{
public:
  std::vector<ForwardAnswer> answers(const std::vector<ForwardQuestion> &questions) override
  {
    std::vector<ForwardAnswer> result;
    for (const ForwardQuestion &question : questions)
    {
      asked.push_back(question);
      result.emplace_back();
      double modulus = 0.;
      for (const auto &[path, value] : question.settings)
        if (path == "Materials/wall/Modulus")
          modulus = std::strtod(value.c_str(), nullptr);
      if (modulus > 9.)
      {
        result.back().failure = "the wall is too stiff";
        continue;
      }
      for (unsigned int p = 0; p < 2; ++p)
      {
        result.back().histories.emplace_back(2, std::vector<std::vector<double>>(1));
        for (unsigned int s = 0; s < 2; ++s)
          for (const double time : question.times[p])
            result.back().histories[p][s][0].push_back(modulus * (time + 10. * p + s));
      }
    }
    return result;
  }
  std::string name() const override { return "ramp"; }
  std::vector<ForwardQuestion> asked;
};

void declare(ParameterSection root)
{
  double modulus = 2., shift = 0.5;
  std::vector<double> times = {1., 2.};
  ParameterSection wall = root.subsection("Materials").subsection("wall");
  wall.add("Modulus", modulus, Dimensions::pressure, "Of the wall.", Range::positive());
  wall.add("Times", times, Dimensions::time, "Of the wall.");
  root.subsection("Probes").subsection("second").add("Measured shift", shift, Dimensions::time, "");
}

SoughtNumber number(const std::string &entry)
{
  SoughtNumber result;
  result.name = entry;
  result.entry = entry;
  result.lower = "-1000";
  result.upper = "1000";
  return result;
}

void add_record(StationRecords &all,
                unsigned int probe,
                unsigned int station,
                const std::vector<double> &times)
{
  DataRecord record;
  record.times = times;
  all.records.push_back(record);
  all.sources.push_back({probe, station, 0, 0.1, probe == 0 ? "first" : "second", "pressure"});
}
} // namespace

UNIT_TEST(station_fit_model)
{
  ParameterFile file;
  declare(file.root());
  const ParameterSection section = file.root().subsection("Parameters");
  SoughtNumber modulus = number("Materials/wall/Modulus");
  modulus.lower = "0";
  const std::vector<SoughtEntry> sought = {
      find_sought_entry(file, section, modulus),
      find_sought_entry(file, section, number("Probes/second/Measured shift")),
      find_sought_entry(file, section, number("Materials/wall/Times 2"))};
  check::equal("clock", sought[1].clock_of(), "second");
  check::equal("no clock", sought[0].clock_of(), "");
  check::absolute("start of a clock", sought[1].parameter.start, 0.5, 0.);

  StationRecords records;
  add_record(records, 0, 0, {0., 1., 2.});
  add_record(records, 1, 1, {1., 3.});
  add_record(records, 1, 0, {2.});
  Ramp ramp;
  StationFitModel model(ramp, sought, records, {"first", "second"}, {{"Time/End time", "4 s"}});
  const auto predictions = model.predict({{3., 0.25, 7.}, {-1., 0., 7.}, {9.5, 0., 7.}});
  const std::vector<double> expected = {0., 3., 6., 3. * 12.25, 3. * 14.25, 3. * 12.25};
  check::is_true("as many values as there are data", predictions[0].values.size() == 6);
  double largest = 0.;
  for (unsigned int i = 0; i < 6; ++i)
    largest = std::max(largest, std::abs(predictions[0].values[i] - expected[i]));
  check::absolute("values, with the clock of one probe", largest, 0., 1e-14);
  check::absolute("shift of a record", model.shift_of(2, {3., 0.25, 7.}), 0.25, 0.);
  check::is_true("what the file does not accept is not asked for", ramp.asked.size() == 2);
  check::is_true("and fails", check::matches(predictions[1].failure,
                                             "'Materials/wall/Modulus' does not accept -1"));
  check::equal("the model fails", predictions[2].failure, "the wall is too stiff");
  std::string settings;
  for (const auto &[path, value] : ramp.asked[0].settings)
    settings.append(path).append("=").append(value).append("; ");
  check::equal("entries", settings,
               "Time/End time=4 s; Materials/wall/Modulus=3 Pa; Materials/wall/Times=1 s, 7 s; ");
  check::is_true("each time once",
                 ramp.asked[0].times[1].size() == 3 && ramp.asked[0].times[1][2] == 3.25);

  const auto refused = [&](SoughtNumber wrong, const std::string &pattern)
  {
    check::throws<InputError>(
        pattern, [&]() { find_sought_entry(file, section, wrong); }, pattern);
  };
  SoughtNumber wrong = modulus;
  wrong.lower = "3";
  refused(wrong, "the entry's value, which is the start, lies outside of the bounds");
  wrong = modulus;
  wrong.upper = "-5";
  refused(wrong, "the lower bound lies above the upper one");
  wrong = modulus;
  wrong.lower = "-5";
  refused(wrong, "does not accept such a number");
  wrong = number("Materials/wall/Times 1");
  wrong.scale = FitParameter::Scale::logarithmic;
  refused(wrong, "a logarithmic scale is for positive numbers");
  wrong = number("Probes/second/Measured shift");
  wrong.lower.clear();
  refused(wrong, "the shift of a clock needs bounds");
}
} // namespace test_of_station_fit_model
