#ifndef continua_finite_element_space_kept_mapping_h
#define continua_finite_element_space_kept_mapping_h

#include <deal.II/base/config.h>
#include <deal.II/base/point.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/tria.h>

#if DEAL_II_VERSION_GTE(9, 8, 0)
#include <boost/container/small_vector.hpp>
#endif
#include <boost/signals2/connection.hpp>

#include <memory>
#include <vector>

namespace Continua
{
/**
 * A MappingQ that keeps the support points of the cells of a mesh. MappingQ takes them from the
 * geometry anew each time that a cell is visited, which is slow where the geometry is: the nearest
 * place on a centreline is a search. The points are the same to the last bit. Copies share what is
 * kept. dealii::MappingQCache is not this: it knows no cell that was not kept.
 */
template <int dim>
class KeptMapping : public dealii::MappingQ<dim>
{
public:
  using Base = dealii::MappingQ<dim>;

  /// `triangulation`: that of the cells, which must outlive the use of the mapping.
  KeptMapping(unsigned int degree, const dealii::Triangulation<dim> &triangulation);

  /// Keeps the points of the owned cells and of the ghost cells, until the mesh changes. The points
  /// of the other cells are found anew for each use.
  void keep_points();

  std::unique_ptr<dealii::Mapping<dim>> clone() const override;

protected:
#if DEAL_II_VERSION_GTE(9, 8, 0)
  /// deal.II's type of the points of a cell.
  using Points = boost::container::small_vector<dealii::Point<dim>, 200>;
  void
  compute_mapping_support_points(const typename dealii::Triangulation<dim>::cell_iterator &cell,
                                 Points &points) const override;
#else
  std::vector<dealii::Point<dim>> compute_mapping_support_points(
      const typename dealii::Triangulation<dim>::cell_iterator &cell) const override;
#endif

private:
  /// The points of a cell that keep_points() has kept, or null.
  const std::vector<dealii::Point<dim>> *
  kept_points(const typename dealii::Triangulation<dim>::cell_iterator &cell) const;

  struct Kept
  {
    std::vector<std::vector<std::vector<dealii::Point<dim>>>> points; ///< [level][index]
    boost::signals2::scoped_connection change_of_mesh;
  };

  const dealii::Triangulation<dim> *triangulation;
  std::shared_ptr<Kept> kept;
};
} // namespace Continua

#endif
