#ifndef continua_base_summary_h
#define continua_base_summary_h

#include <continua/base/parameter_section.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/// One number that a run states.
struct Quantity
{
  std::string name; ///< "frequency", "maximum displacement", "wave speed"
  double value = 0.;
  std::string unit; ///< SI, "1" if none
  std::string probe; ///< the probe or section it comes from; empty if the run as a whole
};

/**
 * One line of the section Expected: `set [PROBE: ]NAME = VALUE [UNIT] +- TOLERANCE [UNIT | %]`, or a bound `NAME = < VALUE`.
 */
struct ExpectedValue
{
  std::string name;
  std::string probe; ///< empty: any probe that has this quantity
  double value = 0.; ///< in the unit written
  std::string unit; ///< as written
  double tolerance = 0.; ///< absolute, in the unit written
  std::string tolerance_text; ///< as written: "0.2 %"
  bool upper_bound = false; ///< `< VALUE`
};

/// The section Expected, parsed; throws InputError for a line that is malformed.
std::vector<ExpectedValue> read_expected(ParameterSection section);

/**
 * summary.json: what was run (version, revision, command line, ranks, libraries), how large, how long, which
 * quantities came out and which of the expected values hold. Keys keep their order. Only rank 0 writes the file.
 */
class Summary
{
public:
  Summary();
  ~Summary();
  Summary(Summary &&) noexcept;

  void set(const std::string &key, const std::string &value);
  void set(const std::string &key, double value);
  void set(const std::string &key, const std::map<std::string, double> &values);
  void set(const std::string &key, const std::map<std::string, std::string> &values);
  void set(const std::string &key, const std::vector<std::string> &values);

  void add(const Quantity &quantity);
  const std::vector<Quantity> &quantities() const;

  /**
   * One verdict line per expected value, without digits of the result when it passed, so that it is the same on any
   * machine ("frequency (tip): within 0.2 % of 3.3624 Hz"), with value and deviation when it failed ("... FAILED: 3.2
   * Hz is 4.8 % off"), or "FAILED: the run has no such quantity (it has ...)"; also recorded under `checks`.
   * `all_passed` tells whether all held.
   */
  std::vector<std::string> check(const std::vector<ExpectedValue> &expected, bool &all_passed);

  /// Writes the file (atomically: a temporary file, then rename).
  void write(const std::string &file) const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation;
};
} // namespace Continua

#endif
