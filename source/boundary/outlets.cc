#include <continua/boundary/outlets.h>

#include <continua/mesh/round_section.h>

#include <stdexcept>

namespace Continua
{
template <int dim>
double fraction_of_section(const BoundaryCondition &condition,
                           const dealii::Triangulation<dim> &coarse_mesh)
{
  if (dim == 2)
    return 1.;
  try
  {
    return find_round_section(coarse_mesh, condition.boundary_id, condition.region_ids).fraction;
  }
  catch (const std::invalid_argument &)
  {
    return 1.;
  }
}

namespace
{
void take_part(Outlet &outlet, const double fraction)
{
  outlet.impedance.direct *= 1. / fraction;
  for (Impedance::Term &term : outlet.impedance.terms)
    term.residue *= 1. / fraction;
  for (double &state : outlet.initial_states)
    state *= fraction;
}
} // namespace

template <int dim>
std::vector<Outlet> make_outlets(const std::vector<BoundaryCondition> &conditions,
                                 ParameterSection boundaries,
                                 const dealii::Triangulation<dim> &coarse_mesh,
                                 const std::vector<Material> &materials)
{
  std::vector<Outlet> outlets;
  for (unsigned int c = 0; c < conditions.size(); ++c)
  {
    const BoundaryCondition &condition = conditions[c];
    if (!condition.outlet || condition.outlet->impedance.n_ports() == 0)
      continue;
    for (const unsigned int region : condition.region_ids)
      if (materials[region].is_solid())
        boundaries.subsection(condition.name)
            .refuse("Type", "the boundary belongs to a solid, out of which nothing flows",
                    "Name the liquid's 'Region' and give the solid's part a condition of its own");
    outlets.push_back(*condition.outlet);
    outlets.back().conditions = {c};
    take_part(outlets.back(), fraction_of_section(condition, coarse_mesh));
  }
  return outlets;
}

template double fraction_of_section(const BoundaryCondition &, const dealii::Triangulation<2> &);
template double fraction_of_section(const BoundaryCondition &, const dealii::Triangulation<3> &);
template std::vector<Outlet> make_outlets(const std::vector<BoundaryCondition> &,
                                          ParameterSection,
                                          const dealii::Triangulation<2> &,
                                          const std::vector<Material> &);
template std::vector<Outlet> make_outlets(const std::vector<BoundaryCondition> &,
                                          ParameterSection,
                                          const dealii::Triangulation<3> &,
                                          const std::vector<Material> &);
} // namespace Continua
