#ifndef continua_postprocess_probe_checks_h
#define continua_postprocess_probe_checks_h

#include <continua/postprocess/probe_entries.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/// What entries of one probe do not go together, and what of them does not go with the mesh and the
/// run. Each check throws InputError with the place of the entry.
template <int dim>
class ProbeChecks
{
public:
  explicit ProbeChecks(const ProbeEntries<dim> &probe) : probe(probe) {}

  /// Refuses entries that do not go together, once the place is known.
  void check_entries() const;
  /// See ProbeEntries.
  void check(const dealii::Triangulation<dim> &coarse_mesh,
             const std::vector<FieldComponent> &known_fields,
             const std::set<std::pair<unsigned int, unsigned int>> &boundary_regions) const;
  void check_limits(const std::vector<BoundaryCondition> &conditions,
                    const ProbeLimits &limits,
                    const std::vector<FieldComponent> &known_fields) const;

private:
  using Place = typename ProbeEntries<dim>::Place;
  const ProbeEntries<dim> &probe;

  void check_reference() const;
  void check_sign_changes() const;
  /// Of the cell-wise path: refuses what is not looked at on the present mesh.
  void check_moving_cells(const std::vector<FieldComponent> &known_fields) const;
  /// Refuses a cavity's pressure or volume where the boundary encloses none.
  void check_cavities(const std::vector<BoundaryCondition> &conditions,
                      const std::vector<FieldComponent> &known_fields) const;
  /// Refuses a mean over time where no liquid has a wall.
  void check_walls(const std::vector<BoundaryCondition> &conditions,
                   const ProbeLimits &limits) const;
  /// Refuses a point that no cell of the coarse mesh holds, a boundary that the region does not
  /// touch, a section without area and regions that do not meet.
  void check_point(const std::string &entry,
                   const dealii::Point<dim> &point,
                   const dealii::Triangulation<dim> &coarse_mesh) const;
  void
  check_boundaries(const std::set<std::pair<unsigned int, unsigned int>> &boundary_regions) const;
  void check_section(const std::string &entry,
                     const ProbeRequest<dim> &of_section,
                     const dealii::Triangulation<dim> &coarse_mesh) const;
  void check_interface(const dealii::Triangulation<dim> &coarse_mesh) const;
};
} // namespace Continua

#endif
