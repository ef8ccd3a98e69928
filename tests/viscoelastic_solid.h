#ifndef continua_tests_viscoelastic_solid_h
#define continua_tests_viscoelastic_solid_h

#include <continua/materials/material.h>

#include <vector>

/// Without density; the volume change relaxes where it has branches of its own.
inline Continua::Material
viscoelastic_solid(const double inverse_bulk_modulus,
                   const double viscosity,
                   const std::vector<Continua::Branch> &branches,
                   const std::vector<Continua::BulkBranch> &bulk_branches = {})
{
  Continua::Material result;
  result.compression = bulk_branches.empty() ? Continua::Compression::elastic(inverse_bulk_modulus)
                                             : Continua::Compression::relaxing(bulk_branches);
  result.shear.viscosity = viscosity;
  result.shear.branches = branches;
  return result;
}

#endif
