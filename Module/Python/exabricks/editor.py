# SPDX-License-Identifier: BSD-3-Clause
"""The viewer's editor: colors and opacities over a histogram."""

import math

import vtkmodules.vtkRenderingContextOpenGL2  # noqa: F401  draws it
from vtkmodules.vtkChartsCore import (
    vtkAxis,
    vtkChart,
    vtkChartXY,
    vtkCompositeTransferFunctionItem,
    vtkPiecewiseControlPointsItem,
)
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkTable
from vtkmodules.vtkRenderingContext2D import vtkContextActor
from vtkmodules.vtkRenderingCore import vtkRenderer
from vtkmodules.vtkViewsContext2D import vtkContextInteractorStyle

HISTOGRAM_BINS = 128


class TransferFunctionEditor:
    """Control points of the opacities of a VolumeScene, over the volume that leaf cells of each value take, logarithmic upwards.

    `renderer`: what draws it. `style`: the interactor style that moves points, while attach() lets it. `moving` and `moved`
    are called while and after a point is moved.
    """

    def __init__(self, moving, moved):
        self._moving = moving
        self._moved = moved
        self.chart = vtkChartXY()
        self.chart.SetShowLegend(False)
        self.chart.ForceAxesToBoundsOn()
        # The buttons move points; the view of the axes stays.
        for action in (vtkChart.PAN, vtkChart.ZOOM, vtkChart.SELECT, vtkChart.SELECT_RECTANGLE):
            self.chart.SetActionToButton(action, -1)
        for action in (vtkChart.SELECT, vtkChart.NOTIFY):
            self.chart.SetClickActionToButton(action, -1)
        self.chart.SetZoomWithMouseWheel(False)
        for place in (vtkAxis.BOTTOM, vtkAxis.LEFT):
            axis = self.chart.GetAxis(place)
            axis.GetLabelProperties().SetColor(1.0, 1.0, 1.0)
            axis.GetTitleProperties().SetColor(1.0, 1.0, 1.0)
            axis.GetPen().SetColor(255, 255, 255, 255)
            axis.SetGridVisible(False)
        self.chart.GetAxis(vtkAxis.LEFT).SetTitle("opacity")
        self.chart.GetAxis(vtkAxis.LEFT).SetBehavior(vtkAxis.FIXED)
        self.chart.GetAxis(vtkAxis.LEFT).SetRange(0.0, 1.0)
        self._actor = vtkContextActor()
        self._actor.GetScene().AddItem(self.chart)
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(0.15, 0.15, 0.15)
        self.renderer.AddActor(self._actor)
        self._actor.GetScene().SetRenderer(self.renderer)
        self.style = vtkContextInteractorStyle()

    def attach(self, attached):
        """Whether the style hears of changes: without an interactor it must not."""
        self.style.SetScene(self._actor.GetScene() if attached else None)

    def fill(self, scene, title):
        """Takes the histogram and the functions of a scene. `title`: of the values."""
        self.chart.ClearPlots()
        self.chart.AddPlot(self._functions(scene))
        value_range = [0.0, 0.0]
        scene.data.GetScalarRange(value_range)
        bars = self.chart.AddPlot(vtkChart.BAR)
        bars.SetInputData(_histogram(scene.data, value_range), 0, 1)
        bars.SetColor(200, 200, 200, 90)
        self.chart.AddPlot(self._points(scene))
        low, high = scene.color_range
        spread = value_range[1] - value_range[0] or max(abs(low), 1.0) * 1e-6
        bottom = self.chart.GetAxis(vtkAxis.BOTTOM)
        bottom.SetTitle(title)
        bottom.SetBehavior(vtkAxis.FIXED)
        bottom.SetRange(min(low, value_range[0]), max(high, value_range[0] + spread))

    def _functions(self, scene):
        functions = vtkCompositeTransferFunctionItem()
        functions.SetColorTransferFunction(scene.volume_property.GetRGBTransferFunction())
        functions.SetOpacityFunction(scene.volume_property.GetScalarOpacity())
        functions.SetMaskAboveCurve(True)
        return functions

    def _points(self, scene):
        points = vtkPiecewiseControlPointsItem()
        points.SetPiecewiseFunction(scene.volume_property.GetScalarOpacity())
        points.SetEndPointsRemovable(False)
        points.AddObserver("InteractionEvent", lambda *_: self._moving())
        points.AddObserver("EndInteractionEvent", lambda *_: self._moved())
        return points


def _histogram(data, value_range):
    """Middles of bins, and how high they stand in [0, 1]: by the logarithm of their share of the volume."""
    shares = vtkDoubleArray()
    data.GetVolumeHistogram(HISTOGRAM_BINS, shares)
    shares = [shares.GetValue(i) for i in range(HISTOGRAM_BINS)]
    least = min((share for share in shares if share > 0.0), default=1.0)
    decades = max(math.log10(1.0 / least), 1.0) + 1.0
    values = vtkDoubleArray()
    values.SetName("value")
    heights = vtkDoubleArray()
    heights.SetName("share of the volume")
    for i, share in enumerate(shares):
        values.InsertNextValue(value_range[0] + (i + 0.5) / HISTOGRAM_BINS * (value_range[1] - value_range[0]))
        heights.InsertNextValue((1.0 + math.log10(share / least)) / decades if share > 0.0 else 0.0)
    table = vtkTable()
    table.AddColumn(values)
    table.AddColumn(heights)
    return table
