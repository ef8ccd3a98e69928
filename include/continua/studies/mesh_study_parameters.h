#ifndef continua_studies_mesh_study_parameters_h
#define continua_studies_mesh_study_parameters_h

#include <continua/studies/study_parameters.h>

namespace Continua
{
/// What the sections of studies on sequences of meshes have.
struct MeshStudyParameters : StudyParameters
{
  bool refine_time_step = false; ///< divided as often as the mesh is refined
};
} // namespace Continua

#endif
