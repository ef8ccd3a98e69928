#ifndef continua_finite_element_space_space_h
#define continua_finite_element_space_space_h

#include <continua/base/parameter_section.h>
#include <continua/finite_element/space/ghosted_copy.h>
#include <continua/finite_element/space/kept_mapping.h>
#include <continua/linear_algebra/distributed_vector.h>
#include <continua/materials/model.h>

#include <deal.II/base/index_set.h>
#include <deal.II/base/quadrature.h>
#include <deal.II/distributed/tria_base.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/hp/fe_collection.h>
#include <deal.II/hp/mapping_collection.h>
#include <deal.II/lac/affine_constraints.h>

#include <mpi.h>

#include <string>
#include <vector>

namespace Continua
{
enum class PressureSpace
{
  broken,    ///< the pressure may jump between regions
  continuous ///< one continuous field
};

/// The section Finite element.
struct SpaceParameters
{
  unsigned int velocity_degree = 2;
  PressureSpace pressure_space = PressureSpace::broken;

  void read(ParameterSection section);
};

/**
 * The Taylor-Hood pair on one mesh: velocity Q_k, one vector of it also for every internal
 * displacement, and pressure Q_(k-1), continuous inside a region and broken between regions (or
 * continuous throughout).
 *
 * Two DoFHandlers on one triangulation. The broken pressure is an hp space with one component for
 * each region: FE_Q in the region itself, FE_Nothing elsewhere, so that the dofs on an interface
 * are doubled and hanging nodes are constrained inside each region only. Velocity is not part of
 * it: in one common hp system deal.II 9.4 pins interface pressures to zero where the interface has
 * hanging nodes.
 *
 * Elements, quadratures and mappings for this mesh are made here, so that what depends on the shape
 * of the cells stands in one place.
 */
template <int dim>
class Space
{
public:
  Space(dealii::parallel::TriangulationBase<dim> &triangulation,
        const SpaceParameters &parameters,
        Model model,
        unsigned int n_regions);

  /// Numbers the dofs on the present mesh and makes the constraints of its hanging nodes.
  void distribute();

  DistributedVector velocity_vector() const
  {
    return DistributedVector(velocity_owned, communicator);
  }
  DistributedVector pressure_vector() const
  {
    return DistributedVector(pressure_owned, communicator);
  }
  /// Copies with ghost entries and hanging nodes set, for evaluation on cells.
  DistributedVector ghosted_velocity(const DistributedVector &owned) const;
  DistributedVector ghosted_pressure(const DistributedVector &owned) const;

  /// The same into a vector with ghost entries that is there. Collective.
  void copy_velocity(const DistributedVector &owned, DistributedVector &ghosted) const
  {
    velocity_copy.copy(owned, ghosted);
  }
  void copy_pressure(const DistributedVector &owned, DistributedVector &ghosted) const
  {
    pressure_copy.copy(owned, ghosted);
  }

  /// Owned vectors have no values of their own at hanging nodes: the matrices have those condensed.
  void set_hanging_velocities_to_zero(DistributedVector &owned) const;
  void set_hanging_pressures_to_zero(DistributedVector &owned) const;

  /// 2 pi r in axisymmetry, else 1: the measure of a point of the mesh [m or 1].
  double circumference(const dealii::Point<dim> &point) const;
  /// The component of the pressure space in which a region's pressure lives.
  unsigned int pressure_component(const unsigned int region) const { return broken ? region : 0; }
  bool is_axisymmetric() const { return axisymmetric; }
  unsigned int degree() const { return velocity_element.degree; }
  /// Gauss points a direction that integrate the products of shape functions exactly on
  /// parallelograms.
  unsigned int n_quadrature_points() const { return degree() + 1 + (axisymmetric ? 1 : 0); }

  /// The element of one component of the velocity, and of the pressure in one region.
  const dealii::FiniteElement<dim> &scalar_element() const
  {
    return velocity_element.base_element(0);
  }
  const dealii::FiniteElement<dim> &scalar_pressure_element() const
  {
    return pressure_elements[0].base_element(0);
  }
  /// A velocity of degree 1.
  dealii::FESystem<dim> linear_element() const;
  /// That many components that jump between cells, of that degree.
  dealii::FESystem<dim> broken_element(unsigned int degree, unsigned int n_components) const;
  /// That many components whose values are those at the points of quadrature(n_points).
  dealii::FESystem<dim> element_at_points(unsigned int n_points, unsigned int n_components) const;
  /// That many components without unknowns, for cells that have none of a field.
  dealii::FESystem<dim> no_element(unsigned int n_components) const;
  /// Gauss points of the unit cell and of its face, that many a direction.
  dealii::Quadrature<dim> quadrature(unsigned int n_points) const;
  dealii::Quadrature<dim - 1> face_quadrature(unsigned int n_points) const;

  MPI_Comm communicator;
  dealii::parallel::TriangulationBase<dim> &triangulation;
  /// Of the velocity's degree, so that curved boundaries (manifolds) cost no order of convergence.
  KeptMapping<dim> mapping;
  dealii::hp::MappingCollection<dim> mappings; ///< the same, for the hp space
  dealii::FESystem<dim> velocity_element;
  dealii::hp::FECollection<dim> pressure_elements; ///< by region, or one if continuous
  dealii::DoFHandler<dim> velocity_dofs;
  dealii::DoFHandler<dim> pressure_dofs;
  dealii::IndexSet velocity_owned, velocity_relevant;
  dealii::IndexSet pressure_owned, pressure_relevant;
  dealii::AffineConstraints<double> velocity_hanging, pressure_hanging;

private:
  bool broken;
  bool axisymmetric;
  // They have work space of their own.
  mutable GhostedCopy velocity_copy, pressure_copy;
  std::vector<unsigned int> hanging_velocities, hanging_pressures; ///< local indices of owned ones
};
} // namespace Continua

#endif
