#!/usr/bin/env bash
# Library:  METIS (orderings of sparse solvers, partitions of meshes)
# Version:  Debian 12: libmetis-dev 5.1.0
# Sentence: After METIS_NodeND or METIS_PartGraphKway a program's handler of SIGTERM works a single time.
#
# Guessed:  A library that orders a graph does not touch what signals do.
# Seen:     It sets handlers of its own for SIGTERM and SIGABRT, and puts those before back by signal() of System V. They get the
#           flag SA_RESETHAND and lose SA_RESTART: the handler works once, the next SIGTERM ends the program, and a system call that the
#           signal interrupts fails. UMFPACK and CHOLMOD call METIS for large matrices, so that nobody sees the call.
# Output:   flags of the handler of SIGTERM, and how often it has run of two signals:
#               before  restart yes  once no   ran 2 of 2
#               after   restart no   once yes  ran 1 of 1, the second signal ends the program
# Matters:  Batch systems send SIGTERM before they end a job, some twice. A program that then writes a checkpoint loses it.
# To do:    Block SIGTERM while the library works, and set the action again afterwards, as Continua does.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../scripts/lib/findings.sh"
need_installed libmetis-dev 5.1.0

cat >order.c <<'END'
#define _GNU_SOURCE
#include <metis.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static volatile sig_atomic_t n_signals = 0;
static void count(int number)
{
  (void)number;
  n_signals = n_signals + 1;
}

/* A chain of vertices. */
static void order(void)
{
  enum { n = 100 };
  idx_t size = n, starts[n + 1], neighbours[2 * n], order[n], inverse[n], k = 0;
  for (idx_t i = 0; i < n; ++i)
  {
    starts[i] = k;
    if (i > 0)
      neighbours[k++] = i - 1;
    if (i < n - 1)
      neighbours[k++] = i + 1;
  }
  starts[n] = k;
  if (METIS_NodeND(&size, starts, neighbours, NULL, NULL, order, inverse) != METIS_OK)
    exit(9);
}

static void set_handler(void)
{
  struct sigaction action;
  memset(&action, 0, sizeof(action));
  action.sa_handler = count;
  action.sa_flags = SA_RESTART;
  sigaction(SIGTERM, &action, NULL);
}

/* How often the handler runs of two signals; -1 if the second one ends the program. */
static int runs(void)
{
  fflush(stdout);
  const pid_t child = fork();
  if (child == 0)
  {
    raise(SIGTERM);
    raise(SIGTERM);
    _exit(n_signals);
  }
  int status;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status) ? -1 : WEXITSTATUS(status);
}

int main(int argc, char **argv)
{
  (void)argv;
  struct sigaction before, after, kept;
  set_handler();
  sigaction(SIGTERM, NULL, &before);
  const int runs_before = runs();
  order();
  sigaction(SIGTERM, NULL, &after);
  const int runs_after = runs();
  /* What helps. */
  sigset_t blocked, mask;
  sigemptyset(&blocked);
  sigaddset(&blocked, SIGTERM);
  set_handler();
  sigprocmask(SIG_BLOCK, &blocked, &mask);
  sigaction(SIGTERM, NULL, &kept);
  order();
  sigaction(SIGTERM, &kept, NULL);
  sigprocmask(SIG_SETMASK, &mask, NULL);
  const int runs_kept = runs();
  printf("before  restart %d  once %d  ran %d\n", (before.sa_flags & SA_RESTART) != 0, (before.sa_flags & SA_RESETHAND) != 0, runs_before);
  printf("after   restart %d  once %d  ran %d (-1: the second signal ends the program)\n", (after.sa_flags & SA_RESTART) != 0,
         (after.sa_flags & SA_RESETHAND) != 0, runs_after);
  printf("kept    ran %d\n", runs_kept);
  if (argc != 1 || runs_before != 2 || runs_kept != 2)
    return 9;
  return runs_after == -1 && (after.sa_flags & SA_RESETHAND) != 0 && (after.sa_flags & SA_RESTART) == 0 ? 0 : 3;
}
END
gcc -O1 -Wall -Wextra -o order order.c -lmetis
judge ./order
