"""A picture of a PLY file by VTK, without a display: a whole process that luxel's is timed beside.

    python3 picture.py MODEL.ply OUT.png 640x480

Needs the package vtk, of which only the modules are loaded that this takes. The eye is where ../processes
has luxel's, light and material are alike, as far as VTK's own shader has them; one sample a pixel.
"""

import sys

from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkWindowToImageFilter
from vtkmodules.vtkRenderingOpenGL2 import vtkEGLRenderWindow

model, out, size = sys.argv[1:]
reader = vtkPLYReader(file_name=model)
mapper = vtkPolyDataMapper()
mapper.SetInputConnection(reader.GetOutputPort())
actor = vtkActor(mapper=mapper)
surface = actor.GetProperty()
surface.SetColor(0.8, 0.7, 0.6)
surface.SetAmbient(0.1)
surface.SetSpecular(0.4)
surface.SetSpecularPower(32)
light = vtkLight(position=(0.4, 0.6, 1), intensity=0.6)
light.SetLightTypeToCameraLight()
renderer = vtkRenderer(background=(0, 0, 0), automatic_light_creation=False)
renderer.AddLight(light)
renderer.AddActor(actor)
camera = renderer.GetActiveCamera()
camera.SetPosition(0, 0, 3)
camera.SetFocalPoint(0, 0, 0)
camera.SetViewAngle(45)
renderer.ResetCameraClippingRange()
window = vtkEGLRenderWindow()
window.SetOffScreenRendering(True)
window.SetMultiSamples(0)
window.SetSize(*map(int, size.split("x")))
window.AddRenderer(renderer)
window.Render()
pixels = vtkWindowToImageFilter(input=window, read_front_buffer=False, should_rerender=False)
writer = vtkPNGWriter(file_name=out)
writer.SetInputConnection(pixels.GetOutputPort())
writer.Write()
