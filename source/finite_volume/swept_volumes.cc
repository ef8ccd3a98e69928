#include <continua/finite_volume/swept_volumes.h>

#include <deal.II/base/numbers.h>

namespace Continua
{
using namespace dealii;

namespace
{
/// The flux of a velocity that is linear on a line or a triangle through it. In axisymmetry all of
/// the circumference.
double flux(const std::array<Point<2>, 2> &line,
            const std::array<Tensor<1, 2>, 2> &velocity,
            const bool axisymmetric)
{
  const Tensor<1, 2> edge = line[1] - line[0];
  Tensor<1, 2> area;
  area[0] = edge[1];
  area[1] = -edge[0];
  const double a = velocity[0] * area, b = velocity[1] * area;
  if (!axisymmetric)
    return 0.5 * (a + b);
  // The mean of two linear functions' product.
  return 2. * numbers::PI * (line[0][1] * (2. * a + b) + line[1][1] * (a + 2. * b)) / 6.;
}

double flux(const std::array<Point<3>, 3> &triangle,
            const std::array<Tensor<1, 3>, 3> &velocity,
            const bool /*axisymmetric*/)
{
  const Tensor<1, 3> area =
      0.5 * cross_product_3d(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  return (velocity[0] + velocity[1] + velocity[2]) * area / 3.;
}
} // namespace

template <int dim>
void SweptVolumes<dim>::reset()
{
  rates.assign(mesh.faces().size(), 0.);
  growths.assign(mesh.n_owned_cells(), 0.);
  earlier_growths = growths;
  moving_materials.clear();
}

template <int dim>
double SweptVolumes<dim>::swept(const VolumeFace<dim> &face,
                                const VertexPlaces<dim> &begin,
                                const VertexPlaces<dim> &end) const
{
  const VertexPlaces<dim> *const ends[2] = {&begin, &end};
  std::array<SurfacePiece<dim>, 2> pieces;
  for (unsigned int i = 0; i < 2; ++i)
    pieces[i] = surface_piece(face.vertices, *ends[i]);
  double volume = 0.;
  for (std::size_t s = 0; s < pieces[0].simplices.size(); ++s)
  {
    const auto &first = pieces[0].simplices[s], &last = pieces[1].simplices[s];
    std::array<Tensor<1, dim>, dim> motion;
    std::array<Point<dim>, dim> middle;
    for (unsigned int v = 0; v < dim; ++v)
    {
      motion[v] = last[v] - first[v];
      middle[v] = first[v] + 0.5 * motion[v];
    }
    // The flux is of the second degree in time: Simpson's rule is exact.
    const bool axisymmetric = mesh.is_axisymmetric();
    volume += (flux(first, motion, axisymmetric) + 4. * flux(middle, motion, axisymmetric) +
               flux(last, motion, axisymmetric)) /
              6.;
  }
  return (pieces[1].area * face.normal < 0. ? -1. : 1.) * volume;
}

template <int dim>
void SweptVolumes<dim>::measure(const Step &step,
                                const VertexPlaces<dim> &older,
                                const VertexPlaces<dim> &old,
                                const VertexPlaces<dim> &present,
                                const std::vector<bool> &materials_that_move)
{
  reset();
  moving_materials = materials_that_move;
  for (unsigned int f = 0; f < mesh.faces().size(); ++f)
  {
    const VolumeFace<dim> &face = mesh.faces()[f];
    bool some_side_moves = false;
    for (unsigned int side = 0; side < face.n_sides(); ++side)
      some_side_moves = some_side_moves || moves(face.cell(side));
    if (!some_side_moves)
      continue;
    const double in_step = swept(face, old, present);
    const double before = step.a2 != 0. ? swept(face, older, old) : 0.;
    rates[f] = step.a0 * in_step - step.a2 * before;
    for (unsigned int side = 0; side < face.n_sides(); ++side)
      if (const unsigned int cell = face.cell(side); mesh.cells()[cell].is_owned)
      {
        const double sign = side == 0 ? 1. : -1.;
        growths[cell] += sign * in_step;
        earlier_growths[cell] += sign * (in_step + before);
      }
  }
}

template class SweptVolumes<2>;
template class SweptVolumes<3>;
} // namespace Continua
