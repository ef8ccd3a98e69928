// Stations of a tube: what the solver is asked for, with which factor, the whole flow rate of a
// quarter of a tube, and what is refused.

#include "../parameter_text.h"

#include <continua/base/input_error.h>
#include <continua/postprocess/stations.h>

#include <deal.II/grid/grid_generator.h>

#include "../unit_test.h"

namespace test_of_stations
{
namespace
{
using namespace Continua;

template <int dim>
using Column = typename Stations<dim>::Column;

/// A box along x, 1 m long, from y = `begin` to y = 1: the inner half is water, the outer one wall.
/// In 3-D from z = `begin_z` besides, in few cells, and all water.
template <int dim>
void make_tube(dealii::Triangulation<dim> &mesh, const double begin, const double begin_z)
{
  dealii::Point<dim> corner, end;
  corner[1] = begin;
  for (unsigned int c = 0; c < dim; ++c)
    end[c] = 1.;
  std::vector<unsigned int> cells(dim, 2);
  if (dim == 3)
  {
    corner[dim - 1] = begin_z;
    cells = {1, begin < 0. ? 2u : 1u, begin_z < 0. ? 2u : 1u};
  }
  dealii::GridGenerator::subdivided_hyper_rectangle(mesh, cells, corner, end);
  for (const auto &cell : mesh.active_cell_iterators())
  {
    cell->set_material_id(dim == 3 || cell->center()[1] < 0.5 * (begin + 1.) ? 1 : 0);
  }
}

/// Reads, sets and checks.
template <int dim>
Stations<dim> make(const std::string &entries,
                   const std::vector<std::string> &fields,
                   const double begin = 0.,
                   const double begin_z = 0.)
{
  ParameterFile file = parameters_of("subsection Probe\n" + entries + "end\n");
  ParameterSection section = file.root().subsection("Probe");
  std::string ignored;
  section.add("Fields", ignored, "");
  Stations<dim> stations;
  stations.add_entries(section);
  stations.set(section, fields, {"wall", "water"}, {});
  dealii::Triangulation<dim> mesh;
  make_tube<dim>(mesh, begin, begin_z);
  stations.check(section, mesh);
  return stations;
}

void refuses(const std::string &name,
             const std::string &entries,
             const std::vector<std::string> &fields,
             const std::string &pattern,
             const double begin = 0.)
{
  check::throws<InputError>(
      name, [&]() { make<2>("set Fluid = water\n" + entries, fields, begin); }, pattern);
}
} // namespace

UNIT_TEST(stations)
{
  using Kind = ProbeRequest<2>::Kind;
  const std::vector<std::string> fields = {
      "pressure",          "axis  pressure",    "flow rate",  "wall distension",
      "pressure gradient", "wall shear stress", "hoop stress"};
  const std::string entries =
      "set Stations = 0.1 m, 25 cm\nset Fluid = water\nset Pair distance = 5 cm\n";
  const Stations<2> stations = make<2>(entries, fields);
  check::is_true("positions",
                 stations.given() && stations.positions() == std::vector<double>{0.1, 0.25});
  check::absolute("pair distance", stations.pair_distance(), 0.05, 1e-17);
  check::equal("label", stations.label(1), "0.25 m");
  const std::vector<Column<2>> columns = stations.columns();
  check::is_true("one for each station and field",
                 columns.size() == 14 && columns[6].station == 0 && columns[7].station == 1);
  const auto names = [&]()
  {
    std::string text;
    for (unsigned int i = 7; i < 14; ++i)
      text += (i > 7 ? ", " : "") + columns[i].field.name + " " + columns[i].field.unit;
    return text;
  };
  check::equal("fields", names(),
               "pressure Pa, axis pressure Pa, flow rate m^3/s, wall distension m, "
               "pressure gradient Pa/m, wall shear stress Pa, hoop stress Pa");
  // Of the second station; region 1 is the water.
  const auto asks = [&](const unsigned int column, const unsigned int term, const Kind kind,
                        const std::string &field, const unsigned int region, const double position,
                        const double factor)
  {
    const auto &[request, present_factor] = columns[7 + column].terms.at(term);
    return request.kind == kind && request.field == field &&
           request.region_ids == std::set<unsigned int>{region} &&
           std::abs(request.point[0] - position) < 1e-15 && request.point[1] == 0. &&
           std::abs(present_factor - factor) < 1e-12 * std::abs(factor);
  };
  check::is_true("pressure", asks(0, 0, Kind::section_mean, "pressure", 1, 0.25, 1.));
  check::is_true("axis pressure", asks(1, 0, Kind::point, "pressure", 1, 0.25, 1.));
  check::is_true("flow rate", asks(2, 0, Kind::section_flow, "", 1, 0.25, 1.));
  check::is_true("wall distension", asks(3, 0, Kind::rim_mean, "radial displacement", 1, 0.25, 2.));
  check::is_true("pressure gradient",
                 asks(4, 0, Kind::section_mean, "pressure", 1, 0.275, 20.) &&
                     asks(4, 1, Kind::section_mean, "pressure", 1, 0.225, -20.) &&
                     columns[11].terms.size() == 2);
  const auto downstream = make<2>("set Stations = 0.25\nset Fluid = water\nset Pair distance = 5 "
                                  "cm\nset Pair = downstream\n",
                                  {"pressure gradient", "velocity integral"})
                              .columns();
  check::absolute("pair downstream, first", downstream[0].terms[1].first.point[0], 0.25, 1e-15);
  check::absolute("pair downstream, second", downstream[0].terms[0].first.point[0], 0.3, 1e-15);
  check::is_true("velocity integral", downstream[1].terms[0].first.kind == Kind::section_integral &&
                                          downstream[1].terms[0].first.field == "axial velocity");
  check::is_true("wall shear stress", asks(5, 0, Kind::rim_mean, "wall shear stress", 1, 0.25, 1.));
  check::is_true("hoop stress", asks(6, 0, Kind::section_mean, "hoop stress", 0, 0.25, 1.));
  check::is_true("none are given", !Stations<2>().given());

  // A half and a quarter of the circumference.
  const std::vector<std::string> flow = {"flow rate"};
  const auto copies = [&](const double begin, const double begin_z)
  { return make<3>(entries, flow, begin, begin_z).columns()[0].terms[0].second; };
  check::absolute("half a tube", copies(0., -1.), 2., 0.);
  check::absolute("a quarter", copies(0., 0.), 4., 0.);

  refuses("outside", "set Stations = 1.5 m\n", flow,
          "1.5 m is outside the tube.*between 0 m and 1 m");
  refuses("the second one of a pair", "set Stations = 0.99 m\nset Pair = downstream\n",
          {"pressure gradient"}, "needs the section at 1.007 m, which is outside");
  refuses("the first one of a pair", "set Stations = 5 mm\n", {"pressure gradient"},
          "needs the section at -0.0035 m, .*between 0.0085 m and 0.9915 m");
  refuses("twice", "set Stations = 0.5, 0.5\n", flow, "0.5 m is given twice");
  refuses("behind", "set Stations = 0.5, 0.2\n", flow, "0.2 m stands behind 0.5 m");
  refuses("unknown field", "set Stations = 0.5\n", {"presure"}, "no field 'presure'.*pressure");
  refuses("field twice", "set Stations = 0.5\n", {"flow rate", "flow rate"}, "recorded twice");
  refuses("beside the axis", "set Stations = 0.5\n", {"axis pressure"},
          "the axis is not in the fluid", 0.1);
}
} // namespace test_of_stations
