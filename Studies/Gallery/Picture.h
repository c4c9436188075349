// SPDX-License-Identifier: BSD-3-Clause
// A picture of sRGB codes, and what a sheet of pictures needs.
#ifndef skyline_Picture_h
#define skyline_Picture_h

#include <cstddef>
#include <string>
#include <vector>

namespace skyline
{
namespace gallery
{

/// Rows from the bottom up, three codes a pixel.
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

/// Lays `part` with its lower left corner at (x, y); what would stick out is left off.
void Paste(Picture& picture, const Picture& part, int x, int y);

/// Writes a line of black text with the lower left corner of its letters' box at (x, y). `size` in
/// pixels; where VTK has no fonts, nothing is written.
void WriteText(Picture& picture, const std::string& text, int x, int y, int size);

/// Its width in pixels.
int TextWidth(const std::string& text, int size);

/// A map in the picture's size of `values` (columns x rows, row by row from the south), white at 0,
/// red at `full` and above, blue at -`full` and below; north is up. Pixels are means of what they
/// cover, or the nearest value where there are more of them.
Picture DifferenceMap(
  const std::vector<float>& values, int columns, int rows, double full, int width, int height);

/// False, where the file cannot be written.
bool WritePng(const Picture& picture, const std::string& path);

} // namespace gallery
} // namespace skyline

#endif
