#include <continua/case/rules/rule_rows.h>

namespace Continua
{
namespace
{
using Names = std::vector<std::string>;

/// What goes before others: finite and small deformation, and what belongs to one of them.
std::vector<Rule> rules_of_deformation()
{
  return {
      {{"cavity"},
       {"small deformation"},
       "the volume of a cavity is that of the deformed body",
       "Set Deformation = finite, or give the boundary Type = pressure"},
      {{"crank nicolson"},
       {"cavity"},
       "a volume that is held in the middle of each step lets the pressure of the cavity swing "
       "from step to step",
       "Set Scheme = backward differencing or euler implicit"},
      {{"free profile"},
       {"cell-wise"},
       "the cell-wise path has no free profile",
       "Choose another profile, or set Discretisation = taylor hood"},
      {{"free profile"},
       {"mesh that stays"},
       "a free profile is that of a section which moves, and here the mesh stays",
       "Choose another profile, or set Deformation = finite"},
      {{"mesh that follows a boundary"},
       {"no steps in time"},
       "a mesh that follows a velocity is never at rest",
       "Set Mesh = fixed, or make the run transient from rest or from a state that is given"},
      {{"steady start"},
       {"mesh that follows a boundary"},
       "a mesh that follows a velocity is never at rest",
       "Set Mesh = fixed, or make the run transient from rest or from a state that is given"},
      {{"set Mesh motion", "set Boundaries/<name>/Mesh"},
       {"mesh that stays"},
       "with small deformation the mesh stays",
       "Remove the entry, or set Deformation = finite for a mesh that moves"},
      {{"set Mesh motion", "set Boundaries/<name>/Mesh"},
       {"no liquid"},
       "no region is a liquid, whose mesh would move",
       "Remove the entry"},
      {{"subsection Wall directions"},
       {"small deformation"},
       "fibres and prestretch are for finite deformation",
       "Remove the section, or set Deformation = finite"},
      {{"set Wave theory/Mean pressure"},
       {"small deformation"},
       "with small deformation a mean pressure does not change the waves",
       "Leave the entry out, or set Deformation = finite"},
      {{"unloaded shape"},
       {"small deformation"},
       "with small deformation the shape of the mesh is also the one without load",
       "Set Unloaded shape = mesh, or Deformation = finite"},
      {{"set Wave theory/Mean pressure"},
       {"finite deformation"},
       "a run has the pressures that act on the body",
       "Leave the entry out, or set Analysis = linear wave theory"},
      {{"finite deformation"}, {"modal"}, "vibrations are linear", "Set Deformation = small"},
      {{"finite deformation"},
       {"pulse response"},
       "this motion is linear about a body without loads",
       "Set Deformation = small, or use Analysis = transient"},
      {{"finite deformation"},
       {"plane stress"},
       "plane stress with finite deformation would need the strain across the plane as an unknown",
       "Set Model = plane strain or three-dimensional, or Deformation = small"},
      {{"finite deformation"},
       {"no solid, and no boundary that moves"},
       "no region is a solid, and the mesh of the liquids follows no boundary",
       "Set Deformation = small, or Mesh = follows for a boundary that moves"},
      {{"finite deformation of a solid"},
       {"cell-wise"},
       "the solids of the cell-wise path are for small deformation, beside which the mesh of the "
       "liquids may move",
       "Set Discretisation = taylor hood, or Deformation = small, with Mesh motion = elastic for a "
       "mesh that moves"},
      {{"steady start"},
       {"unloaded shape"},
       "after the inverse solve for the unloaded shape the run starts in the shape of the mesh, at "
       "rest under the loads at t = 0",
       "Remove the entry, or set Unloaded shape = mesh"},
      {{"set Initial state/Velocity", "set Initial state/Displacement",
        "set Initial state/Pressure", "subsection Initial state/Pressures"},
       {"unloaded shape"},
       "the inverse solve for the unloaded shape finds the state at t = 0 from the loads",
       "Remove it, or set Unloaded shape = mesh"},
      {{"weight"},
       {"unloaded shape"},
       "with an unloaded shape that is not the mesh's the mass at a place of the mesh is not its "
       "volume times the density, which the weight would need",
       "Give the weight as a Force density, or set Unloaded shape = mesh"},
      {{"cavity"},
       {"unloaded shape"},
       "the inverse solve for the unloaded shape needs the pressure of the loaded one, and a "
       "cavity has its volume given",
       "Give the boundary Type = pressure, or set Unloaded shape = mesh"},
      {{"subsection Wall directions"},
       {"no direction in any material"},
       "no material has fibres or a prestretch, which alone have directions",
       "Remove the section, or give a material a Strain law with fibres"},
      {{"volume that relaxes"},
       {"finite deformation"},
       "in finite deformation the volume change does not relax",
       "Set Volumetric relaxation = none, or Deformation = small"},
      {{"start from the shape of the mesh"},
       {"prestretch"},
       "with a prestretch the shape of the mesh is not in balance, and the run would start with a "
       "jump",
       "Set Type = steady: the run then starts from the state at rest under its loads"},
      {{"weight"},
       {"prestretch"},
       "with a prestretch the mass at a place of the mesh is not its volume times the density, "
       "which the weight would need",
       "Give the weight as a Force density, or remove the prestretch"},
      {{"solid without a spring that holds"},
       {"finite deformation"},
       "the material has no spring that holds: such a body flows until its mesh is turned inside "
       "out",
       "Take Type = prony with a small Young's modulus, or set Deformation = small"},
      {{"trapezoidal update"},
       {"finite deformation"},
       "finite deformation needs displacement and pressure at the level at which the step "
       "balances, which the trapezoidal update does not have",
       "Set Update = implicit"},
      {{"subsection Exact solution"},
       {"cell-wise mesh that moves"},
       "the error is an integral over the undeformed mesh, and the mesh moves",
       "Remove the section, and compare probes"},
      {{"set Exact solution/Stress"},
       {"finite deformation"},
       "the error of the stress is that of a small deformation",
       "Compare the displacement or the pressure"}};
}

/// Analyses of bodies that do not move in time, or move for ever. The readers of the sections
/// Modal, Boundaries, Materials and Periodic state refuse some of it themselves, with the same
/// sentence.
std::vector<Rule> rules_of_analyses()
{
  const Names frequency_domain = {"harmonic", "resonances", "periodic response", "pulse response"};
  return {
      {{"set Steady/Time of loads"},
       {"transient"},
       "a run in time starts under the loads at t = 0",
       "Remove the entry, or set Analysis = steady"},
      {{"power law", "solid without a spring that holds"},
       {"steady", "steady start", "unloaded shape"},
       "the stress of this solid relaxes to zero, so that it has no state at rest",
       "Use a law with a long-term modulus, or Initial state/Type = given and Unloaded shape = "
       "mesh in a run in time"},
      {{"liquid"},
       {"modal"},
       "a modal analysis is of solids, which a fluid is not",
       "Use Analysis = transient"},
      {{"solid that relaxes"},
       {"modal"},
       "this solid relaxes, so that its stiffness depends on the frequency and its vibrations die "
       "away",
       "Use hookean with the modulus at the frequency in question, or Analysis = transient"},
      {{"absorbing end"},
       {"modal"},
       "an end that takes waves up has no vibrations that last",
       "Use 'free', 'roller' or 'fixed', or Analysis = transient"},
      {{"network at an end"},
       {"no steps in time"},
       "a network goes on in time, in steps inside those of the body",
       "Use 'resistance' or 'windkessel', or Analysis = transient"},
      {{"highest modes"},
       {"taylor hood"},
       "the highest modes of the finite elements are not sought: with an incompressible material "
       "they have no bound",
       "Set Discretisation = cell-wise, or Which = lowest"},
      {{"iterative solver"},
       {"modal"},
       "vibrations have an indefinite matrix, which is solved directly",
       "Use automatic or direct"},
      {{"set Linear solver/Factor precision"},
       {"modal"},
       "the factor of vibrations has double precision",
       "Remove it"},
      {{"umfpack"},
       {"modal"},
       "umfpack does not tell the signs of its pivots, by which modes are counted",
       "Use automatic or mumps"},
      {{"cholmod"},
       {"shift of modes"},
       "cholmod does not pivot, which a shift needs",
       "Use automatic or mumps"},
      {{"shift of modes"},
       {"highest modes"},
       "the highest modes are sought without a shift",
       "Remove the entry"},
      {{"absorbing end"},
       {"steady"},
       "there is no wave in a state at rest that could leave",
       "Use 'pressure' or 'resistance', or Analysis = transient"},
      {{"adaptive steps"},
       {"periodic response"},
       "with an adaptive time step the beats do not have the same times, at which Periodic state "
       "compares them",
       "Set Time step control = fixed"},
      {{"womersley profile"},
       {"steady"},
       "a steady flow has no womersley profile",
       "Use 'parabolic', which is what that becomes"},
      {{"womersley profile of a liquid that was at rest"},
       {"steady start", "unloaded shape"},
       "the liquid of this profile is at rest before t = 0, and the flow steady",
       "Set Flow before the start = steady or periodic, or Initial state/Type = given and Unloaded "
       "shape = mesh"},
      {{"material that is no Hookean solid"},
       {"plane stress"},
       "plane stress is for Hookean solids only: with viscosity or relaxation the strain across "
       "the plane depends on history",
       "Use 'hookean' here, or Model = plane strain or three-dimensional"},
      {{"cell-wise"},
       frequency_domain,
       "the frequency domain needs the symmetric matrices of the finite elements, which the "
       "cell-wise path has not",
       "Set Discretisation = taylor hood, or use Analysis = transient"},
      {{"convection"},
       frequency_domain,
       "motion in the frequency domain is linear, and about a liquid at rest: a stream would make "
       "its matrix unsymmetric",
       "Set Convection = none, or use Analysis = transient"},
      {{"outlet that holds the flow rate"},
       frequency_domain,
       "in the frequency domain the distribution of the velocity over an outlet is free",
       "Set Coupling = pressure, or use Analysis = transient"},
      {{"womersley profile"},
       frequency_domain,
       "a womersley profile is that of a flow in time; the frequency domain has none so far",
       "Use 'flat', 'parabolic' or 'table', leave it out with Coupling = pressure, or use Analysis "
       "= transient"},
      {{"set Initial state/Velocity", "set Initial state/Displacement",
        "set Initial state/Pressure", "subsection Initial state/Pressures"},
       frequency_domain,
       "a motion that goes on for ever has no initial state",
       "Remove the entry, or use Analysis = transient"},
      {{"set Initial state/Type"},
       {"harmonic", "resonances", "pulse response"},
       "a motion that goes on for ever has no initial state",
       "Remove the entry, or use Analysis = transient"},
      {{"iterative solver"},
       frequency_domain,
       "the frequency domain has an indefinite complex matrix, which is solved directly",
       "Use automatic or direct"},
      {{"set Linear solver/Factor precision"},
       frequency_domain,
       "the complex factor has double precision",
       "Remove it"},
      {{"cholmod", "umfpack"},
       frequency_domain,
       "the complex factor is that of MUMPS",
       "Use automatic or mumps"},
      {{"checkpoints", "checkpoint at the end"},
       {"analysis without checkpoints"},
       "this analysis has no checkpoints",
       "Remove the entry"},
      {{"set Boundaries/<name>/Initial pressure"},
       {"no unloaded shape in a steady flow"},
       "a steady flow has no start, and gives the windkessel the charge that it has itself",
       "Remove the entry, or set Analysis = transient"},
      {{"averages of wall shear stress"},
       {"steady", "modal", "harmonic", "resonances", "pulse response"},
       "averages over time are those of a run in time or of a period, which this analysis has not",
       "Leave them out, or set Analysis = transient or periodic response"},
      {{"adaptive steps"},
       {"pulse response"},
       "the times of a pulse response have equal distances",
       "Set Time step control = fixed; 'Time step' is the distance of the rows"}};
}

} // namespace

const std::vector<Rule> &rules()
{
  static const std::vector<Rule> all = []
  {
    std::vector<Rule> list;
    for (const std::vector<Rule> &part :
         {rules_of_deformation(), rules_of_analyses(), rules_of_convection(),
          rules_of_explicit_convection(), rules_of_cells(), rules_of_moving_cells(),
          rules_of_solvers()})
      list.insert(list.end(), part.begin(), part.end());
    return list;
  }();
  return all;
}
} // namespace Continua
