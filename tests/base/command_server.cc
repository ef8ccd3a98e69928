// A server of commands: their streams, folder, environment and status come through; several at a
// time; a client that goes takes its command along; a server without work ends.

#include <continua/base/child_process.h>
#include <continua/base/command_server.h>
#include <continua/base/input_file.h>

#include "../unit_test.h"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace test_of_command_server
{
using namespace Continua;

namespace
{
/// What the server performs.
int perform(const int argc, char **argv)
{
  const std::string word = argc > 1 ? argv[1] : "";
  if (word == "say")
  {
    std::string line;
    std::getline(std::cin, line);
    const char *const name = std::getenv("NAME");
    std::cout << argc << " " << argv[2] << " " << line << " "
              << std::filesystem::current_path().filename().string() << " "
              << (name == nullptr ? "-" : name) << std::endl;
    std::cerr << "an error" << std::endl;
    return 3;
  }
  if (word == "sleep")
  {
    std::ofstream("sleeping") << ::getpid() << std::endl;
    ::sleep(100);
  }
  if (word == "end")
    ::raise(SIGTERM);
  if (word == "throw")
    throw std::runtime_error("wanted");
  return 0;
}

/// A connection of a client, to ask and to read the answers.
class Client
{
public:
  Client()
  {
    sockaddr_un address = {};
    address.sun_family = AF_UNIX;
    std::strcpy(address.sun_path, "socket");
    connection = ::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0);
    // The server may not listen yet.
    for (int i = 0; i < 1000; ++i)
    {
      if (::connect(connection, reinterpret_cast<sockaddr *>(&address), sizeof(address)) == 0)
        return;
      ::usleep(10000);
    }
  }
  ~Client() { ::close(connection); }
  Client(const Client &) = delete;
  Client &operator=(const Client &) = delete;

  void ask(const std::vector<std::string> &texts, const unsigned int n_streams = 3) const
  {
    std::string message;
    for (const std::string &text : texts)
      message += text + '\0';
    std::array<int, 3> streams = {{::open("input", O_RDONLY),
                                   ::open("output", O_CREAT | O_WRONLY | O_TRUNC, 0600),
                                   ::open("errors", O_CREAT | O_WRONLY | O_TRUNC, 0600)}};
    iovec place = {message.data(), message.size()};
    std::array<char, CMSG_SPACE(sizeof(streams))> control = {};
    msghdr header = {};
    header.msg_iov = &place;
    header.msg_iovlen = 1;
    if (n_streams > 0)
    {
      header.msg_control = control.data();
      header.msg_controllen = CMSG_SPACE(n_streams * sizeof(int));
      cmsghdr *const rights = CMSG_FIRSTHDR(&header);
      rights->cmsg_level = SOL_SOCKET;
      rights->cmsg_type = SCM_RIGHTS;
      rights->cmsg_len = CMSG_LEN(n_streams * sizeof(int));
      std::memcpy(CMSG_DATA(rights), streams.data(), n_streams * sizeof(int));
    }
    ::sendmsg(connection, &header, 0);
    for (const int stream : streams)
      ::close(stream);
  }
  /// Without the times.
  std::string answer() const
  {
    std::array<char, 1000> text = {};
    const ssize_t size = ::recv(connection, text.data(), text.size(), 0);
    const std::string all(text.data(), size > 0 ? static_cast<std::size_t>(size) : 0);
    std::istringstream words(all);
    std::string word, status;
    words >> word >> status;
    return word == "ended" ? word + " " + status : all;
  }
  std::string answers(const std::vector<std::string> &texts) const
  {
    ask(texts);
    const std::string first = answer();
    return first == "started" ? answer() : first;
  }

private:
  int connection;
};

bool appears(const std::string &file)
{
  for (int i = 0; i < 1000 && !std::filesystem::exists(file); ++i)
    ::usleep(10000);
  return std::filesystem::exists(file);
}
} // namespace

UNIT_TEST(command_server)
{
  std::filesystem::create_directory("folder");
  std::ofstream("input") << "from input" << std::endl;
  const std::string here = std::filesystem::current_path().string();
  ChildProcess server(
      []
      {
        CommandServer("socket", perform).serve(1.);
        return 0;
      });

  check::equal(
      "status",
      Client().answers({here + "/folder", "3", "program", "say", "two words", "NAME=value"}),
      "ended 3");
  check::equal("output", read_input_file("output"), "3 two words from input folder value\n");
  check::equal("errors", read_input_file("errors"), "an error\n");
  struct stat status = {};
  ::stat("socket", &status);
  check::is_true("for the user alone", (status.st_mode & 0077) == 0);
  check::equal("signal", Client().answers({here, "2", "program", "end"}),
               "ended " + std::to_string(-SIGTERM));
  check::equal("exception", Client().answers({here, "2", "program", "throw"}), "ended 1");
  check::equal("its text", read_input_file("errors"), "error: wanted\n");
  check::equal("a folder that is not there",
               Client().answers({here + "/missing", "2", "program", "say"}), "ended 1");
  check::is_true("and its name",
                 read_input_file("errors").find("missing cannot be entered") != std::string::npos);
  check::is_true("no arguments",
                 check::matches(Client().answers({here, "0"}), "^error: a command is a folder"));
  check::is_true("fewer arguments than said",
                 check::matches(Client().answers({here, "3", "a"}), "^error: a command is"));
  {
    const Client client;
    client.ask({here, "2", "program", "say"}, 2);
    check::is_true("two descriptors",
                   check::matches(client.answer(), "^error: a command comes with three"));
  }

  std::string sleeping;
  {
    const Client slow;
    slow.ask({here, "2", "program", "sleep"});
    check::equal("a slow command", slow.answer(), "started");
    check::equal("another beside it", Client().answers({here, "2", "program", ""}), "ended 0");
    appears("sleeping");
    std::ifstream("sleeping") >> sleeping;
  }
  bool has_ended = false;
  for (int i = 0; i < 1000 && !has_ended; ++i)
  {
    has_ended = ::kill(std::stoi(sleeping), 0) != 0;
    ::usleep(10000);
  }
  check::is_true("a client that goes takes its command along", has_ended);
  check::is_true("the server ends without work", server.wait(60.).exit_status() == 0);
  check::is_true("and takes the socket along", !std::filesystem::exists("socket"));

  check::throws<std::runtime_error>(
      "a folder for the socket", [] { CommandServer("missing/socket", perform).serve(1.); },
      "the socket missing/socket cannot be made: No such file");
  check::throws<std::runtime_error>(
      "the length of its name", [] { CommandServer(std::string(200, 'a'), perform).serve(1.); },
      "too long");
}
} // namespace test_of_command_server
