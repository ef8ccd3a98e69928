#ifndef continua_postprocess_error_norms_h
#define continua_postprocess_error_norms_h

#include <continua/base/parameter_section.h>
#include <continua/base/summary.h>
#include <continua/continuum/continuum_solver.h>
#include <continua/materials/model.h>

#include <string>
#include <vector>

namespace Continua
{
/**
 * The section Exact solution: functions of (x, y, z, t) with which the state at the end is
 * compared. Fields that are not given are not compared.
 */
template <int dim>
class ErrorNorms
{
public:
  /// Declares and reads; throws InputError.
  void read(ParameterSection section);
  /**
   * Compares at `time` [s] and adds `L2 error of FIELD` (absolute: the unit of the field times the
   * square root of an area, or of a volume) and, unless the exact solution is zero, `relative L2
   * error of FIELD`, for velocity, displacement, pressure and stress (with the components xx, yy,
   * zz, xy and in three dimensions xz, yz, each counted once). Collective.
   */
  void finish(ContinuumSolver<dim> &solver, double time, Model model, Summary &summary) const;

  /// The names of what finish() adds.
  void name_quantities(QuantityNames &names) const;

  bool empty() const { return fields.empty(); }

private:
  struct Field
  {
    std::string name;
    ComparedField compared;
    Dimension dimension;
    std::vector<Expression> exact; ///< one a component
  };
  std::vector<Field> fields;
};
} // namespace Continua

#endif
