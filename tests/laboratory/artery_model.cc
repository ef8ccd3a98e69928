// Diameters and forces of an artery under pressure, by the quadrature of another program; and their
// derivatives.

#include <continua/laboratory/artery_model.h>

#include <cmath>

#include "../unit_test.h"

namespace test_of_artery_model
{
using namespace Continua;

namespace
{
constexpr double degree = 3.14159265358979323846 / 180.;

/// Angle from the circumference.
Material layer_of(const double shear_modulus,
                  const double stiffness,
                  const double exponent,
                  const double angle)
{
  Material material;
  material.density = 1050.;
  material.shear.branches = {{shear_modulus}};
  material.strain_law_parameters.type = "holzapfel gasser ogden";
  material.strain_law_parameters.fibre_stiffness = stiffness;
  material.strain_law_parameters.fibre_exponent = exponent;
  material.strain_law_parameters.fibre_angle = 90. * degree - angle * degree;
  material.prestretch.opening_angle = 160. * degree;
  material.set_strain_law();
  return material;
}

/// The closed ring of the opened one of scripts/references/solids/artery.py, whose radii
/// scripts/references/tables/inflation_table.py prints.
TubeSection ring()
{
  TubeSection section;
  section.inner_radius = 0.7265981e-3;
  section.layer_thicknesses = {0.2626498e-3, 0.1207572e-3};
  section.layers = {layer_of(3000., 2363.2, 0.8393, 29.), layer_of(300., 562., 0.7112, 62.)};
  return section;
}

ArteryParameter parameter_of(const std::string &key, const std::vector<std::size_t> &layers)
{
  ArteryParameter parameter;
  parameter.entry = find_artery_entry(key);
  parameter.layers = layers;
  parameter.fit.name = key;
  parameter.fit.unit = parameter.entry->unit();
  parameter.fit.lower = parameter.entry->lower;
  parameter.fit.upper = parameter.entry->upper;
  parameter.fit.scale = parameter.entry->scale;
  parameter.fit.start = parameter.entry->value(ring().layers[layers[0]]);
  return parameter;
}
} // namespace

UNIT_TEST(artery_model)
{
  InflationTest test;
  test.has_force = true;
  for (const double pressure : {5e3, 13.33e3})
    test.rows.push_back({1.7, pressure, 2.8e-3, 0.});
  test.rows.push_back({1.5, 9e3, 2.8e-3, 0.});
  const std::vector<ArteryParameter> parameters = {
      parameter_of("Young's modulus", {0}), parameter_of("Fibre stiffness", {0}),
      parameter_of("Fibre exponent", {1}),  parameter_of("Fibre dispersion", {0}),
      parameter_of("Fibre angle", {0}),     parameter_of("Opening angle", {0, 1})};
  std::vector<double> set;
  for (const ArteryParameter &parameter : parameters)
    set.push_back(parameter.fit.start);
  check::relative("Young's modulus of the layer", set[0], 9000., 1e-14);
  check::equal("its text", parameters[0].entry->text(set[0]), "9000 Pa");
  check::equal("text of an angle", parameters[4].entry->text(set[4]), "61 deg");

  ArteryModel model(ring(), parameters, test);
  const LoadedTube opened = model.tube(set);
  check::relative("radius of the opened ring", opened.section().inner_radius, 1.43e-3, 1e-6);
  check::relative("layer of the opened ring", opened.section().layer_thicknesses[0], 0.26e-3, 2e-6);
  const std::vector<double> values = model.predict({set})[0].values;
  const auto force = [](const double of_wall, const double radius, const double pressure)
  { return of_wall - 180. * degree * radius * radius * pressure; };
  check::relative("diameter under 5 kPa", values[0], 2. * 1.2990663e-3, 1e-6);
  check::relative("diameter under 13.33 kPa", values[1], 2. * 1.4276468e-3, 1e-6);
  check::absolute("force under 5 kPa", values[3], force(0.0472018, 1.1284315e-3, 5e3), 1e-7);
  check::absolute("force under 13.33 kPa", values[4], force(0.0846735, 1.2743468e-3, 13.33e3),
                  1e-7);

  // Against differences of the whole prediction.
  std::vector<std::vector<double>> by_parameter;
  check::is_true("there are derivatives", model.derivatives(set, by_parameter));
  for (std::size_t k = 0; k < set.size(); ++k)
  {
    const double h = 1e-4 * (set[k] > 0. ? set[k] : 0.1);
    std::vector<double> high = set, low = set;
    high[k] += h;
    low[k] = std::max(low[k] - h, parameters[k].fit.lower);
    const std::vector<FitModel::Prediction> both = model.predict({high, low});
    for (const std::size_t first : {std::size_t{0}, test.rows.size()})
    {
      double largest = 0., difference = 0.;
      for (std::size_t i = first; i < first + test.rows.size(); ++i)
      {
        const double slope = (both[0].values[i] - both[1].values[i]) / (high[k] - low[k]);
        largest = std::max(largest, std::abs(slope));
        difference = std::max(difference, std::abs(slope - by_parameter[k][i]));
      }
      check::absolute((first == 0 ? "diameter by " : "force by ") + parameters[k].fit.name,
                      difference / largest, 0., 1e-3);
    }
  }
  // The inner diameter.
  test.is_outer = false;
  check::relative("inner diameter", model.predict({set})[0].values[1], 2. * 1.2743468e-3, 1e-6);
  check::equal("record of it", test.data_records(1e-6, 1e-4)[0].name, "inner diameter");
  // A wall of rubber bears no more than mu ln(B/A).
  TubeSection rubber = ring();
  for (Material &layer : rubber.layers)
    layer.strain_law_parameters.type = "neo hookean";
  const std::vector<ArteryParameter> modulus = {parameter_of("Young's modulus", {0, 1})};
  const FitModel::Prediction failed = ArteryModel(rubber, modulus, test).predict({{9e3}})[0];
  check::is_true("a wall that gives way has no values", failed.values.empty());
  check::is_true("and says where", check::matches(failed.failure, "axial stretch 1.7 and 5000 Pa"));
}
} // namespace test_of_artery_model
