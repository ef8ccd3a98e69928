#include <continua/base/input_error.h>
#include <continua/mesh/gmsh_file.h>

#include "../unit_test.h"
#include "gmsh_meshes.h"

#include <sstream>

namespace test_of_gmsh_file
{
using namespace Continua;
using meshes::squares;

namespace
{
GmshFile read(const std::string &text)
{
  return GmshFile::read(text, "x.msh");
}

void refused(const std::string &name, const std::string &text, const std::string &pattern)
{
  check::throws<InputError>(
      name, [&] { read(text); }, "^x.msh:" + pattern);
}
} // namespace

UNIT_TEST(gmsh_file)
{
  const GmshFile file = read(squares);
  check::absolute("groups", file.groups.size(), 6., 0.);
  check::equal("name with a blank", file.groups[2].name, "around it");
  check::is_true("group", file.groups[3].dimension == 2 && file.groups[3].tag == 7 &&
                              file.groups[3].line == 9);
  check::absolute("points", file.points.size(), 7., 0.);
  check::absolute("a coordinate", file.points[6][2], 3., 0.);
  check::absolute("blocks", file.blocks.size(), 7., 0.);
  const GmshFile::Block &block = file.blocks[2];
  check::is_true("block",
                 block.dimension == 1 && block.entity == 2 && block.type == 1 && block.line == 47);
  check::is_true("a group with a minus sign", block.groups == std::vector<int>{3});
  check::is_true("vertices",
                 file.blocks[6].elements[0].nodes == std::vector<unsigned int>({1, 4, 5, 2}));
  check::is_true("no group", file.blocks[4].groups.empty());

  std::string windows;
  for (const char character : squares)
    windows += character == '\n' ? std::string("\r\n") : std::string(1, character);
  check::equal("other ends of line, and an unknown section",
               read(meshes::with(windows, "$Nodes", "$Comments\r\na b\r\n$EndComments\r\n$Nodes"))
                   .groups[2]
                   .name,
               "around it");

  check::equal("comments before the format, and a group of no dimension",
               read("$Comments\n$MeshFormat?\n$EndComments\n" +
                    meshes::with(squares, "0 9 \"a point\"", "-1 1 \"none\""))
                   .groups[1]
                   .name,
               "around it");

  refused("empty", "", "0?.*no mesh file");
  refused("another file", "Point(1) = {0, 0, 0};\n", "1: 'Geometry/File'.*-format msh41");
  const GmshFile second = read(meshes::squares_2);
  check::absolute("MSH 2: points", second.points.size(), 6., 0.);
  check::absolute("MSH 2: blocks", second.blocks.size(), 6., 0.);
  check::is_true("MSH 2: a group without a name", second.blocks[2].groups == std::vector<int>{4} &&
                                                      second.blocks[2].elements.size() == 4);
  check::is_true("MSH 2: no group", second.blocks[3].groups.empty());
  check::is_true("MSH 2: further tags",
                 second.blocks[4].elements[0].nodes == std::vector<unsigned int>({0, 1, 4, 3}));
  // gmsh writes the elements of an entity once for each of its groups.
  const GmshFile twice = read(
      meshes::with(meshes::with(meshes::squares_2, "$Elements\n9\n", "$Elements\n10\n"),
                   "9 3 2 8 2 12 13 16 15\n", "9 3 2 8 2 12 13 16 15\n10 3 2 9 2 12 13 16 15\n"));
  check::is_true("MSH 2: an element in two groups",
                 twice.blocks.size() == 6 && twice.blocks[5].groups == std::vector<int>({8, 9}) &&
                     twice.blocks[5].elements.size() == 1);
  const GmshFile copy = read(
      meshes::with(meshes::with(meshes::squares_2, "$Elements\n9\n", "$Elements\n10\n"),
                   "9 3 2 8 2 12 13 16 15\n", "9 3 2 8 2 12 13 16 15\n10 3 2 8 2 12 13 16 15\n"));
  check::is_true("MSH 2: an element twice", copy.blocks.size() == 6 &&
                                                copy.blocks[5].groups == std::vector<int>{8} &&
                                                copy.blocks[5].elements.size() == 1);
  // As gmsh writes points with Mesh.SaveParametric, with their places on their entities behind.
  const GmshFile parametric =
      read(meshes::with(meshes::with(meshes::with(meshes::squares_2, "$Nodes", "$ParametricNodes"),
                                     "$EndNodes", "$EndParametricNodes"),
                        "13 2 0 0\n", "13 2 0 0 1 4 0.5\n"));
  check::is_true("MSH 2: parametric points", parametric.points.size() == 6 &&
                                                 parametric.points[2][0] == 2. &&
                                                 parametric.blocks.size() == 6);
  refused("MSH 2: too short",
          meshes::with(meshes::squares_2, "8 3 4 7 1 1 2 11 12 15 14", "8 3 4 7"),
          "28:.*too short");
  for (const auto &[name, text] :
       {std::make_pair("MSH 4.0", meshes::square_4), std::make_pair("MSH 1", meshes::square_1)})
  {
    const GmshFile old = read(text);
    check::is_true(name,
                   old.points.size() == 4 && old.points[2][1] == 1. && old.blocks.size() == 2 &&
                       old.blocks[0].elements.size() == 4 &&
                       old.blocks[0].groups == std::vector<int>{3} &&
                       old.blocks[1].groups == std::vector<int>{100} && old.blocks[1].entity == 6 &&
                       old.blocks[1].elements[0].nodes == std::vector<unsigned int>({0, 1, 2, 3}));
  }
  // Two partitions: the lines of the points have three coordinates, those of the others six.
  const std::string pieces =
      meshes::with(meshes::with(squares, "$Nodes",
                                "$PartitionedEntities\n2\n1\n5 1\n1 1 1 0\n7 0 1 2 1 2 0 0 0 1 9\n"
                                "7 1 2 1 1 0 0 0 2 0 0 1 -3 0\n7 2 1 1 2 0 0 0 1 1 0 1 7 0\n"
                                "$EndPartitionedEntities\n$Nodes"),
                   "2 1 3 1\n9 11 12 15 14", "2 7 3 1\n9 11 12 15 14");
  const GmshFile partitioned = read(pieces);
  check::is_true("partitioned", partitioned.blocks[5].groups == std::vector<int>{7});
  // The second square belongs to another partition: the entity 5 is a ghost.
  const GmshFile with_ghost = read(meshes::with(pieces, "2 2 3 1\n", "2 5 3 1\n"));
  check::is_true("ghost cells", partitioned.blocks.size() == 7 && with_ghost.blocks.size() == 6);

  refused("version 5", meshes::with(squares, "4.1 0 8", "5 0 8"),
          "2:.*'5 0 8'.*-save -save_all -format msh41");
  refused("binary", meshes::with(squares, "4.1 0 8", "4.1 1 8"),
          "2:.*binary.*-save -save_all -format msh41");
  refused("no number", meshes::with(squares, "2 1 0\n", "2 l 0\n"), "38:.*'2 l 0'.*numbers");
  refused("too few numbers", meshes::with(squares, "2 1 0\n", "2 1\n"), "38:.*3 numbers");
  refused("cut off", squares.substr(0, squares.find("9 11 12 15 14")), "56:.*ends in the middle");
  refused("no elements", squares.substr(0, squares.find("$Elements")), "40:.*no .Elements");
  refused("unknown node", meshes::with(squares, "9 11 12 15 14", "9 11 12 15 18"), "57:.*node");
  refused("broken name", meshes::with(squares, "\"fluid\"", "\"fluid"), "9:.*name");
  refused("no finite coordinate", meshes::with(squares, "2 1 0\n", "nan 1 0\n"), "38:.*nan");
  refused("infinite coordinate", meshes::with(squares, "2 1 0\n", "2 1e999 0\n"), "38:.*1e999");
  refused("tag too large", meshes::with(squares, "2 2 3 1\n", "2 1e300 3 1\n"),
          "58:.*whole numbers");
  refused("negative count", meshes::with(squares, "2 2 3 1\n", "2 2 3 -1\n"), "58:.*negative");
  refused("half a node", meshes::with(squares, "9 11 12 15 14", "9 11 12 15 14.5"), "57:.*tags of");
  refused("node beyond all", meshes::with(squares, "9 11 12 15 14", "9 11 12 15 1e300"),
          "57:.*tags of");
  refused("groups of an entity",
          meshes::with(squares, "2 1 0 0 2 0 0 1 -3 0", "2 1 0 0 2 0 0 1e9 3 0"), "17:.*too short");
  refused("group beyond all",
          meshes::with(squares, "2 1 0 0 2 0 0 1 -3 0", "2 1 0 0 2 0 0 1 -3e10 0"),
          "17:.*whole numbers");
  refused("escape in a name", meshes::with(squares, "\"fluid\"", "\"\x1b[2J\""),
          "9:.*control character 0x1b");
  refused("partitioned, and damaged",
          meshes::with(squares, "$Nodes", "$PartitionedEntities\n$EndPartitionedEntities\n$Nodes"),
          "24:.*numbers");
}
} // namespace test_of_gmsh_file
