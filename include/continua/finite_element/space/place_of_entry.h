#ifndef continua_finite_element_space_place_of_entry_h
#define continua_finite_element_space_place_of_entry_h

#include <continua/finite_element/space/space.h>

#include <string>
#include <vector>

namespace Continua
{
/// Where the node of the largest entry of an owned vector is, or of the first entry that is no
/// number: "in the region 'liquid' near (0.1, 0.2) m". `regions`: their names. Collective.
template <int dim>
std::string place_of_largest_entry(const Space<dim> &space,
                                   const dealii::DoFHandler<dim> &dofs,
                                   const DistributedVector &entries,
                                   const std::vector<std::string> &regions);
} // namespace Continua

#endif
