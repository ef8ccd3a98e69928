#include <continua/analysis/mode_search.h>

#include <continua/base/input_error.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Continua
{
using namespace dealii;

namespace
{
/// A smaller share of the body's mass or inertia is round-off.
constexpr double smallest_share = 1e-6;

double frequency_of(const double lambda)
{
  return std::sqrt(std::max(lambda, 0.)) / (2. * numbers::PI);
}

/// Eigenvectors of a small symmetric matrix as columns, those of the largest values first.
FullMatrix<double> axes_of(const FullMatrix<double> &matrix)
{
  const unsigned int n = matrix.m();
  LAPACKFullMatrix<double> work(n, n);
  work = matrix;
  const double bound = 2. * matrix.frobenius_norm() + 1.;
  Vector<double> values;
  FullMatrix<double> vectors, result(n, n);
  work.compute_eigenvalues_symmetric(-bound, bound, 0., values, vectors);
  for (unsigned int k = 0; k < n; ++k)
    for (unsigned int i = 0; i < n; ++i)
      result(i, k) = vectors(i, n - 1 - k);
  return result;
}

/// Columns from `first` on of a product.
FullMatrix<double> columns_of_product(const FullMatrix<double> &a,
                                      const FullMatrix<double> &b,
                                      const unsigned int first)
{
  FullMatrix<double> product(a.m(), b.n()), result(a.m(), b.n() - first);
  a.mmult(product, b);
  for (unsigned int i = 0; i < result.m(); ++i)
    for (unsigned int k = 0; k < result.n(); ++k)
      result(i, k) = product(i, first + k);
  return result;
}
} // namespace

template <int dim>
ModeSearch<dim>::ModeSearch(VibrationOperator<dim> &vibration,
                            const std::vector<RigidMotion<dim>> &motions,
                            const std::vector<std::vector<double>> &momenta,
                            const MPI_Comm communicator,
                            Log &log)
    : vibration(vibration),
      motions(motions),
      momenta(momenta),
      communicator(communicator),
      log(log),
      directions(vibration.directions())
{
}

template <int dim>
double ModeSearch<dim>::distance(const Eigenpair &pair) const
{
  return std::abs(pair.value - shift);
}

template <int dim>
void ModeSearch<dim>::sort_by_distance(std::vector<Eigenpair> &pairs) const
{
  std::stable_sort(pairs.begin(), pairs.end(),
                   [this](const Eigenpair &a, const Eigenpair &b)
                   { return distance(a) < distance(b); });
}

template <int dim>
std::vector<Eigenpair> ModeSearch<dim>::seek(const unsigned int n_wanted,
                                             const std::vector<Eigenpair> &found)
{
  const unsigned int n = vibration.n_local_unknowns();
  std::vector<Eigenpair> pairs;
  if (vibration.is_symmetric())
    pairs = dominant_eigenpairs(
        [this](const std::vector<double> &x, std::vector<double> &y)
        {
          y = x;
          vibration.solve(y);
        },
        [this](const std::vector<double> &x, std::vector<double> &y)
        { vibration.multiply_mass(x, y); },
        n, n_wanted, communicator, found);
  else
    pairs = dominant_eigenpairs(
        [this](const std::vector<double> &x, std::vector<double> &y)
        {
          vibration.multiply_mass(x, y);
          vibration.solve(y);
        },
        n, n_wanted, communicator);
  for (Eigenpair &pair : pairs)
  {
    // Of two conjugate values the one with positive imaginary part is kept, as before.
    pair.value = shift + 1. / pair.value;
    if (pair.value.imag() < 0.)
    {
      pair.value = std::conj(pair.value);
      for (double &x : pair.imaginary)
        x = -x;
    }
  }
  sort_by_distance(pairs);
  return pairs;
}

template <int dim>
std::size_t ModeSearch<dim>::n_below(const double lambda)
{
  // K has no negative values.
  if (lambda <= 0.)
    return 0;
  vibration.set_shift(lambda);
  return vibration.n_below_shift();
}

template <int dim>
void ModeSearch<dim>::complete(std::vector<Eigenpair> &found, const unsigned int n_wanted)
{
  while (found.size() < n_wanted)
  {
    std::vector<Eigenpair> more = seek(n_wanted - found.size(), found);
    if (more.empty())
      break;
    std::move(more.begin(), more.end(), std::back_inserter(found));
    sort_by_distance(found);
  }
  if (found.empty())
    return;
  const double radius =
      (1. + margin) * distance(found[std::min<std::size_t>(n_wanted, found.size()) - 1]);
  const double lower = shift - radius, upper = shift + radius;
  const std::size_t n_above = n_below(upper), n_counted = n_above - n_below(lower);
  const auto n_inside = [&]()
  {
    return static_cast<std::size_t>(std::count_if(found.begin(), found.end(),
                                                  [&](const Eigenpair &pair)
                                                  { return distance(pair) < radius; }));
  };
  vibration.set_shift(shift);
  std::size_t n_found = n_inside();
  // A mode beyond the interval may converge before one that is missing. Then the next search leaves
  // that mode out, too, and asks for more.
  for (std::size_t n_surplus = 0; n_found < n_counted && n_surplus <= largest_surplus;)
  {
    std::vector<Eigenpair> more = seek(n_counted - n_found + n_surplus, found);
    if (more.empty())
      break;
    std::move(more.begin(), more.end(), std::back_inserter(found));
    sort_by_distance(found);
    const std::size_t n_now = n_inside();
    if (n_now == n_found)
      n_surplus = 2 * n_surplus + 1;
    n_found = n_now;
  }
  std::ostringstream interval;
  interval << "between " << frequency_of(lower) << " and " << frequency_of(upper) << " Hz";
  if (n_found != n_counted)
    throw RunError("the eigenvalue solver found " + std::to_string(n_found) + " modes " +
                   interval.str() + ", but the signs of the pivots count " +
                   std::to_string(n_counted) +
                   ". Ask for one mode more or fewer, or set Modal/Shift to another frequency");
  log.detail("The signs of the pivots count " + std::to_string(n_counted) + " modes " +
             interval.str() + ": all are found");
}

template <int dim>
std::vector<Eigenpair> ModeSearch<dim>::nearest(const double shift_of_vibration,
                                                const unsigned int n_wanted)
{
  shift = shift_of_vibration;
  std::vector<Eigenpair> pairs = seek(n_wanted);
  if (vibration.is_symmetric())
    complete(pairs, n_wanted);

  // Of modes of one frequency, the first shapes in the chosen order.
  std::size_t first = 0;
  while (first < pairs.size())
  {
    std::size_t end = first + 1;
    while (end < pairs.size() && pairs[first].value.imag() == 0. &&
           std::abs(pairs[end].value - pairs[end - 1].value) <= equal_values * distance(pairs[end]))
      ++end;
    if (end - first > 1)
      choose_shapes(pairs, first, end);
    if (first < n_wanted && end > n_wanted)
      log.line("Mode " + std::to_string(n_wanted) + " is one of " + std::to_string(end - first) +
               " of one frequency; Modal/Number of modes = " + std::to_string(end) +
               " shows all of them");
    first = end;
  }
  if (pairs.size() > n_wanted)
    pairs.resize(n_wanted);
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Eigenpair &a, const Eigenpair &b)
                   { return a.value.real() < b.value.real(); });
  return pairs;
}

template <int dim>
void ModeSearch<dim>::choose_shapes(std::vector<Eigenpair> &pairs,
                                    const std::size_t first,
                                    const std::size_t end)
{
  const unsigned int m = end - first, n = vibration.n_local_unknowns();
  // Products of the shapes with each other, by direction, and with the motions.
  std::vector<double> products(dim * m * m + motions.size() * m, 0.);
  const auto energy = [&](const unsigned int d, const unsigned int i,
                          const unsigned int j) -> double &
  { return products[(d * m + i) * m + j]; };
  const auto part = [&](const unsigned int motion, const unsigned int i) -> double &
  { return products[dim * m * m + motion * m + i]; };
  std::vector<double> weighed(n);
  double value = 0., residual = 0.;
  for (unsigned int j = 0; j < m; ++j)
  {
    const Eigenpair &pair = pairs[first + j];
    value += pair.value.real() / m;
    residual += pair.residual * pair.residual;
    vibration.multiply_mass(pair.real, weighed);
    for (unsigned int i = 0; i < m; ++i)
      for (unsigned int k = 0; k < n; ++k)
        energy(directions[k], i, j) += pairs[first + i].real[k] * weighed[k];
    for (unsigned int motion = 0; motion < motions.size(); ++motion)
      for (unsigned int k = 0; k < n; ++k)
        part(motion, j) += pair.real[k] * momenta[motion][k];
  }
  Utilities::MPI::sum(products, communicator, products);

  // An orthonormal basis of the shapes: columns of weights.
  FullMatrix<double> gram(m, m);
  for (unsigned int d = 0; d < dim; ++d)
    for (unsigned int i = 0; i < m; ++i)
      for (unsigned int j = 0; j < m; ++j)
        gram(i, j) += energy(d, i, j);
  FullMatrix<double> remainder = axes_of(gram);
  for (unsigned int k = 0; k < m; ++k)
  {
    double size = 0.;
    for (unsigned int i = 0; i < m; ++i)
      for (unsigned int j = 0; j < m; ++j)
        size += remainder(i, k) * gram(i, j) * remainder(j, k);
    for (unsigned int i = 0; i < m; ++i)
      remainder(i, k) /= std::sqrt(size);
  }

  FullMatrix<double> chosen(m, m);
  unsigned int n_chosen = 0;
  const auto take = [&](const FullMatrix<double> &columns, const unsigned int column)
  {
    for (unsigned int i = 0; i < m; ++i)
      chosen(i, n_chosen) = columns(i, column);
    ++n_chosen;
  };
  for (unsigned int motion = 0; motion < motions.size() && n_chosen < m; ++motion)
  {
    const unsigned int n_left = remainder.n();
    std::vector<double> of_remainder(n_left, 0.);
    double size = 0.;
    for (unsigned int k = 0; k < n_left; ++k)
    {
      for (unsigned int i = 0; i < m; ++i)
        of_remainder[k] += remainder(i, k) * part(motion, i);
      size += of_remainder[k] * of_remainder[k];
    }
    if (size < smallest_share * motions[motion].inertia)
      continue;
    // One shape carries all of it; the others are orthogonal to that one.
    FullMatrix<double> dyad(n_left, n_left);
    for (unsigned int k = 0; k < n_left; ++k)
      for (unsigned int l = 0; l < n_left; ++l)
        dyad(k, l) = of_remainder[k] * of_remainder[l] / size;
    const FullMatrix<double> axes = axes_of(dyad);
    take(columns_of_product(remainder, axes, 0), 0);
    if (n_chosen < m)
      remainder = columns_of_product(remainder, axes, 1);
  }
  if (n_chosen < m)
  {
    const unsigned int n_left = remainder.n();
    FullMatrix<double> difference(n_left, n_left);
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int k = 0; k < n_left; ++k)
        for (unsigned int l = 0; l < n_left; ++l)
          for (unsigned int i = 0; i < m; ++i)
            for (unsigned int j = 0; j < m; ++j)
              difference(k, l) += (dim - d) * remainder(i, k) * energy(d, i, j) * remainder(j, l);
    const FullMatrix<double> axes = columns_of_product(remainder, axes_of(difference), 0);
    for (unsigned int k = 0; k < n_left; ++k)
      take(axes, k);
  }

  std::vector<Eigenpair> mixed(m);
  for (unsigned int k = 0; k < m; ++k)
  {
    Eigenpair &pair = mixed[k];
    pair.value = value;
    // The residual of a combination with unit weights is at most this.
    pair.residual = std::sqrt(residual);
    pair.real.assign(n, 0.);
    pair.imaginary.assign(n, 0.);
    for (unsigned int i = 0; i < m; ++i)
      for (unsigned int l = 0; l < n; ++l)
        pair.real[l] += chosen(i, k) * pairs[first + i].real[l];
  }
  std::move(mixed.begin(), mixed.end(), pairs.begin() + first);
}

template class ModeSearch<2>;
template class ModeSearch<3>;
} // namespace Continua
