#ifndef continua_tests_parameter_text_h
#define continua_tests_parameter_text_h

#include <continua/base/parameter_file.h>

#include <fstream>
#include <string>

/// A parameter file with that text, in the folder of the test.
inline Continua::ParameterFile parameters_of(const std::string &text)
{
  const std::string name = "parameters_of_the_test.prm";
  std::ofstream(name) << text;
  return Continua::ParameterFile(name);
}

#endif
