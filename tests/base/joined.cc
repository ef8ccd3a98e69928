#include <continua/base/joined.h>

#include "../unit_test.h"

namespace test_of_joined
{
UNIT_TEST(joined)
{
  check::equal("three words", Continua::joined({"a", "b c", "d"}), "a, b c, d");
  check::equal("one", Continua::joined({"a"}), "a");
  check::equal("none", Continua::joined({}), "");
}
} // namespace test_of_joined
