#ifndef continua_base_output_files_h
#define continua_base_output_files_h

#include <string>
#include <vector>

namespace Continua
{
/// The files and folders that runs write into their output folder, of all analyses: `--overwrite`
/// removes them. Those whose names depend on the case are not among them
/// (OutputDirectory::file_of_case).
const std::vector<std::string> &output_files();

/// The path of a file in the output folder, which every run takes from here before it writes: the
/// name, or its first part before a slash, is in the list (else an exception of deal.II).
std::string output_file(const std::string &folder, const std::string &name);
} // namespace Continua

#endif
