#ifndef continua_base_input_error_h
#define continua_base_input_error_h

#include <stdexcept>
#include <string>

namespace Continua
{
/// Where a piece of the user's input stands.
struct Origin
{
  std::string
      file; ///< as the user named it; empty where there is none (a default, the command line)
  unsigned int line = 0; ///< first line is 1; 0 where there is none
};

/**
 * The user's input is wrong: thrown before any work is done, printed by main, exit status 2.
 * what() is "FILE:LINE: 'KEY': PROBLEM. REMEDY." with the parts that are known.
 */
class InputError : public std::runtime_error
{
public:
  InputError(const Origin &origin,
             const std::string &key,
             const std::string &problem,
             const std::string &remedy);
};

/// Something that the input needs is not there. It may be there under a misspelt name: whoever
/// knows all names looks for it before this is reported.
class MissingInput : public InputError
{
public:
  using InputError::InputError;
};

/// The run failed in mid-work (divergence, NaN, full disk): exit status 1.
class RunError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// A time step has no solution that was found. What was before the step is unchanged, and a shorter
/// step may have one.
class StepFailure : public RunError
{
public:
  using RunError::RunError;
};
} // namespace Continua

#endif
