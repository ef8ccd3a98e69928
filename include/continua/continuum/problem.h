#ifndef continua_continuum_problem_h
#define continua_continuum_problem_h

#include <continua/boundary/boundary_condition.h>
#include <continua/boundary/outlet.h>
#include <continua/continuum/convection.h>
#include <continua/continuum/mesh_motion_kind.h>
#include <continua/continuum/region_model.h>
#include <continua/continuum/wall_directions_parameters.h>
#include <continua/materials/deformation.h>
#include <continua/materials/material.h>
#include <continua/materials/model.h>
#include <continua/materials/plane_stress.h>
#include <continua/signal/waveform.h>

#include <deal.II/base/exceptions.h>

#include <mpi.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace Continua
{
/// What is given inside the body: loads and the state at the start, each by Cartesian components.
struct InteriorData
{
  std::vector<Waveform>
      acceleration;                 ///< b [m/s^2], times the density of each region; empty is none
  std::vector<Waveform> body_force; ///< rho b [N/m^3]; empty is none
  std::vector<Expression> initial_velocity;     ///< [m/s]; empty is rest
  std::vector<Expression> initial_displacement; ///< [m] of branches that never relax; empty is none
  std::vector<Expression> initial_pressure;     ///< [Pa] one for each region; empty is none
  /// Whether a run in time starts from a state at rest under its loads: those at t = 0, or their
  /// mean over a period.
  bool starts_steady_under_loads = false, starts_under_mean_loads = false;

  /// Reads the sections `Body force` and `Initial state`. Throws InputError.
  void read(ParameterSection body_force_section,
            ParameterSection initial_state,
            const std::vector<std::string> &regions,
            unsigned int n_dimensions);
  /// What is to be said of its tables in a run to `end_time` [s], each sentence once.
  std::vector<Waveform::Remark> table_remarks(double end_time) const;
};

/// Fields of the output beside those that are always there.
struct FurtherFields
{
  bool vorticity = false;
  bool q_criterion = false;
  bool wall_shear_stress = false;
  bool wall_shear_averages = false; ///< the mean over time and the oscillatory shear index
};

/// Of the mean of the wall shear stress over time.
struct WallShearWindow
{
  bool is_kept = false; ///< whether anybody asks for it
  double begin = 0.;    ///< [s]
  double end = std::numeric_limits<double>::infinity();
};

/// The physical problem on one mesh, the same for every discretisation. Regions are numbered by
/// material id.
struct Problem
{
  MPI_Comm communicator = MPI_COMM_WORLD;
  Model model = Model::plane_strain;
  std::vector<std::string> regions;                     ///< names by material id
  std::vector<std::string> boundaries;                  ///< names by boundary id
  std::vector<Material> materials;                      ///< by material id
  std::vector<PlaneStressFactors> plane_stress_factors; ///< likewise; empty in other models
  std::vector<BoundaryCondition> conditions;
  std::vector<Outlet> outlets;
  InteriorData interior;
  Convection convection;
  Deformation deformation = Deformation::small;
  UnloadedShape unloaded_shape = UnloadedShape::mesh;
  /// Whether the mesh of the liquids follows solids in finite deformation or boundaries, and how.
  bool mesh_moves = false;
  /// Whether it moves before each step instead, as that of the cell-wise path.
  bool mesh_moves_between_steps = false;
  MeshMotionKind mesh_motion = MeshMotionKind::hyperelastic;
  WallDirectionsParameters wall_directions;
  NewtonParameters newton;
  FurtherFields further_fields;
  WallShearWindow wall_shear_window;

  /// Which equations a region has.
  RegionModel region_model(const unsigned int region) const
  {
    if (materials[region].is_solid())
      return deformation == Deformation::finite ? RegionModel::finite_solid : RegionModel::linear;
    return convection.is_on || some_mesh_moves() ? RegionModel::flow : RegionModel::linear;
  }
  bool some_mesh_moves() const { return mesh_moves || mesh_moves_between_steps; }
  /// Whether the equations of a region are those of its present shape.
  bool is_deformed(const unsigned int region) const
  {
    const RegionModel of_region = region_model(region);
    return of_region == RegionModel::finite_solid || (of_region == RegionModel::flow && mesh_moves);
  }
  bool has_regions_of(const RegionModel model_of_region) const
  {
    for (unsigned int region = 0; region < materials.size(); ++region)
      if (region_model(region) == model_of_region)
        return true;
    return false;
  }
  /// Whether the present shape of some region counts.
  bool has_deformed_regions() const
  {
    return some_mesh_moves() || has_regions_of(RegionModel::finite_solid);
  }
  /// Whether Newton's iteration makes the steps.
  bool is_nonlinear() const
  {
    return has_regions_of(RegionModel::flow) || has_regions_of(RegionModel::finite_solid);
  }
  /// Whether the mesh has the shape under the loads of the start, of which the unloaded one is
  /// found.
  bool finds_unloaded_shape() const { return unloaded_shape == UnloadedShape::inverse_solve; }
  /// Whether what is around the body supports it somewhere.
  bool has_supports() const
  {
    return std::any_of(conditions.begin(), conditions.end(),
                       [](const BoundaryCondition &condition) { return condition.is_supported(); });
  }
  /// Whether a cavity is a body of liquid, of which the boundary is an opening.
  bool is_filled(const BoundaryCondition &cavity) const
  {
    return std::any_of(cavity.region_ids.begin(), cavity.region_ids.end(),
                       [this](const unsigned int region) { return !materials[region].is_solid(); });
  }
  /// The numbers of the conditions that enclose a cavity.
  std::vector<unsigned int> cavities() const
  {
    std::vector<unsigned int> numbers;
    for (unsigned int i = 0; i < conditions.size(); ++i)
      if (conditions[i].is_cavity())
        numbers.push_back(i);
    return numbers;
  }
  /// The numbers of the conditions whose pressure is an unknown.
  std::vector<unsigned int> unknown_pressures() const
  {
    std::vector<unsigned int> numbers;
    for (unsigned int i = 0; i < conditions.size(); ++i)
      if (conditions[i].has_unknown_pressure())
        numbers.push_back(i);
    return numbers;
  }
  /// Of a region in any model.
  PlaneStressFactors plane_stress(const unsigned int region) const
  {
    Assert(model != Model::plane_stress || !plane_stress_factors.empty(),
           dealii::ExcMessage("A problem of plane stress needs the factors of its regions."));
    return plane_stress_factors.empty() ? PlaneStressFactors() : plane_stress_factors[region];
  }
};
} // namespace Continua

#endif
