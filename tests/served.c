/* Runs a program in a copy of a process that has loaded it already: served PROGRAM [ARGUMENT]...

   The client of Continua's CommandServer (include/continua/base/command_server.h), which has the form of the messages. The start of a
   program that is linked with deal.II takes half a second of processor time, a copy takes some milliseconds. CONTINUA_SERVERS names the
   folder of the sockets. The first command of a program starts its server, which ends by itself when no command has come for a minute; a
   program that was built anew has another server. Under mpiexec each rank is such a copy. Ends with the exit status of the program, or by
   the signal that ended it. If CONTINUA_SERVED_TIMES names a file, the processor time is appended, "USER SYSTEM" [s]: the program is no
   child of this process. In C, since it starts thousands of times. */
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

extern char **environ;

static const int longest_start = 120; /* [s], beside other work */

static void fail(const char *text, ...)
{
  va_list arguments;
  va_start(arguments, text);
  fprintf(stderr, "served: ");
  vfprintf(stderr, text, arguments);
  fprintf(stderr, "\n");
  va_end(arguments);
  exit(125);
}

/* A name for the program as it is now. */
static void name_socket(const char *program, char *name, size_t size)
{
  struct stat status;
  char path[PATH_MAX], text[PATH_MAX + 200];
  if (realpath(program, path) == NULL || stat(path, &status) != 0)
    fail("%s: %s", program, strerror(errno));
  snprintf(text, sizeof(text), "%s %llu %lld %lld %ld", path, (unsigned long long)status.st_ino, (long long)status.st_size,
           (long long)status.st_mtim.tv_sec, status.st_mtim.tv_nsec);
  unsigned long long hash = 14695981039346656037ULL; /* FNV-1a */
  for (const char *c = text; *c != '\0'; ++c)
    hash = (hash ^ (unsigned char)*c) * 1099511628211ULL;
  snprintf(name, size, "%016llx", hash);
}

/* A connection to the socket, or -1. A path may be longer than sockets allow, a descriptor of its folder is short. */
static int connect_to(int folder, const char *name)
{
  struct sockaddr_un address = {.sun_family = AF_UNIX};
  snprintf(address.sun_path, sizeof(address.sun_path), "/proc/self/fd/%d/%s", folder, name);
  const int connection = socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0);
  if (connect(connection, (struct sockaddr *)&address, sizeof(address)) == 0)
    return connection;
  close(connection);
  return -1;
}

/* Starts the server unless another client has, and connects. */
static int start_server(const char *program, int folder, const char *name)
{
  char file[64];
  snprintf(file, sizeof(file), "%s.lock", name);
  const int lock = openat(folder, file, O_CREAT | O_RDWR | O_CLOEXEC, 0600);
  if (lock < 0 || flock(lock, LOCK_EX) != 0)
    fail("%s: %s", file, strerror(errno));
  int connection = connect_to(folder, name);
  if (connection < 0)
  {
    unlinkat(folder, name, 0);
    snprintf(file, sizeof(file), "%s.log", name);
    const int log = openat(folder, file, O_CREAT | O_WRONLY | O_APPEND | O_CLOEXEC, 0600);
    char path[PATH_MAX];
    if (realpath(program, path) == NULL)
      fail("%s: %s", program, strerror(errno));
    const pid_t server = fork();
    if (server == 0)
    {
      /* In a session of its own, and no child of MPI: it outlives the test that starts it. */
      setsid();
      for (char **entry = environ; *entry != NULL;)
        if (strncmp(*entry, "OMPI_COMM", 9) == 0 || strncmp(*entry, "PMIX", 4) == 0)
        {
          char key[200];
          snprintf(key, sizeof(key), "%.*s", (int)strcspn(*entry, "="), *entry);
          unsetenv(key);
        }
        else
          ++entry;
      const int nothing = open("/dev/null", O_RDWR);
      dup2(nothing, 0);
      dup2(log, 1);
      dup2(log, 2);
      if (fchdir(folder) == 0)
      {
        close_range(3, ~0U, 0);
        execl(path, path, "--serve", name, (char *)NULL);
      }
      _exit(127);
    }
    for (int i = 0; i < longest_start * 200 && connection < 0; ++i)
    {
      int status;
      if (waitpid(server, &status, WNOHANG) == server)
        fail("%s --serve ended with the status %d: see %s in CONTINUA_SERVERS", program, WEXITSTATUS(status), file);
      usleep(5000);
      connection = connect_to(folder, name);
    }
    if (connection < 0)
      fail("%s --serve did not start: see %s in CONTINUA_SERVERS", program, file);
  }
  close(lock);
  return connection;
}

/* Appends a text with the zero byte behind it. */
static void append(char **message, size_t *size, const char *text)
{
  const size_t length = strlen(text) + 1;
  *message = realloc(*message, *size + length);
  if (*message == NULL)
    fail("no memory");
  memcpy(*message + *size, text, length);
  *size += length;
}

/* Sends the command with the three streams of this process; whether it was taken. */
static int ask(int connection, char *message, size_t size)
{
  int streams[3] = {0, 1, 2};
  struct iovec place = {message, size};
  union
  {
    char bytes[CMSG_SPACE(sizeof(streams))];
    struct cmsghdr aligned;
  } control;
  memset(&control, 0, sizeof(control));
  struct msghdr header = {.msg_iov = &place, .msg_iovlen = 1, .msg_control = control.bytes, .msg_controllen = sizeof(control.bytes)};
  struct cmsghdr *rights = CMSG_FIRSTHDR(&header);
  rights->cmsg_level = SOL_SOCKET;
  rights->cmsg_type = SCM_RIGHTS;
  rights->cmsg_len = CMSG_LEN(sizeof(streams));
  memcpy(CMSG_DATA(rights), streams, sizeof(streams));
  if (sendmsg(connection, &header, MSG_NOSIGNAL) < 0)
  {
    if (errno == EMSGSIZE)
      fail("a command of %zu bytes is too long", size);
    return 0;
  }
  char answer[1000];
  const ssize_t length = recv(connection, answer, sizeof(answer) - 1, 0);
  if (length <= 0) /* it has just ended, since nothing had come for a while */
    return 0;
  answer[length] = '\0';
  if (strcmp(answer, "started") != 0)
    fail("%s", answer);
  return 1;
}

static void report(double user, double system)
{
  const char *file = getenv("CONTINUA_SERVED_TIMES");
  const int times = file == NULL ? -1 : open(file, O_WRONLY | O_APPEND | O_CLOEXEC);
  if (times < 0)
    return;
  dprintf(times, "%f %f\n", user, system);
  close(times);
}

int main(int argc, char **argv)
{
  const char *servers = getenv("CONTINUA_SERVERS");
  if (argc < 2 || servers == NULL)
    fail("usage: CONTINUA_SERVERS=FOLDER served PROGRAM [ARGUMENT]...");
  mkdir(servers, 0700);
  const int folder = open(servers, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0)
    fail("%s: %s", servers, strerror(errno));
  char name[32], number[20], here[PATH_MAX], *message = NULL;
  size_t size = 0;
  name_socket(argv[1], name, sizeof(name));
  append(&message, &size, getcwd(here, sizeof(here)) == NULL ? "." : here);
  snprintf(number, sizeof(number), "%d", argc - 1);
  append(&message, &size, number);
  for (int i = 1; i < argc; ++i)
    append(&message, &size, argv[i]);
  for (char **entry = environ; *entry != NULL; ++entry)
    append(&message, &size, *entry);

  int connection = -1;
  for (int i = 0; i < 3; ++i)
  {
    connection = connect_to(folder, name);
    if (connection < 0)
      connection = start_server(argv[1], folder, name);
    if (ask(connection, message, size))
      break;
    close(connection);
    connection = -1;
  }
  if (connection < 0)
    fail("no server of %s answers", argv[1]);

  char answer[1000];
  ssize_t length;
  do
    length = recv(connection, answer, sizeof(answer) - 1, 0);
  while (length < 0 && errno == EINTR);
  answer[length > 0 ? length : 0] = '\0';
  int status;
  double user, system;
  if (sscanf(answer, "ended %d %lf %lf", &status, &user, &system) != 3)
    fail("the server of %s ended while it was performing a command", argv[1]);
  report(user, system);
  if (status >= 0)
    return status;
  signal(-status, SIG_DFL);
  raise(-status);
  return 128 - status;
}
