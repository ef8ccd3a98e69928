#include <continua/laboratory/artery_model.h>

#include <continua/base/units.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Continua
{
ArteryModel::ArteryModel(const TubeSection &ring,
                         const std::vector<ArteryParameter> &parameters,
                         const InflationTest &test)
    : ring(ring), parameters(parameters), test(test)
{
}

LoadedTube ArteryModel::tube(const std::vector<double> &set) const
{
  TubeSection section = ring;
  for (std::size_t k = 0; k < parameters.size(); ++k)
    for (const std::size_t layer : parameters[k].layers)
      parameters[k].entry->set(section.layers[layer], set[k]);
  bool is_opened = false;
  for (Material &layer : section.layers)
  {
    layer.set_strain_law();
    is_opened = is_opened || layer.prestretch.opening_angle > 0.;
  }
  return is_opened ? LoadedTube::of_image(section, 0.) : LoadedTube(section);
}

std::vector<LoadedTube> ArteryModel::tubes_of_rows(const LoadedTube &tube) const
{
  std::vector<LoadedTube> tubes;
  for (const InflationRow &row : test.rows)
  {
    TubeSection section = tube.section();
    for (Material &layer : section.layers)
      layer.prestretch.axial = row.axial_stretch;
    tubes.emplace_back(section);
  }
  return tubes;
}

double ArteryModel::diameter(const LoadedTube &tube, const double inner_radius) const
{
  return 2. * (test.is_outer ? tube.outer_radius(inner_radius) : inner_radius);
}

std::vector<double> ArteryModel::radii(const std::vector<LoadedTube> &tubes) const
{
  std::vector<double> radii;
  for (std::size_t i = 0; i < tubes.size(); ++i)
  {
    const InflationRow &row = test.rows[i];
    // From a little below what was measured.
    double start = 0.5 * row.diameter;
    if (test.is_outer)
    {
      const double outer = tubes[i].outer_radius(ring.inner_radius),
                   area = outer * outer - ring.inner_radius * ring.inner_radius;
      start = std::sqrt(std::max(start * start - area, 0.01 * start * start));
    }
    try
    {
      radii.push_back(tubes[i].inner_radius(row.pressure, 0.99 * start));
    }
    catch (const std::domain_error &error)
    {
      throw std::domain_error("at the axial stretch " + shortest_number(row.axial_stretch) +
                              " and " + shortest_number(row.pressure) + " Pa " + error.what());
    }
  }
  return radii;
}

std::vector<FitModel::Prediction> ArteryModel::predict(const std::vector<std::vector<double>> &sets)
{
  std::vector<Prediction> predictions;
  for (const std::vector<double> &set : sets)
  {
    Prediction prediction;
    try
    {
      const std::vector<LoadedTube> tubes = tubes_of_rows(tube(set));
      const std::vector<double> inner = radii(tubes);
      for (std::size_t i = 0; i < tubes.size(); ++i)
        prediction.values.push_back(diameter(tubes[i], inner[i]));
      for (std::size_t i = 0; test.has_force && i < tubes.size(); ++i)
        prediction.values.push_back(tubes[i].loads(inner[i]).axial_force);
    }
    catch (const std::domain_error &error)
    {
      prediction.values.clear();
      prediction.failure = error.what();
    }
    predictions.push_back(prediction);
  }
  return predictions;
}

bool ArteryModel::derivatives(const std::vector<double> &set,
                              std::vector<std::vector<double>> &by_parameter)
{
  constexpr double step = 1e-5;
  const std::size_t n_rows = test.rows.size();
  by_parameter.assign(set.size(), std::vector<double>(n_values()));
  try
  {
    const std::vector<LoadedTube> tubes = tubes_of_rows(tube(set));
    const std::vector<double> inner = radii(tubes);
    // By the radius.
    std::vector<double> of_pressure, of_force, of_diameter;
    for (std::size_t i = 0; i < n_rows; ++i)
    {
      const double h = step * inner[i];
      const LoadedTube::Loads above = tubes[i].loads(inner[i] + h),
                              below = tubes[i].loads(inner[i] - h);
      of_pressure.push_back((above.pressure - below.pressure) / (2. * h));
      of_force.push_back((above.axial_force - below.axial_force) / (2. * h));
      of_diameter.push_back((diameter(tubes[i], inner[i] + h) - diameter(tubes[i], inner[i] - h)) /
                            (2. * h));
    }
    for (std::size_t k = 0; k < set.size(); ++k)
    {
      const FitParameter &parameter = parameters[k].fit;
      const double h = step * parameter.value_per_coordinate(set[k]) * parameter.size();
      std::vector<double> high = set, low = set;
      high[k] = std::min(set[k] + h, parameter.upper);
      low[k] = std::max(set[k] - h, parameter.lower);
      const double width = high[k] - low[k];
      const std::vector<LoadedTube> above = tubes_of_rows(tube(high)),
                                    below = tubes_of_rows(tube(low));
      for (std::size_t i = 0; i < n_rows; ++i)
      {
        const LoadedTube::Loads loads_above = above[i].loads(inner[i]),
                                loads_below = below[i].loads(inner[i]);
        const double radius_by_parameter =
            -(loads_above.pressure - loads_below.pressure) / width / of_pressure[i];
        by_parameter[k][i] = (diameter(above[i], inner[i]) - diameter(below[i], inner[i])) / width +
                             of_diameter[i] * radius_by_parameter;
        if (test.has_force)
          by_parameter[k][n_rows + i] =
              (loads_above.axial_force - loads_below.axial_force) / width +
              of_force[i] * radius_by_parameter;
      }
    }
  }
  catch (const std::domain_error &)
  {
    return false;
  }
  return true;
}
} // namespace Continua
