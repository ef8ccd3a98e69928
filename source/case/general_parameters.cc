#include <continua/case/case.h>

namespace Continua
{
void GeneralParameters::read(ParameterSection root,
                             const std::vector<std::pair<std::string, std::string>> &analyses)
{
  root.add("Title", title, "What the run is called in summaries and legends.");
  std::vector<std::string> names;
  std::string text = "What is done:";
  for (const auto &type : analyses)
  {
    names.push_back(type.first);
    text += " " + type.first + " - " + type.second;
  }
  root.add_choice("Analysis", analysis, names, text);
  root.add_choice("Model", model, model_names(),
                  "The kinematics: plane strain, plane stress (Hookean solids only), axisymmetric "
                  "(x axial, y radial), "
                  "three-dimensional.");
  names.clear();
  text = "How the equations are discretised in space:";
  for (const auto &type : discretisation_types())
  {
    text += (names.empty() ? " " : "; ") + type.first + " - " + type.second;
    names.push_back(type.first);
  }
  root.add_choice("Discretisation", discretisation, names, text + ".");
  root.add_choice(
      "Convection", convection, {"none", "navier stokes"},
      "Convective terms of the equations: none - linear waves and creeping flow; navier "
      "stokes - momentum and pressure of the liquids are convected, and their density follows the "
      "pressure.");
  add_choice(
      root, "Deformation", deformation, deformation_words(),
      "How large the deformation of the solids may be: small - linear; finite - the "
      "equations are those of the deformed body, by the Strain law of each material, and "
      "the mesh of the liquids moves with the solids, and with boundaries of Mesh = follows.");
  add_choice(
      root, "Mesh motion", mesh_motion, mesh_motion_words(),
      "With finite deformation, how the motion of the solids is extended into the mesh of "
      "the liquids: hyperelastic - as a body whose energy grows without bound where a cell "
      "vanishes, linearised in each step; elastic - as a linear elastic body, with one "
      "factor for the whole run. Both are stiff where cells are small. On the cell-wise path "
      "the entry itself lets the mesh move, beside solids of small deformation, and is "
      "elastic.");
  add_choice(
      root, "Unloaded shape", unloaded_shape, unloaded_shape_words(),
      "With finite deformation, the shape in which the body is free of stress: mesh - that of "
      "the mesh; inverse solve - the mesh has the shape under the loads at t = 0, such as that "
      "of a vessel in an image, and one inverse solve, as the section Steady says, finds the "
      "shape from which these loads bring the body to it. The run starts in the shape of the "
      "mesh, in balance and at rest.");
}

void SteadyParameters::read(ParameterSection section, const bool is_nonlinear)
{
  section.add(
      "Time step", time_step, Dimensions::time,
      "First of the steps of backward Euler that lead to a steady state with convection or finite "
      "deformation. If it is not given, a first step without a solution is made anew at a "
      "quarter of its size until there is one. The state at rest does not depend on it. "
      "Linear steady equations are solved without steps.",
      Range::positive());
  finds_first_step = !section.given("Time step");
  section.add("Tolerance", tolerance, Dimensions::none,
              "The steps of backward Euler end when the velocity changes in one by less than this "
              "fraction of the largest velocity so far; the change of a step that was halved "
              "counts as that of Time step. The solves of the steady equations, which follow, "
              "end when one changes the displacement of each solid and the forces of each liquid "
              "by less than this fraction of them.",
              Range::positive());
  section.add("Maximum steps", maximum_steps, "Steps after which the run gives up [1].", 1);
  if (is_nonlinear)
    time_step_growth = 2.;
  section.add("Time step growth", time_step_growth, Dimensions::none,
              "Largest ratio of a step to the one before it; 1 keeps them at one size, with one "
              "matrix. With convection or finite deformation a step grows where Newton's iteration "
              "needed no more than "
              "half of its maximum, and a step without a solution is made anew at half its size.",
              Range{1., 100.});
  section.add("Time of loads", time_of_loads, Dimensions::time,
              "Time at which a steady analysis takes loads and prescribed velocities. With "
              "Unloaded shape = inverse solve the mesh has the shape under those at t = 0, and "
              "the displacement leads from there to the steady shape under those at this time.");
  section.add(
      "Load steps", load_steps,
      "Steps in which loads and prescribed velocities come, by equal parts, one for each "
      "time step; with a long Time step it is a continuation in the load, of a flow in the "
      "Reynolds number. A part without a solution is halved. With convection or finite "
      "deformation alone. After an inverse solve for the unloaded shape they also go through "
      "the times from 0 to Time of loads [1].",
      1);
}
} // namespace Continua
