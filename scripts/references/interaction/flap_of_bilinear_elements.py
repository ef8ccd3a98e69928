#!/usr/bin/env python3
"""By how much a mesh of 4 x 100 bilinear elements makes a flap too stiff.

Bilinear quadrilaterals with full integration cannot bend without shear. The published finite elements of the flap in Mok's channel are of this kind
(KratosMultiphysics/Examples, fluid_structure_interaction/validation/fsi_mok: 4 x 100 elements, plane stress). The script computes the deflection of the
clamped flap under a uniform pressure with such a mesh and with finer ones, and compares it with that of the finest.
"""

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import spsolve

LENGTH, THICKNESS = 0.25, 0.005  # m
MODULUS, RATIO = 2.3e6, 0.45  # Pa, 1


def element(size_x, size_y):
    """The stiffness of a rectangle in plane stress by 2 x 2 points, per metre of depth, in N/m."""
    law = MODULUS / (1 - RATIO**2) * np.array([[1, RATIO, 0], [RATIO, 1, 0], [0, 0, (1 - RATIO) / 2]])
    signs = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    stiffness = np.zeros((8, 8))
    for place in signs / np.sqrt(3):
        strain = np.zeros((3, 8))
        for corner, (a, b) in enumerate(signs):
            slope = np.array([a * (1 + b * place[1]) / (2 * size_x), b * (1 + a * place[0]) / (2 * size_y)])
            strain[:, 2 * corner : 2 * corner + 2] = [[slope[0], 0], [0, slope[1]], [slope[1], slope[0]]]
        stiffness += strain.T @ law @ strain * size_x * size_y / 4
    return stiffness


def tip_deflection(across, along, pressure=1.0):
    """The deflection of the tip under a pressure in Pa on one side, in m."""
    matrix = element(THICKNESS / across, LENGTH / along)
    nodes = np.arange((across + 1) * (along + 1)).reshape(along + 1, across + 1)
    corners = np.stack([nodes[:-1, :-1], nodes[:-1, 1:], nodes[1:, 1:], nodes[1:, :-1]], axis=-1).reshape(-1, 4)
    unknowns = (2 * corners[:, :, None] + np.arange(2)).reshape(-1, 8)
    rows, columns = np.repeat(unknowns, 8, axis=1), np.tile(unknowns, 8)
    values = np.tile(matrix.ravel(), len(unknowns))
    size = 2 * nodes.size
    stiffness = coo_matrix((values, (rows.ravel(), columns.ravel())), shape=(size, size)).tocsr()
    force = np.zeros(size)
    share = np.full(along + 1, pressure * LENGTH / along)
    share[[0, -1]] /= 2
    force[2 * nodes[:, 0]] = share
    free = np.arange(2 * (across + 1), size)
    motion = np.zeros(size)
    motion[free] = spsolve(stiffness[free][:, free].tocsc(), force[free])
    return motion[2 * nodes[-1, 0]]


finest = tip_deflection(32, 3200)
for mesh in ((4, 100), (4, 200), (8, 400), (16, 1600)):
    print(f"{mesh[0]:3d} x {mesh[1]:5d} elements: too stiff by {100 * (finest / tip_deflection(*mesh) - 1):6.2f} %")
