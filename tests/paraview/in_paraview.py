"""Runs inside ParaView's Python: pvpython --force-offscreen-rendering in_paraview.py FILTER FOLDER."""

import inspect
import sys
from pathlib import Path

if not hasattr(inspect, "getargspec"):  # Debian 12's ParaView 5.11 loads no plugin in Python without it
    inspect.getargspec = inspect.getfullargspec
try:
    import whittle
except ImportError as problem:
    print(f"skipped: ParaView's Python {sys.version_info.major}.{sys.version_info.minor}: {problem}")
    sys.exit(77)

from paraview import simple
from paraview.vtk.numpy_interface import dataset_adapter

simple.LoadPlugin(str(Path(sys.argv[1])), remote=False, ns=globals())


def faces_of(source):
    source.UpdatePipeline()
    return source.GetDataInformation().GetNumberOfCells()


def fetched(source):
    return dataset_adapter.WrapDataObject(simple.servermanager.Fetch(source))


def check(holds, what):
    if not holds:
        sys.exit(f"failed: {what}")


sphere = simple.Sphere(ThetaResolution=100, PhiResolution=60)
n = faces_of(sphere)
small = SimplifyWithWhittle(Input=sphere)  # noqa: F821
check(abs(faces_of(small) - n / 10) <= 1, "a tenth of the faces is the default")
small.FaceRatio = 0.05
check(abs(faces_of(small) - n / 20) <= 1, "a share of the faces")
small.Target = "Number of Faces"
small.Faces = 300
check(299 <= faces_of(small) <= 300, "a number of faces")
small.Effort = "fast"
fast = fetched(small).Points.copy()
small.Effort = "best"
check(fast.shape != fetched(small).Points.shape or (fast != fetched(small).Points).any(), "the effort")
small.Target = "Largest Error"
small.MaxError = 0.5
within = faces_of(small)
check(0 < within < n, "a largest error")
original, simplified = fetched(sphere), fetched(small)
diagonal = 3**0.5
proven = whittle.certify(original.VTKObject, simplified.VTKObject)["proven"]
check(proven <= 0.005 * diagonal * 1.001, f"within the error: {proven}")

colored = simple.Elevation(Input=sphere, LowPoint=[0, 0, -0.5], HighPoint=[0, 0, 0.5])
result = fetched(SimplifyWithWhittle(Input=colored, FaceRatio=0.1))  # noqa: F821
check(abs(result.PointData["Elevation"] - (result.Points[:, 2] + 0.5)).max() < 0.02, "arrays of points go along")
check(len(result.PointData["Normals"]) == len(result.Points), "normals go along")

squares = simple.Plane(XResolution=20, YResolution=20)
check(faces_of(SimplifyWithWhittle(Input=squares, FaceRatio=0.1)) <= 80, "polygons are cut into triangles")  # noqa: F821
# As docs/user/other-programs.md has it.
script = "import whittle\noutput.ShallowCopy(whittle.simplify(inputs[0].VTKObject, face_ratio=0.1))"
programmable = simple.ProgrammableFilter(Input=sphere, Script=script, OutputDataSetType="vtkPolyData")
check(abs(faces_of(programmable) - n / 10) <= 1, "a programmable filter")

small.Target = "Share of the Faces"
small.FaceRatio = 2  # which is refused, and ParaView goes on
small.UpdatePipeline()
small.FaceRatio = 0.05
check(abs(faces_of(small) - n / 20) <= 1, "after a mistake")
print("done")
