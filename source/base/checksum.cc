#include <continua/base/checksum.h>
#include <continua/base/input_error.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <vector>

namespace Continua
{
void Checksum::add(const char *const data, const std::size_t size)
{
  for (std::size_t i = 0; i < size; ++i)
    state = (state ^ static_cast<unsigned char>(data[i])) * 0x100000001b3ULL;
  n_bytes += size;
}

Checksum Checksum::of_file(const std::string &file, const unsigned long length)
{
  Checksum result;
  result.add_rest_of(file, length);
  return result;
}

void Checksum::add_rest_of(const std::string &file, const unsigned long length)
{
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    throw RunError("cannot read '" + file + "': " + std::strerror(errno));
  stream.seekg(static_cast<std::streamoff>(n_bytes));
  std::vector<char> buffer(1 << 16);
  while (stream && n_bytes < length)
  {
    const unsigned long rest = length - n_bytes;
    stream.read(buffer.data(),
                static_cast<std::streamsize>(std::min<unsigned long>(buffer.size(), rest)));
    add(buffer.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad())
    throw RunError("cannot read '" + file + "': " + std::strerror(errno != 0 ? errno : EIO));
}
} // namespace Continua
