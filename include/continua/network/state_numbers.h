#ifndef continua_network_state_numbers_h
#define continua_network_state_numbers_h

#include <cstddef>
#include <vector>

namespace Continua
{
/**
 * Copies what a step of a network changes into a row of numbers, or back. Each part of the network
 * hands its members over, always in the same order.
 */
class StateNumbers
{
public:
  enum class Direction
  {
    take, ///< from the network
    give  ///< to it
  };
  StateNumbers(const Direction direction, std::vector<double> &numbers)
      : direction(direction), numbers(numbers)
  {
    if (direction == Direction::take)
      numbers.clear();
  }

  void value(double &member)
  {
    if (direction == Direction::take)
      numbers.push_back(member);
    else
      member = numbers.at(next++);
  }
  /// A flag or a count.
  template <typename Number>
  void value(Number &member)
  {
    if (direction == Direction::take)
      places_of_flags.push_back(numbers.size());
    double copy = static_cast<double>(member);
    value(copy);
    member = static_cast<Number>(copy);
  }
  void values(std::vector<double> &members)
  {
    for (double &member : members)
      value(member);
  }
  /// The places of flags and counts in the row that was taken.
  const std::vector<std::size_t> &flags() const { return places_of_flags; }

private:
  Direction direction;
  std::vector<double> &numbers;
  std::vector<std::size_t> places_of_flags;
  std::size_t next = 0;
};
} // namespace Continua

#endif
