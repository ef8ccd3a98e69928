#ifndef continua_base_summary_h
#define continua_base_summary_h

#include <continua/base/expected_value.h>
#include <continua/base/quantity_names.h>

#include <map>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace Continua
{
/// One number that a run states.
struct Quantity
{
  std::string name; ///< "frequency", "maximum displacement", "wave speed"
  double value = 0.;
  std::string unit;  ///< SI, "1" if none
  std::string probe; ///< the probe or section it comes from; empty if the run as a whole
};

/**
 * summary.json: what was run (version, revision, command line, ranks, libraries), how large, how
 * long, which quantities came out and which of the expected values hold. Keys keep their order;
 * `quantities`, `absent` and `checks` stand at the end. A number that is not finite is written as
 * null. Only rank 0 writes the file.
 */
class Summary
{
public:
  Summary();
  ~Summary();
  Summary(Summary &&) noexcept;
  Summary &operator=(Summary &&) noexcept;

  /// A key that is set again keeps its place and has the new value. Whole numbers are written as
  /// such.
  void set(const std::string &key, const std::string &value);
  /// For bool alone: an overload would also take pointers and make whole numbers ambiguous.
  template <typename Bool, typename = std::enable_if_t<std::is_same_v<Bool, bool>>>
  void set(const std::string &key, const Bool value)
  {
    set_flag(key, value);
  }
  void set(const std::string &key, double value);
  void set(const std::string &key, const std::map<std::string, double> &values);
  void set(const std::string &key, const std::map<std::string, std::string> &values);
  void set(const std::string &key, const std::vector<std::string> &values);

  /// A table: the names of its columns and their values.
  using Columns = std::vector<std::pair<std::string, std::vector<double>>>;
  void set(const std::string &key, const Columns &columns);
  /// A quantity of the same name and probe replaces the earlier one.
  void add(const Quantity &quantity);
  const std::vector<Quantity> &quantities() const;
  /// A quantity that the results cannot carry, and why: one expected value of it fails with this
  /// reason. The summary lists these under `absent`.
  void add_absence(const std::string &name, const std::string &probe, const std::string &reason);
  /// What was set as a number under this key; 0 if nothing was.
  double number_of(const std::string &key) const;
  /// What was set as numbers with names under this key; none if nothing was.
  std::map<std::string, double> numbers_of(const std::string &key) const;
  /// What was set as a table under this key; none if nothing was.
  Columns columns_of(const std::string &key) const;
  /// The names that Expected was checked with before the run.
  void set_possible(const QuantityNames &names);

  /**
   * One verdict line per expected value, without digits of the result when it passed, so that it is
   * the same on any machine ("check: frequency (tip): within 0.2 % of 3.3624 Hz"), with value and
   * deviation when it failed ("... FAILED: 3.2 Hz is 4.8 % off 3.3624 Hz +- 0.2 %"), "FAILED:
   * absent: REASON", or "FAILED: the run has no such quantity (it has ...)"; also recorded under
   * `checks` (name, probe, criterion as written; expected, tolerance and value in `unit`, the unit
   * written; passed). `all_passed` tells whether all held. A value that is not finite never passes.
   *
   * A quantity that is not among the possible ones, where these were set, is a mistake of the
   * program: one more line says so. A quantity that the command line excludes is not compared: its
   * line names the changes, and `passed` is null.
   */
  std::vector<std::string> check(const std::vector<ExpectedValue> &expected, bool &all_passed);

  /// What became of an expected value.
  struct Check
  {
    std::string name, probe;
    std::string criterion; ///< as written: "10.1 m/s +- 0.2 %"
    double value;          ///< in `unit`; NaN if the run has none
    std::string unit;      ///< as written
    bool passed;
    bool is_compared = true; ///< false where the command line excludes the quantity
  };
  /// Of the last check(), in the order of the expected values.
  std::vector<Check> checks() const;

  /// The summary that write() has written; `text`: of the file. A number that was not finite is
  /// NaN.
  static Summary read(const std::string &text);
  /// Writes the file (atomically: a temporary file, then rename); RunError when the disk refuses.
  void write(const std::string &file) const;

private:
  void set_flag(const std::string &key, bool value);
  struct Implementation;
  std::unique_ptr<Implementation> implementation;
};
} // namespace Continua

#endif
