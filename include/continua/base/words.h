#ifndef continua_base_words_h
#define continua_base_words_h

#include <continua/base/parameter_section.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/// The words that a parameter file has for the values of an enum, in the order of the manual.
template <typename Value>
using Words = std::vector<std::pair<std::string, Value>>;

/// The word for a value. Throws std::logic_error where the table has none.
template <typename Value>
std::string word_of(const Words<Value> &words, const Value &value)
{
  const auto row = std::find_if(words.begin(), words.end(),
                                [&](const auto &candidate) { return candidate.second == value; });
  if (row == words.end())
    throw std::logic_error("a value has no word");
  return row->first;
}

/// The value of a word. Throws std::logic_error where the table has no such word.
template <typename Value>
Value value_of(const Words<Value> &words, const std::string &word)
{
  const auto row = std::find_if(words.begin(), words.end(),
                                [&](const auto &candidate) { return candidate.first == word; });
  if (row == words.end())
    throw std::logic_error("there is no value for the word '" + word + "'");
  return row->second;
}

/// The words alone.
template <typename Value>
std::vector<std::string> choices_of(const Words<Value> &words)
{
  std::vector<std::string> choices;
  for (const auto &row : words)
    choices.push_back(row.first);
  return choices;
}

/// Declares and reads one of a few words, as ParameterSection::add_choice(), into its value. The
/// default is the variable's value. Throws InputError for another word.
template <typename Value>
void add_choice(ParameterSection &section,
                const std::string &key,
                Value &value,
                const Words<Value> &words,
                const std::string &text)
{
  std::string word = word_of(words, value);
  section.add_choice(key, word, choices_of(words), text);
  value = value_of(words, word);
}
} // namespace Continua

#endif
