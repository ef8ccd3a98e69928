#include <continua/case/before_the_run/preflight_report.h>

#include <continua/theory/amplification.h>
#include <continua/theory/tube_waves_closed_form.h>
#include <continua/theory/womersley.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace Continua
{
namespace
{
/// Closed formulas for the pressure wave of a section at a real frequency.
struct SectionWaves
{
  SectionWaves(const TubeSection &section, const double omega)
      : young(section.hoop_modulus(omega)),
        tube{{section.inner_radius, section.wall_thickness(), section.poisson_ratio(omega).real(),
              section.fluid.density, section.fluid.inverse_bulk_modulus()},
             section.fluid.shear.viscosity,
             section.wall_density()}
  {
  }

  double moens_korteweg() const { return phase_speed_of(moens_korteweg_speed(tube.tube, young)); }
  double korteweg(const Anchoring anchoring) const
  {
    return phase_speed_of(korteweg_speed(tube.tube, young, anchoring, WallTheory::thick));
  }
  /// Of a speed c = omega / k for complex k.
  static double phase_speed_of(const Complex speed) { return 1. / (1. / speed).real(); }

  Complex young; ///< [Pa]
  ClosedFormTube tube;
};

TubeSection middle_of(const TubeSection &a, const TubeSection &b)
{
  TubeSection middle = a;
  middle.inner_radius = 0.5 * (a.inner_radius + b.inner_radius);
  for (std::size_t i = 0; i < std::min(a.layer_thicknesses.size(), b.layer_thicknesses.size()); ++i)
    middle.layer_thicknesses[i] = 0.5 * (a.layer_thicknesses[i] + b.layer_thicknesses[i]);
  return middle;
}
} // namespace

PreflightReport::PreflightReport(const PreflightInput &input) : input(input)
{
  frequency = input.frequency;
  if (frequency > 0.)
    add("load frequency", frequency, "Hz",
        "90 % of the energy of '" + input.load + "' lies below it" +
            (input.load_jumps ? "; the load jumps" : ""));
  report_regions();
  if (input.is_tube)
    report_tube();
  else
    report_body_mesh();
  report_time();
  report_stiffest_mode();
}

void PreflightReport::add(const std::string &name,
                          const double value,
                          const std::string &unit,
                          const std::string &remark)
{
  list.push_back({name, value, unit, remark});
}

double PreflightReport::value(const std::string &name) const
{
  for (const Entry &entry : list)
    if (entry.name == name)
      return entry.value;
  return std::numeric_limits<double>::quiet_NaN();
}

double PreflightReport::reference_angular_frequency() const
{
  return 2. * dealii::numbers::PI * (frequency > 0. ? frequency : 1. / input.end_time);
}

void PreflightReport::report_regions()
{
  const double omega = reference_angular_frequency();
  for (const PreflightInput::Region &region : input.regions)
  {
    const Material &material = region.material;
    if (!material.is_solid())
    {
      add("speed of sound, " + region.name,
          acoustic_speed(material.density, material.inverse_bulk_modulus()), "m/s");
      continue;
    }
    const Complex shear = std::sqrt(material.complex_shear_modulus(omega) / material.density);
    const Complex bar = std::sqrt(material.complex_young_modulus(omega) / material.density);
    add("longitudinal speed, " + region.name, material.longitudinal_speed(), "m/s");
    add("bar speed, " + region.name, SectionWaves::phase_speed_of(bar), "m/s");
    add("shear speed, " + region.name, SectionWaves::phase_speed_of(shear), "m/s");
  }
}

void PreflightReport::report_tube()
{
  const PreflightInput::End &near = input.ends[0], &far = input.ends[1];
  SectionWaves waves(near.section, reference_angular_frequency());
  const Anchoring anchoring =
      near.section.tethered ? Anchoring::throughout : Anchoring::expansion_joints;
  const std::string wall = near.section.tethered ? "wall axially held" : "wall axially free";
  if (frequency == 0.)
  {
    frequency = waves.korteweg(anchoring) / (4. * input.length);
    add("tube's own frequency", frequency, "Hz",
        "no load varies over time: a quarter of a wave in the tube's length");
    waves = SectionWaves(near.section, reference_angular_frequency());
  }
  const double omega = reference_angular_frequency();
  const double radius = near.section.inner_radius, thickness = near.section.wall_thickness();
  const Material &fluid = near.section.fluid;
  add("Moens-Korteweg speed", waves.moens_korteweg(), "m/s", "thin wall, no axial stress");
  add("Korteweg speed, wall axially free", waves.korteweg(Anchoring::expansion_joints), "m/s",
      "thick wall; the early pulse also between clamped ends");
  add("Korteweg speed, wall axially held", waves.korteweg(Anchoring::throughout), "m/s",
      "thick wall, tethered along its length");

  double speed;
  double loss = std::numeric_limits<double>::quiet_NaN();
  double fluid_mass = 0.; // that moves with a unit of the wall's surface, rho I0 / (k I1) [kg/m^2]
  try
  {
    const Complex k = closed_form_wave_number(waves.tube, omega, waves.young, anchoring);
    const Complex membrane = inviscid_membrane_wave_number(waves.tube, omega, waves.young);
    speed = phase_speed(omega, k);
    loss = -std::expm1(-attenuation(k) * input.length);
    const Complex x = membrane * radius;
    fluid_mass = fluid.density * (bessel_i_ratio(0, x, 1, x) / membrane).real();
    add("phase speed at the frequency", speed, "m/s", "closed formula, " + wall);
  }
  catch (const std::domain_error &)
  {
    warning_list.push_back(
        "pre-flight: the load's frequency is above the ring frequency of the tube's wall, where "
        "its pressure wave does not propagate; the speed of long waves is used");
    speed = waves.korteweg(anchoring);
  }
  // Simpson's rule for 1/c, with R and h linear between the ends.
  const double far_speed = SectionWaves(far.section, omega).korteweg(anchoring);
  const double middle_speed =
      SectionWaves(middle_of(near.section, far.section), omega).korteweg(anchoring);
  const double near_speed = waves.korteweg(anchoring);
  if (std::abs(far_speed - near_speed) > 1e-6 * near_speed)
    add("Korteweg speed at the far end", far_speed, "m/s", wall);
  const double transit = input.length / 6. * (1. / near_speed + 4. / middle_speed + 1. / far_speed);
  std::ostringstream remark;
  remark.precision(3);
  remark << "from end to end; the run covers " << input.end_time / transit << " of it";
  add("transit time", transit, "s", remark.str());
  if (std::isfinite(loss))
    add("loss over the length", loss, "1", "of the amplitude, by viscosity and by the wall");

  if (fluid.shear.viscosity > 0.)
    add("Womersley number", Womersley(radius, fluid.density, fluid.shear.viscosity).number(omega),
        "1");
  add("added-mass ratio", fluid.density * radius / (near.section.wall_density() * thickness), "1",
      "rho_f R / (rho_s h)");
  if (fluid_mass > 0.)
    add("added-mass ratio of the wave", fluid_mass / (near.section.wall_density() * thickness), "1",
        "radial inertia of the fluid over that of the wall");
  report_tube_mesh(speed / frequency);
  report_ends(speed);
}

void PreflightReport::report_tube_mesh(const double wavelength)
{
  const Material &fluid = input.ends[0].section.fluid;
  add("wavelength", wavelength, "m", "at the frequency");
  add("cells per wavelength", wavelength / input.axial_cell, "1",
      "the longest axial cells of the fluid, " + quantity_text(input.axial_cell, "m"));
  const double nodes = input.velocities_per_cell * wavelength / input.axial_cell;
  if (nodes < least_nodes_per_wavelength)
  {
    std::ostringstream text;
    text.precision(3);
    text << "pre-flight: " << nodes
         << " velocity nodes per wavelength of the load's frequency, fewer than "
         << least_nodes_per_wavelength << ": the mesh disperses the wave; take more axial cells";
    warning_list.push_back(text.str());
  }
  if (fluid.shear.viscosity == 0.)
    return;
  const double layer =
      Womersley(input.ends[0].section.inner_radius, fluid.density, fluid.shear.viscosity)
          .layer_thickness(reference_angular_frequency());
  add("Stokes layer", layer, "m", "sqrt(2 nu / omega)");
  add("fluid cells in the Stokes layer", layer / input.normal_cell, "1",
      "the thickest cells at the wall, " + quantity_text(input.normal_cell, "m"));
  if (input.normal_cell > largest_layer_cell * layer)
    warning_list.push_back("pre-flight: the fluid's cells at the wall, " +
                           quantity_text(input.normal_cell, "m") +
                           ", are thicker than the Stokes layer of " + quantity_text(layer, "m") +
                           ": the wave's friction is wrong; grade the mesh towards the wall");
}

void PreflightReport::report_outlet(const PreflightInput::End &end, const std::string &which)
{
  if (end.outlet->network)
    return; // its impedance is that of all of its vessels
  if (end.outlet->impedance.n_ports() == 0)
  {
    add("reflection, " + which, 0., "1", "'" + end.boundary + "': the tube goes on");
    return;
  }
  const double omega = reference_angular_frequency();
  const double speed =
      SectionWaves(end.section, omega)
          .korteweg(end.section.tethered ? Anchoring::throughout : Anchoring::expansion_joints);
  const double radius = end.section.inner_radius;
  const double of_tube =
      end.section.fluid.density * speed / (dealii::numbers::PI * radius * radius);
  const Complex of_outlet = end.outlet->impedance.value(Complex(0., omega))(0, 0);
  add("reflection, " + which, std::abs((of_outlet - of_tube) / (of_outlet + of_tube)), "1",
      "'" + end.boundary + "': an outlet; the magnitude at the frequency, of a tube of " +
          quantity_text(of_tube, "Pa s/m^3"));
}

void PreflightReport::report_ends(const double speed)
{
  for (unsigned int i = 0; i < 2; ++i)
  {
    const PreflightInput::End &end = input.ends[i];
    const std::string which = i == 0 ? "near end" : "far end";
    if (end.outlet != nullptr)
      report_outlet(end, which);
    else
      add("reflection, " + which, end.flow_is_given ? 1. : -1., "1",
          "'" + end.boundary + "': " +
              (end.flow_is_given ? "the flow is prescribed (closed)"
                                 : "the pressure is prescribed (open)"));
    if (!end.wall_is_clamped && !end.rim_is_held)
      continue;
    const std::string held = end.wall_is_clamped ? "clamped " : "held ";
    std::string cell = "wall cell at the ";
    cell.append(held).append(which);
    const double nu = end.section.poisson_ratio(reference_angular_frequency()).real();
    const double bend = std::sqrt(end.section.inner_radius * end.section.wall_thickness());
    add(cell, end.wall_cell, "m",
        "sqrt(R h)/2 is " + quantity_text(0.5 * bend, "m") +
            (end.wall_is_clamped ? "" : "; '" + end.boundary + "' holds the rim of the wall"));
    if (end.wall_is_clamped)
      add("early reflection by the clamped " + which,
          2. * bend / std::pow(3. * (1. - nu * nu), 0.25) / speed, "s");
    if (end.wall_cell > largest_clamped_cell * bend)
    {
      std::ostringstream text;
      text.precision(3);
      text << "pre-flight: the wall's cells at its " << held << which << ", "
           << quantity_text(end.wall_cell, "m") << " long, do not resolve its bending over "
           << quantity_text(bend, "m") << " = sqrt(R h): "
           << (end.wall_is_clamped ? "reflections there come too early"
                                   : "the distension near it is wrong")
           << "; grade the mesh towards the ends";
      warning_list.push_back(text.str());
    }
  }
}

void PreflightReport::report_body_mesh()
{
  if (frequency == 0.)
    return;
  const double omega = reference_angular_frequency();
  for (const PreflightInput::Region &region : input.regions)
  {
    const Material &material = region.material;
    const double speed = material.is_solid()
                             ? SectionWaves::phase_speed_of(std::sqrt(
                                   material.complex_shear_modulus(omega) / material.density))
                             : acoustic_speed(material.density, material.inverse_bulk_modulus());
    const double cells = speed / frequency / region.largest_cell;
    if (std::isfinite(cells))
      add("cells per wavelength, " + region.name, cells, "1",
          material.is_solid() ? "of shear waves" : "of sound");
    if (input.velocities_per_cell * cells < least_nodes_per_wavelength)
    {
      std::ostringstream text;
      text.precision(3);
      text << "pre-flight: " << input.velocities_per_cell * cells
           << " velocity nodes per wavelength at the load's frequency in '" << region.name
           << "', fewer than " << least_nodes_per_wavelength << ": refine the mesh";
      warning_list.push_back(text.str());
    }
  }
}

void PreflightReport::report_time()
{
  if (frequency == 0.)
    return;
  const double steps = 1. / (frequency * input.step.size());
  add("time steps per period", steps, "1");
  if (steps < least_steps_per_period)
  {
    std::ostringstream text;
    text.precision(3);
    text << "pre-flight: " << steps << " time steps per period of the load's frequency, fewer than "
         << least_steps_per_period << ": take a smaller time step";
    warning_list.push_back(text.str());
  }
  const Amplification amplification(input.step, reference_angular_frequency());
  const double loss = 1. - amplification.remaining(input.end_time);
  // What round-off leaves of 1 - 1 is no damping.
  const double shown = std::abs(loss) < 1e-9 ? 0. : loss;
  add("numerical damping", shown, "1", "of the amplitude at the frequency, over the run");
  add("numerical error of the frequency", amplification.frequency_error(), "1",
      "negative: too slow");
  if (loss > largest_loss)
  {
    std::ostringstream text;
    text.precision(3);
    text << "pre-flight: the time scheme takes " << 100. * loss
         << " % of the amplitude at the load's frequency over the run: take a smaller time step or "
            "Scheme = crank nicolson";
    warning_list.push_back(text.str());
  }
}

void PreflightReport::report_stiffest_mode()
{
  // An incompressible liquid has no speed of sound, and its constraint no time of its own.
  double fastest = 0.;
  bool is_incompressible = false;
  for (const PreflightInput::Region &region : input.regions)
  {
    const double speed =
        region.material.is_solid()
            ? region.material.longitudinal_speed()
            : acoustic_speed(region.material.density, region.material.inverse_bulk_modulus());
    if (std::isfinite(speed))
      fastest = std::max(fastest, speed / region.smallest_cell);
    else
      is_incompressible = true;
  }
  if (fastest > 0.)
    add("largest Courant number", fastest * input.step.size(), "1",
        is_incompressible ? "of longitudinal waves and sound in the shortest edge; not of what is "
                            "incompressible"
                          : "of sound and longitudinal waves in the shortest edge");
  const double courant =
      is_incompressible ? std::numeric_limits<double>::infinity() : fastest * input.step.size();
  // The shortest wave on the mesh has two nodes.
  const double theta = std::min(dealii::numbers::PI * input.velocities_per_cell * courant, 1e6);
  const double radius = Amplification(input.step, theta / input.step.size()).spectral_radius();
  add("stiffest mode, factor per step", radius, "1",
      input.step.update == Update::midpoint ? "kept, as all modes" : "");
  if (input.step.update == Update::trapezoidal && theta > 4.)
  {
    std::ostringstream text;
    text.precision(3);
    text << "pre-flight: with Update = trapezoidal modes that the step does not resolve change "
            "their sign from step to step and lose only "
         << 100. * (1. - radius) << " % of their amplitude in each; take Update = implicit";
    warning_list.push_back(text.str());
  }
}

std::string PreflightReport::headline() const
{
  std::string text = "Pre-flight:";
  const double transit = value("transit time");
  if (input.frequency > 0.)
    text += " load of " + quantity_text(input.frequency, "Hz") + ",";
  if (std::isfinite(transit))
    text += " tube wave " + quantity_text(input.length / transit, "m/s") +
            (input.starts_loaded ? " (of the wall without load), " : ", ") +
            quantity_text(transit, "s") + " to the far end";
  else if (const double courant = value("largest Courant number"); std::isfinite(courant))
    text += " largest Courant number " + quantity_text(courant, "1");
  else
    text += " no waves of compression";
  return text + "; more in log.txt";
}
} // namespace Continua
