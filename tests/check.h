#ifndef continua_tests_check_h
#define continua_tests_check_h

// What the unit tests print: "NAME: ok" without digits when a check holds, so that the reference
// output is the same on every machine, and the numbers when it does not.

#include <cmath>
#include <exception>
#include <functional>
#include <iostream>
#include <string>

namespace check
{
inline void is_true(const std::string &name, const bool condition)
{
  std::cout << name << (condition ? ": ok" : ": FAILED") << std::endl;
}

/// |value - reference| <= tolerance.
inline void absolute(const std::string &name,
                     const double value,
                     const double reference,
                     const double tolerance)
{
  if (std::abs(value - reference) <= tolerance)
    std::cout << name << ": ok" << std::endl;
  else
    std::cout << name << ": FAILED, " << value << " is not " << reference << " +- " << tolerance
              << std::endl;
}

/// |value - reference| <= tolerance |reference|.
inline void relative(const std::string &name,
                     const double value,
                     const double reference,
                     const double tolerance)
{
  absolute(name, value, reference, tolerance * std::abs(reference));
}

inline void equal(const std::string &name, const std::string &value, const std::string &reference)
{
  if (value == reference)
    std::cout << name << ": ok" << std::endl;
  else
    std::cout << name << ": FAILED, '" << value << "' is not '" << reference << "'" << std::endl;
}

/// Whether the regular expression matches somewhere in the text. Not inline: compiling it takes
/// longer than most tests.
bool matches(const std::string &text, const std::string &pattern);

/// `function` throws an Exception whose text matches the regular expression.
template <typename Exception>
void throws(const std::string &name,
            const std::function<void()> &function,
            const std::string &pattern)
{
  try
  {
    function();
    std::cout << name << ": FAILED, nothing was thrown" << std::endl;
  }
  catch (const Exception &exception)
  {
    if (matches(exception.what(), pattern))
      std::cout << name << ": ok" << std::endl;
    else
      std::cout << name << ": FAILED, '" << exception.what() << "' does not match '" << pattern
                << "'" << std::endl;
  }
  catch (const std::exception &exception)
  {
    std::cout << name << ": FAILED, another exception: " << exception.what() << std::endl;
  }
}
} // namespace check

#endif
