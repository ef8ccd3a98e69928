#ifndef continua_tests_mesh_gmsh_meshes_h
#define continua_tests_mesh_gmsh_meshes_h

// Mesh files of gmsh, written by hand, for the tests of their readers.

#include <fstream>
#include <stdexcept>
#include <string>

namespace meshes
{
/// Two squares of side 1 beside each other, x from 0 to 2: `fluid` and `wall`. The second runs
/// clockwise, and the group `below` holds its curve with a minus sign.
inline const std::string squares = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
6
0 9 "a point"
1 3 "below"
1 4 "around it"
2 7 "fluid"
2 8 "wall"
3 1 "none of ours"
$EndPhysicalNames
$Entities
1 4 2 0
1 0 0 0 1 9
1 0 0 0 1 0 0 1 3 0
2 1 0 0 2 0 0 1 -3 0
3 0 0 0 2 1 0 1 4 0
4 1 0 0 1 1 0 0 0
1 0 0 0 1 1 0 1 7 0
2 1 0 0 2 1 0 1 8 0
$EndEntities
$Nodes
1 7 11 17
2 1 0 7
11
12
13
14
15
16
17
0 0 0
1 0 0
2 0 0
0 1 0
1 1 0
2 1 0
0.5 0.7 3
$EndNodes
$Elements
7 10 1 10
0 1 15 1
1 11
1 1 1 1
2 11 12
1 2 1 1
3 13 12
1 3 1 4
4 13 16
5 16 15
6 15 14
7 14 11
1 4 1 1
8 12 15
2 1 3 1
9 11 12 15 14
2 2 3 1
10 12 15 16 13
$EndElements
)";

/// The same squares in MSH 2.2, the second counter-clockwise: `fluid`, `wall`, `below`, and group 4
/// without a name. The edge between the squares is in no group.
inline const std::string squares_2 = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
3
1 3 "below"
2 7 "fluid"
2 8 "wall"
$EndPhysicalNames
$Nodes
6
11 0 0 0
12 1 0 0
13 2 0 0
14 0 1 0
15 1 1 0
16 2 1 0
$EndNodes
$Elements
9
1 1 2 3 1 11 12
2 1 2 3 2 12 13
3 1 2 4 3 13 16
4 1 2 4 3 16 15
5 1 2 4 3 15 14
6 1 2 4 3 14 11
7 1 2 0 4 12 15
8 3 4 7 1 1 2 11 12 15 14
9 3 2 8 2 12 13 16 15
$EndElements
)";

/// As `squares_2`, of second order: `fluid` of 9 nodes and `wall` of 8, clockwise. The sides along
/// x rise by -0.1 (below) and 0.2, the side between the cells by 0.1 to the right.
inline const std::string curved_squares = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
3
1 3 "below"
2 7 "fluid"
2 8 "wall"
$EndPhysicalNames
$Nodes
14
11 0 0 0
12 1 0 0
13 2 0 0
14 0 1 0
15 1 1 0
16 2 1 0
21 0.5 -0.1 0
22 1.5 -0.1 0
23 2 0.5 0
24 1.5 1.2 0
25 0.5 1.2 0
26 0 0.5 0
27 1.1 0.5 0
28 0.55 0.5 0
$EndNodes
$Elements
9
1 8 2 3 1 11 12 21
2 8 2 3 2 12 13 22
3 8 2 4 3 13 16 23
4 8 2 4 3 16 15 24
5 8 2 4 3 15 14 25
6 8 2 4 3 14 11 26
7 8 2 0 4 12 15 27
8 10 4 7 1 1 2 11 12 15 14 21 27 25 26 28
9 16 2 8 2 12 15 16 13 27 24 23 22
$EndElements
)";

/// The first of the squares alone in MSH 4.0.
inline const std::string square_4 = R"($MeshFormat
4 0 8
$EndMeshFormat
$Entities
1 1 1 0
1 0 0 0 0 0 0 1 5 0
2 0 0 0 1 1 0 1 3 0
6 0 0 0 1 1 0 1 100 0
$EndEntities
$Nodes
2 4
1 1 0 2
1 0 0 0
2 1 0 0
6 2 0 2
3 1 1 0
4 0 1 0
$EndNodes
$Elements
2 5
2 1 1 4
1 1 2
2 2 3
3 3 4
4 4 1
6 2 3 1
5 1 2 3 4
$EndElements
)";

/// The same in the format of before 2005.
inline const std::string square_1 = R"($NOD
4
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
$ENDNOD
$ELM
5
1 1 3 2 2 1 2
2 1 3 2 2 2 3
3 1 3 2 2 3 4
4 1 3 2 2 4 1
5 3 100 6 4 1 2 3 4
$ENDELM
)";

/// A cuboid with the edges 1, 2, 3: `block`, with the boundaries `floor` (z = 0) and `rest`.
inline const std::string block = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
3
2 1 "floor"
2 2 "rest"
3 1 "block"
$EndPhysicalNames
$Entities
0 1 2 1
1 0 0 0 1 0 0 0 0
1 0 0 0 1 2 0 1 1 0
2 0 0 0 1 2 3 1 2 0
1 0 0 0 1 2 3 1 1 0
$EndEntities
$Nodes
1 8 1 8
3 1 0 8
1
2
3
4
5
6
7
8
0 0 0
1 0 0
1 2 0
0 2 0
0 0 3
1 0 3
1 2 3
0 2 3
$EndNodes
$Elements
4 8 1 8
1 1 1 1
1 1 2
2 1 3 1
2 1 2 3 4
2 2 3 5
3 5 6 7 8
4 1 2 6 5
5 2 3 7 6
6 3 4 8 7
7 4 1 5 8
3 1 5 1
8 1 2 3 4 5 6 7 8
$EndElements
)";

/// The text with one piece exchanged.
inline std::string with(std::string text, const std::string &piece, const std::string &other)
{
  const std::size_t place = text.find(piece);
  if (place == std::string::npos)
    throw std::logic_error("the mesh has no '" + piece + "'");
  return text.replace(place, piece.size(), other);
}
} // namespace meshes

#endif
