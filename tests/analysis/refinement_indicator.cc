// Painted regions, pressures by region and the field of the Kelly indicator: the pressure x^2 of
// the right half and a constant one on the left give normal derivatives that jump in the right half
// only; the velocity at rest gives none.

#include "../parameter_text.h"

#include <continua/analysis/refinement_indicator.h>
#include <continua/case/case.h>
#include <continua/program/analyses.h>

#include <deal.II/base/mpi.h>

#include "../unit_test.h"

namespace test_of_refinement_indicator
{
namespace
{
using namespace Continua;
using namespace dealii;

/// The largest indicator left and right of x = 2 m.
std::pair<double, double> largest(const std::string &field)
{
  ParameterFile file = parameters_of(
      "set Analysis = transient\nset Model = plane strain\n"
      "subsection Geometry\nset Type = box\nset Size = 4 m, 1 m\n"
      "subsection Regions\nset right = x - 2\nend\nend\n"
      "subsection Mesh\nset Cells = 8, 2\nend\n"
      "subsection Materials\n"
      "subsection body\nset Type = newtonian\nset Density = 1000 kg/m^3\n"
      "set Viscosity = 1 mPa s\nset Bulk modulus = 2 GPa\nend\n"
      "subsection right\nset Type = hookean\nset Density = 1000 kg/m^3\n"
      "set Young's modulus = 1 MPa\nset Poisson's ratio = 0.3\nend\nend\n"
      "subsection Initial state\nset Pressure = 7\n"
      "subsection Pressures\nset right = x^2\nend\nend\n"
      "subsection Boundaries\n"
      "subsection left\nset Type = fixed\nend\nsubsection right\nset Type = free\nend\n"
      "subsection bottom\nset Type = roller\nend\nsubsection top\nset Type = roller\nend\nend\n"
      "subsection Time\nset Time step = 1 ms\nset End time = 1 s\nend\n"
      "subsection Adaptivity\nset Every n steps = 1\nset Indicator = kelly\n"
      "set Indicator field = " +
      field + "\nend\n");
  Case<2> input = analyses().read_case<2>(file, MPI_COMM_WORLD);
  Log log(MPI_COMM_WORLD, false);
  const auto solver =
      make_solver<2>(*input.triangulation, input.problem, input.discretisation, log);
  solver->initialise();
  const Vector<float> indicator = refinement_indicator(input, *solver, 0.);
  double left = 0., right = 0.;
  for (const auto &cell : input.triangulation->active_cell_iterators())
  {
    double &half = cell->center()[0] < 2. ? left : right;
    half = std::max<double>(half, indicator[cell->active_cell_index()]);
  }
  return {left, right};
}
} // namespace

UNIT_TEST(refinement_indicator)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const auto [left, right] = largest("pressure");
  // Kelly's estimator of deal.II: h/24 times the integral of the squared jump over the faces of a
  // cell, and its root. Linear elements have the slopes x_i + x_(i+1), which jump by 2 h = 1 at
  // both faces across x of the height 0.5; the diagonal is h = sqrt(0.5).
  check::relative("pressure: right", right, std::sqrt(std::sqrt(0.5) / 24. * 2. * 0.5), 1e-6);
  check::absolute("pressure: left", left, 0., 1e-9 * right);
  const auto [velocity_left, velocity_right] = largest("velocity");
  check::absolute("velocity at rest", std::max(velocity_left, velocity_right), 0., 1e-12);
}
} // namespace test_of_refinement_indicator
