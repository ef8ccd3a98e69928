#ifndef continua_base_folder_lock_h
#define continua_base_folder_lock_h

#include <string>

namespace Continua
{
/**
 * One folder, one run: a lock (flock) on the file `lock` in the folder, which states in words which
 * process has it. It ends with the object, and with the process, however that ends; the file is
 * then removed, or stays without a lock after a kill, which does not matter. Programs that the
 * process starts do not inherit it. Other hosts see it as far as the file system tells them of
 * locks (NFS does).
 */
class FolderLock
{
public:
  /// Tries to lock a folder that is there. Throws RunError with the system's reason if the file can
  /// be neither made nor opened, or is not a lock's.
  explicit FolderLock(const std::string &folder);
  ~FolderLock();
  FolderLock(const FolderLock &) = delete;
  FolderLock &operator=(const FolderLock &) = delete;

  /// Who has the lock instead: "process 4711 on node12 since 2026-11-23 01:40:12 +0000"; empty if
  /// no one has.
  const std::string &holder() const { return other_holder; }
  /// Why the folder has no lock all the same: the file system has none. Else empty.
  const std::string &warning() const { return missing; }

private:
  std::string file;
  int descriptor = -1; ///< of the locked file; -1: this object has no lock
  std::string other_holder;
  std::string missing;

  /// One attempt; false: the file was removed meanwhile by the process that had it.
  bool try_to_lock();
  void name_holder() const;
};
} // namespace Continua

#endif
