# SPDX-License-Identifier: BSD-3-Clause
"""The wrapped classes for shadow heights: a house in the shadow of a ridge."""
import unittest

import skyline
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer


def ridge():
    image = vtkImageData()
    image.SetDimensions(101, 21, 1)
    image.SetSpacing(1.0, 1.0, 1.0)
    heights = vtkDoubleArray()
    heights.SetName("Elevation")
    for _ in range(21):
        for column in range(101):
            heights.InsertNextValue(50.0 if column == 100 else 0.0)
    image.GetPointData().SetScalars(heights)
    return image


class Wrapped(unittest.TestCase):
    def test_receiver(self):
        shadow = skyline.vtkHeightFieldShadowHeight()
        shadow.SetInputData(ridge())
        shadow.SetSunAzimuth(90.0)
        shadow.SetSunElevation(45.0)
        shadow.SoftOn()
        points = vtkPoints()
        for height in [5.0, 29.9, 30.1, 45.0]:  # 20 m behind the ridge the shadow reaches up to 30 m
            points.InsertNextPoint(80.0, 10.0, height)
        cloud = vtkPolyData()
        cloud.SetPoints(points)
        receiver = skyline.vtkHeightFieldShadowReceiver()
        receiver.SetInputData(cloud)
        receiver.SetShadowConnection(shadow.GetOutputPort())
        receiver.Update()
        lit = receiver.GetOutput().GetPointData().GetArray("SunVisibility")
        values = [lit.GetValue(k) for k in range(4)]
        self.assertEqual(values[0], 0.0)
        self.assertTrue(0.0 < values[1] < 0.5 < values[2] < 1.0, values)
        self.assertEqual(values[3], 1.0)

    def test_mapper(self):
        """A roof at 20 m, read from pixels: dark near the ridge, lit beyond 30 m from it."""
        if not skyline.vtkSkylineEGLWindow.IsSupported():
            self.skipTest("no OpenGL context")
        shadow = skyline.vtkHeightFieldShadowHeight()
        shadow.SetInputData(ridge())
        shadow.SetSunAzimuth(90.0)
        shadow.SetSunElevation(45.0)
        shadow.SoftOn()
        points = vtkPoints()
        for x, y in [(0, 0), (100, 0), (100, 20), (0, 20)]:
            points.InsertNextPoint(x, y, 20.0)
        faces = vtkCellArray()
        faces.InsertNextCell(4)
        for corner in range(4):
            faces.InsertCellPoint(corner)
        roof = vtkPolyData()
        roof.SetPoints(points)
        roof.SetPolys(faces)
        mapper = skyline.vtkSkylineSoftShadowPolyDataMapper()
        mapper.SetInputData(roof)
        shader = mapper.GetShader()
        shader.SetMode(skyline.vtkSkylineSoftShadowShader.RECEIVER)
        shader.SetHeightFieldConnection(shadow.GetOutputPort())
        shader.SetSunIrradiance(3.0, 3.0, 3.0)
        shader.SetUniformLight(0.1, 0.1, 0.1)
        actor = vtkActor()
        actor.SetMapper(mapper)
        renderer = vtkRenderer()
        renderer.AddActor(actor)
        camera = renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetFocalPoint(50.0, 10.0, 0.0)
        camera.SetPosition(50.0, 10.0, 500.0)
        camera.SetParallelScale(10.0)
        window = skyline.vtkSkylineEGLWindow()
        window.SetSize(100, 20)
        window.AddRenderer(renderer)
        renderer.ResetCameraClippingRange()
        window.Render()
        codes = vtkUnsignedCharArray()
        window.GetPixelData(0, 10, 99, 10, 0, codes, 0)
        line = [codes.GetValue(3 * column) for column in range(100)]
        self.assertGreater(line[60], 2 * line[80])
        self.assertEqual(line[75:95], [line[80]] * 20)
        self.assertEqual(line[5:65], [line[60]] * 60)

    def test_cap(self):
        cap = skyline.vtkHeightFieldCap()
        cap.SetInputData(ridge())
        cap.SetObjectsData(vtkPolyData())
        cap.Update()
        self.assertEqual(cap.GetOutput().GetPointData().GetScalars().GetRange(), (0.0, 50.0))


if __name__ == "__main__":
    unittest.main()
