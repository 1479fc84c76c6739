"""The picture of doc/solution-file.md:  xvfb-run -a pvpython
doc/images/coulomb_in_paraview.py coulomb.out/solution.hdf doc/images/paraview-coulomb.png"""
import sys

from paraview import simple as pv

source, picture = sys.argv[1:]
view = pv.CreateView("RenderView")
view.ViewSize = [900, 720]
view.Background = [1, 1, 1]
view.UseColorPaletteForBackground = 0
view.OrientationAxesVisibility = 0
view.InteractionMode = "2D"

body = pv.VTKHDFReader(FileName=source)
body.UpdatePipeline()
outline = pv.Show(body, view)
outline.Representation = "Wireframe"
outline.ColorArrayName = ["POINTS", ""]
outline.DiffuseColor = outline.AmbientColor = [0.5, 0.5, 0.5]

warp = pv.WarpByVector(Input=body)
warp.Vectors = ["POINTS", "displacement"]
warp.ScaleFactor = 2
warped = pv.Show(warp, view)
warped.LineWidth = 4
pv.ColorBy(warped, ("POINTS", "displacement", "Magnitude"))
colours = pv.GetColorTransferFunction("displacement")
bar = pv.GetScalarBar(colours, view)
bar.Title = "displacement"
bar.ComponentTitle = "size"
bar.TitleColor = bar.LabelColor = [0, 0, 0]
bar.Visibility = 1
warped.SetScalarBarVisibility(view, True)

arrows = pv.Glyph(Input=warp, GlyphType="Arrow")
arrows.OrientationArray = ["POINTS", "traction"]
arrows.ScaleArray = ["POINTS", "traction"]
arrows.ScaleFactor = 0.15
arrows.GlyphMode = "Uniform Spatial Distribution (Bounds Based)"
arrows.MaximumNumberOfSamplePoints = 2000
shown = pv.Show(arrows, view)
shown.ColorArrayName = ["POINTS", ""]
shown.DiffuseColor = shown.AmbientColor = [0.6, 0.05, 0.05]

pv.ResetCamera(view)
view.CameraParallelScale *= 1.1
pv.Render(view)
pv.SaveScreenshot(picture, view)
