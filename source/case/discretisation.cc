#include <continua/case/discretisation.h>

#include <continua/continuum/discrete_continuum.h>
#include <continua/finite_volume/cell_wise.h>

namespace Continua
{
std::vector<std::pair<std::string, std::string>> discretisation_types()
{
  return {{"taylor hood", "finite elements, velocity Q_k, pressure Q_(k-1)"},
          {"cell-wise", "the thesis's finite volumes, one value in a cell"}};
}

void DiscretisationParameters::read(ParameterSection root, const std::string &chosen)
{
  type = chosen;
  // A file may have the sections of both, so that one word changes its discretisation.
  const auto is_read = [&](const std::string &owner, const std::string &section)
  { return type == owner || root.has_subsection(section); };
  if (is_read("taylor hood", "Finite element"))
    taylor_hood.space.read(root.subsection("Finite element"));
  if (is_read("taylor hood", "Linear solver"))
    taylor_hood.linear_solver.read(root.subsection("Linear solver"));
  if (is_read("cell-wise", "Cell-wise"))
    cell_wise.read(root.subsection("Cell-wise"));
}

unsigned int DiscretisationParameters::velocities_per_cell() const
{
  return is_cell_wise() ? 1 : taylor_hood.space.velocity_degree;
}

std::vector<std::string> DiscretisationParameters::citations() const
{
  if (!is_cell_wise())
    return {"hoodtaylor1973"};
  std::vector<std::string> keys = {"jasakweller2000"};
  if (cell_wise.formulation == Formulation::velocity_pressure)
  {
    if (cell_wise.rhie_chow != RhieChow::none)
      keys.emplace_back("rhiechow1983");
    if (cell_wise.is_segregated())
      keys.emplace_back("issa1986");
  }
  return keys;
}

template <int dim>
std::unique_ptr<ContinuumSolver<dim>>
make_solver(dealii::parallel::TriangulationBase<dim> &triangulation,
            const Problem &problem,
            const DiscretisationParameters &parameters,
            Log &log)
{
  std::unique_ptr<Discretisation<dim>> discretisation;
  if (parameters.is_cell_wise())
    discretisation =
        std::make_unique<CellWise<dim>>(triangulation, problem, parameters.cell_wise, log);
  else
    discretisation =
        std::make_unique<TaylorHood<dim>>(triangulation, problem, parameters.taylor_hood, log);
  return std::make_unique<DiscreteContinuum<dim>>(std::move(discretisation), problem, log);
}

template std::unique_ptr<ContinuumSolver<2>> make_solver(dealii::parallel::TriangulationBase<2> &,
                                                         const Problem &,
                                                         const DiscretisationParameters &,
                                                         Log &);
template std::unique_ptr<ContinuumSolver<3>> make_solver(dealii::parallel::TriangulationBase<3> &,
                                                         const Problem &,
                                                         const DiscretisationParameters &,
                                                         Log &);
} // namespace Continua
