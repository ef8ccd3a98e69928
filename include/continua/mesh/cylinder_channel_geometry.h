#ifndef continua_mesh_cylinder_channel_geometry_h
#define continua_mesh_cylinder_channel_geometry_h

#include <continua/mesh/cylinder_sector.h>
#include <continua/mesh/geometry.h>

#include <vector>

namespace Continua
{
/**
 * `channel with cylinder`: a channel along x from 0, between y = 0 and y = height, around a rigid
 * cylinder, which is a hole, and behind the cylinder an elastic beam along x; in three dimensions
 * extruded along z from 0. The channel is that of M. Schaefer and S. Turek, Benchmark computations
 * of laminar flow around a cylinder (1996), and with the beam that of S. Turek and J. Hron,
 * Proposal for numerical benchmarking of fluid-structure interaction (2006).
 *
 * The length of the beam is counted from the cylinder's rearmost point, x = cylinder x + radius, to
 * the tip; on its centre line it is attached there, and its root is the arc of the circle between
 * its two sides, so that the sides are a little longer.
 *
 * Regions `fluid` and, if the beam's length is more than 0, `beam`. Boundaries `inlet`, `outlet`,
 * `bottom`, `top`, `cylinder` (where it touches fluid), with a beam `beam root` (where it holds the
 * beam), and in three dimensions `back`, `front`.
 *
 * The cells fill a square around the cylinder with straight lines from the circle outwards; around
 * the square and behind it they are rectangles. Inside the square the mesh is its own mirror image
 * about the beam's centre line.
 */
template <int dim>
class CylinderChannelGeometry : public Geometry<dim>
{
public:
  struct Parameters
  {
    double length = 2.5;           ///< of the channel [m]
    double height = 0.41;          ///< of the channel [m]
    double width = 0.41;           ///< in three dimensions [m]
    double cylinder_x = 0.2;       ///< [m]
    double cylinder_y = 0.2;       ///< [m]
    double cylinder_radius = 0.05; ///< [m]
    double beam_length = 0.35;     ///< from the cylinder's rearmost point [m]; 0: no beam
    double beam_thickness = 0.02;  ///< [m]

    unsigned int circumferential_cells = 8; ///< along a quarter of the cylinder, even
    unsigned int radial_cells = 6;          ///< from the cylinder to the square around it
    unsigned int upstream_cells = 4;        ///< from the inlet to the square
    unsigned int transverse_cells = 3;      ///< from the square to the bottom, and to the top
    unsigned int axial_cells = 20;          ///< behind the beam or the square, to the outlet
    unsigned int beam_cells = 2;            ///< across the beam
    unsigned int beam_axial_cells = 15;     ///< along the beam, from the square to the tip
    unsigned int width_cells = 8;           ///< in three dimensions
    double cylinder_grading = 0.25;         ///< cell at the cylinder over that at the square
    double wall_grading = 1.;  ///< cell at the bottom and the top over that at the square
    double beam_grading = 0.4; ///< fluid's cell at the beam over that farthest from it
    double tip_grading = 0.5;  ///< along the beam, cell at the tip over that at the square

    bool has_beam() const { return beam_length > 0.; }

    /// Throws InputError.
    static Parameters read(ParameterSection geometry, ParameterSection mesh);
  };

  explicit CylinderChannelGeometry(const Parameters &parameters);

  std::vector<std::string> regions() const override;
  std::vector<std::string> boundaries() const override;
  void create(dealii::Triangulation<dim> &triangulation) const override;
  MeshExtent extent() const override;
  std::unique_ptr<Geometry<dim>> coarsened(double most_cells) const override;

private:
  /// A sector of the square with the places v of its lines.
  struct Lines
  {
    CylinderSector sector;
    std::vector<double> places;
  };
  struct Section;

  double half_side() const; ///< of the square around the cylinder [m]
  /// The fluid's cells on each side of the beam in the quarter behind the cylinder.
  unsigned int cells_beside_beam() const { return parameters.circumferential_cells / 2; }
  std::vector<Lines> lines() const; ///< counter-clockwise, from the lowest on the square's right
  Section section() const;          ///< the mesh of the plane

  const Parameters parameters;
};
} // namespace Continua

#endif
