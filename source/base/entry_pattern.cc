#include <continua/base/entry_pattern.h>

#include <stdexcept>
#include <utility>

namespace Continua
{
EntryPattern::EntryPattern(std::string values, const bool may_be_empty, Check check)
    : values(std::move(values)), may_be_empty(may_be_empty), check(std::move(check))
{
}

bool EntryPattern::match(const std::string &text) const
{
  if (text.empty())
    return may_be_empty;
  try
  {
    check(text);
    return true;
  }
  catch (const std::invalid_argument &)
  {
    return false;
  }
}

std::string EntryPattern::description(const OutputStyle /*style*/) const
{
  return "[" + values + "]";
}

std::unique_ptr<dealii::Patterns::PatternBase> EntryPattern::clone() const
{
  return std::make_unique<EntryPattern>(*this);
}
} // namespace Continua
