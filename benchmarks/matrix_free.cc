// What products without a matrix gain in three dimensions: the velocity block of a step in a
// water-filled elastic tube, assembled and formed anew in every product, with each instruction set
// and in both precisions; beside the other parts of an iteration of the Krylov solver.
//
//   benchmark_matrix_free OUTPUT SOURCE_DIRECTORY [--large]
//
// writes OUTPUT.txt and OUTPUT.md. --large: a third mesh, of 0.5 million velocities.

#include "measurement.h"

#include <continua/case/case.h>
#include <continua/finite_element/products/matrix_free_product.h>
#include <continua/finite_element/products/region_operators.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/matrix_product.h>
#include <continua/program/analyses.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <Epetra_CrsMatrix.h>

#include <cmath>
#include <map>
#include <random>

namespace Benchmarks
{
using namespace Continua;

constexpr unsigned int n_repetitions = 7;
/// Each repetition takes as many calls as fit into this time, and at least one [s].
constexpr double repetition_time = 0.1;
constexpr double largest_difference = 1e-12;

/// A thing to be measured and what it keeps.
struct Part
{
  std::string name;
  double bytes;
  std::function<void()> call;
  double time = 0.; ///< of a call [s]
};

/// Median processor times of the calls, measured in turn.
void measure(std::vector<Part> &parts)
{
  std::vector<unsigned int> n_calls;
  std::vector<std::vector<double>> times(parts.size());
  for (const Part &part : parts)
  {
    part.call();
    n_calls.push_back(
        std::max(1u, static_cast<unsigned int>(repetition_time / processor_time(part.call))));
  }
  for (unsigned int repetition = 0; repetition < n_repetitions; ++repetition)
    for (std::size_t k = 0; k < parts.size(); ++k)
      times[k].push_back(processor_time(
                             [&]()
                             {
                               for (unsigned int i = 0; i < n_calls[k]; ++i)
                                 parts[k].call();
                             }) /
                         n_calls[k]);
  for (std::size_t k = 0; k < parts.size(); ++k)
    parts[k].time = median(times[k]);
}

/// sum over the regions of mass M + stiffness S, as one matrix.
void sum_matrices(const Space<3> &space,
                  const std::vector<RegionOperators> &operators,
                  const std::vector<double> &mass,
                  const std::vector<double> &stiffness,
                  dealii::TrilinosWrappers::SparseMatrix &sum)
{
  dealii::TrilinosWrappers::SparsityPattern pattern(space.velocity_owned, space.communicator);
  dealii::DoFTools::make_sparsity_pattern(space.velocity_dofs, pattern, space.velocity_hanging,
                                          false);
  pattern.compress();
  sum.reinit(pattern);
  std::vector<unsigned int> columns;
  std::vector<double> values;
  const auto add = [&](const Epetra_CrsMatrix &matrix, const double factor)
  {
    for (int row = 0; row < matrix.NumMyRows(); ++row)
    {
      int n = 0, *indices = nullptr;
      double *entries = nullptr;
      matrix.ExtractMyRowView(row, n, entries, indices);
      columns.assign(indices, indices + n);
      values.assign(entries, entries + n);
      for (double &value : values)
        value *= factor;
      sum.add(row, columns.size(), columns.data(), values.data());
    }
  };
  for (std::size_t region = 0; region < operators.size(); ++region)
  {
    add(operators[region].mass.trilinos_matrix(), mass[region]);
    add(operators[region].stiffness.trilinos_matrix(), stiffness[region]);
  }
  sum.compress(dealii::VectorOperation::add);
}

template <typename Number>
using Product = MatrixFreeProduct<3, Number>;

/// With the sets of instructions that this processor has.
template <typename Number>
std::vector<std::pair<std::string, std::unique_ptr<Product<Number>>>>
matrix_free_products(const typename Product<Number>::Input &input,
                     const typename Product<Number>::Coefficients &coefficients)
{
  std::vector<std::pair<std::string, std::unique_ptr<Product<Number>>>> result;
  for (const auto &[word, set] : instruction_set_words())
    if (can_run(set))
    {
      result.emplace_back(std::string("matrix-free, ") + word +
                              (sizeof(Number) == 4 ? ", single precision" : ""),
                          make_matrix_free_product<3, Number>(set, input));
      result.back().second->set(coefficients);
    }
  return result;
}

double bytes(const dealii::TrilinosWrappers::SparseMatrix &matrix)
{
  return 12. * static_cast<double>(matrix.n_nonzero_elements()) + 4. * matrix.m();
}

void bench(const std::string &source_directory, const std::string &cells, Report &report)
{
  std::vector<std::string> overrides;
  const std::vector<std::string> keys = {"Axial cells", "Radial cells", "Circumferential cells",
                                         "Wall cells"};
  std::istringstream numbers(cells);
  for (const std::string &key : keys)
  {
    std::string count;
    numbers >> count;
    overrides.push_back("Mesh/" + key + "=" + count);
  }
  ParameterFile file(source_directory + "/parameter_files/verification/elastic-tube-3d.prm",
                     overrides);
  Case<3> input = analyses().read_case<3>(file, MPI_COMM_WORLD);
  const Problem &problem = input.problem;
  Space<3> space(*input.triangulation, input.discretisation.taylor_hood.space, problem.model,
                 problem.regions.size());
  space.distribute();
  std::vector<RegionOperators> operators(problem.regions.size());
  assemble_region_operators(space, operators);

  std::vector<double> mass, stiffness;
  const Step step = crank_nicolson_step(0., input.time.time_step);
  for (const Material &material : problem.materials)
  {
    mass.push_back(step.a0 * material.density);
    stiffness.push_back(material.shear.viscosity + BranchHistory::step_stiffness(material, step));
  }
  dealii::TrilinosWrappers::SparseMatrix sum;
  sum_matrices(space, operators, mass, stiffness, sum);

  DistributedVector source = space.velocity_vector(), target = space.velocity_vector(),
                    part = space.velocity_vector(), pressure = space.pressure_vector(),
                    divergence = space.pressure_vector();
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> distribution(-1., 1.);
  for (double &value : source)
    value = distribution(generator);
  for (double &value : pressure)
    value = distribution(generator);

  std::vector<Part> parts;
  double region_bytes = 0., divergence_bytes = 0.;
  for (const RegionOperators &region : operators)
  {
    region_bytes += bytes(region.mass) + bytes(region.stiffness);
    divergence_bytes += bytes(region.divergence);
  }
  parts.push_back({"assembled, by region", region_bytes,
                   [&]()
                   {
                     target = 0.;
                     for (std::size_t region = 0; region < operators.size(); ++region)
                     {
                       multiply(operators[region].mass, part, source);
                       target.add(mass[region], part);
                       multiply(operators[region].stiffness, part, source);
                       target.add(stiffness[region], part);
                     }
                   }});
  parts.push_back({"assembled, one matrix", bytes(sum), [&]() { multiply(sum, target, source); }});

  multiply(sum, target, source);
  const auto products = matrix_free_products<double>(
      {space.mapping, space.velocity_dofs, space.velocity_hanging, false}, {mass, stiffness, {}});
  const auto single_products = matrix_free_products<float>(
      {space.mapping, space.velocity_dofs, space.velocity_hanging, false}, {mass, stiffness, {}});
  Product<double>::Vector free_source, free_target;
  products.front().second->initialise(free_source);
  products.front().second->initialise(free_target);
  std::copy(source.begin(), source.end(), free_source.begin());
  Product<float>::Vector single_source, single_target;
  single_products.front().second->initialise(single_source);
  single_products.front().second->initialise(single_target);
  std::copy(source.begin(), source.end(), single_source.begin());
  double difference = 0.;
  for (const auto &[name, product] : products)
  {
    product->multiply(free_target, free_source);
    double distance = 0.;
    for (std::size_t i = 0; i < free_target.locally_owned_size(); ++i)
      distance = std::max(distance, std::abs(free_target.local_element(i) - target.begin()[i]));
    difference = std::max(difference, distance / target.linfty_norm());
    parts.push_back({name, static_cast<double>(product->memory()),
                     [&free_source, &free_target, product = product.get()]()
                     { product->multiply(free_target, free_source); }});
  }
  for (const auto &[name, product] : single_products)
    parts.push_back({name, static_cast<double>(product->memory()),
                     [&single_source, &single_target, product = product.get()]()
                     { product->multiply(single_target, single_source); }});
  if (!(difference < largest_difference))
    throw std::runtime_error("the products differ by " + number(difference));

  parts.push_back({"B and B^T, assembled", divergence_bytes,
                   [&]()
                   {
                     for (const RegionOperators &region : operators)
                     {
                       multiply(region.divergence, divergence, source);
                       multiply_transposed(region.divergence, part, pressure);
                     }
                   }});
  dealii::TrilinosWrappers::PreconditionSSOR relaxation;
  relaxation.initialize(sum);
  parts.push_back({"SSOR of the one matrix", 0., [&]() { relaxation.vmult(target, source); }});
  measure(parts);

  const auto n_dofs = static_cast<double>(space.velocity_dofs.n_dofs());
  std::map<std::string, double> time;
  for (const Part &entry : parts)
    time[entry.name] = entry.time;
  const double assembled = time.at("assembled, one matrix");
  report.start_table(std::to_string(space.triangulation.n_active_cells()) + " cells, " +
                         std::to_string(space.velocity_dofs.n_dofs()) + " velocities, " +
                         std::to_string(space.pressure_dofs.n_dofs()) +
                         " pressures; largest relative difference of the products " +
                         number(difference),
                     {"", "time [ms]", "million dofs/s", "bytes/dof", "over the one matrix"});
  for (const Part &entry : parts)
    report.row({entry.name, number(1e3 * entry.time), number(1e-6 * n_dofs / entry.time),
                entry.bytes > 0. ? number(entry.bytes / n_dofs) : "-",
                number(assembled / entry.time)});

  // An iteration with the matrix multiplies once by the system and twice by A in the
  // preconditioner, between its two relaxations. One without it multiplies once in double and four
  // times in single precision. What more there is (stiff block, Schur complement,
  // orthogonalisation) is the same with both.
  const double best = time.at(products.back().first),
               best_single = time.at(single_products.back().first),
               divergence_time = time.at("B and B^T, assembled");
  const double with_matrix =
      3. * assembled + divergence_time + 2. * time.at("SSOR of the one matrix");
  const double without = best + 4. * best_single + divergence_time;
  report.row(
      {"an iteration: 3 products, B, B^T, 2 SSOR", number(1e3 * with_matrix), "-", "-", "1"});
  report.row({"an iteration: 5 products without a matrix, B, B^T", number(1e3 * without), "-", "-",
              number(with_matrix / without)});
}

void run(const std::string &output, const std::string &source_directory, const bool large)
{
  Report report("Products without a matrix");
  describe_machine(report);
  describe_libraries(report);
  report.line("velocity block of parameter_files/verification/elastic-tube-3d.prm, a quarter of a "
              "water-filled tube with curved cells, Crank-Nicolson; medians of " +
              std::to_string(n_repetitions) + " repetitions, processor time, one core");
  std::vector<std::string> meshes = {"32 3 4 1", "64 5 8 1"};
  if (large)
    meshes.emplace_back("120 9 12 2");
  for (const std::string &cells : meshes)
    bench(source_directory, cells, report);
  report.line("load at the end: " + number(load()));
  report.finish(output);
}
} // namespace Benchmarks

int main(int argc, char **argv)
{
  return Benchmarks::main_of(argc, argv, Benchmarks::run, "--large");
}
