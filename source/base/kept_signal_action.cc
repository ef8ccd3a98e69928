#include <continua/base/kept_signal_action.h>

namespace Continua
{
KeptSignalAction::KeptSignalAction()
{
  sigset_t blocked;
  sigemptyset(&blocked);
  sigaddset(&blocked, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &blocked, &mask);
  sigaction(SIGTERM, nullptr, &action);
}

KeptSignalAction::~KeptSignalAction()
{
  sigaction(SIGTERM, &action, nullptr);
  pthread_sigmask(SIG_SETMASK, &mask, nullptr);
}
} // namespace Continua
