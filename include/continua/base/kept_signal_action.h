#ifndef continua_base_kept_signal_action_h
#define continua_base_kept_signal_action_h

#include <csignal>

namespace Continua
{
/**
 * Lets a library order a graph or a matrix without touching what SIGTERM does. METIS (5.1), which
 * UMFPACK, CHOLMOD, MUMPS and deal.II call, sets a handler of its own for this signal, and puts the
 * one before back by signal() of System V: that one then works a single time, and the next SIGTERM
 * ends the program. While one lives the signal waits, and at its end the action is what it was.
 * They may be nested. No class member throws.
 */
class KeptSignalAction
{
public:
  KeptSignalAction();
  ~KeptSignalAction();
  KeptSignalAction(const KeptSignalAction &) = delete;
  KeptSignalAction &operator=(const KeptSignalAction &) = delete;

private:
  struct sigaction action = {};
  sigset_t mask = {};
};
} // namespace Continua

#endif
