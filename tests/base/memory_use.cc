// The memory of the process by parts, against blocks of known sizes that are taken and given back.

#include <continua/base/memory_use.h>

#include "../unit_test.h"

#include <cstddef>
#include <vector>

namespace test_of_memory_use
{
using namespace Continua;

namespace
{
constexpr std::size_t size = 64 * 1000 * 1000;

double bytes_of(const MemoryUse &use, const std::string &name)
{
  double bytes = 0.;
  for (const auto &[part, of_part] : use.parts())
    if (part == name)
      bytes += of_part;
  return bytes;
}
} // namespace

UNIT_TEST(memory_use)
{
  MemoryUse use;
  use.mark("program");
  check::is_true("a first mark", bytes_of(use, "program") > 0. && memory_held() > 0.);
  // What is called for the first time brings pages of the program itself into memory, 2 MB where
  // they are large: they are no part of what comes now.
  use.mark("program");
  check::relative("the first part is all that there is", bytes_of(use, "program"), memory_held(),
                  0.05);
  use.mark("program");
  const double at_start = bytes_of(use, "program");
  std::vector<char> first(size, 'a');
  use.mark("first");
  check::relative("a block", bytes_of(use, "first"), size, 0.03);
  std::vector<char> second(2 * size, 'b');
  use.mark("second");
  check::relative("another one", bytes_of(use, "second"), 2. * size, 0.03);
  first = std::vector<char>();
  use.mark("first");
  check::absolute("what is given back no longer counts", bytes_of(use, "first") / size, 0., 0.03);
  use.mark("nothing");
  check::absolute("nothing was taken", bytes_of(use, "nothing") / size, 0., 0.03);
  std::vector<char> third(size, 'c');
  use.mark_again("third");
  check::relative("a part that is made over and over", bytes_of(use, "third"), size, 0.03);
  std::vector<char> fourth(size, 'd');
  use.mark_again("third");
  check::relative("its second time counts", bytes_of(use, "third"), 2. * size, 0.03);
  double sum = 0.;
  for (const auto &part : use.parts())
    sum += part.second;
  check::relative("the parts are the whole", sum, memory_held(), 0.03);
  check::is_true("the blocks are there", second.back() == 'b' &&
                                             third.back() + fourth.back() == 'c' + 'd' &&
                                             sum > at_start + 1.9 * size);
  check::equal("in the order of their first marks",
               use.parts()[1].first + ", " + use.parts()[2].first, std::string("first, second"));
}
} // namespace test_of_memory_use
