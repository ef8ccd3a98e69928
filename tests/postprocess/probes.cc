#include "../unit_test.h"
#include "fake_solver.h"
#include "text_file.h"

#include <continua/base/input_error.h>
#include <continua/base/parameter_file.h>
#include <continua/postprocess/probes.h>

#include <deal.II/base/numbers.h>
#include <deal.II/grid/grid_generator.h>

#include <filesystem>

namespace test_of_probes
{
using namespace Continua;

namespace
{
using Kind = ProbeRequest<2>::Kind;

/// A section Probes in file.prm, read and attached to the solver.
template <int dim>
Probes<dim> make(const std::string &entries, FakeSolver<dim> &solver, const Model model)
{
  write_text("probes.prm", "subsection Probes\n" + entries + "end\n");
  ParameterFile file("probes.prm");
  Probes<dim> probes(MPI_COMM_WORLD);
  probes.read(file.root().subsection("Probes"), {"inlet", "outlet"}, {"fluid", "wall"});
  file.refuse_unknown();
  probes.attach(solver, model);
  return probes;
}

/// What is refused in a child, with the pattern that the message matches.
void refuses(const std::string &name, const std::string &entries, const std::string &pattern)
{
  check::throws<InputError>(
      name,
      [&]()
      {
        FakeSolver<2> solver;
        make("subsection tip\n" + entries + "end\n", solver, Model::plane_strain);
      },
      pattern);
}

const std::string two_probes = "subsection tip\n"
                               "  set Fields = displacement, pressure\n"
                               "  set Point = 0.5 m, 25 cm\n"
                               "  set Region = wall\n"
                               "end\n"
                               "subsection out\n"
                               "  set Fields = velocity x\n"
                               "  set Boundary = outlet\n"
                               "  set Value = integral\n"
                               "end\n";

/// Four columns that change in time: t, 2 t, 3 t, 4 t + 0.1.
void set_values(FakeSolver<2> &solver, const double time)
{
  solver.value = [time](const ProbeRequest<2> &request)
  {
    if (request.kind != Kind::point)
      return 4. * time + 0.1;
    return time * (request.field == "displacement x" ? 1. : request.field == "pressure" ? 3. : 2.);
  };
}

void test_requests()
{
  FakeSolver<2> solver;
  // A probe of somebody else comes first.
  solver.add_probe({});
  Probes<2> probes = make(two_probes, solver, Model::plane_strain);
  check::absolute("columns", probes.n_columns(), 4., 0.);
  FakeSolver<2> section_solver;
  make("subsection cut\nset Fields = velocity x\nset Section = 50 cm\nset Value = integral\n"
       "set Region = fluid\nend\n",
       section_solver, Model::axisymmetric);
  const ProbeRequest<2> &cut = section_solver.requests.at(0);
  check::is_true("section", cut.kind == Kind::section_integral && cut.point[0] == 0.5 &&
                                cut.normal == dealii::Point<2>(1., 0.) &&
                                cut.region_ids == std::set<unsigned int>{0});
  check::equal("expanded", solver.requests[1].field + ", " + solver.requests[2].field,
               "displacement x, displacement y");
  check::is_true("point", solver.requests[3].kind == Kind::point &&
                              solver.requests[3].point == dealii::Point<2>(0.5, 0.25));
  check::is_true("region", solver.requests[1].region_ids == std::set<unsigned int>{1} &&
                               solver.requests[4].region_ids.empty());
  check::is_true("boundary", solver.requests[4].kind == Kind::boundary_integral &&
                                 solver.requests[4].boundary_ids == std::set<unsigned int>{1});

  probes.open("probes.csv");
  for (const double time : {0., 0.1, 0.2, 0.3})
  {
    set_values(solver, time);
    probes.record(time);
  }
  Summary summary;
  probes.finish(summary);
  const std::string header = "time [s],tip: displacement x [m],tip: displacement y [m],"
                             "tip: pressure [Pa],out: velocity x [m^2/s]\n";
  check::equal("file", read_text("probes.csv").substr(0, header.size() + 24),
               header + "0,0,0,0,0.1\n0.1,0.1,0.2,");
  const std::string whole = read_text("probes.csv");
  check::absolute("final of one among several",
                  quantity(summary, "final displacement y", "tip: displacement y"), 0.6, 1e-15);
  check::absolute("final of one", quantity(summary, "final velocity x", "out"), 1.3, 1e-15);

  // Continued from 0.1 s: the histories are again what they were, bit by bit.
  FakeSolver<2> second_solver;
  Probes<2> second = make(two_probes, second_solver, Model::plane_strain);
  second.open("probes.csv", 0.1);
  check::is_true("history after a restart",
                 second.times() == std::vector<double>{0., 0.1} &&
                     second.values(2) == std::vector<double>{0., 0.1 * 3.} &&
                     second.values(3) == std::vector<double>{0.1, 4. * 0.1 + 0.1});
  for (const double time : {0.2, 0.3})
  {
    set_values(second_solver, time);
    second.record(time);
  }
  Summary second_summary;
  second.finish(second_summary);
  check::equal("file after a restart", read_text("probes.csv"), whole);
  check::is_true("histories at the end",
                 second.times() == probes.times() && second.values(1) == probes.values(1));
  check::is_true("columns of a run that is no other",
                 [&]()
                 {
                   FakeSolver<2> other_solver;
                   Probes<2> other =
                       make("subsection tip\nset Fields = pressure\nset Point = 0, 0\nend\n",
                            other_solver, Model::plane_strain);
                   try
                   {
                     other.open("probes.csv", 0.1);
                   }
                   catch (const RunError &)
                   {
                     return true;
                   }
                   return false;
                 }());
}

void test_oscillation()
{
  // exp(-0.4 t) sin(2 pi 2 t) + a second mode at 5 Hz that decays faster.
  FakeSolver<2> solver;
  Probes<2> probes = make("subsection tip\n"
                          "  set Fields = displacement y\n"
                          "  set Point = 0, 0\n"
                          "  set Modes = 1.9 Hz, 5.2 Hz\n"
                          "end\n"
                          "subsection silent\n"
                          "  set Fields = pressure\n"
                          "  set Boundary = inlet\n"
                          "  set Signal analysis = false\n"
                          "end\n",
                          solver, Model::plane_strain);
  for (unsigned int n = 0; n <= 2000; ++n)
  {
    const double t = 0.002 * n;
    solver.value = [t](const ProbeRequest<2> &)
    {
      const double phase = 2. * dealii::numbers::PI * t;
      return 3e-3 * std::exp(-0.4 * t) * std::sin(2. * phase) +
             1e-4 * std::exp(-1. * t) * std::sin(5. * phase);
    };
    probes.record(t);
  }
  Summary summary;
  check::is_true("no warnings", probes.finish(summary).empty());
  check::relative("frequency", quantity(summary, "frequency", "tip"), 2., 2e-3);
  check::relative("frequency of the fit", quantity(summary, "frequency of the fit", "tip"), 2.,
                  1e-3);
  check::relative("decay", quantity(summary, "decay per oscillation", "tip"), std::exp(-0.2), 1e-2);
  check::relative("mode 1 frequency", quantity(summary, "mode 1 frequency", "tip"), 2., 1e-6);
  check::relative("mode 2 frequency", quantity(summary, "mode 2 frequency", "tip"), 5., 1e-6);
  check::relative("mode 1 decay", quantity(summary, "mode 1 decay per oscillation", "tip"),
                  std::exp(-0.4 / 2.), 1e-6);
  check::relative("mode 2 amplitude", quantity(summary, "mode 2 amplitude", "tip"), 1e-4, 1e-4);
  check::is_true("maximum after a quarter",
                 quantity(summary, "maximum displacement y", "tip") > 2.7e-3 &&
                     quantity(summary, "maximum displacement y", "tip") < 3e-3);
  check::absolute("time of maximum", quantity(summary, "time of maximum displacement y", "tip"),
                  0.125, 0.01);
  check::equal("unit of frequency", quantity_unit(summary, "frequency"), "Hz");
  check::is_true("no analysis where none is wanted",
                 std::isnan(quantity(summary, "final pressure", "silent")));
}

/// A quarter of a tube of radius 1 along x from 0 to 2, its wall from 0.5 on.
void test_stations()
{
  dealii::Triangulation<3> mesh;
  dealii::GridGenerator::subdivided_hyper_rectangle(mesh, {2, 2, 2}, dealii::Point<3>(),
                                                    dealii::Point<3>(2., 1., 1.));
  for (const auto &cell : mesh.active_cell_iterators())
    cell->set_material_id(cell->center()[1] < 0.5 && cell->center()[2] < 0.5 ? 0 : 1);
  const std::vector<FieldComponent> fields = {{"pressure", "Pa"}, {"radial displacement", "m"}};

  const auto read = [](const std::string &entries)
  {
    write_text("probes.prm", "subsection Probes\n subsection tube\n" + entries + "end\nend\n");
    return std::make_unique<ParameterFile>("probes.prm");
  };
  const auto file = read("set Stations = 100 mm, 0.9 m\n"
                         "set Pair distance = 500 mm\nset Pair = downstream\n"
                         "set Fields = pressure, axis pressure, flow rate, wall distension, "
                         "pressure gradient, wall shear stress, hoop stress\n");
  Probes<3> probes(MPI_COMM_WORLD);
  probes.read(file->root().subsection("Probes"), {"inlet"}, {"fluid", "wall"});
  file->refuse_unknown();
  probes.check(mesh, fields, {});
  FakeSolver<3> solver;
  solver.value = [](const ProbeRequest<3> &request)
  {
    if (request.field == "pressure")
      return 3. * request.point[0] + (request.kind == ProbeRequest<3>::Kind::point ? 7. : 0.);
    return 5. + 10. * request.region_ids.count(1);
  };
  probes.attach(solver, Model::three_dimensional);
  check::equal("column of a station", probes.column_names()[0], "tube 0.1 m: pressure [Pa]");
  check::equal("column of the last field", probes.column_names()[13],
               "tube 0.9 m: hoop stress [Pa]");
  probes.record(0.);
  const StationsProbe &tube = probes.stations().at(0);
  check::equal("name", tube.name, "tube");
  check::absolute("columns of the second station", tube.columns.at(1).at(2), 9., 0.);
  const auto at = [&](const unsigned int field)
  { return probes.values(tube.columns.at(1).at(field)).back(); };
  check::relative("section mean", at(0), 2.7, 1e-12);
  check::relative("on the axis", at(1), 9.7, 1e-12);
  check::relative("flow rate of the whole tube", at(2), 20., 1e-12);
  check::relative("distension is twice the displacement", at(3), 10., 1e-12);
  check::relative("pressure gradient", at(4), 3., 1e-12);
  check::relative("shear stress on the fluid's side", at(5), 5., 1e-12);
  check::relative("hoop stress of the wall", at(6), 15., 1e-12);
  Summary summary;
  probes.finish(summary);
  check::relative("quantity of a station",
                  quantity(summary, "final flow rate", "tube 0.9 m: flow rate"), 20., 1e-12);

  const auto refused =
      [&](const std::string &name, const std::string &entries, const std::string &pattern)
  {
    check::throws<InputError>(
        name,
        [&]()
        {
          const auto bad = read(entries);
          Probes<3> family(MPI_COMM_WORLD);
          family.read(bad->root().subsection("Probes"), {"inlet"}, {"fluid", "wall"});
          family.check(mesh, fields, {});
        },
        pattern);
  };
  refused("station outside", "set Stations = 10 cm, 2.1 m\nset Fields = pressure\n",
          "probes.prm:3: 'Probes/tube/Stations': the station 2.1 m .*between 0 m and 2 m");
  refused("pair sticks out",
          "set Stations = 1.99 m\nset Pair = downstream\nset Fields = pressure gradient\n",
          "probes.prm:3: .*2.007 m.*between 0 m and 1.983 m");
  refused("station twice", "set Stations = 10 cm, 0.1 m\nset Fields = pressure\n", "given twice");
  refused("no such field at stations", "set Stations = 1\nset Fields = velocity\n",
          "probes.prm:4: .*'velocity'.*There are: pressure, axis pressure");
  refused("no such fluid", "set Stations = 1\nset Fields = pressure\nset Fluid = blood\n",
          "probes.prm:5: 'Probes/tube/Fluid'");
  refused("pair without stations",
          "set Section = 1\nset Fields = pressure\nset Pair distance = 1\n",
          "probes.prm:5: .*belongs to Stations");
  refused("value of stations", "set Stations = 1\nset Fields = pressure\nset Value = mean\n",
          "probes.prm:5: 'Probes/tube/Value'");
  refused("section outside", "set Section = 3\nset Fields = pressure\n",
          "probes.prm:3: 'Probes/tube/Section': a section without area");
  refused("section and stations", "set Section = 1\nset Stations = 1\nset Fields = pressure\n",
          "more than one place");
}

void test_short_histories()
{
  FakeSolver<3> solver;
  solver.value = [](const ProbeRequest<3> &) { return 7.; };
  Probes<3> probes = make("subsection in\n"
                          "  set Fields = velocity x\n"
                          "  set Boundary = inlet\n"
                          "  set Value = integral\n"
                          "  set Modes = 2\n"
                          "end\n",
                          solver, Model::three_dimensional);
  probes.record(0.);
  Summary summary;
  const std::vector<std::string> warnings = probes.finish(summary);
  check::absolute("steady: one quantity", static_cast<double>(summary.quantities().size()), 1., 0.);
  check::absolute("steady: value", quantity(summary, "final velocity x", "in"), 7., 0.);
  check::equal("flow rate", quantity_unit(summary, "final velocity x"), "m^3/s");
  check::equal("modes of too few rows", warnings.empty() ? "" : warnings.front(),
               "the modes could not be fitted to velocity x of the probe 'in': it has too few "
               "rows");

  FakeSolver<2> unused;
  Probes<2> none = make("", unused, Model::plane_strain);
  none.open("none.csv");
  none.record(0.);
  none.finish(summary);
  check::is_true("no file without columns", !std::filesystem::exists("none.csv"));
}

/// A force is asked for by component, of all boundaries at once.
void test_forces()
{
  const std::string entries = "subsection walls\nset Fields = pressure, force\n"
                              "set Boundary = inlet, outlet\nend\n";
  FakeSolver<2> solver;
  const Probes<2> probes = make(entries, solver, Model::plane_strain);
  const std::vector<std::string> names = probes.column_names();
  check::equal("columns of forces", names.at(1) + ", " + names.at(2),
               "walls: force x [N/m], walls: force y [N/m]");
  const ProbeRequest<2> &request = solver.requests.at(2);
  check::is_true("force", request.kind == Kind::boundary_force && request.component == 1 &&
                              request.boundary_ids == std::set<unsigned int>{0, 1});
  check::is_true("pressure beside a force", solver.requests.at(0).kind == Kind::boundary_mean);
  FakeSolver<2> axisymmetric;
  check::equal("force about an axis",
               make(entries, axisymmetric, Model::axisymmetric).column_names().at(1),
               "walls: force x [N]");
}

void test_reference_point()
{
  FakeSolver<2> solver;
  Probes<2> probes = make("subsection drop\nset Fields = pressure\nset Point = 0.25 m, 0 m\n"
                          "set Reference point = 1 m, 0 m\nend\n",
                          solver, Model::plane_strain);
  solver.value = [](const ProbeRequest<2> &request) { return 8. - 4. * request.point[0]; };
  check::absolute("difference of two points", probes.present_values().at(0), 3., 1e-15);
}
/// Interfaces, fields of walls, positions and differences, as the solver is asked for them.
void test_walls()
{
  FakeSolver<2> solver;
  solver.value = [](const ProbeRequest<2> &request)
  {
    if (request.kind == Kind::sign_change)
      return request.number == 0 ? 3. : std::nan("");
    return request.boundary_ids.count(1) > 0 ? 2. : 7.;
  };
  Probes<2> probes =
      make("subsection wall\nset Interface = fluid, wall\n"
           "set Fields = force x\nend\n"
           "subsection shear\nset Interface = fluid, wall\n"
           "set Fields = wall shear stress y\nset Value = integral\nend\n"
           "subsection turn\nset Boundary = inlet\nset Fields = wall shear stress x\n"
           "set Sign changes = 2\nset Sign changes along = y\n"
           "set Sign changes between = 1 m, 2 m\nend\n"
           "subsection drop\nset Boundary = inlet\nset Reference boundary = outlet\n"
           "set Fields = pressure\nend\n",
           solver, Model::plane_strain);
  const ProbeRequest<2> &force = solver.requests.at(0), &shear = solver.requests.at(1),
                        &second = solver.requests.at(3);
  const std::set<unsigned int> fluid = {0}, wall = {1};
  check::is_true("force on an interface", force.kind == Kind::boundary_force &&
                                              force.region_ids == fluid &&
                                              force.neighbour_ids == wall && force.component == 0);
  check::is_true("shear on an interface", shear.kind == Kind::boundary_integral &&
                                              shear.field == "wall shear stress y" &&
                                              shear.neighbour_ids == wall);
  check::is_true("a second change of sign", second.kind == Kind::sign_change &&
                                                second.number == 1 && second.component == 1 &&
                                                second.range == std::pair<double, double>(1., 2.));
  std::string names;
  for (const std::string &name : probes.column_names())
    names += name + "; ";
  check::equal("columns on walls", names,
               "wall: force x [N/m]; shear: wall shear stress y [N/m]; "
               "turn: sign change 1 of wall shear stress x [m]; "
               "turn: sign change 2 of wall shear stress x [m]; drop: pressure [Pa]; ");
  check::absolute("a difference", probes.present_values().at(4), 5., 0.);

  // A position that is not there has no quantity.
  probes.open("walls.csv");
  probes.record(0.);
  probes.record(1.);
  Summary summary;
  probes.finish(summary);
  check::absolute("a position",
                  quantity(summary, "final sign change 1 of wall shear stress x",
                           "turn: sign change 1 of wall shear stress x"),
                  3., 0.);
  bool is_there = false;
  for (const Quantity &entry : summary.quantities())
    is_there = is_there || entry.name.find("sign change 2") != std::string::npos;
  check::is_true("no position", !is_there);
}
} // namespace

UNIT_TEST(probes)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    std::cout.setstate(std::ios::failbit); // one rank speaks

  test_requests();
  test_oscillation();
  test_stations();
  test_short_histories();

  test_forces();
  test_reference_point();

  const std::string point = "set Point = 0, 0\n";
  refuses(
      "unknown field", "set Fields = pressur\n" + point,
      "probes.prm:3: 'Probes/tip/Fields': .*'pressur'.*mean 'pressure'.*velocity x, velocity y");
  refuses("field twice", "set Fields = displacement, displacement y\n" + point, "twice");
  refuses("no field", point, "probes.prm:2: .*no field");
  refuses("no place", "set Fields = pressure\n", "probes.prm:2: 'Probes/tip': .*either Point or");
  refuses("two places", "set Fields = pressure\nset Boundary = inlet\n" + point,
          "probes.prm:4: .*either Point or");
  refuses("coordinates", "set Fields = pressure\nset Point = 1 mm\n", "probes.prm:4: .*Give 2");
  refuses("boundary twice", "set Fields = force\nset Boundary = inlet, outlet, inlet\n",
          "probes.prm:4: 'Probes/tip/Boundary': 'inlet' stands there twice");
  refuses("outside", "set Fields = pressure\nset Point = 2 m, 0 m\n",
          "probes.prm:4: 'Probes/tip/Point': the point is outside the mesh");
  refuses("unknown boundary", "set Fields = pressure\nset Boundary = outlt\n",
          "probes.prm:4: .*mean 'outlet'.*inlet, outlet");
  refuses("unknown region", "set Fields = pressure\nset Region = fluids\n" + point,
          "probes.prm:4: .*mean 'fluid'");
  refuses("mean of a point", "set Fields = pressure\nset Value = mean\n" + point,
          "probes.prm:4: 'Probes/tip/Value'");
  refuses("modes without analysis",
          "set Fields = pressure\nset Signal analysis = false\nset Modes = 2 Hz\n" + point,
          "probes.prm:5: 'Probes/tip/Modes'");
  refuses("unknown entry", "set Fields = pressure\nset Pont = 0, 0\n" + point, "Point");
  test_walls();
  const ProbeColumnName column{"tube", "tube 0.2 m", "pressure", false};
  check::is_true("a station in another unit", column.is_meant_by("tube 20 cm: pressure") &&
                                                  column.is_meant_by("tube 200 mm") &&
                                                  !column.is_meant_by("tube 20 mm"));
}
} // namespace test_of_probes
