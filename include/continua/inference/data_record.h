#ifndef continua_inference_data_record_h
#define continua_inference_data_record_h

#include <continua/inference/noise_model.h>

#include <string>
#include <vector>

namespace Continua
{
/// A record of data with one kind of noise.
struct DataRecord
{
  std::string name;           ///< "stations 0.1 m: pressure"
  std::string unit;           ///< SI
  double interval = 0.;       ///< [s] between its values (uniform); 0: the values have no order
  std::vector<double> times;  ///< [s], or the abscissa of values without an order
  std::vector<double> values; ///< measured [unit]; empty in the design of an experiment
  NoiseModel noise;

  std::size_t size() const { return times.size(); }
};

/// Throws std::invalid_argument, with the name and what is wrong, for no record, a record without
/// times, values (if `with_values`) of another number than times or that are not finite, and noise
/// that cannot be whitened (its standard deviation may be unknown if `with_values`).
void check_data_records(const std::vector<DataRecord> &records, bool with_values);

/// All values of records one after another, cut into records again.
std::vector<std::vector<double>> by_record(const std::vector<DataRecord> &records,
                                           const std::vector<double> &values);
} // namespace Continua

#endif
