#ifndef continua_case_analysis_traits_h
#define continua_case_analysis_traits_h

#include <continua/base/parameter_section.h>
#include <continua/base/quantity_names.h>

#include <string>

namespace Continua
{
template <int dim>
struct Case;

/// What the body does in an analysis. It decides which section of the file is read.
enum class Motion
{
  in_time,   ///< it moves from its initial state until an end time: section Time
  steady,    ///< it does not change any more under its loads: section Steady
  vibrating, ///< it vibrates freely: section Modal
  harmonic   ///< it moves with exp(s t) under loads that do: sections of the analysis
};

/// All that the reader of a case knows of the analysis: a part of the analysis's row in the table
/// of analyses.
template <int dim>
struct AnalysisTraits
{
  std::string name;
  Motion motion = Motion::in_time;
  bool has_fields = true;       ///< false: the analysis makes no use of a discretisation
  bool has_checkpoints = false; ///< from which a run goes on
  /// The rules of the analysis across sections. Throws InputError. Null: the analysis reads no
  /// case.
  void (*check)(const Case<dim> &input, ParameterSection root) = nullptr;
  /// Adds the names of the quantities that the analysis can state.
  void (*name_quantities)(const Case<dim> &input, QuantityNames &names) = nullptr;
  /// Adds the names that another analysis of the same file can state, and this one cannot: what
  /// Expected says of them is left out. Null: there are none.
  void (*name_quantities_of_others)(const Case<dim> &input, QuantityNames &names) = nullptr;

  /// Whether fields are computed step by step.
  bool is_transient() const { return motion == Motion::in_time && has_fields; }
  bool is_steady() const { return motion == Motion::steady; }
  bool is_modal() const { return motion == Motion::vibrating; }
  bool is_harmonic() const { return motion == Motion::harmonic; }
};
} // namespace Continua

#endif
