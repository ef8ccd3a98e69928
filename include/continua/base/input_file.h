#ifndef continua_base_input_file_h
#define continua_base_input_file_h

#include <string>
#include <vector>

namespace Continua
{
/// Throws std::invalid_argument with the problem unless `path` names a regular file that can be
/// opened for reading. A pipe, a socket, a device and a folder are refused before they are opened:
/// to open them can wait for ever. `kind`: what the file is to be, for the message ("file",
/// "mesh").
void check_input_file(const std::string &path, const std::string &kind = "file");

/// Every byte of an input file. Throws std::invalid_argument with the problem: what
/// check_input_file() refuses, a read error with the reason of the system, and a file of more than
/// 4 GiB. A read error is never taken for the end of the file.
std::string read_input_file(const std::string &path, const std::string &kind = "file");

/**
 * The lines of an input file of text. A line ends with a line feed, a carriage return or both. A
 * byte order mark of UTF-8 is left out. Throws InputError with the file, and with the line where
 * there is one, for what read_input_file() refuses, for UTF-16 and UTF-32, for bytes that are no
 * UTF-8, and for control characters other than the tab (a terminal would obey them).
 */
std::vector<std::string> read_input_lines(const std::string &path,
                                          const std::string &kind = "file");

/// The same of a text that has been read from the file `name`.
std::vector<std::string> lines_of_text(const std::string &text, const std::string &name);

/// What is wrong with some text as input: "has bytes that are no UTF-8", "has the control character
/// 0x1b"; empty if nothing is wrong.
std::string problem_of_text(const std::string &text);

/// The text as a terminal may show it: control characters except the line feed, and bytes that are
/// no UTF-8, become "\x1b".
std::string printable(const std::string &text);
} // namespace Continua

#endif
