#include <continua/base/input_error.h>
#include <continua/program/examples.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <vector>

namespace Continua
{
namespace
{
/// Of the comment that a file begins with.
std::string first_sentence(const std::filesystem::path &file)
{
  std::ifstream text(file);
  std::string sentence, line;
  while (std::getline(text, line) && line.compare(0, 2, "# ") == 0)
  {
    sentence += (sentence.empty() ? "" : " ") + line.substr(2);
    for (std::size_t stop = sentence.find('.'); stop != std::string::npos;
         stop = sentence.find('.', stop + 1))
      if (stop + 1 == sentence.size() || sentence[stop + 1] == ' ')
        return sentence.substr(0, stop + 1);
  }
  return sentence;
}
} // namespace

std::string examples_folder()
{
  // Where the program itself is, wherever it was called from.
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe");
  // Installed: PREFIX/bin/continua. Built: CHECKOUT/build/release/continua or a folder further
  // down.
  for (std::filesystem::path above = program.parent_path(); above != above.parent_path();
       above = above.parent_path())
    for (const std::filesystem::path &folder :
         {above / "share" / "continua" / "parameter_files", above / "parameter_files"})
      if (std::filesystem::is_directory(folder))
        return folder.string();
  throw InputError({"command line", 0}, "--examples",
                   "the program's parameter files are not beside it (" + program.string() + ")",
                   "Install the program with them, or look into the folder parameter_files of its "
                   "sources");
}

void print_examples(std::ostream &out, const std::string &folder)
{
  std::vector<std::filesystem::path> files;
  for (const auto &entry : std::filesystem::recursive_directory_iterator(folder))
  {
    const std::filesystem::path &path = entry.path();
    if (entry.is_regular_file() && path.extension() == ".prm" &&
        path.parent_path().filename() != "common")
      files.push_back(path);
  }
  std::sort(files.begin(), files.end());
  out << "Parameter files in " << folder << ":\n\n";
  for (const std::filesystem::path &file : files)
  {
    out << "  " << std::filesystem::relative(file, folder).string() << "\n";
    if (const std::string sentence = first_sentence(file); !sentence.empty())
      out << "      " << sentence << "\n";
  }
}
} // namespace Continua
