#ifndef continua_case_theory_stream_case_h
#define continua_case_theory_stream_case_h

#include <continua/case/case.h>
#include <continua/theory/stream_waves.h>

#include <memory>
#include <string>

namespace Continua
{
/// A parameter file with a mean flow, as the theory of waves on a stream sees it.
struct StreamCase
{
  std::unique_ptr<StreamWaves> waves;
  /// Of the section at the frequency of the waves [1/Pa], by Lame's wall without inertia.
  Complex distensibility;
};

/// Translates the case; returns why the theory does not cover it, or nothing.
template <int dim>
std::string make_stream_case(const Case<dim> &input, StreamCase &stream_case);
} // namespace Continua

#endif
