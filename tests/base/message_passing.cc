// What Open MPI is told before it starts: alone, by a launcher, with more ranks than cores, and
// that what the user has set stays.

#include <continua/base/child_process.h>
#include <continua/base/message_passing.h>

#include "../unit_test.h"

#include <sched.h>

#include <cstdlib>

namespace test_of_message_passing
{
using namespace Continua;

namespace
{
using Entries = std::vector<std::pair<std::string, std::string>>;

/// The value after prepare_message_passing() in an environment without MPI but for `entries`; "-":
/// it is not set.
std::string value_of(const char *const name, const Entries &entries)
{
  ::clearenv();
  for (const auto &[key, value] : entries)
    ::setenv(key.c_str(), value.c_str(), 1);
  prepare_message_passing();
  const char *const value = std::getenv(name);
  return value == nullptr ? "-" : value;
}

Entries launched(const int n_local_ranks)
{
  return {{"OMPI_COMM_WORLD_SIZE", "100000"},
          {"OMPI_COMM_WORLD_LOCAL_SIZE", std::to_string(n_local_ranks)}};
}
} // namespace

UNIT_TEST(message_passing)
{
  const char *const daemon = "OMPI_MCA_ess_singleton_isolated",
                    *const yields = "OMPI_MCA_mpi_yield_when_idle", *const layer = "OMPI_MCA_btl";
  check::equal("alone: no daemon", value_of(daemon, {}), "1");
  check::equal("alone: no folder that others share",
               value_of("OMPI_MCA_orte_create_session_dirs", {}), "0");
  check::equal("alone: no network", value_of(layer, {}), "self");
  check::equal("alone: nobody to yield to", value_of(yields, {}), "0");
  check::equal("alone: nobody to yield to, whatever is set", value_of(yields, {{yields, "1"}}),
               "0");
  check::equal("what the user has set stays", value_of(layer, {{layer, "self,tcp"}}), "self,tcp");
  check::equal("a batch system's process", value_of(daemon, {{"PMI_RANK", "0"}}), "-");

  // This process may use the cores of its parent at most.
  cpu_set_t cores;
  ::sched_getaffinity(0, sizeof(cores), &cores);
  const int n_cores = CPU_COUNT(&cores);
  check::equal("a rank", value_of(daemon, launched(n_cores)), "-");
  check::equal("a core for each rank", value_of(yields, launched(n_cores)), "-");
  check::equal("more ranks than cores", value_of(yields, launched(100000)), "1");
  check::is_true("they yield", waiting_ranks_yield());
  Entries own = launched(100000);
  own.emplace_back(yields, "0");
  check::equal("unless the user forbids it", value_of(yields, own), "0");
  check::is_true("they do not", !waiting_ranks_yield());
  // A rank that is bound to one core has the launcher's cores to share.
  cpu_set_t one;
  CPU_ZERO(&one);
  for (int core = 0; core < CPU_SETSIZE; ++core)
    if (CPU_ISSET(core, &cores) && CPU_COUNT(&one) == 0)
      CPU_SET(core, &one);
  ::sched_setaffinity(0, sizeof(one), &one);
  check::equal("a rank that is bound to a core", value_of(yields, launched(n_cores)), "-");

  check::is_true("entries of launchers",
                 is_of_launcher("PMIX_RANK=0") && is_of_launcher("SLURM_NTASKS=2") &&
                     !is_of_launcher("PATH=/usr/bin") && !is_of_launcher("MY_PMIX_RANK=0"));
}
} // namespace test_of_message_passing
