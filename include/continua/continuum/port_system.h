#ifndef continua_continuum_port_system_h
#define continua_continuum_port_system_h

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace Continua
{
/**
 * The small linear system of the ports of a body. With the inputs s (the pressure of a port that
 * holds it, else the flow rate), the outputs o = o0 + H s of the body and the models' p = p_plus +
 * Z Q it is
 *
 *   [ I_p + I_Q H - Z (I_Q + I_p H) ] s = p_plus + (Z I_p - I_Q) o0,
 *
 * with I_p, I_Q ones at the ports of either kind. set_impedances() inverts the matrix; it need not
 * be called again while has_inverse() holds.
 */
class PortSystem
{
public:
  /// `of_ports`: by port, whether it holds the flow rate.
  void reinit(const std::vector<bool> &of_ports);
  unsigned int size() const { return holds_flow.size(); }
  /// H: by row, for each port's input what the row's port gives back.
  void set_responses(const std::vector<double> &by_row);
  void set_response(const unsigned int row, const unsigned int column, const double value)
  {
    responses(row, column) = value;
    is_current = false;
  }
  /// H or Z have changed, or will.
  void forget() { is_current = false; }
  /// Whether the matrix is that of the last set_impedances().
  bool has_inverse() const { return is_current; }
  /// Z; inverts the matrix.
  void set_impedances(const dealii::FullMatrix<double> &of_models);

  /// The inputs s for o0 and p_plus.
  const dealii::Vector<double> &solve(const dealii::Vector<double> &outputs,
                                      const dealii::Vector<double> &predicted);
  /// The inputs for the changes o0 of the outputs at constant inputs, where p_plus stays; `rows`:
  /// what the equations of ports that hold the flow rate leave.
  const dealii::Vector<double> &solve_change(const dealii::Vector<double> &outputs,
                                             const std::vector<double> &rows);
  /// o0 + H s of the last solve().
  const dealii::Vector<double> &completed_outputs() const { return completed; }

private:
  std::vector<bool> holds_flow;
  dealii::FullMatrix<double> responses, impedances, inputs_of_rhs;
  bool is_current = false;
  dealii::Vector<double> completed, rhs, inputs;

  /// Adds Z I_p o0 to the right side, and solves.
  const dealii::Vector<double> &solve_for_inputs(const dealii::Vector<double> &outputs);
};
} // namespace Continua

#endif
