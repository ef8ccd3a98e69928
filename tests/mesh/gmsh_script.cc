// What a .geo file may not do: every statement that touches more than the geometry is found, in the
// file and in those that it reads, and nothing else is.

#include <continua/base/input_error.h>
#include <continua/mesh/gmsh_script.h>

#include "../unit_test.h"

#include <filesystem>
#include <fstream>

namespace test_of_gmsh_script
{
using namespace Continua;

namespace
{
void write(const std::string &file, const std::string &text)
{
  std::ofstream(file, std::ios::binary) << text;
}

void accepted(const std::string &name, const std::string &text)
{
  write("script.geo", text);
  try
  {
    check_gmsh_script("script.geo");
    check::is_true(name, true);
  }
  catch (const InputError &error)
  {
    check::equal(name, error.what(), "");
  }
}

void refused(const std::string &name, const std::string &text, const std::string &pattern)
{
  write("script.geo", text);
  check::throws<InputError>(
      name, [] { check_gmsh_script("script.geo"); }, "^" + pattern);
}
} // namespace

UNIT_TEST(gmsh_script)
{
  const std::filesystem::path folder = "gmsh-script-test";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  std::filesystem::current_path(folder);

  accepted("a geometry",
           "SetFactory(\"OpenCASCADE\");\n"
           "Point(1) = {0, 0, 0, 1e-3}; lc = .5e+1; Mesh.Algorithm = 8; Save = 1; x = Save + 2;\n"
           "For i In {1 : 3}\n  Printf(\"%g > 0\", i);\nEndFor\n"
           "Transfinite Curve{1 : 3} = 4 Using Progression p;\n"
           "Field[1] = MathEval; Field[1].F = \"0.1 + x > 2\"; Background Field = 1;\n"
           "Physical Curve(\"Exit\") = {1}; Print.Text = 0; Mesh 2;\n"
           "If(Printf > 2) x = 3; EndIf\n");
  accepted("comments and texts",
           "// SystemCall \"x\";\n/* Exit; */ a = \"SystemCall 'x';\"; b = 'Exit;'; /* ** / */\n");
  accepted("case matters", "exit = 1; systemcall = 2;\n");

  refused("a program", "\n\nSystemCall \"x\";", "script.geo:3: .*'SystemCall'.*runs a program");
  refused("a text behind a variable", "a = \"x\"; System a;", "script.geo:1: .*'System'");
  refused("in the background", "NonBlockingSystemCall\n\"x\";", "script.geo:1: .*NonBlocking");
  refused("in a macro", "Macro f\n  SystemCall \"x\";\nReturn\n", "script.geo:2: ");
  refused("behind a comment", "/* a\n*/ SystemCall /* b */ \"x\";", "script.geo:2: ");
  refused("by the name of a command", "S2N[\"SystemCall\"] \"x\";", ".*'S2N' is refused");
  refused("a client", "OnelabRun(\"a\", \"b\");", ".*'OnelabRun' is refused");
  refused("a plugin", "Plugin(MathEval).Run;", ".*'Plugin' is refused");
  refused("a field of another program", "Field[1] = ExternalProcess;", ".*'ExternalProcess'");
  refused("an option of a solver", "Solver.Executable0 = \"x\";", ".*'Solver' is refused");
  refused("a file", "Printf(\"a)\", Sin(1)) > \"f\";", ".*'Printf' is refused: it writes a file");
  refused("the end of a file", "Error(\"a\") >> \"f\";", ".*'Error' is refused");
  refused("saving", "Save \"f.msh\";", ".*'Save' is refused: it writes a file");
  refused("saving a view", "Save View[0] \"f.pos\";", ".*'Save' is refused");
  refused("saving under a computed name", "Save StrCat(\"a\", \"b\");", ".*'Save' is refused");
  refused("a picture", "Print \"f.png\";", ".*'Print' is refused");
  refused("a folder", "CreateDir \"f\";", ".*'CreateDir' is refused");
  refused("the end of the program", "Exit;", ".*'Exit' is refused: it ends the program");
  refused("the end of the reading", "Abort;", ".*'Abort' is refused");
  refused("a comment without an end", "\n/* a", "script.geo:2: .*no end");
  refused("a text without an end", "a = \"b;\n", "script.geo:1: .*no end");
  refused("a text that gmsh cuts", "a = \"" + std::string(1100, 'b') + "\";", ".*1000 characters");
  refused("ends of line that gmsh overlooks", "// a\rExit;\n", "script.geo:1: .*carriage return");
  refused("no text", std::string("a\n\0", 3), "script.geo:2: .*byte 0");

  // The files that it reads, from where it stands.
  std::filesystem::create_directory("parts");
  write("parts/bad.geo", "a = 1;\nExit;\n");
  write("parts/outer.geo", "Include \"bad.geo\";\n");
  write("parts/loop.geo", "Include \"loop.geo\";\n");
  write("parts/shape.stl", "solid SystemCall \"x\";\nendsolid\n");
  write("parts/mesh.msh", "$MeshFormat\n4.1 0 8\n$EndMeshFormat\nExit;\n");
  write("parts/script.msh", "Exit;\n");
  refused("an included file", "\nInclude \"parts/bad.geo\";", "parts/bad.geo:2: .*'Exit'");
  refused("over two steps", "Include 'parts/outer.geo';", "parts/bad.geo:2: ");
  refused("beside the file", "Merge StrCat(CurrentDirectory, \"parts/bad.geo\");",
          "parts/bad.geo:2: ");
  refused("a mesh that is none", "Merge \"parts/script.msh\";", "parts/script.msh:1: ");
  refused("a shape that is read as a script", "Include \"parts/shape.stl\";",
          "parts/shape.stl:1: ");
  accepted("a shape", "Merge \"parts/shape.stl\";");
  accepted("a mesh", "Merge \"parts/mesh.msh\";");
  accepted("a loop", "Include \"parts/loop.geo\";");
  refused("a missing file", "\nMerge \"parts/none.stl\";", "script.geo:2: .*does not exist");
  refused("a packed file", "Merge \"parts/shape.stl.gz\";", ".*'Merge' is refused: .*'.gz'");
  refused("a program as a file", "Merge \"a.PY\";", ".*'Merge' is refused: .*'.py'");
  refused("a file that cannot be seen", "Merge name;", "script.geo:1: .*cannot be seen which file");
  write("parts/shape.stl.opt", "Exit;\n");
  refused("options beside a shape", "Merge \"parts/shape.stl\";", "parts/shape.stl.opt:1: ");
  write("script.geo.opt", "a = 1;\nExit;\n");
  refused("options beside the file", "a = 1;", "script.geo.opt:2: ");

  std::filesystem::current_path("..");
  std::filesystem::remove_all(folder);
}
} // namespace test_of_gmsh_script
