#include <continua/analysis/modal.h>

#include <continua/analysis/free_motions.h>
#include <continua/analysis/mode_search.h>
#include <continua/base/collective.h>
#include <continua/base/input_error.h>
#include <continua/base/interruption.h>
#include <continua/base/table_writer.h>
#include <continua/postprocess/field_writer.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace Continua
{
using namespace dealii;

namespace
{
/// Multiplies the shape by a number that makes its largest component 1 m; of a complex shape that
/// turns its phase as well. The first of equal components counts, on the first rank that has one.
void normalise(Eigenpair &pair, const MPI_Comm communicator)
{
  double largest = 0.;
  std::complex<double> value;
  for (std::size_t i = 0; i < pair.real.size(); ++i)
  {
    const std::complex<double> x(pair.real[i], pair.imaginary[i]);
    // Round-off must not choose between components that symmetry makes equal.
    if (std::abs(x) > (1. + 1e-6) * largest)
    {
      largest = std::abs(x);
      value = x;
    }
  }
  std::complex<double> chosen;
  double chosen_size = 0.;
  const std::vector<double> real_parts = all_gather(communicator, value.real());
  const std::vector<double> imaginary_parts = all_gather(communicator, value.imag());
  for (std::size_t rank = 0; rank < real_parts.size(); ++rank)
  {
    const std::complex<double> of_rank(real_parts[rank], imaginary_parts[rank]);
    if (std::abs(of_rank) > (1. + 1e-6) * chosen_size)
    {
      chosen = of_rank;
      chosen_size = std::abs(of_rank);
    }
  }
  for (std::size_t i = 0; i < pair.real.size(); ++i)
  {
    const std::complex<double> x = std::complex<double>(pair.real[i], pair.imaginary[i]) / chosen;
    pair.real[i] = x.real();
    pair.imaginary[i] = x.imag();
  }
}

double percent(const double share)
{
  return 100. * share;
}
} // namespace

template <int dim>
void Modal<dim>::prepare()
{
  const Case<dim> &input = run.input;
  vibration = run.solver->vibration();
  if (!vibration)
    throw RunError("the discretisation '" + input.general.discretisation +
                   "' has no modal analysis; set Discretisation = taylor hood");
  if (input.modal.highest() && !vibration->has_acceleration())
    throw RunError("this formulation has no highest modes; set Modal/Which = lowest");
  for (unsigned int region = 0; region < input.problem.materials.size(); ++region)
    if (input.problem.materials[region].shear.viscosity > 0.)
      run.log.line("The viscosity of '" + input.problem.regions[region] +
                   "' is left out: modes are those without damping");
  for (const BoundaryCondition &condition : input.problem.conditions)
    if (condition.normal.damping > 0. || condition.tangential.damping > 0.)
      run.log.line("The damping of the support '" + condition.name +
                   "' is left out: modes are those without damping");
  directions = vibration->directions();
  motions = rigid_motions<dim>(*input.triangulation, run.solver->mapping(), input.problem);
  for (const RigidMotion<dim> &motion : motions)
    momenta.push_back(vibration->momentum(motion));
}

template <int dim>
void Modal<dim>::stop_if_asked(const std::string &phase) const
{
  SignalWatch::stop_if_asked(run.input.communicator,
                             "after " + phase + "; a modal analysis begins anew, with --overwrite");
}

template <int dim>
std::vector<Eigenpair> Modal<dim>::solve()
{
  const ModalParameters &modal = run.input.modal;
  const MPI_Comm communicator = run.input.communicator;
  const unsigned int n = vibration->n_local_unknowns();
  if (modal.highest())
  {
    SectionTimer::Scope scope(run.log.timer(), "eigenvalues");
    return dominant_eigenpairs([this](const std::vector<double> &x, std::vector<double> &y)
                               { vibration->accelerate(x, y); },
                               n, modal.n_modes, communicator);
  }
  shift = std::pow(2. * numbers::PI * modal.shift, 2);
  try
  {
    SectionTimer::Scope scope(run.log.timer(), "factor");
    vibration->set_shift(shift);
  }
  catch (const RunError &error)
  {
    throw RunError(std::string(error.what()) +
                   " If the body can move freely, or the shift is a mode's frequency, set "
                   "Modal/Shift to another, such as half of the first mode's.");
  }
  stop_if_asked("the factor");
  SectionTimer::Scope scope(run.log.timer(), "eigenvalues");
  return ModeSearch<dim>(*vibration, motions, momenta, communicator, run.log)
      .nearest(shift, modal.n_modes);
}

template <int dim>
Mode Modal<dim>::describe(const Eigenpair &pair, const bool is_symmetric) const
{
  Mode mode;
  mode.eigenvalue = pair.value;
  mode.residual = pair.residual;
  // The zero of a rigid motion is known to the shift's round-off, and may come out negative.
  if (is_symmetric && mode.eigenvalue.real() < 1e-8 * shift)
    mode.eigenvalue = 0.;
  const std::complex<double> omega = std::sqrt(mode.eigenvalue);
  mode.frequency = omega.real() / (2. * numbers::PI);
  mode.growth_rate = std::abs(omega.imag());

  const unsigned int n = vibration->n_local_unknowns();
  std::array<std::vector<double>, 2> weighed = {{std::vector<double>(n), std::vector<double>(n)}};
  vibration->multiply_mass(pair.real, weighed[0]);
  vibration->multiply_mass(pair.imaginary, weighed[1]);
  // By direction, and the real and imaginary part by motion.
  std::vector<double> sums(dim + 2 * motions.size(), 0.);
  for (unsigned int i = 0; i < n; ++i)
  {
    sums[directions[i]] += pair.real[i] * weighed[0][i] + pair.imaginary[i] * weighed[1][i];
    for (unsigned int m = 0; m < motions.size(); ++m)
    {
      sums[dim + 2 * m] += pair.real[i] * momenta[m][i];
      sums[dim + 2 * m + 1] += pair.imaginary[i] * momenta[m][i];
    }
  }
  Utilities::MPI::sum(sums, run.input.communicator, sums);
  for (unsigned int d = 0; d < dim; ++d)
    mode.mass += sums[d];
  for (unsigned int d = 0; d < dim; ++d)
    mode.direction_shares.push_back(sums[d] / mode.mass);
  for (unsigned int m = 0; m < motions.size(); ++m)
  {
    const std::complex<double> product(sums[dim + 2 * m], sums[dim + 2 * m + 1]);
    mode.participations.push_back(product.real() / mode.mass);
    mode.inertia_shares.push_back(std::norm(product) / mode.mass / motions[m].inertia);
  }
  return mode;
}

template <int dim>
std::string Modal<dim>::text_of(const unsigned int number, const Mode &mode) const
{
  // The largest share of a translation, and of a turn.
  std::array<unsigned int, 2> first = {{0, 0}};
  std::array<double, 2> largest = {{0., 0.}};
  for (unsigned int m = 0; m < motions.size(); ++m)
    if (mode.inertia_shares[m] > (1. + 1e-6) * largest[motions[m].rotates])
    {
      largest[motions[m].rotates] = mode.inertia_shares[m];
      first[motions[m].rotates] = m;
    }
  // Round-off must not choose between directions that symmetry makes equal.
  unsigned int direction = 0;
  for (unsigned int d = 1; d < dim; ++d)
    if (mode.direction_shares[d] > (1. + 1e-6) * mode.direction_shares[direction])
      direction = d;
  const char axis = "xyz"[direction];
  std::ostringstream text;
  text << "Mode " << number << ": " << std::setprecision(5) << mode.frequency << " Hz, ";
  if (mode.growth_rate > 0.)
    text << "grows by exp(" << mode.growth_rate << " t/s), ";
  // A bending mode turns the body, too, but carries some of its mass along.
  if (largest[true] > 1e-3 && largest[true] > 10. * largest[false])
    text << "turns about " << motions[first[true]].axis;
  else
    text << "moves along " << axis;
  text << std::fixed << std::setprecision(1) << ": " << percent(mode.direction_shares[direction])
       << " % of its energy along " << axis;
  for (const bool rotates : {false, true})
  {
    std::string axes;
    for (unsigned int m = 0; m < motions.size(); ++m)
      if (motions[m].rotates == rotates)
      {
        text << (axes.empty() ? "; " : ", ") << percent(mode.inertia_shares[m]);
        axes += (axes.empty() ? "" : ", ") + motions[m].axis;
      }
    if (!axes.empty())
      text << (rotates ? " % of the inertia about " : " % of the mass along ") << axes;
  }
  return text.str();
}

template <int dim>
std::vector<std::string> Modal<dim>::header() const
{
  std::vector<std::string> names = {"mode [1]", "frequency [Hz]", "growth rate [1/s]",
                                    "modal mass [kg]", "elastic energy [J]"};
  const std::array<const char *, 3> axes = {{"x", "y", "z"}};
  for (unsigned int d = 0; d < dim; ++d)
    names.push_back(std::string("share of energy along ") + axes[d] + " [1]");
  for (const RigidMotion<dim> &motion : motions)
  {
    const std::string where = (motion.rotates ? "about " : "along ") + motion.axis;
    names.push_back("participation " + where + (motion.rotates ? " [1/m]" : " [1]"));
    names.push_back((motion.rotates ? "effective inertia " : "effective mass ") + where +
                    (motion.rotates ? " [kg m^2]" : " [kg]"));
    names.push_back("share of " + std::string(motion.rotates ? "inertia " : "mass ") + where +
                    " [1]");
  }
  names.emplace_back("residual [1]");
  for (const std::string &name : run.input.probes.column_names())
    names.push_back(name);
  return names;
}

template <int dim>
std::vector<double> Modal<dim>::row(const unsigned int number, const Mode &mode) const
{
  std::vector<double> values = {static_cast<double>(number), mode.frequency, mode.growth_rate,
                                mode.mass, mode.energy};
  values.insert(values.end(), mode.direction_shares.begin(), mode.direction_shares.end());
  for (unsigned int m = 0; m < motions.size(); ++m)
  {
    values.push_back(mode.participations[m]);
    values.push_back(mode.inertia_shares[m] * motions[m].inertia);
    values.push_back(mode.inertia_shares[m]);
  }
  values.push_back(mode.residual);
  return values;
}

template <int dim>
void Modal<dim>::add_quantities(const unsigned int number, const Mode &mode)
{
  const std::string name = "mode " + std::to_string(number) + " ";
  run.summary.add({name + "frequency", mode.frequency, "Hz", ""});
  run.summary.add({name + "growth rate", mode.growth_rate, "1/s", ""});
  for (unsigned int m = 0; m < motions.size(); ++m)
    run.summary.add({name +
                         (motions[m].rotates ? "share of inertia about " : "share of mass along ") +
                         motions[m].axis,
                     mode.inertia_shares[m], "1", ""});
}

template <int dim>
void Modal<dim>::check(const Case<dim> &input, ParameterSection root)
{
  if (!input.modal.highest() && input.modal.shift == 0.)
    refuse_free_motions(input, root, ", so that the frequency 0 Hz is a mode's",
                        "; or give Modal/Shift a frequency, such as half of the first mode's");
}

template <int dim>
void Modal<dim>::name_quantities(const Case<dim> &input, QuantityNames &names)
{
  const bool axisymmetric = input.problem.model == Model::axisymmetric;
  const std::string axes = dim == 2 ? "xy" : "xyz";
  names.add("mass");
  names.add("largest residual");
  for (const char axis : axes)
    names.add(std::string("share of mass along ") + axis);
  for (unsigned int k = 1; k <= input.modal.n_modes; ++k)
  {
    const std::string mode = "mode " + std::to_string(k) + " ";
    names.add(mode + "frequency");
    names.add(mode + "growth rate");
    for (const char axis : axisymmetric ? std::string("x") : axes)
      names.add(mode + "share of mass along " + axis);
    for (const char axis : axisymmetric ? std::string() : dim == 2 ? std::string("z") : axes)
      names.add(mode + "share of inertia about " + axis);
  }
}
template <int dim>
void Modal<dim>::perform()
{
  run.initialise();
  Case<dim> &input = run.input;
  prepare();
  std::vector<Eigenpair> pairs = solve();
  stop_if_asked("the eigenvalues");
  if (pairs.size() < input.modal.n_modes)
    run.log.warning("the body has only " + std::to_string(pairs.size()) + " modes on this mesh");

  std::unique_ptr<TableWriter> table;
  if (run.is_writer)
    table = std::make_unique<TableWriter>(run.directory.file("modes.csv"), header());
  FieldWriter<dim> writer(input.communicator, run.directory.path(),
                          input.output.subdivisions_for(input.discretisation.velocities_per_cell()),
                          input.output.higher_order_cells, input.output.files_per_state);
  std::vector<std::string> texts;
  std::vector<double> carried(motions.size(), 0.);
  double largest_residual = 0.;
  for (unsigned int k = 0; k < pairs.size(); ++k)
  {
    normalise(pairs[k], input.communicator);
    Mode mode = describe(pairs[k], vibration->is_symmetric());
    vibration->set_shape(pairs[k].real, mode.eigenvalue.real());
    // A shape has no velocity: all of it is that of springs and pressure.
    mode.energy = run.solver->energy().sum();
    texts.push_back(text_of(k + 1, mode));
    run.log.line(texts.back());
    add_quantities(k + 1, mode);
    for (unsigned int m = 0; m < motions.size(); ++m)
      carried[m] += mode.inertia_shares[m];
    largest_residual = std::max(largest_residual, mode.residual);
    const std::vector<double> probe_values = input.probes.present_values();
    if (table)
    {
      std::vector<double> values = row(k + 1, mode);
      values.insert(values.end(), probe_values.begin(), probe_values.end());
      table->row(values);
    }
    if (!input.output.final_fields)
      continue;
    writer.write(*run.solver, k + 1.);
    if (pairs[k].value.imag() != 0.)
    {
      // The part that is a quarter of a period away.
      vibration->set_shape(pairs[k].imaginary, mode.eigenvalue.real());
      writer.write(*run.solver, k + 1.5);
    }
  }
  if (table)
    table->flush();
  if (input.output.final_fields)
    writer.finish(run.summary);
  run.summary.set("modes", texts);
  for (unsigned int m = 0; m < motions.size(); ++m)
    if (!motions[m].rotates)
    {
      run.summary.add({"share of mass along " + motions[m].axis, carried[m], "1", ""});
      if (m == 0)
        run.summary.add({"mass", motions[m].inertia, "kg", ""});
    }
  run.summary.add({"largest residual", largest_residual, "1", ""});
  run.citations.add("slepc");
  run.finish(0, 0.);
}

template class Modal<2>;
template class Modal<3>;
} // namespace Continua
