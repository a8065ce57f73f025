# SPDX-License-Identifier: BSD-3-Clause
"""The opacity unit distance stays about the length of a cell when finer data are read, unless somebody chose another."""

from vtkmodules.vtkIOXML import vtkXMLUniformGridAMRWriter

from Support import *

load_plugin()
collector = Collector()
source = make_scene()
writer = vtkXMLUniformGridAMRWriter()
writer.SetInputDataObject(source.GetClientSideObject().GetOutputDataObject(0))
writer.SetDataModeToBinary()
writer.SetFileName(os.path.abspath("scene.vth"))
assert writer.Write()
simple.Delete(source)

COARSE, FINE = 2, 4  # levels
reader = simple.OpenDataFile([os.path.abspath("scene.vth")])
reader.DefaultNumberOfLevels = COARSE
reader.UpdatePipeline()
view = make_view()
display = show(reader, view)
look_at(reader, view)


def cell_length():
    """What ParaView takes for it: the diagonal over the cube root of the number of cells."""
    information = reader.GetDataInformation()
    bounds = information.GetBounds()
    diagonal = math.sqrt(sum((bounds[2 * i + 1] - bounds[2 * i]) ** 2 for i in range(3)))
    return diagonal / information.GetNumberOfCells() ** (1.0 / 3.0)


def expect_distance(expected, what):
    simple.Render(view)
    found = display.OpacityUnitDistance
    print(f"{what}: {found}, expected {expected}")
    assert abs(found - expected) < 1e-6 * expected, what


simple.Render(view)
coarse = cell_length()
expect_distance(coarse, "at first")
reader.DefaultNumberOfLevels = FINE
simple.Render(view)
assert cell_length() < 0.9 * coarse, (cell_length(), coarse)
expect_distance(cell_length(), "more levels")
fine = picture(view, "fine")
display.OpacityUnitDistance = cell_length()
expect_alike(picture(view, "same"), fine, 60.0, "the picture has the new distance")

# Also while another representation is shown.
display.SetRepresentationType("Outline")
reader.DefaultNumberOfLevels = COARSE
simple.Render(view)
display.SetRepresentationType("ExaBricks")
expect_distance(coarse, "as many levels as at first")

# Somebody's own stays, until it is set back to the default.
display.OpacityUnitDistance = 5.0
reader.DefaultNumberOfLevels = FINE
expect_distance(5.0, "chosen")
display.SMProxy.GetProperty("OpacityUnitDistance").ResetToDomainDefaults(False)
expect_distance(cell_length(), "set back")
reader.DefaultNumberOfLevels = COARSE
expect_distance(coarse, "set back, and as many levels as at first")

# A state keeps what was chosen, and goes on to keep the default.
for chosen in (None, 5.0):
    if chosen:
        display.OpacityUnitDistance = chosen
    simple.Render(view)
    simple.SaveState("session.pvsm")
    simple.ResetSession()
    load_plugin()
    simple.LoadState("session.pvsm")
    view = simple.GetActiveViewOrCreate("RenderView")
    reader, = simple.GetSources().values()
    display = simple.GetDisplayProperties(reader, view)
    expect_distance(chosen or coarse, "from a state")
    reader.DefaultNumberOfLevels = FINE
    simple.Render(view)
    expect_distance(chosen or cell_length(), "from a state, more levels")
    reader.DefaultNumberOfLevels = COARSE
    simple.Render(view)

# Nothing but that few levels were read, by each of the mappers. (The unit distance of ParaView's own volume rendering is
# that of the first data, which nobody set.)
assert collector.said and all("Of 4 levels 2 were read" in text for text in collector.said), collector.said
