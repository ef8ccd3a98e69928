#ifndef continua_laboratory_large_strain_tests_h
#define continua_laboratory_large_strain_tests_h

#include <continua/base/log.h>
#include <continua/base/output_directory.h>
#include <continua/base/summary.h>
#include <continua/base/table_writer.h>
#include <continua/laboratory/large_strain_parameters.h>
#include <continua/laboratory/strain_law_fit.h>
#include <continua/materials/material.h>
#include <continua/time_integration/time_control.h>

#include <mpi.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/**
 * Tests of a hyperelastic law at a point, without elements: curves of stress over stretch, the
 * inflation of a thin tube, relaxation at large strains, and the fit of the law's constants to
 * measured curves. Each writes a table NAME.csv and adds quantities of its name.
 */
class LargeStrainTests
{
public:
  /// `material`: a solid without viscosity; its springs that never relax have the law, the branches
  /// are Maxwell branches. All ranks compute the same, one writes. The references must outlive
  /// this.
  LargeStrainTests(const Material &material,
                   const StrainLawParameters &law,
                   const LargeStrainParameters &parameters,
                   const TimeParameters &time,
                   const OutputDirectory &directory,
                   MPI_Comm communicator,
                   Log &log,
                   Summary &summary);

  /// Fits the law to the tables, if there are any (fit-NAME.csv), and gives the material the shear
  /// modulus that was found; the ratio of shear and bulk modulus stays.
  void fit_tables(Material &fitted);
  /// Performs the tests, after fit_tables() with the law that was found.
  void perform(const std::vector<std::string> &tests);

  /// The names of what perform() adds to the summary.
  static void name_quantities(const StrainLawParameters &law,
                              const LargeStrainParameters &parameters,
                              const std::vector<std::string> &tests,
                              QuantityNames &names);

private:
  const Material &material;
  const LargeStrainParameters &parameters;
  const TimeParameters &time;
  const OutputDirectory &directory;
  const MPI_Comm communicator;
  const bool is_writer;
  Log &log;
  Summary &summary;
  StrainLawParameters law_parameters;
  double shear_modulus;        ///< of the springs that never relax [Pa]
  double inverse_bulk_modulus; ///< [1/Pa]

  /// Null on ranks that do not write.
  std::unique_ptr<TableWriter> table(const std::string &name,
                                     const std::vector<std::string> &header) const;
  std::unique_ptr<StrainLaw> law() const;
  /// The values [1] from `first` to `last` of a curve.
  std::vector<double> points(double first, double last) const;
  void fit();
  void curve(const std::string &name, HomogeneousTestType type);
  /// A load [Pa] at a stretch, and its derivative by the stretch [Pa].
  using LoadAndSlope = std::function<std::pair<double, double>(double)>;
  /// States the first extreme of the load on each side of no strain within the range of the
  /// stretches, as a line and as quantities; nothing where there is none.
  void state_limit_points(const std::string &test,
                          const std::string &load,
                          const LoadAndSlope &load_and_slope);
  void inflation();
  void relaxation(const std::string &name, HomogeneousTestType type, double held);
};
} // namespace Continua

#endif
