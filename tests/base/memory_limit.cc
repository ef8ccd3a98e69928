// The least of free memory and of the limits of control groups of both versions, from folders that
// look like /proc and /sys.

#include <continua/base/duration_text.h>
#include <continua/base/memory_limit.h>

#include <sys/resource.h>

#include "../unit_test.h"

#include <filesystem>
#include <fstream>

namespace test_of_memory_limit
{
namespace
{
using namespace Continua;

/// Writes a file below `root`, with its folders.
void put(const std::string &root, const std::string &file, const std::string &text)
{
  const std::filesystem::path path(root + file);
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path) << text;
}

void expect(const std::string &name,
            const std::string &root,
            const double bytes,
            const std::string &source)
{
  const MemoryLimit limit = memory_limit(root);
  check::relative(name, limit.bytes, bytes, 1e-12);
  check::equal(name + ": its source", limit.source, source);
}
} // namespace

UNIT_TEST(memory_limit)
{
  const std::string meminfo = "MemTotal: 9000000 kB\nMemFree: 1 kB\nMemAvailable:  8000000 kB\n";
  put("free", "/proc/meminfo", meminfo);
  expect("no limit", "free", 8.192e9, "free memory");

  put("second", "/proc/meminfo", meminfo);
  put("second", "/proc/self/cgroup", "0::/job/step\n");
  put("second", "/sys/fs/cgroup/job/step/memory.max", "max\n");
  put("second", "/sys/fs/cgroup/job/step/memory.current", "100000000\n");
  expect("version 2, without a limit", "second", 8.192e9, "free memory");
  // The group around it has one; what the kernel keeps of files it gives back.
  put("second", "/sys/fs/cgroup/job/memory.max", "4000000000\n");
  put("second", "/sys/fs/cgroup/job/memory.current", "1000000000\n");
  expect("version 2, the group around it", "second", 3e9, "the limit of the container");
  put("second", "/sys/fs/cgroup/job/memory.stat",
      "anon 600000000\ninactive_file 400000000\nfile 400000000\n");
  expect("version 2, with files in memory", "second", 3.4e9, "the limit of the container");

  put("first", "/proc/meminfo", meminfo);
  put("first", "/proc/self/cgroup", "12:cpu,cpuacct:/x\n4:memory:/docker/abc\n0::/\n");
  put("first", "/sys/fs/cgroup/memory/docker/abc/memory.limit_in_bytes", "2000000000\n");
  put("first", "/sys/fs/cgroup/memory/docker/abc/memory.usage_in_bytes", "500000000\n");
  put("first", "/sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");
  put("first", "/sys/fs/cgroup/memory/memory.usage_in_bytes", "500000000\n");
  expect("version 1", "first", 1.5e9, "the limit of the container");
  put("first", "/sys/fs/cgroup/memory/docker/abc/memory.usage_in_bytes", "3000000000\n");
  expect("version 1, beyond it", "first", 0., "the limit of the container");

  check::is_true("this machine", memory_limit().bytes > 0. && memory_limit().bytes < 1e15);
  check::is_true("memory of this process", peak_memory() > 1e6 && peak_memory() < 1e11);
  rlimit limit;
  getrlimit(RLIMIT_AS, &limit);
  const rlimit before = limit;
  limit.rlim_cur = rlim_t(1) << 40;
  setrlimit(RLIMIT_AS, &limit);
  put("free", "/proc/meminfo", "MemAvailable: 4000000000 kB\n");
  put("free", "/proc/self/status", "VmSize: 1048576 kB\n");
  expect("address space", "free", 1099511627776. - 1073741824., "the limit of the process");
  setrlimit(RLIMIT_AS, &before);

  check::equal("megabytes", memory_text(180.4e6), "180 MB");
  check::equal("gigabytes", memory_text(12.34e9), "12.3 GB");
  check::equal("little", memory_text(1.), "1 MB");
  check::equal("seconds", duration_text(12.4), "12 s");
  check::equal("minutes", duration_text(200.), "3 min 20 s");
  check::equal("hours", duration_text(3721.), "1 h 02 min");
}
} // namespace test_of_memory_limit
