#include <continua/boundary/flow_rate_entries.h>

#include <continua/boundary/boundary_entries.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Continua
{
namespace
{
/// Through a plane channel.
constexpr Dimension flow_rate_of_depth{0, 2, -1};

/// Entries of some profiles alone.
void refuse_other_profile(const ParameterSection &section,
                          const std::optional<FlowProfile::Shape> &profile,
                          const FlowProfile::Shape user,
                          const std::string &word,
                          const std::vector<std::string> &keys)
{
  for (const std::string &key : keys)
    if (profile != user && section.given(key))
      section.refuse(key, "is of use with Profile = " + word + " only",
                     "Set that, or remove the entry");
}

void read_profile_table(ParameterSection &section, BoundaryCondition &condition)
{
  std::string file, column;
  Interpolant::Kind kind = Interpolant::Kind::linear;
  section.add_input_file("Profile table", file,
                         "A csv file of the velocity over the distance from the centre, with a "
                         "header such as 'r [mm], U [m/s]'. It must cover the section.");
  section.require("Profile table");
  section.add("Profile column", column,
              "The column of the velocity; may be left out if there is but one.");
  add_choice(section, "Profile interpolation", kind,
             {{"linear", Interpolant::Kind::linear}, {"cubic", Interpolant::Kind::cubic}},
             "Between the rows; cubic is smooth and does not overshoot.");
  // Without a file the documentation of the entries is made.
  if (!file.empty())
    condition.profile_table = std::make_shared<const ProfileTable>(file, kind, column);
}

void read_flow_past(ParameterSection &section, BoundaryCondition &condition)
{
  add_choice(section, "Flow before the start", condition.past, flow_past_words(),
             "What the liquid of a womersley profile did before t = 0: at rest - nothing; steady - "
             "it carried the flow rate of t = 0; periodic - it carried the flow rate of 'Period' "
             "again and again, so that the flow is periodic from the start.");
  const bool is_periodic = condition.past == FlowPast::periodic;
  if (!is_periodic && section.given("Period"))
    section.refuse("Period", "is of use with Flow before the start = periodic only",
                   "Set that, or remove the entry");
  if (!is_periodic)
    return;
  double period = std::numeric_limits<double>::infinity();
  section.add("Period", period, Dimensions::time, "After which the flow rate repeats itself.",
              Range::positive());
  section.require("Period");
  condition.period = period;
}
} // namespace

void read_flow_rate(ParameterSection &section, BoundaryCondition &condition, unsigned int)
{
  using Shape = FlowProfile::Shape;
  const Waveform flow_rate =
      condition.is_in_plane
          ? Waveform::read(section, "Flow rate", flow_rate_of_depth,
                           "Flow rate of the whole channel and of a unit of its depth, into the "
                           "body; a function of time alone.",
                           true)
          : Waveform::read(section, "Flow rate", Dimensions::flow_rate,
                           "Flow rate of the whole tube, into the body; a function of time alone.",
                           true);
  if (flow_rate.depends_on_space())
    section.refuse(
        "Flow rate", "depends on x, y or z",
        "Write it as a function of t; 'Profile' gives the distribution over the section");
  // Without a shape it is free.
  std::optional<Shape> profile = Shape::parabolic;
  add_choice(section, "Profile", profile,
             {{"flat", Shape::flat},
              {"parabolic", Shape::parabolic},
              {"womersley", Shape::womersley},
              {"table", Shape::table},
              {"free", std::nullopt}},
             "How the velocity is distributed over the section: flat (zero at the rim), "
             "parabolic (the developed flow), womersley: that of a viscous liquid in a rigid tube "
             "or channel with this flow rate and 'Flow before the start', or table: as "
             "'Profile table' has it, scaled to the flow rate and zero at the rim. Or free, with "
             "Deformation = finite: as the equations have it, through a present section of any "
             "shape that may widen, on which one unknown pressure acts.");
  refuse_other_profile(section, profile, Shape::table, "table",
                       {"Profile table", "Profile column", "Profile interpolation"});
  refuse_other_profile(section, profile, Shape::womersley, "womersley",
                       {"Flow before the start", "Period"});
  if (profile == Shape::table)
    read_profile_table(section, condition);
  if (profile == Shape::womersley)
    read_flow_past(section, condition);
  if (!profile)
  {
    condition.free_flow = FreeFlow{flow_rate};
    read_tangential(section, condition);
    // With a static one the liquid that flows in can gain energy.
    read_inflow_pressure(section, condition, InflowPressure::total);
    return;
  }
  for (const char *const key : {"Tangential", "Inflow pressure"})
    if (section.given(key))
      section.refuse(key, "with this profile the velocity is given on all of the section",
                     "Remove the entry, or set Profile = free");
  condition.profile = profile;
  condition.normal.kind = condition.tangential.kind = BoundaryPart::Kind::velocity;
  condition.normal.along_normal = flow_rate;
}
} // namespace Continua
