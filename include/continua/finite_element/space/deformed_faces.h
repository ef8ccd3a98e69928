#ifndef continua_finite_element_space_deformed_faces_h
#define continua_finite_element_space_deformed_faces_h

#include <continua/continuum/problem.h>
#include <continua/finite_element/space/deformed_face_point.h>
#include <continua/finite_element/space/space.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/base/types.h>
#include <deal.II/lac/vector.h>

#include <functional>
#include <vector>

namespace Continua
{
/// Faces of cells, such as those of some boundary conditions, with their places under a
/// displacement of the mesh.
template <int dim>
class DeformedFaces
{
public:
  struct Face
  {
    unsigned int number;                                  ///< of its set, see below
    std::vector<dealii::types::global_dof_index> indices; ///< of the cell, component by component
    std::vector<DeformedFacePoint<dim>> points;
  };

  using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;
  /// The number of the set to which a face of a cell belongs, or -1.
  using SetOfFace = std::function<int(const Cell &cell, unsigned int face)>;

  /// One set for each of the conditions, which are given by their numbers in the problem. Both must
  /// outlive it.
  DeformedFaces(const Space<dim> &space,
                const Problem &problem,
                const std::vector<unsigned int> &conditions);
  DeformedFaces(const Space<dim> &space, const SetOfFace &set_of_face);

  /// The mesh has changed.
  void reinit();
  /// Takes a displacement [m]. Collective.
  void take(const DistributedVector &displacement);
  /// This rank's faces, in an order that does not depend on the ranks.
  const std::vector<Face> &all() const { return faces; }
  /// That displacement, of the cell of a face [m].
  const dealii::Vector<double> &displacement_of(const Face &face);
  /// Sets int v . n da over the faces of a set at that displacement, with the hanging nodes
  /// condensed [m^2]. Collective.
  void set_flow(unsigned int number, DistributedVector &flow);

private:
  const Space<dim> &space;
  const SetOfFace set_of_face;                  ///< empty: there are none
  const dealii::Quadrature<dim - 1> quadrature; ///< as that of TermFaces
  std::vector<Face> faces;
  DistributedVector ghosted;
  dealii::Vector<double> of_cell;
};
} // namespace Continua

#endif
