#ifndef continua_inference_interpolated_model_h
#define continua_inference_interpolated_model_h

#include <continua/inference/fit_model.h>
#include <continua/inference/fit_parameter.h>

#include <string>
#include <vector>

namespace Continua
{
/**
 * A model by polynomials in the coordinates of its parameters within a box around a point: Lagrange
 * interpolation of the values of another model at Chebyshev's nodes (J.-P. Berrut, L. N. Trefethen,
 * SIAM Review 46, 2004, 501). It stands for a dear model where thousands of fits stay near one
 * point.
 */
class InterpolatedModel : public FitModel
{
public:
  /// `centre`: of the box [unit of each parameter]; `half_widths`: in coordinates, 0 for a number
  /// that stays. `n_nodes`: in each direction, two at least. Throws RunError if the model fails in
  /// the box.
  InterpolatedModel(FitModel &model,
                    const std::vector<FitParameter> &parameters,
                    const std::vector<double> &centre,
                    const std::vector<double> &half_widths,
                    unsigned int n_nodes);

  std::vector<Prediction> predict(const std::vector<std::vector<double>> &sets) override;
  unsigned int n_evaluations() const { return values.size(); } ///< of the other model
  /// The ends of the box [unit of each parameter].
  std::vector<double> lower() const { return end_of_box(-1.); }
  std::vector<double> upper() const { return end_of_box(1.); }

private:
  std::vector<FitParameter> parameters;
  std::vector<double> centre, half_widths; ///< coordinates
  std::vector<std::vector<double>> nodes;  ///< by parameter, from -1 to 1
  std::vector<std::vector<double>> values; ///< by node of the grid, the first parameter fastest

  std::vector<double> end_of_box(double sign) const;
  /// Lagrange's polynomials of a parameter at a coordinate.
  std::vector<double> weights(unsigned int parameter, double coordinate) const;
};
} // namespace Continua

#endif
