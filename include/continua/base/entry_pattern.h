#ifndef continua_base_entry_pattern_h
#define continua_base_entry_pattern_h

#include <deal.II/base/patterns.h>

#include <functional>
#include <memory>
#include <string>

namespace Continua
{
/**
 * The texts that an entry of a parameter file accepts, for deal.II's ParameterHandler: those that
 * our own reader of the entry understands. deal.II's patterns know no units.
 */
class EntryPattern : public dealii::Patterns::PatternBase
{
public:
  /// Throws std::invalid_argument for a text that the entry does not accept.
  using Check = std::function<void(const std::string &)>;

  /// `values`: what is accepted, in words.
  EntryPattern(std::string values, bool may_be_empty, Check check);

  bool match(const std::string &text) const override;
  std::string description(OutputStyle style = Machine) const override;
  std::unique_ptr<PatternBase> clone() const override;

private:
  std::string values;
  bool may_be_empty;
  Check check;
};
} // namespace Continua

#endif
