#ifndef continua_theory_bar_record_h
#define continua_theory_bar_record_h

#include <continua/inference/data_record.h>
#include <continua/materials/material.h>

#include <string>
#include <vector>

namespace Continua
{
/// What a test of a bar shows.
enum class BarQuantity
{
  relaxation, ///< stress over the strain that is held [Pa], over time [s]
  creep,      ///< strain over the stress that is there from t = 0 on [1/Pa], over time [s]
  modulus     ///< storage and loss modulus of Young's modulus in turn [Pa], over frequency [Hz]
};

/// Rows of a test of a bar that is pulled along its axis and free at its sides, at small strains.
struct BarRecord
{
  BarQuantity quantity = BarQuantity::relaxation;
  /// Time in which the strain of a relaxation rises evenly, from t = 0 on; 0: it is there at once
  /// [s].
  double loading_time = 0.;
  /// Times > 0 [s], increasing, or frequencies > 0 [Hz], each twice.
  std::vector<double> abscissae;
  std::vector<double> values;      ///< measured, in the unit of the quantity
  std::vector<double> noise_units; ///< of each value: what the noise is a share of, in this unit
  /// Whether logarithms are compared: noise that is a share of each value, which is positive.
  bool is_logarithmic = false;

  std::string name() const; ///< "relaxation", "creep", "modulus"
  std::string unit() const; ///< "Pa" or "1/Pa"

  /// What a bar of the material shows at the abscissae: exact for branches, viscosity and power law
  /// (UniaxialResponse, PowerLawResponse). A power law has a constant Poisson's ratio here.
  std::vector<double> predicted(const Material &material) const;
  /// Measured over noise_units, or the logarithms of the values in SI [1], independent of each
  /// other, with noise of that standard deviation [1]; NaN: unknown, one for the record.
  DataRecord data_record(double standard_deviation) const;
  /// predicted() in the same form [1].
  std::vector<double> scaled_prediction(const Material &material) const;

private:
  std::vector<double> scaled(std::vector<double> numbers) const;
};
} // namespace Continua

#endif
