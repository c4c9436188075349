// SPDX-License-Identifier: BSD-3-Clause
#include "WholeField.h"

#include "vtkExtentTranslator.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <array>
#include <stdexcept>
#include <string>

namespace skyline
{

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;
using Extent = std::array<int, 6>;

std::string Text(const Extent& extent)
{
  return "columns " + std::to_string(extent[0]) + " to " + std::to_string(extent[1]) + ", rows " +
    std::to_string(extent[2]) + " to " + std::to_string(extent[3]);
}

} // namespace

void RequestWhole(vtkInformation* input)
{
  if (input->Has(Pipeline::WHOLE_EXTENT()))
  {
    Extent whole{};
    input->Get(Pipeline::WHOLE_EXTENT(), whole.data());
    input->Set(Pipeline::UPDATE_EXTENT(), whole.data(), 6);
  }
  // A request for a piece would override the extent.
  input->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
  input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
  input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
}

void CheckWhole(vtkInformation* input)
{
  vtkImageData* image = vtkImageData::GetData(input);
  if (!image || !input->Has(Pipeline::WHOLE_EXTENT()))
  {
    return;
  }
  Extent whole{}, here{};
  input->Get(Pipeline::WHOLE_EXTENT(), whole.data());
  image->GetExtent(here.data());
  for (std::size_t k = 0; k < 4; k += 2)
  {
    if (here[k] > whole[k] || here[k + 1] < whole[k + 1])
    {
      throw std::invalid_argument("this process has only a part of the height field, " +
        Text(here) + " of " + Text(whole) +
        "; horizons need all of it; read it with vtkHeightFieldReader, or use one process");
    }
  }
}

bool IsFirstPiece(vtkInformation* output)
{
  return !output->Has(Pipeline::UPDATE_PIECE_NUMBER()) ||
    output->Get(Pipeline::UPDATE_PIECE_NUMBER()) == 0;
}

void KeepPiece(vtkInformation* output)
{
  vtkImageData* image = vtkImageData::GetData(output);
  const int pieces = output->Has(Pipeline::UPDATE_NUMBER_OF_PIECES())
    ? output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES())
    : 1;
  if (!image || pieces < 2 || image->GetNumberOfPoints() == 0)
  {
    return;
  }
  Extent whole{}, piece{};
  image->GetExtent(whole.data());
  vtkNew<vtkExtentTranslator> translator;
  const int some = translator->PieceToExtentThreadSafe(output->Get(Pipeline::UPDATE_PIECE_NUMBER()),
    pieces, output->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS()), whole.data(), piece.data(),
    vtkExtentTranslator::BLOCK_MODE, 0);
  if (some)
  {
    image->Crop(piece.data());
  }
  else
  {
    image->Initialize();
  }
}

} // namespace skyline
