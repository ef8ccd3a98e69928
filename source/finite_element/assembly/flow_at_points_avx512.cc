// Eight points at a time.
#include <deal.II/base/config.h>
#undef DEAL_II_VECTORIZATION_WIDTH_IN_BITS
#define DEAL_II_VECTORIZATION_WIDTH_IN_BITS 512

#include <continua/finite_element/assembly/flow_at_points.templates.h>

CONTINUA_DEFINE_FLOW_TERMS(flow_terms_avx512, 8)
