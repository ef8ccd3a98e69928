#include <continua/base/child_process.h>
#include <continua/base/command_server.h>

#include <fcntl.h>
#include <poll.h>
#include <sys/signalfd.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <list>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace Continua
{
namespace
{
using Clock = std::chrono::steady_clock;
constexpr std::size_t n_streams = 3; ///< input, output, errors

/// A descriptor that is closed in the end.
class OwnedDescriptor
{
public:
  explicit OwnedDescriptor(const int number = -1) : number(number) {}
  OwnedDescriptor(OwnedDescriptor &&other) noexcept : number(std::exchange(other.number, -1)) {}
  OwnedDescriptor &operator=(OwnedDescriptor &&other) noexcept
  {
    std::swap(number, other.number);
    return *this;
  }
  OwnedDescriptor(const OwnedDescriptor &) = delete;
  OwnedDescriptor &operator=(const OwnedDescriptor &) = delete;
  ~OwnedDescriptor()
  {
    if (number >= 0)
      ::close(number);
  }
  operator int() const { return number; }

private:
  int number;
};

struct Request
{
  std::string folder;
  std::vector<std::string> arguments, environment;
  std::array<OwnedDescriptor, n_streams> streams;
};

/// A client, and the process of its command.
struct Client
{
  OwnedDescriptor connection;
  std::unique_ptr<ChildProcess> process;
};

[[noreturn]] void fail(const std::string &what)
{
  throw std::runtime_error(what + ": " + std::strerror(errno));
}

OwnedDescriptor listen_at(const std::string &file)
{
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  if (file.size() >= sizeof(address.sun_path))
    throw std::runtime_error("the name of the socket " + file + " is too long: it may have " +
                             std::to_string(sizeof(address.sun_path) - 1) + " letters");
  std::memcpy(address.sun_path, file.c_str(), file.size());
  OwnedDescriptor result(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  // For the user alone.
  const mode_t before = ::umask(0077);
  const int bound = ::bind(result, reinterpret_cast<const sockaddr *>(&address), sizeof(address));
  ::umask(before);
  if (bound != 0 || ::listen(result, SOMAXCONN) != 0)
    fail("the socket " + file + " cannot be made");
  return result;
}

void answer(const OwnedDescriptor &connection, const std::string &text)
{
  // A client that has gone is noticed elsewhere.
  (void)::send(connection, text.data(), text.size(), MSG_NOSIGNAL);
}

/// The texts of a message, each with a zero byte behind it.
std::vector<std::string> split(const std::vector<char> &message)
{
  std::vector<std::string> result;
  auto begin = message.begin();
  for (auto end = begin; end != message.end(); ++end)
    if (*end == '\0')
    {
      result.emplace_back(begin, end);
      begin = end + 1;
    }
  return result;
}

/// Throws std::runtime_error if the message is none.
Request receive(const OwnedDescriptor &connection)
{
  std::vector<char> message(std::size_t(1) << 20);
  iovec place = {message.data(), message.size()};
  std::array<char, CMSG_SPACE(n_streams * sizeof(int))> control = {};
  msghdr header = {};
  header.msg_iov = &place;
  header.msg_iovlen = 1;
  header.msg_control = control.data();
  header.msg_controllen = control.size();
  const ssize_t size = ::recvmsg(connection, &header, MSG_CMSG_CLOEXEC);
  Request request;
  const cmsghdr *const rights = size > 0 ? CMSG_FIRSTHDR(&header) : nullptr;
  if (rights == nullptr || rights->cmsg_type != SCM_RIGHTS ||
      rights->cmsg_len != CMSG_LEN(n_streams * sizeof(int)))
    throw std::runtime_error("a command comes with three descriptors");
  std::array<int, n_streams> numbers;
  std::memcpy(numbers.data(), CMSG_DATA(rights), sizeof(numbers));
  for (std::size_t i = 0; i < n_streams; ++i)
    request.streams[i] = OwnedDescriptor(numbers[i]);
  if ((header.msg_flags & (MSG_TRUNC | MSG_CTRUNC)) != 0)
    throw std::runtime_error("the command is longer than " + std::to_string(message.size()) +
                             " bytes");
  message.resize(static_cast<std::size_t>(size));
  const std::vector<std::string> texts = split(message);
  const std::size_t n_arguments =
      texts.size() < 2 ? 0 : std::strtoul(texts[1].c_str(), nullptr, 10);
  if (n_arguments == 0 || n_arguments > texts.size() - 2)
    throw std::runtime_error("a command is a folder, the number of arguments, and the arguments");
  const auto first = texts.begin() + 2, behind = first + static_cast<std::ptrdiff_t>(n_arguments);
  request.folder = texts[0];
  request.arguments.assign(first, behind);
  request.environment.assign(behind, texts.end());
  return request;
}

/// In the copy: takes on what the client has, and becomes the program.
int perform(Request &request, const CommandServer::Main &main)
{
  for (std::size_t i = 0; i < n_streams; ++i)
    if (::dup2(request.streams[i], static_cast<int>(i)) < 0)
      fail("a stream cannot be taken on");
  ::clearenv();
  for (std::string &entry : request.environment)
    ::putenv(entry.data()); // the texts live as long as the process
  if (::chdir(request.folder.c_str()) != 0)
    fail("the folder " + request.folder + " cannot be entered");
  std::vector<char *> arguments;
  arguments.reserve(request.arguments.size() + 1);
  for (std::string &argument : request.arguments)
    arguments.push_back(argument.data());
  arguments.push_back(nullptr);
  return main(static_cast<int>(request.arguments.size()), arguments.data());
}

void start(Client &client, const CommandServer::Main &main)
{
  try
  {
    auto request = std::make_unique<Request>(receive(client.connection));
    client.process = std::make_unique<ChildProcess>(
        [&request, &main]
        {
          // It is never deleted: the environment of the copy is made of it.
          return perform(*request.release(), main);
        });
    answer(client.connection, "started");
  }
  catch (const std::exception &error)
  {
    answer(client.connection, std::string("error: ") + error.what());
  }
}

/// Whether there is nothing more to be done for the client.
bool is_done(Client &client)
{
  if (client.process == nullptr)
    return true;
  const auto end = client.process->end();
  if (end)
    answer(client.connection, "ended " + std::to_string(end->exit_status()) + " " +
                                  std::to_string(end->user_time) + " " +
                                  std::to_string(end->system_time));
  return end.has_value();
}

bool is_of_this_user(const OwnedDescriptor &connection)
{
  ucred peer = {};
  socklen_t size = sizeof(peer);
  return ::getsockopt(connection, SOL_SOCKET, SO_PEERCRED, &peer, &size) == 0 &&
         peer.uid == ::geteuid();
}

/// Becomes readable when a child ends.
OwnedDescriptor watch_children()
{
  sigset_t ends;
  ::sigemptyset(&ends);
  ::sigaddset(&ends, SIGCHLD);
  ::sigprocmask(SIG_BLOCK, &ends, nullptr);
  return OwnedDescriptor(::signalfd(-1, &ends, SFD_CLOEXEC | SFD_NONBLOCK));
}
} // namespace

CommandServer::CommandServer(std::string socket_file, Main main)
    : socket_file(std::move(socket_file)), main(std::move(main))
{
}

void CommandServer::serve(const double idle_time)
{
  const OwnedDescriptor ends = watch_children();
  OwnedDescriptor listener = listen_at(socket_file);
  std::list<Client> clients;
  Clock::time_point last = Clock::now();
  while (true)
  {
    std::vector<pollfd> watched = {{listener, POLLIN, 0}, {ends, POLLIN, 0}};
    for (const Client &client : clients)
      watched.push_back({client.connection, POLLIN, 0});
    ::poll(watched.data(), watched.size(), 1000);
    signalfd_siginfo ignored;
    while (::read(ends, &ignored, sizeof(ignored)) > 0)
      ;
    // In the order of `watched`. A client says nothing more until it goes.
    auto client = clients.begin();
    for (std::size_t i = 2; i < watched.size(); ++i)
    {
      const bool has_gone = watched[i].revents != 0;
      if (has_gone || is_done(*client))
        client = clients.erase(client);
      else
        ++client;
    }
    OwnedDescriptor connection(::accept4(listener, nullptr, nullptr, SOCK_CLOEXEC));
    if (connection >= 0 && is_of_this_user(connection))
    {
      clients.push_back({std::move(connection), nullptr});
      start(clients.back(), main);
      if (clients.back().process == nullptr)
        clients.pop_back();
    }
    if (!clients.empty())
      last = Clock::now();
    else if (std::chrono::duration<double>(Clock::now() - last).count() > idle_time)
      break;
  }
  // Whoever is waiting at the socket sees it closed before "started", and starts another server.
  ::unlink(socket_file.c_str());
}
} // namespace Continua
