#include <continua/finite_element/solvers/harmonic_matrix.h>

#include <continua/base/collective.h>
#include <continua/finite_element/solvers/condensed_system.h>

#include <algorithm>
#include <functional>

namespace Continua
{
namespace
{
using Complex = std::complex<double>;

template <typename Number>
void gather(std::vector<Number> &values, const MPI_Datatype type, const MPI_Comm communicator)
{
  int n_ranks = 1;
  MPI_Comm_size(communicator, &n_ranks);
  const int n_own = static_cast<int>(values.size());
  std::vector<int> counts(n_ranks), starts(n_ranks, 0);
  MPI_Allgather(&n_own, 1, MPI_INT, counts.data(), 1, MPI_INT, communicator);
  for (int rank = 1; rank < n_ranks; ++rank)
    starts[rank] = starts[rank - 1] + counts[rank - 1];
  std::vector<Number> all(starts.back() + counts.back());
  MPI_Allgatherv(values.data(), n_own, type, all.data(), counts.data(), starts.data(), type,
                 communicator);
  values = std::move(all);
}

/// Gives each rank the triplets of all ranks.
template <typename Entries>
void gather_entries(Entries &triplets, const MPI_Comm communicator)
{
  gather(triplets.rows, MPI_INT, communicator);
  gather(triplets.columns, MPI_INT, communicator);
  gather(triplets.values, MPI_DOUBLE, communicator);
}

/// Whether a row has nothing but a number on its diagonal, which belongs to the constant part.
template <int dim>
bool is_held(const Space<dim> &space, const BoundaryConstraints<dim> &constraints, const int row)
{
  const int n_velocities = space.velocity_dofs.n_dofs();
  if (row >= n_velocities)
    return space.pressure_owned.is_element(row - n_velocities) &&
           space.pressure_hanging.is_constrained(row - n_velocities);
  return space.velocity_owned.is_element(row) && constraints.all().is_constrained(row);
}
} // namespace

template <typename Entries>
void HarmonicMatrix::take_places(const Entries &triplets)
{
  const std::size_t n_old = pattern.size();
  for (std::size_t k = 0; k < triplets.rows.size(); ++k)
    pattern.push_back(static_cast<unsigned long long>(triplets.rows[k]) * n + triplets.columns[k]);
  std::sort(pattern.begin() + n_old, pattern.end());
  pattern.erase(std::unique(pattern.begin() + n_old, pattern.end()), pattern.end());
  std::inplace_merge(pattern.begin(), pattern.begin() + n_old, pattern.end());
  pattern.erase(std::unique(pattern.begin(), pattern.end()), pattern.end());
}

template <typename Entries>
HarmonicMatrix::Part HarmonicMatrix::part_of(const Entries &triplets) const
{
  Part part;
  part.values = triplets.values;
  for (std::size_t k = 0; k < triplets.rows.size(); ++k)
    part.places.push_back(std::lower_bound(pattern.begin(), pattern.end(),
                                           static_cast<unsigned long long>(triplets.rows[k]) * n +
                                               triplets.columns[k]) -
                          pattern.begin());
  return part;
}

template <int dim>
void HarmonicMatrix::build(const Space<dim> &space,
                           const std::vector<RegionOperators> &operators,
                           const BoundaryConstraints<dim> &constraints)
{
  const unsigned int n_regions = operators.size();
  n = static_cast<int>(space.velocity_dofs.n_dofs() + space.pressure_dofs.n_dofs());
  pattern.clear();
  SystemCoefficients none;
  none.mass.assign(n_regions, 0.);
  none.stiffness.assign(n_regions, 0.);
  none.compressibility.assign(n_regions, 0.);

  // The divergence and the rows of what is held.
  SymmetricTriplets of_constant = condensed_triplets(space, operators, constraints, none);
  gather_entries(of_constant, space.communicator);
  // One coefficient at a time is 1, without the divergence.
  none.left_out.assign(n_regions, true);
  std::vector<SymmetricTriplets> of_parts;
  const auto add = [&](const std::function<void(SystemCoefficients &)> &set)
  {
    SystemCoefficients one = none;
    set(one);
    const SymmetricTriplets all = condensed_triplets(space, operators, constraints, one);
    SymmetricTriplets part;
    for (std::size_t k = 0; k < all.rows.size(); ++k)
      if (!is_held(space, constraints, all.rows[k]))
      {
        part.rows.push_back(all.rows[k]);
        part.columns.push_back(all.columns[k]);
        part.values.push_back(all.values[k]);
      }
    gather_entries(part, space.communicator);
    of_parts.push_back(std::move(part));
  };
  for (unsigned int region = 0; region < n_regions; ++region)
    for (std::vector<double> SystemCoefficients::*const kind :
         {&SystemCoefficients::mass, &SystemCoefficients::stiffness,
          &SystemCoefficients::compressibility})
      add([&](SystemCoefficients &one) { (one.*kind)[region] = 1.; });
  add([](SystemCoefficients &one) { one.support_stiffness = 1.; });
  add([](SystemCoefficients &one) { one.support_damping = 1.; });

  take_places(of_constant);
  for (const SymmetricTriplets &part : of_parts)
    take_places(part);
  constant = part_of(of_constant);
  mass.clear();
  stiffness.clear();
  compression.clear();
  for (unsigned int region = 0; region < n_regions; ++region)
  {
    mass.push_back(part_of(of_parts[3 * region]));
    stiffness.push_back(part_of(of_parts[3 * region + 1]));
    compression.push_back(part_of(of_parts[3 * region + 2]));
  }
  support_stiffness = part_of(of_parts[3 * n_regions]);
  support_damping = part_of(of_parts[3 * n_regions + 1]);
}

template <int dim>
void HarmonicMatrix::build(const Space<dim> &space,
                           const std::vector<RegionOperators> &operators,
                           const BoundaryConstraints<dim> &constraints,
                           const LoadedBody<dim> &loaded)
{
  using Kind = LoadedPart;
  const unsigned int n_regions = operators.size();
  n = static_cast<int>(space.velocity_dofs.n_dofs() + space.pressure_dofs.n_dofs());
  has_one_triangle = false;
  pattern.clear();
  SystemCoefficients none;
  none.mass.assign(n_regions, 0.);
  none.stiffness.assign(n_regions, 0.);
  none.compressibility.assign(n_regions, 0.);
  none.left_out.assign(n_regions, true);
  // Of the linear terms there are the supports alone, and the rows of what is held.
  const auto linear = [&](const SystemCoefficients &coefficients, const bool of_held)
  {
    const SymmetricTriplets lower = condensed_triplets(space, operators, constraints, coefficients);
    Triplets entries;
    const auto add = [&entries](const int row, const int column, const double value)
    {
      entries.rows.push_back(row);
      entries.columns.push_back(column);
      entries.values.push_back(value);
    };
    for (std::size_t k = 0; k < lower.rows.size(); ++k)
      if (is_held(space, constraints, lower.rows[k]) == of_held)
      {
        add(lower.rows[k], lower.columns[k], lower.values[k]);
        if (lower.rows[k] != lower.columns[k])
          add(lower.columns[k], lower.rows[k], lower.values[k]);
      }
    return entries;
  };
  Triplets of_constant = linear(none, true);
  std::vector<Triplets> of_parts;
  for (unsigned int region = 0; region < n_regions; ++region)
  {
    loaded.add_entries(Kind::stiffness, region, constraints.all(), of_constant);
    for (const Kind kind : {Kind::mass, Kind::relaxation, Kind::viscosity})
    {
      of_parts.emplace_back();
      loaded.add_entries(kind, region, constraints.all(), of_parts.back());
    }
  }
  SystemCoefficients of_support = none;
  of_support.support_stiffness = 1.;
  of_parts.push_back(linear(of_support, false));
  of_support.support_stiffness = 0.;
  of_support.support_damping = 1.;
  of_parts.push_back(linear(of_support, false));

  gather_entries(of_constant, space.communicator);
  take_places(of_constant);
  for (Triplets &part : of_parts)
  {
    gather_entries(part, space.communicator);
    take_places(part);
  }
  constant = part_of(of_constant);
  mass.clear();
  stiffness.clear();
  compression.clear();
  viscosity.clear();
  for (unsigned int region = 0; region < n_regions; ++region)
  {
    mass.push_back(part_of(of_parts[3 * region]));
    stiffness.push_back(part_of(of_parts[3 * region + 1]));
    viscosity.push_back(part_of(of_parts[3 * region + 2]));
  }
  support_stiffness = part_of(of_parts[3 * n_regions]);
  support_damping = part_of(of_parts[3 * n_regions + 1]);
}

std::vector<int> HarmonicMatrix::rows() const
{
  std::vector<int> result;
  result.reserve(pattern.size());
  for (const unsigned long long place : pattern)
    result.push_back(static_cast<int>(place / n));
  return result;
}

std::vector<int> HarmonicMatrix::columns() const
{
  std::vector<int> result;
  result.reserve(pattern.size());
  for (const unsigned long long place : pattern)
    result.push_back(static_cast<int>(place % n));
  return result;
}

void HarmonicMatrix::set_values(const HarmonicCoefficients &coefficients,
                                std::vector<Complex> &values) const
{
  values.assign(pattern.size(), 0.);
  const auto add = [&values](const Complex factor, const Part &part)
  {
    for (std::size_t k = 0; k < part.places.size(); ++k)
      values[part.places[k]] += factor * part.values[k];
  };
  add(1., constant);
  for (unsigned int region = 0; region < mass.size(); ++region)
  {
    add(coefficients.mass[region], mass[region]);
    add(coefficients.stiffness[region], stiffness[region]);
    if (!compression.empty())
      add(coefficients.compressibility[region], compression[region]);
    if (!viscosity.empty())
      add(coefficients.viscosity[region], viscosity[region]);
  }
  add(coefficients.support_stiffness, support_stiffness);
  add(coefficients.support_damping, support_damping);
}

template void HarmonicMatrix::build(const Space<2> &,
                                    const std::vector<RegionOperators> &,
                                    const BoundaryConstraints<2> &);
template void HarmonicMatrix::build(const Space<2> &,
                                    const std::vector<RegionOperators> &,
                                    const BoundaryConstraints<2> &,
                                    const LoadedBody<2> &);
template void HarmonicMatrix::build(const Space<3> &,
                                    const std::vector<RegionOperators> &,
                                    const BoundaryConstraints<3> &);
template void HarmonicMatrix::build(const Space<3> &,
                                    const std::vector<RegionOperators> &,
                                    const BoundaryConstraints<3> &,
                                    const LoadedBody<3> &);
} // namespace Continua
