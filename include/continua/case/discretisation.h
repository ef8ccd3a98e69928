#ifndef continua_case_discretisation_h
#define continua_case_discretisation_h

#include <continua/base/log.h>
#include <continua/base/parameter_section.h>
#include <continua/continuum/continuum_solver.h>
#include <continua/continuum/problem.h>
#include <continua/finite_element/taylor_hood.h>
#include <continua/finite_volume/cell_wise_parameters.h>

#include <deal.II/distributed/tria_base.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/// The discretisations that exist: name and a line of description, for the manual and
/// `Discretisation`.
std::vector<std::pair<std::string, std::string>> discretisation_types();

/// What the discretisation of a run reads of the parameter file, and what the run has to know of it
/// besides the solver.
struct DiscretisationParameters
{
  std::string type = "taylor hood";
  TaylorHoodParameters taylor_hood;
  CellWiseParameters cell_wise;

  /// Declares and reads the sections of that discretisation, and those of another that are given.
  /// Throws InputError.
  void read(ParameterSection root, const std::string &type);

  bool is_cell_wise() const { return type == "cell-wise"; }
  /// Velocities along an edge of a cell, a shared one counted once: the degree of the elements.
  unsigned int velocities_per_cell() const;
  /// Keys of what is to be cited for the methods used.
  std::vector<std::string> citations() const;
};

/// The solver of the chosen discretisation; all but the parameters must outlive it.
template <int dim>
std::unique_ptr<ContinuumSolver<dim>>
make_solver(dealii::parallel::TriangulationBase<dim> &triangulation,
            const Problem &problem,
            const DiscretisationParameters &parameters,
            Log &log);
} // namespace Continua

#endif
