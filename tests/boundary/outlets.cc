// The outlets of boundary conditions: for the part of the tube that is modelled, of liquids only.

#include <continua/boundary/boundary_conditions.h>
#include <continua/boundary/flow_rates.h>
#include <continua/boundary/outlets.h>

#include "../parameter_text.h"
#include "../unit_test.h"

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <cmath>

namespace test_of_outlets
{
using namespace Continua;
using namespace dealii;

namespace
{
const std::string windkessel =
    "set Type = windkessel\nset Proximal resistance = 3\nset Distal resistance = 40\n"
    "set Compliance = 0.02\nset Initial pressure = 5\n";

/// The outlets of a body whose boundary 0 is `text` and boundary 1 a resistance of 7.
template <int dim>
std::vector<Outlet> outlets(const std::string &text,
                            const Triangulation<dim> &mesh,
                            const Material &material,
                            const bool axisymmetric)
{
  ParameterFile file = parameters_of("subsection end\n" + text +
                                     "end\nsubsection other\nset Type = resistance\n"
                                     "set Resistance = 7\nend\n");
  std::vector<BoundaryCondition> conditions = read_boundary_conditions(
      file.root(), {"end", "other"}, {"body"}, {{0, 0}, {1, 0}}, dim, axisymmetric);
  set_flow_profiles(conditions, file.root(), mesh, {material}, {false, 1., 0.1});
  return make_outlets(conditions, file.root(), mesh, {material});
}

void check_fraction(const std::string &name, const Outlet &outlet, const double fraction)
{
  // The pressure of the modelled part's flow is that of the tube's; a compliance of the part has
  // the part of the volume.
  check::relative(name + ": proximal resistance", outlet.impedance.direct(0, 0), 3. / fraction,
                  1e-12);
  check::relative(name + ": compliance", outlet.impedance.terms[0].residue(0, 0),
                  1. / (0.02 * fraction), 1e-12);
  check::relative(name + ": rate", outlet.impedance.terms[0].rate, 1. / (40. * 0.02), 1e-12);
  check::relative(name + ": initial state", outlet.initial_states[0], 5. * 0.02 * fraction, 1e-12);
}
} // namespace

UNIT_TEST(outlets)
{
  Material liquid;
  liquid.shear.viscosity = 1.;
  Material solid = liquid;
  solid.shear.branches.push_back({10., 1.});

  // A tube of length 2 around the x axis; its end at x = 0 is boundary 0, the rest boundary 1.
  const auto tube = [](const bool quarter)
  {
    Triangulation<2> coarse, disc;
    if (quarter)
      GridGenerator::quarter_hyper_ball(coarse);
    else
      GridGenerator::hyper_ball(coarse);
    // Straight cells, small enough for a disc.
    coarse.refine_global(2);
    GridGenerator::flatten_triangulation(coarse, disc);
    auto along_z = std::make_unique<Triangulation<3>>();
    GridGenerator::extrude_triangulation(disc, 2, 2., *along_z);
    along_z->reset_all_manifolds();
    along_z->set_all_manifold_ids(numbers::flat_manifold_id);
    // z becomes x.
    GridTools::transform([](const Point<3> &p) { return Point<3>(p[2], p[0], p[1]); }, *along_z);
    for (const auto &cell : along_z->active_cell_iterators())
    {
      cell->set_material_id(0);
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary())
          cell->face(f)->set_boundary_id(std::abs(cell->face(f)->center()[0]) < 1e-9 ? 0 : 1);
    }
    return along_z;
  };
  const auto whole = outlets<3>(windkessel, *tube(false), liquid, false);
  check::is_true("two outlets", whole.size() == 2 && whole[0].name == "end" &&
                                    whole[0].conditions == std::vector<unsigned int>{0} &&
                                    whole[1].conditions == std::vector<unsigned int>{1});
  check_fraction("whole tube", whole[0], 1.);
  check::relative("no disc: the rest of the boundary", whole[1].impedance.direct(0, 0), 7., 1e-12);
  const auto quarter = tube(true);
  check_fraction("quarter", outlets<3>(windkessel, *quarter, liquid, false)[0], 0.25);
  check_fraction("quarter, held by the flow",
                 outlets<3>(windkessel + "set Coupling = flow\n", *quarter, liquid, false)[0],
                 0.25);
  check::is_true("an absorbing end is another's business",
                 outlets<3>("set Type = absorbing\n", *quarter, liquid, false).size() == 1);

  Triangulation<2> plane;
  GridGenerator::hyper_cube(plane, 0., 1., true);
  for (const auto &cell : plane.active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
      cell->face(f)->set_boundary_id(f == 0 ? 0 : 1);
  check_fraction("axisymmetric", outlets<2>(windkessel, plane, liquid, true)[0], 1.);
  check_fraction("plane", outlets<2>(windkessel, plane, liquid, false)[0], 1.);

  check::throws<InputError>(
      "an outlet of a solid", [&] { outlets<2>(windkessel, plane, solid, true); },
      "'end/Type'.*belongs to a solid.*liquid's 'Region'");
}
} // namespace test_of_outlets
