#include <continua/continuum/vector_archive.h>

#include <continua/base/input_error.h>

#include <algorithm>

namespace Continua
{
void save_vector(ArchiveWriter &archive, const std::string &name, const DistributedVector &vector)
{
  archive.add(name, std::vector<double>(vector.begin(), vector.end()));
}

void load_vector(const ArchiveReader &archive, const std::string &name, DistributedVector &vector)
{
  const std::vector<double> values = archive.values(name);
  if (values.size() != static_cast<std::size_t>(vector.end() - vector.begin()))
    throw RunError("the checkpoint's field '" + name + "' has " + std::to_string(values.size()) +
                   " values on this rank, the mesh has " +
                   std::to_string(vector.end() - vector.begin()) +
                   ": it belongs to another mesh or number of ranks");
  std::copy(values.begin(), values.end(), vector.begin());
}
} // namespace Continua
