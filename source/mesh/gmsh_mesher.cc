#include <continua/base/collective.h>
#include <continua/base/input_error.h>
#include <continua/mesh/gmsh_mesher.h>

#include <deal.II/base/mpi.h>

#include <gmsh.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace Continua
{
namespace
{
/// The library of gmsh, while it is in use.
struct Gmsh
{
  Gmsh()
  {
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
    // One thread: the same mesh each time.
    gmsh::option::setNumber("General.NumThreads", 1);
  }
  ~Gmsh() { gmsh::finalize(); }
};

/// A folder of its own for the file that gmsh writes.
struct TemporaryFolder
{
  TemporaryFolder()
  {
    std::string name = (std::filesystem::temp_directory_path() / "continua-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
      throw std::runtime_error("no folder can be made in " +
                               std::filesystem::temp_directory_path().string());
    path = name;
  }
  ~TemporaryFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
  std::filesystem::path path;
};

/// Throws std::runtime_error, or a std::string as the library does.
std::string mesh_on_this_rank(const std::string &geo_file, const unsigned int dimension)
{
  const TemporaryFolder folder;
  const std::string mesh_file = (folder.path / "mesh.msh").string();
  const Gmsh gmsh_library;
  gmsh::open(geo_file);
  gmsh::model::mesh::generate(dimension);
  std::string error;
  gmsh::logger::getLastError(error);
  if (!error.empty())
    throw std::runtime_error(error);
  gmsh::option::setNumber("Mesh.MshFileVersion", 4.1);
  gmsh::option::setNumber("Mesh.Binary", 0);
  gmsh::write(mesh_file);

  std::ifstream stream(mesh_file);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream || text.str().empty())
    throw std::runtime_error("it has written no mesh to " + mesh_file);
  return text.str();
}
} // namespace

std::string mesh_with_gmsh(const std::string &geo_file, const unsigned int dimension)
{
  std::string text;
  std::string error;
  const bool parallel = dealii::Utilities::MPI::job_supports_mpi();
  if (!parallel || dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
  {
    try
    {
      text = mesh_on_this_rank(geo_file, dimension);
    }
    catch (const std::string &message)
    {
      error = message;
    }
    catch (const std::exception &exception)
    {
      error = exception.what();
    }
    if (text.empty() && error.empty())
      error = "no reason is known";
  }
  if (parallel)
  {
    text = broadcast(MPI_COMM_WORLD, text);
    error = broadcast(MPI_COMM_WORLD, error);
  }
  if (!error.empty())
    throw InputError({geo_file, 0}, "Geometry/File", "gmsh cannot mesh the file: " + error,
                     "Look at it with 'gmsh FILE.geo', and mesh it there");
  return text;
}
} // namespace Continua
