#ifndef continua_continuum_fibre_directions_h
#define continua_continuum_fibre_directions_h

#include <continua/materials/material.h>
#include <continua/materials/model.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace Continua
{
/// The unit directions of a material's fibres at a place of the stress-free body, from the axis
/// towards the circumference; empty for a law without fibres. The axis is the x axis, in plane
/// strain the line through the origin across the plane. On the axis itself, where no circumference
/// exists, any one is taken.
template <int dim>
std::vector<dealii::Tensor<1, 3>>
fibres_at(const Material &material, Model model, const dealii::Point<dim> &place);
} // namespace Continua

#endif
