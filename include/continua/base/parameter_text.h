#ifndef continua_base_parameter_text_h
#define continua_base_parameter_text_h

#include <continua/base/input_error.h>

#include <string>
#include <vector>

namespace Continua
{
/**
 * What the user's text sets, before anybody says what it means: the tree of sections and entries of
 * a `.prm` file, its includes and the command line's overrides, each with its place. ParameterFile
 * describes the syntax. Where two files set the same entry the including one holds; two files of
 * which neither includes the other may not disagree unless a file above them decides.
 */
class ParameterText
{
public:
  struct Setting
  {
    std::string value;
    Origin origin;
    /// The chain of inclusions that leads to the file, one number for each; empty for the command
    /// line.
    std::vector<unsigned int> inclusions;
    bool is_unset = false; ///< an `unset`: takes back what included files set; there is no value
  };
  struct Entry
  {
    std::string key;
    std::vector<Setting> settings; ///< one, once everything has been read

    const std::string &value() const { return settings.front().value; }
    const Origin &origin() const { return settings.front().origin; }
  };
  struct Section
  {
    std::string name;
    Origin origin; ///< where it was first opened; the top section: the file, without a line
    std::vector<Entry> entries;
    std::vector<Section> sections;
    std::vector<Setting> unsets; ///< each takes back all that included files set in the section
    std::vector<Setting>
        openings; ///< where it is opened; those that an `unset` takes back are gone

    /// Null if there is none of that name.
    const Entry *entry(const std::string &key) const;
    const Section *section(const std::string &section_name) const;
    Entry &get_entry(const std::string &key);
    Section &get_section(const std::string &section_name, const Origin &place);
  };

  /// Origin::file of what the command line sets.
  static const std::string command_line;

  ParameterText() = default;
  /// `overrides`: "Section/Key=value" sets an entry; a path without '=' takes out an entry or a
  /// section that the file has. No file is read if `path` is empty. Throws InputError; sections and
  /// includes that are nested deeper than 50 levels, 1000 includes and 40,000 statements are
  /// refused, too.
  ParameterText(const std::string &path, const std::vector<std::string> &overrides);

  /// Sets an entry as the command line does, "Section/Key=value", after the text was read. Throws
  /// InputError.
  void set(const std::string &override_text);
  /// The section of that path; null if the user has none.
  const Section *find(const std::vector<std::string> &path) const;
  const Section &root() const { return top; }
  /// The files that were read, the `.prm` first.
  const std::vector<std::string> &files() const { return files_read; }
  /// The options of the command line that changed the file: "--set Section/Key=value, --unset
  /// Section"; empty if none did.
  const std::string &changes() const { return change_list; }
  /// What a user may want to know: entries that the command line sets several times.
  const std::vector<std::string> &notes() const { return note_list; }

private:
  /// Reads a file into a section of the tree. `stack` holds the files that are being read.
  void read(const std::string &path,
            const Origin &includer,
            Section &section,
            const std::vector<unsigned int> &inclusions,
            std::vector<std::string> &stack);
  void set_from_command_line(const std::string &override_text);
  void unset_from_command_line(const std::string &path);
  /// Gives the entry the setting; a further one of the command line replaces the first.
  void take(Entry &entry, const std::string &path, const Setting &setting);

  Section top;
  std::vector<std::string> files_read;
  std::vector<std::string> note_list;
  std::string change_list;
  unsigned int n_inclusions = 0;
  unsigned int n_statements = 0; ///< of all files, those of a file once for each include
};

/// Without white space at its ends, and with one blank for each run of it inside; what stands
/// between double quotes stays as it is.
std::string collapse_blanks(const std::string &text);
/// Whether a file that sets an entry to this text is read to the same text: no '#' begins a comment
/// in it, no blank would be lost, it is one line of UTF-8.
bool can_be_a_value(const std::string &text);
/// "A/B/C", with a name between double quotes where it needs them.
std::string join_path(const std::vector<std::string> &names);
} // namespace Continua

#endif
