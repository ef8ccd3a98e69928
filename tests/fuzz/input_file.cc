#include "input_file.h"

#include <stdlib.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace Fuzz
{
namespace
{
/// A folder in memory where there is one, and gone at the end.
struct Folder
{
  Folder()
  {
    const bool in_memory = std::filesystem::is_directory("/dev/shm");
    std::string name =
        (in_memory ? std::string("/dev/shm") : std::filesystem::temp_directory_path().string()) +
        "/continua-fuzz-XXXXXX";
    require(::mkdtemp(name.data()) != nullptr, "no folder can be made for the inputs");
    path = name;
  }
  ~Folder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
  std::string path;
};
} // namespace

std::string input_file(const std::string &content, const std::string &name)
{
  static const Folder folder;
  const std::string path = folder.path + "/" + name;
  std::ofstream stream(path, std::ios::binary | std::ios::trunc);
  stream << content;
  stream.close();
  require(static_cast<bool>(stream), "the input cannot be written to " + path);
  return path;
}

void require(const bool holds, const std::string &what)
{
  if (holds)
    return;
  std::fprintf(stderr, "finding: %s\n", what.c_str());
  std::abort();
}
} // namespace Fuzz
