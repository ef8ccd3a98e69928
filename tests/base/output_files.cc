// The list of files that runs write, from which every path is made.

#include <continua/base/output_files.h>

#include <deal.II/base/exceptions.h>

#include "../unit_test.h"

#include <algorithm>

namespace test_of_output_files
{
using namespace Continua;

UNIT_TEST(output_files)
{
  check::equal("a file", output_file("out", "wave.csv"), "out/wave.csv");
  check::equal("in a folder", output_file("out", "checkpoint/current"), "out/checkpoint/current");
  check::throws<dealii::ExceptionBase>(
      "a file that is not in the list", []() { output_file("out", "waves.csv"); },
      "A run writes 'waves.csv', which is missing in the list");
  const std::vector<std::string> &names = output_files();
  check::is_true("each once, in order",
                 std::is_sorted(names.begin(), names.end()) &&
                     std::adjacent_find(names.begin(), names.end()) == names.end());
  check::is_true("not the lock, which the next run takes over",
                 std::find(names.begin(), names.end(), "lock") == names.end());
}
} // namespace test_of_output_files
