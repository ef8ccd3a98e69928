#ifndef continua_case_network_ends_h
#define continua_case_network_ends_h

#include <continua/case/case.h>

#include <string>
#include <vector>

namespace Continua
{
/// Reads the section Network of a run whose body stands at nodes of a network (Type = network): its
/// liquid is that of the body. Throws InputError for what does not fit the body, and for a network
/// without a body.
template <int dim>
void read_network_of_body(Case<dim> &input, ParameterSection root);

/// Adds the outlet whose ports are the boundaries at the network. After set_flow_profiles().
template <int dim>
void add_network_outlet(Case<dim> &input);

/// What a user should know of the joints before the run; none without a network.
template <int dim>
std::vector<std::string> network_warnings(const Case<dim> &input);

/// What jumps at the joints at the start, a sentence, or "".
template <int dim>
std::string network_at_start(const Case<dim> &input);
} // namespace Continua

#endif
