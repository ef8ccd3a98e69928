/* Runs a test and keeps the processor time that it took: measured FILE COMMAND...

   FILE gets one line, "USER SYSTEM CLOCK" in seconds. A served command (served.c) is no child of the test: its client appends its times,
   "USER SYSTEM" a line, to the file CONTINUA_SERVED_TIMES. In C, since it starts 1400 times. */
#define _GNU_SOURCE
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

static double seconds(struct timeval time) { return (double)time.tv_sec + 1e-6 * (double)time.tv_usec; }

static double now(void)
{
  struct timespec time;
  clock_gettime(CLOCK_MONOTONIC, &time);
  return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

/* Makes the folders above a file. */
static void make_folders(const char *file)
{
  char path[4096];
  snprintf(path, sizeof(path), "%s", file);
  for (char *slash = strchr(path + 1, '/'); slash != NULL; slash = strchr(slash + 1, '/'))
  {
    *slash = '\0';
    mkdir(path, 0777);
    *slash = '/';
  }
}

int main(int argc, char **argv)
{
  if (argc < 3)
  {
    fprintf(stderr, "usage: measured FILE COMMAND...\n");
    return 2;
  }
  char served[4200];
  make_folders(argv[1]);
  snprintf(served, sizeof(served), "%s.served", argv[1]);
  FILE *const empty = fopen(served, "w");
  if (empty == NULL)
  {
    fprintf(stderr, "measured: %s: %s\n", served, strerror(errno));
    return 127;
  }
  fclose(empty);
  setenv("CONTINUA_SERVED_TIMES", served, 1);
  const double start = now();
  const pid_t process = fork();
  if (process == 0)
  {
    prctl(PR_SET_PDEATHSIG, SIGKILL); /* ctest kills what takes too long */
    execvp(argv[2], argv + 2);
    fprintf(stderr, "%s: %s\n", argv[2], strerror(errno));
    _exit(127);
  }
  int status = 0;
  while (process < 0 || waitpid(process, &status, 0) != process)
    if (process < 0 || errno != EINTR)
      return 127;
  struct rusage usage;
  getrusage(RUSAGE_CHILDREN, &usage);
  double user = seconds(usage.ru_utime), system = seconds(usage.ru_stime), more_user, more_system;
  FILE *const times = fopen(served, "r");
  if (times != NULL)
  {
    while (fscanf(times, "%lf %lf", &more_user, &more_system) == 2)
    {
      user += more_user;
      system += more_system;
    }
    fclose(times);
    remove(served);
  }
  FILE *const file = fopen(argv[1], "w");
  if (file != NULL)
  {
    fprintf(file, "%.3f %.3f %.3f\n", user, system, now() - start);
    fclose(file);
  }
  if (WIFSIGNALED(status))
  {
    fprintf(stderr, "ended by the signal %d\n", WTERMSIG(status));
    return 128 + WTERMSIG(status);
  }
  return WEXITSTATUS(status);
}
