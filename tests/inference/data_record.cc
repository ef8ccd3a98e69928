#include "../unit_test.h"
#include "records.h"

#include <continua/inference/data_record.h>

#include <stdexcept>

namespace test_of_data_record
{
using namespace Continua;

namespace
{
void refuses(const std::string &name, const DataRecord &record, const std::string &pattern)
{
  check::throws<std::invalid_argument>(
      name, [&]() { check_data_records({record}, true); }, pattern);
}
} // namespace

UNIT_TEST(data_record)
{
  const DataRecord good = uniform_record("pressure", 0.1, {1., 2.}, 0.1);
  check_data_records({good}, true);
  const auto pieces =
      by_record({good, uniform_record("flow", 0.1, {0., 0., 0.}, 1.)}, {1., 2., 3., 4., 5.});
  check::is_true("pieces", pieces[0] == std::vector<double>({1., 2.}) &&
                               pieces[1] == std::vector<double>({3., 4., 5.}));
  check::throws<std::invalid_argument>(
      "none", []() { check_data_records({}, true); }, "no record");
  DataRecord record = good;
  record.values.push_back(1.);
  refuses("length", record, "'pressure' has 3 values at 2 times");
  record = good;
  record.values[1] = undefined;
  refuses("not finite", record, "not finite");
  record = good;
  record.interval = -1.;
  refuses("interval", record, "interval");
  record = good;
  record.noise.standard_deviation = 0.;
  refuses("no noise", record, "cannot be weighted");
  record = good;
  record.noise.correlation_time = 1.;
  record.interval = 0.;
  refuses("no order", record, "values in time");
  record = good;
  record.values.clear();
  check_data_records({record}, false);
  record.noise.standard_deviation = undefined;
  check::throws<std::invalid_argument>(
      "unknown noise of an experiment", [&]() { check_data_records({record}, false); },
      "standard deviation");
  record.times.clear();
  refuses("empty", record, "has no values");
}
} // namespace test_of_data_record
