#ifndef continua_mesh_plane_section_h
#define continua_mesh_plane_section_h

#include <continua/mesh/vessel_axis.h>

#include <deal.II/base/point.h>
#include <deal.II/base/quadrature.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/tria.h>

#include <set>
#include <vector>

namespace Continua
{
/**
 * The section of a body by a plane, as quadrature points in the cells that the plane cuts. In the
 * unit cell the plane is the zero of a polynomial, (x(xi) - point).normal, so that curved cells are
 * cut where they are and not where their corners say. Saye's recursion (SIAM J. Sci. Comput. 37,
 * 2015, doi 10.1137/140966290; in deal.II) puts Gauss points onto that zero.
 *
 * A plane through faces of cells would belong to the cells on either side, or by round-off to none.
 * It is therefore moved by 1e-9 of the body's extent against its normal (where that leaves the
 * body, along its normal): sections are limits from that side, and cells share no part of them.
 *
 * A plane across a vessel that bends or divides may cut it elsewhere, too. With the vessel's axis
 * the section is that of the cells alone which the axis leads through the plane's point.
 */
template <int dim>
class PlaneSection
{
public:
  enum class Cells
  {
    coarse,       ///< the coarse mesh, which every rank has: no communication
    first_coarse, ///< of these the first one that is cut, and no other
    active        ///< the present mesh, each rank its own cells; collective
  };
  /// The points in one cell.
  struct Part
  {
    typename dealii::Triangulation<dim>::cell_iterator cell;
    /// In the coordinates of the unit cell, and their shares of the section: areas [m^2], in two
    /// dimensions lengths [m]. On a rim lengths [m], in two dimensions 1.
    dealii::Quadrature<dim> quadrature;
    std::vector<dealii::Point<dim>> points; ///< the same in the body [m]
    /// On a rim: in the plane, away from the section, of length 1.
    std::vector<dealii::Tensor<1, dim>> normals;
  };

  /// The section of the regions (material ids; empty: of all) by the plane through `point` with
  /// that `normal`, which need not have length 1; `n_points` Gauss points a direction. `axis`: null
  /// for the whole section.
  PlaneSection(const dealii::MappingQ<dim> &mapping,
               const dealii::Triangulation<dim> &triangulation,
               Cells cells,
               const std::set<unsigned int> &regions,
               const dealii::Point<dim> &point,
               const dealii::Tensor<1, dim> &normal,
               unsigned int n_points,
               const VesselAxis<dim> *axis = nullptr);
  /// Whether such a section of the coarse mesh has an area. The first cell that is cut tells.
  static bool exists(const dealii::MappingQ<dim> &mapping,
                     const dealii::Triangulation<dim> &triangulation,
                     const std::set<unsigned int> &regions,
                     const dealii::Point<dim> &point,
                     const dealii::Tensor<1, dim> &normal,
                     const VesselAxis<dim> *axis = nullptr);

  /// On this rank's cells.
  const std::vector<Part> &parts() const { return section_parts; }
  /// Of the whole section [m^2, in two dimensions m]; 0 where the plane misses the regions.
  double area() const { return total_area; }
  /// The rim of the section that faces away from the plane's point (within 60 degrees), towards
  /// another region or the outside: of a tube's fluid, around its axis, the inner side of the wall,
  /// and neither the axis nor planes of symmetry.
  std::vector<Part> outer_rim() const;

private:
  using CellIterator = typename dealii::Triangulation<dim>::cell_iterator;
  class CellPlane;
  bool counts(const CellIterator &cell) const;
  /// Whether the vessel's axis leads through the cell at the plane's point.
  bool is_on_axis(const CellIterator &cell) const;
  /// Fills the parts for the plane as it stands; returns their area.
  double cut();

  const dealii::MappingQ<dim> &mapping;
  const dealii::Triangulation<dim> &triangulation;
  const Cells cells;
  const std::set<unsigned int> regions;
  dealii::Point<dim> point;
  const dealii::Tensor<1, dim> normal;
  const unsigned int n_points;
  const VesselAxis<dim> *const axis;
  double position = 0.; ///< of the plane's point along the axis [m]
  std::vector<Part> section_parts;
  double total_area = 0.;
};
} // namespace Continua

#endif
