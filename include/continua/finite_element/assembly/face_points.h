#ifndef continua_finite_element_assembly_face_points_h
#define continua_finite_element_assembly_face_points_h

#include <continua/continuum/problem.h>
#include <continua/finite_element/assembly/term_faces.h>
#include <continua/finite_element/terms/cell_state.h>
#include <continua/finite_element/terms/flow_face_point.h>
#include <continua/finite_element/terms/solid_face_point.h>
#include <continua/time_integration/step.h>

#include <deal.II/lac/vector.h>

#include <vector>

namespace Continua
{
/// Makes the state at the points of faces.
template <int dim>
class FacePoints
{
public:
  /// It must outlive it.
  explicit FacePoints(const Problem &problem) : problem(problem) {}

  /// What is given in this step, and the unknown pressures of boundaries [Pa].
  void set_step(const Step &of_state, const std::vector<double> &pressures_of_boundaries);
  /// At a point of a face of a solid; the displacement is that of the cell at its dofs [m].
  SolidFacePoint<dim> of_solid(const TermFace<dim> &face,
                               unsigned int q,
                               const dealii::Vector<double> &displacement) const;
  /// At a point of a face of a liquid.
  FlowFacePoint<dim> of_flow(const TermFace<dim> &face,
                             unsigned int q,
                             const Material &liquid,
                             const CellState<dim> &state) const;

private:
  const Problem &problem;
  Step step;
  std::vector<double> boundary_pressures;

  /// The traction on a liquid at a present place [Pa].
  dealii::Tensor<1, dim> traction(const TermFace<dim> &face,
                                  const dealii::Point<dim> &place,
                                  const dealii::Tensor<1, dim> &normal) const;
};
} // namespace Continua

#endif
