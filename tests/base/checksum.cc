// A checksum that grows: of published values, in parts, and of files.

#include <continua/base/checksum.h>
#include <continua/base/input_error.h>

#include "../unit_test.h"

#include <filesystem>
#include <fstream>

namespace test_of_checksum
{
using namespace Continua;

UNIT_TEST(checksum)
{
  // Test vectors of FNV-1a: draft-eastlake-fnv, appendix C.
  Checksum sum;
  check::is_true("nothing", sum.value() == 0xcbf29ce484222325ul && sum.length() == 0);
  sum.add("foo");
  check::is_true("foo", sum.value() == 0xdcb27518fed9d577ul);
  sum.add("bar");
  check::is_true("foobar", sum.value() == 0x85944171f73967e8ul && sum.length() == 6);

  const std::string file = "checksum-test.txt";
  std::ofstream(file) << "foobar";
  check::is_true("a file", Checksum::of_file(file).value() == sum.value());
  check::is_true("its beginning", Checksum::of_file(file, 3).value() == 0xdcb27518fed9d577ul);
  check::is_true("a file that is shorter", Checksum::of_file(file, 9).length() == 6);
  Checksum part;
  part.add("foo");
  part.add_rest_of(file);
  check::is_true("the rest of a file", part.value() == sum.value() && part.length() == 6);
  part.add_rest_of(file);
  check::is_true("there is no more", part.length() == 6);
  std::filesystem::remove(file);
  check::throws<RunError>(
      "no file", []() { Checksum::of_file("no-such-file"); }, "'no-such-file': No such file");
  check::throws<RunError>(
      "a folder", []() { Checksum::of_file("/"); }, "cannot read '/': Is a directory");
}
} // namespace test_of_checksum
