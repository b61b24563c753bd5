# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     Parcels of a case at some times, side by side, as spheres of their size in
#     colours of their speed. For ParaView's python, off-screen:
#
#         xvfb-run -a pvbatch parcels.py CASE PICTURE.png TIME[,TIME...] [CLOUD]
#
#     etc/pictures/parcels runs it where ParaView is installed. It looks along
#     -z with y upward, and reads decomposed cases as well as whole ones.
# ------------------------------------------------------------------------------
"""Renders the parcels of an OpenFOAM case with ParaView."""

import sys
from pathlib import Path

from paraview import simple as pv

HEIGHT = 900  # of the picture, in pixels
HEAD = 0.08  # room above the mesh, below it half of that, in its heights
GAP = 0.2  # between the times, in widths of the mesh
LEGEND = 160  # its width in pixels
SPEED = "parcel velocity, m/s"
DARK = [0.15, 0.15, 0.15]


def open_region(case, region):
    """One region of the case: of the whole case if the parcels are there, else
    of its ranks."""
    marker = case / f"{case.name}.foam"
    marker.touch()
    whole = any(
        (entry / "lagrangian").is_dir() for entry in case.iterdir()
        if entry.name not in ("0", "0.orig")
    )
    reader = pv.OpenFOAMReader(
        FileName=str(marker),
        CaseType="Reconstructed Case" if whole else "Decomposed Case",
    )
    reader.MeshRegions = [region]
    reader.CellArrays = []
    return reader


def bounds_of(case):
    mesh = open_region(case, "internalMesh")
    mesh.UpdatePipeline()
    return mesh.GetDataInformation().GetBounds()


def show_parcels(case, cloud, time, offset, view):
    """Returns what is shown and the largest speed."""
    reader = open_region(case, f"lagrangian/{cloud}")
    frame = pv.ForceTime(Input=reader, ForcedTime=time)
    speed = pv.Calculator(Input=frame, ResultArrayName=SPEED,
                          Function="mag(U)")
    moved = pv.Transform(Input=speed)
    moved.Transform.Translate = [offset, 0, 0]

    spheres = pv.Glyph(Input=moved, GlyphType="Sphere")
    spheres.GlyphMode = "All Points"
    spheres.GlyphType.Radius = 0.5
    spheres.GlyphType.ThetaResolution = 12
    spheres.GlyphType.PhiResolution = 12
    spheres.ScaleArray = ["POINTS", "dParcel"]
    spheres.ScaleFactor = 1
    spheres.OrientationArray = ["POINTS", "No orientation array"]

    shown = pv.Show(spheres, view)
    pv.ColorBy(shown, ("POINTS", SPEED))
    return shown, spheres.PointData[SPEED].GetRange()[1]


def show_outline(bounds, offset, view):
    box = pv.Outline(Input=pv.Box(
        XLength=bounds[1] - bounds[0],
        YLength=bounds[3] - bounds[2],
        ZLength=bounds[5] - bounds[4],
        Center=[
            (bounds[0] + bounds[1]) / 2 + offset,
            (bounds[2] + bounds[3]) / 2,
            (bounds[4] + bounds[5]) / 2,
        ],
    ))
    shown = pv.Show(box, view)
    shown.AmbientColor = shown.DiffuseColor = DARK
    shown.LineWidth = 1.5


def show_text(text, position, view):
    shown = pv.Show(pv.Text(Text=text), view)
    shown.WindowLocation = "Any Location"
    shown.Position = position
    shown.Color, shown.FontSize = DARK, 20


def show_legend(shown, largest, view):
    colours = pv.GetColorTransferFunction(SPEED)
    colours.ApplyPreset("Viridis (matplotlib)", True)
    colours.RescaleTransferFunction(0, largest)
    legend = pv.GetScalarBar(colours, view)
    legend.Title, legend.ComponentTitle = SPEED, ""
    legend.TitleColor = legend.LabelColor = DARK
    legend.RangeLabelFormat = "%.2f"
    legend.WindowLocation = "Any Location"
    legend.Position = [1 - LEGEND / view.ViewSize[0], 0.2]
    legend.ScalarBarLength = 0.55
    shown.SetScalarBarVisibility(view, True)


def look_at(bounds, width, view):
    """Along -z, without perspective; width is that of all times together."""
    height = bounds[3] - bounds[2]
    full = (1 + 1.5 * HEAD) * height
    scale = HEIGHT / full
    view.ViewSize = [int(scale * width) + LEGEND, HEIGHT]

    margin = (view.ViewSize[0] / scale - width) / 2
    x = bounds[0] + width / 2 + margin
    y = bounds[2] + height / 2 + 0.25 * HEAD * height
    view.CameraParallelProjection = 1
    view.CameraParallelScale = full / 2
    view.CameraFocalPoint = [x, y, (bounds[4] + bounds[5]) / 2]
    view.CameraPosition = [x, y, bounds[5] + 10 * height]
    view.CameraViewUp = [0, 1, 0]


def main():
    case, picture = Path(sys.argv[1]).resolve(), sys.argv[2]
    times = [float(time) for time in sys.argv[3].split(",")]
    cloud = sys.argv[4] if len(sys.argv) > 4 else "parcels"

    pv._DisableFirstRenderCameraReset()
    view = pv.CreateRenderView()
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0

    bounds = bounds_of(case)
    width = bounds[1] - bounds[0]
    step = (1 + GAP) * width
    margin = GAP * width / 2
    look_at([bounds[0] - margin, *bounds[1:]], len(times) * step, view)

    largest = 0
    for i, time in enumerate(times):
        show_outline(bounds, i * step, view)
        shown, speed = show_parcels(case, cloud, time, i * step, view)
        largest = max(largest, speed)
        pixels = view.ViewSize[0] - LEGEND
        show_text(f"t = {time:g} s",
                  [((i + 0.1) * pixels / len(times)) / view.ViewSize[0], 0.95],
                  view)

    show_legend(shown, largest, view)
    pv.Render(view)
    pv.SaveScreenshot(picture, view)


main()
