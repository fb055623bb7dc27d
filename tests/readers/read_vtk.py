"""Run by the Python that has VTK: reads a .vtu with VTK's own reader and writes what is in it.

read_vtk.py FILE OUT
Writes "point x y z vx vy vz fragment" lines, then "bond a b strain broken" lines.
"""
import sys

from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

source, out = sys.argv[1:]
reader = vtkXMLUnstructuredGridReader()
reader.SetFileName(source)
reader.Update()
grid = reader.GetOutput()
with open(out, "w") as file:
    points = grid.GetPointData()
    velocity, fragment = points.GetArray("velocity"), points.GetArray("fragment")
    for i in range(grid.GetNumberOfPoints()):
        numbers = [*grid.GetPoint(i), *velocity.GetTuple(i), fragment.GetValue(i)]
        file.write("point " + " ".join(f"{number:.17g}" for number in numbers) + "\n")
    cells = grid.GetCellData()
    strain, broken = cells.GetArray("strain"), cells.GetArray("broken")
    for i in range(grid.GetNumberOfCells()):
        line = grid.GetCell(i)
        ends = [line.GetPointId(0), line.GetPointId(1)]
        file.write(f"bond {ends[0]} {ends[1]} {strain.GetValue(i):.17g} {broken.GetValue(i)}\n")
