#include <continua/case/theory/stream_case.h>

#include <continua/case/theory/tube_wave_case.h>
#include <continua/theory/korteweg.h>
#include <continua/vessel/tube_law.h>

#include <stdexcept>

namespace Continua
{
template <int dim>
std::string make_stream_case(const Case<dim> &input, StreamCase &stream_case)
{
  if (std::string why_not = why_no_tube_of_liquid(input); !why_not.empty())
    return why_not;
  const std::vector<VesselBranch<dim>> branches = input.geometry->branches();
  if (branches.size() > 1 || !branches.front().law.is_uniform())
    return "the tube's section is not one along its length";
  for (const BoundaryCondition &condition : input.problem.conditions)
    if (condition.tangential.is_supported())
      return "the wall is supported along the axis ('" + condition.name + "')";
  const WaveTheoryParameters &parameters = input.wave_theory;
  const TubeSection section = tube_section_at(input, branches.front().law, 0.);
  const double omega = 2. * dealii::numbers::PI * parameters.stream_frequency;
  stream_case.distensibility = 0.;
  if (!section.layers.empty())
  {
    const Complex young = section.hoop_modulus(omega);
    if (!(std::abs(young) > 0.))
      return "the wall yields to a pressure at rest; give 'Mean flow frequency'";
    const LongWaveTube wall{section.inner_radius, section.wall_thickness(),
                            section.poisson_ratio(omega).real(), section.fluid.density, 0.};
    const Complex speed = korteweg_speed(
        wall, young, section.tethered ? Anchoring::throughout : Anchoring::expansion_joints,
        WallTheory::thick);
    stream_case.distensibility = 1. / (section.fluid.density * speed * speed);
  }
  const double viscosity = section.fluid.shear.viscosity;
  if (omega > 0. && !(viscosity > 0.))
    return "a liquid without viscosity slips; leave 'Mean flow frequency' out";
  stream_case.waves =
      std::make_unique<StreamWaves>(parameters.stream, section.inner_radius, section.fluid.density,
                                    viscosity, section.fluid.inverse_bulk_modulus());
  try
  {
    for (const StreamWall wall : {StreamWall::mesh_that_stays, StreamWall::moving})
      stream_case.waves->long_wave_speed(stream_case.distensibility.real(),
                                         StreamWaves::Direction::against_stream, wall);
  }
  catch (const std::domain_error &error)
  {
    return error.what();
  }
  return "";
}

template std::string make_stream_case(const Case<2> &, StreamCase &);
template std::string make_stream_case(const Case<3> &, StreamCase &);
} // namespace Continua
