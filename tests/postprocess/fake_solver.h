#ifndef continua_tests_postprocess_fake_solver_h
#define continua_tests_postprocess_fake_solver_h

#include <continua/continuum/continuum_solver.h>

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/shared_tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/lac/vector.h>

#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

/**
 * A solver without equations on the unit square or cube, whose answers a test sets: what the
 * postprocessors see of a real one.
 */
template <int dim>
class FakeSolver : public Continua::ContinuumSolver<dim>
{
public:
  FakeSolver()
      : triangulation(MPI_COMM_WORLD,
                      dealii::Triangulation<dim>::none,
                      false,
                      dealii::parallel::shared::Triangulation<dim>::partition_zorder),
        element(1),
        dof_handler(triangulation)
  {
    dealii::GridGenerator::subdivided_hyper_cube(triangulation, 2);
    dof_handler.distribute_dofs(element);
    pressure.reinit(dof_handler.n_dofs());
    pressure = 1.;
  }

  void initialise() override {}
  Continua::StepReport advance(const Continua::Step &) override { return {}; }
  void solve_steady(double) override {}
  void begin_averages() override {}
  void add_to_averages(double) override {}
  bool steady_is_direct() const override { return true; }
  bool data_jump(double, double) const override { return false; }

  std::vector<Continua::FieldComponent> fields() const override
  {
    return {{"velocity x", "m/s"},
            {"velocity y", "m/s"},
            {"displacement x", "m"},
            {"displacement y", "m"},
            {"pressure", "Pa"}};
  }
  unsigned int add_probe(const Continua::ProbeRequest<dim> &request) override
  {
    if (request.kind == Continua::ProbeRequest<dim>::Kind::point && request.point[0] > 1.)
      throw std::invalid_argument("the point is outside the mesh");
    requests.push_back(request);
    return static_cast<unsigned int>(requests.size() - 1);
  }
  void evaluate_probes(std::vector<double> &values) override
  {
    values.clear();
    for (const Continua::ProbeRequest<dim> &request : requests)
      values.push_back(value(request));
  }

  Continua::PowerBalance power_balance(bool) override { return balance; }
  Continua::Energy energy() override { return present_energy; }
  double divergence() override { return 0.; }
  Continua::MotionExtremes motion_extremes() override { return {}; }
  Continua::LiquidMass liquid_mass() override { return {}; }

  std::map<std::string, std::string> add_output(dealii::DataOut<dim> &data_out) override
  {
    data_out.attach_dof_handler(dof_handler);
    data_out.add_data_vector(pressure, "pressure");
    return {{"pressure", "Pa"}};
  }
  void indicators(const Continua::IndicatorRequest &, dealii::Vector<float> &) override {}
  Continua::StepError step_error() override { return {}; }
  void keep_state() override {}
  void return_to_kept_state() override {}
  void start_from_present_state() override {}
  void prepare_refinement() override {}
  void transfer() override {}
  void save(Continua::ArchiveWriter &) const override {}
  void load(const Continua::ArchiveReader &) override {}

  /// The distance of constants from zero on a body of volume 1: the state is `state` everywhere.
  double error_norm(Continua::ComparedField,
                    const std::vector<Continua::Expression> &exact,
                    const double time) override
  {
    const double point[3] = {2., 3., 5.};
    double square = 0.;
    for (unsigned int c = 0; c < exact.size(); ++c)
      square += std::pow(state - exact[c](point, time), 2);
    return std::sqrt(square);
  }
  Continua::SolverSizes sizes() const override { return {}; }

  // What the test sets.
  std::function<double(const Continua::ProbeRequest<dim> &)> value;
  Continua::PowerBalance balance;
  Continua::Energy present_energy;
  double state = 0.;
  // What the test looks at.
  std::vector<Continua::ProbeRequest<dim>> requests;

private:
  dealii::parallel::shared::Triangulation<dim> triangulation;
  dealii::FE_Q<dim> element;
  dealii::DoFHandler<dim> dof_handler;
  dealii::Vector<double> pressure;
};

#endif
