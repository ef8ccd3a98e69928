#ifndef continua_tests_finite_element_conditions_in_turn_h
#define continua_tests_finite_element_conditions_in_turn_h

// Boundary conditions from a text, in tests on several ranks.

#include <continua/boundary/boundary_conditions.h>
#include <continua/finite_element/conditions/boundary_constraints.h>

#include "../parameter_text.h"

#include <deal.II/base/mpi.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

/// Of the entries of a section Boundaries. The ranks take turns: each writes the file that it
/// reads. `pairs`: boundaries and materials that meet.
inline std::vector<Continua::BoundaryCondition>
conditions_in_turn(const std::string &entries,
                   const std::vector<std::string> &boundaries,
                   const std::vector<std::string> &materials,
                   const std::set<std::pair<unsigned int, unsigned int>> &pairs,
                   const unsigned int dim)
{
  std::vector<Continua::BoundaryCondition> conditions;
  for (unsigned int rank = 0; rank < dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
       ++rank)
  {
    if (rank == dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD))
    {
      Continua::ParameterFile file = parameters_of("subsection Boundaries\n" + entries + "end\n");
      conditions = Continua::read_boundary_conditions(file.root().subsection("Boundaries"),
                                                      boundaries, materials, pairs, dim, false);
    }
    MPI_Barrier(MPI_COMM_WORLD);
  }
  return conditions;
}

/// Of a plane box of two regions along x: a roller on the left and a fixed bottom.
inline std::vector<Continua::BoundaryCondition> conditions_of_two_regions()
{
  return conditions_in_turn("subsection left\nset Type = roller\nend\n"
                            "subsection right\nset Type = free\nend\n"
                            "subsection bottom\nset Type = fixed\nend\n"
                            "subsection top\nset Type = free\nend\n",
                            {"left", "right", "bottom", "top"}, {"one", "two"},
                            {{0, 0}, {1, 1}, {2, 0}, {2, 1}, {3, 0}, {3, 1}}, 2);
}

#endif
