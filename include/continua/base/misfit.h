#ifndef continua_base_misfit_h
#define continua_base_misfit_h

#include <sstream>
#include <string>

namespace Continua
{
/// A fit that misses more than this is warned of [1].
constexpr double largest_misfit = 0.05;

/// What to warn of where a law does not follow what it was fitted to; empty below the bound. `fit`
/// names what was fitted, by which entry or probe; `misfit`: relative [1], `measure` says how it
/// is measured; `remedy` is a sentence.
inline std::string misfit_warning(const std::string &fit,
                                  const double misfit,
                                  const std::string &measure,
                                  const std::string &remedy)
{
  if (misfit <= largest_misfit)
    return "";
  std::ostringstream text;
  text.precision(2);
  text << fit << " misses by " << 100. * misfit << " % (" << measure << "), more than "
       << 100. * largest_misfit << " %. " << remedy;
  return text.str();
}
} // namespace Continua

#endif
