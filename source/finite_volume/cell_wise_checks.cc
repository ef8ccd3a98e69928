#include <continua/finite_volume/cell_wise_checks.h>

namespace Continua
{
void check_cell_wise(const Problem &problem,
                     const CellWiseParameters &parameters,
                     const bool,
                     ParameterSection root)
{
  const Formulation formulation = parameters.formulation_type();
  if (formulation == Formulation::velocity_pressure)
    return;
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
  {
    const Material &material = problem.materials[region];
    ParameterSection section = root.subsection("Materials").subsection(problem.regions[region]);
    if (formulation == Formulation::displacement && !material.is_solid())
      section.refuse("Type", "a fluid has no stress of its displacement",
                     "Set Cell-wise/Formulation = velocity-pressure");
    if (material.inverse_bulk_modulus == 0.)
      section.refuse("",
                     "the pressure of an incompressible material does not follow from the motion",
                     "Set Cell-wise/Formulation = velocity-pressure, or give it a bulk modulus");
  }
}
} // namespace Continua
