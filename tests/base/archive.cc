// The archive of a checkpoint: numbers come back bit by bit; whatever damages the file is noticed.

#include <continua/base/archive.h>
#include <continua/base/input_error.h>

#include "../unit_test.h"

#include <deal.II/base/exceptions.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

namespace test_of_archive
{
using namespace Continua;

namespace
{
const std::string file = "archive-test.bin";

std::string content()
{
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

void write_raw(const std::string &bytes)
{
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
}

bool same_bits(const double a, const double b)
{
  return std::memcmp(&a, &b, sizeof(double)) == 0;
}

void unreadable(const std::string &name, const std::string &bytes, const std::string &pattern)
{
  write_raw(bytes);
  check::throws<RunError>(
      name, []() { ArchiveReader reader(file); }, pattern);
}
} // namespace

UNIT_TEST(archive)
{
  using Limits = std::numeric_limits<double>;
  const std::vector<double> numbers = {
      0.1, -0., Limits::denorm_min(), Limits::max(), Limits::infinity(), Limits::quiet_NaN()};
  ArchiveWriter writer;
  writer.add("identity", std::string("a\0b\n", 4));
  writer.add("empty text", std::string());
  writer.add("velocity", numbers);
  writer.add("no values", std::vector<double>());
  writer.add("time", 1. / 3.);
  writer.add("step", 18446744073709551615ul);
  writer.write(file);

  const ArchiveReader reader(file);
  check::is_true("text", reader.text("identity") == std::string("a\0b\n", 4));
  check::is_true("empty text", reader.text("empty text").empty());
  const std::vector<double> read = reader.values("velocity");
  bool same = read.size() == numbers.size();
  for (std::size_t i = 0; same && i < numbers.size(); ++i)
    same = same_bits(read[i], numbers[i]);
  check::is_true("values bit by bit", same);
  check::is_true("no values", reader.values("no values").empty());
  check::is_true("value bit by bit", same_bits(reader.value("time"), 1. / 3.));
  check::is_true("integer", reader.integer("step") == 18446744073709551615ul);
  check::is_true("has", reader.has("time") && !reader.has("times"));
  check::is_true("no temporary file", !std::filesystem::exists(file + ".new"));
  check::throws<RunError>(
      "missing record", [&]() { reader.value("x"); }, "no record 'x'");
  check::throws<RunError>(
      "another type", [&]() { reader.text("time"); }, "'time' is a number, not a text");
  check::throws<dealii::ExceptionBase>(
      "same name twice", [&]() { writer.add("time", 1.); }, "two records 'time'");

  const std::string good = content();
  unsigned int n_unnoticed = 0;
  for (std::size_t i = 0; i < good.size(); ++i)
  {
    std::string bad = good;
    // The lowest and the highest bit in turn.
    bad[i] = static_cast<char>(bad[i] ^ (i % 2 == 0 ? '\x01' : '\x80'));
    write_raw(bad);
    try
    {
      ArchiveReader damaged(file);
      ++n_unnoticed;
    }
    catch (const RunError &)
    {
    }
  }
  check::is_true("every damaged byte is noticed", n_unnoticed == 0);
  n_unnoticed = 0;
  for (std::size_t size = 0; size < good.size(); ++size)
  {
    write_raw(good.substr(0, size));
    try
    {
      ArchiveReader truncated(file);
      ++n_unnoticed;
    }
    catch (const RunError &)
    {
    }
  }
  check::is_true("every truncation is noticed", n_unnoticed == 0);

  unreadable("cut", good.substr(0, good.size() - 8), "truncated or damaged: its checksum");
  unreadable("bytes behind the end", good + "x", "checksum");
  unreadable("empty", "", "archive-test.bin.*empty");
  unreadable("foreign", "<?xml version=\"1.0\"?><VTKFile type=\"x\">",
             "not an archive of Continua");
  std::string newer = good;
  newer[16] = 7;
  unreadable("newer format", newer, "format 7; this program reads format 6");
  check::throws<RunError>(
      "no file", []() { ArchiveReader missing("no-such-file"); }, "'no-such-file'.*No such file");
  check::throws<RunError>(
      "a folder", []() { ArchiveReader folder("/"); }, "cannot read '/'");
  check::throws<RunError>(
      "no folder", [&]() { writer.write("no-such-folder/a"); }, "'no-such-folder/a'.*No such file");

  std::filesystem::remove(file);
}
} // namespace test_of_archive
