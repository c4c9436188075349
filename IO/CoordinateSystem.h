// SPDX-License-Identifier: BSD-3-Clause
// What a coordinate reference system says about metres, directions and the body under the posts.
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

/// A CRS as the reader needs it. Every message names `file`.
class CoordinateSystem
{
public:
  /// Metres without a place: a raster with no CRS.
  CoordinateSystem() = default;

  /// Takes the horizontal part of a CRS: geographic, projected, or local with a unit of length.
  /// Throws IoFailure for any other kind, for a unit that is not known, and for longitudes that
  /// grow to the west.
  CoordinateSystem(const OGRSpatialReference& crs, const std::string& file);

  bool IsGeographic() const { return this->Geographic; }

  /// What its steps are: degrees of longitude and latitude only if it is not derived from another
  /// geographic CRS (rotated pole).
  StepUnit GetStepUnit() const
  {
    return !this->Geographic ? StepUnit::Metres
      : this->Derived        ? StepUnit::DerivedDegrees
                             : StepUnit::Degrees;
  }

  /// Metres in one unit of x and y; degrees in one where the CRS is geographic.
  double GetUnit() const { return this->Unit; }

  /// True for a CRS that counts lengths on a map; false where it is geographic, or there is none.
  bool IsOnMap() const { return !this->Wkt.empty() && !this->Geographic; }

  /// Metres in one unit of height by the CRS's vertical axis, of a compound CRS or one of three
  /// dimensions; 0 where it has none.
  double GetVerticalUnit() const { return this->VerticalUnit; }

  /// True where the vertical axis counts downwards.
  bool CountsDepths() const { return this->Depths; }

  /// True where x grows to the west and y to the south (South African maps).
  bool PointsSouthWest() const { return this->SouthWest; }

  /// Fills CRS, body and lattice of a georeference that has its geotransform and post counts. A CRS
  /// without a body only gives its name. Throws IoFailure where posts have no place on the body.
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
  std::string Wkt; ///< of the whole CRS, vertical part included
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
