"""Run by the Python that has the reader: reads a file that we exported and says what is in it.

read_formats.py READER FILE
Writes lines "KEY VALUE". READER is ase, meshio, vtk-obj, vtk-ply, vtk-materials or has-READER, which only says whether
it is there.
"""
import sys


def with_ase(path):
    import ase.io

    frames = ase.io.read(path, index=":", format="extxyz")
    print("frames", len(frames))
    last = frames[-1]
    print("points", len(last))
    print("time", repr(float(last.info["Time"])))
    print("materials", len(set(last.get_chemical_symbols())))
    for name in ("velo", "fragment", "material", "masses"):
        assert len(last.arrays[name]) == len(last), name
    print("sum", repr(float(last.positions.sum())))


def with_meshio(path):
    import warnings

    warnings.simplefilter("ignore")
    import meshio

    mesh = meshio.read(path)
    print("points", len(mesh.points))
    print("faces", sum(len(block.data) for block in mesh.cells))
    print("sum", repr(float(mesh.points.sum())))
    for block in mesh.cells:
        assert block.data.max() < len(mesh.points)
    for name, values in mesh.point_data.items():
        assert len(values) == len(mesh.points), name
    for name in ("damage", "fragment", "material", "inside"):
        if name in mesh.point_data:
            print("has-" + name, len(set(mesh.point_data[name])))


def with_vtk(reader, path):
    reader.SetFileName(path)
    reader.Update()
    data = reader.GetOutput()
    print("points", data.GetNumberOfPoints())
    print("faces", data.GetNumberOfCells())


def materials_in_vtk(path):
    """As ParaView and others import a file, knowing its name alone."""
    import os
    import tempfile

    from vtkmodules.vtkCommonCore import vtkFileOutputWindow, vtkOutputWindow
    from vtkmodules.vtkIOImport import vtkOBJImporter
    import vtkmodules.vtkRenderingOpenGL2  # noqa: F401

    with tempfile.TemporaryDirectory() as folder:
        window = vtkFileOutputWindow()
        window.SetFileName(os.path.join(folder, "errors.txt"))
        window.SetFlush(True)
        vtkOutputWindow.SetInstance(window)
        importer = vtkOBJImporter()
        importer.SetFileName(path)
        importer.Update()
        print("actors", importer.GetRenderer().GetActors().GetNumberOfItems())
        written = os.path.join(folder, "errors.txt")
        print("errors", open(written).read().count("ERR") if os.path.exists(written) else 0)
    actors = importer.GetRenderer().GetActors()
    actors.InitTraversal()
    colours = {tuple(round(c, 3) for c in actors.GetNextActor().GetProperty().GetDiffuseColor())
               for _ in range(actors.GetNumberOfItems())}
    print("colours", len(colours))


def main():
    reader, *files = sys.argv[1:]
    if reader == "has-ase":
        import ase.io  # noqa: F401
    elif reader == "has-meshio":
        import meshio  # noqa: F401
    elif reader == "has-vtk":
        import vtkmodules.vtkIOGeometry  # noqa: F401
        import vtkmodules.vtkIOImport  # noqa: F401
        import vtkmodules.vtkIOPLY  # noqa: F401
    elif reader == "ase":
        with_ase(*files)
    elif reader == "meshio":
        with_meshio(*files)
    elif reader == "vtk-obj":
        from vtkmodules.vtkIOGeometry import vtkOBJReader

        with_vtk(vtkOBJReader(), *files)
    elif reader == "vtk-ply":
        from vtkmodules.vtkIOPLY import vtkPLYReader

        with_vtk(vtkPLYReader(), *files)
    elif reader == "vtk-materials":
        materials_in_vtk(*files)


main()
