// A state that is listed once: what its visitors size, carry over, save and load, by name and kind,
// and what an archive lacks.

#include <continua/base/input_error.h>
#include <continua/continuum/state_archive.h>
#include <continua/continuum/state_vectors.h>

#include "../unit_test.h"

#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <filesystem>
#include <numeric>

namespace test_of_state_archive
{
using namespace Continua;
using namespace dealii;

namespace
{
/// This rank's share of n entries.
IndexSet owned(const unsigned int n)
{
  return Utilities::create_evenly_distributed_partitioning(
      Utilities::MPI::this_mpi_process(MPI_COMM_WORLD),
      Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD), n);
}

DistributedVector vector_of(const unsigned int n)
{
  return DistributedVector(owned(n), MPI_COMM_WORLD);
}

VectorNumbering numbering_of(const std::string &name, const unsigned int n)
{
  const IndexSet indices = owned(n);
  std::vector<unsigned long> numbers;
  for (const auto i : indices)
    numbers.push_back(i);
  return VectorNumbering(MPI_COMM_WORLD, name, numbers);
}

struct Body
{
  DistributedVector velocity, velocity_older, pressure;
  std::vector<double> outlet = {0., 0.}, outlet_older = outlet;
  double time = 0.;
  bool is_current = false;
  KeptState kept{[this](StateVisitor &visitor) { visit(visitor); }};

  void visit(StateVisitor &visitor)
  {
    visitor.levels("velocity", StateKind::velocity, velocity, velocity_older);
    visitor.vector({"pressure", 3}, StateKind::pressure, pressure);
    visitor.levels({"outlet", 0, 1}, outlet.data(), outlet_older.data(), outlet.size());
    visitor.value("time", time);
    visitor.value("is current", is_current);
  }
};

const StateNumbering &numbering()
{
  static const StateNumbering result{numbering_of("velocity", 6), numbering_of("pressure", 5)};
  return result;
}

/// entry i = factor (1 + i).
void set(DistributedVector &vector, const double factor)
{
  unsigned int k = 0;
  for (const auto i : vector.locally_owned_elements())
    vector.begin()[k++] = factor * (1. + i);
}
bool is(const DistributedVector &vector, const double factor)
{
  unsigned int k = 0;
  double wrong = 0.;
  for (const auto i : vector.locally_owned_elements())
    wrong += vector.begin()[k++] == factor * (1. + i) ? 0. : 1.;
  return Utilities::MPI::sum(wrong, MPI_COMM_WORLD) == 0.;
}
} // namespace

UNIT_TEST(state_archive)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool is_first = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  if (!is_first)
    std::cout.setstate(std::ios::failbit);
  check::equal("a name with numbers", StateName("outlet", 0, 1).str(), "outlet 0, 1");
  const DistributedVector velocity = vector_of(6), pressure = vector_of(5);
  Body body;
  StateSizes sizes(velocity, pressure, pressure, pressure);
  body.visit(sizes);
  check::is_true("sizes by kind", body.velocity.size() == 6 && body.velocity_older.size() == 6 &&
                                      body.pressure.size() == 5);
  StateVectors vectors;
  body.visit(vectors);
  check::is_true("vectors by kind",
                 vectors.velocities ==
                         std::vector<DistributedVector *>({&body.velocity, &body.velocity_older}) &&
                     vectors.pressures == std::vector<DistributedVector *>({&body.pressure}));

  set(body.velocity, 2.);
  set(body.velocity_older, 3.);
  set(body.pressure, 5.);
  body.outlet = {7., 8.};
  body.outlet_older = {9., 10.};
  body.time = 0.1;
  body.is_current = true;
  const std::string file = "state_archive.archive";
  ArchiveWriter writer;
  save_state(writer, numbering(), body.kept);
  const std::string piece =
      file + "-" + std::to_string(Utilities::MPI::this_mpi_process(MPI_COMM_WORLD));
  writer.piece().write(piece);
  if (is_first)
    writer.write(file);
  MPI_Barrier(MPI_COMM_WORLD);
  const auto open = [&file]()
  {
    ArchiveReader reader(file);
    std::vector<std::string> pieces;
    for (unsigned int rank = 0; rank < Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD); ++rank)
      pieces.push_back(file + "-" + std::to_string(rank));
    reader.set_pieces(pieces);
    return reader;
  };
  Body other;
  other.visit(sizes);
  const ArchiveReader reader = open();
  load_state(reader, numbering(), other.kept);
  check::is_true("vectors",
                 is(other.velocity, 2.) && is(other.velocity_older, 3.) && is(other.pressure, 5.));
  check::is_true("numbers of an outlet",
                 other.outlet == body.outlet && other.outlet_older == body.outlet_older);
  check::is_true("a number and a flag", other.time == 0.1 && other.is_current);

  // One that asks for more than was saved.
  KeptState more{[&other](StateVisitor &visitor)
                 {
                   other.visit(visitor);
                   visitor.value("salinity", other.time);
                 }};
  check::throws<RunError>(
      "a part that is not there", [&]() { load_state(reader, numbering(), more); }, "salinity");
  KeptState longer{[](StateVisitor &visitor)
                   {
                     std::vector<double> present(3), older(3);
                     visitor.levels({"outlet", 0, 1}, present.data(), older.data(), 3);
                   }};
  check::throws<RunError>(
      "another number of numbers", [&]() { load_state(reader, numbering(), longer); },
      "outlet 0, 1.*another version");
  MPI_Barrier(MPI_COMM_WORLD);
  std::filesystem::remove(piece);
  if (is_first)
    std::filesystem::remove(file);
}
} // namespace test_of_state_archive
