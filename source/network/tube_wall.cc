#include <continua/network/tube_wall.h>

#include <continua/materials/neo_hookean.h>
#include <continua/network/neo_hookean_wall.h>
#include <continua/network/square_root_wall.h>
#include <continua/network/tabulated_wall.h>
#include <continua/network/wall_material.h>
#include <continua/theory/loaded_tube.h>
#include <continua/theory/saint_venant_kirchhoff_tube.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace Continua
{
namespace
{
/// Of the liquid's compliance over that of the wall: the speed of waves is wrong by half of it.
constexpr double largest_share_of_liquid = 1e-3;

double area_of(const TubeSection &section)
{
  return FlowLaw::pi * section.inner_radius * section.inner_radius;
}

/// Young's modulus and relaxation of a layer about its state without strain.
WallMaterial material_of(const Material &layer)
{
  Material small = layer;
  small.strain_law.reset();
  try
  {
    return WallMaterial::of(small);
  }
  catch (const std::domain_error &error)
  {
    throw std::domain_error(std::string("has a wall that ") + error.what());
  }
}

/// The pressure [Pa] of an inner radius [m] of a section of finite strain.
std::function<double(double)> finite_law_of(const TubeSection &section)
{
  if (section.layers.front().strain_law->has_own_mean_stress())
    return [tube = SaintVenantKirchhoffTube(section)](const double radius)
    { return tube.pressure(radius); };
  return [tube = LoadedTube(section)](const double radius) { return tube.pressure(radius); };
}

/// The walls of a tube of finite strain. Over the area relative to that without load the pressure
/// depends on thickness over radius alone, if the layers have the same shares of the thickness
/// everywhere: so a few tables serve all sections. They are linear between their ratios, as the
/// pressure of a thin wall is.
class TableOfWalls
{
public:
  TableOfWalls(const std::function<TubeSection(double)> &section_at,
               const double length,
               const unsigned int n_cells,
               const double shift)
      : shift(shift)
  {
    const TubeSection first = section_at(0.);
    least = most = ratio_of(first);
    for (unsigned int i = 1; i <= 2 * n_cells; ++i)
    {
      const TubeSection section = section_at(0.5 * i * length / n_cells);
      least = std::min(least, ratio_of(section));
      most = std::max(most, ratio_of(section));
      for (std::size_t layer = 0; layer < section.layers.size(); ++layer)
        has_same_shares = has_same_shares &&
                          std::abs(section.layer_thicknesses[layer] / section.wall_thickness() -
                                   first.layer_thicknesses[layer] / first.wall_thickness()) < 1e-9;
    }
    if (!has_same_shares)
      return;
    const unsigned int n = most > least * (1. + 1e-9) ? n_ratios : 1;
    for (unsigned int i = 0; i < n; ++i)
    {
      TubeSection section = first;
      const double ratio = n > 1 ? least + i * (most - least) / (n - 1) : least;
      for (double &thickness : section.layer_thicknesses)
        thickness *= ratio / ratio_of(first);
      tables.emplace_back(area_of(section), finite_law_of(section), shift);
    }
  }

  TabulatedWall at(const TubeSection &section) const
  {
    if (!has_same_shares)
      return {area_of(section), finite_law_of(section), shift};
    if (tables.size() == 1)
      return {area_of(section), tables.front(), tables.front(), 0.};
    const double place = std::clamp((ratio_of(section) - least) / (most - least), 0., 1.) *
                         static_cast<double>(tables.size() - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(place), tables.size() - 2);
    return {area_of(section), tables[i], tables[i + 1], place - static_cast<double>(i)};
  }

private:
  static constexpr unsigned int n_ratios = 17;
  double shift, least = 0., most = 0.; ///< [Pa]; thickness over radius [1]
  bool has_same_shares = true;
  std::vector<TabulatedWall> tables; ///< of equally spaced ratios

  static double ratio_of(const TubeSection &section)
  {
    return section.wall_thickness() / section.inner_radius;
  }
};
} // namespace

TubeWall::TubeWall(const TubeSection &section, const WallTheory theory)
    : section(section), theory(theory)
{
  if (section.layers.empty())
    throw std::domain_error("has no wall that gives way");
  if (section.fluid.shear.flow_curve || section.fluid.is_solid())
    throw std::domain_error("has a liquid that is not Newtonian");
  if (section.axial_stiffness != 0. || section.axial_damping != 0.)
    throw std::domain_error("has a support along its axis");
  for (const Material &layer : section.layers)
    if ((layer.strain_law == nullptr) != (section.layers.front().strain_law == nullptr))
      throw std::domain_error("has layers of small and of finite strain");
  set_relaxation();
  if (is_finite())
    check_finite();
  const double share = section.fluid.inverse_bulk_modulus() * density_times_speed_squared();
  if (share > largest_share_of_liquid)
    throw std::domain_error("has a liquid that is compressible beside the wall: it takes up " +
                            std::to_string(100. * share) + " % of what the wall does");
}

void TubeWall::check_finite() const
{
  if (!section.tethered)
    throw std::domain_error("is free along its axis, and the law of a wall of finite strain is "
                            "that of one which is held");
  if (section.radial_stiffness != 0. || section.radial_damping != 0.)
    throw std::domain_error("has a support around a wall of finite strain");
  // The branches of a vessel are of the stiffness of its wall law. Those of a layer are of its
  // matrix without stress, which is another stiffness where fibres or a prestretch bear the load.
  for (const Material &layer : section.layers)
    if (!relaxing.is_elastic() &&
        (layer.strain_law_parameters.has_fibres() || layer.prestretch.exists()))
      throw std::domain_error(
          "has a wall with fibres or a prestretch that relaxes, and the branches "
          "of a vessel are of the stiffness of the whole wall");
  bool all_linear = true, all_incompressible = true;
  for (const Material &layer : section.layers)
  {
    const bool is_linear = layer.strain_law->has_own_mean_stress() && !layer.prestretch.exists();
    all_linear = all_linear && is_linear;
    all_incompressible =
        all_incompressible && layer.is_incompressible() && !layer.strain_law->has_own_mean_stress();
  }
  if (!all_linear && !all_incompressible)
    throw std::domain_error("has a compressible wall of finite strain whose law is not that of "
                            "Saint-Venant and Kirchhoff");
}

void TubeWall::set_relaxation()
{
  const double thickness = section.wall_thickness();
  double total = 0., viscosity = 0.;
  for (std::size_t i = 0; i < section.layers.size(); ++i)
  {
    const WallMaterial material = material_of(section.layers[i]);
    const double modulus = material.youngs_modulus * section.layer_thicknesses[i] / thickness;
    total += modulus;
    viscosity += modulus * material.relaxation.damping_time;
    for (const WallRelaxation::Branch &branch : material.relaxation.branches)
      relaxing.branches.push_back({modulus * branch.share, branch.relaxation_time});
  }
  wall_share = total;
  // What is around stands beside the wall, as it does in TubeSection::hoop_modulus().
  const double nu = section.poisson_ratio(0.).real(), psi = section.tethered ? 1. - nu * nu : 1.,
               of_support =
                   psi * section.inner_radius * (section.inner_radius + thickness) / thickness;
  total += of_support * section.radial_stiffness;
  viscosity += of_support * section.radial_damping;
  wall_share /= total;
  relaxing.damping_time = viscosity / total;
  for (WallRelaxation::Branch &branch : relaxing.branches)
    branch.share /= total;
}

bool TubeWall::is_neo_hookean() const
{
  for (const Material &layer : section.layers)
    if (dynamic_cast<const NeoHookean *>(layer.strain_law.get()) == nullptr ||
        layer.prestretch.exists() ||
        layer.long_term_shear_modulus() != section.layers.front().long_term_shear_modulus())
      return false;
  return true;
}

double TubeWall::density_times_speed_squared() const
{
  if (is_neo_hookean())
  {
    const NeoHookeanWall wall(area_of(section), section.wall_area(), 0.,
                              section.layers.front().long_term_shear_modulus());
    return wall.reference_area() * wall.stiffness(wall.reference_area());
  }
  if (is_finite())
  {
    // R/2 dp/dR.
    const std::function<double(double)> pressure = finite_law_of(section);
    constexpr double step = 1e-4;
    return (pressure(section.inner_radius * (1. + step)) -
            pressure(section.inner_radius * (1. - step))) /
           (4. * step);
  }
  const LongWaveTube tube{section.inner_radius, section.wall_thickness(),
                          section.poisson_ratio(0.).real(), section.fluid.density, 0.};
  const double speed =
      korteweg_speed(tube, section.hoop_modulus(0.),
                     section.tethered ? Anchoring::throughout : Anchoring::expansion_joints, theory)
          .real();
  return section.fluid.density * speed * speed;
}

double TubeWall::hoop_stress(const double pressure, const double inner_radius) const
{
  if (!is_finite())
    return wall_share * pressure * section.inner_radius / section.wall_thickness();
  // As LoadedTube::outer_radius(), of all laws: with a prestretch the section is not that of the
  // mesh.
  double squared = inner_radius * inner_radius, inner = section.inner_radius;
  for (std::size_t i = 0; i < section.layers.size(); ++i)
  {
    const double thickness = section.layer_thicknesses[i];
    squared += section.layers[i].prestretch.volume_ratio(1.) * thickness * (2. * inner + thickness);
    inner += thickness;
  }
  return pressure * inner_radius / (std::sqrt(squared) - inner_radius);
}

std::unique_ptr<Vessel> TubeWall::make(const VesselDescription &description,
                                       const FlowLaw &flow_law,
                                       const std::function<TubeSection(double)> &section_at,
                                       const WallTheory theory,
                                       const double shift)
{
  const TubeWall first(section_at(0.), theory);
  std::unique_ptr<Vessel> vessel;
  if (!first.is_finite())
    vessel = make_vessel<SquareRootWall>(
        description, flow_law,
        [&](const double z)
        {
          const TubeSection section = section_at(z);
          return SquareRootWall(area_of(section), shift,
                                TubeWall(section, theory).density_times_speed_squared());
        });
  else if (first.is_neo_hookean())
    vessel = make_vessel<NeoHookeanWall>(description, flow_law,
                                         [&](const double z)
                                         {
                                           const TubeSection section = section_at(z);
                                           return NeoHookeanWall(
                                               area_of(section), section.wall_area(), shift,
                                               section.layers.front().long_term_shear_modulus());
                                         });
  else
  {
    const TableOfWalls walls(section_at, description.length, description.n_cells, shift);
    vessel = make_vessel<TabulatedWall>(description, flow_law,
                                        [&](const double z) { return walls.at(section_at(z)); });
  }
  if (!first.relaxing.is_elastic())
    vessel->set_relaxation(first.relaxing);
  return vessel;
}
} // namespace Continua
