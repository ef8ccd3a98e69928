#include <continua/case/theory/absorbing_ends.h>

#include <continua/base/input_error.h>
#include <continua/base/misfit.h>
#include <continua/case/before_the_run/cost_of_case.h>
#include <continua/case/before_the_run/load_spectrum.h>
#include <continua/case/case.h>
#include <continua/case/theory/loaded_tube_case.h>
#include <continua/case/theory/tube_wave_case.h>
#include <continua/continuum/stress_free_state.h>
#include <continua/mesh/round_section.h>
#include <continua/theory/end_impedance.h>
#include <continua/theory/impedance_fit.h>
#include <continua/theory/korteweg.h>
#include <continua/theory/matched_impedance.h>
#include <continua/vessel/tube_law.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>

namespace Continua
{
namespace
{
/// What the impedance of a tube's end is asked for with.
constexpr const char *fit_keys[] = {"Lowest frequency", "Highest frequency", "Fit tolerance"};
/// Samples of the impedance over the band: so many a decade, and at least so many.
constexpr unsigned int n_per_decade = 12, fewest_samples = 24;

/// The ring frequency of a wall that carries the liquid's radial inertia, rho R/4 on its surface
/// [Hz]: the pressure wave ends near it. Infinite if the wall is rigid.
double loaded_ring_frequency(const TubeSection &section)
{
  if (section.layers.empty())
    return std::numeric_limits<double>::infinity();
  const double stiffness = section.hoop_modulus(2. * dealii::numbers::PI).real() *
                           section.wall_thickness() / (section.inner_radius * section.inner_radius);
  const double mass = section.wall_density() * section.wall_thickness() +
                      0.25 * section.fluid.density * section.inner_radius;
  return std::sqrt(stiffness / mass) / (2. * dealii::numbers::PI);
}

struct Band
{
  double lowest, highest; ///< [Hz]
  bool is_weighted;       ///< by the loads
};

Band band_of(const AbsorbingEndParameters &asked,
             const TimeParameters &time,
             const LoadSpectrum &spectrum,
             const TubeSection &section,
             const ParameterSection &condition)
{
  Band band{};
  band.is_weighted = asked.highest_frequency == 0. && !spectrum.is_empty();
  // Ten steps a period resolve a wave; the pressure wave ends near the ring frequency.
  const double resolved =
      std::min(1. / (10. * time.smallest_step()), loaded_ring_frequency(section));
  band.highest = asked.highest_frequency > 0. ? asked.highest_frequency
                 : band.is_weighted           ? std::min(spectrum.highest_frequency(), resolved)
                                              : resolved;
  band.lowest = asked.lowest_frequency > 0.
                    ? asked.lowest_frequency
                    : std::min(1. / (2. * dealii::numbers::PI * time.end_time), 0.1 * band.highest);
  if (band.lowest >= band.highest)
    condition.refuse("Lowest frequency", "it is not below the highest frequency of the band",
                     "Give a lower one, or leave it out");
  return band;
}

ImpedanceFit fit(const TubeSection &section,
                 const WallEnd wall,
                 const Band &band,
                 const LoadSpectrum &spectrum,
                 const double tolerance,
                 const double time_step,
                 const ParameterSection &condition)
{
  const double decades = std::log10(band.highest / band.lowest);
  const unsigned int n =
      std::max<unsigned int>(fewest_samples, std::ceil(n_per_decade * decades)) + 1;
  std::vector<double> frequencies;
  for (unsigned int i = 0; i < n; ++i)
    frequencies.push_back(band.lowest * std::pow(10., decades * i / (n - 1)));
  // Beside the axis of real frequencies, where all is smooth.
  const double shift = 2. * dealii::numbers::PI * band.lowest;
  try
  {
    const auto values = matched_impedances(section, wall, shift, frequencies);
    std::vector<ImpedanceSample> samples;
    for (unsigned int i = 0; i < n; ++i)
      samples.push_back({{shift, 2. * dealii::numbers::PI * frequencies[i]},
                         values[i],
                         band.is_weighted ? spectrum.from(frequencies[i]) : 1.});
    ImpedanceFit result = fit_impedance(samples, tolerance, 1. / time_step);
    if (result.error <= tolerance)
      return result;
    std::ostringstream text;
    text.precision(2);
    if (std::isfinite(result.error))
      text << "the impedance of the tube is met up to an error of " << result.error << " only";
    else
      text << "no passive impedance follows that of the tube";
    text.precision(4);
    text << ", from " << band.lowest << " to " << band.highest << " Hz; the tolerance is "
         << tolerance;
    condition.refuse("Fit tolerance", text.str(),
                     "Give a lower 'Highest frequency' or a larger 'Fit tolerance': half of it is "
                     "what comes back of a wave");
  }
  catch (const RunError &error)
  {
    condition.refuse("Highest frequency", error.what(),
                     "Give a lower one: in this tube there is no such wave up to there. If there "
                     "is none at all, use 'resistance' or 'windkessel'");
  }
}

void scale(Impedance &impedance, const double factor)
{
  impedance.direct *= factor;
  for (Impedance::Term &term : impedance.terms)
    term.residue *= factor;
}

/// Area of a boundary of the coarse mesh [m^2]; of a plane model for a depth of 1 m.
template <int dim>
double area_of(const Case<dim> &input, const BoundaryCondition &condition)
{
  double sum = 0.;
  for (const auto &cell : input.triangulation->cell_iterators_on_level(0))
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == condition.boundary_id &&
          condition.region_ids.count(cell->material_id()) > 0)
        sum +=
            cell->face(f)->measure() * (input.problem.model == Model::axisymmetric
                                            ? 2. * dealii::numbers::PI * cell->face(f)->center()[1]
                                            : 1.);
  return sum;
}

/// The tube behind an end, in the state about which its waves are small.
template <int dim>
TubeSection section_that_goes_on(const Case<dim> &input,
                                 const TubeLaw &law,
                                 const double position,
                                 const BoundaryCondition &condition,
                                 ParameterSection root)
{
  const Problem &problem = input.problem;
  if (problem.finds_unloaded_shape() && !condition.absorbing.has_mean_pressure)
    root.subsection("Boundaries")
        .subsection(condition.name)
        .refuse_missing("the entry 'Mean pressure' is missing: the tube that goes on behind the "
                        "image is under a pressure, too",
                        "Add 'set Mean pressure = ...', the pressure of the image at this end");
  const bool is_loaded =
      condition.absorbing.has_mean_pressure ||
      std::any_of(problem.materials.begin(), problem.materials.end(), has_directions);
  if (problem.deformation == Deformation::small || law.is_rigid() || !is_loaded)
    return tube_section_at(input, law, position);
  return loaded_section_at(input, law, position, condition.absorbing.mean_pressure,
                           root.subsection("Boundaries").subsection(condition.name), root);
}

/// The plane wave in a liquid without a wall.
template <int dim>
void add_plane_end(Case<dim> &input,
                   const unsigned int number,
                   const ParameterSection &condition_section,
                   std::vector<AbsorbingEnd> &ends)
{
  const BoundaryCondition &condition = input.problem.conditions[number];
  if (input.problem.materials.size() > 1 || input.problem.materials[0].is_solid())
    condition_section.refuse(
        "Type", "an absorbing end is that of a 'tube', or of a body of one liquid",
        "Use the geometry 'tube', or 'pressure', 'resistance' or 'windkessel' here");
  for (const char *key : fit_keys)
    if (condition_section.given(key))
      condition_section.refuse(
          key, "the plane wave's impedance is one number at all frequencies, and nothing is fitted",
          "Remove the entry: it is for the ends of a 'tube'");
  const Material &liquid = input.problem.materials[0];
  if (liquid.is_incompressible())
    condition_section.refuse(
        "Type", "there is no wave that could leave an incompressible liquid without a wall",
        "Give it a 'Bulk modulus', or use 'pressure', 'resistance' or 'windkessel' here");
  Outlet outlet = *condition.outlet;
  outlet.conditions = {number};
  AbsorbingEnd end;
  end.name = condition.name;
  end.impedance = liquid.density * acoustic_speed(liquid.density, liquid.inverse_bulk_modulus()) /
                  area_of(input, condition);
  outlet.impedance = Impedance::resistance(end.impedance);
  input.problem.outlets.push_back(outlet);
  ends.push_back(end);
}

/// The impedance of a tube's end of that section, for all of its circumference.
void fit_tube_end(const AbsorbingEndParameters &asked,
                  const TubeSection &tube,
                  const WallEnd wall_end,
                  const TimeParameters &time,
                  const LoadSpectrum &spectrum,
                  const ParameterSection &section,
                  Impedance &impedance,
                  AbsorbingEnd &end)
{
  const Band band = band_of(asked, time, spectrum, tube, section);
  const ImpedanceFit result =
      fit(tube, wall_end, band, spectrum, asked.tolerance, time.smallest_step(), section);
  impedance = result.impedance;
  end.lowest_frequency = band.lowest;
  end.highest_frequency = band.highest;
  end.error = result.error;
  end.reference_frequency = std::clamp(spectrum.energy_frequency(), band.lowest, band.highest);
  end.impedance =
      std::abs(impedance.value({0., 2. * dealii::numbers::PI * end.reference_frequency})(0, 0));
  end.n_terms = impedance.terms.size();
  const double above = spectrum.from(band.highest);
  if (asked.highest_frequency > 0. && above > asked.tolerance)
    end.left_out = above;
}

/// In the frequency domain; tried at all frequencies that are known before the run, which it then
/// remembers. Throws InputError.
EndImpedance exact_end(const EndImpedance &impedance,
                       const std::vector<double> &frequencies,
                       const ParameterSection &section)
{
  for (const char *key : fit_keys)
    if (section.given(key))
      section.refuse(key, "in the frequency domain the impedance is exact, and nothing is fitted",
                     "Remove the entry");
  for (const double frequency : frequencies)
    if (frequency > 0.)
      try
      {
        impedance({0., 2. * dealii::numbers::PI * frequency});
      }
      catch (const RunError &error)
      {
        section.refuse("Type", error.what(),
                       "Give other frequencies: in this tube there is no such wave. If there is "
                       "none at all, use 'resistance' or 'windkessel'");
      }
  return impedance;
}

/// One end of a vessel. Without a spectrum the impedance is zero, to be loaded.
template <int dim>
void add_tube_end(Case<dim> &input,
                  const TubeLaw &law,
                  const typename VesselBranch<dim>::End &vessel_end,
                  const std::optional<LoadSpectrum> &spectrum,
                  ParameterSection root,
                  std::vector<AbsorbingEnd> &ends)
{
  ParameterSection boundaries = root.subsection("Boundaries");
  Problem &problem = input.problem;
  const std::string &end_name = vessel_end.fluid, &wall_name = vessel_end.wall;
  int liquid = -1, wall = -1;
  for (unsigned int c = 0; c < problem.conditions.size(); ++c)
  {
    const BoundaryCondition &condition = problem.conditions[c];
    const std::string &boundary = problem.boundaries[condition.boundary_id];
    if (boundary == end_name && condition.type == BoundaryType::absorbing)
      liquid = c;
    if (boundary == wall_name && condition.type == BoundaryType::absorbing)
      wall = c;
  }
  if (liquid < 0)
  {
    if (wall >= 0)
      boundaries.subsection(problem.conditions[wall].name)
          .refuse("Type", "the wall's end absorbs, but not the liquid's at '" + end_name + "'",
                  "Make both absorbing, or this one 'fixed' or 'free'");
    return;
  }
  const BoundaryCondition &condition = problem.conditions[liquid];
  const ParameterSection section = boundaries.subsection(condition.name);
  if (problem.regions.size() != law.layer_fractions().size() + 1 || problem.materials[0].is_solid())
    section.refuse("Type", "the tube is not full of liquid, or has painted regions",
                   "Use 'pressure', 'resistance' or 'windkessel' here");
  for (const BoundaryCondition &other : problem.conditions)
    if (law.is_rigid() && problem.boundaries[other.boundary_id] == "outside" &&
        other.type != BoundaryType::fixed)
      section.refuse("Type", "a tube without a wall goes on with an outside that is fixed",
                     "Make the 'outside' fixed, or use 'pressure', 'resistance' or 'windkessel'");
    else if (!law.is_rigid() && problem.boundaries[other.boundary_id] == "outside" &&
             (other.normal.kind == BoundaryPart::Kind::velocity ||
              (other.tangential.kind == BoundaryPart::Kind::velocity &&
               !other.tangential.is_zero())))
      section.refuse("Type", "a tube goes on with a wall that is free outside or held axially only",
                     "Make the 'outside' free, or 'pressure' with Tangential = fixed");
  if (wall >= 0)
  {
    const ParameterSection wall_section = boundaries.subsection(problem.conditions[wall].name);
    if (problem.conditions[wall].region_ids.size() + 1 != problem.regions.size())
      wall_section.refuse("Region", "an absorbing end of the wall is that of all its layers",
                          "Leave the entry out, with one condition for the whole end");
    std::vector<const char *> keys(std::begin(fit_keys), std::end(fit_keys));
    keys.push_back("Mean pressure");
    for (const char *key : keys)
      if (wall_section.given(key))
        wall_section.refuse(key, "liquid and wall have one impedance together",
                            "Move the entry to the liquid's end, '" + end_name + "'");
  }
  WallEnd wall_end = WallEnd::clamped;
  const std::string of_wall = read_wall_end(input, wall_name, wall_end);
  if (!of_wall.empty())
    boundaries.subsection(wall_name).refuse("", "the liquid's end absorbs, and " + of_wall,
                                            "Let the wall's whole end be absorbing, fixed or free");

  if (law.is_rigid() && problem.materials[0].inverse_bulk_modulus() == 0.)
    section.refuse("Type", "an incompressible liquid in a rigid tube carries no wave",
                   "Give the liquid a bulk modulus, or use 'pressure', 'resistance' or "
                   "'windkessel'");
  const TubeSection tube = section_that_goes_on(input, law, vessel_end.position, condition, root);
  AbsorbingEnd end;
  end.name = condition.name;
  // A wall that is held axially has no wave that would arrive there.
  end.absorbs_wall = wall_end == WallEnd::absorbing && !tube.tethered;
  Outlet outlet = *condition.outlet;
  outlet.conditions = {static_cast<unsigned int>(liquid)};
  if (end.absorbs_wall)
    outlet.conditions.push_back(wall);
  if (spectrum)
    fit_tube_end(condition.absorbing, tube, wall_end, input.time, *spectrum, section,
                 outlet.impedance, end);
  else
    outlet.impedance.direct.reinit(outlet.conditions.size(), outlet.conditions.size());
  if (!input.analysis.is_harmonic())
    ends.push_back(end);

  // A part of the section has that part of the flow.
  try
  {
    const double part =
        1. / find_round_section(*input.triangulation, condition.boundary_id, condition.region_ids)
                 .fraction;
    scale(outlet.impedance, part);
    if (input.analysis.is_harmonic())
      outlet.exact_impedance =
          exact_end(EndImpedance(tube, wall_end, part), input.harmonic.frequencies, section);
  }
  catch (const std::invalid_argument &error)
  {
    section.refuse("Type", error.what(), "Use 'resistance' or 'windkessel' there");
  }
  problem.outlets.push_back(outlet);
}
} // namespace

template <int dim>
void AbsorbingEnds::add(Case<dim> &input, ParameterSection root, const bool restart)
{
  ParameterSection boundaries = root.subsection("Boundaries");
  const auto is_absorbing = [](const BoundaryCondition &condition)
  { return condition.type == BoundaryType::absorbing; };
  Problem &problem = input.problem;
  const auto first =
      std::find_if(problem.conditions.begin(), problem.conditions.end(), is_absorbing);
  if (first == problem.conditions.end())
    return;
  // Wave theory knows these ends without an impedance of the time domain.
  if (!input.analysis.is_transient() && !input.analysis.is_harmonic())
    return;
  const std::vector<VesselBranch<dim>> branches = input.geometry->branches();
  if (branches.empty())
  {
    for (unsigned int c = 0; c < problem.conditions.size(); ++c)
      if (is_absorbing(problem.conditions[c]))
        add_plane_end(input, c, boundaries.subsection(problem.conditions[c].name), ends);
    return;
  }
  std::set<std::string> absorbing;
  std::string names;
  for (const VesselBranch<dim> &branch : branches)
    for (const auto &end : branch.ends)
    {
      absorbing.insert(end.fluid);
      names += (names.empty() ? "'" : ", or '") + end.fluid + "'";
      if (end.wall.empty())
        continue;
      absorbing.insert(end.wall);
      names += " and '" + end.wall + "'";
    }
  for (const BoundaryCondition &condition : problem.conditions)
    if (is_absorbing(condition) && absorbing.count(problem.boundaries[condition.boundary_id]) == 0)
      boundaries.subsection(condition.name)
          .refuse("Type", "a tube goes on at its ends only", "Use it at " + names);
  std::optional<LoadSpectrum> spectrum;
  if (!restart && input.analysis.is_transient())
  {
    const double memory = LoadSpectrum::memory(input.time.end_time, input.time.smallest_step());
    const MemoryLimit limit = memory_limit_of(input);
    // Every rank makes its own.
    if (memory * dealii::Utilities::MPI::n_mpi_processes(input.communicator) > limit.bytes)
      root.subsection("Time").refuse(
          "End time",
          "the absorbing end of a tube needs the spectrum of the load over the run, of which "
          "the steps until then take " +
              memory_text(memory) + " on each rank, and the run may take " +
              memory_text(limit.bytes) + " (" + limit.source + ")",
          "Give an earlier end, a longer time step, or more by Mesh/Memory limit");
    spectrum.emplace(problem, input.time.end_time, input.time.smallest_step());
  }
  for (const VesselBranch<dim> &branch : branches)
    for (const auto &end : branch.ends)
      add_tube_end(input, branch.law, end, spectrum, root, ends);
}

void AbsorbingEnds::report(Log &log, Summary &summary) const
{
  for (const AbsorbingEnd &end : ends)
  {
    std::ostringstream text;
    text.precision(4);
    text << end.name << ": an absorbing end of the impedance " << end.impedance << " Pa s/m^3";
    if (end.reference_frequency == 0.)
      text << ", the plane wave's";
    else
    {
      text << " at " << end.reference_frequency << " Hz, of "
           << (end.absorbs_wall ? "liquid and wall" : "the liquid") << ": ";
      if (end.n_terms == 0)
        text << "a resistance follows";
      else
        text << end.n_terms << (end.n_terms == 1 ? " term follows" : " terms follow");
      text << " it from " << end.lowest_frequency << " to " << end.highest_frequency
           << " Hz within ";
      text.precision(2);
      text << end.error;
    }
    log.line(text.str());
    if (end.left_out > 0.)
    {
      std::ostringstream warning;
      warning.precision(2);
      warning << "Boundaries/" << end.name << "/Highest frequency: above the band of the fit the "
              << "loads' spectrum still reaches " << 100. * end.left_out
              << " % of its largest value, and the end does not absorb that as closely as the fit "
                 "tolerance says";
      log.warning(warning.str());
    }
    if (const std::string warning =
            misfit_warning("Boundaries/" + end.name + ": the fit of the absorbing end", end.error,
                           "the largest error over the largest impedance",
                           "Set a smaller Fit tolerance, or leave it out");
        !warning.empty())
      log.warning(warning);
    summary.add({"absorbing end fit error", end.error, "1", end.name});
    summary.set("absorbing end " + end.name,
                std::map<std::string, double>{{"impedance [Pa s/m^3]", end.impedance},
                                              {"reference frequency [Hz]", end.reference_frequency},
                                              {"lowest frequency [Hz]", end.lowest_frequency},
                                              {"highest frequency [Hz]", end.highest_frequency},
                                              {"terms", static_cast<double>(end.n_terms)},
                                              {"error of the fit", end.error}});
  }
}

namespace
{
/// Direct, then rate and residue of each term, matrices row by row.
std::vector<double> numbers_of(const Impedance &impedance)
{
  std::vector<double> numbers;
  const auto add = [&numbers](const Impedance::Matrix &matrix)
  {
    for (unsigned int i = 0; i < matrix.m(); ++i)
      for (unsigned int j = 0; j < matrix.n(); ++j)
        numbers.push_back(matrix(i, j));
  };
  add(impedance.direct);
  for (const Impedance::Term &term : impedance.terms)
  {
    numbers.push_back(term.rate);
    add(term.residue);
  }
  return numbers;
}

std::string record_of(const Outlet &outlet)
{
  return "impedance of the absorbing end " + outlet.name;
}

std::string band_record_of(const AbsorbingEnd &end)
{
  return "band and error of the absorbing end " + end.name;
}
} // namespace

void AbsorbingEnds::save(ArchiveWriter &archive, const Problem &problem) const
{
  for (const Outlet &outlet : problem.outlets)
    if (problem.conditions[outlet.conditions[0]].type == BoundaryType::absorbing)
      archive.add(record_of(outlet), numbers_of(outlet.impedance));
  for (const AbsorbingEnd &end : ends)
    archive.add(band_record_of(end),
                std::vector<double>{end.lowest_frequency, end.highest_frequency, end.error,
                                    end.reference_frequency, end.impedance});
}

void AbsorbingEnds::load(const ArchiveReader &archive, Problem &problem)
{
  for (Outlet &outlet : problem.outlets)
    if (problem.conditions[outlet.conditions[0]].type == BoundaryType::absorbing)
    {
      const std::vector<double> numbers = archive.values(record_of(outlet));
      const unsigned int n = outlet.impedance.n_ports();
      std::size_t next = 0;
      const auto take = [&]()
      {
        Impedance::Matrix matrix(n, n);
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            matrix(i, j) = numbers.at(next++);
        return matrix;
      };
      outlet.impedance.direct = take();
      outlet.impedance.terms.clear();
      while (next < numbers.size())
      {
        Impedance::Term term;
        term.rate = numbers.at(next++);
        term.residue = take();
        outlet.impedance.terms.push_back(term);
      }
      for (AbsorbingEnd &end : ends)
        if (end.name == outlet.name)
        {
          const std::vector<double> band = archive.values(band_record_of(end));
          end.lowest_frequency = band.at(0);
          end.highest_frequency = band.at(1);
          end.error = band.at(2);
          end.reference_frequency = band.at(3);
          end.impedance = band.at(4);
          end.n_terms = outlet.impedance.terms.size();
        }
    }
}

template void AbsorbingEnds::add(Case<2> &, ParameterSection, bool);
template void AbsorbingEnds::add(Case<3> &, ParameterSection, bool);
} // namespace Continua
