#ifndef continua_base_archive_h
#define continua_base_archive_h

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace Continua
{
/**
 * A flat binary file of named records, written whole and atomically (temporary file, flush to disk,
 * rename) with a checksum; used for checkpoints. Numbers are kept bit by bit. Reading a damaged,
 * truncated or foreign file throws RunError with the reason.
 *
 * Format: 16 bytes of magic, the format's version, the records (type, length of the name, name,
 * length of the content in bytes, content), the checksum of all that. Whole numbers have 8 bytes in
 * the machine's byte order; a file from a machine with the other order is refused because its
 * format version does not read as one.
 */
class ArchiveWriter
{
public:
  /// A name may be given to one record only.
  void add(const std::string &name, const std::string &text);
  void add(const std::string &name, const std::vector<double> &values);
  void add(const std::string &name, double value);
  void add(const std::string &name, unsigned long value);
  /// Throws RunError when the disk refuses; an older file of this name is then kept.
  void write(const std::string &file) const;

private:
  void append(const std::string &name, char type, const void *data, std::size_t size);
  std::string bytes;
  std::set<std::string> names;
};

class ArchiveReader
{
public:
  /// Reads the whole file and verifies the checksum.
  explicit ArchiveReader(const std::string &file);
  bool has(const std::string &name) const;
  /// These throw RunError if there is no such record, or one of another type.
  std::string text(const std::string &name) const;
  std::vector<double> values(const std::string &name) const;
  double value(const std::string &name) const;
  unsigned long integer(const std::string &name) const;

private:
  struct Record
  {
    char type;
    std::size_t begin; ///< of the content, in `bytes`
    std::size_t size;  ///< of the content [bytes]
  };
  const char *find(const std::string &name, char type, std::size_t &size) const;
  std::string file_name;
  std::string bytes;
  std::map<std::string, Record> records;
};
} // namespace Continua

#endif
