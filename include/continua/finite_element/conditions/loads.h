#ifndef continua_finite_element_conditions_loads_h
#define continua_finite_element_conditions_loads_h

#include <continua/continuum/load_list.h>
#include <continua/finite_element/space/space.h>

#include <array>
#include <optional>
#include <vector>

namespace Continua
{
/// The loads on the velocity's test functions: prescribed tractions int v . t and the body force
/// int v . rho b, with hanging nodes condensed. Those that follow the present shape of their region
/// are terms of its equations and not here (see following_loads.h).
template <int dim>
class Loads : public LoadList
{
public:
  /// `region`: those on its cells and their faces alone; none: all.
  Loads(const Space<dim> &space,
        const Problem &problem,
        const std::optional<unsigned int> region = {})
      : LoadList(problem), space(space), region(region)
  {
  }

  /// int v . n over the faces of a condition: the flow rate out of the body that each velocity
  /// stands for (hanging nodes condensed) [m^2].
  DistributedVector flow_of_velocities(unsigned int condition) const;
  /// The traction that is prescribed on a face at a point [Pa], of the parts that are natural;
  /// others are zero.
  static dealii::Tensor<1, dim> prescribed_traction(const BoundaryCondition &condition,
                                                    const dealii::Point<dim> &point,
                                                    const dealii::Tensor<1, dim> &normal,
                                                    double time);

private:
  using Item = LoadList::Item;
  using LoadList::problem;
  const Space<dim> &space;
  const std::optional<unsigned int> region;

  bool acts_on(const unsigned int material_id) const { return !region || *region == material_id; }
  /// Whether the item is a term of the equations of a region.
  bool is_term(const Item &item, unsigned int region) const;
  DistributedVector zero_forces() const override { return space.velocity_vector(); }
  void integrate(const Item &item,
                 const Waveform *waveform,
                 double time,
                 DistributedVector &forces) const override;
  std::vector<std::array<double, 3>> places(const Item &item) const override;
};
} // namespace Continua

#endif
