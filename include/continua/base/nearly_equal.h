#ifndef continua_base_nearly_equal_h
#define continua_base_nearly_equal_h

#include <vector>

namespace Continua
{
/// Whether they differ by at most 1e-12 of the first one.
bool nearly_equal(double a, double b);
/// Whether the vectors have the same size and each pair of entries differs by at most 1e-12 of the
/// first of the two.
bool nearly_equal(const std::vector<double> &a, const std::vector<double> &b);
} // namespace Continua

#endif
