// The section Cell-wise: what the two variants are by default, what is given over them, and which
// unknowns the words mean.

#include "../parameter_text.h"

#include <continua/finite_volume/cell_wise_parameters.h>

#include "../unit_test.h"

#include <tuple>

namespace test_of_cell_wise_parameters
{
namespace
{
using namespace Continua;

CellWiseParameters read(const std::string &entries)
{
  ParameterFile file = parameters_of("subsection Cell-wise\n" + entries + "end\n");
  CellWiseParameters parameters;
  parameters.read(file.root().subsection("Cell-wise"));
  file.refuse_unknown();
  return parameters;
}

/// The entries that the variants differ by.
auto scheme(const CellWiseParameters &p)
{
  return std::make_tuple(p.rhie_chow, p.rhie_chow_in_time, p.stencil_coefficient, p.pressure_update,
                         p.boundary_pressure, p.boundary_velocity_as);
}
} // namespace

UNIT_TEST(cell_wise_parameters)
{
  const CellWiseParameters right = read("");
  check::is_true("by default",
                 scheme(right) ==
                     std::make_tuple(RhieChow::increment, RhieChowInTime::momentum_of_faces,
                                     StencilCoefficient::automatic, PressureUpdate::as_displacement,
                                     BoundaryPressure::definition, BoundaryVelocityAs::automatic));
  check::is_true("coupled", !right.is_segregated());
  auto thesis = std::make_tuple(RhieChow::pressure, RhieChowInTime::made_anew,
                                StencilCoefficient::longitudinal, PressureUpdate::trapezoidal,
                                BoundaryPressure::momentum, BoundaryVelocityAs::gradient);
  check::is_true("thesis", scheme(read("set Variant = thesis\n")) == thesis);
  std::get<RhieChow>(thesis) = RhieChow::none;
  check::is_true("thesis but for one",
                 scheme(read("set Rhie-Chow = none\nset Variant = thesis\n")) == thesis);

  check::is_true("pressure by Euler",
                 read("set Pressure update = euler\n").pressure_update == PressureUpdate::euler);
  check::is_true("the cell's gradient", read("set Boundary gradient = cell\n").boundary_gradient ==
                                            BoundaryGradient::cell);
  check::is_true("by default the face's", right.boundary_gradient == BoundaryGradient::replaced);

  struct Row
  {
    std::string formulation;
    Formulation type;
    bool has_pressure, faces_balance;
  };
  for (const Row &words :
       {Row{"displacement", Formulation::displacement, false, false},
        Row{"velocity", Formulation::velocity, false, false},
        Row{"velocity explicit pressure", Formulation::velocity_explicit_pressure, true, false},
        Row{"velocity-pressure", Formulation::velocity_pressure, true, true}})
  {
    const CellWiseParameters p = read("set Formulation = " + words.formulation + "\n");
    check::is_true(words.formulation, p.formulation == words.type &&
                                          p.has_pressure() == words.has_pressure &&
                                          p.faces_balance() == words.faces_balance);
    check::is_true(words.formulation + ", faces by balance",
                   read("set Formulation = " + words.formulation +
                        "\nset Velocity at boundaries as = balance\n")
                       .faces_balance());
    check::is_true(words.formulation + ", faces by value",
                   !read("set Formulation = " + words.formulation +
                         "\nset Velocity at boundaries as = value\n")
                        .faces_balance());
  }
  check::is_true("pressures of faces",
                 read("set Pressure at boundaries = momentum\n").boundary_pressure ==
                         BoundaryPressure::momentum &&
                     read("set Pressure at boundaries = zero gradient\n").boundary_pressure ==
                         BoundaryPressure::zero_gradient &&
                     right.boundary_pressure == BoundaryPressure::definition);
  check::is_true("segregated", read("set Solution = segregated\n").is_segregated());
  check::throws<InputError>(
      "no corrections", []() { read("set Maximum corrections = 0\n"); }, "Maximum corrections");
  check::throws<InputError>(
      "no such formulation", []() { read("set Formulation = pressure\n"); },
      "Formulation.*velocity-pressure");
}
} // namespace test_of_cell_wise_parameters
