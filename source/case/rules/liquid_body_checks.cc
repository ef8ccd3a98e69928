#include <continua/case/rules/liquid_body_checks.h>

#include <continua/mesh/connected_cells.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace Continua
{
using namespace dealii;

namespace
{
/// Coarse cells that hang together.
struct ConnectedBody
{
  std::set<unsigned int> regions, conditions;
  std::set<unsigned int> neighbours; ///< regions of other bodies that it touches
};

template <int dim>
std::vector<ConnectedBody> connected_bodies(const Case<dim> &input,
                                            const std::vector<unsigned int> &kind_of_region)
{
  const std::vector<unsigned int> numbers =
      connected_cells<dim>(*input.triangulation, kind_of_region);
  std::vector<ConnectedBody> bodies(
      numbers.empty() ? 0 : *std::max_element(numbers.begin(), numbers.end()) + 1);
  for (const auto &cell : input.triangulation->cell_iterators_on_level(0))
  {
    ConnectedBody &body = bodies[numbers[cell->index()]];
    body.regions.insert(cell->material_id());
    for (const unsigned int f : cell->face_indices())
      if (!cell->at_boundary(f))
      {
        if (numbers[cell->neighbor(f)->index()] != numbers[cell->index()])
          body.neighbours.insert(cell->neighbor(f)->material_id());
      }
      else
        for (unsigned int c = 0; c < input.problem.conditions.size(); ++c)
          if (const BoundaryCondition &condition = input.problem.conditions[c];
              condition.boundary_id == cell->face(f)->boundary_id() &&
              condition.region_ids.count(cell->material_id()) > 0)
            body.conditions.insert(c);
  }
  return bodies;
}

std::string names_of(const Problem &problem, const std::set<unsigned int> &regions)
{
  std::string text;
  for (const unsigned int region : regions)
    text += (text.empty() ? "'" : ", '") + problem.regions[region] + "'";
  return text;
}

/// An enclosed incompressible body has a pressure up to a constant only.
template <int dim>
void check_pressure_level(const Case<dim> &input, ParameterSection root)
{
  const Problem &problem = input.problem;
  std::vector<unsigned int> is_compressible;
  for (const Material &material : problem.materials)
    is_compressible.push_back(
        material.is_incompressible() ||
                // A steady flow without convection is that of Stokes, by one solve.
                (input.analysis.is_steady() && material.shear.branches.empty() &&
                 !problem.convection.is_on)
            ? 0
            : 1);
  for (const ConnectedBody &body : connected_bodies(input, is_compressible))
  {
    if (is_compressible[*body.regions.begin()] == 1 || !body.neighbours.empty() ||
        !std::all_of(body.conditions.begin(), body.conditions.end(),
                     [&problem](const unsigned int c)
                     {
                       return problem.conditions[c].normal.kind == BoundaryPart::Kind::velocity ||
                              problem.conditions[c].has_unknown_pressure();
                     }))
      continue;
    const bool is_part = body.regions.size() < problem.regions.size();
    root.subsection("Boundaries")
        .refuse("",
                "the body " + (is_part ? "of " + names_of(problem, body.regions) + " " : "") +
                    "is incompressible and the normal velocity is prescribed on all of its "
                    "boundary, or the volume behind it or the flow rate, so that the pressure is "
                    "determined up to a "
                    "constant only",
                "Give one boundary a pressure, a traction or 'free', an outlet 'Coupling = "
                "pressure', or the material a bulk modulus");
  }
}

/// The bodies of liquid of cavities.
void check_filled_cavities(const Problem &problem,
                           const std::vector<ConnectedBody> &bodies,
                           ParameterSection root)
{
  std::map<const ConnectedBody *, const BoundaryCondition *> cavity_of_body;
  for (const unsigned int number : problem.cavities())
  {
    const BoundaryCondition &condition = problem.conditions[number];
    if (!problem.is_filled(condition))
      continue;
    ParameterSection section = root.subsection("Boundaries").subsection(condition.name);
    if (std::any_of(condition.region_ids.begin(), condition.region_ids.end(),
                    [&problem](const unsigned int region)
                    { return problem.materials[region].is_solid(); }))
      section.refuse("Type",
                     "the boundary has faces of solids and of liquids, and a cavity is either "
                     "empty, with walls that are solids, or a liquid with an opening",
                     "Give the part of the liquid a condition of its own, with Boundary and "
                     "Region");
    if (std::count_if(bodies.begin(), bodies.end(),
                      [number = number](const ConnectedBody &body)
                      { return body.conditions.count(number) > 0; }) > 1)
      section.refuse("Type",
                     "it opens several bodies of liquid that do not touch, and gives one volume",
                     "Give each of them a boundary of its own, with Boundary and Region");
    for (const ConnectedBody &body : bodies)
    {
      if (body.conditions.count(number) == 0)
        continue;
      if (const auto [found, is_new] = cavity_of_body.emplace(&body, &condition); !is_new)
        section.refuse("Type",
                       "the body of liquid behind it has its volume given by the boundary '" +
                           found->second->name + "' already",
                       "Give one of the two a pressure, a velocity or an outlet");
      if (body.neighbours.empty())
        section.refuse("Type",
                       "the body of liquid behind it has no solid beside it, so that its volume "
                       "cannot change",
                       "Prescribe a pressure, or model the wall");
    }
  }
}
} // namespace

template <int dim>
void check_bodies(const Case<dim> &input, ParameterSection root)
{
  check_pressure_level(input, root);
  const Problem &problem = input.problem;
  if (!problem.mesh_moves)
    return;
  std::vector<unsigned int> is_solid;
  for (const Material &material : problem.materials)
    is_solid.push_back(material.is_solid() ? 1 : 0);
  std::vector<ConnectedBody> liquids;
  for (const ConnectedBody &body : connected_bodies(input, is_solid))
    if (is_solid[*body.regions.begin()] == 0)
      liquids.push_back(body);
  check_filled_cavities(problem, liquids, root);
  if (!problem.finds_unloaded_shape())
    return;
  for (const ConnectedBody &body : liquids)
    if (std::none_of(body.conditions.begin(), body.conditions.end(),
                     [&problem](const unsigned int c)
                     {
                       const BoundaryCondition &condition = problem.conditions[c];
                       return condition.type != BoundaryType::axis &&
                              ((condition.normal.kind == BoundaryPart::Kind::traction &&
                                !condition.has_unknown_pressure()) ||
                               condition.outlet != nullptr);
                     }))
      root.refuse("Unloaded shape",
                  "the inverse solve for the unloaded shape needs the pressure of the loaded one, "
                  "and that of the liquid " +
                      names_of(problem, body.regions) +
                      " is given nowhere: it has no boundary with a pressure or an outlet",
                  "Give a boundary of the liquid a pressure, or set Unloaded shape = mesh");
}

template void check_bodies(const Case<2> &, ParameterSection);
template void check_bodies(const Case<3> &, ParameterSection);
} // namespace Continua
