# SPDX-License-Identifier: BSD-3-Clause
"""`import skyline` provides all classes of the three wrapped modules, and they work in a pipeline."""

import unittest

import skyline
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

CLASSES = [
    "vtkHeightFieldReader", "vtkHeightFieldFileWriter", "vtkHeightFieldWriter",
    "vtkHeightFieldPictureWriter",
    "vtkHeightFieldAlgorithm", "vtkHeightFieldHorizon", "vtkHeightFieldSkyView",
    "vtkHeightFieldSunShadow", "vtkHeightFieldShading", "vtkHeightFieldSkyLight",
    "vtkHeightFieldSurface", "vtkSkylineEGLWindow", "vtkSkylineSoftShadowPolyDataMapper",
    "vtkSkylineSoftShadowShader", "vtkHeightFieldVisibility", "vtkHeightFieldTransfer",
    "vtkHeightFieldInspection", "vtkHeightFieldIrradiance", "vtkSkylineLight", "vtkSkylineEnvironmentLight",
    "vtkSkylineKeyLight", "vtkSkylineLampLight", "vtkSkylineSunLight", "vtkSkylineLightMapReader",
    "vtkHeightFieldShadowHeight", "vtkHeightFieldShadowReceiver", "vtkHeightFieldCap",
    "vtkOpenGLHeightFieldDevice", "vtkOpenGLHeightFieldHorizon",
    "vtkOpenGLHeightFieldVisibility", "vtkOpenGLHeightFieldTransfer",
    "vtkOpenGLHeightFieldIrradiance", "vtkOpenGLHeightFieldShadowHeight",
]


class TestImportSkyline(unittest.TestCase):
    def test_classes(self):
        for name in CLASSES:
            self.assertTrue(hasattr(skyline, name), name)

    def test_old_names_of_classes(self):
        with self.assertWarnsRegex(DeprecationWarning, "was renamed to vtkSkylineLightMapReader"):
            self.assertIs(skyline.vtkLightMapReader, skyline.vtkSkylineLightMapReader)
        with self.assertRaisesRegex(AttributeError, "no attribute 'vtkMoon'"):
            skyline.vtkMoon  # noqa: B018

    def test_flat_field_has_a_level_horizon(self):
        image = vtkImageData()
        image.SetDimensions(5, 4, 1)
        image.AllocateScalars(10, 1)  # VTK_FLOAT
        heights = vtk_to_numpy(image.GetPointData().GetScalars())
        heights[:] = 100.0

        horizon = skyline.vtkHeightFieldHorizon()
        horizon.SetNumberOfAzimuths(4)
        horizon.SetInputData(image)
        horizon.Update()
        result = horizon.GetOutput().GetPointData().GetArray("HorizonElevation")
        degrees = vtk_to_numpy(result).reshape(4, 5, 4)
        # Row 0 is the southern edge: there is no terrain south of it, and level ground in the other
        # directions.
        self.assertEqual(list(degrees[0, 2]), [0.0, 0.0, -90.0, 0.0])
        self.assertEqual(list(degrees[2, 2]), [0.0, 0.0, 0.0, 0.0])


if __name__ == "__main__":
    unittest.main()
