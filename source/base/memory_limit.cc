#include <continua/base/memory_limit.h>

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

namespace Continua
{
namespace
{
constexpr double infinite = std::numeric_limits<double>::infinity();

/// The number behind `key` in a file of lines "KEY NUMBER" or "KEY: NUMBER"; NaN if there is none.
double number_behind(const std::string &file, const std::string &key)
{
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);)
  {
    std::istringstream words(line);
    std::string word;
    double number = 0.;
    if (words >> word && (word == key || word == key + ":") && words >> number)
      return number;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// The only number of a file; infinite where it holds a word ("max") or is not there.
double number_in(const std::string &file)
{
  double number = 0.;
  return std::ifstream(file) >> number ? number : infinite;
}

/// What is left in a control group; infinite if it has no limit.
double left_in_group(const std::string &folder,
                     const std::string &limit,
                     const std::string &usage,
                     const std::string &cache)
{
  const double largest = number_in(folder + "/" + limit), used = number_in(folder + "/" + usage);
  // Version 1 writes "no limit" as a number near 2^63.
  if (!(largest < 1e18) || !std::isfinite(used))
    return infinite;
  const double kept_files = number_behind(folder + "/memory.stat", cache);
  return std::max(0., largest - used + (std::isfinite(kept_files) ? kept_files : 0.));
}

/// The least that is left in the groups of this process and in those around them.
double left_in_groups(const std::string &root)
{
  double left = infinite;
  std::ifstream groups(root + "/proc/self/cgroup");
  // NUMBER:CONTROLLERS:PATH; version 2 has no controllers.
  for (std::string line; std::getline(groups, line);)
  {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos)
      continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    std::string path = line.substr(second + 1);
    const bool is_second_version = controllers.empty();
    if (!is_second_version && controllers.find("memory") == std::string::npos)
      continue;
    const std::string mount = root + "/sys/fs/cgroup" + (is_second_version ? "" : "/memory");
    while (true)
    {
      const std::string folder = mount + (path == "/" ? "" : path);
      left = std::min(left,
                      is_second_version
                          ? left_in_group(folder, "memory.max", "memory.current", "inactive_file")
                          : left_in_group(folder, "memory.limit_in_bytes", "memory.usage_in_bytes",
                                          "total_inactive_file"));
      if (path.empty() || path == "/")
        break;
      path.erase(path.rfind('/') == std::string::npos ? 0 : path.rfind('/'));
    }
  }
  return left;
}

/// What is left of the address space of this process; infinite if it has no limit.
double left_of_address_space(const std::string &root)
{
  rlimit limit;
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
    return infinite;
  const double used = 1024. * number_behind(root + "/proc/self/status", "VmSize");
  return std::max(0., static_cast<double>(limit.rlim_cur) - (std::isfinite(used) ? used : 0.));
}
} // namespace

MemoryLimit memory_limit(const std::string &root)
{
  MemoryLimit limit{infinite, "free memory"};
  const double available = number_behind(root + "/proc/meminfo", "MemAvailable");
  if (std::isfinite(available))
    limit.bytes = 1024. * available;
  const auto take = [&limit](const double bytes, const std::string &source)
  {
    if (bytes < limit.bytes)
      limit = {bytes, source};
  };
  take(left_in_groups(root), "the limit of the container");
  take(left_of_address_space(root), "the limit of the process");
  return limit;
}

double peak_memory()
{
  rusage usage;
  return getrusage(RUSAGE_SELF, &usage) == 0 ? 1024. * static_cast<double>(usage.ru_maxrss) : 0.;
}

std::string memory_text(const double bytes)
{
  std::ostringstream text;
  text.precision(3);
  if (bytes < 0.9995e9)
    text << std::max(1., std::round(bytes / 1e6)) << " MB";
  else
    text << bytes / 1e9 << " GB";
  return text.str();
}
} // namespace Continua
