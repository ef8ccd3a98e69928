#include <continua/base/input_error.h>
#include <continua/program/examples.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <vector>

namespace Continua
{
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
    std::ifstream text(file);
    std::string line;
    std::getline(text, line);
    const std::size_t begin = line.find_first_not_of("# ");
    out << "  " << std::filesystem::relative(file, folder).string() << "\n";
    if (line.compare(0, 1, "#") == 0 && begin != std::string::npos)
      out << "      " << line.substr(begin) << "\n";
  }
}
} // namespace Continua
