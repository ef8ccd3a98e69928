#include <continua/network/tube_wall.h>

#include <continua/network/neo_hookean_wall.h>
#include <continua/network/square_root_wall.h>
#include <continua/network/tabulated_wall.h>
#include <continua/network/wall_material.h>
#include <continua/theory/loaded_tube.h>
#include <continua/theory/saint_venant_kirchhoff_tube.h>

#include <cmath>
#include <stdexcept>

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
  double whole = 0., viscosity = 0.;
  for (std::size_t i = 0; i < section.layers.size(); ++i)
  {
    const WallMaterial material = material_of(section.layers[i]);
    const double modulus = material.youngs_modulus * section.layer_thicknesses[i] / thickness;
    whole += modulus;
    viscosity += modulus * material.relaxation.damping_time;
    for (const WallRelaxation::Branch &branch : material.relaxation.branches)
      relaxing.branches.push_back({modulus * branch.share, branch.relaxation_time});
  }
  wall_share = whole;
  // What is around stands beside the wall, as it does in TubeSection::hoop_modulus().
  const double nu = section.poisson_ratio(0.).real(), psi = section.tethered ? 1. - nu * nu : 1.,
               of_support =
                   psi * section.inner_radius * (section.inner_radius + thickness) / thickness;
  whole += of_support * section.radial_stiffness;
  viscosity += of_support * section.radial_damping;
  wall_share /= whole;
  relaxing.damping_time = viscosity / whole;
  for (WallRelaxation::Branch &branch : relaxing.branches)
    branch.share /= whole;
}

std::function<double(double)> TubeWall::finite_law() const
{
  if (section.layers.front().strain_law->has_own_mean_stress())
    return [tube = SaintVenantKirchhoffTube(section)](const double radius)
    { return tube.pressure(radius); };
  return [tube = LoadedTube(section)](const double radius) { return tube.pressure(radius); };
}

bool TubeWall::is_neo_hookean() const
{
  for (const Material &layer : section.layers)
    if (layer.strain_law_parameters.type != "neo hookean" || layer.prestretch.exists() ||
        layer.long_term_shear_modulus() != section.layers.front().long_term_shear_modulus())
      return false;
  return true;
}

double TubeWall::density_times_speed_squared() const
{
  if (is_neo_hookean() && is_finite())
  {
    const NeoHookeanWall wall(area_of(section), section.wall_area(), 0.,
                              section.layers.front().long_term_shear_modulus());
    return wall.reference_area() * wall.stiffness(wall.reference_area());
  }
  if (is_finite())
  {
    // R/2 dp/dR.
    const std::function<double(double)> pressure = finite_law();
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
  return pressure * inner_radius /
         (std::sqrt(inner_radius * inner_radius + section.wall_area() / FlowLaw::pi) -
          inner_radius);
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
    // A uniform tube has one table.
    std::unique_ptr<TabulatedWall> last;
    TubeSection of_last;
    vessel = make_vessel<TabulatedWall>(description, flow_law,
                                        [&](const double z)
                                        {
                                          const TubeSection section = section_at(z);
                                          if (last == nullptr || !(section == of_last))
                                          {
                                            last = std::make_unique<TabulatedWall>(
                                                area_of(section),
                                                TubeWall(section, theory).finite_law(), shift);
                                            of_last = section;
                                          }
                                          return *last;
                                        });
  }
  if (!first.relaxing.is_elastic())
    vessel->set_relaxation(first.relaxing);
  return vessel;
}
} // namespace Continua
