#ifndef continua_base_memory_use_h
#define continua_base_memory_use_h

#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/// The memory that this process holds now [bytes]; 0 if the system does not say it.
double memory_held();
/// Gives back to the system what this process has freed. The allocator keeps small pieces
/// otherwise, which count as held. Takes up to 0.2 s for each GB that is held: only for the moments
/// before much is allocated.
void return_freed_memory();

/**
 * What holds the memory of this process, by the parts of a run. A part holds by how much the memory
 * of the process has grown between the mark before and the part's own mark. Libraries count, too.
 */
class MemoryUse
{
public:
  /// The growth since the last mark, or since the start of the process, belongs to `part`. Memory
  /// that was freed goes back to the system first.
  void mark(const std::string &part);
  /// Likewise of a part that is made over and over, such as a factor: only the first time memory
  /// goes back. Later the next one is made in it, without a fault for each of its pages.
  void mark_again(const std::string &part);
  /// In the order of their first marks; negative where a part has freed more than it has taken
  /// [bytes].
  const std::vector<std::pair<std::string, double>> &parts() const { return bytes_of_parts; }

private:
  using Part = std::pair<std::string, double>;

  double last = 0.; ///< [bytes]
  std::vector<Part> bytes_of_parts;

  std::vector<Part>::iterator find(const std::string &part);
};
} // namespace Continua

#endif
