#ifndef continua_continuum_stress_and_strain_h
#define continua_continuum_stress_and_strain_h

#include <continua/continuum/kinematics.h>
#include <continua/continuum/stress_free_state.h>
#include <continua/materials/flow_curve.h>
#include <continua/materials/material.h>
#include <continua/materials/model.h>
#include <continua/materials/plane_stress.h>

#include <deal.II/base/tensor.h>

#include <array>

namespace Continua
{
/// The components of a stress or strain as (i, j): xx, yy, zz, xy, and in three dimensions xz, yz.
inline constexpr unsigned int stress_pairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};

/// The number of components that exist in the model: 4 in two dimensions, else 6.
template <int dim>
constexpr unsigned int n_stresses()
{
  return dim == 2 ? 4 : 6;
}

/**
 * Stress of a material from the gradient of its mixture w = eta U + sum_k mu_k D_k, since s = 2 dev
 * sym grad w: xx, yy, zz, xy, and in three dimensions xz, yz. zz is the hoop stress in axisymmetry,
 * the stress across the plane in plane strain, 0 in plane stress. [Pa]
 */
template <int dim>
std::array<double, 6> stress(const dealii::Tensor<2, dim> &mixture_gradient,
                             double mixture_hoop,
                             double pressure,
                             Model model);

/// Viscosity over the one at zero rate of shear, of a liquid with this flow curve, from the
/// gradient of its mixture eta_0 U [1]: the factor of its shear stress.
template <int dim>
double thinning(const FlowCurve &curve,
                const dealii::Tensor<2, dim> &mixture_gradient,
                double mixture_hoop,
                Model model);

/// Strain of the displacement from its gradient, in the same order, xy the half of the shear angle.
/// zz is the hoop strain in axisymmetry, 0 in plane strain, and in plane stress what keeps sigma_zz
/// zero. [1]
template <int dim>
std::array<double, 6> strain(const dealii::Tensor<2, dim> &displacement_gradient,
                             double hoop,
                             Model model,
                             const PlaneStressFactors &plane_stress);

/// curl v by x, y, z from the gradient of a velocity, gradient[i][j] = dv_i/dx_j; in two dimensions
/// z alone, which in axisymmetry goes round the axis. [1/s]
template <int dim>
std::array<double, 6> vorticity(const dealii::Tensor<2, dim> &velocity_gradient);

/// Half of |W|^2 - |E|^2, with the antisymmetric and the symmetric part of the gradient: positive
/// where rotation prevails over strain (J. C. R. Hunt, A. A. Wray, P. Moin, Eddies, streams, and
/// convergence zones in turbulent flows, Center for Turbulence Research report CTR-S88 (1988)
/// 193-208). [1/s^2]
template <int dim>
double q_criterion(const dealii::Tensor<2, dim> &velocity_gradient, double hoop, Model model);

/// Cauchy's stress of a solid in finite deformation, in the same order, from the gradients of
/// displacement [1] and velocity [1/s] by the reference place and from the pressure [Pa]; `metric`:
/// sum_k mu_k A_k of the branches that relax, 0 if there are none [Pa] (internal_metric.h).
std::array<double, 6> finite_stress(const Material &material,
                                    const StressFreeState &stress_free,
                                    const Kinematics &kinematics,
                                    const dealii::Tensor<2, 3> &velocity_gradient,
                                    double pressure,
                                    const dealii::SymmetricTensor<2, 3> &metric);

/// Green's strain (F^T F - I)/2, in the same order [1].
std::array<double, 6> green_strain(const Kinematics &kinematics);

/// n.sigma from the stress [Pa].
template <int dim>
dealii::Tensor<1, dim> traction(const std::array<double, 6> &stress,
                                const dealii::Tensor<1, dim> &normal);
} // namespace Continua

#endif
