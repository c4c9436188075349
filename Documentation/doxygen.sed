# SPDX-License-Identifier: BSD-3-Clause
# What every class of VTK has, said once for Doxygen.
s|^  static vtk[A-Za-z0-9]*\* New();$|&  ///< Creates an object with the default settings.|
s|^  void PrintSelf(ostream& os, vtkIndent indent) override;$|& ///< Prints the settings.|
