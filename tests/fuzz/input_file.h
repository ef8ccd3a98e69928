#ifndef continua_tests_fuzz_input_file_h
#define continua_tests_fuzz_input_file_h

#include <cstddef>
#include <cstdint>
#include <string>

/// What libFuzzer calls for each input. Whatever it throws, and every report of a sanitizer, is a
/// finding.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size);

namespace Fuzz
{
/// The input as a file in a folder of this process alone, for a reader that wants a path. Each call
/// writes it anew.
std::string input_file(const std::string &content, const std::string &name);

/// Ends the program if `holds` is false: the reader has read something that is not there.
void require(bool holds, const std::string &what);
} // namespace Fuzz

#endif
