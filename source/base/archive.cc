#include <continua/base/archive.h>
#include <continua/base/atomic_file.h>
#include <continua/base/input_error.h>

#include <deal.II/base/exceptions.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>

namespace Continua
{
namespace
{
const std::string magic = "Continua archive";
constexpr std::uint64_t format_version = 6;
constexpr std::size_t number_size = sizeof(std::uint64_t);

static_assert(sizeof(unsigned long) == number_size && sizeof(double) == number_size,
              "The archive keeps numbers in 8 bytes.");

enum Type : char
{
  text_record = 't',
  values_record = 'v',
  integers_record = 'n',
  value_record = 'd',
  integer_record = 'i'
};

std::string type_name(const char type)
{
  switch (type)
  {
  case text_record:
    return "a text";
  case values_record:
    return "a list of numbers";
  case integers_record:
    return "a list of whole numbers";
  case value_record:
    return "a number";
  default:
    return "a whole number";
  }
}

/// FNV-1a's step on words instead of bytes (a checkpoint may have 100 MB). Each step is a bijection
/// of the state, so that one damaged word always changes the result; the shift carries high bits to
/// the low ones.
std::uint64_t checksum(const char *data, const std::size_t size)
{
  std::uint64_t state = 0xcbf29ce484222325ULL ^ size;
  const auto step = [&state](const std::uint64_t word)
  {
    state = (state ^ word) * 0x100000001b3ULL;
    state ^= state >> 32;
  };
  std::size_t i = 0;
  for (; i + number_size <= size; i += number_size)
  {
    std::uint64_t word;
    std::memcpy(&word, data + i, number_size);
    step(word);
  }
  std::uint64_t rest = 0;
  if (i < size)
    std::memcpy(&rest, data + i, size - i);
  step(rest);
  return state;
}

void append_number(std::string &bytes, const std::uint64_t number)
{
  char buffer[number_size];
  std::memcpy(buffer, &number, number_size);
  bytes.append(buffer, number_size);
}

std::uint64_t read_number(const std::string &bytes, const std::size_t position)
{
  std::uint64_t number;
  std::memcpy(&number, bytes.data() + position, number_size);
  return number;
}
} // namespace

ArchiveWriter::ArchiveWriter() : bytes(magic)
{
  append_number(bytes, format_version);
}

ArchiveWriter &ArchiveWriter::piece()
{
  if (!own_piece)
    own_piece = std::make_unique<ArchiveWriter>();
  return *own_piece;
}

void ArchiveWriter::append(const std::string &name,
                           const char type,
                           const void *data,
                           const std::size_t size)
{
  AssertThrow(names.insert(name).second,
              dealii::ExcMessage("The archive has two records '" + name + "'."));
  bytes += type;
  append_number(bytes, name.size());
  bytes += name;
  append_number(bytes, size);
  if (size > 0)
    bytes.append(static_cast<const char *>(data), size);
}

void ArchiveWriter::add(const std::string &name, const std::string &text)
{
  append(name, text_record, text.data(), text.size());
}

void ArchiveWriter::add(const std::string &name, const std::vector<double> &values)
{
  append(name, values_record, values.data(), values.size() * sizeof(double));
}

void ArchiveWriter::add(const std::string &name, const std::vector<unsigned long> &values)
{
  append(name, integers_record, values.data(), values.size() * sizeof(unsigned long));
}

void ArchiveWriter::add(const std::string &name, const double value)
{
  append(name, value_record, &value, sizeof(double));
}

void ArchiveWriter::add(const std::string &name, const unsigned long value)
{
  append(name, integer_record, &value, sizeof(unsigned long));
}

unsigned long ArchiveWriter::write(const std::string &file) const
{
  const std::uint64_t sum = checksum(bytes.data(), bytes.size());
  std::string end;
  append_number(end, sum);
  // In two parts: a copy of a large state would double the memory.
  write_file_atomically(file, bytes, end);
  return sum;
}

ArchiveReader::ArchiveReader(const std::string &file) : file_name(file), checksum_of_file(0)
{
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream)
    throw RunError("cannot read '" + file + "': " + std::strerror(errno));
  const std::streamoff length = stream.tellg();
  // A folder opens like a file and has a length without meaning.
  if (length < 0 || !stream.seekg(0) || stream.peek() == std::ifstream::traits_type::eof())
    throw RunError("cannot read '" + file + "': it is empty or not a file");
  bytes.resize(static_cast<std::size_t>(length));
  if (!stream.read(&bytes[0], length))
    throw RunError("cannot read '" + file + "': the file is shorter than the system says");

  if (bytes.compare(0, magic.size(), magic) != 0)
    throw RunError("'" + file + "' is not an archive of Continua");
  if (bytes.size() < magic.size() + 2 * number_size)
    throw RunError("'" + file + "' is truncated");
  const std::uint64_t version = read_number(bytes, magic.size());
  if (version != format_version)
    throw RunError("'" + file + "' has archive format " + std::to_string(version) +
                   "; this program reads format " + std::to_string(format_version));
  const std::size_t end = bytes.size() - number_size;
  checksum_of_file = read_number(bytes, end);
  if (Continua::checksum(bytes.data(), end) != checksum_of_file)
    throw RunError("'" + file + "' is truncated or damaged: its checksum is wrong");

  std::size_t position = magic.size() + number_size;
  // The checksum holds, but a length that leads out of the file must not be followed all the same.
  const auto take_length = [&]() -> std::size_t
  {
    if (end - position < number_size)
      throw RunError("'" + file + "' is damaged: a record is cut short");
    const std::uint64_t n = read_number(bytes, position);
    position += number_size;
    if (n > end - position)
      throw RunError("'" + file + "' is damaged: a record is longer than the file");
    return n;
  };
  while (position < end)
  {
    const char type = bytes[position++];
    const std::size_t name_size = take_length();
    const std::string name = bytes.substr(position, name_size);
    position += name_size;
    const std::size_t size = take_length();
    records[name] = {type, position, size};
    position += size;
  }
}

bool ArchiveReader::has(const std::string &name) const
{
  return records.count(name) > 0;
}

const char *ArchiveReader::find(const std::string &name, const char type, std::size_t &size) const
{
  const auto record = records.find(name);
  if (record == records.end())
    throw RunError("'" + file_name + "' has no record '" + name + "'");
  if (record->second.type != type)
    throw RunError("'" + file_name + "': the record '" + name + "' is " +
                   type_name(record->second.type) + ", not " + type_name(type));
  size = record->second.size;
  if ((type == value_record || type == integer_record)     ? size != number_size
      : (type == values_record || type == integers_record) ? size % number_size != 0
                                                           : false)
    throw RunError("'" + file_name + "': the record '" + name + "' has a wrong length");
  return bytes.data() + record->second.begin;
}

std::string ArchiveReader::text(const std::string &name) const
{
  std::size_t size;
  const char *const data = find(name, text_record, size);
  return std::string(data, size);
}

std::vector<double> ArchiveReader::values(const std::string &name) const
{
  std::size_t size;
  const char *const data = find(name, values_record, size);
  std::vector<double> result(size / sizeof(double));
  if (size > 0)
    std::memcpy(result.data(), data, size);
  return result;
}

std::vector<unsigned long> ArchiveReader::integers(const std::string &name) const
{
  std::size_t size;
  const char *const data = find(name, integers_record, size);
  std::vector<unsigned long> result(size / sizeof(unsigned long));
  if (size > 0)
    std::memcpy(result.data(), data, size);
  return result;
}

double ArchiveReader::value(const std::string &name) const
{
  std::size_t size;
  double result;
  std::memcpy(&result, find(name, value_record, size), sizeof(double));
  return result;
}

unsigned long ArchiveReader::integer(const std::string &name) const
{
  std::size_t size;
  unsigned long result;
  std::memcpy(&result, find(name, integer_record, size), sizeof(unsigned long));
  return result;
}

void ArchiveReader::set_pieces(const std::vector<std::string> &files)
{
  piece_files = files;
  pieces.clear();
  pieces.resize(files.size());
}

const ArchiveReader &ArchiveReader::piece(const std::size_t number) const
{
  AssertIndexRange(number, pieces.size());
  if (!pieces[number])
    pieces[number] = std::make_unique<ArchiveReader>(piece_files[number]);
  return *pieces[number];
}
} // namespace Continua
