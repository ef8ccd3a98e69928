#ifndef continua_laboratory_material_fit_h
#define continua_laboratory_material_fit_h

#include <continua/analysis/analysis.h>
#include <continua/base/expected_value.h>
#include <continua/base/quantity_names.h>
#include <continua/laboratory/material_fit_parameters.h>
#include <continua/theory/bar_law_fit.h>

#include <string>
#include <vector>

namespace Continua
{
/**
 * `Analysis = material fit`: the law of a solid from tables of relaxation, creep, and storage and
 * loss modulus. All laws of BarLaw are fitted and compared by an information criterion; the chosen
 * one is written as a material that a parameter file can have (material.prm), with standard errors
 * and correlations (correlation.csv), beside the measured values (fit-relaxation.csv,
 * fit-creep.csv, fit-moduli.csv) and the Prony series of each number of branches (branches.csv).
 */
class MaterialFit : public Analysis
{
public:
  /// Throws InputError.
  explicit MaterialFit(const AnalysisInput &input);

private:
  MaterialFitParameters parameters;
  std::vector<ExpectedValue> expected;
  QuantityNames quantities; ///< that the analysis can state

  /// Every rank does it, and rank 0 writes.
  void compute(const OutputDirectory &directory, Log &log, Summary &summary) override;
  /// Of the section, by which the file asks for a law; "Branches" takes the Prony series.
  std::string key_of_choice() const;
  void check_law(const ParameterSection &section) const;
  void name_quantities();
  /// Of each law that the tables can tell; says which they cannot.
  std::vector<BarLawFit> fit_all(const std::vector<BarLawFit> &of_branches, Log &log) const;
  /// The one that the file asks for.
  BarLawFit chosen(const std::vector<BarLawFit> &of_branches,
                   const std::vector<BarLawFit> &all) const;
  void compare(const BarLawFit &chosen,
               const std::vector<BarLawFit> &all,
               Log &log,
               Summary &summary) const;
  void write(const OutputDirectory &directory,
             const BarLawFit &chosen,
             const std::vector<BarLawFit> &of_branches) const;
};
} // namespace Continua

#endif
