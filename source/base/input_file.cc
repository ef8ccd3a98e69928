#include <continua/base/input_error.h>
#include <continua/base/input_file.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace Continua
{
namespace
{
constexpr std::size_t largest_input_file = std::size_t(1) << 32;

[[noreturn]] void
refuse_file(const std::string &kind, const std::string &path, const std::string &problem)
{
  throw std::invalid_argument("the " + kind + " '" + path + "' " + problem);
}

void refuse_all_but_regular(const std::string &kind, const std::string &path, const mode_t mode)
{
  if (S_ISREG(mode))
    return;
  if (S_ISDIR(mode))
    refuse_file(kind, path, "is a directory");
  refuse_file(kind, path,
              std::string(S_ISFIFO(mode)   ? "is a pipe"
                          : S_ISSOCK(mode) ? "is a socket"
                                           : "is a device") +
                  ", which can be read only once or has no end; Continua reads regular files");
}

/// A descriptor that is closed at the end.
struct OpenFile
{
  OpenFile(const std::string &kind, const std::string &path)
  {
    struct stat status = {};
    if (::stat(path.c_str(), &status) != 0)
      refuse_file(kind, path,
                  errno == ENOENT || errno == ENOTDIR
                      ? std::string("does not exist")
                      : std::string("cannot be read: ") + std::strerror(errno));
    refuse_all_but_regular(kind, path, status.st_mode);
    // Without waiting, should somebody exchange the file in between.
    descriptor = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0)
      refuse_file(kind, path, std::string("cannot be read: ") + std::strerror(errno));
    if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode))
    {
      ::close(descriptor);
      refuse_file(kind, path, "was exchanged for something else while it was opened");
    }
  }
  ~OpenFile() { ::close(descriptor); }
  OpenFile(const OpenFile &) = delete;
  OpenFile &operator=(const OpenFile &) = delete;

  int descriptor;
};

/// The number of bytes of the character that begins at `place`; 0 if they are no UTF-8 (RFC 3629).
std::size_t length_of_character(const std::string &text, const std::size_t place)
{
  const auto byte = [&](const std::size_t i)
  { return place + i < text.size() ? static_cast<unsigned char>(text[place + i]) : 0u; };
  const auto follows = [&](const std::size_t i) { return (byte(i) & 0xc0u) == 0x80u; };
  const unsigned int first = byte(0);
  if (first < 0x80)
    return 1;
  if (first >= 0xc2 && first <= 0xdf)
    return follows(1) ? 2 : 0;
  if (first >= 0xe0 && first <= 0xef)
  {
    // Neither a longer form than needed nor half of a pair of UTF-16.
    const bool second_is_right =
        follows(1) && (first != 0xe0 || byte(1) >= 0xa0) && (first != 0xed || byte(1) <= 0x9f);
    return second_is_right && follows(2) ? 3 : 0;
  }
  if (first >= 0xf0 && first <= 0xf4)
  {
    const bool second_is_right =
        follows(1) && (first != 0xf0 || byte(1) >= 0x90) && (first != 0xf4 || byte(1) <= 0x8f);
    return second_is_right && follows(2) && follows(3) ? 4 : 0;
  }
  return 0;
}

/// Whether a terminal obeys the character instead of showing it. `length`: its bytes.
bool is_control(const std::string &text, const std::size_t place, const std::size_t length)
{
  const unsigned int first = static_cast<unsigned char>(text[place]);
  if (length == 1)
    return (first < 0x20 && first != '\t') || first == 0x7f;
  // The second set of control characters, U+0080 to U+009F.
  return length == 2 && first == 0xc2 && static_cast<unsigned char>(text[place + 1]) < 0xa0;
}

/// "0x1b".
std::string hexadecimal(const char letter)
{
  const char *const digits = "0123456789abcdef";
  const auto byte = static_cast<unsigned char>(letter);
  return {'0', 'x', digits[byte / 16], digits[byte % 16]};
}

bool begins_with(const std::string &text, const std::string &beginning)
{
  return text.compare(0, beginning.size(), beginning) == 0;
}
} // namespace

void check_input_file(const std::string &path, const std::string &kind)
{
  const OpenFile file(kind, path);
}

std::string read_input_file(const std::string &path, const std::string &kind)
{
  const OpenFile file(kind, path);
  std::string text;
  std::vector<char> buffer(1 << 16);
  while (true)
  {
    const ssize_t n = ::read(file.descriptor, buffer.data(), buffer.size());
    if (n < 0 && errno == EINTR)
      continue;
    if (n < 0)
      refuse_file(kind, path,
                  "cannot be read beyond byte " + std::to_string(text.size()) + ": " +
                      std::strerror(errno));
    if (n == 0)
      return text;
    text.append(buffer.data(), static_cast<std::size_t>(n));
    if (text.size() > largest_input_file)
      refuse_file(kind, path, "is larger than 4 GiB, the largest input that Continua reads");
  }
}

std::vector<std::string> read_input_lines(const std::string &path, const std::string &kind)
{
  try
  {
    return lines_of_text(read_input_file(path, kind), path);
  }
  catch (const std::invalid_argument &problem)
  {
    throw InputError({path, 0}, "", problem.what(), "Check the path, and give a file of text");
  }
}

std::vector<std::string> lines_of_text(const std::string &text, const std::string &name)
{
  const std::string utf_16 = "Save it as UTF-8 (in Excel: 'CSV UTF-8')";
  if (begins_with(text, "\xff\xfe") || begins_with(text, "\xfe\xff"))
    throw InputError({name, 0}, "", "the file is in UTF-16 or UTF-32, not in UTF-8", utf_16);
  std::vector<std::string> lines;
  std::size_t begin = begins_with(text, "\xef\xbb\xbf") ? 3 : 0;
  while (begin < text.size())
  {
    std::size_t end = text.find_first_of("\r\n", begin);
    if (end == std::string::npos)
      end = text.size();
    lines.push_back(text.substr(begin, end - begin));
    const Origin here{name, static_cast<unsigned int>(lines.size())};
    if (lines.back().find('\0') != std::string::npos)
      throw InputError(here, "", "the line has the byte 0: the file is in UTF-16, or no text",
                       utf_16);
    const std::string problem = problem_of_text(lines.back());
    if (!problem.empty())
      throw InputError(here, "", "the line " + problem,
                       "Save the file as plain text in UTF-8, or write the line again");
    begin = end + (text.compare(end, 2, "\r\n") == 0 ? 2 : 1);
  }
  return lines;
}

std::string problem_of_text(const std::string &text)
{
  for (std::size_t place = 0; place < text.size();)
  {
    const std::size_t length = length_of_character(text, place);
    if (length == 0)
      return "has the byte " + hexadecimal(text[place]) + ", which is no UTF-8";
    if (is_control(text, place, length))
      return "has the control character " + hexadecimal(text[place + length - 1]);
    place += length;
  }
  return "";
}

std::string printable(const std::string &text)
{
  std::string shown;
  for (std::size_t place = 0; place < text.size();)
  {
    const std::size_t length = length_of_character(text, place);
    const bool is_shown = length > 0 && (text[place] == '\n' || !is_control(text, place, length));
    for (std::size_t i = 0; i < std::max<std::size_t>(length, 1); ++i, ++place)
      shown += is_shown ? std::string(1, text[place]) : "\\" + hexadecimal(text[place]).substr(1);
  }
  return shown;
}
} // namespace Continua
