#ifndef continua_analysis_mode_search_h
#define continua_analysis_mode_search_h

#include <continua/analysis/rigid_motions.h>
#include <continua/base/log.h>
#include <continua/continuum/vibration_operator.h>
#include <continua/linear_algebra/eigenpairs.h>

#include <mpi.h>

#include <cstddef>
#include <vector>

namespace Continua
{
/**
 * The modes nearest to a shift, none of them left out.
 *
 * A Krylov method begins with one vector, in which only one shape of a multiple frequency has a
 * part; the others come from round-off, or not at all. Where the matrices are symmetric the search
 * therefore counts the modes of an interval about the shift by the signs of the pivots of K - a M
 * at its ends a (Sylvester's law of inertia; R. G. Grimes, J. G. Lewis, H. D. Simon, SIAM J. Matrix
 * Anal. Appl. 15 (1994)), and goes on among the shapes that are orthogonal to those found until it
 * has as many. Elsewhere dominant_eigenpairs() makes sure that none is left.
 *
 * Shapes of one frequency may be mixed at will. The search chooses those that carry all of the mass
 * that they have in common along x, then y, then z, then those that carry the inertia about the
 * axes, then those whose energies along the axes differ most: so the shapes depend neither on the
 * ranks nor on round-off, unless symmetry leaves several that none of this tells apart.
 */
template <int dim>
class ModeSearch
{
public:
  /// Beyond the last mode the interval goes on by so much of its distance from the shift; modes
  /// that are so near to the last one are sought, too.
  static constexpr double margin = 1e-4;
  /// Modes whose lambda differ by less, relative to the distance from the shift, have one
  /// frequency.
  static constexpr double equal_values = 1e-9;
  /// The search gives up where it finds none that is missing among so many modes more than are
  /// missing.
  static constexpr std::size_t largest_surplus = 31;

  ModeSearch(VibrationOperator<dim> &vibration,
             const std::vector<RigidMotion<dim>> &motions,
             const std::vector<std::vector<double>> &momenta,
             MPI_Comm communicator,
             Log &log);

  /// `shift` [1/s^2]: the vibration's, which is set. The values of the pairs are lambda [1/s^2] in
  /// rising order. There are fewer than `n_wanted` if the body has no more. Throws RunError if the
  /// count and the modes disagree.
  std::vector<Eigenpair> nearest(double shift, unsigned int n_wanted);

private:
  VibrationOperator<dim> &vibration;
  const std::vector<RigidMotion<dim>> &motions;
  const std::vector<std::vector<double>> &momenta; ///< M r of the motions
  const MPI_Comm communicator;
  Log &log;
  const std::vector<unsigned int> directions;
  double shift = 0.;

  /// By the Krylov method, the nearest first, with their lambda.
  std::vector<Eigenpair> seek(unsigned int n_wanted, const std::vector<Eigenpair> &found = {});
  /// Adds to the modes found until none that is nearer than the n_wanted-th is missing.
  void complete(std::vector<Eigenpair> &found, unsigned int n_wanted);
  std::size_t n_below(double lambda);
  void sort_by_distance(std::vector<Eigenpair> &pairs) const;
  double distance(const Eigenpair &pair) const;
  /// Chooses the shapes of the modes from `first` up to `end`, which have one frequency.
  void choose_shapes(std::vector<Eigenpair> &pairs, std::size_t first, std::size_t end);
};
} // namespace Continua

#endif
