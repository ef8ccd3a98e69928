// A tube under pressure in finite deformation: closed form of rubber, the quadrature of another
// program for an artery, Lame's tube as the limit, and a branch that relaxes.

#include <continua/theory/closed_form_waves.h>
#include <continua/theory/korteweg.h>
#include <continua/theory/loaded_tube.h>

#include "../unit_test.h"

namespace test_of_loaded_tube
{
using namespace Continua;

namespace
{
constexpr double degree = 3.14159265358979323846 / 180.;

Material layer_of(const double shear_modulus,
                  const StrainLawParameters &law = StrainLawParameters())
{
  Material material;
  material.density = 1050.;
  material.shear.branches = {{shear_modulus}};
  material.strain_law_parameters = law;
  material.set_strain_law();
  return material;
}

/// Angle from the circumference.
StrainLawParameters fibres(const double stiffness, const double exponent, const double angle)
{
  StrainLawParameters law;
  law.type = "holzapfel gasser ogden";
  law.fibre_stiffness = stiffness;
  law.fibre_exponent = exponent;
  law.fibre_angle = 90. * degree - angle * degree;
  return law;
}

TubeSection tube(const double inner_radius,
                 const std::vector<double> &thicknesses,
                 const std::vector<Material> &layers)
{
  TubeSection section;
  section.inner_radius = inner_radius;
  section.layer_thicknesses = thicknesses;
  section.layers = layers;
  section.fluid.density = 1060.;
  return section;
}

/// Of scripts/references/solids/artery.py.
TubeSection artery(const double inner_radius, const double opening_angle)
{
  std::vector<Material> layers = {layer_of(3000., fibres(2363.2, 0.8393, 29.)),
                                  layer_of(300., fibres(562., 0.7112, 62.))};
  for (Material &layer : layers)
  {
    layer.prestretch.axial = 1.7;
    layer.prestretch.opening_angle = opening_angle * degree;
  }
  layers[1].density = 1200.;
  return tube(inner_radius, {0.26e-3, 0.13e-3}, layers);
}

/// Pressure of a branch of shear modulus 1 in the tube of the radii 1 to 2 and one layer, when the
/// inner radius goes at once from `relaxed`, where the branch has no stress, to `present`.
double pressure_of_branch(const double relaxed, const double present)
{
  constexpr unsigned int n = 20000;
  double sum = 0.;
  for (unsigned int i = 0; i < n; ++i)
  {
    const double radius = 1. + (i + 0.5) / n,
                 r = std::sqrt(present * present + radius * radius - 1.),
                 before = std::sqrt(relaxed * relaxed + radius * radius - 1.),
                 around = (r / before) * (r / before);
    sum += (around - 1. / around) * radius / (r * r) / n;
  }
  return sum;
}
} // namespace

UNIT_TEST(loaded_tube)
{
  // Rubber, plane strain: p/mu = ln(B/A) - ln(b/a) - (A^2 - a^2)(1/a^2 - 1/b^2)/2.
  const LoadedTube rubber(tube(1., {1.}, {layer_of(2e5)}));
  const double a = 1.4, b = std::sqrt(a * a + 3.);
  check::relative("rubber: outer radius", rubber.outer_radius(a), b, 1e-14);
  check::relative(
      "rubber: pressure", rubber.pressure(a),
      2e5 * (std::log(2.) - std::log(b / a) - 0.5 * (1. - a * a) * (1. / (a * a) - 1. / (b * b))),
      1e-10);
  check::relative("rubber: radius under the pressure", rubber.inner_radius(rubber.pressure(a)), a,
                  1e-10);
  // With the program's own pressure.
  const double h = 1e-5;
  check::relative("rubber: slope of the pressure", rubber.stiffness(a),
                  (rubber.pressure(a + h) - rubber.pressure(a - h)) / (2. * h), 1e-8);
  check::throws<std::domain_error>(
      "rubber: more than mu ln(B/A)", [&]() { rubber.inner_radius(2e5 * std::log(2.)); },
      "rises no further than 1386");

  // Two layers with fibres, prestretch and opening angle; numbers of
  // scripts/references/solids/artery.py.
  struct Row
  {
    double pressure, inner_radius, outer_radius, distensibility, axial_force;
  };
  const LoadedTube closed(artery(0.71e-3, 0.)), opened(artery(1.43e-3, 160.));
  const auto compare =
      [](const std::string &name, const LoadedTube &tube, const std::vector<Row> &rows)
  {
    for (const Row &row : rows)
    {
      const double inner = tube.inner_radius(row.pressure);
      check::relative(name + ": inner radius", inner, row.inner_radius, 2e-7);
      check::relative(name + ": outer radius", tube.outer_radius(inner), row.outer_radius, 2e-7);
      check::relative(name + ": distensibility", tube.distensibility(inner), row.distensibility,
                      1e-6);
      // The script has the force of the wall alone.
      const LoadedTube::Loads loads = tube.loads(inner);
      check::absolute(name + ": pressure and force at once", loads.pressure, row.pressure, 1e-6);
      check::absolute(name + ": axial force",
                      loads.axial_force + 180. * degree * inner * inner * row.pressure,
                      row.axial_force, 1e-7);
    }
  };
  compare("closed ring", closed,
          {{0., 0.4778812e-3, 0.8022504e-3, 6.532547e-4, 0.0188253},
           {5e3, 1.0622350e-3, 1.2424083e-3, 5.984159e-5, 0.0421188},
           {13.33e3, 1.1892885e-3, 1.3526427e-3, 1.350235e-5, 0.0724967}});
  compare("opened ring", opened,
          {{0., 0.4923582e-3, 0.8103285e-3, 6.704961e-4, 0.0188146},
           {13.33e3, 1.2743468e-3, 1.4276468e-3, 1.462897e-5, 0.0846735}});
  // The thin layer that stands for the wall: the same speed, 1/sqrt(rho D), from Korteweg's
  // formula.
  const TubeSection about = opened.section_about(13.33e3);
  const auto speed_of = [](const TubeSection &section)
  {
    const LongWaveTube wall{section.inner_radius, section.wall_thickness(), 0.5,
                            section.fluid.density, 0.};
    return korteweg_speed(wall, section.hoop_modulus(1e-9), Anchoring::throughout, WallTheory::thin)
        .real();
  };
  check::relative("artery: speed of long waves", speed_of(about), 8.030456, 1e-6);
  check::relative("artery: thickness", about.wall_thickness(), 0.1533e-3, 1e-5);
  check::is_true("artery: held along its axis", about.tethered);

  // A thick layer, of which Lame's formula has the same speed.
  const TubeSection thick = opened.section_about(13.33e3, WallTheory::thick);
  const LongWaveTube thick_wall{thick.inner_radius, thick.wall_thickness(), 0.5, 1060., 0.};
  check::relative(
      "artery: speed with a thick layer",
      korteweg_speed(thick_wall, thick.hoop_modulus(1e-9), Anchoring::throughout, WallTheory::thick)
          .real(),
      8.030456, 1e-6);
  // From the image under that pressure back to the opened ring and its layers.
  const auto image = [&](const double radius, const double middle, const double outer)
  {
    TubeSection section = artery(1.43e-3, 160.);
    section.inner_radius = radius;
    section.layer_thicknesses = {middle - radius, outer - middle};
    return section;
  };
  const double in_image = 1.2743468e-3, ratio = 20. / 36. / 1.7,
               between =
                   std::sqrt(in_image * in_image + ratio * (1.69e-3 * 1.69e-3 - 1.43e-3 * 1.43e-3));
  const LoadedTube found =
      LoadedTube::of_image(image(in_image, between, opened.outer_radius(in_image)), 13.33e3);
  check::relative("image: radius under another pressure", found.inner_radius(5e3),
                  opened.inner_radius(5e3), 1e-6);
  check::relative("image: radius without pressure", found.inner_radius(0.), 0.4923582e-3, 2e-6);
  check::throws<std::domain_error>(
      "image: more than rubber bears",
      [&]() { LoadedTube::of_image(tube(1., {0.1}, {layer_of(1e3)}), 1e6); },
      "no tube without load");

  // Without pressure: Lame's tube, held along its axis.
  const TubeSection straight = tube(0.01, {2e-3}, {layer_of(1e5)});
  const LongWaveTube lame{0.01, 2e-3, 0.5, 1060., 0.};
  check::relative("small strains: speed", speed_of(LoadedTube(straight).section_about(0.)),
                  korteweg_speed(lame, 3e5, Anchoring::throughout, WallTheory::thick).real(), 1e-9);

  // A branch without stress in the loaded state, and a viscosity.
  Material relaxing = layer_of(2e5);
  relaxing.shear.branches.push_back({5e4, 0.3});
  relaxing.shear.viscosity = 7.;
  const LoadedTube viscoelastic(tube(1., {1.}, {relaxing}));
  const double loaded = viscoelastic.pressure(a);
  const TubeSection section = viscoelastic.section_about(loaded);
  const Shear &shear = section.layers.at(0).shear;
  const double slope = (pressure_of_branch(a, a + h) - pressure_of_branch(a, a - h)) / (2. * h);
  // dp/da = 4 mu h/a^2 of the thin layer.
  const double of_thin_layer = 4. * (b - a) / (a * a);
  check::relative("branch: slope of its pressure",
                  shear.branches.at(1).shear_modulus * of_thin_layer, 5e4 * slope, 1e-6);
  check::relative("branch: relaxation time", shear.branches.at(1).relaxation_time, 0.3, 1e-15);
  check::relative("viscosity", shear.viscosity * of_thin_layer, 7. * slope, 1e-6);
  check::relative("spring: slope of its pressure",
                  shear.branches.at(0).shear_modulus * of_thin_layer, rubber.stiffness(a), 1e-9);
  // Mass of the wall over its present area: the undeformed one over the undeformed area here.
  check::relative("density", section.layers.at(0).density, 1050., 1e-12);
  // By the areas of the layers, 0.26 and 0.13 mm from 1.43 mm on.
  check::relative("density of a stretched artery", about.layers.at(0).density,
                  (1050. * 0.8112 + 1200. * 0.4563) / (0.8112 + 0.4563), 1e-12);

  // Two layers with a branch each and a prestretch: J0 = 1/1.5, 2 mm and 1 mm from 10 mm on. About
  // the state of the inner radius 12 mm the layers are between r^2 = 144, 144 + 44/1.5 and
  // 144 + 69/1.5 mm^2.
  Material first = layer_of(1e5), second = layer_of(3e5);
  first.shear.branches.push_back({5e4, 0.3});
  second.shear.branches.push_back({2e4, 0.1});
  for (Material *const layer : {&first, &second})
    layer->prestretch.axial = 1.5;
  const LoadedTube two_layers(tube(0.01, {2e-3, 1e-3}, {first, second}));
  const TubeSection two = two_layers.section_about(two_layers.pressure(0.012));
  const double inside = 144e-6, middle = inside + 44e-6 / 1.5, outside = inside + 69e-6 / 1.5,
               thickness = std::sqrt(outside) - std::sqrt(inside);
  const auto part = [&](const double inner_square, const double outer_square)
  { return std::pow(0.012, 3) * (1. / inner_square - 1. / outer_square) / (2. * thickness); };
  check::relative("two layers: branch of the inner one",
                  two.layers.at(0).shear.branches.at(1).shear_modulus, 5e4 * part(inside, middle),
                  1e-9);
  check::relative("two layers: branch of the outer one",
                  two.layers.at(0).shear.branches.at(2).shear_modulus, 2e4 * part(middle, outside),
                  1e-9);

  // The mean hoop stress is p a/h.
  const double mean = 13.33e3, change = 1.;
  const auto hoop = [&](const double pressure)
  {
    const double inner = opened.inner_radius(pressure);
    return pressure * inner / (opened.outer_radius(inner) - inner);
  };
  std::vector<WaveMode> modes;
  ClosedFormWaves(about, WaveLevel::womersley, 0.).evaluate(1e-3, modes);
  check::relative("hoop stress of a wave", modes.at(0).hoop_stress.real(),
                  (hoop(mean + change) - hoop(mean - change)) / (2. * change), 1e-4);

  // A ring that opens nearly by a full turn.
  const LoadedTube wide(artery(20e-3, 350.));
  check::relative("opening angle of 350 degrees", wide.pressure(wide.inner_radius(5e3)), 5e3, 1e-9);

  check::throws<std::invalid_argument>(
      "a compressible layer",
      []()
      {
        Material compressible = layer_of(1e5);
        compressible.compression = Compression::elastic(1e-6);
        LoadedTube(tube(1., {1.}, {compressible}));
      },
      "not incompressible");
  check::throws<std::invalid_argument>(
      "no wall", []() { LoadedTube(tube(1., {}, {})); }, "no wall");
}
} // namespace test_of_loaded_tube
