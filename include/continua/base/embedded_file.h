#ifndef continua_base_embedded_file_h
#define continua_base_embedded_file_h

namespace Continua
{
/// A file of the source tree whose text the build puts into the program. cmake/embedded_files.cmake
/// writes tables of them.
struct EmbeddedFile
{
  const char *name; ///< without its folder
  const char *text;
};
} // namespace Continua

#endif
