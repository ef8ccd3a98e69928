// Gives a reader the files that are named on the command line, for a build without libFuzzer.

#include "input_file.h"

#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

int main(const int n_arguments, const char *const *arguments)
{
  if (n_arguments < 2)
  {
    std::cerr << "no input is named\n";
    return 2;
  }
  for (int i = 1; i < n_arguments; ++i)
  {
    std::ifstream stream(arguments[i], std::ios::binary);
    const std::string content{std::istreambuf_iterator<char>(stream), {}};
    if (!stream)
    {
      std::cerr << arguments[i] << " cannot be read\n";
      return 2;
    }
    try
    {
      LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t *>(content.data()),
                             content.size());
    }
    catch (const std::exception &error)
    {
      std::cerr << arguments[i] << ": " << error.what() << '\n';
      return 1;
    }
  }
  return 0;
}
