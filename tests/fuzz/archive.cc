// Archives of checkpoints: refused with a RunError, or read record by record. The checksum of most
// inputs is made right: no fuzzer would find it, and a forged file has it.

#include <continua/base/archive.h>
#include <continua/base/input_error.h>

#include "input_file.h"

#include <cstring>
#include <fstream>
#include <sstream>

using namespace Continua;

namespace
{
constexpr std::size_t word = sizeof(std::uint64_t);

/// As the writer computes it; see beginning().
std::string checksum(const std::string &bytes)
{
  std::uint64_t state = 0xcbf29ce484222325ULL ^ bytes.size();
  std::string padded = bytes;
  padded.resize(bytes.size() / word * word + word);
  for (std::size_t i = 0; i < padded.size(); i += word)
  {
    std::uint64_t number;
    std::memcpy(&number, padded.data() + i, word);
    state = (state ^ number) * 0x100000001b3ULL;
    state ^= state >> 32;
  }
  return std::string(reinterpret_cast<const char *>(&state), word);
}

/// What every archive begins with. Ends the program if the checksum above is no longer the
/// writer's: the inputs would all be refused at the door.
std::string beginning()
{
  const std::string file = Fuzz::input_file("", "empty");
  ArchiveWriter().write(file);
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  const std::string bytes = text.str();
  Fuzz::require(bytes.size() > 2 * word, "an empty archive has nothing");
  const std::string head = bytes.substr(0, bytes.size() - word);
  Fuzz::require(checksum(head) == bytes.substr(head.size()),
                "the checksum is another: bring it up to date here");
  return head;
}

/// Reads every record that the archive may have, as what it may be.
void read(const ArchiveReader &archive, const std::string &name)
{
  archive.has(name);
  const auto attempt = [](const auto &function)
  {
    try
    {
      function();
    }
    catch (const RunError &)
    {
    }
  };
  attempt([&]() { archive.text(name); });
  attempt([&]() { archive.values(name); });
  attempt([&]() { archive.integers(name); });
  attempt([&]() { archive.value(name); });
  attempt([&]() { archive.integer(name); });
}
} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, const std::size_t size)
{
  static const std::string head = beginning();
  if (size == 0)
    return 0;
  const std::string input(reinterpret_cast<const char *>(data) + 1, size - 1);
  std::string content = input;
  if (data[0] % 8 != 0)
  {
    content = head + input;
    content += checksum(content);
  }
  try
  {
    const ArchiveReader archive(Fuzz::input_file(content, "archive"));
    for (const char *const name : {"", "a", "time", "identity", "checksums of the pieces"})
      read(archive, name);
  }
  catch (const RunError &)
  {
  }
  return 0;
}
