#ifndef continua_tests_finite_volume_cell_wise_meshes_h
#define continua_tests_finite_volume_cell_wise_meshes_h

// Meshes, fields and operators for the unit tests of the finite volumes.

#include "../check.h"

#include <continua/finite_volume/surface_normal_gradient.h>
#include <continua/mesh/distortion.h>

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>

#include <cmath>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace cell_wise_meshes
{
using namespace Continua;

/// Whether a factor says how much memory it takes; on several ranks it is MUMPS, which counts whole
/// megabytes.
inline bool states_memory(const double memory)
{
  return memory > 0. || dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1;
}

/// Only rank 0 prints.
inline void quiet_other_ranks()
{
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    std::cout.setstate(std::ios::failbit);
}

template <int dim>
using Triangulation = dealii::parallel::distributed::Triangulation<dim>;

/// Region 1 is a block in the middle of the unit cube that reaches to x = 0, region 0 the rest.
template <int dim>
void set_regions(Triangulation<dim> &mesh)
{
  for (const auto &cell : mesh.active_cell_iterators())
  {
    bool inside = cell->center()[0] < 0.5;
    for (unsigned int c = 1; c < dim; ++c)
      inside = inside && cell->center()[c] > 0.25 && cell->center()[c] < 0.75;
    cell->set_material_id(inside ? 1 : 0);
  }
}

/// The unit square or cube in n cells each way.
template <int dim>
void make_box(Triangulation<dim> &mesh, const unsigned int n)
{
  const std::vector<unsigned int> cells(dim, n);
  dealii::Point<dim> end;
  for (unsigned int c = 0; c < dim; ++c)
    end[c] = 1.;
  dealii::GridGenerator::subdivided_hyper_rectangle(mesh, cells, dealii::Point<dim>(), end, true);
  set_regions(mesh);
}

/// Moves every vertex; unlike GridTools::transform() also hanging ones, which a map that leaves
/// planes plane leaves on the edges and faces where they hang.
template <int dim>
void move_vertices(Triangulation<dim> &mesh,
                   const std::function<dealii::Point<dim>(const dealii::Point<dim> &)> &map)
{
  std::vector<bool> is_moved(mesh.n_vertices(), false);
  for (const auto &cell : mesh.cell_iterators())
    for (const unsigned int v : cell->vertex_indices())
      if (!is_moved[cell->vertex_index(v)])
      {
        cell->vertex(v) = map(cell->vertex(v));
        is_moved[cell->vertex_index(v)] = true;
      }
}

/// Makes cells grow smoothly with each coordinate: s (2 + s) / 3 for s.
inline double graded(const double s)
{
  return s * (2. + s) / 3.;
}
inline double not_graded(const double place)
{
  return std::sqrt(1. + 3. * place) - 1.;
}
template <int dim>
void grade(Triangulation<dim> &mesh)
{
  move_vertices<dim>(mesh,
                     [](const dealii::Point<dim> &point)
                     {
                       dealii::Point<dim> moved;
                       for (unsigned int c = 0; c < dim; ++c)
                         moved[c] = graded(point[c]);
                       return moved;
                     });
}

/// Divides the owned cells where the condition holds.
template <int dim>
void refine(
    Triangulation<dim> &mesh,
    const std::function<bool(const dealii::Point<dim> &)> &where = [](const dealii::Point<dim> &)
    { return true; })
{
  for (const auto &cell : mesh.active_cell_iterators())
    if (cell->is_locally_owned() && where(cell->center()))
      cell->set_refine_flag();
  mesh.execute_coarsening_and_refinement();
}

/// Divides the cells near a corner twice: hanging nodes inside, on the boundary and on interfaces.
template <int dim>
void refine_corner(Triangulation<dim> &mesh)
{
  for (const double radius : {0.6, 0.4})
    refine<dim>(mesh,
                [radius](const dealii::Point<dim> &centre) { return centre.norm() < radius; });
}

/// An affine map: lines of centres meet faces in their middle, but not at right angles.
template <int dim>
void shear(Triangulation<dim> &mesh)
{
  move_vertices<dim>(mesh,
                     [](const dealii::Point<dim> &point)
                     {
                       dealii::Point<dim> moved = point;
                       moved[0] += 0.5 * point[1] + 0.3 * point[dim - 1];
                       return moved;
                     });
}

/// A projective map: it leaves planes plane and the axis y = 0 where it is, but no two cells alike,
/// and lines of centres miss the middle of faces.
template <int dim>
void project(Triangulation<dim> &mesh)
{
  move_vertices<dim>(mesh,
                     [](const dealii::Point<dim> &point)
                     {
                       double divisor = 1.;
                       for (unsigned int c = 0; c < dim; ++c)
                         divisor += (0.5 - 0.2 * c) * point[c];
                       return dealii::Point<dim>(point / divisor);
                     });
}

template <int dim>
struct NamedMesh
{
  std::string name;
  std::function<void(Triangulation<dim> &)> make;
};

/// Meshes whose cells have flat faces.
template <int dim>
std::vector<NamedMesh<dim>> flat_faced()
{
  using Mesh = Triangulation<dim>;
  std::vector<NamedMesh<dim>> list = {{"Cartesian", [](Mesh &mesh) { make_box(mesh, 4); }},
                                      {"graded",
                                       [](Mesh &mesh)
                                       {
                                         make_box(mesh, 4);
                                         grade(mesh);
                                       }},
                                      {"sheared",
                                       [](Mesh &mesh)
                                       {
                                         make_box(mesh, 4);
                                         shear(mesh);
                                       }},
                                      {"projective",
                                       [](Mesh &mesh)
                                       {
                                         make_box(mesh, 4);
                                         project(mesh);
                                       }},
                                      {"adaptive",
                                       [](Mesh &mesh)
                                       {
                                         make_box(mesh, 4);
                                         refine_corner(mesh);
                                       }},
                                      {"adaptive and projective", [](Mesh &mesh)
                                       {
                                         make_box(mesh, 4);
                                         refine_corner(mesh);
                                         project(mesh);
                                       }}};
  if constexpr (dim == 2) // in 3-D their faces are not flat
  {
    list.push_back({"random", [](Mesh &mesh)
                    {
                      make_box(mesh, 4);
                      distort_coarse_mesh(mesh, 0.3);
                      refine(mesh);
                    }});
    list.push_back({"adaptive and curved", [](Mesh &mesh)
                    {
                      dealii::GridGenerator::quarter_hyper_shell(mesh, dealii::Point<dim>(), 0.5,
                                                                 1., 4);
                      refine(mesh);
                      set_regions(mesh);
                      refine_corner(mesh);
                    }});
  }
  return list;
}

/// A function's values at the centres of cells and faces, by global number, on every rank.
template <int dim>
std::vector<double>
replicated_field(const CellWiseMesh<dim> &mesh,
                 const ValueSpace<dim> &space,
                 const std::function<double(const dealii::Point<dim> &)> &function)
{
  std::vector<double> values(space.n_values(), 0.);
  for (unsigned int c = 0; c < mesh.n_owned_cells(); ++c)
    values[space.of_cell(c)] = function(mesh.cells()[c].centre);
  for (unsigned int f = 0; f < mesh.faces().size(); ++f)
    if (mesh.faces()[f].has_value())
      for (unsigned int side = 0; side < mesh.faces()[f].n_sides(); ++side)
        if (space.owns_face(f, side))
          values[space.of_face(f, side)] = function(mesh.faces()[f].centre);
  dealii::Utilities::MPI::sum(values, mesh.communicator(), values);
  return values;
}

/// All operators on one mesh, and fields of replicated values.
template <int dim>
class Operators
{
public:
  Operators(const CellWiseMesh<dim> &mesh, const InterfaceValue interface_value)
      : mesh(mesh),
        space(mesh, interface_value),
        gradient(mesh, space),
        normal_gradient(mesh, space, gradient)
  {
    space.distribute();
    gradient.build();
  }

  /// A function's values at centres of cells and faces.
  std::vector<double> field(const std::function<double(const dealii::Point<dim> &)> &function) const
  {
    return replicated_field<dim>(mesh, space, function);
  }

  /// The divergence of a vector field over a cell as the equations have it, by what its faces'
  /// values let through; the coefficient of a value is the vector that multiplies it [m^2].
  Stencil<dealii::Tensor<1, dim>> divergence(const unsigned int cell) const
  {
    Stencil<dealii::Tensor<1, dim>> result;
    for (const unsigned int f : mesh.cells()[cell].faces)
    {
      const unsigned int side = mesh.side(f, cell);
      const dealii::Tensor<1, dim> area = mesh.faces()[f].area * mesh.faces()[f].outward(side);
      result.add(area, gradient.face_value(f, side));
    }
    return result;
  }
  /// div grad over a cell by the normal gradients on its faces [m].
  Stencil<double> compact_laplacian(const unsigned int cell) const
  {
    Stencil<double> result;
    for (const unsigned int f : mesh.cells()[cell].faces)
      result.add(mesh.faces()[f].area, normal_gradient(f, mesh.side(f, cell)));
    return result;
  }
  /// The same by the cells' gradients interpolated to the faces: it does not see a checkerboard.
  Stencil<double> wide_laplacian(const unsigned int cell) const
  {
    Stencil<double> result;
    for (const unsigned int f : mesh.cells()[cell].faces)
    {
      const unsigned int side = mesh.side(f, cell);
      const dealii::Tensor<1, dim> area = mesh.faces()[f].area * mesh.faces()[f].outward(side);
      result.add(area, gradient.on_face(f, side));
    }
    return result;
  }

  const CellWiseMesh<dim> &mesh;
  ValueSpace<dim> space;
  GaussGradient<dim> gradient;
  SurfaceNormalGradient<dim> normal_gradient;
};

/// Does something with the operators on each mesh, plane or axisymmetric, and with either kind of
/// value on interfaces.
template <int dim>
void on_each(const std::vector<NamedMesh<dim>> &meshes,
             const bool axisymmetric,
             const std::function<void(const std::string &, const Operators<dim> &)> &action)
{
  for (const auto &named : meshes)
  {
    Triangulation<dim> triangulation(MPI_COMM_WORLD);
    named.make(triangulation);
    CellWiseMesh<dim> mesh(triangulation, axisymmetric);
    mesh.build();
    for (const InterfaceValue value : {InterfaceValue::common, InterfaceValue::broken})
      action((axisymmetric ? "axisymmetric"
              : dim == 2   ? "2-D"
                           : "3-D") +
                 std::string(", ") + named.name +
                 (value == InterfaceValue::common ? ", common values" : ", broken values"),
             Operators<dim>(mesh, value));
  }
}

template <typename Coefficient>
Coefficient evaluate(const Stencil<Coefficient> &stencil, const std::vector<double> &values)
{
  Coefficient result{};
  for (const auto &entry : stencil)
    result += values[entry.first] * entry.second;
  return result;
}

/// 1 + 2 x + 3 y + ... and its gradient.
template <int dim>
dealii::Tensor<1, dim> slope()
{
  dealii::Tensor<1, dim> slope;
  for (unsigned int c = 0; c < dim; ++c)
    slope[c] = 2. + c;
  return slope;
}
template <int dim>
double linear(const dealii::Point<dim> &point)
{
  return 1. + slope<dim>() * point;
}

/// Whether a cell's neighbours are all cells of its own region.
template <int dim>
bool is_inside(const CellWiseMesh<dim> &mesh, const unsigned int cell)
{
  for (const unsigned int f : mesh.cells()[cell].faces)
    if (mesh.faces()[f].has_value())
      return false;
  return true;
}

/// A smooth function, its gradient and its Laplacian.
template <int dim>
struct Waves
{
  static double value(const dealii::Point<dim> &point)
  {
    double product = 1.;
    for (unsigned int c = 0; c < dim; ++c)
      product *= std::sin(phase(c, point));
    return product;
  }
  static dealii::Tensor<1, dim> gradient(const dealii::Point<dim> &point)
  {
    dealii::Tensor<1, dim> gradient;
    for (unsigned int k = 0; k < dim; ++k)
    {
      gradient[k] = number(k);
      for (unsigned int c = 0; c < dim; ++c)
        gradient[k] *= c == k ? std::cos(phase(c, point)) : std::sin(phase(c, point));
    }
    return gradient;
  }
  static double laplacian(const dealii::Point<dim> &point)
  {
    double sum = 0.;
    for (unsigned int c = 0; c < dim; ++c)
      sum -= number(c) * number(c);
    return sum * value(point);
  }

private:
  static double number(const unsigned int c) { return 1.5 + 0.5 * c; }
  static double phase(const unsigned int c, const dealii::Point<dim> &point)
  {
    return 1. + number(c) * point[c];
  }
};

/// The observed order of an error between two meshes, one with half the cell size of the other.
inline void
check_order(const std::string &name, const double coarse, const double fine, const double theory)
{
  check::absolute(name, std::log2(coarse / fine), theory, 0.15);
}

/// A sequence of meshes, by the number of times the cells are halved.
struct Sequence
{
  std::string name;
  std::function<void(Triangulation<2> &, unsigned int)> make;
  bool is_smooth; ///< whether neighbouring cells become alike
};
inline std::vector<Sequence> sequences()
{
  using Mesh = Triangulation<2>;
  return {{"Cartesian", [](Mesh &mesh, const unsigned int n) { make_box(mesh, n); }, true},
          {"graded",
           [](Mesh &mesh, const unsigned int n)
           {
             make_box(mesh, n);
             grade(mesh);
           },
           true},
          {"projective",
           [](Mesh &mesh, const unsigned int n)
           {
             make_box(mesh, n);
             project(mesh);
           },
           true},
          {"random",
           [](Mesh &mesh, const unsigned int n)
           {
             make_box(mesh, n);
             distort_coarse_mesh(mesh, 0.3);
           },
           false},
          {"adaptive",
           [](Mesh &mesh, const unsigned int n)
           {
             make_box(mesh, n);
             refine_corner(mesh);
           },
           false}};
}

inline double largest(const double value)
{
  return dealii::Utilities::MPI::max(value, MPI_COMM_WORLD);
}
inline double sum(const double value)
{
  return dealii::Utilities::MPI::sum(value, MPI_COMM_WORLD);
}
} // namespace cell_wise_meshes

#endif
