#ifndef continua_finite_element_terms_term_list_h
#define continua_finite_element_terms_term_list_h

#include <continua/continuum/nonlinear_terms.h>

#include <array>
#include <cstddef>
#include <vector>

namespace Continua
{
/**
 * The terms of one model of a region, inside its cells or on their faces, as a list of types
 * without members. A term has
 *
 *   power                                the kind of NonlinearPowers that it belongs to
 *   add(point, tested)                   what it gives at a point
 *   add_derivative(point, change, tested)  the derivative of that in the direction of a change
 *
 * Those inside the cells are templates in the number, so that one text serves the
 * residual, the matrix of a cell and products without a matrix. A term that is no force, such as
 * the row of volume, has `power` null.
 */
template <typename... Terms>
struct TermList
{
  static constexpr std::size_t size = sizeof...(Terms);

  template <typename Point, typename Tested>
  static void add(const Point &point, Tested &tested)
  {
    (Terms::add(point, tested), ...);
  }
  template <typename Point, typename Change, typename Tested>
  static void add_derivative(const Point &point, const Change &change, Tested &tested)
  {
    (Terms::add_derivative(point, change, tested), ...);
  }
  /// The kind of each.
  static std::array<PowerKind, size> kinds() { return {{Terms::power...}}; }
  /// Calls visit(Term()) for each.
  template <typename Visit>
  static void for_each(const Visit &visit)
  {
    (visit(Terms()), ...);
  }
};
/// The kinds of the terms of several lists, one list after the other.
template <typename... Lists>
std::vector<PowerKind> kinds_of()
{
  std::vector<PowerKind> all;
  const auto append = [&all](const auto &of_list)
  { all.insert(all.end(), of_list.begin(), of_list.end()); };
  (append(Lists::kinds()), ...);
  return all;
}
} // namespace Continua

#endif
