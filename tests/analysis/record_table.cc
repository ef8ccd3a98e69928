// Which records a run has, at which of its states they look, and that the names of their quantities
// are those of the case.

#include "../parameter_text.h"
#include "column_text.h"

#include <continua/analysis/record_table.h>
#include <continua/program/analyses.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

#include "../unit_test.h"

namespace test_of_record_table
{
using namespace Continua;

namespace
{
std::string run_of_two_steps(const std::string &of_time, const std::string &more)
{
  return column_text::column("transient", "subsection Time\nset Time step = 1 ms\n"
                                          "set End time = 2 ms\n" +
                                              of_time + "end\n" + more);
}

/// The records of a case, and how many of them ask for the state after the first step.
void check_records(const std::string &name,
                   const std::string &text,
                   const unsigned int n_records,
                   const unsigned int n_due,
                   const std::vector<std::string> &quantities,
                   const std::vector<std::string> &no_quantities)
{
  ParameterFile file = parameters_of(text);
  const Case<2> input = analyses().read_case<2>(file, MPI_COMM_WORLD);
  const std::vector<ScheduledRecord<2>> records = make_records(input, "record_table");
  check::absolute(name + ": records", records.size(), n_records, 0.);
  check::absolute(name + ": ask for the first state",
                  std::count_if(records.begin(), records.end(),
                                [](const ScheduledRecord<2> &entry)
                                { return entry.schedule.due(1e-3, 1e-3); }),
                  n_due, 0.);
  QuantityNames names;
  name_quantities_of_records(input, names);
  for (const std::string &quantity : quantities)
    check::is_true(name + ": " + quantity,
                   names.has(quantity, "") && input.quantities.has(quantity, ""));
  for (const std::string &quantity : no_quantities)
    check::is_true(name + ": no " + quantity, !names.has(quantity, ""));
}
} // namespace

UNIT_TEST(record_table)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  // The powers at each step; fields at the end only.
  check_records("plain", run_of_two_steps("", ""), 4, 1, {"energy residual", "largest residual"},
                {"mesh changes", "smallest time step"});
  // A table of residuals, in which each step has rows.
  check_records("segregated loop",
                "set Discretisation = cell-wise\n" +
                    run_of_two_steps("", "subsection Cell-wise\nset Solution = segregated\n"
                                         "set Residual history = true\nend\n"),
                5, 2, {}, {});
  check_records("adaptive",
                run_of_two_steps("set Time step control = adaptive\n",
                                 "subsection Adaptivity\nset Every n steps = 10\nend\n"
                                 "subsection Output\nset Field interval = 1 ms\nend\n"),
                5, 2, {"mesh changes", "smallest time step"}, {});
}
} // namespace test_of_record_table
