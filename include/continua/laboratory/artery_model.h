#ifndef continua_laboratory_artery_model_h
#define continua_laboratory_artery_model_h

#include <continua/inference/fit_model.h>
#include <continua/inference/fit_parameter.h>
#include <continua/laboratory/artery_entry.h>
#include <continua/laboratory/inflation_test.h>
#include <continua/theory/loaded_tube.h>

#include <string>
#include <vector>

namespace Continua
{
/// A number that is sought, and the entries of layers that have it.
struct ArteryParameter
{
  FitParameter fit;
  const ArteryEntry *entry = nullptr;
  std::vector<std::size_t> layers; ///< numbers of the layers, from the inside
};

/**
 * Parameters of the layers of an artery -> diameters and axial forces of an inflation-extension
 * test (LoadedTube). The ring without load, which is closed, is given by its radii; with opening
 * angles its layers are those of the opened ring that closes to these radii.
 */
class ArteryModel : public FitModel
{
public:
  /// `ring`: inner radius, thicknesses and layers of the ring without load. `test` must outlive
  /// this.
  ArteryModel(const TubeSection &ring,
              const std::vector<ArteryParameter> &parameters,
              const InflationTest &test);

  /// A set in which some row has no equilibrium has a failure.
  std::vector<Prediction> predict(const std::vector<std::vector<double>> &sets) override;
  /// At the radius of each row the loads are differentiated by differences; the condition that the
  /// pressure stays gives the change of the radius.
  bool derivatives(const std::vector<double> &set,
                   std::vector<std::vector<double>> &by_parameter) override;

  /// The tube of these parameters without axial stretch; its section is that of the opened ring.
  /// Throws std::domain_error if none closes to the radii that are given.
  LoadedTube tube(const std::vector<double> &set) const;

private:
  const TubeSection ring;
  const std::vector<ArteryParameter> parameters;
  const InflationTest &test;

  /// The same at the axial stretch of each row that differs from the row before.
  std::vector<LoadedTube> tubes_of_rows(const LoadedTube &tube) const;
  /// Inner radius of each row [m].
  std::vector<double> radii(const std::vector<LoadedTube> &tubes) const;
  double diameter(const LoadedTube &tube, double inner_radius) const;
  std::size_t n_values() const { return test.rows.size() * (test.has_force ? 2 : 1); }
};
} // namespace Continua

#endif
