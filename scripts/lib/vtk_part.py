"""A part of a grid of VTK."""

import vtk


def part_of(grid, field="phase", above=False):
    """The cells of which all points have the field below 0.5 (of `phase` the liquid), or above."""
    choose = vtk.vtkThreshold()
    choose.SetInputData(grid)
    choose.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_POINTS, field)
    choose.SetThresholdFunction(vtk.vtkThreshold.THRESHOLD_UPPER if above else vtk.vtkThreshold.THRESHOLD_LOWER)
    choose.SetLowerThreshold(0.5)
    choose.SetUpperThreshold(0.5)
    choose.Update()
    return choose.GetOutput()
