// The step of a discretisation with one velocity and one pressure: a mass on a spring and a dash
// pot, which presses on a compressible volume. Each scheme's values are those of its textbook
// formula for the oscillator; energies and powers balance; a step can be undone, a state saved and
// loaded; the body at rest is the load over both stiffnesses. The same with a support, which adds
// to spring and dash pot.

#include <continua/continuum/time_stepping.h>

#include "../unit_test.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace test_of_time_stepping
{
namespace
{
using namespace Continua;
using namespace dealii;
constexpr double mass_entry = 2., stiffness_entry = 3., divergence_entry = 0.7, volume = 0.25;
constexpr double density = 1.5, shear_modulus = 4., viscosity = 0.3, bulk_modulus = 5., load = 6.;
constexpr double support_stiffness = 2.5, support_damping = 0.4;
constexpr double h = 0.05;

DistributedVector one_entry()
{
  return DistributedVector(complete_index_set(1), MPI_COMM_SELF);
}

/// A body force.
class OneForce : public LoadList
{
public:
  using LoadList::LoadList;

private:
  DistributedVector zero_forces() const override { return one_entry(); }
  void integrate(const Item &,
                 const Waveform *const waveform,
                 const double time,
                 DistributedVector &forces) const override
  {
    const double origin[3] = {0., 0., 0.};
    forces.add((*waveform)(origin, time));
  }
  std::vector<std::array<double, 3>> places(const Item &) const override
  {
    return {{{0., 0., 0.}}};
  }
};

/// One entry everywhere; G = -B.
class OneEntryProducts : public ProductsByRegion
{
public:
  /// `keeps_products`: of the levels, else each product is made where it is needed.
  explicit OneEntryProducts(const bool keeps_products) : keeps_products(keeps_products) {}
  /// Of mass, stiffness and divergence.
  mutable unsigned int n_products = 0;

  bool has_level_products() const override { return keeps_products; }
  void multiply_mass(unsigned int, DistributedVector &y, const DistributedVector &x) const override
  {
    ++n_products;
    y.equ(mass_entry, x);
  }
  void
  multiply_stiffness(unsigned int, DistributedVector &y, const DistributedVector &x) const override
  {
    ++n_products;
    y.equ(stiffness_entry, x);
  }
  void
  multiply_gradient(unsigned int, DistributedVector &y, const DistributedVector &x) const override
  {
    y.equ(-divergence_entry, x);
  }
  void
  multiply_divergence(unsigned int, DistributedVector &y, const DistributedVector &x) const override
  {
    ++n_products;
    y.equ(divergence_entry, x);
  }
  void multiply_pressure_mass(unsigned int,
                              DistributedVector &y,
                              const DistributedVector &x) const override
  {
    y.equ(volume, x);
  }
  void multiply_support_stiffness(unsigned int,
                                  DistributedVector &y,
                                  const DistributedVector &x) const override
  {
    y.equ(support_stiffness, x);
  }
  void multiply_support_damping(unsigned int,
                                DistributedVector &y,
                                const DistributedVector &x) const override
  {
    y.equ(support_damping, x);
  }
  double
  pressure_power(unsigned int, const DistributedVector &u, const DistributedVector &p) override
  {
    ++n_products;
    return -divergence_entry * u[0] * p[0];
  }
  double
  pressure_product(unsigned int, const DistributedVector &p, const DistributedVector &q) override
  {
    return volume * p[0] * q[0];
  }
  double divergence(const DistributedVector &) override { return 0.; }

private:
  const bool keeps_products;
};

class NothingPrescribed : public PrescribedVelocities
{
public:
  bool jumps(double, double) const override { return false; }
  bool is_homogeneous() const override { return true; }
  void evaluate(double, DistributedVector &) const override {}
  void prescribed_part(const DistributedVector &, DistributedVector &) const override {}
  void clear_prescribed(DistributedVector &) const override {}
  void set_prescribed(const DistributedVector &, DistributedVector &) const override {}
};

class OneEntrySystem : public LinearSystem
{
public:
  SystemChange prepare(const SystemCoefficients &coefficients, double) override
  {
    const bool changed = !(coefficients == system);
    system = coefficients;
    return changed ? SystemChange::factor : SystemChange::none;
  }
  void
  eliminate_prescribed(const DistributedVector &, DistributedVector &, DistributedVector &) override
  {
  }
  void solve(const DistributedVector &,
             DistributedVector &momentum,
             DistributedVector &mass,
             DistributedVector &velocity,
             DistributedVector &pressure,
             StepReport &) override
  {
    // a U - b p = f, b U + c p = g.
    const double a = system.mass[0] * mass_entry + system.stiffness[0] * stiffness_entry +
                     system.support_stiffness * support_stiffness +
                     system.support_damping * support_damping;
    const double b = divergence_entry, c = system.compressibility[0] * volume;
    const double f = momentum[0], g = mass[0], determinant = a * c + b * b;
    velocity = (c * f + b * g) / determinant;
    pressure = (a * g - b * f) / determinant;
  }
  void add_velocity_product(const DistributedVector &, DistributedVector &) override {}
  void add_divergence(const DistributedVector &, DistributedVector &) override {}
  void restrict_residuals(DistributedVector &, DistributedVector &) const override {}

private:
  SystemCoefficients system;
};

class NoPorts : public Ports
{
public:
  DistributedVector flow_of_velocities(unsigned int) const override { return one_entry(); }
  DistributedVector flow_profile(unsigned int) const override { return one_entry(); }
};

class OneMass : public Operators
{
public:
  OneMass(const Problem &problem, const bool keeps_products)
      : one_entry_products(keeps_products), plain_step(one_entry_products), force(problem)
  {
  }
  unsigned int &n_products() { return one_entry_products.n_products; }

  void setup() override { force.build(); }
  ProductsByRegion &products() override { return one_entry_products; }
  PrescribedVelocities &prescribed() override { return nothing_prescribed; }
  LinearSystem &system() override { return one_entry_system; }
  StepVariant &variant() override { return plain_step; }
  const LoadList &loads() const override { return force; }
  Ports &ports() override { return no_ports; }
  DistributedVector velocity_vector() const override { return one_entry(); }
  DistributedVector pressure_vector() const override { return one_entry(); }
  std::vector<std::vector<unsigned int>> velocity_nodes() const override { return {{0}}; }
  std::vector<std::vector<unsigned int>> pressure_nodes() const override { return {{0}}; }
  std::vector<unsigned int> pressures_without_history() const override { return {}; }
  StateNumbering numbering() const override
  {
    return {VectorNumbering(MPI_COMM_SELF, "velocity", {0}),
            VectorNumbering(MPI_COMM_SELF, "pressure", {0})};
  }
  void set_initial_state(DistributedVector &velocity,
                         DistributedVector &displacement,
                         DistributedVector &pressure) override
  {
    velocity.add(0.8);
    displacement.add(0.2);
    pressure.add(-bulk_modulus * divergence_entry / volume * 0.2);
  }
  void prepare_transfer(const StateVectors &) override {}
  void finish_transfer(const StateVectors &) override {}
  SolverSizes sizes() const override { return {}; }

private:
  OneEntryProducts one_entry_products;
  NothingPrescribed nothing_prescribed;
  OneEntrySystem one_entry_system;
  StepVariant plain_step;
  NoPorts no_ports;
  OneForce force;
};

/// m u' + c u + k d = f, d' = u.
struct Oscillator
{
  explicit Oscillator(const bool is_supported)
  {
    if (is_supported)
    {
      c += support_damping;
      k += support_stiffness;
    }
  }

  double m = density * mass_entry, c = viscosity * stiffness_entry,
         k = shear_modulus * stiffness_entry +
             bulk_modulus * divergence_entry * divergence_entry / volume;
  double u = 0.8, d = 0.2, u_older = 0.8, d_older = 0.2;

  void step(const std::string &scheme, const bool second_order)
  {
    double u_new = 0., d_new = 0.;
    if (scheme == "crank nicolson")
    {
      // (u_new - u)/h = (f - c (u_new + u)/2 - k (d + h (u_new + u)/4))/m, d_new = d + h (u_new +
      // u)/2.
      u_new = (m / h * u + load - 0.5 * c * u - k * (d + 0.25 * h * u)) /
              (m / h + 0.5 * c + 0.25 * k * h);
      d_new = d + 0.5 * h * (u_new + u);
    }
    else if (scheme == "euler, trapezoidal")
    {
      // (u_new - u)/h = (f - c u_new - k d_new)/m, d_new = d + h (u_new + u)/2.
      u_new = (m / h * u + load - k * (d + 0.5 * h * u)) / (m / h + c + 0.5 * k * h);
      d_new = d + 0.5 * h * (u_new + u);
    }
    else if (second_order)
    {
      // (1.5 u_new - 2 u + 0.5 u_older)/h, and d likewise.
      const double known = (4. * d - d_older) / 3.;
      u_new = (m / h * (2. * u - 0.5 * u_older) + load - k * known) /
              (1.5 * m / h + c + k * 2. * h / 3.);
      d_new = known + 2. * h / 3. * u_new;
    }
    else
    {
      u_new = (m / h * u + load - k * d) / (m / h + c + k * h);
      d_new = d + h * u_new;
    }
    u_older = u;
    d_older = d;
    u = u_new;
    d = d_new;
  }
  double energy() const { return 0.5 * m * u * u + 0.5 * k * d * d; }
};

Problem one_mass_problem(const bool is_supported)
{
  Problem problem;
  problem.communicator = MPI_COMM_SELF;
  problem.regions = {"body"};
  Material material;
  material.density = density;
  material.shear.viscosity = viscosity;
  material.compression = Compression::elastic(1. / bulk_modulus);
  material.shear.branches = {Branch{shear_modulus, std::numeric_limits<double>::infinity()}};
  problem.materials = {material};
  problem.interior.body_force = {Waveform(load)};
  if (is_supported)
  {
    problem.conditions.resize(1);
    problem.conditions[0].normal.stiffness = support_stiffness;
    problem.conditions[0].normal.damping = support_damping;
  }
  return problem;
}

Step make_step(const std::string &scheme, const unsigned int i)
{
  if (scheme == "crank nicolson")
    return crank_nicolson_step(i * h, h);
  return scheme == "backward differencing" && i > 0
             ? backward_differencing_step(i * h, h, h, Update::implicit)
             : euler_step(i * h, h,
                          scheme == "euler, trapezoidal" ? Update::trapezoidal : Update::implicit);
}

void by_scheme(const std::string &scheme, const bool is_supported, const bool keeps_products)
{
  const std::string name = scheme + (is_supported ? ", supported" : "") +
                           (keeps_products ? ", with the products of levels" : "");
  const Problem problem = one_mass_problem(is_supported);
  OneMass operators(problem, keeps_products);
  Log log(MPI_COMM_SELF);
  TimeStepping stepping(problem, operators, log);
  stepping.initialise();
  Oscillator exact(is_supported);
  check::relative(name + ": energy at the start", stepping.energy().sum(), exact.energy(), 1e-13);
  double error = 0., balance = 0., energy = 0.;
  for (unsigned int i = 0; i < 40; ++i)
  {
    const Step step = make_step(scheme, i);
    const double energy_before = stepping.energy().sum();
    stepping.keep_state();
    if (i == 20)
    {
      // A step of another size, undone.
      stepping.advance(euler_step(i * h, 3. * h, Update::implicit));
      stepping.return_to_kept_state();
    }
    stepping.advance(step);
    exact.step(scheme, i > 0 && scheme == "backward differencing");
    const State state = stepping.state();
    error =
        std::max({error, std::abs(state.velocity[0] - exact.u),
                  std::abs(state.history.displacement()[0] - exact.d),
                  std::abs(state.pressure[0] + bulk_modulus * divergence_entry / volume * exact.d) /
                      bulk_modulus});
    const PowerBalance powers = stepping.power_balance(true);
    balance = std::max(balance, std::abs(powers.residual) / powers.exchanged);
    energy = std::max(energy, std::abs(stepping.energy().sum() - exact.energy()));
    if (scheme == "crank nicolson")
    {
      // The midpoint rule loses nothing but by viscosity and by the damper.
      const double work = powers.external - powers.materials[0].terms[2] -
                          (is_supported ? powers.materials[0].terms[5] : 0.);
      energy = std::max(energy, std::abs(stepping.energy().sum() - energy_before - h * work));
    }
  }
  check::absolute(name + ": velocity, displacement, pressure", error, 0., 1e-12);
  check::absolute(name + ": power balance", balance, 0., 1e-13);
  check::absolute(name + ": energy", energy, 0., 1e-12);
  if (keeps_products)
  {
    // Of M v, S v, S d and B v each level has one, whoever asks for it.
    operators.n_products() = 0;
    stepping.advance(make_step(scheme, 40));
    stepping.power_balance(true);
    stepping.energy();
    stepping.advance(make_step(scheme, 41));
    stepping.power_balance(true);
    stepping.energy();
    check::is_true(name + ": four products a step", operators.n_products() == 8);
  }

  ArchiveWriter writer;
  stepping.save(writer);
  writer.write("one_mass.archive");
  writer.piece().write("one_mass.piece");
  ArchiveReader reader("one_mass.archive");
  reader.set_pieces({"one_mass.piece"});
  TimeStepping other(problem, operators, log);
  other.initialise();
  other.load(reader);
  const Step step = make_step(scheme, keeps_products ? 42 : 40);
  stepping.keep_state();
  other.keep_state();
  stepping.advance(step);
  other.advance(step);
  check::is_true(name + ": goes on from an archive to the last bit",
                 stepping.state().velocity[0] == other.state().velocity[0] &&
                     stepping.state().pressure[0] == other.state().pressure[0]);
}
} // namespace

UNIT_TEST(time_stepping)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const std::string scheme : {"euler", "backward differencing", "crank nicolson"})
    for (const bool is_supported : {false, true})
      by_scheme(scheme, is_supported, false);
  for (const std::string scheme :
       {"euler", "euler, trapezoidal", "backward differencing", "crank nicolson"})
    by_scheme(scheme, false, true);

  for (const bool is_supported : {false, true})
  {
    const Problem problem = one_mass_problem(is_supported);
    OneMass operators(problem, true);
    Log log(MPI_COMM_SELF);
    TimeStepping stepping(problem, operators, log);
    stepping.initialise();
    check::is_true("one solve finds the body at rest", stepping.steady_is_direct());
    stepping.solve_steady(0.);
    check::relative(is_supported ? "displacement at rest, supported" : "displacement at rest",
                    stepping.state().history.displacement()[0], load / Oscillator(is_supported).k,
                    1e-13);
  }
}
} // namespace test_of_time_stepping
