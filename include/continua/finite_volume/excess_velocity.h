#ifndef continua_finite_volume_excess_velocity_h
#define continua_finite_volume_excess_velocity_h

#include <continua/continuum/state_visitor.h>
#include <continua/finite_volume/cell_wise_system.h>
#include <continua/finite_volume/linear_reconstruction.h>
#include <continua/time_integration/step.h>

#include <array>
#include <vector>

namespace Continua
{
/**
 * The velocity e by which a face between two cells of a fluid moves faster, along its normal, than
 * the mean of its cells [m/s]. With a momentum of its own
 *
 *   rho de/dt + v e = -(compact - wide normal gradient of p)
 *
 * (v: the viscous part of the momentum diagonal over volume), it follows the scheme in time like
 * any other velocity, so that Rhie and Chow's correction of the flux, area times e, has a limit as
 * the time step falls, and a steady value that does not depend on the time step: S. K. Choi, Numer.
 * Heat Transfer B 36 (1999); A. Cubero, N. Fueyo, Numer. Heat Transfer B 52 (2007). In a step e is
 * -tau (compact - wide) p, which is in the matrix, less tau rho (a1 e_old + a2 e_older), which is
 * known beforehand.
 *
 * The state has e in the cells, so that it is saved and carried to another mesh like a velocity: of
 * each pair of opposite faces of a cell one component, along the way from the lower to the upper
 * face. Both cells beside a face have its value; the mean of the two counts where they differ,
 * after a change of the mesh.
 */
template <int dim>
class ExcessVelocity
{
public:
  /// All must outlive it.
  ExcessVelocity(const CellWiseSystem<dim> &system,
                 const LinearReconstruction<dim> &reconstruction);

  /// The mesh has changed; the vectors of the state keep what they have.
  void reinit();
  /// Whether a region has it.
  bool exists() const { return some_region; }
  void visit(StateVisitor &visitor);
  /// Adds what the past of e lets through the faces to g [m^3/s]. The system is that of the step.
  void add_past(const Step &step, DistributedVector &mass);
  /// rho (a1 e_old + a2 e_older) of the step of add_past(), on a face of the mesh [Pa/m]; 0 where
  /// there is no e.
  double past(const unsigned int face) const
  {
    return some_region && number_of[face] != VolumeFace<dim>::none ? faces[number_of[face]].past
                                                                   : 0.;
  }
  /// The step has balanced this pressure: e at its end. After add_past() of the same step.
  void advance(const Step &step, const DistributedVector &pressure);
  /// Adds the difference between what e lets out of each cell, and what the present system's
  /// correction makes of a pressure alone [m^3/s].
  void add_outflow(const DistributedVector &pressure, DistributedVector &target) const;

private:
  struct Face
  {
    unsigned int face = 0;      ///< of the mesh
    double density = 0.;        ///< [kg/m^3]
    Stencil<double> difference; ///< compact minus wide normal gradient of p [1/m]
    /// Share of the face in what the cell on either side has of it, with its sign; 0 on a side that
    /// has only the mean over several pieces.
    std::array<double, 2> weight = {};
    std::array<double, 2> share = {}; ///< of the face in the cell's mean
    double old = 0.;                  ///< e at the step's start [m/s]
    double past = 0.;                 ///< rho (a1 e_old + a2 e_older) [Pa/m]
  };
  using Slots = std::array<DistributedVector, 2>; ///< lower and upper faces

  const CellWiseSystem<dim> &system;
  const LinearReconstruction<dim> &reconstruction;
  bool some_region = false;
  std::vector<Face> faces;
  std::vector<unsigned int> number_of; ///< by face of the mesh, or none
  Slots present, older;

  /// Where a cell beside a face has its value.
  unsigned int slot(const Face &face, const unsigned int side) const
  {
    return system.space.mesh.faces()[face.face].number_in_cell[side] % 2;
  }
  unsigned int entry(const Face &face, unsigned int side) const;
  double value(const Face &face, const Slots &ghosted) const;
  Slots ghosted(const Slots &slots) const;
  /// Adds a velocity of the face to the outflow of the owned cells beside it.
  void add_to_cells(const Face &face, double velocity, DistributedVector &target) const;
};
} // namespace Continua

#endif
