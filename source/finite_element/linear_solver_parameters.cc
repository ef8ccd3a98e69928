#include <continua/finite_element/linear_solver_parameters.h>

namespace Continua
{
void LinearSolverParameters::read(ParameterSection section)
{
  const std::vector<std::string> old_types = {"cholmod", "mumps", "umfpack"};
  section.add_choice("Type", type,
                     {"automatic", "direct", "iterative", "cholmod", "mumps", "umfpack"},
                     "Solver of the step's system: automatic takes a direct one up to 1 million "
                     "unknowns in two dimensions and 150,000 in three, and for vibrations, else "
                     "the iterative one. The names of direct solvers belong to Direct solver.");
  for (const std::string &old : old_types)
    if (type == old)
      section.refuse("Type", "the direct solvers have an entry of their own",
                     "Use 'Direct solver = " + old + "'");
  section.add_choice("Direct solver", direct_solver, {"automatic", "cholmod", "mumps", "umfpack"},
                     "automatic takes cholmod on one rank where every material is compressible "
                     "and the matrix has no more than 2 million entries, else mumps; umfpack is "
                     "there for comparison.");
  section.add("Refinement steps", refinement_steps,
              "Steps of iterative refinement after each direct solve [1].", 0, 5);
  section.add("Kept factors", kept_factors,
              "Factors, of as many time steps' sizes, that are kept for when a size comes back; "
              "each takes its full memory [1].",
              1, 20);
  section.add("Tolerance", tolerance, Dimension(),
              "Of the iterative solver: residual relative to the largest term of the step's own "
              "equations [1].",
              Range{0., 1e-2, true, false});
  section.add("Maximum iterations", maximum_iterations,
              "Of the iterative solver; a solve that needs more ends the run [1].", 1);
  section.add("Restart length", restart_length,
              "Iterations after which the iterative solver begins anew; it keeps two vectors for "
              "each [1].",
              5, 500);
  section.add_choice("Schur complement", schur_complement,
                     {"automatic", "cahouet-chabard", "simple"},
                     "How the iterative solver approximates the pressure's matrix; automatic is "
                     "cahouet-chabard.");
  section.add_choice("Stiff block", stiff_block, {"automatic", "direct", "algebraic multigrid"},
                     "What the iterative solver does with the solid: automatic takes a factor up "
                     "to 400,000 of its unknowns in two dimensions, 60,000 in three.");
  section.add_choice("Fluid block", fluid_block, {"automatic", "relaxation", "algebraic multigrid"},
                     "What the iterative solver does with the fluid: automatic takes relaxation "
                     "unless viscosity evens velocities out over several cells within a step.");
  const auto refuse_idle = [&](const std::vector<std::string> &keys, const std::string &of)
  {
    for (const std::string &key : keys)
      if (section.given(key))
        section.refuse(key, "Type = " + type + " makes no use of it",
                       "Remove it, or set Type = " + of + " or automatic");
  };
  if (type == "iterative")
    refuse_idle({"Direct solver", "Refinement steps", "Kept factors"}, "direct");
  if (type == "direct")
    refuse_idle({"Tolerance", "Maximum iterations", "Restart length", "Schur complement",
                 "Stiff block", "Fluid block"},
                "iterative");
}
} // namespace Continua
