#ifndef continua_base_memory_limit_h
#define continua_base_memory_limit_h

#include <string>

namespace Continua
{
/// What the processes of this user may still take on this machine.
struct MemoryLimit
{
  double bytes = 0.;  ///< infinite if nothing limits it
  std::string source; ///< "free memory", "the limit of the container", "the limit of the process"
};

/**
 * The smallest of the memory that the kernel can give without swapping (MemAvailable of
 * /proc/meminfo), of what is left of the limits of this process's control groups (of both versions;
 * files that the kernel keeps in memory count as free), and of the limit of the process's address
 * space (`ulimit -v`). `root`: the folder in which /proc and /sys stand; for tests.
 */
MemoryLimit memory_limit(const std::string &root = "");

/// The most memory that this process has held so far [bytes].
double peak_memory();

/// "12.3 GB", "180 MB".
std::string memory_text(double bytes);
} // namespace Continua

#endif
