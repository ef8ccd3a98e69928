#ifndef continua_tests_inference_records_h
#define continua_tests_inference_records_h

#include <continua/inference/data_record.h>
#include <continua/inference/fit_parameter.h>

#include <cmath>
#include <vector>

/// Parameters and records of the tests, whose unit is 1.
inline Continua::FitParameter
parameter_of(const std::string &name,
             const double start,
             const Continua::FitParameter::Scale scale = Continua::FitParameter::Scale::linear)
{
  Continua::FitParameter parameter;
  parameter.name = name;
  parameter.unit = "1";
  parameter.start = start;
  parameter.scale = scale;
  return parameter;
}

inline Continua::FitParameter bounded_parameter(const std::string &name,
                                                const double start,
                                                const double lower,
                                                const double upper)
{
  Continua::FitParameter parameter = parameter_of(name, start);
  parameter.lower = lower;
  parameter.upper = upper;
  return parameter;
}

inline Continua::FitParameter held_parameter(const std::string &name, const double value)
{
  return bounded_parameter(name, value, value, value);
}

/// At the times 0, `interval`, 2 `interval` ... `deviation` NaN: unknown.
inline Continua::DataRecord uniform_record(const std::string &name,
                                           const double interval,
                                           const std::vector<double> &values,
                                           const double deviation)
{
  Continua::DataRecord record;
  record.name = name;
  record.unit = "1";
  record.interval = interval;
  for (std::size_t i = 0; i < values.size(); ++i)
    record.times.push_back(i * interval);
  record.values = values;
  record.noise.standard_deviation = deviation;
  return record;
}

#endif
