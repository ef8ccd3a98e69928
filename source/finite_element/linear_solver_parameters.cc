#include <continua/finite_element/linear_solver_parameters.h>

namespace Continua
{
void LinearSolverParameters::read(ParameterSection section)
{
  const Words<LinearSolverType> types = {{"automatic", LinearSolverType::automatic},
                                         {"direct", LinearSolverType::direct},
                                         {"iterative", LinearSolverType::iterative}};
  const std::vector<std::string> old_types = {"cholmod", "mumps", "umfpack"};
  std::vector<std::string> type_choices = choices_of(types);
  type_choices.insert(type_choices.end(), old_types.begin(), old_types.end());
  std::string word = word_of(types, type);
  section.add_choice("Type", word, type_choices,
                     "Solver of the step's system: automatic takes a direct one up to 1 million "
                     "unknowns in two dimensions and 150,000 in three, and for vibrations, else "
                     "the iterative one. The names of direct solvers belong to Direct solver.");
  for (const std::string &old : old_types)
    if (word == old)
      section.refuse("Type", "the direct solvers have an entry of their own",
                     "Use 'Direct solver = " + old + "'");
  type = value_of(types, word);
  add_choice(section, "Direct solver", direct_solver, direct_solver_words(),
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
  add_choice(section, "Schur complement", schur_complement,
             {{"automatic", SchurApproximation::automatic},
              {"cahouet-chabard", SchurApproximation::cahouet_chabard},
              {"simple", SchurApproximation::simple}},
             "How the iterative solver approximates the pressure's matrix; automatic is "
             "cahouet-chabard.");
  add_choice(section, "Stiff block", stiff_block,
             {{"automatic", StiffBlock::automatic},
              {"direct", StiffBlock::direct},
              {"algebraic multigrid", StiffBlock::algebraic_multigrid}},
             "What the iterative solver does with the solid: automatic takes a factor up "
             "to 400,000 of its unknowns in two dimensions, 60,000 in three.");
  add_choice(section, "Fluid block", fluid_block,
             {{"automatic", FluidBlock::automatic},
              {"relaxation", FluidBlock::relaxation},
              {"algebraic multigrid", FluidBlock::algebraic_multigrid}},
             "What the iterative solver does with the fluid: automatic takes relaxation "
             "unless viscosity evens velocities out over several cells within a step.");
  add_choice(section, "Velocity product", velocity_product,
             {{"automatic", VelocityProduct::automatic},
              {"assembled", VelocityProduct::assembled},
              {"matrix-free", VelocityProduct::matrix_free}},
             "How the iterative solver multiplies with the matrix of the velocities: assembled "
             "stores the matrix, matrix-free forms its integrals anew in each product, which is "
             "faster and needs less memory, but is there for Velocity degree = 2 only; automatic "
             "takes it there.");
  std::vector<std::string> instruction_sets = choices_of(instruction_set_words());
  instruction_sets.insert(instruction_sets.begin(), "automatic");
  std::string set = instruction_sets.front();
  section.add_choice("Instruction set", set, instruction_sets,
                     "Of the processor, for products without a matrix: automatic takes the widest "
                     "one that the processor has. The last digits of results depend on it.");
  if (set != instruction_sets.front())
    instruction_set = value_of(instruction_set_words(), set);
  if (!can_run(instruction_set))
    section.refuse("Instruction set", "this processor or this program lacks " + set,
                   "Use automatic");
  if (velocity_product == VelocityProduct::assembled && section.given("Instruction set"))
    section.refuse("Instruction set", "Velocity product = assembled makes no use of it",
                   "Remove it, or set Velocity product = matrix-free");
  const auto refuse_idle = [&](const std::vector<std::string> &keys, const std::string &of)
  {
    for (const std::string &key : keys)
      if (section.given(key))
        section.refuse(key, "Type = " + word + " makes no use of it",
                       "Remove it, or set Type = " + of + " or automatic");
  };
  if (type == LinearSolverType::iterative)
    refuse_idle({"Direct solver", "Refinement steps", "Kept factors"}, "direct");
  if (type == LinearSolverType::direct)
    refuse_idle({"Tolerance", "Maximum iterations", "Restart length", "Schur complement",
                 "Stiff block", "Fluid block", "Velocity product", "Instruction set"},
                "iterative");
}
} // namespace Continua
