#include "../unit_test.h"
#include "fake_solver.h"
#include "text_file.h"

#include <continua/base/input_error.h>
#include <continua/base/parameter_file.h>
#include <continua/postprocess/error_norms.h>

namespace test_of_error_norms
{
using namespace Continua;

namespace
{
template <int dim>
Summary run(const std::string &entries, const Model model)
{
  write_text("exact.prm", "subsection Exact solution\n" + entries + "end\n");
  ParameterFile file("exact.prm");
  ErrorNorms<dim> norms;
  norms.read(file.root().subsection("Exact solution"));
  file.refuse_unknown();
  FakeSolver<dim> solver;
  solver.state = 5.;
  Summary summary;
  norms.finish(solver, 2., model, summary);
  return summary;
}
} // namespace

UNIT_TEST(error_norms)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  check::is_true("nothing given", run<2>("", Model::plane_strain).quantities().empty());

  // At (2, 3, 5) and t = 2 the velocity is (2, 8): from (5, 5) it is sqrt(18) away and itself
  // sqrt(68) long.
  const Summary plane = run<2>("  set Velocity = y - 1, x*t^2\n"
                               "  set Pressure = 2 Pa\n",
                               Model::plane_strain);
  check::relative("velocity", quantity(plane, "L2 error of velocity"), std::sqrt(18.), 1e-14);
  check::relative("relative velocity", quantity(plane, "relative L2 error of velocity"),
                  std::sqrt(18. / 68.), 1e-14);
  check::equal("unit of velocity", quantity_unit(plane, "L2 error of velocity"), "m^2/s");
  check::relative("pressure", quantity(plane, "L2 error of pressure"), 3., 1e-14);
  check::relative("relative pressure", quantity(plane, "relative L2 error of pressure"), 1.5,
                  1e-14);
  check::absolute("no more", static_cast<double>(plane.quantities().size()), 4., 0.);

  const Summary space = run<3>("  set Displacement = 0, 0, 0\n", Model::three_dimensional);
  check::relative("displacement", quantity(space, "L2 error of displacement"), std::sqrt(75.),
                  1e-14);
  check::equal("unit of displacement", quantity_unit(space, "L2 error of displacement"),
               "m m^(3/2)");
  check::absolute("nothing relative to zero", static_cast<double>(space.quantities().size()), 1.,
                  0.);

  // From (5, 5, 5, 5) it is sqrt(9 + 4 + 16 + 1) away.
  const Summary stress = run<2>("  set Stress = x, y, z - 4, 2*t\n", Model::axisymmetric);
  check::relative("stress", quantity(stress, "L2 error of stress"), std::sqrt(30.), 1e-14);
  check::equal("unit of stress", quantity_unit(stress, "L2 error of stress"), "Pa m^(3/2)");
  check::relative("stress of six components",
                  quantity(run<3>("  set Stress = 5, 4, 3, 2, 1, 0\n", Model::three_dimensional),
                           "L2 error of stress"),
                  std::sqrt(55.), 1e-14);
  check::throws<InputError>(
      "components of stress",
      []() { run<3>("  set Stress = 1, 2, 3, 4\n", Model::three_dimensional); }, "exact.prm:2");

  check::throws<InputError>(
      "components", []() { run<2>("  set Velocity = x\n", Model::plane_strain); }, "exact.prm:2");
}
} // namespace test_of_error_norms
