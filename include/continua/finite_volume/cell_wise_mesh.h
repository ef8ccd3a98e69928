#ifndef continua_finite_volume_cell_wise_mesh_h
#define continua_finite_volume_cell_wise_mesh_h

#include <deal.II/base/numbers.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/distributed/tria_base.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_dgq.h>

#include <array>
#include <vector>

namespace Continua
{
/// One cell as finite volumes see it. Areas and volumes are those of the body: in axisymmetry of
/// the whole circumference, in a plane model per unit of depth.
template <int dim>
struct FiniteVolume
{
  typename dealii::DoFHandler<dim>::active_cell_iterator iterator;
  unsigned int number = 0;   ///< global, by which ranks agree on a face's owner
  dealii::Point<dim> centre; ///< centroid of the cell in its plane [m]
  double volume = 0.;        ///< [m^3], in a plane model [m^2]
  double plane_volume = 0.;  ///< without the factor 2 pi r of axisymmetry [m^2]; else = volume
  double radius = 0.;        ///< of the centre, in axisymmetry [m]; else 0
  unsigned int material_id = 0;
  bool is_owned = false;
  std::vector<unsigned int>
      faces; ///< their numbers; of a ghost only those it shares with owned cells
};

/// Place and size of a face.
template <int dim>
struct FaceShape
{
  dealii::Point<dim> centre;     ///< [m]
  dealii::Tensor<1, dim> normal; ///< of unit length, out of the owner
  double area = 0.;              ///< [m^2], in a plane model [m]; 0 on the axis
  double plane_area = 0.;        ///< without the factor 2 pi r of axisymmetry [m]; else = area
};

/// One flat piece of surface between two cells or on the boundary; a face with hanging nodes is as
/// many of them as it has finer cells on its other side. On a mesh that moves its shape is that of
/// the liquids.
template <int dim>
struct VolumeFace : FaceShape<dim>
{
  static constexpr unsigned int none = dealii::numbers::invalid_unsigned_int;

  /// Local numbers; the owner is the cell with the smaller global number, on every rank. On the
  /// boundary there is no neighbour.
  unsigned int owner = none, neighbour = none;
  unsigned int boundary_id = none; ///< of boundary faces
  /// Which face of the cell on either side it is, or is a piece of.
  std::array<unsigned int, 2> number_in_cell{{none, none}};
  bool is_interface = false; ///< between two materials
  /// Of the triangulation, around the face, from one of its corners on.
  std::vector<unsigned int> vertices;
  /// The side of a cell that stays where the mesh of the other one moves, or none; the shape that
  /// it sees.
  unsigned int undeformed_side = none;
  FaceShape<dim> undeformed_shape;
  /// From the owner's centre to the neighbour's, on the boundary to the face's centre [m].
  dealii::Tensor<1, dim> distance;
  /// Of the owner's value in linear interpolation to where that line meets the plane of the face
  /// (equation 3.2); 0 on the boundary, where the face has its own value.
  double owner_weight = 0.;

  bool at_boundary() const { return neighbour == none; }
  /// Whether the face has a value of its own: on the boundary and between two materials.
  bool has_value() const { return at_boundary() || is_interface; }
  /// The cell on one side, 0 the owner's and 1 the neighbour's.
  unsigned int cell(const unsigned int side) const { return side == 0 ? owner : neighbour; }
  /// As the cell on that side sees it.
  const FaceShape<dim> &shape(const unsigned int side) const
  {
    return side == undeformed_side ? undeformed_shape : *this;
  }
  /// Out of the cell on that side.
  dealii::Tensor<1, dim> outward(const unsigned int side) const
  {
    return side == 0 ? shape(0).normal : -1. * shape(1).normal;
  }
  unsigned int n_sides() const { return at_boundary() ? 1 : 2; }
};

/// By the number of the triangulation [m].
template <int dim>
using VertexPlaces = std::vector<dealii::Point<dim>>;

/// A flat piece of surface between vertices: its centre, area times normal, and the simplices
/// (lines or triangles) that it consists of; of a warped face that of its triangles.
template <int dim>
struct SurfacePiece
{
  dealii::Point<dim> centre;
  dealii::Tensor<1, dim> area;
  std::vector<std::array<dealii::Point<dim>, dim>> simplices;
};
/// The piece between the vertices of a face, in the plane or in space.
SurfacePiece<2> surface_piece(const std::vector<unsigned int> &vertices,
                              const VertexPlaces<2> &places);
SurfacePiece<3> surface_piece(const std::vector<unsigned int> &vertices,
                              const VertexPlaces<3> &places);

/**
 * The active cells of a triangulation and the faces between them, measured once, or, where the mesh
 * of some cells moves, at each of their places. The cells of this rank come first, then the ghosts;
 * faces are those of this rank's cells, so that a face between two ranks is on both. Cells have
 * straight edges (their vertices are on curved boundaries).
 */
template <int dim>
class CellWiseMesh
{
public:
  CellWiseMesh(dealii::parallel::TriangulationBase<dim> &triangulation, bool axisymmetric);

  /// Finds the cells and faces of the present triangulation, and measures them.
  void build();
  /// Measures them anew with the vertices of the cells of these materials at `places`; the others
  /// have those of the triangulation. Collective.
  void move(const VertexPlaces<dim> &places, const std::vector<bool> &materials_that_move);

  const std::vector<FiniteVolume<dim>> &cells() const { return volumes; }
  const std::vector<VolumeFace<dim>> &faces() const { return surfaces; }
  unsigned int n_owned_cells() const { return n_owned; }
  bool is_axisymmetric() const { return axisymmetric; }
  /// Where a point of a cell is [m], from its undeformed place and its coordinates in the cell.
  dealii::Point<dim> present_place(unsigned int cell,
                                   const dealii::Point<dim> &unit_point,
                                   const dealii::Point<dim> &undeformed) const;
  /// The local number of an active cell that is owned or a ghost.
  unsigned int cell_number(const typename dealii::Triangulation<dim>::cell_iterator &cell) const;
  /// Which side of a face a cell is on.
  unsigned int side(const unsigned int face, const unsigned int cell) const
  {
    return surfaces[face].owner == cell ? 0 : 1;
  }
  /// From the centre of the cell on a side to the place of the value beyond the face: the face's
  /// centre if it has a value of its own, else the other cell's [m].
  dealii::Tensor<1, dim> distance(unsigned int face, unsigned int side) const;
  MPI_Comm communicator() const { return triangulation.get_communicator(); }

  dealii::parallel::TriangulationBase<dim> &triangulation;
  dealii::FE_DGQ<dim> element;       ///< of degree 0
  dealii::DoFHandler<dim> cell_dofs; ///< its numbers are the cells' global ones

private:
  bool axisymmetric;
  unsigned int n_owned = 0;
  std::vector<FiniteVolume<dim>> volumes;
  std::vector<VolumeFace<dim>> surfaces;
  std::vector<unsigned int> local_numbers; ///< by active cell index
  VertexPlaces<dim> present_places;        ///< of the cells that move
  std::vector<bool> moving_materials;      ///< empty where nothing moves

  bool moves(const unsigned int cell) const
  {
    return !moving_materials.empty() && moving_materials[volumes[cell].material_id];
  }

  void number_cells();
  /// Makes the faces of owned cells.
  void make_faces();
  /// Makes the face between a cell and another (or the boundary, VolumeFace::none), unless the
  /// other cell has made it. `f`: which face of the cell it is part of.
  void add_face(unsigned int cell,
                unsigned int other,
                const typename dealii::Triangulation<dim>::face_iterator &on,
                unsigned int f);
  /// Measures cells and faces.
  void measure();
  /// Sets the shape of a face, and adds its parts of the volumes of the cells on these sides and of
  /// their first moments about `inside` to `moments`.
  void measure_face(const VolumeFace<dim> &face,
                    const VertexPlaces<dim> &places,
                    const std::vector<unsigned int> &sides,
                    const std::vector<dealii::Point<dim>> &inside,
                    FaceShape<dim> &shape,
                    std::vector<dealii::Tensor<1, dim>> &moments);
  /// A ghost's measures are taken from its rank, which alone sees all its faces.
  void exchange_measures();
};
} // namespace Continua

#endif
