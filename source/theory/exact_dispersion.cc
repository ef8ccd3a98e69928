#include <continua/theory/exact_dispersion.h>

#include <continua/theory/arb_headers.h>
#include <continua/theory/constants.h>
#include <continua/theory/cylinder_functions.h>
#include <continua/theory/womersley.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace Continua
{
using dealii::numbers::PI;

namespace
{
using Complex = std::complex<double>;

Ball bessel_j(const unsigned int order, const Ball &argument)
{
  Ball result;
  acb_hypgeom_bessel_j(result.number, Ball(order).number, argument.number, Ball::precision);
  return result;
}

/// A size for comparing: the binary exponent of the larger part, which a double may not hold.
double size_of(const Ball &number)
{
  mag_t bound;
  mag_init(bound);
  acb_get_mag(bound, number.number);
  const double size = mag_is_zero(bound) ? -1e300 : mag_get_d_log2_approx(bound);
  mag_clear(bound);
  return size;
}

/// Gauss points and weights on (0, 1), enough for what varies smoothly through a layer.
constexpr double gauss_points[3] = {0.1127016653792583, 0.5, 0.8872983346207417};
constexpr double gauss_weights[3] = {5. / 18., 8. / 18., 5. / 18.};

/// Bits to begin with, and where certainty is not sought any more (it is not there at an exact
/// zero).
constexpr slong first_precision = 128, largest_precision = 2000;
slong more(const slong precision)
{
  return precision + precision / 2;
}

/**
 * Gauss's elimination with pivots from the whole matrix. Returns the determinant up to its sign; if
 * asked, also the vector that the matrix takes to zero when its last pivot is.
 */
Ball eliminate(std::vector<std::vector<Ball>> &matrix, std::vector<Ball> *null_vector)
{
  const unsigned int n = matrix.size();
  std::vector<unsigned int> columns(n);
  for (unsigned int i = 0; i < n; ++i)
    columns[i] = i;
  Ball determinant = 1.;
  for (unsigned int step = 0; step < n; ++step)
  {
    unsigned int row = step, column = step;
    double largest = -1e301;
    for (unsigned int i = step; i < n; ++i)
      for (unsigned int j = step; j < n; ++j)
      {
        const double size = size_of(matrix[i][columns[j]]);
        if (size > largest)
        {
          largest = size;
          row = i;
          column = j;
        }
      }
    std::swap(matrix[step], matrix[row]);
    if (row != step)
      determinant = -determinant;
    std::swap(columns[step], columns[column]);
    if (column != step)
      determinant = -determinant;
    const Ball &pivot = matrix[step][columns[step]];
    determinant *= pivot;
    if (step + 1 == n)
      break;
    for (unsigned int i = step + 1; i < n; ++i)
    {
      const Ball factor = matrix[i][columns[step]] / pivot;
      for (unsigned int j = step + 1; j < n; ++j)
        matrix[i][columns[j]] -= factor * matrix[step][columns[j]];
    }
  }
  if (null_vector != nullptr)
  {
    null_vector->assign(n, Ball());
    (*null_vector)[columns[n - 1]] = 1.;
    for (unsigned int step = n - 1; step-- > 0;)
    {
      Ball sum = 0.;
      for (unsigned int j = step + 1; j < n; ++j)
        sum += matrix[step][columns[j]] * (*null_vector)[columns[j]];
      (*null_vector)[columns[step]] = -sum / matrix[step][columns[step]];
    }
  }
  return determinant;
}
} // namespace

ExactDispersion::ExactDispersion(const TubeSection &section) : section(section)
{
  radii.push_back(section.inner_radius);
  for (const double thickness : section.layer_thicknesses)
    radii.push_back(radii.back() + thickness);
  present = {pressure_wave};
  if (!section.layers.empty())
  {
    if (!section.tethered)
      present.push_back(axial_wave);
    present.push_back(bending_wave);
    present.push_back(other_bending_wave);
  }
}

ExactDispersion::Layer
ExactDispersion::layer(const Material &material, const Complex &omega, const Complex &k) const
{
  Layer result;
  const Ball mu = material.complex_shear_modulus(omega);
  const Ball inertia = Ball(material.density) * Ball(omega) * Ball(omega);
  const Ball inverse_bulk = material.complex_inverse_bulk_modulus(omega);
  const Ball softness = mu * inverse_bulk / Ball(3.);
  const Ball stiff = Ball(1.) + Ball(4.) * softness;
  result.mu = mu;
  result.k = k;
  result.pressure = inertia / stiff;
  result.lame_term = inertia * (Ball(1.) - Ball(2.) * softness) / stiff;
  result.q_l = square_root(result.pressure * inverse_bulk - result.k * result.k);
  if (material.is_solid() || material.shear.viscosity > 0.)
    result.q_s = square_root(inertia / mu - result.k * result.k);
  return result;
}

ExactDispersion::Column ExactDispersion::column(const Layer &layer,
                                                const Ball &radius,
                                                const Ball &phi,
                                                const Ball &phi_slope,
                                                const Ball &psi,
                                                const Ball &curl)
{
  const Ball ik = Ball(imaginary) * layer.k;
  const Ball two_mu = layer.mu + layer.mu;
  const Ball phi_curvature = -phi_slope / radius - layer.q_l * layer.q_l * phi;
  const Ball psi_slope = curl - psi / radius;
  const Ball spherical = -(layer.lame_term * phi);
  Column result;
  result.u_r = phi_slope + ik * psi;
  result.u_z = curl - ik * phi;
  result.s_rr = spherical + two_mu * (phi_curvature + ik * psi_slope);
  result.s_rz =
      layer.mu * ((layer.k * layer.k - layer.q_s * layer.q_s) * psi - Ball(2.) * ik * phi_slope);
  result.s_zz = spherical - two_mu * ik * result.u_z;
  result.s_tt = spherical + two_mu * result.u_r / radius;
  return result;
}

ExactDispersion::Columns ExactDispersion::core_columns(const Layer &fluid, const Ball &radius) const
{
  const Ball zero = 0.;
  const Ball argument = fluid.q_l * radius;
  Columns columns = {
      column(fluid, radius, bessel_j(0, argument), -fluid.q_l * bessel_j(1, argument), zero, zero)};
  // A liquid without viscosity has no shear wave.
  if (section.fluid.shear.viscosity > 0.)
  {
    const Ball shear_argument = fluid.q_s * radius;
    // Scaled to one at the wall, since it grows exponentially towards it.
    columns.push_back(
        column(fluid, radius, zero, zero,
               bessel_j(1, shear_argument) / (fluid.q_s * bessel_j(0, shear_argument)), Ball(1.)));
  }
  return columns;
}

ExactDispersion::Columns ExactDispersion::wall_columns(const Layer &wall, const Ball &radius) const
{
  const Ball zero = 0.;
  const CylinderFunctions of_l(wall.q_l * radius), of_s(wall.q_s * radius);
  // Scaled to be even in q, so that the sign of the square root does not matter.
  return {column(wall, radius, of_l.j0, -wall.q_l * of_l.j1, zero, zero),
          column(wall, radius, of_l.y0, -wall.q_l * of_l.y1, zero, zero),
          column(wall, radius, zero, zero, of_s.j1 / wall.q_s, of_s.j0),
          column(wall, radius, zero, zero, of_s.y1 * wall.q_s, of_s.y0 * wall.q_s * wall.q_s)};
}

ExactDispersion::Matrix ExactDispersion::conditions(const Complex &omega, const Complex &k) const
{
  const bool viscous = section.fluid.shear.viscosity > 0.;
  const Layer fluid = layer(section.fluid, omega, k);
  const Columns core = core_columns(fluid, Ball(radii[0]));
  const unsigned int n_core = core.size(), n_layers = section.layers.size();
  const unsigned int n = n_core + 4 * n_layers;
  Matrix matrix(n, std::vector<Ball>(n));
  unsigned int row = 0;
  // Rows of one interface: what stands inside less what stands outside.
  const auto fill = [&matrix](const unsigned int row, const unsigned int first,
                              const Columns &columns, const Ball Column::*what, const double sign)
  {
    for (unsigned int j = 0; j < columns.size(); ++j)
      matrix[row][first + j] = sign > 0. ? columns[j].*what : -(columns[j].*what);
  };
  if (n_layers == 0)
  {
    fill(row++, 0, core, &Column::u_r, 1.);
    if (viscous)
      fill(row++, 0, core, &Column::u_z, 1.);
    return matrix;
  }
  for (unsigned int i = 0; i < n_layers; ++i)
  {
    const Layer wall = layer(section.layers[i], omega, k);
    const unsigned int first = n_core + 4 * i;
    const Columns outer = wall_columns(wall, Ball(radii[i]));
    const Columns &inner =
        i == 0 ? core : wall_columns(layer(section.layers[i - 1], omega, k), Ball(radii[i]));
    const unsigned int inner_first = i == 0 ? 0 : first - 4;
    for (const Ball Column::*what : {&Column::u_r, &Column::s_rr, &Column::s_rz, &Column::u_z})
    {
      // A liquid without viscosity slides along the wall, without shear stress.
      if (i == 0 && !viscous && what == &Column::u_z)
        continue;
      if (i > 0 || viscous || what != &Column::s_rz)
        fill(row, inner_first, inner, what, 1.);
      fill(row, first, outer, what, -1.);
      ++row;
    }
    if (i + 1 == n_layers)
    {
      const Columns surface = wall_columns(wall, Ball(radii[i + 1]));
      // What is around pushes the surface back.
      const Ball radial = section.radial_support(omega), axial = section.axial_support(omega);
      for (unsigned int j = 0; j < surface.size(); ++j)
      {
        const Column &column = surface[j];
        matrix[row][first + j] = column.s_rr + radial * column.u_r;
        matrix[row + 1][first + j] =
            section.tethered ? column.u_z : column.s_rz + axial * column.u_z;
      }
      row += 2;
    }
  }
  return matrix;
}

Ball ExactDispersion::determinant(const Complex &omega, const Complex &wave_number) const
{
  slong precision = first_precision;
  return determinant(omega, wave_number, precision);
}

Ball ExactDispersion::determinant(const Complex &omega,
                                  const Complex &wave_number,
                                  slong &precision) const
{
  for (;; precision = more(precision))
  {
    const WorkingPrecision working(precision);
    Matrix matrix = conditions(omega, wave_number);
    const Ball result = eliminate(matrix, nullptr);
    if (result.accuracy() >= 32 || precision > largest_precision)
      return result;
  }
}

ExactDispersion::Complex ExactDispersion::guess(const Family family, const Complex &omega) const
{
  const double radius = section.inner_radius, density = section.fluid.density;
  const Complex f10 = Womersley(radius, density, section.fluid.shear.viscosity).f10(omega);
  // The root that decays towards z > 0, or travels there.
  const auto downstream = [](const Complex &square)
  {
    const Complex root = std::sqrt(square);
    const bool decays =
        std::abs(root.imag()) > 1e-9 * std::abs(root) ? root.imag() < 0. : root.real() > 0.;
    return decays ? root : -root;
  };
  if (section.layers.empty())
    return downstream(omega * omega * density * section.fluid.inverse_bulk_modulus() / (1. - f10));

  const double thickness = section.wall_thickness();
  const Complex nu = section.poisson_ratio(omega), young = section.membrane_modulus(omega);
  const double middle = radius + 0.5 * thickness, outer = radius + thickness;
  // Of wall and surroundings over the wall alone: the stiffness of a plate against a radial
  // displacement.
  const Complex plate = young * thickness / (1. - nu * nu);
  const Complex stiffening = 1. + section.radial_support(omega) * radius * outer / plate;
  if (family == bending_wave || family == other_bending_wave)
  {
    // The strain energy of a bent shell: with its middle surface free k^4 = -12 (1 - nu^2)/(R h)^2;
    // bent about a surface that is held k^4 h^3/3 - nu k^2 h^2/R + h/R^2 = 0.
    const double product = middle * thickness;
    // The hoop has Young's modulus, not that of the plate.
    const Complex hoop = 1. + (stiffening - 1.) / (1. - nu * nu);
    const Complex square =
        section.tethered ? 1.5 / product * (nu + imaginary * std::sqrt(4. / 3. * hoop - nu * nu))
                         : imaginary * std::sqrt(12. * (1. - nu * nu) * hoop) / product;
    const Complex root = std::sqrt(square);
    return family == bending_wave ? Complex(root.real(), -root.imag()) : -root;
  }
  // p R = (E h/(1 - nu^2)) (s u_r/R + nu du_z/dz), s the stiffening, and the axial balance of the
  // wall, with the flow of a long wave: a quadratic equation for k^2.
  // A thick wall gives way more than a membrane, by Lame's displacement of its inner surface: psi
  // of anchoring_coefficient() over that of a thin wall.
  const double ratio = thickness / radius;
  const Complex thin = section.tethered ? 1. - nu * nu : 1.;
  const Complex of_wall = ratio * (1. + nu) / thin + 2. / (2. + ratio);
  const Complex yielding = of_wall * stiffening / (1. + (stiffening - 1.) * of_wall);
  const Complex a = plate * (1. - f10) / (2. * density * omega * omega);
  if (section.tethered)
    return downstream(yielding * radius / (stiffening * a) +
                      omega * omega * density * section.fluid.inverse_bulk_modulus());
  const Complex mass =
      omega * omega * (section.wall_density() * thickness + 0.5 * radius * density * f10) -
      section.axial_support(omega) * outer / radius;
  const Complex a2 = -a * plate * (stiffening - nu * nu);
  const Complex a1 =
      radius * plate * (1. - nu * f10 + 0.25 * stiffening * f10 * f10) + stiffening * a * mass;
  const Complex a0 = -radius * mass;
  const Complex root = std::sqrt(a1 * a1 - 4. * a2 * a0);
  const Complex sum = std::abs(a1 + root) > std::abs(a1 - root) ? a1 + root : a1 - root;
  const Complex slow = -sum / (2. * a2), fast = -2. * a0 / sum;
  // Young's wave of an incompressible liquid is slower than the wall's axial wave, but faster where
  // the wall is stiff and the liquid light (a gas in a pipe of steel). Where the wall is supported
  // along its axis, its wave does not travel at low frequencies, and is found in another place.
  const double square_of_young = std::abs(radius / a),
               square_of_bar = std::abs(omega * omega * section.wall_density() / young);
  const bool is_supported = section.axial_support(omega) != 0.;
  const bool is_gas = is_supported ? std::abs(mass / plate) > std::abs(radius / (stiffening * a))
                                   : square_of_young < square_of_bar;
  if (family == axial_wave)
    return downstream(is_gas ? slow : fast);
  const Complex sound = omega * omega * density * section.fluid.inverse_bulk_modulus();
  // In a gas compression is what the wave lives on, and friction slows it as in a rigid pipe.
  return downstream(is_gas ? yielding * fast + sound / (1. - f10) : yielding * slow + sound);
}

bool ExactDispersion::find_root(const Complex &omega,
                                const Complex &start,
                                Complex &wave_number) const
{
  // Muller's method: a parabola through three points. The values are taken relative to the first.
  slong precision = first_precision;
  Complex x[3] = {start * 1.001, start * 0.999, start};
  const Ball reference = determinant(omega, x[0], precision);
  Complex f[3] = {1., (determinant(omega, x[1], precision) / reference).value(),
                  (determinant(omega, x[2], precision) / reference).value()};
  for (unsigned int iteration = 0; iteration < 40; ++iteration)
  {
    if (f[2] == 0.)
      break;
    const Complex h1 = x[1] - x[0], h2 = x[2] - x[1];
    const Complex d1 = (f[1] - f[0]) / h1, d2 = (f[2] - f[1]) / h2;
    const Complex a = (d2 - d1) / (h1 + h2), b = a * h2 + d2;
    const Complex root = std::sqrt(b * b - 4. * a * f[2]);
    const Complex denominator = std::abs(b + root) > std::abs(b - root) ? b + root : b - root;
    if (denominator == 0.)
      return false;
    const Complex next = x[2] - 2. * f[2] / denominator;
    if (!(std::isfinite(next.real()) && std::isfinite(next.imag())))
      return false;
    const double change = std::abs(next - x[2]);
    x[0] = x[1];
    x[1] = x[2];
    x[2] = next;
    if (change < 1e-11 * std::abs(next))
    {
      wave_number = next;
      return true;
    }
    f[0] = f[1];
    f[1] = f[2];
    f[2] = (determinant(omega, next, precision) / reference).value();
  }
  wave_number = x[2];
  return f[2] == 0.;
}

double ExactDispersion::group_speed(const Complex &omega, const Complex &wave_number) const
{
  constexpr double part = 1e-4;
  const double difference = part * omega.real();
  Complex roots[2];
  for (const bool above : {false, true})
  {
    const double sign = above ? 1. : -1.;
    // The phase speed hardly changes.
    const Complex start = wave_number * (1. + sign * part);
    if (!find_root(omega + sign * difference, start, roots[above]) ||
        std::abs(roots[above] - start) > 10. * part * std::abs(start))
      return std::numeric_limits<double>::quiet_NaN();
  }
  return 2. * difference / (roots[1] - roots[0]).real();
}

WaveMode
ExactDispersion::mode(const Family family, const Complex &omega, const Complex &wave_number) const
{
  for (slong precision = first_precision;; precision = more(precision))
  {
    const WorkingPrecision working(precision);
    slong certain_bits = 0;
    const WaveMode result = uncertain_mode(family, omega, wave_number, certain_bits);
    if (certain_bits >= 40 || precision > largest_precision)
      return result;
  }
}

WaveMode ExactDispersion::uncertain_mode(const Family family,
                                         const Complex &omega,
                                         const Complex &wave_number,
                                         slong &certain_bits) const
{
  std::vector<Ball> amplitudes;
  {
    Matrix matrix = conditions(omega, wave_number);
    eliminate(matrix, &amplitudes);
  }
  const double radius = radii[0];
  const Layer fluid = layer(section.fluid, omega, wave_number);
  const Columns core = core_columns(fluid, Ball(radius));
  const unsigned int n_core = core.size();
  const auto sum =
      [&amplitudes](const Columns &columns, const unsigned int first, const Ball Column::*what)
  {
    Ball result = 0.;
    for (unsigned int j = 0; j < columns.size(); ++j)
      result += amplitudes[first + j] * (columns[j].*what);
    return result;
  };

  // Means over the liquid's section, in closed form.
  const Ball argument = fluid.q_l * Ball(radius);
  const Ball mean_phi = Ball(2.) * bessel_j(1, argument) / argument * amplitudes[0];
  const Ball ik = Ball(imaginary) * fluid.k;
  Ball mean_u_z = -(ik * mean_phi);
  if (n_core > 1)
  {
    const Ball shear_argument = fluid.q_s * Ball(radius);
    mean_u_z += Ball(2.) * amplitudes[1] * bessel_j(1, shear_argument) /
                (shear_argument * bessel_j(0, shear_argument));
  }
  const Ball traction = fluid.lame_term * mean_phi + Ball(2.) * fluid.mu * ik * mean_u_z;
  const Ball u_r = sum(core, 0, &Column::u_r);
  // Unit amplitude, the same along a family's curve so that it is smooth.
  Ball unit = mean_u_z;
  if (family == axial_wave)
    unit = sum(wall_columns(layer(section.layers[0], omega, wave_number), Ball(radius)), n_core,
               &Column::u_z);
  else if (family != pressure_wave)
    unit = u_r;
  certain_bits = unit.accuracy();
  const auto scaled = [&unit, &certain_bits](const Ball &value)
  {
    const Ball result = value / unit;
    certain_bits = std::min(certain_bits, result.accuracy());
    return result.value();
  };

  WaveMode mode;
  mode.wave_number = wave_number;
  mode.section_pressure = scaled(fluid.pressure * mean_phi);
  mode.axis_pressure = scaled(fluid.pressure * amplitudes[0]);
  mode.wall_shear_stress =
      section.fluid.shear.viscosity > 0. ? scaled(sum(core, 0, &Column::s_rz)) : 0.;
  mode.wall_displacement = section.layers.empty() ? 0. : scaled(u_r);
  mode.hoop_stress = 0.;
  mode.junction.fill(0.);
  mode.junction[WaveMode::traction] = scaled(traction);
  mode.junction[WaveMode::flow_rate] = imaginary * omega * PI * radius * radius * scaled(mean_u_z);

  // The wall's quantities by Gauss's rule in each layer.
  double area = 0., first_moment = 0., second_moment = 0.;
  for (unsigned int i = 0; i < section.layers.size(); ++i)
    for (unsigned int q = 0; q < 3; ++q)
    {
      const double r = radii[i] + gauss_points[q] * section.layer_thicknesses[i];
      const double weight = gauss_weights[q] * section.layer_thicknesses[i];
      area += 2. * PI * r * weight;
      first_moment += 2. * PI * r * r * weight;
    }
  const double middle = area > 0. ? first_moment / area : 0.;
  for (unsigned int i = 0; i < section.layers.size(); ++i)
  {
    const Layer wall = layer(section.layers[i], omega, wave_number);
    for (unsigned int q = 0; q < 3; ++q)
    {
      const double r = radii[i] + gauss_points[q] * section.layer_thicknesses[i];
      const double weight = gauss_weights[q] * section.layer_thicknesses[i];
      const double ring = 2. * PI * r * weight, arm = r - middle;
      const Columns columns = wall_columns(wall, Ball(r));
      const auto value = [&](const Ball Column::*what)
      { return scaled(sum(columns, n_core + 4 * i, what)); };
      const Complex u_z = value(&Column::u_z), s_zz = value(&Column::s_zz);
      mode.junction[WaveMode::radial_displacement] += ring / area * value(&Column::u_r);
      mode.junction[WaveMode::axial_displacement] += ring / area * u_z;
      mode.junction[WaveMode::rotation] += ring * arm * u_z;
      mode.junction[WaveMode::axial_force] += ring * s_zz;
      mode.junction[WaveMode::bending_moment] += ring * arm * s_zz;
      mode.junction[WaveMode::shear_force] += ring * value(&Column::s_rz);
      mode.hoop_stress += ring / area * value(&Column::s_tt);
      second_moment += ring * arm * arm;
    }
  }
  if (second_moment > 0.)
    mode.junction[WaveMode::rotation] /= second_moment;
  return mode;
}
} // namespace Continua
