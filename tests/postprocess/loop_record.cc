// What is said of the loop of a solver, over a restart, and that a solver without one says nothing.

#include <continua/postprocess/loop_record.h>

#include "../unit_test.h"

#include <deal.II/base/mpi.h>

namespace test_of_loop_record
{
using namespace Continua;

namespace
{
double value(const Summary &summary, const std::string &name)
{
  for (const Quantity &quantity : summary.quantities())
    if (quantity.name == name)
      return quantity.value;
  return -1.;
}
} // namespace

UNIT_TEST(loop_record)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Log log(MPI_COMM_WORLD, false);
  {
    LoopRecord<2> none;
    none.take({}, 0.1, log);
    Summary summary;
    none.finish(summary);
    check::is_true("no loop", summary.quantities().empty());
  }
  LoopRecord<2> record;
  StepReport report;
  report.corrections = 4;
  report.residual = 2e-9;
  record.take(report, 0.1, log);
  report.corrections = 0;
  record.take(report, 0.2, log);
  check::is_true("no warning", log.warnings().empty());
  report.corrections = 50;
  report.residual = 3e-4;
  report.cap_reached = true;
  record.take(report, 0.3, log);
  check::equal("warning", log.warnings().at(0),
               "the loop of the step to t = 0.3 s ended at its cap of 50 corrections with a "
               "residual of 0.0003; the summary counts such steps, log.txt has them all");

  ArchiveWriter writer;
  record.save(writer);
  writer.write("loop-record-test.bin");
  LoopRecord<2> again;
  again.load(ArchiveReader("loop-record-test.bin"));
  again.take(report, 0.4, log);
  check::is_true("one warning for all", log.warnings().size() == 1);
  Summary summary;
  again.finish(summary);
  check::absolute("mean", value(summary, "corrections a step (mean)"), 26., 1e-14);
  check::absolute("maximum", value(summary, "corrections a step (maximum)"), 50., 0.);
  check::absolute("residual", value(summary, "largest residual"), 3e-4, 1e-19);
  check::absolute("steps at the cap", value(summary, "steps that reached the cap"), 2., 0.);
}
} // namespace test_of_loop_record
