#ifndef continua_base_quiet_gsl_h
#define continua_base_quiet_gsl_h

#include <gsl/gsl_errno.h>

namespace Continua
{
/// GSL's default handler ends the program. As long as one of these lives errors are seen by GSL's
/// return values instead.
class QuietGsl
{
public:
  QuietGsl() : previous(gsl_set_error_handler_off()) {}
  ~QuietGsl() { gsl_set_error_handler(previous); }
  QuietGsl(const QuietGsl &) = delete;
  QuietGsl &operator=(const QuietGsl &) = delete;

private:
  gsl_error_handler_t *previous;
};
} // namespace Continua

#endif
