#include <continua/finite_element/space/linear_solver_parameters.h>

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
  section.add_choice(
      "Type", word, type_choices,
      "Solver of the step's system: automatic takes a direct one up to 1 million "
      "unknowns in two dimensions and 30,000 in three, and for vibrations. In three "
      "dimensions up to 300,000 it takes the one that is estimated to take less "
      "time for all steps, and beyond, or where no factor fits into the memory, the "
      "iterative one. With convection it takes a direct one up to 150,000 unknowns in three "
      "dimensions; for a steady flow and with finite deformation as long as its factor fits. The "
      "names of direct solvers belong to Direct solver.");
  for (const std::string &old : old_types)
    if (word == old)
      section.refuse("Type", "the direct solvers have an entry of their own",
                     "Use 'Direct solver = " + old + "'");
  type = value_of(types, word);
  add_choice(section, "Direct solver", direct_solver, direct_solver_words(),
             "automatic takes cholmod on one rank where every material is compressible "
             "and the matrix has no more than 2 million entries, else mumps; umfpack is "
             "there for comparison. Where a factor without pivots loses its digits, automatic and "
             "mumps make it again by MUMPS with pivots, and say so.");
  add_choice(section, "Factor precision", factor_precision,
             {{"automatic", FactorPrecision::automatic},
              {"double", FactorPrecision::double_precision},
              {"single", FactorPrecision::single_precision}},
             "Of a direct solver's factor. A factor in single precision takes half the memory, and "
             "each solve two or three times the work: FGMRES makes up for the digits, until the "
             "residual is 1e-12 of the right-hand side. automatic is double unless that does not "
             "fit into the memory; with Type = automatic it is single, too, for more than 150,000 "
             "unknowns in three dimensions. Single is there for MUMPS only, and not with "
             "convection, finite "
             "deformation or vibrations.");
  section.add("Refinement steps", refinement_steps,
              "Steps of iterative refinement after each direct solve [1]; at least one where the "
              "steady equations are solved.",
              0, 5);
  section.add("Kept factors", kept_factors,
              "Factors, of as many time steps' sizes, that are kept for when a size comes back; "
              "each takes its full memory [1].",
              1, 20);
  section.add("Tolerance", tolerance, Dimension(),
              "Of the iterative solver: residual relative to the largest term of the step's own "
              "equations [1].",
              Range{0., 1e-2, true, false});
  section.add("Maximum iterations", maximum_iterations,
              "Of the iterative solver. A solve that needs more ends the run; with convection or "
              "finite deformation the step then has no solution and is halved [1].",
              1);
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
              {"polynomial multigrid", StiffBlock::polynomial_multigrid},
              {"algebraic multigrid", StiffBlock::algebraic_multigrid}},
             "What the iterative solver does with the solid: automatic takes a factor up to "
             "400,000 of its velocities in two dimensions and 60,000 in three. Beyond it takes a "
             "factor if the solid has at most half of all velocities and 1,000,000 of them, and "
             "the entries of the factor need at most 1 kB for each unknown of the whole system; "
             "else it takes multigrid. A factor of a matrix of more than 2,000,000 entries has "
             "single precision. polynomial multigrid relaxes the quadratic velocities by products "
             "without a matrix. It solves for the linear ones by a factor, if this needs at most "
             "250 B for each unknown of the whole system, else by algebraic multigrid. It needs "
             "Velocity degree = 2 and products without a matrix, and automatic takes it there. "
             "algebraic multigrid has a matrix of all velocities of the solid.");
  add_choice(section, "Fluid block", fluid_block,
             {{"automatic", FluidBlock::automatic},
              {"relaxation", FluidBlock::relaxation},
              {"algebraic multigrid", FluidBlock::algebraic_multigrid}},
             "What the iterative solver does with the fluid: automatic takes relaxation "
             "unless viscosity evens velocities out over several cells within a step, then "
             "polynomial multigrid, or algebraic multigrid where the products have a matrix.");
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
  section.add_choice(
      "Instruction set", set, instruction_sets,
      "Of the processor, for products without a matrix in three dimensions: automatic "
      "takes the widest one that processor and program have. In two dimensions "
      "products have the baseline. The last digits of results depend on it.");
  if (set != instruction_sets.front())
    instruction_set = value_of(instruction_set_words(), set);
  if (!can_run(instruction_set))
    section.refuse("Instruction set", "this processor or this program lacks " + set,
                   "Use automatic");
  if (velocity_product == VelocityProduct::assembled && section.given("Instruction set"))
    section.refuse("Instruction set", "Velocity product = assembled makes no use of it",
                   "Remove it, or set Velocity product = matrix-free");
  if (velocity_product == VelocityProduct::assembled &&
      stiff_block == StiffBlock::polynomial_multigrid)
    section.refuse("Stiff block", "polynomial multigrid needs products without a matrix",
                   "Set Velocity product = matrix-free, or Stiff block = algebraic multigrid");
  const auto refuse_idle = [&](const std::vector<std::string> &keys, const std::string &of)
  {
    for (const std::string &key : keys)
      if (section.given(key))
        section.refuse(key, "Type = " + word + " makes no use of it",
                       "Remove it, or set Type = " + of + " or automatic");
  };
  if (type == LinearSolverType::iterative)
    refuse_idle({"Direct solver", "Factor precision", "Refinement steps", "Kept factors"},
                "direct");
  const bool is_single = factor_precision == FactorPrecision::single_precision;
  if (type == LinearSolverType::direct)
    refuse_idle({"Tolerance", "Maximum iterations", "Restart length", "Schur complement",
                 "Stiff block", "Fluid block"},
                "iterative");
  // A factor in single precision has products of its own.
  if (type == LinearSolverType::direct && !is_single)
    refuse_idle({"Velocity product", "Instruction set"}, "iterative");
  if (!is_single)
    return;
  if (direct_solver == DirectSolver::cholmod || direct_solver == DirectSolver::umfpack)
    section.refuse("Factor precision",
                   word_of(direct_solver_words(), direct_solver) +
                       " has no factor in single precision",
                   "Set Direct solver = mumps or automatic, or Factor precision = double");
  if (section.given("Refinement steps"))
    section.refuse("Refinement steps",
                   "with Factor precision = single FGMRES refines each solve to its own tolerance",
                   "Remove it, or set Factor precision = double");
}
} // namespace Continua
