#ifndef continua_laboratory_material_laboratory_h
#define continua_laboratory_material_laboratory_h

#include <continua/analysis/analysis.h>
#include <continua/base/log.h>
#include <continua/base/output_directory.h>
#include <continua/base/summary.h>
#include <continua/laboratory/laboratory_parameters.h>
#include <continua/materials/prony_series.h>
#include <continua/materials/relaxation_test.h>
#include <continua/materials/strain_law_parameters.h>

#include <string>
#include <vector>

namespace Continua
{
/**
 * `Analysis = material`: one solid of the section Materials without a body. Reports its complex
 * modulus over a band (modulus.csv), its mean modulus and its branches (prony.csv), for a power law
 * those that are fitted to it, beside a relaxation table the law found (relaxation-table.csv), and
 * simulates material tests with one element (LaboratoryTests), or those of a hyperelastic law at a
 * point (LargeStrainTests).
 */
class MaterialLaboratory : public Analysis
{
public:
  /// Throws InputError.
  explicit MaterialLaboratory(const AnalysisInput &input);

  QuantityNames quantity_names() const override { return quantities; }

private:
  std::string name; ///< of the material
  Material material;
  RelaxationTest table;           ///< of a power law, if it has one
  PronySeries series;             ///< of a power law
  StrainLawParameters strain_law; ///< of tests at large strains
  LaboratoryParameters laboratory;
  TimeParameters time;
  std::vector<ExpectedValue> expected;
  QuantityNames quantities; ///< that the laboratory can state

  /// On every rank alike; rank 0 of the communicator writes.
  void compute(const OutputDirectory &directory, Log &log, Summary &summary) override;
  bool is_power_law() const { return material.has_power_law(); }
  void read_material_of(ParameterSection materials);
  void read_strain_law(ParameterSection section);
  void check_loading_time(const ParameterSection &section) const;
  void fit(const ParameterSection &section);
  /// The names of what report() and the tests add.
  void name_quantities();
  void report(Log &log, Summary &summary) const;
  void write_modulus(const OutputDirectory &directory) const;
  void write_branches(const OutputDirectory &directory) const;
  void write_table(const OutputDirectory &directory) const;
  template <int dim>
  void simulate(const OutputDirectory &directory, Log &log, Summary &summary) const;
};
} // namespace Continua

#endif
