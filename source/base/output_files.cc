#include <continua/base/output_files.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace Continua
{
const std::vector<std::string> &output_files()
{
  static const std::vector<std::string> names = {"amplification.csv",
                                                 "beats.csv",
                                                 "branches.csv",
                                                 "checkpoint",
                                                 "citation.bib",
                                                 "comparison.csv",
                                                 "correlation.csv",
                                                 "creep.csv",
                                                 "dispersion.csv",
                                                 "equibiaxial.csv",
                                                 "errors.csv",
                                                 "evaluations.csv",
                                                 "expected-errors.csv",
                                                 "fields",
                                                 "fields.pvd",
                                                 "fit-creep.csv",
                                                 "fit-equibiaxial.csv",
                                                 "fit-inflation.csv",
                                                 "fit-moduli.csv",
                                                 "fit-planar.csv",
                                                 "fit-relaxation.csv",
                                                 "fit-shear.csv",
                                                 "fit-uniaxial.csv",
                                                 "fit.csv",
                                                 "harmonic.csv",
                                                 "harmonics.csv",
                                                 "identification.csv",
                                                 "impedance.csv",
                                                 "inflation.csv",
                                                 "input",
                                                 "interpolated-response.csv",
                                                 "load-steps.csv",
                                                 "loaded-tube.csv",
                                                 "log.txt",
                                                 "mass.csv",
                                                 "material.prm",
                                                 "materials.prm",
                                                 "mean-power.csv",
                                                 "modes.csv",
                                                 "modulus.csv",
                                                 "network-elements.csv",
                                                 "network-vessels.csv",
                                                 "network.csv",
                                                 "other-files.txt",
                                                 "parameters.prm",
                                                 "planar.csv",
                                                 "plots",
                                                 "power.csv",
                                                 "probes.csv",
                                                 "profiles.csv",
                                                 "prony.csv",
                                                 "refinement.csv",
                                                 "relaxation-table.csv",
                                                 "relaxation.csv",
                                                 "report.html",
                                                 "residuals.csv",
                                                 "resonances.csv",
                                                 "response.csv",
                                                 "runs.csv",
                                                 "sensitivities.csv",
                                                 "shear-relaxation.csv",
                                                 "shear.csv",
                                                 "spin-coating.csv",
                                                 "stretch-relaxation.csv",
                                                 "summary.json",
                                                 "sweep.csv",
                                                 "synthetic.csv",
                                                 "transfer.csv",
                                                 "uniaxial.csv",
                                                 "view-in-paraview.py",
                                                 "wave-numbers.csv",
                                                 "wave.csv"};
  return names;
}

std::string output_file(const std::string &folder, const std::string &name)
{
  const std::vector<std::string> &names = output_files();
  AssertThrow(std::find(names.begin(), names.end(), name.substr(0, name.find('/'))) != names.end(),
              dealii::ExcMessage("A run writes '" + name +
                                 "', which is missing in the list of output_files.cc."));
  return folder + "/" + name;
}
} // namespace Continua
