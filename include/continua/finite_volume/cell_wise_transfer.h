#ifndef continua_finite_volume_cell_wise_transfer_h
#define continua_finite_volume_cell_wise_transfer_h

#include <continua/finite_volume/face_conditions.h>
#include <continua/finite_volume/linear_reconstruction.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

namespace Continua
{
/**
 * Carries vectors of velocities and pressures over a change of the mesh (distributed
 * triangulations). A cell that is divided gives its parts its value plus its gradient times the
 * distance of the centres, exact for linear functions; one that is put together has the mean over
 * the volumes of its parts, so that nothing is lost. The values of faces are carried over as those
 * of cells are, along the face, between a liquid and a solid with the gradient of the solid; where
 * a velocity of zero is prescribed the parts of a face have its value, so that what a boundary
 * holds stays held.
 */
template <int dim>
class CellWiseTransfer
{
public:
  CellWiseTransfer(const CellWiseSpace<dim> &space,
                   const FaceConditions<dim> &face_conditions,
                   const std::vector<BoundaryCondition> &conditions,
                   const LinearReconstruction<dim> &reconstruction)
      : space(space),
        face_conditions(face_conditions),
        conditions(conditions),
        reconstruction(reconstruction)
  {
  }

  /// Call when cells are flagged and before the triangulation changes.
  void prepare(const std::vector<DistributedVector *> &velocities,
               const std::vector<DistributedVector *> &pressures);
  /// Call when the space and the conditions are those of the new mesh; fills the vectors (of the
  /// new size) in the same order.
  void finish(const std::vector<DistributedVector *> &velocities,
              const std::vector<DistributedVector *> &pressures);

private:
  static constexpr unsigned int n_faces = 2 * dim;
  using CellIterator = typename dealii::Triangulation<dim>::cell_iterator;

  /// One component of a vector in one cell.
  struct Component
  {
    double value = 0.;
    dealii::Tensor<1, dim> gradient;
    std::array<double, n_faces> on_faces{}; ///< values of faces that have one of their own
    /// The gradients along these faces: of the cell, or of the solid beside it.
    std::array<dealii::Tensor<1, dim>, n_faces> face_gradients;
  };
  /// What is known of one cell, or of one that is put together of several.
  struct CellData
  {
    dealii::Point<dim> centre;
    std::array<double, n_faces> face_areas{}; ///< of its faces with their own value; else 0 [m^2]
    std::array<dealii::Point<dim>, n_faces> face_centres;
    std::vector<Component> components; ///< of the velocities, then of the pressures
  };

  CellData data_of(unsigned int cell) const;
  CellData mean_over(const CellIterator &parent) const;
  std::vector<char> pack(const CellData &data) const;
  CellData unpack(const std::vector<double> &values) const;
  /// The part of a change along a boundary face in directions that are not held there.
  dealii::Tensor<1, dim> free_part(unsigned int face, const dealii::Tensor<1, dim> &change) const;
  /// Fills the new vectors in a cell and on its faces; `divided`: the data are its parent's.
  void set(unsigned int cell,
           const CellData &data,
           bool divided,
           const std::vector<DistributedVector *> &velocities,
           const std::vector<DistributedVector *> &pressures) const;

  const CellWiseSpace<dim> &space;
  const FaceConditions<dim> &face_conditions;
  const std::vector<BoundaryCondition> &conditions;
  const LinearReconstruction<dim> &reconstruction;
  std::vector<DistributedVector> old_velocities, old_pressures; ///< with ghosts
  unsigned int handle = 0;                                      ///< of the data at the mesh
};
} // namespace Continua

#endif
