#ifndef continua_case_theory_absorbing_ends_h
#define continua_case_theory_absorbing_ends_h

#include <continua/base/archive.h>
#include <continua/base/log.h>
#include <continua/base/parameter_section.h>
#include <continua/base/summary.h>
#include <continua/continuum/problem.h>

#include <string>
#include <vector>

namespace Continua
{
template <int dim>
struct Case;

/// An end of the body that lets waves leave, and the impedance that stands for what goes on there.
struct AbsorbingEnd
{
  std::string name;              ///< of the liquid's condition
  bool absorbs_wall = false;     ///< the axial wave of the wall too
  double lowest_frequency = 0.;  ///< of the band of the fit [Hz]
  double highest_frequency = 0.; ///< [Hz]
  double error = 0.;             ///< see ImpedanceFit; zero where nothing is fitted
  double impedance = 0.;         ///< |Z| of the liquid's port at the reference frequency [Pa s/m^3]
  double reference_frequency = 0.; ///< [Hz], below which most of the load's energy lies
  unsigned int n_terms = 0;
  /// Of the loads' spectrum above a band given by hand, see LoadSpectrum::from(); zero where it is
  /// below the tolerance of the fit.
  double left_out = 0.;
};

/**
 * The conditions of type absorbing, of which each becomes an outlet.
 *
 * At an end of a `tube` its impedance is that of the section at this end, going on for ever
 * (matched_impedance()), fitted over the run's band (fit_impedance()). With the condition of the
 * wall's end of the same type the outlet has two ports. The band reaches from 1/(2 pi end time) to
 * where the spectrum of the loads has fallen to a thousandth; an error at a frequency counts as
 * much as the part of the loads from there on, relative to its largest value. In a body of one
 * compressible liquid, without a wall, it is the plane wave's rho c over the boundary's area.
 */
class AbsorbingEnds
{
public:
  /// Adds to the outlets of `input.problem`. `root`: of the file. A run that
  /// goes on (`restart`) loads the impedances of its tubes instead of fitting them, perhaps over
  /// another band by its end time. Throws InputError.
  template <int dim>
  void add(Case<dim> &input, ParameterSection root, bool restart);
  /// A line and a quantity "absorbing end fit error" for each end.
  void report(Log &log, Summary &summary) const;

  void save(ArchiveWriter &archive, const Problem &problem) const;
  /// Instead of a fit: the impedances of the run that goes on.
  void load(const ArchiveReader &archive, Problem &problem);

private:
  std::vector<AbsorbingEnd> ends;
};
} // namespace Continua

#endif
