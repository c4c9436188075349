# SPDX-License-Identifier: BSD-3-Clause
"""The wrapped classes of shadow heights: a house in the shadow of a ridge."""
import unittest

import skyline
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData


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
        shadow = skyline.vtkShadowHeightMap()
        shadow.SetInputData(ridge())
        shadow.SetSunAzimuth(90.0)
        shadow.SetSunElevation(45.0)
        shadow.SoftOn()
        points = vtkPoints()
        for height in [5.0, 29.9, 30.1, 45.0]:  # 20 m behind the ridge: shadow to 30 m
            points.InsertNextPoint(80.0, 10.0, height)
        cloud = vtkPolyData()
        cloud.SetPoints(points)
        receiver = skyline.vtkShadowReceiver()
        receiver.SetInputData(cloud)
        receiver.SetShadowConnection(shadow.GetOutputPort())
        receiver.Update()
        lit = receiver.GetOutput().GetPointData().GetArray("SunVisibility")
        values = [lit.GetValue(k) for k in range(4)]
        self.assertEqual(values[0], 0.0)
        self.assertTrue(0.0 < values[1] < 0.5 < values[2] < 1.0, values)
        self.assertEqual(values[3], 1.0)

    def test_cap(self):
        cap = skyline.vtkHeightFieldCap()
        cap.SetInputData(ridge())
        cap.SetObjectsData(vtkPolyData())
        cap.Update()
        self.assertEqual(cap.GetOutput().GetPointData().GetScalars().GetRange(), (0.0, 50.0))


if __name__ == "__main__":
    unittest.main()
