#ifndef continua_finite_volume_face_links_h
#define continua_finite_volume_face_links_h

#include <continua/finite_volume/split_equations.h>

#include <array>
#include <vector>

namespace Continua
{
/**
 * How the faces with their own velocity hang on the cells beside them in the compact part of the
 * momentum equations: by a link of stiffness c alpha area / distance to either cell. With the face
 * eliminated, its two links become one between the cells, or vanish where the face is free; what
 * its own equation still lacks then acts on the cells (on a free boundary: they feel exactly the
 * given traction, equations 3.65 to 3.70 as gradients).
 */
template <int dim>
class FaceLinks
{
public:
  using Vector = typename SplitEquations<dim>::Vector;

  struct Link
  {
    unsigned int face = 0;     ///< of the mesh
    unsigned int velocity = 0; ///< its place in the vector
    bool is_owned = false;     ///< whether its equation is this rank's
    unsigned int n_sides = 1;
    std::array<unsigned int, 2> cells = {{0, 0}}; ///< velocities' places
    std::array<bool, 2> cell_is_owned = {{false, false}};
    std::array<double, 2> stiffness = {{0., 0.}}; ///< of the links [Pa s m^(dim-2)]
    std::array<double, 2> share = {{1., 0.}};     ///< of each in their sum
    double compliance = 0.;                       ///< one over their sum
    double weight_ratio = 1.;                     ///< area over the weight of its equations
    dealii::Tensor<2, dim> free;                  ///< projector on the directions not prescribed
    /// What a component that is not eliminated holds its cell with: its link's stiffness, or, on a
    /// wall whose pressure follows from the velocity, what that adds to the normal one.
    std::array<double, dim> hold = {};
    std::array<bool, dim> follows = {}; ///< components that are eliminated
  };

  FaceLinks(const CellWiseSystem<dim> &system, const SplitEquations<dim> &equations);

  /// `by_value`: boundary faces keep their last value (3.69) and none is eliminated.
  void reinit(bool by_value);
  const std::vector<Link> &links() const { return all; }

  /// Adds what the faces' equations lack to the cells' residuals; all ghosts up to date.
  void add_to_cells(Vector &residual) const;
  /// Moves the faces with the cells' change and, with `residual`, by what they lack over their
  /// links' stiffness; the change's ghosts up to date.
  void follow(const Vector &change, const Vector *residual, Vector &unknowns) const;
  /// Sets the prescribed directions to what their equations say, by those equations' residual.
  void set_prescribed(const Vector &residual, Vector &unknowns) const;

private:
  const CellWiseSystem<dim> &system;
  const SplitEquations<dim> &equations;
  std::vector<Link> all;
  std::vector<double> scales; ///< of prescribed directions' equations, 0 where there are none

  void set_hold(Link &link) const;
};
} // namespace Continua

#endif
