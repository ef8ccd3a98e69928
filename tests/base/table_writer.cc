// A csv file that grows: its text, a restart without gap or duplicate, and a full disk.

#include <continua/base/input_error.h>
#include <continua/base/table_writer.h>

#include "../unit_test.h"

#include <deal.II/base/exceptions.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

namespace test_of_table_writer
{
using namespace Continua;

namespace
{
const std::string file = "table-writer-test.csv";
const std::vector<std::string> header = {"time [s]", "tip: displacement y [m]"};
const std::string first_row = "time [s],tip: displacement y [m]\n";

std::string content()
{
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

void write_raw(const std::string &text)
{
  std::ofstream(file, std::ios::binary | std::ios::trunc) << text;
}
} // namespace

UNIT_TEST(table_writer)
{
  {
    TableWriter table(file, header);
    check::equal("the header is there at once", content(), first_row);
    table.row({0., 0.1});
    table.row({1e-4, -1. / 3.});
    table.flush();
    check::equal("shortest text", content(), first_row + "0,0.1\n1e-04,-0.3333333333333333\n");
    table.row({0.3, std::numeric_limits<double>::quiet_NaN()});
    table.row({0.4, -std::numeric_limits<double>::infinity()});
    check::throws<dealii::ExceptionBase>(
        "wrong number of values", [&table]() { table.row({1.}); }, "1.*2");
  }
  check::equal("the end flushes", content(),
               first_row + "0,0.1\n1e-04,-0.3333333333333333\n0.3,nan\n0.4,-inf\n");

  {
    const double value = 0.1 + 0.2; // not 0.3
    TableWriter table(file, {"a"});
    table.row({value});
    table.flush();
    const std::string text = content();
    check::is_true("reads back to the same number",
                   std::strtod(text.c_str() + 2, nullptr) == value);
  }
  {
    TableWriter table(file, {"a, b", "say \"c\""});
    check::equal("quoted names", content(), "\"a, b\",\"say \"\"c\"\"\"\n");
  }
  {
    // A spreadsheet would compute them.
    TableWriter table(file, {"=1+1", "+a", "-b", "@c", "d=e", "=f,g"});
    check::equal("names like formulas", content(), "'=1+1,'+a,'-b,'@c,d=e,\"'=f,g\"\n");
  }

  const auto restart = [](const std::string &before, const double time)
  {
    write_raw(before);
    TableWriter table(file, header, time);
    table.row({time + 1., 9.});
    table.flush();
    return content();
  };
  const std::string rows = "1,10\n2,20\n3,30\n";
  check::equal("cut at a row", restart(first_row + rows, 2.), first_row + "1,10\n2,20\n3,9\n");
  check::equal("cut between rows", restart(first_row + rows, 2.5),
               first_row + "1,10\n2,20\n3.5,9\n");
  check::equal("nothing to cut", restart(first_row + rows, 3.), first_row + rows + "4,9\n");
  check::equal("all cut", restart(first_row + rows, 0.5), first_row + "1.5,9\n");
  check::equal("half a row is cut", restart(first_row + "1,10\n2,2", 2.),
               first_row + "1,10\n3,9\n");
  check::equal("half a header", restart("time [s],ti", 2.), first_row + "3,9\n");
  check::equal("an empty file", restart("", 2.), first_row + "3,9\n");
  check::equal("round-off in the time",
               restart(first_row + "0.3,1\n0.4,2\n", 3 * 0.09999999999999999),
               first_row + "0.3,1\n1.3,9\n");

  check::throws<RunError>(
      "other columns", [&]() { restart("time [s],root: pressure [Pa]\n1,10\n", 1.); },
      "table-writer-test.csv.*columns.*root: pressure.*tip: displacement");
  check::throws<RunError>(
      "a row that is none", [&]() { restart(first_row + "1,10\nx\n2,1\n", 5.); }, "row 3");

  // What is written is known without reading it back.
  {
    const auto is_known = [](const std::string &name, const TableWriter &table)
    {
      const WrittenTable &written = table.written();
      const Checksum there = Checksum::of_file(file);
      check::is_true(name, written.name == file && written.all.value() == there.value() &&
                               written.all.length() == there.length());
      const std::string text = content();
      const std::size_t last = text.rfind('\n', text.size() - 2);
      if (std::isfinite(written.last_time))
        check::is_true(name + ", without the last row",
                       written.without_last_row.length() == last + 1 &&
                           written.without_last_row.value() ==
                               Checksum::of_file(file, last + 1).value());
    };
    TableWriter table(file, header);
    is_known("known: the header", table);
    table.row({1., 10.});
    table.row({2., 1. / 3.});
    check::absolute("time of the last row", table.written().last_time, 2., 0.);
    table.flush_to_disk();
    is_known("known: two rows", table);
    table.row({3., 30.});
    table.flush();
    TableWriter continued(file, header, 2.);
    is_known("known: a table that is continued", continued);
    check::absolute("time of its last row", continued.written().last_time, 2., 0.);
    continued.row({4., 5.});
    continued.flush();
    is_known("known: with a row more", continued);
    TableWriter cut(file, header, 0.5);
    is_known("known: all rows cut", cut);
  }

  std::filesystem::remove(file);
  {
    TableWriter table(file, header, 1.);
    check::equal("no file yet", content(), first_row);
  }
  check::throws<RunError>(
      "no folder", []() { TableWriter table("no-such-folder/a.csv", header); }, "No such file");
  check::throws<RunError>(
      "full disk", []() { TableWriter table("/dev/full", header); },
      "cannot write '/dev/full': No space left");
  std::filesystem::remove(file);
}
} // namespace test_of_table_writer
