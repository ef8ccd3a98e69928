#!/usr/bin/env bash
# Library:  Open MPI (singletons: programs that start without mpirun)
# Version:  Debian 12: openmpi-bin, libopenmpi-dev 4.1.4
# Sentence: With OMPI_MCA_ess_singleton_isolated=1 all programs of a user share one session folder, and the first that ends removes it.
#
# Guessed:  The variable only leaves out the daemon that Open MPI 4 starts for a program without mpirun. Several such programs run beside
#           each other as before, each with a session folder of its own.
# Seen:     All have the job number 0, and so the same folder ompi.HOST.USER/jf.0/1/0. Each makes the folder in MPI_Init and removes it in
#           MPI_Finalize. The first that ends takes the folder of the others away. A program that starts in this moment fails in MPI_Init:
#           "A call to mkdir was unable to create the desired directory" (4 of some 600 short runs, two at a time).
# Output:   folders of a waiting program, before and after another one has started and ended:
#               isolated                    before 1  after 0
#               isolated, no session folder before 0  after 0
#               with the daemon             before 2  after 3 (with those of the daemons; the waiting program's stays)
# Matters:  Sweeps and test suites set the variable, since it saves 0.4 s of each start. Then a run fails now and then, for no reason of
#           its own, and passes when it is repeated.
# To do:    Set OMPI_MCA_orte_create_session_dirs=0 beside it, as Continua does.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../scripts/lib/findings.sh"
need_installed libopenmpi-dev 4.1.4

cat >wait.c <<'END'
#include <mpi.h>
#include <stdio.h>
#include <unistd.h>

/* With an argument: waits until the file of this name is there. */
int main(int argc, char **argv)
{
  MPI_Init(NULL, NULL);
  if (argc > 1)
  {
    fclose(fopen("started", "w"));
    for (int i = 0; i < 600 && access(argv[1], F_OK) != 0; ++i)
      usleep(100000);
  }
  MPI_Finalize();
  return 0;
}
END
mpicc -o wait wait.c

# Session folders of one process each that are in the folder of this test.
count() { find sessions -mindepth 4 -maxdepth 4 -type d | wc -l; }

# "before N  after M": folders while one program waits, before and after another one has run.
observe() {
  local before after
  rm -rf sessions started go
  mkdir sessions
  env "$@" OMPI_MCA_orte_tmpdir_base="$folder/sessions" ./wait go &
  while [ ! -e started ]; do sleep 0.1; done
  before=$(count)
  env "$@" OMPI_MCA_orte_tmpdir_base="$folder/sessions" ./wait
  after=$(count)
  touch go
  wait
  printf 'before %s  after %s' "$before" "$after"
}

decide() {
  local isolated none daemon
  isolated=$(observe OMPI_MCA_ess_singleton_isolated=1)
  none=$(observe OMPI_MCA_ess_singleton_isolated=1 OMPI_MCA_orte_create_session_dirs=0)
  daemon=$(observe OMPI_MCA_btl=self)
  say "isolated                    $isolated"
  say "isolated, no session folder $none"
  say "with the daemon             $daemon"
  [ "$isolated" = "before 1  after 0" ] && [ "$none" = "before 0  after 0" ] && [ "$daemon" = "before 2  after 3" ] || return 3
}
judge decide
