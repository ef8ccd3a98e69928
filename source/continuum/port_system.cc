#include <continua/continuum/port_system.h>

namespace Continua
{
using namespace dealii;

void PortSystem::reinit(const std::vector<bool> &of_ports)
{
  holds_flow = of_ports;
  for (FullMatrix<double> *matrix : {&responses, &impedances, &inputs_of_rhs})
    matrix->reinit(size(), size());
  for (Vector<double> *vector : {&completed, &rhs, &inputs})
    vector->reinit(size());
  is_current = false;
}

void PortSystem::set_responses(const std::vector<double> &by_row)
{
  responses.fill(by_row.data());
  is_current = false;
}

void PortSystem::set_impedances(const FullMatrix<double> &of_models)
{
  impedances = of_models;
  const unsigned int n = size();
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
    {
      double sum = i == j && !holds_flow[i] ? 1. : 0.;
      if (holds_flow[i])
        sum += responses(i, j);
      if (holds_flow[j])
        sum -= impedances(i, j);
      for (unsigned int l = 0; l < n; ++l)
        if (!holds_flow[l])
          sum -= impedances(i, l) * responses(l, j);
      inputs_of_rhs(i, j) = sum;
    }
  inputs_of_rhs.gauss_jordan();
  is_current = true;
}

const Vector<double> &PortSystem::solve_for_inputs(const Vector<double> &outputs)
{
  for (unsigned int i = 0; i < size(); ++i)
    for (unsigned int j = 0; j < size(); ++j)
      if (!holds_flow[j])
        rhs[i] += impedances(i, j) * outputs[j];
  inputs_of_rhs.vmult(inputs, rhs);
  return inputs;
}

const Vector<double> &PortSystem::solve(const Vector<double> &outputs,
                                        const Vector<double> &predicted)
{
  for (unsigned int i = 0; i < size(); ++i)
    rhs[i] = predicted[i] - (holds_flow[i] ? outputs[i] : 0.);
  solve_for_inputs(outputs);
  completed = outputs;
  responses.vmult_add(completed, inputs);
  return inputs;
}

const Vector<double> &PortSystem::solve_change(const Vector<double> &outputs,
                                               const std::vector<double> &rows)
{
  for (unsigned int i = 0; i < size(); ++i)
    rhs[i] = holds_flow[i] ? -rows[i] - outputs[i] : 0.;
  return solve_for_inputs(outputs);
}
} // namespace Continua
