/* Lets one operation on a file fail: a library to preload, which scripts/attack/run builds and uses (attack `files`).
 *
 * It has functions with the names of the C library's, counts those calls that touch a watched folder, and does something else
 * at one of them. Nothing outside of the watched folders is touched. Environment:
 *
 *   CONTINUA_FAULT_FOLDERS   NAME=/ABSOLUTE/PATH[:NAME=PATH]...: the folders; a file in one is called NAME/PATH WITHIN
 *   CONTINUA_FAULT_LOG       a line for each call that goes on is appended: operation, file, number among the calls of this
 *                            operation on this file, detail, parted by tabs; and a line `fault` for each that does not
 *   CONTINUA_FAULT           KIND OPERATION NUMBER FILE, parted by blanks: which call, and what happens; without it: only count
 *   CONTINUA_FAULT_SHADOW    folder: what a rename replaces and what is removed is kept there as a link, for the kind `power`
 *
 * Kinds:
 *
 *   once    the call fails
 *   ever    this call and every later one fail
 *   short   a write or read transfers half of its bytes and says so; this is no error
 *   cut     a write transfers half of its bytes; every later write and opening for writing finds a full disk
 *   kill    the process is killed by SIGKILL before the call
 *   half    the same after half of the bytes of a write
 *   power   as `kill`; what a loss of power leaves is made of it by the attack
 *
 * What libstdc++ does by fopen, write, writev and fclose, Open MPI by pwrite and p4est by fwrite is all covered. */
#define _GNU_SOURCE
#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

enum action { go_on, fail, half, half_then_kill };
enum nature { reads, writes, other };

struct fault {
  char kind[16], operation[24], file[PATH_MAX];
  long number;
};

static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
static pthread_once_t once = PTHREAD_ONCE_INIT;
static char folders[4 * PATH_MAX];
static struct fault the_fault;
static int has_fault, has_happened, log_descriptor = -1;
static const char *shadow;
static long n_shadows;

/* How often an operation was done on a file. */
struct counter {
  struct counter *next;
  long number;
  char key[];
};
static struct counter *counters;

static void start(void)
{
  const char *text = getenv("CONTINUA_FAULT_FOLDERS");
  if (text != NULL)
    snprintf(folders, sizeof folders, "%s", text);
  text = getenv("CONTINUA_FAULT");
  has_fault = text != NULL && sscanf(text, "%15s %23s %ld %4095[^\n]", the_fault.kind, the_fault.operation,
                                     &the_fault.number, the_fault.file) == 4;
  shadow = getenv("CONTINUA_FAULT_SHADOW");
  text = getenv("CONTINUA_FAULT_LOG");
  if (text != NULL)
    log_descriptor = (int)syscall(SYS_openat, AT_FDCWD, text, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
}

/* The path without double slashes, "." and "..". */
static void normalise(const char *path, char *result)
{
  char whole[2 * PATH_MAX];
  if (path[0] == '/')
    snprintf(whole, sizeof whole, "%s", path);
  else {
    char here[PATH_MAX] = "";
    if (getcwd(here, sizeof here) == NULL)
      here[0] = '\0';
    snprintf(whole, sizeof whole, "%s/%s", here, path);
  }
  size_t length = 0;
  char *rest = whole, *part;
  while ((part = strtok_r(rest, "/", &rest)) != NULL) {
    if (strcmp(part, ".") == 0)
      continue;
    if (strcmp(part, "..") == 0) {
      while (length > 0 && result[--length] != '/')
        ;
      continue;
    }
    const size_t n = strlen(part);
    if (length + n + 2 > PATH_MAX)
      break;
    result[length++] = '/';
    memcpy(result + length, part, n);
    length += n;
  }
  result[length] = '\0';
}

/* "NAME/PATH WITHIN" of a watched file; 0 for any other. */
static int watched(const char *path, char *name)
{
  pthread_once(&once, start);
  if (folders[0] == '\0' || path == NULL)
    return 0;
  char whole[PATH_MAX], list[sizeof folders];
  normalise(path, whole);
  memcpy(list, folders, sizeof list);
  char *rest = list, *folder;
  while ((folder = strtok_r(rest, ":", &rest)) != NULL) {
    char *const place = strchr(folder, '=');
    if (place == NULL)
      continue;
    *place = '\0';
    const size_t n = strlen(place + 1);
    if (strncmp(whole, place + 1, n) == 0 && (whole[n] == '/' || whole[n] == '\0')) {
      snprintf(name, PATH_MAX, "%s%s", folder, whole + n);
      return 1;
    }
  }
  return 0;
}

/* The path behind a descriptor; 0 if it is no file. */
static int path_of(const int descriptor, char *path)
{
  char link[64];
  snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
  const ssize_t n = readlink(link, path, PATH_MAX - 1);
  if (n <= 0 || path[0] != '/')
    return 0;
  path[n] = '\0';
  char *const end = strstr(path, " (deleted)");
  if (end != NULL && end[10] == '\0')
    *end = '\0';
  return 1;
}

static int path_at(const int folder, const char *path, char *result)
{
  if (path[0] == '/' || folder == AT_FDCWD) {
    snprintf(result, PATH_MAX, "%s", path);
    return 1;
  }
  char parent[PATH_MAX];
  if (!path_of(folder, parent))
    return 0;
  return snprintf(result, PATH_MAX, "%s/%s", parent, path) < PATH_MAX;
}

static long count(const char *operation, const char *file)
{
  char key[PATH_MAX + 32];
  snprintf(key, sizeof key, "%s %s", operation, file);
  for (struct counter *c = counters; c != NULL; c = c->next)
    if (strcmp(c->key, key) == 0)
      return ++c->number;
  struct counter *const c = malloc(sizeof *c + strlen(key) + 1);
  if (c == NULL)
    return 0;
  strcpy(c->key, key);
  c->number = 1;
  c->next = counters;
  counters = c;
  return 1;
}

static void write_log(const char *operation, const char *file, const long number, const char *detail)
{
  if (log_descriptor < 0)
    return;
  char line[2 * PATH_MAX];
  const int n = snprintf(line, sizeof line, "%s\t%s\t%ld\t%s\n", operation, file, number, detail);
  if (n > 0 && syscall(SYS_write, log_descriptor, line, (size_t)n) != n)
    abort();
}

static int error_of(const char *operation, const enum nature nature)
{
  if (strcmp(operation, "flock") == 0)
    return ENOLCK;
  if (strcmp(operation, "unlink") == 0 || strcmp(operation, "rmdir") == 0)
    return EACCES;
  return nature == writes && strcmp(operation, "fsync") != 0 && strcmp(operation, "close") != 0 ? ENOSPC : EIO;
}

static void die(void)
{
  syscall(SYS_kill, getpid(), SIGKILL);
  for (;;)
    pause();
}

/* Keeps what stands at the path as a link in the shadow folder; its number there, or -1. */
static long keep(const char *path)
{
  char kept[PATH_MAX];
  if (shadow == NULL || snprintf(kept, sizeof kept, "%s/%ld", shadow, n_shadows) >= PATH_MAX)
    return -1;
  return syscall(SYS_linkat, AT_FDCWD, path, AT_FDCWD, kept, 0) == 0 ? n_shadows++ : -1;
}

static enum action decide(const char *operation, const char *path, const enum nature nature, const char *detail)
{
  char file[PATH_MAX];
  if (!watched(path, file))
    return go_on;
  const int error_before = errno;
  pthread_mutex_lock(&mutex);
  const long number = count(operation, file);
  enum action action = go_on;
  if (has_fault) {
    const int is_it = !has_happened && number == the_fault.number && strcmp(operation, the_fault.operation) == 0 &&
                      strcmp(file, the_fault.file) == 0;
    const int was = has_happened;
    const char *const kind = the_fault.kind;
    has_happened = was || is_it;
    if (is_it && strcmp(kind, "once") == 0)
      action = fail;
    else if (has_happened && strcmp(kind, "ever") == 0)
      action = fail;
    else if (is_it && (strcmp(kind, "short") == 0 || strcmp(kind, "cut") == 0))
      action = half;
    else if (was && strcmp(kind, "cut") == 0 && nature == writes && strcmp(operation, "close") != 0 &&
             strcmp(operation, "fsync") != 0)
      action = fail;
    else if (is_it && strcmp(kind, "half") == 0)
      action = half_then_kill;
    else if (is_it)
      die();
  }
  if (action != go_on)
    write_log("fault", file, number, operation);
  if (action != fail)
    write_log(operation, file, number, detail);
  pthread_mutex_unlock(&mutex);
  errno = action == fail ? error_of(operation, nature) : error_before;
  return action;
}

static enum action decide_descriptor(const char *operation, const int descriptor, const enum nature nature)
{
  const int error_before = errno;
  char path[PATH_MAX], detail[32] = "";
  pthread_once(&once, start);
  if (folders[0] == '\0' || !path_of(descriptor, path)) {
    errno = error_before;
    return go_on;
  }
  struct stat status;
  if (syscall(SYS_newfstatat, descriptor, "", &status, AT_EMPTY_PATH) == 0)
    snprintf(detail, sizeof detail, "%lld", (long long)status.st_size);
  errno = error_before;
  return decide(operation, path, nature, detail);
}

#define REAL(type, name, ...)                                                                                         \
  static type (*real)(__VA_ARGS__);                                                                                   \
  if (real == NULL)                                                                                                   \
  real = (type(*)(__VA_ARGS__))dlsym(RTLD_NEXT, name)

static enum nature nature_of_flags(const int flags)
{
  return (flags & (O_WRONLY | O_RDWR | O_CREAT | O_TRUNC)) != 0 ? writes : reads;
}

static const char *detail_of_flags(const int flags)
{
  return (flags & O_TRUNC) != 0 ? "new" : nature_of_flags(flags) == writes ? "write" : "read";
}

#define MODE(flags)                                                                                                   \
  mode_t mode = 0;                                                                                                    \
  if (((flags)&O_CREAT) != 0 || ((flags)&O_TMPFILE) == O_TMPFILE) {                                                   \
    va_list list;                                                                                                     \
    va_start(list, flags);                                                                                            \
    mode = (mode_t)va_arg(list, unsigned int);                                                                        \
    va_end(list);                                                                                                     \
  }

#define OPEN(name)                                                                                                    \
  int name(const char *path, int flags, ...)                                                                          \
  {                                                                                                                   \
    REAL(int, #name, const char *, int, ...);                                                                         \
    MODE(flags)                                                                                                       \
    if (decide("open", path, nature_of_flags(flags), detail_of_flags(flags)) == fail)                                 \
      return -1;                                                                                                      \
    return real(path, flags, mode);                                                                                   \
  }
OPEN(open)
OPEN(open64)

#define OPENAT(name)                                                                                                  \
  int name(int folder, const char *path, int flags, ...)                                                              \
  {                                                                                                                   \
    REAL(int, #name, int, const char *, int, ...);                                                                    \
    MODE(flags)                                                                                                       \
    char whole[PATH_MAX];                                                                                             \
    if (path_at(folder, path, whole) &&                                                                               \
        decide("open", whole, nature_of_flags(flags), detail_of_flags(flags)) == fail)                                \
      return -1;                                                                                                      \
    return real(folder, path, flags, mode);                                                                           \
  }
OPENAT(openat)
OPENAT(openat64)

#define FOPEN(name)                                                                                                   \
  FILE *name(const char *path, const char *mode)                                                                      \
  {                                                                                                                   \
    REAL(FILE *, #name, const char *, const char *);                                                                  \
    const int only_reads = mode[0] == 'r' && strchr(mode, '+') == NULL;                                               \
    if (decide("open", path, only_reads ? reads : writes,                                                             \
               only_reads ? "read" : mode[0] == 'w' ? "new" : "write") == fail)                                       \
      return NULL;                                                                                                    \
    return real(path, mode);                                                                                          \
  }
FOPEN(fopen)
FOPEN(fopen64)

int close(int descriptor)
{
  REAL(int, "close", int);
  if (decide_descriptor("close", descriptor, writes) != fail)
    return real(descriptor);
  real(descriptor);
  errno = EIO;
  return -1;
}

int fclose(FILE *stream)
{
  REAL(int, "fclose", FILE *);
  if (decide_descriptor("close", fileno(stream), writes) != fail)
    return real(stream);
  real(stream);
  errno = EIO;
  return EOF;
}

ssize_t write(int descriptor, const void *data, size_t size)
{
  REAL(ssize_t, "write", int, const void *, size_t);
  switch (decide_descriptor("write", descriptor, writes)) {
  case fail:
    return -1;
  case half:
    return real(descriptor, data, size > 1 ? size / 2 : size);
  case half_then_kill:
    real(descriptor, data, size / 2);
    die();
    return -1;
  default:
    return real(descriptor, data, size);
  }
}

#define PWRITE(name, type)                                                                                            \
  ssize_t name(int descriptor, const void *data, size_t size, type offset)                                            \
  {                                                                                                                   \
    REAL(ssize_t, #name, int, const void *, size_t, type);                                                            \
    switch (decide_descriptor("write", descriptor, writes)) {                                                         \
    case fail:                                                                                                        \
      return -1;                                                                                                      \
    case half:                                                                                                        \
      return real(descriptor, data, size > 1 ? size / 2 : size, offset);                                              \
    case half_then_kill:                                                                                              \
      real(descriptor, data, size / 2, offset);                                                                       \
      die();                                                                                                          \
      return -1;                                                                                                      \
    default:                                                                                                          \
      return real(descriptor, data, size, offset);                                                                    \
    }                                                                                                                 \
  }
PWRITE(pwrite, off_t)
PWRITE(pwrite64, off64_t)

ssize_t writev(int descriptor, const struct iovec *parts, int n_parts)
{
  REAL(ssize_t, "writev", int, const struct iovec *, int);
  const enum action action = decide_descriptor("write", descriptor, writes);
  if (action == fail)
    return -1;
  if (action == go_on)
    return real(descriptor, parts, n_parts);
  size_t whole = 0;
  for (int i = 0; i < n_parts; ++i)
    whole += parts[i].iov_len;
  /* Half of it, from the front. */
  size_t left = whole > 1 ? whole / 2 : whole;
  ssize_t n_written = 0;
  for (int i = 0; i < n_parts && left > 0; ++i) {
    const size_t size = parts[i].iov_len < left ? parts[i].iov_len : left;
    const ssize_t n = syscall(SYS_write, descriptor, parts[i].iov_base, size);
    if (n < 0)
      break;
    n_written += n;
    left -= (size_t)n;
  }
  if (action == half_then_kill)
    die();
  return n_written;
}

size_t fwrite(const void *data, size_t size, size_t n, FILE *stream)
{
  REAL(size_t, "fwrite", const void *, size_t, size_t, FILE *);
  switch (decide_descriptor("write", fileno(stream), writes)) {
  case fail:
    return 0;
  case half:
    return real(data, size, n / 2, stream);
  case half_then_kill:
    real(data, size, n / 2, stream);
    fflush(stream);
    die();
    return 0;
  default:
    return real(data, size, n, stream);
  }
}

int fflush(FILE *stream)
{
  REAL(int, "fflush", FILE *);
  if (stream != NULL && decide_descriptor("flush", fileno(stream), writes) == fail)
    return EOF;
  return real(stream);
}

ssize_t read(int descriptor, void *data, size_t size)
{
  REAL(ssize_t, "read", int, void *, size_t);
  switch (decide_descriptor("read", descriptor, reads)) {
  case fail:
    return -1;
  case half:
    return real(descriptor, data, size > 1 ? size / 2 : size);
  default:
    return real(descriptor, data, size);
  }
}

#define PREAD(name, type)                                                                                             \
  ssize_t name(int descriptor, void *data, size_t size, type offset)                                                  \
  {                                                                                                                   \
    REAL(ssize_t, #name, int, void *, size_t, type);                                                                  \
    switch (decide_descriptor("read", descriptor, reads)) {                                                           \
    case fail:                                                                                                        \
      return -1;                                                                                                      \
    case half:                                                                                                        \
      return real(descriptor, data, size > 1 ? size / 2 : size, offset);                                              \
    default:                                                                                                          \
      return real(descriptor, data, size, offset);                                                                    \
    }                                                                                                                 \
  }
PREAD(pread, off_t)
PREAD(pread64, off64_t)

size_t fread(void *data, size_t size, size_t n, FILE *stream)
{
  REAL(size_t, "fread", void *, size_t, size_t, FILE *);
  if (decide_descriptor("read", fileno(stream), reads) == fail)
    return 0;
  return real(data, size, n, stream);
}

#define SYNC(name)                                                                                                    \
  int name(int descriptor)                                                                                            \
  {                                                                                                                   \
    REAL(int, #name, int);                                                                                            \
    return decide_descriptor("fsync", descriptor, writes) == fail ? -1 : real(descriptor);                            \
  }
SYNC(fsync)
SYNC(fdatasync)

int flock(int descriptor, int operation)
{
  REAL(int, "flock", int, int);
  return decide_descriptor("flock", descriptor, other) == fail ? -1 : real(descriptor, operation);
}

#define FTRUNCATE(name, type)                                                                                         \
  int name(int descriptor, type length)                                                                               \
  {                                                                                                                   \
    REAL(int, #name, int, type);                                                                                      \
    return decide_descriptor("truncate", descriptor, writes) == fail ? -1 : real(descriptor, length);                 \
  }
FTRUNCATE(ftruncate, off_t)
FTRUNCATE(ftruncate64, off64_t)

#define TRUNCATE(name, type)                                                                                          \
  int name(const char *path, type length)                                                                             \
  {                                                                                                                   \
    REAL(int, #name, const char *, type);                                                                             \
    return decide("truncate", path, writes, "") == fail ? -1 : real(path, length);                                    \
  }
TRUNCATE(truncate, off_t)
TRUNCATE(truncate64, off64_t)

ssize_t sendfile(int out, int in, off_t *offset, size_t size)
{
  REAL(ssize_t, "sendfile", int, int, off_t *, size_t);
  switch (decide_descriptor("write", out, writes)) {
  case fail:
    return -1;
  case half:
    return real(out, in, offset, size > 1 ? size / 2 : size);
  case half_then_kill:
    real(out, in, offset, size / 2);
    die();
    return -1;
  default:
    return real(out, in, offset, size);
  }
}

/* The detail of a rename is the new name, and the number of what it replaced in the shadow folder. */
static int rename_is_refused(const char *from, const char *to)
{
  char name[PATH_MAX], detail[PATH_MAX + 32];
  if (!watched(to, name))
    return 0;
  snprintf(detail, sizeof detail, "%s\t%ld", name, keep(to));
  return decide("rename", from, writes, detail) == fail;
}

int rename(const char *from, const char *to)
{
  REAL(int, "rename", const char *, const char *);
  return rename_is_refused(from, to) ? -1 : real(from, to);
}

int renameat(int from_folder, const char *from, int to_folder, const char *to)
{
  REAL(int, "renameat", int, const char *, int, const char *);
  char old_path[PATH_MAX], new_path[PATH_MAX];
  if (path_at(from_folder, from, old_path) && path_at(to_folder, to, new_path) && rename_is_refused(old_path, new_path))
    return -1;
  return real(from_folder, from, to_folder, to);
}

/* The detail of a removal is the number of what was removed in the shadow folder. */
static int removal_is_refused(const char *operation, const char *path)
{
  char name[PATH_MAX], detail[32];
  if (!watched(path, name))
    return 0;
  snprintf(detail, sizeof detail, "%ld", keep(path));
  return decide(operation, path, writes, detail) == fail;
}

int unlink(const char *path)
{
  REAL(int, "unlink", const char *);
  return removal_is_refused("unlink", path) ? -1 : real(path);
}

int remove(const char *path)
{
  REAL(int, "remove", const char *);
  return removal_is_refused("unlink", path) ? -1 : real(path);
}

int unlinkat(int folder, const char *path, int flags)
{
  REAL(int, "unlinkat", int, const char *, int);
  char whole[PATH_MAX];
  if (path_at(folder, path, whole) && removal_is_refused((flags & AT_REMOVEDIR) != 0 ? "rmdir" : "unlink", whole))
    return -1;
  return real(folder, path, flags);
}

int rmdir(const char *path)
{
  REAL(int, "rmdir", const char *);
  return removal_is_refused("rmdir", path) ? -1 : real(path);
}

int mkdir(const char *path, mode_t mode)
{
  REAL(int, "mkdir", const char *, mode_t);
  return decide("mkdir", path, writes, "") == fail ? -1 : real(path, mode);
}

int mkdirat(int folder, const char *path, mode_t mode)
{
  REAL(int, "mkdirat", int, const char *, mode_t);
  char whole[PATH_MAX];
  if (path_at(folder, path, whole) && decide("mkdir", whole, writes, "") == fail)
    return -1;
  return real(folder, path, mode);
}

DIR *opendir(const char *path)
{
  REAL(DIR *, "opendir", const char *);
  return decide("opendir", path, reads, "") == fail ? NULL : real(path);
}
