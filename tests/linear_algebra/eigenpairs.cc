#include "../unit_test.h"

#include <continua/base/input_error.h>
#include <continua/linear_algebra/eigenpairs.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace test_of_eigenpairs
{
namespace
{
using Continua::LinearMap;

int rank = 0, n_ranks = 1;

/// This rank's entries of a vector of which every rank has all.
unsigned int begin_of(const unsigned int n, const int of_rank)
{
  return n * of_rank / n_ranks;
}

/// A map by a function of the whole vector.
template <typename Function>
LinearMap whole(const unsigned int n, const Function &function)
{
  return [n, function](const std::vector<double> &x, std::vector<double> &y)
  {
    std::vector<double> all(n, 0.);
    const unsigned int begin = begin_of(n, rank);
    std::copy(x.begin(), x.end(), all.begin() + begin);
    MPI_Allreduce(MPI_IN_PLACE, all.data(), static_cast<int>(n), MPI_DOUBLE, MPI_SUM,
                  MPI_COMM_WORLD);
    const std::vector<double> result = function(all);
    std::copy_n(result.begin() + begin, y.size(), y.begin());
  };
}
} // namespace

UNIT_TEST(eigenpairs)
{
  using namespace Continua;
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &n_ranks);
  if (rank > 0)
    std::cout.setstate(std::ios::failbit); // rank 0 alone prints

  // Springs of stiffness 1 from a wall to n equal masses in a row and on to a point without mass,
  // which goes with its neighbour: omega_k = 2 / sqrt(m) sin((2 k - 1) pi / (2 (2 n + 1))).
  const unsigned int n = 40;
  const double mass = 2.;
  // The inverse of the chain's K is min(i, j) + 1: each point stretches the springs before it.
  const auto flexibility = [](const std::vector<double> &force)
  {
    std::vector<double> x(force.size(), 0.);
    for (std::size_t i = 0; i < x.size(); ++i)
      for (std::size_t j = 0; j < x.size(); ++j)
        x[i] += (static_cast<double>(std::min(i, j)) + 1.) * force[j];
    return x;
  };
  const auto weighed = [mass](std::vector<double> x)
  {
    for (double &value : x)
      value *= mass;
    x.back() = 0.;
    return x;
  };
  const unsigned int n_local = begin_of(n + 1, rank + 1) - begin_of(n + 1, rank);
  const std::vector<Eigenpair> chain = dominant_eigenpairs(
      whole(n + 1, flexibility), whole(n + 1, weighed), n_local, 5, MPI_COMM_WORLD);
  check::equal("chain: five values", std::to_string(chain.size()), "5");
  for (unsigned int k = 1; k <= chain.size(); ++k)
  {
    const double omega =
        2. / std::sqrt(mass) * std::sin((2 * k - 1) * dealii::numbers::PI / (2. * (2 * n + 1)));
    check::relative("chain: frequency " + std::to_string(k),
                    std::sqrt(1. / chain[k - 1].value.real()), omega, 1e-10);
    check::absolute("chain: residual " + std::to_string(k), chain[k - 1].residual, 0., 1e-8);
  }
  double products[2] = {0., 0.};
  for (unsigned int i = 0; i < n_local; ++i)
    if (begin_of(n + 1, rank) + i < n)
    {
      products[0] += mass * chain[0].real[i] * chain[1].real[i];
      products[1] += mass * chain[0].real[i] * chain[0].real[i];
    }
  MPI_Allreduce(MPI_IN_PLACE, products, 2, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  check::absolute("chain: orthogonal", products[0] / products[1], 0., 1e-10);

  // Rotations in planes, scaled: values r exp(+-i angle), and one that is real.
  const LinearMap rotations =
      whole(7,
            [](const std::vector<double> &x)
            {
              std::vector<double> y(7);
              for (unsigned int p = 0; p < 3; ++p)
              {
                const double r = 3. - p, angle = 0.5 + p;
                y[2 * p] = r * (std::cos(angle) * x[2 * p] - std::sin(angle) * x[2 * p + 1]);
                y[2 * p + 1] = r * (std::sin(angle) * x[2 * p] + std::cos(angle) * x[2 * p + 1]);
              }
              y[6] = -2.5 * x[6];
              return y;
            });
  const unsigned int n_local_of_seven = begin_of(7, rank + 1) - begin_of(7, rank);
  const std::vector<Eigenpair> turned =
      dominant_eigenpairs(rotations, n_local_of_seven, 3, MPI_COMM_WORLD);
  const std::complex<double> exact[] = {std::polar(3., 0.5), -2.5, std::polar(2., 1.5)};
  check::equal("rotations: three values", std::to_string(turned.size()), "3");
  for (unsigned int k = 0; k < turned.size(); ++k)
  {
    check::absolute("rotations: value " + std::to_string(k + 1),
                    std::abs(turned[k].value - exact[k]), 0., 1e-12);
    check::absolute("rotations: residual " + std::to_string(k + 1), turned[k].residual, 0., 1e-12);
  }

  // Values that occur three and two times: one start vector has a part in one shape of each.
  const std::vector<double> copies = {5., 5., 5., 3., 3., 2., 1., 1., 1., 0.5, 0.25};
  const unsigned int n_copies = copies.size();
  const unsigned int n_local_of_copies = begin_of(n_copies, rank + 1) - begin_of(n_copies, rank);
  const LinearMap diagonal = whole(n_copies,
                                   [&](std::vector<double> x)
                                   {
                                     for (unsigned int i = 0; i < n_copies; ++i)
                                       x[i] *= copies[i];
                                     return x;
                                   });
  const auto n_independent = [&](const std::vector<Eigenpair> &pairs)
  {
    std::vector<std::vector<double>> basis;
    const auto product = [&](const std::vector<double> &a, const std::vector<double> &b)
    {
      double sum = 0.;
      for (std::size_t i = 0; i < a.size(); ++i)
        sum += a[i] * b[i];
      MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
      return sum;
    };
    for (const Eigenpair &pair : pairs)
    {
      std::vector<double> x = pair.real;
      const double before = product(x, x);
      for (const std::vector<double> &q : basis)
      {
        const double part = product(q, x);
        for (std::size_t i = 0; i < x.size(); ++i)
          x[i] -= part * q[i];
      }
      const double after = product(x, x);
      if (after < 1e-8 * before)
        continue;
      for (double &entry : x)
        entry /= std::sqrt(after);
      basis.push_back(x);
    }
    return basis.size();
  };
  const auto check_copies = [&](const std::string &name, const std::vector<Eigenpair> &pairs)
  {
    check::equal(name + ": shapes", std::to_string(n_independent(pairs)),
                 std::to_string(pairs.size()));
    for (unsigned int k = 0; k < pairs.size(); ++k)
      check::absolute(name + ": value " + std::to_string(k + 1),
                      std::abs(pairs[k].value - copies[k]), 0., 1e-10);
  };
  for (const unsigned int n_wanted : {2u, 3u, 4u, 5u, 9u, 11u})
  {
    const std::vector<Eigenpair> found =
        dominant_eigenpairs(diagonal, n_local_of_copies, n_wanted, MPI_COMM_WORLD);
    check::equal("copies: " + std::to_string(n_wanted) + " values", std::to_string(found.size()),
                 std::to_string(n_wanted));
    check_copies("copies: " + std::to_string(n_wanted), found);
  }
  // The symmetric ones go on where they are told to.
  const LinearMap identity = whole(n_copies, [](const std::vector<double> &x) { return x; });
  std::vector<Eigenpair> found;
  while (found.size() < n_copies)
  {
    const std::vector<Eigenpair> next =
        dominant_eigenpairs(diagonal, identity, n_local_of_copies, 1, MPI_COMM_WORLD, found);
    if (next.empty())
      break;
    found.insert(found.end(), next.begin(), next.end());
    std::stable_sort(found.begin(), found.end(),
                     [](const Eigenpair &a, const Eigenpair &b)
                     { return a.value.real() > b.value.real() + 1e-8; });
  }
  check::equal("copies, one after the other", std::to_string(found.size()),
               std::to_string(n_copies));
  check_copies("copies, one after the other", found);

  // Two values that are not zero.
  const std::vector<Eigenpair> few =
      dominant_eigenpairs(whole(7, [](const std::vector<double> &x)
                                { return std::vector<double>{0, 4 * x[1], 0, 0, 3 * x[4], 0, 0}; }),
                          n_local_of_seven, 5, MPI_COMM_WORLD);
  check::equal("no more than there are", std::to_string(few.size()), "2");

  check::throws<RunError>(
      "what the map throws",
      [&]()
      {
        dominant_eigenpairs([](const std::vector<double> &, std::vector<double> &)
                            { throw RunError("out of order"); },
                            n_local_of_seven, 1, MPI_COMM_WORLD);
      },
      "out of order");
}
} // namespace test_of_eigenpairs
