#ifndef continua_laboratory_material_fit_parameters_h
#define continua_laboratory_material_fit_parameters_h

#include <continua/base/parameter_section.h>
#include <continua/theory/bar_law.h>
#include <continua/theory/bar_record.h>

#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/// What the noise of a table is like.
enum class TableNoise
{
  relative, ///< a share of each value; of storage and loss modulus of the magnitude of both
  even      ///< the same in all rows
};

/// The section `Material fit`: tables of tests of a bar, and the law that is sought.
struct MaterialFitParameters
{
  /// That is asked for; null: the one with the least criterion.
  std::shared_ptr<const BarLaw> law;
  unsigned int n_branches = 0;    ///< of a Prony series; 0: by the criterion
  unsigned int most_branches = 8; ///< that are tried
  double poissons_ratio = 0.5;    ///< [1]
  double density = 1000.;         ///< of the material that is written [kg/m^3]
  TableNoise noise = TableNoise::relative;
  std::vector<BarRecord> records;      ///< one for each table
  std::vector<std::string> keys;       ///< of the tables, as many
  std::vector<std::size_t> n_left_out; ///< rows of each table that are not used

  /// Declares and reads, the tables included; throws InputError. Whether there is a table is for
  /// the analysis to check.
  void read(ParameterSection section);
  /// The number of values of all records.
  std::size_t n_values() const;

private:
  void read_relaxation(ParameterSection &section);
  void read_creep(ParameterSection &section);
  void read_moduli(ParameterSection &section);
  void take(const BarRecord &record, const std::string &key, std::size_t left_out);
};
} // namespace Continua

#endif
