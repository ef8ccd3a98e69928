#ifndef continua_base_archive_h
#define continua_base_archive_h

#include <cstddef>
#include <map>
#include <memory>
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
 * What all ranks have alike stands in the archive itself, of which one rank writes its copy; what
 * each has of its own stands in its piece, an archive in a file of its own.
 *
 * Format: 16 bytes of magic, the format's version, the records (type, length of the name, name,
 * length of the content in bytes, content), the checksum of all that. Whole numbers have 8 bytes in
 * the machine's byte order; a file from a machine with the other order is refused because its
 * format version does not read as one.
 */
class ArchiveWriter
{
public:
  ArchiveWriter();
  /// A name may be given to one record only.
  void add(const std::string &name, const std::string &text);
  void add(const std::string &name, const std::vector<double> &values);
  void add(const std::string &name, const std::vector<unsigned long> &values);
  void add(const std::string &name, double value);
  void add(const std::string &name, unsigned long value);
  /// What is this rank's alone.
  ArchiveWriter &piece();
  /// Writes the archive without the piece, and returns its checksum. Throws RunError when the disk
  /// refuses; an older file of this name is then kept.
  unsigned long write(const std::string &file) const;

private:
  void append(const std::string &name, char type, const void *data, std::size_t size);
  std::string bytes; ///< from the magic on, without the checksum
  std::set<std::string> names;
  std::unique_ptr<ArchiveWriter> own_piece;
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
  std::vector<unsigned long> integers(const std::string &name) const;
  double value(const std::string &name) const;
  unsigned long integer(const std::string &name) const;
  unsigned long checksum() const { return checksum_of_file; }

  /// Where the pieces of the ranks that wrote the archive are; each is read when it is first asked
  /// for.
  void set_pieces(const std::vector<std::string> &files);
  std::size_t n_pieces() const { return piece_files.size(); }
  const ArchiveReader &piece(std::size_t number) const;

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
  unsigned long checksum_of_file;
  std::map<std::string, Record> records;
  std::vector<std::string> piece_files;
  mutable std::vector<std::unique_ptr<ArchiveReader>> pieces;
};
} // namespace Continua

#endif
