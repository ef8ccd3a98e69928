#include <continua/finite_element/assembly/initial_state.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/numerics/vector_tools.h>

#include <cmath>
#include <sstream>

namespace Continua
{
using namespace dealii;

namespace
{
/// Expressions as a deal.II function, component by component.
template <int dim>
class ExpressionFunction : public Function<dim>
{
public:
  explicit ExpressionFunction(const std::vector<Expression> &components,
                              const std::vector<double> &divisors = {})
      : Function<dim>(components.size()), components(components), divisors(divisors)
  {
  }
  double value(const Point<dim> &point, const unsigned int component) const override
  {
    double coordinates[3] = {0., 0., 0.};
    for (unsigned int c = 0; c < dim; ++c)
      coordinates[c] = point[c];
    return components[component](coordinates, 0.) / (divisors.empty() ? 1. : divisors[component]);
  }

private:
  const std::vector<Expression> &components;
  std::vector<double> divisors; ///< one a component, or none
};
/// sum M_p / K on the pressures that it determines; the identity on the idle ones (incompressible,
/// or hanging).
template <int dim>
struct PressureCompressibility
{
  const Space<dim> &space;
  const Problem &problem;
  const std::vector<RegionOperators> &operators;
  DistributedVector diagonal;
  std::vector<unsigned int> idle; ///< local indices

  void reinit()
  {
    diagonal = space.pressure_vector();
    for (unsigned int i = 0; i < space.pressure_owned.n_elements(); ++i)
    {
      const auto global = space.pressure_owned.nth_index_in_set(i);
      double &entry = diagonal.begin()[i];
      for (unsigned int region = 0; region < operators.size(); ++region)
        entry += problem.materials[region].inverse_bulk_modulus() *
                 operators[region].pressure_mass.el(global, global);
      if (entry == 0. || space.pressure_hanging.is_constrained(global))
      {
        entry = 1.;
        idle.push_back(i);
      }
    }
  }
  void set_idle_to_zero(DistributedVector &vector) const
  {
    for (const unsigned int i : idle)
      vector.begin()[i] = 0.;
  }
  void vmult(DistributedVector &target, const DistributedVector &source) const
  {
    DistributedVector product(source);
    target = 0.;
    for (unsigned int region = 0; region < operators.size(); ++region)
      if (!problem.materials[region].is_incompressible())
      {
        multiply(operators[region].pressure_mass, product, source);
        target.add(problem.materials[region].inverse_bulk_modulus(), product);
      }
    set_idle_to_zero(target);
  }
};

struct DiagonalInverse
{
  const DistributedVector &diagonal;
  void vmult(DistributedVector &target, const DistributedVector &source) const
  {
    for (unsigned int i = 0; i < source.locally_owned_size(); ++i)
      target.begin()[i] = source.begin()[i] / diagonal.begin()[i];
  }
};
} // namespace

template <int dim>
void solve_equilibrium_pressure(const Space<dim> &space,
                                const Problem &problem,
                                const std::vector<RegionOperators> &operators,
                                const DistributedVector &displacement,
                                DistributedVector &pressure)
{
  PressureCompressibility<dim> matrix{space, problem, operators, {}, {}};
  matrix.reinit();
  DistributedVector right_hand_side = space.pressure_vector(), product = right_hand_side;
  for (const RegionOperators &region : operators)
  {
    multiply(region.divergence, product, displacement);
    right_hand_side.add(-1., product);
  }
  matrix.set_idle_to_zero(right_hand_side);
  pressure = 0.;
  SolverControl control(1000, 1e-14 * right_hand_side.l2_norm());
  SolverCG<DistributedVector> solver(control);
  solver.solve(matrix, pressure, right_hand_side, DiagonalInverse{matrix.diagonal});
}

namespace
{
/// Warns if an initial field changes the volume of an incompressible material: no later step takes
/// that back.
template <int dim>
void warn_of_volume_change(const Space<dim> &space,
                           const Problem &problem,
                           const std::vector<RegionOperators> &operators,
                           const DistributedVector &field,
                           const std::string &name,
                           Log &log)
{
  DistributedVector divergence = space.pressure_vector(), strain = space.velocity_vector();
  for (unsigned int region = 0; region < operators.size(); ++region)
    if (problem.materials[region].is_incompressible())
    {
      multiply(operators[region].divergence, divergence, field);
      operators[region].multiply_stiffness(strain, field);
      // int (div u)^2, with the diagonal of the mass matrix, against int 2 dev sym grad u : dev sym
      // grad u.
      double square = 0.;
      for (unsigned int i = 0; i < space.pressure_owned.n_elements(); ++i)
      {
        // Zero for a pressure of another region.
        const auto global = space.pressure_owned.nth_index_in_set(i);
        const double mass = operators[region].pressure_mass.el(global, global);
        if (mass > 0.)
          square += divergence.begin()[i] * divergence.begin()[i] / mass;
      }
      square = Utilities::MPI::sum(square, space.communicator);
      if (square > 0.05 * 0.05 * (strain * field))
        log.warning("the initial " + name + " changes the volume of the incompressible region '" +
                    problem.regions[region] + "', which no later step takes back");
    }
}
} // namespace

template <int dim>
void set_initial_state(const Space<dim> &space,
                       const Problem &problem,
                       const std::vector<RegionOperators> &operators,
                       Log &log,
                       DistributedVector &velocity,
                       DistributedVector &displacement,
                       DistributedVector &pressure)
{
  const InteriorData &data = problem.interior;
  if (!data.initial_velocity.empty())
    VectorTools::interpolate(space.mapping, space.velocity_dofs,
                             ExpressionFunction<dim>(data.initial_velocity), velocity);
  if (!data.initial_displacement.empty())
    VectorTools::interpolate(space.mapping, space.velocity_dofs,
                             ExpressionFunction<dim>(data.initial_displacement), displacement);
  if (!data.initial_pressure.empty())
  {
    std::vector<Expression> by_component = data.initial_pressure;
    by_component.resize(space.pressure_elements.n_components());
    // The mean pressure is given; in plane stress the unknown is another multiple of it.
    std::vector<double> factors;
    for (unsigned int component = 0; component < by_component.size(); ++component)
      factors.push_back(problem.plane_stress(component).pressure_factor);
    VectorTools::interpolate(space.mapping, space.pressure_dofs,
                             ExpressionFunction<dim>(by_component, factors), pressure);
  }
  space.set_hanging_velocities_to_zero(velocity);
  space.set_hanging_velocities_to_zero(displacement);
  space.set_hanging_pressures_to_zero(pressure);
  // What follows is of a small deformation; in a finite one the closed row of the volume takes the
  // pressure to its displacement.
  if (problem.has_regions_of(RegionModel::finite_solid))
    return;
  warn_of_volume_change(space, problem, operators, velocity, "velocity", log);
  if (data.initial_displacement.empty())
    return;
  warn_of_volume_change(space, problem, operators, displacement, "displacement", log);
  if (data.initial_pressure.empty())
  {
    solve_equilibrium_pressure(space, problem, operators, displacement, pressure);
    log.line("Initial pressure: in equilibrium with the initial displacement");
    return;
  }
  // What was given must obey p = -K div D in the solids, or they start with a shock that nobody
  // asked for. Measured by M_p, region by region, since elsewhere the pressure has no displacement
  // to obey.
  DistributedVector difference = space.pressure_vector(), product = difference;
  solve_equilibrium_pressure(space, problem, operators, displacement, difference);
  difference.add(-1., pressure);
  double square = 0., scale = 0.;
  for (unsigned int region = 0; region < operators.size(); ++region)
    if (problem.materials[region].phase() == 1. && !problem.materials[region].is_incompressible())
    {
      multiply(operators[region].pressure_mass, product, difference);
      square += product * difference;
      multiply(operators[region].pressure_mass, product, pressure);
      scale += product * pressure;
    }
  if (square > 0.05 * 0.05 * scale)
  {
    std::ostringstream text;
    text
        << "the initial pressure of a solid is not that of its initial displacement (p = -K div D)";
    if (scale > 0.)
      text << ": they differ by " << 100. * std::sqrt(square / scale) << " %";
    log.warning(text.str());
  }
}

template void solve_equilibrium_pressure(const Space<2> &,
                                         const Problem &,
                                         const std::vector<RegionOperators> &,
                                         const DistributedVector &,
                                         DistributedVector &);
template void set_initial_state(const Space<2> &,
                                const Problem &,
                                const std::vector<RegionOperators> &,
                                Log &,
                                DistributedVector &,
                                DistributedVector &,
                                DistributedVector &);
template void solve_equilibrium_pressure(const Space<3> &,
                                         const Problem &,
                                         const std::vector<RegionOperators> &,
                                         const DistributedVector &,
                                         DistributedVector &);
template void set_initial_state(const Space<3> &,
                                const Problem &,
                                const std::vector<RegionOperators> &,
                                Log &,
                                DistributedVector &,
                                DistributedVector &,
                                DistributedVector &);
} // namespace Continua
