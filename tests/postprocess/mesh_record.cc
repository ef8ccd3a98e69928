// Means over time, and what transfers did, of three meshes; the same after a restart.

#include <continua/postprocess/mesh_record.h>

#include <cmath>
#include <filesystem>

#include "../unit_test.h"

namespace test_of_mesh_record
{
using namespace Continua;

namespace
{
SolverSizes sizes(const unsigned int n_cells)
{
  SolverSizes result;
  result.n_cells = n_cells;
  result.n_dofs = {{"velocity", 8 * n_cells}, {"pressure", 2 * n_cells}};
  return result;
}

double quantity(const Summary &summary, const std::string &name)
{
  for (const Quantity &candidate : summary.quantities())
    if (candidate.name == name)
      return candidate.value;
  return std::nan("");
}
} // namespace

UNIT_TEST(mesh_record)
{
  MeshRecord<2> first;
  first.start(sizes(100), 0.);
  first.change(sizes(300), 1., 2., 1.9);
  ArchiveWriter writer;
  first.save(writer);
  writer.write("mesh-record-test");
  MeshRecord<2> record;
  record.load(ArchiveReader("mesh-record-test"));
  std::filesystem::remove("mesh-record-test");
  record.change(sizes(50), 3., 4., 4.04);
  Summary summary;
  record.finish(4., summary);
  check::absolute("changes", quantity(summary, "mesh changes"), 2., 0.);
  check::relative("largest relative energy change",
                  quantity(summary, "largest relative energy change by transfer"), 0.05, 1e-12);
  // (1 x 100 + 2 x 300 + 1 x 50) / 4.
  check::relative("mean cells", quantity(summary, "cells (mean)"), 187.5, 1e-12);
  check::absolute("most cells", quantity(summary, "cells (largest)"), 300., 0.);
  check::relative("mean unknowns", quantity(summary, "unknowns (mean)"), 1875., 1e-12);
  check::absolute("most unknowns", quantity(summary, "unknowns (largest)"), 3000., 0.);
}
} // namespace test_of_mesh_record
