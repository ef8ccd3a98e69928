#ifndef continua_tests_finite_element_shell_conditions_h
#define continua_tests_finite_element_shell_conditions_h

// Boundary conditions of a quarter of a shell, for the unit tests of products without a matrix.

#include <continua/boundary/boundary_conditions.h>

#include "../parameter_text.h"

#include <deal.II/base/mpi.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace shell
{
/// A roller inside, a support outside, one fixed end, free boundaries elsewhere. The ranks take
/// turns: each writes the file that it reads.
inline std::vector<Continua::BoundaryCondition>
read_conditions(const unsigned int dim, const std::vector<std::string> &regions)
{
  std::vector<std::string> names = {"inner", "outer", "left", "bottom", "back"};
  names.resize(dim + 2);
  std::string text = "subsection Boundaries\n"
                     "subsection inner\nset Type = roller\nend\n"
                     "subsection outer\nset Type = support\nset Normal stiffness = 2e3\n"
                     "set Tangential damping = 30\nend\n"
                     "subsection left\nset Type = fixed\nend\n"
                     "subsection bottom\nset Type = free\nend\n";
  text += dim == 3 ? "subsection back\nset Type = free\nend\nend\n" : "end\n";
  std::set<std::pair<unsigned int, unsigned int>> pairs;
  for (unsigned int boundary = 0; boundary < names.size(); ++boundary)
    for (unsigned int region = 0; region < regions.size(); ++region)
      pairs.insert({boundary, region});
  std::vector<Continua::BoundaryCondition> conditions;
  for (unsigned int rank = 0; rank < dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
       ++rank)
  {
    if (rank == dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD))
    {
      Continua::ParameterFile file = parameters_of(text);
      conditions = Continua::read_boundary_conditions(file.root().subsection("Boundaries"), names,
                                                      regions, pairs, dim, false);
    }
    MPI_Barrier(MPI_COMM_WORLD);
  }
  return conditions;
}
} // namespace shell

#endif
