#ifndef continua_continuum_vector_archive_h
#define continua_continuum_vector_archive_h

#include <continua/base/archive.h>
#include <continua/linear_algebra/distributed_vector.h>

#include <string>

namespace Continua
{
/// Writes this rank's entries of a vector, bit by bit.
void save_vector(ArchiveWriter &archive, const std::string &name, const DistributedVector &vector);
/// Reads them back; throws RunError if their number differs (another mesh or number of ranks).
void load_vector(const ArchiveReader &archive, const std::string &name, DistributedVector &vector);
} // namespace Continua

#endif
