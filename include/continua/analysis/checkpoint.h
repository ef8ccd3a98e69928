#ifndef continua_analysis_checkpoint_h
#define continua_analysis_checkpoint_h

#include <continua/base/archive.h>
#include <continua/base/output_directory.h>
#include <continua/base/parameter_file.h>
#include <continua/base/written_table.h>

#include <mpi.h>

#include <functional>
#include <string>
#include <vector>

namespace Continua
{
/**
 * The state of a run on disk, to go on from on any number of ranks: `checkpoint/STEP/` with an
 * archive `state` and a piece `rank-N` of each rank that wrote it; `checkpoint/current` names the
 * last complete one. A new one is written beside the old, flushed to the disk, then named, then the
 * old one is removed, so that a kill at any moment leaves a good one. The state that `current`
 * names is never removed. All methods are collective and throw on all ranks alike.
 *
 * An archive also states length and checksum of each table that a restart continues.
 */
class Checkpoint
{
public:
  /// `folder`: the output's checkpoint folder. `identity`: the text of ParameterFile that must be
  /// the same at the restart.
  Checkpoint(MPI_Comm communicator, const std::string &folder, const std::string &identity);
  /// Of a run of the program.
  Checkpoint(MPI_Comm communicator, const OutputDirectory &directory, const ParameterFile &file);

  /// Writes what `fill` adds to the archive, on rank 0, and to its piece, on every rank.
  /// `tables`, on rank 0: what is written, and flushed to the disk, of the tables that a restart
  /// continues. Throws RunError when the disk refuses; what was written of this one is then
  /// removed, and an earlier one is kept. Returns, on all ranks, what the user should be warned of:
  /// a disk that refused when the new one was named already.
  std::string write(unsigned int step,
                    const std::function<void(ArchiveWriter &)> &fill,
                    const std::vector<WrittenTable> &tables = {}) const;

  /// Opens the last complete checkpoint. Throws InputError if there is none, if it belongs to
  /// another case or version, or if any of its files is missing or damaged.
  ArchiveReader read() const;
  /// Throws InputError if a table in the output folder `output` is missing, is shorter than when
  /// the archive was written, or begins with other bytes. `keeps_last_row`: whether the restart
  /// keeps the row with which a table ended then; others are not looked at.
  void check_tables(const ArchiveReader &archive,
                    const std::string &output,
                    const std::function<bool(const std::string &table)> &keeps_last_row) const;
  /// Removes from the tables of numbers what stands behind the rows that check_tables() has looked
  /// at: rows that were written after the archive. Throws RunError.
  void cut_tables(const ArchiveReader &archive,
                  const std::string &output,
                  const std::function<bool(const std::string &table)> &keeps_last_row) const;

private:
  MPI_Comm communicator;
  std::string folder;
  std::string identity;

  /// The step of the last complete one; empty if there is none. Throws RunError if that cannot be
  /// known.
  std::string current() const;
  std::string archive_file(const std::string &step) const;
  std::string piece_file(const std::string &step, unsigned int rank) const;
  /// What is left of checkpoints that were not finished, or not removed.
  void remove_all_but(const std::string &step) const;
  /// Throws InputError.
  void check_case(const ArchiveReader &archive) const;
  /// Whether all other files are there and whole; throws RunError. A rank looks at its share.
  void check_files(const ArchiveReader &archive, const std::string &step) const;
};
} // namespace Continua

#endif
