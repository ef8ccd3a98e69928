#ifndef continua_finite_volume_stencil_h
#define continua_finite_volume_stencil_h

#include <algorithm>
#include <utility>
#include <vector>

namespace Continua
{
/**
 * A linear function of the values of a ValueSpace: the sum of coefficient times value over a few
 * global value numbers. A coefficient is a number or, for a gradient, a vector. Every operator of
 * the cell-wise discretisation is one, so that matrices are put together from them and nothing is
 * written twice.
 */
template <typename Coefficient>
class Stencil
{
public:
  using Entry = std::pair<unsigned int, Coefficient>;

  Stencil() = default;
  Stencil(const unsigned int index, const Coefficient &coefficient) { add(index, coefficient); }

  void add(const unsigned int index, const Coefficient &coefficient)
  {
    for (Entry &entry : entries)
      if (entry.first == index)
      {
        entry.second += coefficient;
        return;
      }
    entries.emplace_back(index, coefficient);
  }
  /// Adds factor times another stencil; the factor may turn its coefficients into others (a vector
  /// times a number).
  template <typename Factor, typename Other>
  void add(const Factor &factor, const Stencil<Other> &other)
  {
    for (const auto &entry : other)
      add(entry.first, Coefficient(factor * entry.second));
  }

  typename std::vector<Entry>::const_iterator begin() const { return entries.begin(); }
  typename std::vector<Entry>::const_iterator end() const { return entries.end(); }
  std::size_t size() const { return entries.size(); }

private:
  std::vector<Entry> entries;
};
} // namespace Continua

#endif
