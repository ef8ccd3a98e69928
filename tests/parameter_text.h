#ifndef continua_tests_parameter_text_h
#define continua_tests_parameter_text_h

#include <continua/base/parameter_file.h>

#include <fstream>
#include <string>

constexpr const char *parameter_file_of_the_test = "parameters_of_the_test.prm";

/// A parameter file with that text, in the folder of the test.
inline Continua::ParameterFile parameters_of(const std::string &text)
{
  std::ofstream(parameter_file_of_the_test) << text;
  return Continua::ParameterFile(parameter_file_of_the_test);
}

#endif
