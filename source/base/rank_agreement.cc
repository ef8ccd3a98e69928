#include <continua/base/checksum.h>
#include <continua/base/collective.h>
#include <continua/base/input_error.h>
#include <continua/base/input_file.h>
#include <continua/base/lack_of_memory.h>
#include <continua/base/parameter_file.h>
#include <continua/base/rank_agreement.h>

#include <deal.II/base/mpi.h>

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <new>
#include <sstream>
#include <thread>

namespace Continua
{
namespace
{
using dealii::Utilities::MPI::n_mpi_processes;
using dealii::Utilities::MPI::this_mpi_process;

/// The communicator of the agreement that lives; null: there is none, or there is one rank alone.
MPI_Comm agreeing = MPI_COMM_NULL;

/// How long the others may take to come with the same error. Where all find it, some may still
/// write a summary.
constexpr std::chrono::seconds patience(5);

/// "rank 3 (on node12)".
std::string name_of_this_rank(const MPI_Comm communicator)
{
  char host[256] = "";
  ::gethostname(host, sizeof(host) - 1);
  return "rank " + std::to_string(this_mpi_process(communicator)) +
         (host[0] == '\0' ? "" : std::string(" (on ") + host + ")");
}

bool all_ranks_arrive(const MPI_Comm communicator)
{
  using Clock = std::chrono::steady_clock;
  // Of several ranks that wait in vain the first one speaks.
  const auto turn = std::chrono::milliseconds(100) * this_mpi_process(communicator);
  const Clock::time_point end = Clock::now() + patience + std::min<Clock::duration>(turn, patience);
  MPI_Request request;
  MPI_Ibarrier(communicator, &request);
  for (int done = 0; Clock::now() < end;)
  {
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (done != 0)
      return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

/// What this rank reads, in lines "NAME: CONTENT".
std::vector<std::pair<std::string, std::string>> input_of_this_rank(const ParameterFile &file)
{
  std::vector<std::pair<std::string, std::string>> input;
  for (const std::string &name : file.input_files())
  {
    const Checksum sum = Checksum::of_file(name);
    std::ostringstream text;
    text << sum.length() << " bytes with the checksum " << std::hex << sum.value();
    input.emplace_back(name, text.str());
  }
  return input;
}
} // namespace

RankAgreement::RankAgreement(const MPI_Comm communicator_) : communicator(MPI_COMM_NULL)
{
  if (n_mpi_processes(communicator_) == 1)
    return;
  MPI_Comm_dup(communicator_, &communicator);
  agreeing = communicator;
}

RankAgreement::~RankAgreement()
{
  agreeing = MPI_COMM_NULL;
  if (communicator != MPI_COMM_NULL)
    MPI_Comm_free(&communicator);
}

void RankAgreement::wait_for_all(const std::string &text, const int status)
{
  if (agreeing == MPI_COMM_NULL || all_ranks_arrive(agreeing))
    return;
  std::cerr << "error: " << printable(text) << "\nThis error is that of "
            << name_of_this_rank(agreeing) << " alone. It ends the other ranks, too." << std::endl;
  MPI_Abort(MPI_COMM_WORLD, status);
}

void RankAgreement::print_error(const std::string &text, const int status)
{
  wait_for_all(text, status);
  if (agreeing == MPI_COMM_NULL)
  {
    std::cerr << "error: " << printable(text) << std::endl;
    return;
  }
  const std::vector<std::string> texts = all_gather(agreeing, text),
                                 names = all_gather(agreeing, name_of_this_rank(agreeing));
  if (this_mpi_process(agreeing) == 0)
    for (std::size_t rank = 0; rank < texts.size(); ++rank)
      if (std::find(texts.begin(), texts.begin() + rank, texts[rank]) == texts.begin() + rank)
        std::cerr << "error" << (rank == 0 ? "" : " of " + names[rank]) << ": "
                  << printable(texts[rank]) << std::endl;
  // Nobody ends the others before the text is out.
  MPI_Barrier(agreeing);
}

std::string text_of_failure(const std::exception &error)
{
  if (dynamic_cast<const RunError *>(&error) != nullptr ||
      dynamic_cast<const InputError *>(&error) != nullptr)
    return error.what();
  if (dynamic_cast<const std::bad_alloc *>(&error) != nullptr)
    return lack_of_memory + " for this run. Take fewer cells or steps, or another machine.";
  // The rest are texts of libraries, and of parts of Continua that know of no run.
  return std::string("the run failed, and Continua has no better reason than the text below. If "
                     "the parameter file is right, please report it with this text.\n") +
         error.what();
}

void require_same_input(const ParameterFile &file, const MPI_Comm communicator)
{
  if (n_mpi_processes(communicator) == 1)
    return;
  const auto input = input_of_this_rank(file);
  std::string text;
  for (const auto &[name, content] : input)
    text += content + "\n";
  const std::vector<std::string> texts = all_gather(communicator, text),
                                 names = all_gather(communicator, name_of_this_rank(communicator));
  for (std::size_t rank = 1; rank < texts.size(); ++rank)
  {
    if (texts[rank] == texts[0])
      continue;
    std::istringstream of_first(texts[0]), of_other(texts[rank]);
    std::string first, other;
    std::size_t line = 0;
    while (std::getline(of_first, first) && std::getline(of_other, other) && first == other)
      ++line;
    throw InputError(
        {line < input.size() ? input[line].first : file.text().root().origin.file, 0}, "",
        names[rank] + " reads another content of the file than rank 0: " + other + " instead of " +
            first,
        "Give all machines the same files, and leave them as they are while the run starts");
  }
}
} // namespace Continua
