// SPDX-License-Identifier: BSD-3-Clause
// A picture of sRGB codes, and the functions that a sheet of pictures needs.
#ifndef skyline_Picture_h
#define skyline_Picture_h

#include <cstddef>
#include <string>
#include <vector>

namespace skyline
{
namespace gallery
{

/// Rows from bottom to top, three codes per pixel.
struct Picture
{
  int Width = 0, Height = 0;
  std::vector<unsigned char> Codes;

  Picture() = default;
  Picture(int width, int height, unsigned char code)
    : Width(width)
    , Height(height)
    , Codes(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), code)
  {
  }
  unsigned char* At(int x, int y)
  {
    return this->Codes.data() + 3 * (static_cast<std::ptrdiff_t>(y) * this->Width + x);
  }
  const unsigned char* At(int x, int y) const
  {
    return this->Codes.data() + 3 * (static_cast<std::ptrdiff_t>(y) * this->Width + x);
  }
};

/// Copies `part` into the picture, with its lower left corner at (x, y). Parts outside the picture
/// are omitted.
void Paste(Picture& picture, const Picture& part, int x, int y);

/// Writes a line of black text, with the lower left corner of its bounding box at (x, y). size:
/// pixels. Writes nothing if VTK has no fonts.
void WriteText(Picture& picture, const std::string& text, int x, int y, int size);

/// The width of the text in pixels.
int TextWidth(const std::string& text, int size);

/// A map of `values` (columns x rows, row by row from the south) with the given size: white at 0,
/// red at `full` and above, blue at -`full` and below. North is up. A pixel is the mean of the
/// values that it covers, or the nearest value if there are more pixels than values.
Picture DifferenceMap(
  const std::vector<float>& values, int columns, int rows, double full, int width, int height);

/// Returns false if the file cannot be written.
bool WritePng(const Picture& picture, const std::string& path);

} // namespace gallery
} // namespace skyline

#endif
