#ifndef continua_network_friction_memory_h
#define continua_network_friction_memory_h

#include <array>

namespace Continua
{
/**
 * The part of the friction of a liquid in a round tube that depends on the past: of the flow rate Q
 * exp(s t) it takes, per length and density,
 *
 *     4 nu/R^2 sum_j weight_j s/(s + rate_j nu/R^2) Q
 *
 * beside the 8 nu/R^2 Q of Poiseuille's flow (W. Zielke, J. Basic Eng. 90 (1968) 109: an infinite
 * sum with the squares of the zeros of J2 as rates; A. K. Trikha, J. Fluids Eng. 97 (1975) 97: a
 * few exponentials instead). The ten here were fitted to s F10/(1 - F10) of J. R. Womersley by
 * least squares. For Womersley's numbers up to 300 the inertia and friction together are within
 * 1.1e-5 (test network/vessel_memory).
 */
struct FrictionMode
{
  double rate;   ///< times nu/R^2: of the decay of the memory [1]
  double weight; ///< [1]
};
constexpr std::array<FrictionMode, 10> friction_modes = {{{26.40027559992302, 1.0040738751498863},
                                                          {73.27728598612156, 1.131748364485071},
                                                          {167.99566222709484, 1.7124014146402229},
                                                          {399.78570104400853, 2.8291212603454756},
                                                          {999.239779707924, 4.711025850687047},
                                                          {2610.919502956032, 7.992746137712746},
                                                          {7162.764806397532, 13.963198612890004},
                                                          {20935.50079086733, 25.713290441427574},
                                                          {70434.67984437553, 58.32656190364792},
                                                          {591225.1630545426, 475.412420824837}}};
} // namespace Continua

#endif
