#ifndef continua_base_checksum_h
#define continua_base_checksum_h

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace Continua
{
/// A checksum of bytes that come one after the other, and their number: FNV-1a with 64 bits. A
/// changed byte always changes it.
class Checksum
{
public:
  void add(const char *data, std::size_t size);
  void add(const std::string &text) { add(text.data(), text.size()); }
  /// Adds what stands in a file behind as many bytes as were added before, but no more bytes than
  /// make `length` of them. Throws RunError with the system's reason if it cannot be read.
  void add_rest_of(const std::string &file,
                   unsigned long length = std::numeric_limits<unsigned long>::max());
  unsigned long value() const { return state; }
  /// How many bytes were added.
  unsigned long length() const { return n_bytes; }

  /// Of the first `length` bytes of a file, or of the whole file if it is shorter. Throws RunError
  /// as add_rest_of().
  static Checksum of_file(const std::string &file,
                          unsigned long length = std::numeric_limits<unsigned long>::max());

private:
  std::uint64_t state = 0xcbf29ce484222325ULL;
  unsigned long n_bytes = 0;
};
} // namespace Continua

#endif
