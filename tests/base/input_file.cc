// Input files as bytes and as lines: what cannot be read is refused with its reason, and a read
// error is never the end of a file.

#include <continua/base/input_error.h>
#include <continua/base/input_file.h>

#include "../unit_test.h"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace test_of_input_file
{
using namespace Continua;

namespace
{
void refused(const std::string &name, const std::string &path, const std::string &pattern)
{
  for (const bool is_read : {false, true})
    check::throws<std::invalid_argument>(
        name + (is_read ? ", read" : ", looked at"),
        [&]
        {
          if (is_read)
            read_input_file(path);
          else
            check_input_file(path);
        },
        "^the file '.*' " + pattern);
}

void text_refused(const std::string &name, const std::string &text, const std::string &pattern)
{
  check::throws<InputError>(
      name, [&] { lines_of_text(text, "x.csv"); }, "^x.csv" + pattern);
}

std::string joined_lines(const std::string &text)
{
  std::string all;
  for (const std::string &line : lines_of_text(text, "x.csv"))
    all += "[" + line + "]";
  return all;
}
} // namespace

UNIT_TEST(input_file)
{
  const std::filesystem::path folder = "input-file-test";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  const std::string bytes("a\r\n\0\xff", 5);
  std::ofstream(folder / "bytes", std::ios::binary) << bytes;
  check::equal("every byte", read_input_file(folder / "bytes"), bytes);

  refused("missing", folder / "none", "does not exist");
  refused("missing folder", folder / "bytes" / "none", "does not exist");
  refused("folder", folder, "is a directory");
  refused("device without an end", "/dev/zero", "is a device");
  // A pipe without a writer would be waited for.
  ::mkfifo((folder / "pipe").c_str(), 0600);
  refused("pipe", folder / "pipe", "is a pipe");
  int ends[2];
  if (::pipe(ends) == 0)
    refused("pipe of a shell", "/dev/fd/" + std::to_string(ends[0]), "is a pipe");
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  (folder / "socket").string().copy(address.sun_path, sizeof(address.sun_path) - 1);
  const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
  ::bind(socket, reinterpret_cast<const sockaddr *>(&address), sizeof(address));
  refused("socket", folder / "socket", "is a socket");
  ::close(socket);
  // It can be opened, but page 0 of a process is never there.
  check::throws<std::invalid_argument>(
      "read error", [] { read_input_file("/proc/self/mem"); },
      "cannot be read beyond byte 0: Input/output error");
  check::throws<InputError>(
      "read error of lines", [] { read_input_lines("/proc/self/mem", "table"); },
      "^/proc/self/mem: the table .*Input/output error");

  check::equal("line feeds", joined_lines("a\n\nb\n"), "[a][][b]");
  check::equal("of Windows, without a last one", joined_lines("a\r\n\r\nb"), "[a][][b]");
  check::equal("carriage returns alone", joined_lines("a\r\rb\r"), "[a][][b]");
  check::equal("byte order mark",
               joined_lines("\xef\xbb\xbf"
                            "a\n"),
               "[a]");
  check::equal("empty", joined_lines(""), "");
  check::equal("letters of two, three and four bytes", joined_lines("\u00b5\u20ac\U0001f600\t"),
               "[\u00b5\u20ac\U0001f600\t]");
  check::equal("the last letters of two, three and four bytes",
               joined_lines("\u07ff\uffee\U0010fffd"), "[\u07ff\uffee\U0010fffd]");
  text_refused("UTF-16, little end first",
               std::string("\xff\xfe"
                           "a\0",
                           4),
               ": .*UTF-16.*UTF-8");
  text_refused("UTF-16, big end first", std::string("\xfe\xff\0a", 4), ": .*UTF-16");
  text_refused("UTF-16 without a mark", std::string("\na\0b\0", 5), ":2: .*byte 0.*UTF-16");
  text_refused("Latin-1", "a\nSchl\xe4uche\n", ":2: the line has the byte 0xe4, which is no UTF-8");
  text_refused("cut character", "\xe2\x82", ":1: .*0xe2.*no UTF-8");
  text_refused("longer form than needed", "\xc0\xaf", ":1: .*0xc0");
  text_refused("half of a pair", "\xed\xa0\x80", ":1: .*0xed");
  text_refused("beyond the last character", "\xf4\x90\x80\x80", ":1: .*0xf4");
  text_refused("escape", "a\rb\x1b[2J", ":2: .*control character 0x1b");
  text_refused("delete", "\x7f", ":1: .*control character 0x7f");
  text_refused("escape of eight bits", "\xc2\x9b", ":1: .*control character 0x9b");

  check::equal("printable", printable("a\x1b[2J\n\xe4\u00e4\t\x7f"),
               "a\\x1b[2J\n\\xe4\u00e4\t\\x7f");
  std::filesystem::remove_all(folder);
}
} // namespace test_of_input_file
