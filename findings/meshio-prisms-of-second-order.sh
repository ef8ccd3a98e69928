#!/usr/bin/env bash
# Library:  meshio
# Version:  Debian 12: python3-meshio 7.0.0-3 (its meshio.__version__ is 5.0.0)
# Sentence: A .vtu that meshio makes from Gmsh's .msh has ten of the 18 nodes of a prism of second order in wrong places.
#
# Guessed:  meshio knows both formats, and it reorders the nodes of cells of second order. So a prism has the same shape in the .vtu.
# Seen:     meshio reorders the nodes of the 20-node and 27-node hexahedron, of the 10-node tetrahedron and of the 15-node prism. Its
#           table has no row for the 18-node prism, which is the one that Gmsh makes for Mesh.ElementOrder = 2. The nodes keep
#           Gmsh's order, without a message, and VTK takes them for other nodes. The cell is folded.
# Output:   One straight prism with the volume 0.5, by VTK's shape functions. "Middle" is the place of its middle:
#               Gmsh's own .vtk            nodes in wrong places  0  volume  0.5000  middle 0.3333 0.3333 0.5000
#               meshio's .vtu              nodes in wrong places 10  volume -0.0360  middle 0.3333 0.3333 0.3333
#               meshio's .vtu, reordered   nodes in wrong places  0  volume  0.5000  middle 0.3333 0.3333 0.5000
# Matters:  A mesh of a vessel with a layer of prisms at the wall, and the results of another code on it, often come to ParaView by
#           meshio. Values between the nodes, probes, slices and volumes are then wrong, and so is a comparison with Continua.
#           The nodes themselves, and values at the nodes, are right.
# To do:    Let Gmsh write the .vtk. Or reorder the nodes after meshio.read, by ORDER_OF_VTK below. Look at the volumes.
#           ("vtk-volume-of-second-order-cells" tells why VTK's filters are no help there.)
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../scripts/lib/findings.sh"
need_installed python3-vtk9 9.1.0
need_installed python3-numpy 1:1.24.2
unpack python3-meshio=7.0.0-3 python3-rich=13.3.1-1 python3-commonmark=0.9.1-4 gmsh=4.8.4+ds2-3
need_libraries gmsh
"$python" -c 'import meshio' 2>import.log || skip "meshio does not start: $(tail -n 1 import.log)"

cat >finding.py <<'END'
import subprocess
import sys

import meshio
import vtk

# The 18-node prism as Gmsh's manual and gmsh.model.mesh.getElementProperties(13) have it, with the height 1.
NODES = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (0, 1, 1),
         (0.5, 0, 0), (0, 0.5, 0), (0, 0, 0.5), (0.5, 0.5, 0), (1, 0, 0.5), (0, 1, 0.5), (0.5, 0, 1), (0, 0.5, 1), (0.5, 0.5, 1),
         (0.5, 0, 0.5), (0, 0.5, 0.5), (0.5, 0.5, 0.5)]
# What VTK's nodes are among Gmsh's: its edges are those of the lower triangle, of the upper one and the upright ones.
ORDER_OF_VTK = [0, 1, 2, 3, 4, 5, 6, 9, 7, 12, 14, 13, 8, 10, 11, 15, 17, 16]
GAUSS = (0.5 - 0.5 / 3**0.5, 0.5 + 0.5 / 3**0.5)
RULE = [(1 / 12, (*point, z)) for point in ((1 / 6, 1 / 6), (2 / 3, 1 / 6), (1 / 6, 2 / 3)) for z in GAUSS]


def write_mesh(path):
    """One prism as .msh of version 2.2."""
    with open(path, "w") as stream:
        stream.write(f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{len(NODES)}\n")
        for number, node in enumerate(NODES, 1):
            stream.write(f"{number} {node[0]} {node[1]} {node[2]}\n")
        numbers = " ".join(str(i + 1) for i in range(len(NODES)))
        stream.write(f"$EndNodes\n$Elements\n1\n1 13 2 1 1 {numbers}\n$EndElements\n")


def read_cell(reader, path):
    reader.SetFileName(path)
    reader.Update()
    cell = reader.GetOutput().GetCell(0)
    if cell.GetCellType() != vtk.VTK_BIQUADRATIC_QUADRATIC_WEDGE:
        sys.exit(f"{path}: the cell is a {cell.GetClassName()}")
    return cell


def place(cell, parameters):
    """Where VTK's shape functions put a point of the reference prism."""
    result = [0.0] * 3
    cell.EvaluateLocation(vtk.reference(0), parameters, result, [0.0] * 18)
    return result


def judge(name, cell):
    """Nodes in wrong places, the volume by VTK's shape functions, and the middle of the prism."""
    parameters = cell.GetParametricCoords()
    n_wrong = sum(any(abs(cell.GetPoints().GetPoint(i)[k] - parameters[3 * i + k]) > 1e-9 for k in range(3)) for i in range(18))
    volume, step = 0.0, 0.01
    for weight, point in RULE:
        columns = []
        for k in range(3):
            up, down = list(point), list(point)
            up[k] += step
            down[k] -= step
            columns.append([(a - b) / (2 * step) for a, b in zip(place(cell, up), place(cell, down))])
        volume += weight * vtk.vtkMath.Determinant3x3(*columns)
    middle = place(cell, (1 / 3, 1 / 3, 0.5))
    print("{:24}  nodes in wrong places {:2}  volume {:7.4f}  middle {:.4f} {:.4f} {:.4f}".format(name, n_wrong, volume, *middle))
    return n_wrong, volume


write_mesh("prism.msh")
mesh = meshio.read("prism.msh")
meshio.write("meshio.vtu", mesh)
mesh.cells[0].data = mesh.cells[0].data[:, ORDER_OF_VTK]
meshio.write("reordered.vtu", mesh)
subprocess.run(["gmsh", "prism.msh", "-save", "-format", "vtk", "-o", "gmsh.vtk"], check=True, stdout=subprocess.DEVNULL)
right = judge("Gmsh's own .vtk", read_cell(vtk.vtkUnstructuredGridReader(), "gmsh.vtk"))
found = judge("meshio's .vtu", read_cell(vtk.vtkXMLUnstructuredGridReader(), "meshio.vtu"))
reordered = judge("meshio's .vtu, reordered", read_cell(vtk.vtkXMLUnstructuredGridReader(), "reordered.vtu"))
for n_wrong, volume in (right, reordered):
    if n_wrong or abs(volume - 0.5) > 1e-6:
        sys.exit("the mesh, or the rule of this script, is wrong")
sys.exit(0 if found[0] == 10 and abs(found[1] + 0.0360) < 1e-4 else 3)
END
judge "$python" finding.py
