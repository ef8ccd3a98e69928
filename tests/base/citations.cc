// citation.bib: what is always in it, what a run adds, and that it is BibTeX.

#include <continua/base/citations.h>

#include "../unit_test.h"

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace test_of_citations
{
using namespace Continua;

UNIT_TEST(citations)
{
  Citations citations;
  const std::string always = citations.bibtex();
  for (const char *const key :
       {"@misc{continua,", "@phdthesis{giannopapa2004,", "@article{dealii94,"})
    check::is_true(std::string("always: ") + key, always.find(key) != std::string::npos);
  check::is_true("nothing else", std::count(always.begin(), always.end(), '@') == 3);
  check::is_true("the thesis", always.find("Fluid structure interaction in flexible vessels") !=
                                       std::string::npos &&
                                   always.find("King's College London") != std::string::npos);

  citations.add("rannacher1984");
  citations.add("mumps");
  citations.add("mumps");
  const std::string more = citations.bibtex();
  check::is_true("two more", std::count(more.begin(), more.end(), '@') == 5);
  check::is_true("own order", more.find("@article{mumps,") < more.find("@article{rannacher1984,"));
  check::throws<dealii::ExceptionBase>(
      "unknown key", [&citations]() { citations.add("x"); }, "'x'");

  Citations all;
  for (const char *const key :
       {"continua", "giannopapa2004", "dealii94", "mumps", "p4est", "trilinos", "rannacher1984",
        "hoodtaylor1973", "arb", "cholmod", "jasakweller2000", "slepc", "rhiechow1983", "issa1986",
        "roache1994", "celik2008", "metis", "aaa"})
    all.add(key);
  const std::string text = all.bibtex();
  check::is_true("all keys", Citations::keys().size() == 18);
  check::is_true("braces match", std::count(text.begin(), text.end(), '{') ==
                                     std::count(text.begin(), text.end(), '}'));

  const std::string file = "citations-test.bib";
  all.write(file);
  std::ostringstream written;
  written << std::ifstream(file).rdbuf();
  check::equal("written", written.str(), text);
  std::filesystem::remove(file);
}
} // namespace test_of_citations
