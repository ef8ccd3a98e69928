#include <continua/base/csv_table.h>

#include "../unit_test.h"

#include <filesystem>
#include <fstream>

namespace test_of_csv_table
{
using namespace Continua;

namespace
{
const std::string path = "csv-table-test.csv";

CsvTable table(const std::string &content)
{
  std::ofstream(path, std::ios::binary) << content;
  return CsvTable(path, "time [ms], pressure [mmHg]");
}

void refused(const std::string &name,
             const std::function<void()> &function,
             const std::string &pattern)
{
  check::throws<InputError>(name, function, path + pattern);
}
} // namespace

namespace
{
/// What public tables have: no header, or one in a comment; quotes around cells; the exponents of
/// Fortran; a separator at the end of each line; rows with blanks below a header with commas.
void test_public_tables()
{
  const auto second = [](const std::string &content)
  { return table(content).values(1, Dimensions::flow_rate).at(1); };
  check::relative("quoted cells", second("\"t [s]\",\"q [ml/s]\"\n\"0\",\"1\"\n\"1\",\"2.5\"\n"),
                  2.5e-6, 1e-14);
  check::equal("a quote in quotes", table("\"2\"\" tube [m]\",b\n1,2\n").name(0), "2\" tube");
  check::relative("exponents of Fortran",
                  second("t [s] q [ml/s]\n 0.0D+00  1.0d0\n 1.0D-03 -2.5D+01\n"), -25e-6, 1e-14);
  check::relative("separators at the ends", second("t [s], q [ml/s],\n0, 1,\n1, 2.5,\n"), 2.5e-6,
                  1e-14);
  check::relative("at the ends of the rows", second("t [s];q [ml/s]\n0;1;\n1;2.5;;\n"), 2.5e-6,
                  1e-14);
  check::relative("rows with blanks", second("t [s], q [ml/s]\n  0 1\n 1\t  2.5\n"), 2.5e-6, 1e-14);
  check::relative("other names of units", second("t [sec], q [cc/sec]\n0, 1\n1, 2.5\n"), 2.5e-6,
                  1e-14);
  check::relative("powers behind units", second("t (msec), q (cm3 s-1)\n0, 1\n1, 2.5\n"), 2.5e-6,
                  1e-14);
  const CsvTable comment = table("# of a phantom\n# t [s]  q [ml/s]\n\n0 1\n1 2.5\n");
  check::is_true("a header in a comment", comment.n_rows() == 2 && comment.header().line == 2);
  check::relative("its unit", comment.values(1, Dimensions::flow_rate)[1], 2.5e-6, 1e-14);
  refused(
      "the header in the comment has another unit",
      [&] { comment.values(1, Dimensions::pressure); }, ":2: 'q'.*ml/s.*Pa");
  // Fewer names, no unit: a remark.
  for (const char *const remark : {"# t [s]", "# flow time", "#", " "})
    refused(
        std::string("no header but: ") + remark,
        [&] { table(std::string(remark) + "\n0; 1\n1; 2\n"); },
        ":2: the table has no header: this line has only numbers. Insert a line such as "
        "'time \\[ms\\]; pressure \\[mmHg\\]' with .* above this line, and keep this line");
  refused(
      "as many columns as the rows have", [] { table("0 1 2\n1 2 3\n"); },
      ":1: .*'time \\[ms\\]  pressure \\[mmHg\\]  \"value 3 \\[1\\]\"'");
  // As this remedy says.
  check::equal("a name with a blank among blanks",
               table("time [ms]  pressure [mmHg]  \"value 3 [1]\"\n0 1 2\n1 2 3\n").name(2),
               "value 3");
  refused(
      "rows in brackets", [] { table("(\n(0 1)\n(1 2)\n)\n"); },
      ":2: the row stands in brackets. .*\"tr -d '..' < FILE > NEW\"");
  refused(
      "a first line that counts rows", [] { table("3    16\n0. -1.\n1. -2.\n2. 0.\n"); },
      ":1: .*counts the rows that follow. Write '#' before this line, insert a line such as "
      "'time \\[ms\\]  pressure");
  // As this remedy says.
  check::is_true("after the remedy", table("#3    16\ntime [ms]  pressure [mmHg]\n0. -1.\n1. -2.\n"
                                           "2. 0.\n")
                                             .n_rows() == 3);
  refused(
      "rows counted below a header",
      []
      {
        table("t [s]  q [1]\n3    16\n0. -1.\n1. -2.\n2. 0.\n")
            .increasing_values(0, Dimensions::time, "time", "later");
      },
      ":2: the line counts the rows that follow.*'#' before");
  refused(
      "no decimal comma", [] { table("t [s]; q [1]\n0,5\n1,5\n"); }, ":2: .*cells, the header 2");
  refused(
      "decimal commas",
      [] { table("t [s]; q [1]\n0,5; -1,5e-3\n1;2\n").values(1, Dimensions::none); },
      ":2: 'q': '-1,5e-3' has a decimal comma. .*'tr , . < FILE > NEW'");
  refused(
      "decimal commas without a header", [] { table("0,5;1\n1;2,5\n"); },
      ":1: the table has no header, and its numbers have decimal commas. .*'tr , . <.*insert");
  for (const char *const gap : {"-", "NaN", "n/a"})
    refused(
        std::string("a gap: ") + gap,
        [&] { table(std::string("q [1]\n") + gap + "\n").values(0, Dimensions::none); },
        ":2: 'q': the value is missing");
  check::relative("units below the names", second("Time,Channel A\n(ms),(ml/s)\n\n0,1\n1,2.5\n"),
                  2.5e-6, 1e-14);
  check::relative("without brackets", second("t\tq\ns\tcm\u00b3/s\n0\t1\n1\t2.5\n"), 2.5e-6, 1e-14);
  const std::string recorder = "Interval=\t0.001 s\nRange=\t10.0 kPa\nTitle=\tp\n0\t1\n1\t2\n";
  refused(
      "lines before the rows", [&] { table(recorder); },
      ":1: the 3 lines before the first row of numbers .line 4. are no header with units. Write "
      "'#' before each of them, and insert a line such as 'time \\[ms\\]\tpressure \\[mmHg\\]' "
      "with");
  // As this remedy says.
  check::relative("after this remedy",
                  table("#Interval=\t0.001 s\n#Range=\t10.0 kPa\n#Title=\tp\n"
                        "time [ms]\tpressure [mmHg]\n0\t1\n1\t2\n")
                      .values(0, Dimensions::time)[1],
                  1e-3, 1e-14);
  std::ofstream(path, std::ios::binary) << "0 1\n1 2\n";
  refused(
      "units of the example, and advice",
      [] { CsvTable(path, "t [s], q [ml/s]", ". 'Table factor' turns the sign"); },
      ":1: .*columns .s, ms, min, h; m.3/s, l/min, ml/s, cm.3/s. above.*'Table factor' turns");
}
} // namespace

UNIT_TEST(csv_table)
{
  test_public_tables();
  const CsvTable tube = table("# measured\nx [cm]; \"wall, outer [mm]\"; ratio; note\n\n"
                              "0; 1.5; 0.5; a\n# between\n2; -2e-1; 1; b\n");
  check::is_true("columns and rows", tube.n_columns() == 4 && tube.n_rows() == 2);
  check::is_true("line of the header", tube.header().line == 2);
  check::equal("names", tube.names(1), "'wall, outer', 'ratio', 'note'");
  check::is_true("found", tube.find("ratio") == 2);
  check::relative("unit", tube.values(1, Dimensions::length)[1], -2e-4, 1e-14);
  check::relative("no unit", tube.values(2, Dimensions::none)[0], 0.5, 0.);
  check::relative("increasing",
                  tube.increasing_values(0, Dimensions::length, "position", "larger")[1], 0.02,
                  1e-14);
  const CsvTable wave = table("time [s],\"tube 0.1 m: pressure, theory [Pa]\"\n0,1\n");
  check::equal("a separator in quotes", wave.name(1), "tube 0.1 m: pressure, theory");
  refused(
      "no such column", [&] { tube.find("x", 1); }, ":2: 'x'.*'wall, outer'");
  refused(
      "no unit where one is needed", [&] { tube.values(2, Dimensions::length); },
      ":2: 'ratio'.*no unit");
  refused(
      "another dimension", [&] { tube.values(0, Dimensions::time); }, ":2: 'x'.*cm");
  refused(
      "no number", [&] { tube.values(3, Dimensions::none); }, ":4: 'note'.*'a' is not a num");
  refused(
      "decreasing", [&] { tube.increasing_values(1, Dimensions::length, "position", "larger"); },
      ":6: 'wall, outer'.*position -2e-1 is not larger");
  refused(
      "too few rows", [&] { tube.require_rows(3); }, ".*2 rows.*3 at least");
  refused(
      "a row", [&] { tube.refuse(1, 4, "is odd", "Say why"); }, ":6: is odd. Say why");
  refused(
      "missing cell", [] { table("a, b\n1, 2\n1\n"); }, ":3: .*1 cells, the header 2");
  refused(
      "no header", [] { table("# a\n"); }, ".*no header.*time \\[ms\\]");
  refused(
      "empty", [] { table(""); }, ": the file is empty.*time \\[ms\\]");
  const CsvTable old_mac = table("time [s],p [Pa]\r0,1\r1,2\r");
  check::is_true("carriage returns alone",
                 old_mac.n_rows() == 2 && old_mac.values(1, Dimensions::pressure)[1] == 2.);
  const CsvTable excel = table("\xef\xbb\xbfsep=;\r\ntime [s];p, inlet [Pa]\r\n0;1\r\n");
  check::equal("separator line of Excel", excel.name(1), "p, inlet");
  check::is_true("line of the header after it", excel.header().line == 2);
  check::is_true("the same in quotes", table("\"sep=,\"\ntime [s],p [Pa]\n0,1\n").n_rows() == 1);
  const CsvTable round = table("time (ms), p (mmHg), strain (true), h[mm] (mean)\n1, 2, 3, 4\n");
  check::equal("unit in round brackets", round.names(), "'time', 'p', 'strain (true)', 'h'");
  check::relative("its factor", round.values(0, Dimensions::time)[0], 1e-3, 1e-14);
  const CsvTable blanks = table("time (ms)  p [Pa]\n1 2\n");
  check::equal("round brackets among blanks", blanks.names(), "'time', 'p'");
  refused(
      "wrong unit in round brackets", [&] { round.values(1, Dimensions::time); }, ":1: 'p'.*mmHg");
  const CsvTable secret = table("root:$y$j9T$x:19000\n");
  check::equal("what may be a secret is not shown", secret.names(), "number 1");
  refused(
      "nor a cell of it", [] { table("a\n$y$j9T\n").values(0, Dimensions::none); },
      ":2: 'a': the cell is not a number");
  refused(
      "not UTF-8", [] { table("a [\xb5m]\n1\n"); }, ":1: the line has the byte 0xb5");
  std::filesystem::remove(path);
}
} // namespace test_of_csv_table
