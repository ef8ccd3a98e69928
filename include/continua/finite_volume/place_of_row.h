#ifndef continua_finite_volume_place_of_row_h
#define continua_finite_volume_place_of_row_h

#include <continua/finite_volume/cell_wise_space.h>

#include <string>
#include <vector>

namespace Continua
{
/// Where the largest entry of a velocity or a pressure is, or the first one that is no number, for
/// a message: "in the region 'liquid' near (0.1, 0.2) m". Collective.
template <int dim>
std::string place_of_largest_row(const CellWiseSpace<dim> &space,
                                 const DistributedVector &rows,
                                 bool of_velocity,
                                 const std::vector<std::string> &regions);
} // namespace Continua

#endif
