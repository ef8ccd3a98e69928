#ifndef continua_studies_studied_run_h
#define continua_studies_studied_run_h

#include <continua/studies/run_series.h>

namespace Continua
{
/// One run of a study on a sequence of meshes.
struct StudiedRun : RunResult
{
  unsigned int variant = 0; ///< number of the variant of the case
  unsigned int mesh = 0;    ///< how often the file's mesh is refined
  double time_step = 0.;    ///< [s]; 0: none
};
} // namespace Continua

#endif
