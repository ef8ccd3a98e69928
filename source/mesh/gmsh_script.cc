#include <continua/base/input_error.h>
#include <continua/base/input_file.h>
#include <continua/mesh/gmsh_script.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>
#include <vector>

namespace Continua
{
namespace
{
const std::string remedy_of_a_command = "Remove the statement, or mesh the file with gmsh and give "
                                        "the .msh file; if you trust the file, "
                                        "run Continua with --allow-mesh-commands";

struct Token
{
  enum class Kind
  {
    name,
    quoted,
    other, ///< a number or a sign
    end
  } kind;
  std::string text; ///< of a string without its quotes
  unsigned int line;

  bool is(const char *const sign) const { return kind == Kind::other && text == sign; }
  bool begins_string() const { return kind == Kind::name || kind == Kind::quoted; }
};

bool is_letter(const char character)
{
  return character == '_' || (character >= 'a' && character <= 'z') ||
         (character >= 'A' && character <= 'Z');
}

bool is_digit(const char character)
{
  return character >= '0' && character <= '9';
}

/// Cuts a script into its tokens; the last one is the end.
class Tokens
{
public:
  Tokens(const std::string &text, const std::string &file) : text(text), file(file)
  {
    while (skip_blanks_and_comments())
      tokens.push_back(next());
    // So that one may look a few tokens ahead.
    for (unsigned int i = 0; i < 8; ++i)
      tokens.push_back({Token::Kind::end, "", line});
  }

  const Token &operator[](const std::size_t i) const { return tokens[std::min(i, size())]; }
  /// Without the end.
  std::size_t size() const { return tokens.size() - 8; }

private:
  const std::string &text;
  const std::string &file;
  std::size_t place = 0;
  unsigned int line = 1;
  std::vector<Token> tokens;

  char character(const std::size_t ahead = 0) const
  {
    return place + ahead < text.size() ? text[place + ahead] : '\0';
  }

  void step()
  {
    line += text[place] == '\n' ? 1 : 0;
    ++place;
  }

  /// False at the end of the text.
  bool skip_blanks_and_comments()
  {
    while (place < text.size())
      if (std::string(" \t\r\n\f").find(character()) != std::string::npos)
        step();
      else if (character() == '/' && character(1) == '/')
        while (place < text.size() && character() != '\n')
          step();
      else if (character() == '/' && character(1) == '*')
        skip_comment();
      else
        return true;
    return false;
  }

  void skip_comment()
  {
    const unsigned int begin = line;
    step();
    step();
    while (character() != '*' || character(1) != '/')
    {
      if (place >= text.size())
        throw InputError({file, begin}, "Geometry/File", "this comment has no end", "Write */");
      step();
    }
    step();
    step();
  }

  Token next()
  {
    const std::size_t begin = place;
    const unsigned int here = line;
    const char first = character();
    if (is_letter(first))
    {
      while (is_letter(character()) || is_digit(character()))
        ++place;
      return {Token::Kind::name, text.substr(begin, place - begin), here};
    }
    if (is_digit(first) || (first == '.' && is_digit(character(1))))
    {
      skip_number();
      return {Token::Kind::other, text.substr(begin, place - begin), here};
    }
    step();
    if (first != '"' && first != '\'')
      return {Token::Kind::other, std::string(1, first), here};
    while (character() != first)
    {
      // gmsh cuts a string at 1023 characters, and takes the rest for statements.
      if (place >= text.size() || place - begin > 1000)
        throw InputError({file, here}, "Geometry/File",
                         "this string has no end, or more than 1000 characters",
                         "Close it with the quote that opens it");
      step();
    }
    step();
    return {Token::Kind::quoted, text.substr(begin + 1, place - begin - 2), here};
  }

  void skip_number()
  {
    const auto skip_digits = [&]
    {
      while (is_digit(character()))
        ++place;
    };
    skip_digits();
    if (character() == '.')
      ++place;
    skip_digits();
    const std::size_t sign = character(1) == '+' || character(1) == '-' ? 1 : 0;
    if ((character() == 'e' || character() == 'E') && is_digit(character(1 + sign)))
    {
      place += 1 + sign;
      skip_digits();
    }
  }
};

/// What a name does wherever it stands.
const std::map<std::string, std::string> &refused_names()
{
  static const std::map<std::string, std::string> table = {
      {"SystemCall", "it runs a program"},
      {"NonBlockingSystemCall", "it runs a program"},
      {"OnelabRun", "it runs a program"},
      {"ExternalProcess", "it runs a program"},
      {"Plugin", "it does what only the plugin says"},
      {"StringToName", "it makes a command of any text"},
      {"S2N", "it makes a command of any text"},
      {"Exit", "it ends the program"},
      {"Abort", "it leaves the mesh unfinished"}};
  return table;
}

/// What a name does where a string follows it; elsewhere it is a variable or an option.
const std::map<std::string, std::string> &refused_commands()
{
  static const std::map<std::string, std::string> table = {
      {"System", "it runs a program"},
      {"Save", "it writes a file"},
      {"Print", "it writes a file"},
      {"CreateDir", "it makes a folder"},
      {"SendToServer", "it talks to another program"}};
  return table;
}

/// Follows a script into the files that it reads.
class ScriptCheck
{
public:
  void check(const std::string &file, const Origin &named_at)
  {
    const std::string canonical = std::filesystem::weakly_canonical(file).string();
    if (!seen.insert(canonical).second)
      return;
    const std::string text = read(file, named_at);
    for (std::size_t i = 0; i < text.size(); ++i)
      if (text[i] == '\0' || (text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n')))
        throw InputError(
            {file, static_cast<unsigned int>(1 + std::count(text.begin(), text.begin() + i, '\n'))},
            "Geometry/File",
            text[i] == '\0' ? "the line has the byte 0: the file is no text in UTF-8"
                            : "the line ends with a carriage return alone, which gmsh overlooks",
            "Save the file as plain text");
    check_tokens(Tokens(text, file), file);
    check_options_beside(file);
  }

private:
  std::set<std::string> seen;

  static std::string read(const std::string &file, const Origin &named_at)
  {
    try
    {
      return read_input_file(file);
    }
    catch (const std::invalid_argument &problem)
    {
      throw InputError(named_at, "Geometry/File", problem.what(),
                       "Check its name; it is relative to the file that names it");
    }
  }

  [[noreturn]] static void
  refuse(const std::string &file, const Token &token, const std::string &reason)
  {
    throw InputError({file, token.line}, "Geometry/File",
                     "gmsh's '" + token.text + "' is refused: " + reason, remedy_of_a_command);
  }

  void check_tokens(const Tokens &tokens, const std::string &file)
  {
    for (std::size_t i = 0; i < tokens.size(); ++i)
    {
      const Token &token = tokens[i];
      if (token.kind != Token::Kind::name)
        continue;
      if (const auto found = refused_names().find(token.text); found != refused_names().end())
        refuse(file, token, found->second);
      const Token &following = tokens[i + 1];
      if (const auto found = refused_commands().find(token.text);
          found != refused_commands().end() && following.begins_string())
        refuse(file, token, found->second);
      if (token.text == "Solver" && following.is("."))
        refuse(file, token, "these options say which programs run");
      if (token.text == "Printf" || token.text == "Warning" || token.text == "Error")
        check_printing(tokens, i, file);
      if ((token.text == "Include" || token.text == "Merge" ||
           token.text == "MergeWithBoundingBox") &&
          following.begins_string())
        follow(tokens, i, file);
    }
  }

  /// `Printf(...) > "FILE"` and `>>`.
  static void check_printing(const Tokens &tokens, const std::size_t begin, const std::string &file)
  {
    if (!tokens[begin + 1].is("("))
      return;
    std::size_t depth = 0, i = begin + 1;
    do
    {
      depth += tokens[i].is("(") ? 1 : 0;
      depth -= tokens[i].is(")") ? 1 : 0;
      ++i;
    } while (depth > 0 && i < tokens.size());
    if (tokens[i].is(">"))
      refuse(file, tokens[begin], "it writes a file");
  }

  /// The file that Include or Merge reads.
  void follow(const Tokens &tokens, const std::size_t i, const std::string &file)
  {
    const Origin here{file, tokens[i].line};
    std::string name;
    if (tokens[i + 1].kind == Token::Kind::quoted)
      name = tokens[i + 1].text;
    else if (tokens[i + 1].text == "StrCat" && (tokens[i + 2].is("(") || tokens[i + 2].is("[")) &&
             (tokens[i + 3].text == "CurrentDirectory" || tokens[i + 3].text == "CurrentDir") &&
             tokens[i + 4].is(",") && tokens[i + 5].kind == Token::Kind::quoted &&
             (tokens[i + 6].is(")") || tokens[i + 6].is("]")))
      name = tokens[i + 5].text;
    else
      throw InputError(here, "Geometry/File",
                       "it cannot be seen which file '" + tokens[i].text + "' reads",
                       "Write its name in quotes. " + remedy_of_a_command);
    const std::string path = (std::filesystem::path(file).parent_path() / name).string();
    if (tokens[i].text == "Include")
      check(path, here);
    else
      check_merged(path, tokens[i], file);
  }

  void check_merged(const std::string &path, const Token &command, const std::string &file)
  {
    static const std::set<std::string> programs = {".gz", ".py", ".pro", ".m", ".exe"};
    static const std::set<std::string> data = {
        ".stl",  ".brep", ".rle", ".brp", ".iges", ".igs",  ".step", ".stp",  ".sat", ".x_t",
        ".x_b",  ".unv",  ".vtk", ".wrl", ".vrml", ".iv",   ".mesh", ".diff", ".med", ".mmed",
        ".rmed", ".bdf",  ".nas", ".dat", ".p3d",  ".ply2", ".ply",  ".geom", ".cgns"};
    std::string extension = std::filesystem::path(path).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](const unsigned char letter) { return std::tolower(letter); });
    if (programs.count(extension) > 0)
      refuse(file, command, "for a file '" + extension + "' gmsh starts a program");
    const Origin here{file, command.line};
    const std::string text = read(path, here);
    const auto begins_with = [&text](const std::string &beginning)
    { return text.compare(0, beginning.size(), beginning) == 0; };
    bool is_data = data.count(extension) > 0;
    for (const char *const header :
         {"$PTS", "$NO", "$PARA", "$ELM", "$MeshFormat", "$Comments", "$PostFormat", "$View"})
      is_data = is_data || begins_with(header);
    if (is_data)
      check_options_beside(path);
    else
      check(path, here);
  }

  /// gmsh reads FILE.opt after FILE, a script as well.
  void check_options_beside(const std::string &file)
  {
    std::error_code no_access;
    if (std::filesystem::exists(file + ".opt", no_access))
      check(file + ".opt", {file, 0});
  }
};
} // namespace

void check_gmsh_script(const std::string &geo_file)
{
  ScriptCheck().check(geo_file, {geo_file, 0});
}
} // namespace Continua
