#include <continua/continuum/state_archive.h>

#include <continua/base/input_error.h>

#include <algorithm>
#include <string>
#include <vector>

namespace Continua
{
namespace
{
/// Of a state that is written and read: what the levels are called.
const std::string older_suffix = " older", eldest_suffix = " eldest";

/// Writes all of it, or the older level alone in the name of the eldest.
class StateWriter : public StateVisitor
{
public:
  StateWriter(ArchiveWriter &archive, const StateNumbering &numbering, const bool eldest)
      : archive(archive), numbering(numbering), eldest(eldest)
  {
  }
  bool takes_vectors() const override { return true; }
  void levels(const StateName &name,
              const StateKind kind,
              DistributedVector &present,
              DistributedVector &older) override
  {
    if (!eldest)
      save(name.str(), kind, present);
    save(name.str() + (eldest ? eldest_suffix : older_suffix), kind, older);
  }
  void vector(const StateName &name, const StateKind kind, DistributedVector &vector) override
  {
    if (!eldest)
      save(name.str(), kind, vector);
  }
  void levels(const StateName &name,
              double *const present,
              double *const older,
              const std::size_t n) override
  {
    if (!eldest)
      archive.add(name.str(), std::vector<double>(present, present + n));
    archive.add(name.str() + (eldest ? eldest_suffix : older_suffix),
                std::vector<double>(older, older + n));
  }
  using StateVisitor::value;
  void value(const StateName &name, double &number) override
  {
    if (!eldest)
      archive.add(name.str(), number);
  }

private:
  ArchiveWriter &archive;
  const StateNumbering &numbering;
  const bool eldest;

  void save(const std::string &name, const StateKind kind, const DistributedVector &vector)
  {
    numbering.of(kind).save(archive, name, vector);
  }
};

/// The same in the other direction.
class StateReader : public StateVisitor
{
public:
  StateReader(const ArchiveReader &archive, const StateNumbering &numbering, const bool eldest)
      : archive(archive), numbering(numbering), eldest(eldest)
  {
  }
  bool takes_vectors() const override { return true; }
  void levels(const StateName &name,
              const StateKind kind,
              DistributedVector &present,
              DistributedVector &older) override
  {
    if (!eldest)
      load(name.str(), kind, present);
    load(name.str() + (eldest ? eldest_suffix : older_suffix), kind, older);
  }
  void vector(const StateName &name, const StateKind kind, DistributedVector &vector) override
  {
    if (!eldest)
      load(name.str(), kind, vector);
  }
  void levels(const StateName &name,
              double *const present,
              double *const older,
              const std::size_t n) override
  {
    if (!eldest)
      load(name.str(), present, n);
    load(name.str() + (eldest ? eldest_suffix : older_suffix), older, n);
  }
  using StateVisitor::value;
  void value(const StateName &name, double &number) override
  {
    if (!eldest)
      number = archive.value(name.str());
  }

private:
  const ArchiveReader &archive;
  const StateNumbering &numbering;
  const bool eldest;

  void load(const std::string &name, const StateKind kind, DistributedVector &vector)
  {
    numbering.of(kind).load(archive, name, vector);
  }
  void load(const std::string &name, double *const numbers, const std::size_t n)
  {
    const std::vector<double> values = archive.values(name);
    if (values.size() != n)
      throw RunError("the checkpoint's '" + name + "' is that of another version of the program");
    std::copy(values.begin(), values.end(), numbers);
  }
};
} // namespace

const VectorNumbering &StateNumbering::of(const StateKind kind) const
{
  switch (kind)
  {
  case StateKind::velocity:
    return velocities;
  case StateKind::pressure:
    return pressures;
  case StateKind::mesh_vertex:
    return *mesh_vertices;
  default:
    return *internal_metrics;
  }
}

void save_state(ArchiveWriter &archive, const StateNumbering &numbering, const KeptState &state)
{
  numbering.velocities.save(archive);
  numbering.pressures.save(archive);
  if (numbering.internal_metrics)
    numbering.internal_metrics->save(archive);
  if (numbering.mesh_vertices)
    numbering.mesh_vertices->save(archive);
  StateWriter writer(archive, numbering, false), writer_of_eldest(archive, numbering, true);
  state.visit(writer);
  state.save(archive, writer_of_eldest);
}

void load_state(const ArchiveReader &archive, const StateNumbering &numbering, KeptState &state)
{
  StateReader reader(archive, numbering, false), reader_of_eldest(archive, numbering, true);
  state.load(archive, reader_of_eldest);
  state.visit(reader);
}
} // namespace Continua
