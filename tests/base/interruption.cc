// Signals ask for an end, also when they are repeated and when the watch is over.

#include <continua/base/interruption.h>

#include <deal.II/base/mpi.h>

#include "../unit_test.h"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>

namespace test_of_interruption
{
using namespace Continua;

namespace
{
/// How a process of its own ends that runs `function`: its exit status, or the number of the signal
/// that ended it as a negative number.
int end_of(const std::function<void()> &function)
{
  const pid_t process = fork();
  if (process == 0)
  {
    for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGXCPU, SIGUSR1})
      std::signal(signal, SIG_DFL);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    function();
    _exit(7);
  }
  int status = 0;
  waitpid(process, &status, 0);
  return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}
} // namespace

UNIT_TEST(interruption)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGXCPU, SIGUSR1})
  {
    const std::string name = SignalWatch::name(signal);
    check::is_true(name + " ends a program that does not watch",
                   end_of([signal]() { raise(signal); }) == -signal);
    const SignalWatch watch;
    check::is_true(name + ": none came", SignalWatch::pending() == 0);
    SignalWatch::stop_if_asked(MPI_COMM_WORLD, "nowhere");
    InterruptibleSetUp::end_of_phase(MPI_COMM_WORLD, "nothing");
    raise(signal);
    raise(signal);
    raise(SIGUSR1);
    check::is_true(name + " is noted", SignalWatch::pending() == signal);
    check::throws<Interrupted>(
        name + " stops", []() { SignalWatch::stop_if_asked(MPI_COMM_WORLD, "at t = 1 s"); },
        "interrupted by " + name + " at t = 1 s");
    InterruptibleSetUp::end_of_phase(MPI_COMM_WORLD, "a phase that is not of the set-up");
    {
      const InterruptibleSetUp set_up("begin anew");
      check::throws<Interrupted>(
          name + " stops the set-up",
          []() { InterruptibleSetUp::end_of_phase(MPI_COMM_WORLD, "the mesh"); },
          "interrupted by " + name + " in the set-up, after the mesh; begin anew");
    }
  }

  const auto twice = [](const int signal)
  {
    return end_of(
        [signal]()
        {
          const SignalWatch watch;
          raise(signal);
          sleep(2);
          raise(signal);
        });
  };
  check::is_true("SIGTERM again ends the program", twice(SIGTERM) == -SIGTERM);
  check::is_true("SIGUSR1 again does not", twice(SIGUSR1) == 7);
  check::is_true("SIGXCPU again does not", twice(SIGXCPU) == 7);
  check::is_true("SIGHUP again does not", twice(SIGHUP) == 7);
  check::is_true("SIGHUP after the watch, when a library put its action back",
                 end_of(
                     []()
                     {
                       {
                         const SignalWatch watch;
                         raise(SIGHUP);
                       }
                       std::signal(SIGHUP, SIG_DFL);
                       raise(SIGHUP);
                     }) == 7);
  const auto after = [](const int signal, const bool came_before, const unsigned int seconds)
  {
    return end_of(
        [&]()
        {
          {
            const SignalWatch watch;
            if (came_before)
              raise(signal);
          }
          sleep(seconds);
          raise(signal);
        });
  };
  check::is_true("after the watch SIGUSR1 does not end the program", after(SIGUSR1, true, 0) == 7);
  check::is_true("after the watch SIGHUP does not", after(SIGHUP, true, 0) == 7);
  check::is_true("after the watch SIGXCPU does not", after(SIGXCPU, true, 0) == 7);
  check::is_true("after the watch SIGTERM does not", after(SIGTERM, false, 0) == 7);
  check::is_true("after the watch SIGINT does not", after(SIGINT, false, 0) == 7);
  check::is_true("SIGTERM that is repeated at once does not", after(SIGTERM, true, 0) == 7);
  check::is_true("SIGTERM that is repeated later does", after(SIGTERM, true, 2) == -SIGTERM);

  // nohup
  check::is_true("SIGHUP that is ignored stays so", end_of(
                                                        []()
                                                        {
                                                          std::signal(SIGHUP, SIG_IGN);
                                                          const SignalWatch watch;
                                                          raise(SIGHUP);
                                                          _exit(SignalWatch::pending());
                                                        }) == 0);
}
} // namespace test_of_interruption
