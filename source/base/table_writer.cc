#include <continua/base/atomic_file.h>
#include <continua/base/input_error.h>
#include <continua/base/table_writer.h>

#include <deal.II/base/exceptions.h>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>

namespace Continua
{
namespace
{
/// A name with a comma, a quote or a line break is put in quotes, its own quotes doubled (RFC
/// 4180). One that begins as a formula does in spreadsheets gets an apostrophe before it, which
/// they take for the sign of a text.
std::string quoted(const std::string &plain_name)
{
  const bool is_like_formula =
      !plain_name.empty() && std::string("=+-@\t\r").find(plain_name[0]) != std::string::npos;
  const std::string name = (is_like_formula ? "'" : "") + plain_name;
  if (name.find_first_of(",\"\r\n") == std::string::npos)
    return name;
  std::string result = "\"";
  for (const char c : name)
    result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + '"';
}

std::string header_line(const std::vector<std::string> &header)
{
  std::string line;
  for (const std::string &name : header)
    line += (line.empty() ? "" : ",") + quoted(name);
  return line;
}

void append_number(std::string &text, const double value)
{
  if (std::isnan(value))
  {
    text += "nan"; // without the sign that to_chars shows
    return;
  }
  char digits[32];
  const std::to_chars_result result = std::to_chars(digits, digits + sizeof(digits), value);
  text.append(digits, result.ptr);
}

void add_row(WrittenTable &table, const std::string &text, const double time)
{
  table.without_last_row = table.all;
  table.all.add(text);
  table.last_time = time;
}

/// The name of a file without its folder.
std::string name_of(const std::string &file)
{
  return std::filesystem::path(file).filename().string();
}

/// What of `file` to keep: the header and the complete rows up to `restart_time`.
WrittenTable part_to_keep(std::ifstream &stream,
                          const std::string &file,
                          const std::string &header,
                          const double restart_time)
{
  WrittenTable kept;
  std::string line;
  std::getline(stream, line);
  if (stream.eof() && header.compare(0, line.size(), line) == 0)
    return kept; // nothing but the beginning of the header
  if (line != header)
    throw RunError("cannot continue '" + file + "': its columns are '" + line +
                   "', those of this run are '" + header + "'");

  kept.all.add(line + '\n');
  // A time that was computed on another way may differ in its last digits.
  const double last_time = restart_time + 1e-12 * std::abs(restart_time);
  for (unsigned int number = 2; std::getline(stream, line) && !stream.eof(); ++number)
  {
    double time = 0.;
    const char *const end = line.data() + line.size();
    const std::from_chars_result result = std::from_chars(line.data(), end, time);
    if (result.ec != std::errc() || (result.ptr != end && *result.ptr != ','))
      throw RunError("cannot continue '" + file + "': row " + std::to_string(number) +
                     " does not begin with a number");
    if (!(time <= last_time))
      break;
    add_row(kept, line + '\n', time);
  }
  if (stream.bad())
    throw RunError("cannot continue '" + file + "': it cannot be read");
  return kept;
}
} // namespace

TableWriter::TableWriter(const std::string &file, const std::vector<std::string> &header)
    : file_name(file), n_columns(header.size()), last_flush(std::chrono::steady_clock::now())
{
  open(false);
  buffer = header_line(header) + '\n';
  start();
}

TableWriter::TableWriter(const std::string &file,
                         const std::vector<std::string> &header,
                         const double restart_time)
    : file_name(file), n_columns(header.size()), last_flush(std::chrono::steady_clock::now())
{
  std::error_code unknown;
  const bool is_there = std::filesystem::exists(file, unknown);
  if (is_there || unknown)
  {
    std::ifstream old_file(file, std::ios::binary);
    if (!old_file)
      throw RunError("cannot continue '" + file + "': it cannot be read");
    contents = part_to_keep(old_file, file, header_line(header), restart_time);
    old_file.close();
    std::error_code error;
    std::filesystem::resize_file(file, contents.all.length(), error);
    if (error)
      throw RunError("cannot cut '" + file + "': " + error.message());
  }
  open(true);
  if (contents.all.length() == 0)
    buffer = header_line(header) + '\n';
  start();
}

TableWriter::~TableWriter()
{
  try
  {
    flush();
  }
  catch (const RunError &)
  {
    // A destructor must not throw; flush() before it tells.
  }
}

void TableWriter::start()
{
  contents.name = name_of(file_name);
  contents.all.add(buffer);
  flush();
}

void TableWriter::open(const bool append)
{
  stream.open(file_name, std::ios::binary | (append ? std::ios::app : std::ios::trunc));
  if (!stream)
    throw RunError("cannot write '" + file_name + "': " + std::strerror(errno));
}

void TableWriter::row(const std::vector<double> &values)
{
  AssertThrow(values.size() == n_columns, dealii::ExcDimensionMismatch(values.size(), n_columns));
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (i > 0)
      text += ',';
    append_number(text, values[i]);
  }
  text += '\n';
  add_row(contents, text, values.empty() ? 0. : values.front());
  buffer += text;
  constexpr std::size_t large = 1 << 20;
  if (buffer.size() > large ||
      std::chrono::steady_clock::now() - last_flush >= std::chrono::seconds(1))
    flush();
}

void TableWriter::flush_to_disk()
{
  flush();
  Continua::flush_to_disk(file_name);
  if (!is_in_folder_on_disk)
    Continua::flush_to_disk(folder_of(file_name));
  is_in_folder_on_disk = true;
}

void TableWriter::flush()
{
  last_flush = std::chrono::steady_clock::now();
  errno = 0;
  stream.write(buffer.data(), static_cast<std::streamsize>(buffer.size()));
  stream.flush();
  buffer.clear();
  if (!stream)
    throw RunError("cannot write '" + file_name + "'" +
                   (errno != 0 ? std::string(": ") + std::strerror(errno) : std::string()));
}
} // namespace Continua
