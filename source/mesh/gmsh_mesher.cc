#include <continua/base/collective.h>
#include <continua/base/input_error.h>
#include <continua/mesh/gmsh_mesher.h>
#include <continua/mesh/gmsh_process.h>
#include <continua/mesh/gmsh_script.h>

#include <deal.II/base/mpi.h>

#include <stdexcept>

namespace Continua
{
namespace
{
/// The permission is the user's, for all that the program does: several runs of a study, too.
bool commands_are_allowed = false;

/// The mesh, or why there is none: as a whole, or for a message that has still to be completed.
struct Outcome
{
  std::string mesh, refusal, failure;
};

Outcome mesh_on_this_rank(const std::string &geo_file,
                          const unsigned int dimension,
                          const double time_limit)
{
  Outcome outcome;
  try
  {
    if (!commands_are_allowed)
      check_gmsh_script(geo_file);
    outcome.mesh = mesh_in_own_process({geo_file, dimension, commands_are_allowed, time_limit});
    if (outcome.mesh.empty())
      outcome.failure = "it has written an empty mesh";
  }
  catch (const InputError &error)
  {
    outcome.refusal = error.what();
  }
  catch (const std::exception &error)
  {
    outcome.failure = error.what();
  }
  return outcome;
}
} // namespace

std::string
mesh_with_gmsh(const std::string &geo_file, const unsigned int dimension, const double time_limit)
{
  Outcome outcome;
  const bool parallel = dealii::Utilities::MPI::job_supports_mpi();
  if (!parallel || dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    outcome = mesh_on_this_rank(geo_file, dimension, time_limit);
  if (parallel)
    for (std::string *const text : {&outcome.mesh, &outcome.refusal, &outcome.failure})
      *text = broadcast(MPI_COMM_WORLD, *text);
  if (!outcome.refusal.empty())
    throw InputError({}, "", outcome.refusal, "");
  if (!outcome.failure.empty())
    throw InputError({geo_file, 0}, "Geometry/File",
                     "gmsh cannot mesh the file: " + outcome.failure,
                     "Look at it with 'gmsh FILE.geo', and mesh it there");
  return outcome.mesh;
}

void allow_mesh_commands()
{
  commands_are_allowed = true;
}
} // namespace Continua
