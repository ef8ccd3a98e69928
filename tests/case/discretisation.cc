// What a discretisation reads, what else a file may hold, and what is to be cited for it.

#include <continua/base/citations.h>
#include <continua/case/discretisation.h>

#include "../parameter_text.h"
#include "../unit_test.h"

#include <deal.II/base/mpi.h>

namespace test_of_discretisation
{
using namespace Continua;

namespace
{
std::string joined(const std::vector<std::string> &words)
{
  std::string text;
  for (const std::string &word : words)
    text += (text.empty() ? "" : ", ") + word;
  return text;
}
} // namespace

UNIT_TEST(discretisation)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  {
    ParameterFile file = parameters_of("subsection Finite element\n"
                                       "set Velocity degree = 3\n"
                                       "end\n");
    DiscretisationParameters parameters;
    parameters.read(file.root(), "taylor hood");
    file.refuse_unknown();
    check::is_true("finite elements", !parameters.is_cell_wise());
    check::is_true("their degree", parameters.velocities_per_cell() == 3);
    check::equal("their citation", joined(parameters.citations()), "hoodtaylor1973");
  }
  {
    // The sections of the other stay in the file when its word changes.
    ParameterFile file = parameters_of("subsection Finite element\n"
                                       "set Velocity degree = 3\n"
                                       "end\n"
                                       "subsection Cell-wise\n"
                                       "set Formulation = velocity-pressure\n"
                                       "set Solution = segregated\n"
                                       "end\n");
    DiscretisationParameters parameters;
    parameters.read(file.root(), "cell-wise");
    file.refuse_unknown();
    check::is_true("finite volumes", parameters.is_cell_wise());
    check::is_true("one velocity in a cell", parameters.velocities_per_cell() == 1);
    check::equal("citations of PISO", joined(parameters.citations()),
                 "jasakweller2000, rhiechow1983, issa1986");
    Citations citations;
    for (const std::string &key : parameters.citations())
      citations.add(key);
    check::is_true("they exist", citations.bibtex().find("Issa") != std::string::npos);
  }
  {
    ParameterFile file = parameters_of("subsection Cell-wise\n"
                                       "set Formulation = displacement\n"
                                       "end\n");
    DiscretisationParameters parameters;
    parameters.read(file.root(), "cell-wise");
    check::equal("citations without a pressure", joined(parameters.citations()), "jasakweller2000");
  }
  {
    ParameterFile file = parameters_of("subsection Cell-wise\n"
                                       "set Solution = implicit\n"
                                       "end\n");
    check::throws<InputError>(
        "an entry of the other that is wrong",
        [&file]() { DiscretisationParameters().read(file.root(), "taylor hood"); },
        "Cell-wise/Solution");
  }
}
} // namespace test_of_discretisation
