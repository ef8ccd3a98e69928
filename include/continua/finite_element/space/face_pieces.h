#ifndef continua_finite_element_space_face_pieces_h
#define continua_finite_element_space_face_pieces_h

namespace Continua
{
/**
 * The sum of `jump(of here, of there)` over the pieces of an interior face of an active cell that
 * its neighbour, or the finer ones of them, share with it. `here` and `there` compute something on
 * a face of a cell, face(cell, f), or on a piece of it, subface(cell, f, piece), at points that
 * both sides have in common.
 */
template <typename Cell, typename Side, typename Jump>
double
sum_over_pieces(const Cell &cell, const unsigned int f, Side &here, Side &there, const Jump &jump)
{
  if (cell->face(f)->has_children())
  {
    double sum = 0.;
    for (unsigned int s = 0; s < cell->face(f)->n_active_descendants(); ++s)
      sum += jump(here.subface(cell, f, s),
                  there.face(cell->neighbor_child_on_subface(f, s), cell->neighbor_of_neighbor(f)));
    return sum;
  }
  if (cell->neighbor_is_coarser(f))
  {
    const auto place = cell->neighbor_of_coarser_neighbor(f);
    return jump(here.face(cell, f), there.subface(cell->neighbor(f), place.first, place.second));
  }
  return jump(here.face(cell, f), there.face(cell->neighbor(f), cell->neighbor_of_neighbor(f)));
}
} // namespace Continua

#endif
