#include <continua/base/collective.h>
#include <continua/base/input_error.h>
#include <continua/postprocess/writing_rank.h>

#include <deal.II/base/mpi.h>

#include <string>

namespace Continua
{
bool is_writing_rank(const MPI_Comm communicator)
{
  return dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
}

void on_writing_rank(const MPI_Comm communicator, const std::function<void()> &function)
{
  std::string problem;
  if (is_writing_rank(communicator))
    try
    {
      function();
    }
    catch (const RunError &error)
    {
      problem = error.what();
    }
  problem = broadcast(communicator, problem);
  if (!problem.empty())
    throw RunError(problem);
}
} // namespace Continua
