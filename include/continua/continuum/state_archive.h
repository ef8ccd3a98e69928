#ifndef continua_continuum_state_archive_h
#define continua_continuum_state_archive_h

#include <continua/base/archive.h>
#include <continua/continuum/kept_state.h>
#include <continua/continuum/vector_numbering.h>

#include <optional>

namespace Continua
{
/// How the vectors of the state are numbered on any number of ranks.
struct StateNumbering
{
  VectorNumbering velocities, pressures;
  std::optional<VectorNumbering> internal_metrics = {}; ///< where there are any
  std::optional<VectorNumbering> mesh_vertices = {};    ///< likewise

  const VectorNumbering &of(StateKind kind) const;
};

/// Writes the state, and what is kept of the one before, bit by bit.
void save_state(ArchiveWriter &archive, const StateNumbering &numbering, const KeptState &state);
/// Takes it back, on the same mesh and any number of ranks. Throws RunError if a part is missing.
void load_state(const ArchiveReader &archive, const StateNumbering &numbering, KeptState &state);
} // namespace Continua

#endif
