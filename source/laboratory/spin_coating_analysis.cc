#include <continua/laboratory/spin_coating_analysis.h>

#include <continua/base/citations.h>
#include <continua/base/summary.h>
#include <continua/base/table_writer.h>
#include <continua/postprocess/writing_rank.h>

#include <algorithm>

namespace Continua
{
SpinCoatingAnalysis::SpinCoatingAnalysis(const AnalysisInput &input) : Analysis(input)
{
  ParameterSection root = file.root(), geometry = root.subsection("Geometry");
  std::string type = "tube";
  geometry.add_choice("Type", type, {"tube"}, "What is made by spin coating.");
  law = TubeLaw::read(geometry);
  coating = SpinCoating::read(root.subsection("Spin coating"));
  expected = read_expected(root.subsection("Expected"));
  file.refuse_unknown();
  for (const std::string name : {"diameter", "wall thickness", "trolley speed", "rod speed"})
  {
    quantities.add("smallest " + name);
    quantities.add("largest " + name);
  }
  quantities.add("volume of solution");
  quantities.add("duration");
  quantities.refuse_unknown(file, root.subsection("Expected"), expected);
}

void SpinCoatingAnalysis::compute(const OutputDirectory &directory, Log &log, Summary &summary)
{
  if (!is_writing_rank(communicator))
    return;
  const std::vector<SpinCoating::Row> rows = coating.table(law);
  summary.set_possible(quantities);
  summary.set("status", "finished");
  const auto range =
      [&](const std::string &name, double SpinCoating::Row::*what, const std::string &unit)
  {
    const auto [smallest, largest] =
        std::minmax_element(rows.begin(), rows.end(),
                            [what](const auto &a, const auto &b) { return a.*what < b.*what; });
    summary.add({"smallest " + name, (*smallest).*what, unit, ""});
    summary.add({"largest " + name, (*largest).*what, unit, ""});
  };
  range("diameter", &SpinCoating::Row::diameter, "m");
  range("wall thickness", &SpinCoating::Row::thickness, "m");
  range("trolley speed", &SpinCoating::Row::trolley_speed, "1/s");
  range("rod speed", &SpinCoating::Row::rod_speed, "1/s");
  summary.add({"volume of solution", rows.back().volume, "m^3", ""});
  summary.add({"duration", rows.back().time, "s", ""});
  bool all_passed = true;
  for (const std::string &verdict : summary.check(expected, all_passed))
    log.line(verdict);
  TableWriter table(directory.file("spin-coating.csv"),
                    {"position [m]", "diameter [m]", "wall thickness [m]",
                     "trolley speed [counts/s]", "rod speed [counts/s]", "volume of solution [m^3]",
                     "time [s]"});
  for (const SpinCoating::Row &row : rows)
    table.row({row.position, row.diameter, row.thickness, row.trolley_speed, row.rod_speed,
               row.volume, row.time});
  table.flush();
  summary.write(directory.file("summary.json"));
  Citations().write(directory.file("citation.bib"));
}
} // namespace Continua
