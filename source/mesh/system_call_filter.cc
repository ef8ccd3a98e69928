#include <continua/mesh/system_call_filter.h>

#include <fcntl.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>

#if defined(__linux__) && (defined(__x86_64__) || defined(__aarch64__))
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

#include <cstddef>
#include <vector>

namespace Continua
{
namespace
{
/// One instruction of the filter; see linux/filter.h.
sock_filter instruction(const unsigned int code,
                        const unsigned int value,
                        const unsigned int if_true = 0,
                        const unsigned int if_false = 0)
{
  return {static_cast<unsigned short>(code), static_cast<unsigned char>(if_true),
          static_cast<unsigned char>(if_false), value};
}

sock_filter load(const std::size_t offset)
{
  return instruction(BPF_LD | BPF_W | BPF_ABS, static_cast<unsigned int>(offset));
}

sock_filter give(const unsigned int verdict)
{
  return instruction(BPF_RET | BPF_K, verdict);
}

constexpr unsigned int refused = SECCOMP_RET_ERRNO | EPERM;
/// As if the call did not exist: glibc then takes the older one, whose arguments can be seen.
constexpr unsigned int unknown = SECCOMP_RET_ERRNO | ENOSYS;

/// The lower half of an argument; both machines are little-endian.
std::size_t argument(const unsigned int number)
{
  return offsetof(seccomp_data, args) + 8 * number;
}

/// Two instructions: the verdict for a call.
void judge(std::vector<sock_filter> &filter, const long call, const unsigned int verdict)
{
  filter.push_back(instruction(BPF_JMP | BPF_JEQ | BPF_K, static_cast<unsigned int>(call), 0, 1));
  filter.push_back(give(verdict));
}

/// A call whose argument decides: `with_flags` if any of the flags is set, else `without_flags`.
void judge_flags(std::vector<sock_filter> &filter,
                 const long call,
                 const unsigned int number,
                 const unsigned int flags,
                 const unsigned int with_flags,
                 const unsigned int without_flags)
{
  filter.push_back(instruction(BPF_JMP | BPF_JEQ | BPF_K, static_cast<unsigned int>(call), 0, 4));
  filter.push_back(load(argument(number)));
  filter.push_back(instruction(BPF_JMP | BPF_JSET | BPF_K, flags, 0, 1));
  filter.push_back(give(with_flags));
  filter.push_back(give(without_flags));
}

std::vector<sock_filter> make_filter()
{
#if defined(__x86_64__)
  constexpr unsigned int machine = AUDIT_ARCH_X86_64;
#else
  constexpr unsigned int machine = AUDIT_ARCH_AARCH64;
#endif
  constexpr unsigned int writing = O_WRONLY | O_RDWR | O_CREAT | O_TRUNC;
  std::vector<sock_filter> filter;
  // The numbers of the calls hold for one machine; those of another one would slip through.
  filter.push_back(load(offsetof(seccomp_data, arch)));
  filter.push_back(instruction(BPF_JMP | BPF_JEQ | BPF_K, machine, 1, 0));
  filter.push_back(give(refused));
  filter.push_back(load(offsetof(seccomp_data, nr)));
#if defined(__x86_64__)
  constexpr unsigned int first_of_x32 = 0x40000000;
  filter.push_back(instruction(BPF_JMP | BPF_JGE | BPF_K, first_of_x32, 0, 1));
  filter.push_back(give(refused));
  for (const long call :
       {SYS_fork, SYS_vfork, SYS_creat, SYS_unlink, SYS_rename, SYS_mkdir, SYS_rmdir, SYS_link,
        SYS_symlink, SYS_mknod, SYS_chmod, SYS_chown, SYS_lchown, SYS_utime, SYS_utimes})
    judge(filter, call, refused);
#endif
  for (const long call :
       {SYS_execve,     SYS_execveat,  SYS_unlinkat,  SYS_renameat,         SYS_renameat2,
        SYS_mkdirat,    SYS_linkat,    SYS_symlinkat, SYS_mknodat,          SYS_fchmodat,
        SYS_fchmod,     SYS_fchownat,  SYS_fchown,    SYS_truncate,         SYS_utimensat,
        SYS_setxattr,   SYS_lsetxattr, SYS_fsetxattr, SYS_removexattr,      SYS_socket,
        SYS_socketpair, SYS_kill,      SYS_ptrace,    SYS_process_vm_writev})
    judge(filter, call, refused);
#ifdef SYS_clone3
  judge(filter, SYS_clone3, unknown);
#endif
#ifdef SYS_openat2
  judge(filter, SYS_openat2, unknown);
#endif
#ifdef SYS_io_uring_setup
  judge(filter, SYS_io_uring_setup, unknown);
#endif
  judge_flags(filter, SYS_clone, 0, CLONE_THREAD, SECCOMP_RET_ALLOW, refused);
#if defined(__x86_64__)
  judge_flags(filter, SYS_open, 1, writing, refused, SECCOMP_RET_ALLOW);
#endif
  judge_flags(filter, SYS_openat, 2, writing, refused, SECCOMP_RET_ALLOW);
  filter.push_back(give(SECCOMP_RET_ALLOW));
  return filter;
}
} // namespace

void refuse_programs_and_writing_to_this_thread()
{
  std::vector<sock_filter> filter = make_filter();
  const sock_fprog program = {static_cast<unsigned short>(filter.size()), filter.data()};
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 ||
      ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program, 0, 0) != 0)
    throw std::runtime_error(std::string("this system cannot keep gmsh from running programs "
                                         "(seccomp: ") +
                             std::strerror(errno) + ")");
}
} // namespace Continua

#else

namespace Continua
{
void refuse_programs_and_writing_to_this_thread()
{
  throw std::runtime_error(
      "this system cannot keep gmsh from running programs: that needs Linux on "
      "x86-64 or ARM64");
}
} // namespace Continua

#endif
