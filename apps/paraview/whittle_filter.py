# SPDX-License-Identifier: BSD-3-Clause
"""Simplify with Whittle: a filter of ParaView 5.10 and later. It needs the Python package whittle."""

from typing import Any

import whittle
from paraview.util.vtkAlgorithm import smdomain, smproperty, smproxy
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter

TARGETS = ("face_ratio", "faces_left", "max_error")
EFFORTS = ("fast", "normal", "best")


def _choice(name: str, texts: tuple[str, ...], standard: int) -> str:
    """A property that is one of some texts."""
    entries = "".join(f'<Entry value="{i}" text="{text}"/>' for i, text in enumerate(texts))
    return f"""<IntVectorProperty name="{name}" command="Set{name}" number_of_elements="1" default_values="{standard}">
        <EnumerationDomain name="enum">{entries}</EnumerationDomain></IntVectorProperty>"""


def _number(name: str, label: str, help: str, target: int, standard: str, low: str, kind: str = "Double") -> str:
    """A number that shows for one of the targets."""
    return f"""<{kind}VectorProperty name="{name}" label="{label}" command="Set{name}" number_of_elements="1"
        default_values="{standard}"><{kind}RangeDomain name="range" min="{low}"/><Documentation>{help}</Documentation>
        <Hints><PropertyWidgetDecorator type="GenericDecorator" mode="visibility" property="Target" value="{target}"/>
        </Hints></{kind}VectorProperty>"""


def _triangles(surface: Any) -> Any:
    """Its polygons and strips as triangles, without its lines and vertices."""
    triangles = vtkTriangleFilter()
    triangles.SetInputData(surface)
    triangles.PassLinesOff()
    triangles.PassVertsOff()
    triangles.Update()
    return triangles.GetOutput()


# In the order in which they show.
PROPERTIES = (
    _choice("Target", ("Share of the Faces", "Number of Faces", "Largest Error"), 0)
    + _number("FaceRatio", "Face Ratio", "A share of the faces.", 0, "0.1", "0")
    + _number("Faces", "Faces", "The number of faces.", 1, "1000", "1", "Int")
    + _number("MaxError", "Max Error (%)", "The largest distance, % of the diagonal; proven.", 2, "0.1", "0")
    + _choice("Effort", EFFORTS, 1)
)


@smproxy.filter(name="WhittleSimplify", label="Simplify With Whittle")
@smproperty.xml(PROPERTIES + '<Hints><ShowInMenu category="Whittle"/></Hints>')
@smproperty.input(name="Input")
@smdomain.datatype(dataTypes=["vtkPolyData"], composite_data_supported=False)
class WhittleSimplify(VTKPythonAlgorithmBase):
    """Simplifies a surface to a share or number of faces, or within a distance that is proven."""

    def __init__(self) -> None:
        super().__init__(nInputPorts=1, nOutputPorts=1, outputType="vtkPolyData")
        self._target = 0
        self._values: list[Any] = [0.1, 1000, "0.1%"]
        self._effort = 1

    def _set(self, target: int, value: Any) -> None:
        self._values[target] = value
        self.Modified()

    def SetTarget(self, target: int) -> None:
        self._target = target
        self.Modified()

    def SetFaceRatio(self, share: float) -> None:
        self._set(0, share)

    def SetFaces(self, number: int) -> None:
        self._set(1, number)

    def SetMaxError(self, percent: float) -> None:
        self._set(2, f"{percent}%")

    def SetEffort(self, effort: int) -> None:
        self._effort = effort
        self.Modified()

    def _tell(self, stage: str, fraction: float) -> None:
        self.SetProgressText(stage)
        self.UpdateProgress(fraction)

    def RequestData(self, request: Any, inputs: Any, outputs: Any) -> int:
        surface = _triangles(vtkPolyData.GetData(inputs[0]))
        target = {TARGETS[self._target]: self._values[self._target]}
        if surface.GetNumberOfPolys() > 0:
            surface = whittle.simplify(surface, effort=EFFORTS[self._effort], progress=self._tell, **target)
        vtkPolyData.GetData(outputs).ShallowCopy(surface)
        return 1
