#include <continua/base/message_passing.h>

#include <sched.h>
#include <unistd.h>

#include <array>
#include <cstdlib>

namespace Continua
{
namespace
{
/// What is there already is kept: the user may know better.
void set_default(const char *const name, const char *const value)
{
  ::setenv(name, value, 0);
}

bool is_set(const char *const name)
{
  return std::getenv(name) != nullptr;
}

bool has_launcher()
{
  // The last one is set in the scripts of a batch system, too.
  return is_launched_rank() || is_set("SLURM_PROCID");
}

/// Ranks on this machine; 1 if the launcher does not tell.
int n_local_ranks()
{
  const char *const text = std::getenv("OMPI_COMM_WORLD_LOCAL_SIZE");
  return text == nullptr ? 1 : std::atoi(text);
}

/// The cores that all ranks of this machine have together. A rank itself may be bound to one of
/// them; the launcher that started it is not.
int n_cores()
{
  cpu_set_t cores;
  if (::sched_getaffinity(::getppid(), sizeof(cores), &cores) == 0)
    return CPU_COUNT(&cores);
  return static_cast<int>(::sysconf(_SC_NPROCESSORS_ONLN));
}
} // namespace

void prepare_message_passing()
{
  if (!has_launcher())
  {
    set_default("OMPI_MCA_ess_singleton_isolated", "1");
    // All such processes of a user would share one folder, which each of them makes and removes:
    // of two that start at a time, one may fail.
    set_default("OMPI_MCA_orte_create_session_dirs", "0");
    // A single rank sends to itself at most.
    set_default("OMPI_MCA_pml", "ob1");
    set_default("OMPI_MCA_btl", "self");
    // It waits for nobody. Each look of MUMPS for messages would yield, also to work of low
    // priority: beside two such processes a run of 7 s took 72 s (Linux 6.18;
    // findings/mumps-solve-yields.sh).
    ::setenv("OMPI_MCA_mpi_yield_when_idle", "0", 1);
    // Which devices the machine has is of no use here.
    set_default("HWLOC_COMPONENTS", "-linuxio,-pci,-opencl,-cuda,-nvml,-gl");
  }
  else if (n_local_ranks() > n_cores())
    set_default("OMPI_MCA_mpi_yield_when_idle", "1");
}

bool is_launched_rank()
{
  return is_set("OMPI_COMM_WORLD_SIZE") || is_set("PMIX_RANK") || is_set("PMI_RANK") ||
         is_set("PMI_SIZE");
}

bool waiting_ranks_yield()
{
  const char *const text = std::getenv("OMPI_MCA_mpi_yield_when_idle");
  return text != nullptr && (std::string(text) == "1" || std::string(text) == "true");
}

bool is_of_launcher(const std::string &entry)
{
  static constexpr std::array<const char *, 15> prefixes = {
      {"OMPI_", "OPAL_", "ORTE_", "PRTE_", "PMIX_", "PMI_", "PMI2_", "MPI_", "MPIR_", "MPIEXEC_",
       "HYDRA_", "HYDI_", "I_MPI_", "MV2_", "SLURM_"}};
  for (const char *const prefix : prefixes)
    if (entry.compare(0, std::string(prefix).size(), prefix) == 0)
      return true;
  return false;
}
} // namespace Continua
