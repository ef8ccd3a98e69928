#ifndef continua_base_command_server_h
#define continua_base_command_server_h

#include <functional>
#include <string>

namespace Continua
{
/**
 * Keeps a program in memory and performs command lines that arrive at a socket, each in a copy of
 * the process. A copy takes some milliseconds; the start of a program that is linked with deal.II
 * takes half a second. For many short runs.
 *
 * The socket is a Unix socket of whole messages (SOCK_SEQPACKET), for the user alone. A client
 * sends one message: the working folder, the number of arguments, the arguments (the name of the
 * program first) and the entries of the environment, each text with a zero byte behind it; with it
 * (SCM_RIGHTS) three descriptors: standard input, standard output and standard error of the
 * command. The server answers "started" or "error: REASON", and at the end of the command "ended
 * STATUS USER SYSTEM": the exit status (negative: the number of the signal that ended it) and the
 * processor time [s]. If the client goes before, the command is killed.
 *
 * tests/served.c is a client.
 */
class CommandServer
{
public:
  /// What performs a command line, as main(): MPI is initialised in it, never before it.
  using Main = std::function<int(int argc, char **argv)>;

  CommandServer(std::string socket_file, Main main);
  /// Serves until no command has come for `idle_time` [s] and none is running. The socket must not
  /// exist; it is removed at the end. Throws std::runtime_error if the socket cannot be made.
  void serve(double idle_time);

private:
  const std::string socket_file;
  const Main main;
};
} // namespace Continua

#endif
