#ifndef continua_base_archive_h
#define continua_base_archive_h

#include <string>
#include <vector>

namespace Continua
{
/**
 * A flat binary file of named records, written whole and atomically (temporary file, flush to disk, rename) with a
 * checksum; used for checkpoints. Numbers are kept bit by bit. Reading a damaged, truncated or foreign file throws
 * RunError with the reason.
 */
class ArchiveWriter
{
public:
  void add(const std::string &name, const std::string &text);
  void add(const std::string &name, const std::vector<double> &values);
  void add(const std::string &name, double value);
  void add(const std::string &name, unsigned long value);
  void write(const std::string &file) const;

private:
  std::string bytes;
};

class ArchiveReader
{
public:
  explicit ArchiveReader(const std::string &file);
  bool has(const std::string &name) const;
  std::string text(const std::string &name) const;
  std::vector<double> values(const std::string &name) const;
  double value(const std::string &name) const;
  unsigned long integer(const std::string &name) const;

private:
  const char *find(const std::string &name, char type, std::size_t &size) const;
  std::string file_name;
  std::string bytes;
};
} // namespace Continua

#endif
