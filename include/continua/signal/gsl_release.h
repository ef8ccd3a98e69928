#ifndef continua_signal_gsl_release_h
#define continua_signal_gsl_release_h

namespace Continua
{
/// Deletes an object of GSL's, for std::unique_ptr.
template <typename Object, void (*release)(Object *)>
struct GslRelease
{
  void operator()(Object *object) const { release(object); }
};
} // namespace Continua

#endif
