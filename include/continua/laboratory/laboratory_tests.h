#ifndef continua_laboratory_laboratory_tests_h
#define continua_laboratory_laboratory_tests_h

#include <continua/base/output_directory.h>
#include <continua/base/summary.h>
#include <continua/base/table_writer.h>
#include <continua/laboratory/laboratory_parameters.h>
#include <continua/laboratory/laboratory_specimen.h>
#include <continua/theory/uniaxial_response.h>

#include <mpi.h>

#include <complex>
#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/**
 * The material tests, simulated with one element and compared with the exact answer of the
 * material's branches, and for a power law with that of the law itself. Each writes a table and
 * adds quantities of its name: differences are the largest over the test, over the largest
 * magnitude of the exact answer.
 */
template <int dim>
class LaboratoryTests
{
public:
  /// `material`: a solid with branches. All ranks simulate the same, one writes the tables. The
  /// references must outlive this.
  LaboratoryTests(const Material &material,
                  const LaboratoryParameters &parameters,
                  const TimeParameters &time,
                  const OutputDirectory &directory,
                  MPI_Comm communicator,
                  Log &log,
                  Summary &summary);

  /// relaxation.csv; of a power law also c and n as they are found from the simulated stress.
  void relaxation();
  /// creep.csv
  void creep();
  /// The names of what the tests that `parameters` ask for add to the summary.
  static void
  name_quantities(const LaboratoryParameters &parameters, bool is_power_law, QuantityNames &names);
  /// harmonic.csv with a row for each frequency, and harmonic-1.csv, ... with the loops.
  void harmonic();

private:
  using Specimen = LaboratorySpecimen<dim>;
  using Sample = typename Specimen::Sample;

  const Material &material;
  const LaboratoryParameters &parameters;
  const TimeParameters &time;
  const OutputDirectory &directory;
  const MPI_Comm communicator;
  const bool is_writer;
  Log &log;
  Summary &summary;
  const UniaxialResponse response;
  const PowerLawResponse law;
  const bool is_power_law;

  /// Throws Interrupted on all ranks if a signal asks for it.
  void stop_if_asked(const std::string &where) const;
  /// Null on ranks that do not write.
  std::unique_ptr<TableWriter> table(const std::string &file,
                                     const std::vector<std::string> &header) const;
  /// One frequency [Hz]; `row` gets what harmonic.csv has of it.
  void harmonic_test(double frequency, unsigned int number, std::vector<double> &row);
};
} // namespace Continua

#endif
