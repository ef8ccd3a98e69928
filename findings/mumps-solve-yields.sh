#!/usr/bin/env bash
# Library:  MUMPS on one rank, with Open MPI
# Version:  Debian 12: libmumps-dev 5.5.1, libopenmpi-dev 4.1.4
# Sentence: Each solve of MUMPS looks for messages thousands of times, on one rank too; with OMPI_MCA_mpi_yield_when_idle=1 each look gives the core away.
#
# Guessed:  mpi_yield_when_idle lets a rank that waits for others give its core away. A program on one rank waits for nobody, so the variable has
#           no effect on it.
# Seen:     A solve calls MPI_Iprobe thousands of times, also on one rank. A look that finds nothing calls sched_yield if the variable
#           is set. A process that yields so often runs only when no other process wants the core, not even one of low priority.
# Output:   calls of sched_yield in one solve, factor of a square grid of 100 x 100 points:
#               mpi_yield_when_idle=0     0
#               mpi_yield_when_idle=1  6740
# Matters:  People set the variable for runs with more ranks than cores, and leave it set. A run of Continua on one rank (a tube, 7 s) then took 72 s beside two
#           processes with nice 10 that used both cores (Linux 6.18).
# To do:    Set the variable to 0 for a program on one rank, as Continua does.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../scripts/lib/findings.sh"
need_installed libopenmpi-dev 4.1.4
need_installed libmumps-dev 5.5.1

cat >solve.c <<'END'
#include <mpi.h>
#include <dmumps_c.h>
#include <stdio.h>
#include <stdlib.h>

static long n_yields = 0;
int sched_yield(void)
{
  ++n_yields;
  return 0;
}

int main(void)
{
  const int m = 100, n = m * m;
  int *rows = malloc(3 * n * sizeof(int)), *columns = malloc(3 * n * sizeof(int)), entries = 0;
  double *values = malloc(3 * n * sizeof(double)), *x = malloc(n * sizeof(double));
  MPI_Init(NULL, NULL);
  for (int i = 0; i < n; ++i)
  {
    x[i] = 1.;
    rows[entries] = columns[entries] = i + 1;
    values[entries++] = 4.;
    if (i % m > 0)
    {
      rows[entries] = i + 1;
      columns[entries] = i;
      values[entries++] = -1.;
    }
    if (i >= m)
    {
      rows[entries] = i + 1;
      columns[entries] = i + 1 - m;
      values[entries++] = -1.;
    }
  }
  DMUMPS_STRUC_C id = {.job = -1, .par = 1, .sym = 2, .comm_fortran = -987654};
  dmumps_c(&id);
  id.n = n;
  id.nz = entries;
  id.irn = rows;
  id.jcn = columns;
  id.a = values;
  id.rhs = x;
  id.icntl[0] = id.icntl[1] = id.icntl[2] = id.icntl[3] = 0;
  id.icntl[6] = 0; /* AMD */
  id.job = 4;
  dmumps_c(&id);
  const long before = n_yields;
  id.job = 3;
  dmumps_c(&id);
  printf("%ld\n", id.infog[0] == 0 ? n_yields - before : -1);
  MPI_Finalize();
  return 0;
}
END
mpicc -rdynamic -o solve solve.c -ldmumps

yields() {
  env OMPI_MCA_ess_singleton_isolated=1 OMPI_MCA_orte_create_session_dirs=0 OMPI_MCA_pml=ob1 OMPI_MCA_btl=self OMPI_MCA_mpi_yield_when_idle="$1" ./solve
}

decide() {
  local off on
  off=$(yields 0)
  on=$(yields 1)
  say "calls of sched_yield in one solve: mpi_yield_when_idle=0 $off, =1 $on"
  [ "$off" -ge 0 ] && [ "$on" -ge 0 ] || return 2
  [ "$off" -eq 0 ] && [ "$on" -gt 1000 ] || return 3
}
judge decide
