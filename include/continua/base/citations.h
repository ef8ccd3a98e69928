#ifndef continua_base_citations_h
#define continua_base_citations_h

#include <set>
#include <string>
#include <vector>

namespace Continua
{
/**
 * What a publication that uses this run should cite (citation.bib): always Continua, the thesis of
 * its method and deal.II; and the libraries and methods that the run has added.
 */
class Citations
{
public:
  Citations();
  /// One of keys(); a second time is no harm. An unknown key is an error of the program.
  void add(const std::string &key);
  /// The entries in BibTeX, in the order of keys() whatever the order of add().
  std::string bibtex() const;
  /// Writes citation.bib; RunError when the disk refuses. For the rank that writes.
  void write(const std::string &file) const;
  /// All keys there are.
  static std::vector<std::string> keys();

private:
  std::set<std::string> used;
};
} // namespace Continua

#endif
