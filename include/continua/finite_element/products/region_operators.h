#ifndef continua_finite_element_products_region_operators_h
#define continua_finite_element_products_region_operators_h

#include <continua/finite_element/products/region_products.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/matrix_product.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <functional>
#include <memory>
#include <vector>

namespace Continua
{
/**
 * The matrices of one region, free of material data and time step; with the hanging nodes of the
 * mesh condensed and no prescribed velocity in them. u, v are velocities (or internal
 * displacements), p, q pressures:
 *
 *   mass             int v . u
 *   stiffness        int 2 dev sym grad v : dev sym grad u
 *   divergence       int q div u               (rows: pressure)
 *   pressure_mass    int q p
 *
 * and, over the boundaries where something supports the region, with the moduli k and c of its
 * parts along the normal n and across (BoundaryPart),
 *
 *   support_stiffness   int k_n (v.n) (u.n) + k_t v_t . u_t     [N/m]
 *   support_damping     the same with c_n and c_t               [N s/m]
 *
 * Mass and stiffness may be products without a matrix instead.
 *
 * dev takes a third of the three-dimensional trace off, in axisymmetry with the hoop strain u_r /
 * r; integrals in axisymmetry are over the whole circumference.
 */
struct RegionOperators
{
  dealii::TrilinosWrappers::SparseMatrix mass;      ///< empty where there are products
  dealii::TrilinosWrappers::SparseMatrix stiffness; ///< empty where there are products
  std::shared_ptr<const RegionProducts> products;   ///< null where there are matrices
  unsigned int number = 0;                          ///< the region's, for the products
  dealii::TrilinosWrappers::SparseMatrix divergence;
  dealii::TrilinosWrappers::SparseMatrix pressure_mass;
  bool is_supported = false; ///< else these two are empty
  dealii::TrilinosWrappers::SparseMatrix support_stiffness;
  dealii::TrilinosWrappers::SparseMatrix support_damping;

  void multiply_mass(DistributedVector &target, const DistributedVector &source) const;
  void multiply_stiffness(DistributedVector &target, const DistributedVector &source) const;
  /// Of the owned velocities; zero at those of other regions, and arbitrary at hanging nodes.
  DistributedVector mass_diagonal() const;
  DistributedVector stiffness_diagonal() const;
};

/// Assembles the operators of every region, by material id.
template <int dim>
void assemble_region_operators(const Space<dim> &space, std::vector<RegionOperators> &operators);
/// The same without mass and stiffness.
template <int dim>
void assemble_pressure_operators(const Space<dim> &space, std::vector<RegionOperators> &operators);
/// Whether a cell takes part in an assembly.
template <int dim>
using CellFilter =
    std::function<bool(const typename dealii::DoFHandler<dim>::active_cell_iterator &cell)>;
template <int dim>
bool all_cells(const typename dealii::DoFHandler<dim>::active_cell_iterator &)
{
  return true;
}
/// Mass and stiffness of some cells alone; they take the place of products.
template <int dim>
void assemble_velocity_operators(const Space<dim> &space,
                                 const CellFilter<dim> &cells,
                                 std::vector<RegionOperators> &operators);
/// Calls visit(cell, indices, mass, stiffness) for owned cells: the matrices of one cell and the
/// global indices of their rows, without constraints and without coefficients.
template <int dim>
void visit_velocity_matrices(
    const Space<dim> &space,
    const CellFilter<dim> &cells,
    const std::function<void(const typename dealii::DoFHandler<dim>::active_cell_iterator &cell,
                             const std::vector<dealii::types::global_dof_index> &indices,
                             const dealii::FullMatrix<double> &mass,
                             const dealii::FullMatrix<double> &stiffness)> &visit);

/// Local indices of the velocity and the pressure dofs of each region.
std::vector<std::vector<unsigned int>>
velocity_nodes(const std::vector<RegionOperators> &operators);
std::vector<std::vector<unsigned int>>
pressure_nodes(const std::vector<RegionOperators> &operators);
} // namespace Continua

#endif
