// SPDX-License-Identifier: BSD-3-Clause
// The units, directions and body that a coordinate reference system (CRS) gives to the posts.
#ifndef skyline_CoordinateSystem_h
#define skyline_CoordinateSystem_h

#include "Geo/Georeference.h"
#include "Geo/RowSpacing.h"

#include <ogr_spatialref.h>

#include <string>
#include <vector>

class OGRCoordinateTransformation;

namespace skyline
{

/// A CRS with what the reader needs to know about it. Every message names the file.
class CoordinateSystem
{
public:
  /// No CRS: x and y are metres on no particular body.
  CoordinateSystem() = default;

  /// Uses the horizontal part of a CRS that is geographic, projected, or local with a unit of
  /// length. Throws IoFailure for any other type of CRS, for an unknown unit, and for longitudes
  /// that increase to the west.
  CoordinateSystem(const OGRSpatialReference& crs, const std::string& file);

  bool IsGeographic() const { return this->Geographic; }

  /// The unit of a step in x or y. A geographic CRS that is derived from another one (a rotated
  /// pole) has degrees that are not longitude and latitude.
  StepUnit GetStepUnit() const
  {
    return !this->Geographic ? StepUnit::Metres
      : this->Derived        ? StepUnit::DerivedDegrees
                             : StepUnit::Degrees;
  }

  /// The size of one unit of x and y, in metres, or in degrees if the CRS is geographic.
  double GetUnit() const { return this->Unit; }

  /// True if x and y are lengths on a map; false if the CRS is geographic or there is none.
  bool IsOnMap() const { return !this->Wkt.empty() && !this->Geographic; }

  /// The size of one unit of height in metres, from the vertical axis of a compound or
  /// three-dimensional CRS; 0 if the CRS has no vertical axis.
  double GetVerticalUnit() const { return this->VerticalUnit; }

  /// True if the vertical axis counts downwards.
  bool CountsDepths() const { return this->Depths; }

  /// True if x increases to the west and y to the south (maps of South Africa).
  bool PointsSouthWest() const { return this->SouthWest; }

  /// Fills in the CRS, the body and the lattice of a georeference that already has its geotransform
  /// and numbers of posts. For a CRS without a body, only the CRS is filled in. Throws IoFailure if
  /// posts have no longitude and latitude.
  void Place(Georeference& georeference) const;

private:
  void ReadAxes();
  void ReadUnits(const OGRSpatialReference& whole);
  void FillLattice(Georeference& georeference) const;
  void FillNodes(
    Georeference& georeference, int nodes, OGRCoordinateTransformation& toDegrees) const;
  bool IsFine(const Georeference& georeference, OGRCoordinateTransformation& toDegrees) const;
  void ToDegrees(const Georeference& georeference, OGRCoordinateTransformation& toDegrees,
    std::vector<double>& columns, std::vector<double>& rows) const;

  std::string File;
  std::string Wkt; ///< of the whole CRS, including its vertical part
  OGRSpatialReference Horizontal;
  bool Geographic = false;
  bool Derived = false;
  bool OnBody = false;
  bool SouthWest = false;
  double Unit = 1.0;
  double VerticalUnit = 0.0;
  bool Depths = false;
};

} // namespace skyline

#endif
