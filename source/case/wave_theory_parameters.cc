#include <continua/case/wave_theory_parameters.h>

#include <limits>
#include <utility>

namespace Continua
{
void WaveTheoryParameters::read(ParameterSection section)
{
  section.add("Overlay", overlay,
              "Whether a transient run of a tube is compared with theory at the stations of its "
              "probes; where the theory does not cover the case there is none, unless it is asked "
              "for here.");
  overlay_given = section.given("Overlay") && overlay;
  section.add("Nonlinear", nonlinear,
              "Whether the one-dimensional nonlinear theory of the same tube stands beside the "
              "waves, too, with waves of finite height; also with Overlay = false.");
  section.add("Nonlinear cell length", nonlinear_cell_length, Dimensions::length,
              "Of the cells of the nonlinear theory, at most [m]; 0: 300 cells in a wave of the "
              "frequency below which 90 % of the energy of the load lies, 50 to 3000 in the tube.",
              Range::not_negative());
  if (section.given("Nonlinear cell length") && nonlinear_cell_length > 0. && !nonlinear)
    section.refuse("Nonlinear cell length", "there is no nonlinear theory: Nonlinear is false",
                   "Set Nonlinear = true, or leave the entry out");
  add_choice(section, "Level", level, wave_level_words(),
             "exact: viscous compressible liquid in a thick layered wall, pressure, axial "
             "and bending waves; closed formula: pressure wave of a thick wall; membrane: of a "
             "membrane; womersley: long waves in a thin wall.");
  add_choice(section, "Far end", far_end,
             {{"as the boundary", FarEnd::as_boundary},
              {"matched", FarEnd::matched},
              {"branches", FarEnd::branches}},
             "What the liquid meets at the outlet: what the boundary's condition says; the "
             "pressure wave's own impedance, so that it leaves without reflection; or "
             "branches, out of which nothing comes back (a bifurcation).");
  if (far_end == FarEnd::branches)
  {
    section.add("Branch diameters", branch_diameters, Dimensions::length,
                "Inner diameter of each branch [m].", Range::positive());
    section.add("Branch wall thicknesses", branch_wall_thicknesses, Dimensions::length,
                "Thickness of the wall of each branch [m].", Range::positive());
    section.add(
        "Branch Young's moduli", branch_youngs_moduli, Dimensions::pressure,
        "Young's modulus of the wall of each branch, which is thick, axially free and of Poisson's "
        "ratio 0.5 [Pa].",
        Range::positive());
    section.require("Branch diameters");
    for (const auto &[key, size] :
         {std::pair("Branch wall thicknesses", branch_wall_thicknesses.size()),
          std::pair("Branch Young's moduli", branch_youngs_moduli.size())})
      if (size != branch_diameters.size())
        section.refuse(key,
                       std::to_string(size) + " values stand beside " +
                           std::to_string(branch_diameters.size()) + " branch diameters",
                       "Give one for each branch");
  }
  section.add("Segments", segments,
              "Uniform segments that stand for a tube whose section varies [1].", 2);
  section.add(
      "Computed sections", computed_sections,
      "Segments whose exact waves are computed; those of the others are interpolated. 0: 6, "
      "or 40 of a tube from a table, which may vary more along its length [1].");
  if (computed_sections > 0 && computed_sections < 4)
    section.refuse("Computed sections", "a cubic between them needs four",
                   "Give 0 for an automatic number, or at least 4");
  section.add("Spectral tolerance", spectral_tolerance, Dimensions::none,
              "The inlet's spectrum is cut where it has fallen to this part of its largest value.",
              Range{1e-12, 0.1, false, false});
  section.add("Highest frequency", highest_frequency, Dimensions::frequency,
              "Of the dispersion table [Hz]; 0: the highest one kept of the inlet's spectrum.",
              Range::not_negative());
  section.add("Mean pressure", mean_pressure, Dimensions::pressure,
              "With Deformation = finite: the pressure in the tube about which the waves run. It "
              "inflates the tube from the shape of the mesh; the pressures of waves count from it "
              "[Pa].",
              Range::not_negative());
  section.add(
      "Mean flow", stream.mean_velocity, Dimensions::velocity,
      "Mean velocity over the section of a stream in the tube: the speeds of waves with and "
      "against it are reported [m/s]; 0: none.",
      Range::not_negative());
  add_choice(
      section, "Mean flow profile", stream.profile,
      {{"plug", StreamProfile::plug}, {"power law", StreamProfile::power_law}},
      "How the stream's velocity depends on the radius: plug - not at all, the liquid slips; "
      "power law - 1 - (r/R)^m, without slip.");
  section.add("Mean flow exponent", stream.exponent, Dimensions::none,
              "m of the power law; 2 is the flow of Poiseuille [1].",
              Range{2., std::numeric_limits<double>::infinity(), false, false});
  section.add("Mean flow frequency", stream_frequency, Dimensions::frequency,
              "Of the waves on the stream, whose liquid is viscous and sticks to the wall [Hz]; 0: "
              "long waves without viscosity only.",
              Range::not_negative());
  if (stream.mean_velocity == 0.)
    for (const char *key : {"Mean flow profile", "Mean flow exponent", "Mean flow frequency"})
      if (section.given(key))
        section.refuse(key, "there is no stream: Mean flow is 0",
                       "Set Mean flow, or leave the entry out");
  if (stream.profile == StreamProfile::plug)
    for (const char *key : {"Mean flow exponent", "Mean flow frequency"})
      if (section.given(key))
        section.refuse(key, "the plug has neither an exponent nor viscosity: its liquid slips",
                       "Leave the entry out, or set Mean flow profile = power law");
}
} // namespace Continua
