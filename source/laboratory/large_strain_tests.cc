#include <continua/laboratory/large_strain_tests.h>

#include <continua/base/interruption.h>
#include <continua/base/misfit.h>
#include <continua/base/six_digits.h>
#include <continua/base/units.h>
#include <continua/laboratory/fit_report.h>
#include <continua/laboratory/relaxing_law.h>
#include <continua/materials/strain_law_types.h>
#include <continua/postprocess/writing_rank.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <tuple>

namespace Continua
{
using dealii::numbers::PI;

namespace
{
/// The Maxwell branches of a shear that rises evenly to `shear` within `loading_time` (0: at once):
/// mu_k times what each has not forgotten [Pa]. In simple shear the branches of internal_metric.h
/// are linear at any strain.
double shear_of_branches(const std::vector<Branch> &branches,
                         const double shear,
                         const double loading_time,
                         const double time)
{
  double sum = 0.;
  for (const Branch &branch : branches)
  {
    const double tau = branch.relaxation_time;
    if (std::isinf(tau))
      continue;
    const double loaded = std::min(time, loading_time);
    // tau (exp((loaded - t)/tau) - exp(-t/tau))/T: the part of each moment of the loading.
    const double part = loading_time > 0. ? std::exp((loaded - time) / tau) *
                                                -std::expm1(-loaded / tau) * tau / loading_time
                                          : std::exp(-time / tau);
    sum += branch.shear_modulus * shear * part;
  }
  return sum;
}

HomogeneousTestType type_of_test(const std::string &test)
{
  return value_of(homogeneous_test_words(), test);
}
} // namespace

LargeStrainTests::LargeStrainTests(const Material &material,
                                   const StrainLawParameters &law,
                                   const LargeStrainParameters &parameters,
                                   const TimeParameters &time,
                                   const OutputDirectory &directory,
                                   const MPI_Comm communicator,
                                   Log &log,
                                   Summary &summary)
    : material(material),
      parameters(parameters),
      time(time),
      directory(directory),
      communicator(communicator),
      is_writer(is_writing_rank(communicator)),
      log(log),
      summary(summary),
      law_parameters(law),
      shear_modulus(material.long_term_shear_modulus()),
      inverse_bulk_modulus(material.inverse_bulk_modulus())
{
}

std::unique_ptr<TableWriter> LargeStrainTests::table(const std::string &name,
                                                     const std::vector<std::string> &header) const
{
  std::string file = name + ".csv";
  std::replace(file.begin(), file.end(), ' ', '-');
  return is_writer ? std::make_unique<TableWriter>(directory.file(file), header) : nullptr;
}

std::unique_ptr<StrainLaw> LargeStrainTests::law() const
{
  return make_strain_law(law_parameters, shear_modulus, 1. / inverse_bulk_modulus);
}

std::vector<double> LargeStrainTests::points(const double first, const double last) const
{
  std::vector<double> result(parameters.n_points);
  for (unsigned int i = 0; i < result.size(); ++i)
    result[i] = first + (last - first) * i / (result.size() - 1.);
  return result;
}

void LargeStrainTests::fit_tables(Material &fitted)
{
  if (parameters.tables.empty())
    return;
  const double before = shear_modulus;
  fit();
  for (Branch &branch : fitted.shear.branches)
    if (std::isinf(branch.relaxation_time))
      branch.shear_modulus *= shear_modulus / before;
  if (fitted.compression.kind() == Compression::Kind::elastic)
    fitted.compression = Compression::elastic(inverse_bulk_modulus);
}

void LargeStrainTests::perform(const std::vector<std::string> &tests)
{
  for (const std::string &test : tests)
  {
    SignalWatch::stop_if_asked(communicator, "before the test " + test +
                                                 "; the tests begin anew, with --overwrite");
    if (test == "inflation")
      inflation();
    else if (test == "stretch relaxation")
      relaxation(test, HomogeneousTestType::uniaxial, parameters.held_stretch);
    else if (test == "shear relaxation")
      relaxation(test, HomogeneousTestType::shear, parameters.held_shear);
    else
      curve(test, type_of_test(test));
  }
}

void LargeStrainTests::fit()
{
  const StrainLawFit found = fit_strain_law(law_parameters, shear_modulus, inverse_bulk_modulus,
                                            parameters.direction, parameters.tables);
  inverse_bulk_modulus *= shear_modulus / found.shear_modulus;
  law_parameters = found.parameters;
  shear_modulus = found.shear_modulus;
  const double mu_over_k = shear_modulus * inverse_bulk_modulus;
  const double young = 9. * shear_modulus / (3. + mu_over_k);
  std::ostringstream text;
  text.precision(6);
  text << "Fit of the law " << law_parameters.type << ": shear modulus " << shear_modulus
       << " Pa, Young's modulus " << young << " Pa";
  summary.add({"Young's modulus", young, "Pa", "fit"});
  for (const StrainLawConstant &constant : strain_law_type(law_parameters.type).constants)
  {
    const double value = law_parameters.*constant.member;
    text << ", " << constant.key << " " << value
         << (constant.dimension == Dimensions::none ? "" : " " + constant.dimension.unit());
  }
  text.precision(2);
  text << "; root mean square of the difference " << found.misfit << " of the largest stress";
  log.line(text.str());
  report_fit(found.sought, found.result, log, summary);
  if (!found.result.converged)
    log.warning("the fit did not come to its end: " + found.result.stop_reason);
  if (const std::string warning =
          misfit_warning("Laboratory: the law " + law_parameters.type, found.misfit,
                         "root of the mean square, of the largest stress",
                         "Choose another law, or leave out the rows that it cannot follow");
      !warning.empty())
    log.warning(warning);
  summary.add({"misfit", found.misfit, "1", "fit"});

  const auto strain_law = law();
  const HomogeneousTest specimen(*strain_law, inverse_bulk_modulus,
                                 fibres_of_specimen(law_parameters, parameters.direction));
  for (const StretchTable &measured : parameters.tables)
  {
    const bool is_shear = measured.type == HomogeneousTestType::shear;
    const auto rows = table(
        "fit-" + word_of(homogeneous_test_words(), measured.type),
        {is_shear ? "shear [1]" : "stretch [1]", "measured stress [Pa]", "stress of the law [Pa]"});
    for (std::size_t row = 0; rows && row < measured.strain_measures.size(); ++row)
      rows->row({measured.strain_measures[row], measured.stresses[row],
                 specimen.at(measured.type, measured.strain_measures[row]).nominal_stress});
    if (rows)
      rows->flush();
  }
}

void LargeStrainTests::curve(const std::string &name, const HomogeneousTestType type)
{
  const bool is_shear = type == HomogeneousTestType::shear;
  const double first = is_shear ? 0. : parameters.smallest_stretch,
               last = is_shear ? parameters.largest_shear : parameters.largest_stretch,
               undeformed = is_shear ? 0. : 1.;
  log.line("Test " + name + ": " + (is_shear ? "shear " : "stretch ") + shortest_number(first) +
           " to " + shortest_number(last));
  const auto strain_law = law();
  const HomogeneousTest specimen(*strain_law, inverse_bulk_modulus,
                                 fibres_of_specimen(law_parameters, parameters.direction));
  const auto rows =
      table(name, {is_shear ? "shear [1]" : "stretch [1]", "nominal stress [Pa]",
                   "Cauchy stress [Pa]", "tangent modulus [Pa]", "normal stress difference [Pa]",
                   "stretch across the thickness [1]", "volume ratio [1]", "energy [J/m^3]"});
  const HomogeneousTestEnd shortest = first < undeformed ? specimen.end(type, first)
                                                         : HomogeneousTestEnd{first, ""},
                           longest = last > undeformed ? specimen.end(type, last)
                                                       : HomogeneousTestEnd{last, ""};
  HomogeneousTestPoint point;
  for (const double strain_measure : points(first, last))
  {
    if (strain_measure < shortest.strain_measure || strain_measure > longest.strain_measure)
      continue;
    point = specimen.at(type, strain_measure);
    if (rows)
      rows->row({strain_measure, point.nominal_stress, point.cauchy_stress, point.tangent_modulus,
                 point.normal_difference, point.strain.gradient[2][2], point.volume_ratio,
                 point.energy});
  }
  if (rows)
    rows->flush();
  for (const HomogeneousTestEnd &end : {shortest, longest})
    if (!end.reason.empty())
      throw RunError("the test " + name + " ends at the stretch " + six_digits(end.strain_measure) +
                     ": " + end.reason +
                     ". The rows up to there are in the table. Ask for a range that " +
                     (end.strain_measure < undeformed ? "begins after it" : "ends before it") +
                     " (Laboratory/" + (end.strain_measure < undeformed ? "Smallest" : "Largest") +
                     " stretch)");
  const auto stress_and_slope = [&](const double stretch)
  {
    const HomogeneousTestPoint at = specimen.at(type, stretch);
    return std::make_pair(at.nominal_stress, at.tangent_modulus);
  };
  if (!is_shear)
    state_limit_points(name, "nominal stress", stress_and_slope);
  summary.add(
      {"modulus at zero strain", specimen.at(type, undeformed).tangent_modulus, "Pa", name});
  summary.add({"nominal stress at the end", point.nominal_stress, "Pa", name});
  summary.add({"Cauchy stress at the end", point.cauchy_stress, "Pa", name});
  summary.add({"tangent modulus at the end", point.tangent_modulus, "Pa", name});
}

void LargeStrainTests::state_limit_points(const std::string &test,
                                          const std::string &load,
                                          const LoadAndSlope &load_and_slope)
{
  // From rest on and not from the rows, so that neither the range nor the rows change the place.
  constexpr double step = 0.01, accuracy = 1e-12; // of the logarithm of the stretch
  const bool rises = load_and_slope(1.).second > 0.;
  const auto has_turned = [&](const double logarithm)
  { return (load_and_slope(std::exp(logarithm)).second > 0.) != rises; };
  const auto state = [&](const std::string &side, const double direction, const double length)
  {
    double before = 0., after = 0.;
    do
    {
      before = after;
      if (std::abs(before) >= length)
        return;
      after = direction * std::min(std::abs(before) + step, length);
    } while (!has_turned(after));
    while (std::abs(after - before) > accuracy)
    {
      const double middle = 0.5 * (before + after);
      (has_turned(middle) ? after : before) = middle;
    }
    const double stretch = std::exp(before), value = load_and_slope(stretch).first;
    log.line("Limit point of the test " + test + " in " + side + ": the " + load +
             " has its extreme, " + six_digits(value) + " Pa, at the stretch " +
             six_digits(stretch) +
             ". A specimen under a given load gives way there. The test gives the stretch and goes "
             "on");
    summary.add({"limit stretch in " + side, stretch, "1", test});
    summary.add({"limit " + load + " in " + side, value, "Pa", test});
  };
  state("compression", -1., -std::log(parameters.smallest_stretch));
  state("tension", 1., std::log(parameters.largest_stretch));
}

void LargeStrainTests::inflation()
{
  const double axial = parameters.axial_stretch, radius = parameters.radius,
               thickness = parameters.wall_thickness;
  log.line("Inflation: circumference stretched by " + shortest_number(parameters.smallest_stretch) +
           " to " + shortest_number(parameters.largest_stretch) + ", axis by " +
           shortest_number(axial));
  const auto strain_law = law();
  const HomogeneousTest wall(*strain_law, inverse_bulk_modulus,
                             fibres_of_specimen(law_parameters, CuttingDirection::axial));
  const auto rows = table("inflation", {"stretch [1]", "pressure [Pa]", "radius [m]",
                                        "circumferential stress [Pa]", "axial stress [Pa]",
                                        "axial force [N]", "distensibility [1/Pa]"});
  double pressure = 0., force = 0., distensibility = 0., circumferential = 0., axial_stress = 0.;
  const auto state_at = [&](const double stretch)
  {
    return wall.equilibrium({{axial, stretch, 1.}}, {{true, true, false}},
                            {{0., 1. / stretch, 0.}});
  };
  // Laplace's law with the present thickness and radius; T = J sigma. With its slope.
  const auto pressure_of = [&](const double stretch, const PrincipalState &state)
  {
    const double factor = thickness / (radius * axial * stretch * stretch);
    return std::make_pair(factor * state.stress[1],
                          factor * (state.stress_rate[1] - 2. * state.stress[1] / stretch));
  };
  for (const double stretch : points(parameters.smallest_stretch, parameters.largest_stretch))
  {
    const PrincipalState state = state_at(stretch);
    double slope = 0.;
    std::tie(pressure, slope) = pressure_of(stretch, state);
    distensibility = 2. / (stretch * slope);
    circumferential = state.stress[1] / state.strain.determinant;
    axial_stress = state.stress[0] / state.strain.determinant;
    // Of the wall less that of the pressure on the end.
    force = PI * radius * thickness * (2. * state.stress[0] - state.stress[1]) / axial;
    if (rows)
      rows->row({stretch, pressure, radius * stretch, circumferential, axial_stress, force,
                 distensibility});
  }
  if (rows)
    rows->flush();
  const std::string name = "inflation";
  state_limit_points(name, "pressure",
                     [&](const double stretch) { return pressure_of(stretch, state_at(stretch)); });
  summary.add({"pressure at the end", pressure, "Pa", name});
  summary.add({"circumferential stress at the end", circumferential, "Pa", name});
  summary.add({"axial stress at the end", axial_stress, "Pa", name});
  summary.add({"axial force at the end", force, "N", name});
  summary.add({"distensibility at the end", distensibility, "1/Pa", name});
}

void LargeStrainTests::relaxation(const std::string &name,
                                  const HomogeneousTestType type,
                                  const double held)
{
  const bool is_shear = type == HomogeneousTestType::shear;
  const double undeformed = is_shear ? 0. : 1., loading_time = parameters.loading_time;
  log.line(
      (is_shear ? "Shear relaxation: shear " : "Stretch relaxation: stretch ") +
      shortest_number(held) +
      (loading_time > 0. ? " loaded within " + shortest_number(loading_time) + " s" : " at once") +
      ", for " + shortest_number(time.end_time) + " s");
  const auto strain_law = law();
  const auto fibres = fibres_of_specimen(law_parameters, parameters.direction);
  const HomogeneousTest relaxed(*strain_law, inverse_bulk_modulus, fibres);
  RelaxingLaw relaxing(*strain_law, material.shear.branches);
  const HomogeneousTest specimen(relaxing, inverse_bulk_modulus, fibres);
  std::vector<std::string> header = {"time [s]", is_shear ? "shear [1]" : "stretch [1]",
                                     "nominal stress [Pa]", "relaxed nominal stress [Pa]"};
  if (is_shear)
    header.push_back("stress of the closed solution [Pa]");
  const auto rows = table(name, header);
  double largest = 0., last = 0., difference = 0., scale = 0.;
  const auto take = [&](const double now, const double duration)
  {
    const double loaded = loading_time > 0. ? std::min(now / loading_time, 1.) : 1.;
    const double strain_measure = undeformed + (held - undeformed) * loaded;
    relaxing.begin_step(duration);
    const HomogeneousTestPoint point = specimen.at(type, strain_measure);
    relaxing.end_step(point.strain);
    const double long_term = relaxed.at(type, strain_measure).nominal_stress;
    std::vector<double> row = {now, strain_measure, point.nominal_stress, long_term};
    last = point.nominal_stress;
    if (std::abs(last) > std::abs(largest))
      largest = last;
    if (is_shear)
    {
      row.push_back(long_term +
                    shear_of_branches(material.shear.branches, held, loading_time, now));
      difference = std::max(difference, std::abs(last - row.back()));
      scale = std::max(scale, std::abs(row.back()));
    }
    if (rows)
      rows->row(row);
  };
  TimeControl control(time);
  take(0., 0.);
  for (double before = 0.; !control.at_end(); before = control.time())
  {
    control.next();
    SignalWatch::stop_if_asked(communicator,
                               "in the test " + name + "; the tests begin anew, with --overwrite");
    take(control.time(), control.time() - before);
  }
  if (rows)
    rows->flush();
  summary.add({"largest stress", largest, "Pa", name});
  summary.add({"final stress", last, "Pa", name});
  if (is_shear)
    summary.add({"largest difference from the closed solution",
                 scale > 0. ? difference / scale : difference, "1", name});
}

void LargeStrainTests::name_quantities(const StrainLawParameters &law,
                                       const LargeStrainParameters &parameters,
                                       const std::vector<std::string> &tests,
                                       QuantityNames &names)
{
  const auto add = [&names](const std::string &test, const std::vector<std::string> &quantities)
  {
    for (const std::string &name : quantities)
      names.add(name, test);
  };
  if (!parameters.tables.empty())
  {
    add("fit", {"Young's modulus", "misfit"});
    name_fit_quantities("shear modulus", names);
    for (const StrainLawConstant &constant : strain_law_type(law.type).constants)
      name_fit_quantities(constant.key, names);
  }
  const auto add_limit_points = [&add](const std::string &test, const std::string &load)
  {
    for (const std::string side : {" in compression", " in tension"})
      add(test, {"limit stretch" + side, "limit " + load + side});
  };
  for (const std::string &test : tests)
    if (test == "inflation")
    {
      add(test, {"pressure at the end", "circumferential stress at the end",
                 "axial stress at the end", "axial force at the end", "distensibility at the end"});
      add_limit_points(test, "pressure");
    }
    else if (test == "stretch relaxation" || test == "shear relaxation")
    {
      add(test, {"largest stress", "final stress"});
      if (test == "shear relaxation")
        names.add("largest difference from the closed solution", test);
    }
    else
    {
      add(test, {"modulus at zero strain", "nominal stress at the end", "Cauchy stress at the end",
                 "tangent modulus at the end"});
      if (test != "shear")
        add_limit_points(test, "nominal stress");
    }
}
} // namespace Continua
