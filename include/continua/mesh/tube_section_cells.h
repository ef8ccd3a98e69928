#ifndef continua_mesh_tube_section_cells_h
#define continua_mesh_tube_section_cells_h

#include <continua/mesh/layered_stack.h>

namespace Continua
{
/// The cells of a tube's cross-section: in two dimensions along the radius, in three those of
/// TubeCrossSection.
struct TubeSectionCells
{
  unsigned int radial_cells = 6; ///< of the fluid; in three dimensions its rings
  /// Of those, outermost over innermost; 0: the outermost is R / `cells_at_wall` thick.
  double radial_grading = 0.;
  std::vector<unsigned int> wall_cells = {1}; ///< of each layer, or one number for all
  unsigned int circumferential_cells = 6;     ///< of a quarter, in three dimensions; even

  /// How often the fluid's outermost cell fits into the radius by default. The Stokes layer
  /// sqrt(2 nu/omega) = sqrt(2) R / (Womersley number) is thicker up to a Womersley number of 181.
  static constexpr double cells_at_wall = 128.;
  /// By how much neighbouring cells across the fluid differ at most by default.
  static constexpr double largest_growth = 2.5;

  /// Declares and reads the entries of the section Mesh for a model of that dimension. Throws
  /// InputError.
  void read(ParameterSection mesh, std::size_t n_layers, unsigned int dimension);
  /// The cells along the scaled radius: the fluid from 0 to 1, the wall from 1 to 2.
  LayeredStack stack(const std::vector<double> &layer_fractions, unsigned int dimension) const;
  /// In three dimensions, of one quarter of the section.
  double n_cells_of_quarter(std::size_t n_layers) const;
};
} // namespace Continua

#endif
