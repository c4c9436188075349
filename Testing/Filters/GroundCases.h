// SPDX-License-Identifier: BSD-3-Clause
// Rasters on many maps, far from the places where these maps are true to scale, for the tests of
// distances and azimuths.
#ifndef skyline_GroundCases_h
#define skyline_GroundCases_h

#include <string>
#include <vector>

namespace skyline
{

struct GroundCase
{
  const char* Name;
  std::string Crs;
  double Longitude, Latitude; ///< of the raster's centre, degrees on the CRS's own ellipsoid
};

inline std::string RotatedPole(const std::string& ellipsoid)
{
  return R"wkt(GEOGCRS["Rotated_pole",BASEGEOGCRS["base",DATUM["d",ELLIPSOID[)wkt" + ellipsoid +
    R"wkt(,LENGTHUNIT["metre",1]]],PRIMEM["Greenwich",0,ANGLEUNIT["degree",0.0174532925199433]]],
DERIVINGCONVERSION["Pole rotation (netCDF CF convention)",METHOD["Pole rotation (netCDF CF convention)"],
PARAMETER["Grid north pole latitude (netCDF CF convention)",39.25,ANGLEUNIT["degree",0.0174532925199433]],
PARAMETER["Grid north pole longitude (netCDF CF convention)",198,ANGLEUNIT["degree",0.0174532925199433]],
PARAMETER["North pole grid longitude (netCDF CF convention)",0,ANGLEUNIT["degree",0.0174532925199433]]],
CS[ellipsoidal,2],AXIS["latitude",north,ORDER[1],ANGLEUNIT["degree",0.0174532925199433]],
AXIS["longitude",east,ORDER[2],ANGLEUNIT["degree",0.0174532925199433]]])wkt";
}

inline std::vector<GroundCase> GroundCases()
{
  const std::string sphere = RotatedPole(R"("Sphere",6371229,0)");
  const std::string wgs = RotatedPole(R"("WGS 84",6378137,298.257223563)");
  const std::string mars = " +a=3396190 +b=3376200 +units=m +no_defs +type=crs";
  const std::string marsSphere = " +R=3396190 +units=m +no_defs +type=crs";
  const std::string moon = " +R=1737400 +units=m +no_defs +type=crs";
  return {
    { "longitude, latitude: Norway", "EPSG:4326", 10, 62 },
    { "longitude, latitude: equator", "EPSG:4326", 30, 0.2 },
    { "longitude, latitude: 80 degrees north", "EPSG:4326", 20, 80 },
    { "longitude, latitude across the antimeridian", "EPSG:4326", 179.9, -17 },
    { "longitude, latitude: Moon", "+proj=longlat +R=1737400 +no_defs +type=crs", 20, 60 },
    { "rotated pole, sphere: Lapland", sphere, 25, 68 },
    { "rotated pole, sphere: Sahara", sphere, -5, 26 },
    { "rotated pole, WGS 84: Caucasus", wgs, 45, 42 },
    { "UTM in its zone", "EPSG:32632", 11, 47 },
    { "UTM, 10 degrees beyond its zone", "EPSG:32632", 22, 47 },
    { "LAEA Europe: Canaries", "EPSG:3035", -16.5, 28.3 },
    { "LAEA Europe: Azores", "EPSG:3035", -28, 38.5 },
    { "LAEA Europe: Cyprus", "EPSG:3035", 33, 35 },
    { "sinusoidal (MODIS): Alaska", "+proj=sinu +R=6371007.181 +units=m +type=crs", -150, 63 },
    { "sinusoidal (MODIS): Patagonia", "+proj=sinu +R=6371007.181 +units=m +type=crs", -71, -48 },
    { "sinusoidal, Mars", "+proj=sinu +lon_0=0" + marsSphere, 137, 40 },
    { "polar stereographic (70 N): Iceland", "EPSG:3413", -19, 65 },
    { "polar stereographic, UPS: 62 N", "EPSG:5041", 100, 62 },
    { "polar stereographic, Antarctica: rim", "EPSG:3031", -58, -63 },
    { "polar stereographic, Moon: 75 S", "+proj=stere +lat_0=-90 +lon_0=0" + moon, 40, -75 },
    { "polar stereographic, Mars: 60 N", "+proj=stere +lat_0=90 +lon_0=0" + mars, 250, 60 },
    { "Krovak, axes east and north", "EPSG:5514", 13, 49.8 },
    { "Krovak, axes south and west", "EPSG:5513", 13, 49.8 },
    { "Albers, United States: California", "EPSG:5070", -122, 37 },
    { "Albers, United States: Florida", "EPSG:5070", -81, 26 },
    { "Lambert conformal, Europe: Cyprus", "EPSG:3034", 33, 35 },
    { "oblique Mercator: Malaysia", "EPSG:3375", 101, 5 },
    { "oblique Mercator: Switzerland, 900 km away", "EPSG:2056", 17, 44 },
    { "web Mercator: 65 N", "EPSG:3857", 25, 65 },
    { "plate carree, Mars: 40 N", "+proj=eqc +lat_ts=0" + mars, 137, 40 },
    { "Robinson: Alaska", "ESRI:54030", -150, 63 },
    { "Mollweide: Chile", "ESRI:54009", -71, -30 },
    { "Goode homolosine: South Africa", "+proj=igh +datum=WGS84 +units=m +type=crs", 25, -30 },
    { "transverse Mercator, axes west and south", "EPSG:2048", 19.5, -33 },
    { "state plane in US feet: 700 km away", "EPSG:2263", -82, 40 },
    { "equal area cylindrical (EASE)", "EPSG:6933", 10, 55 },
    { "equidistant conic, United States", "ESRI:102005", -122, 47 },
    { "azimuthal equidistant: 3000 km away",
      "+proj=aeqd +lat_0=45 +lon_0=10 +datum=WGS84 +type=crs", 40, 30 },
    { "gnomonic: 1500 km away", "+proj=gnom +lat_0=45 +lon_0=10 +datum=WGS84 +type=crs", 25, 38 },
    { "Cassini-Soldner: 8 degrees away", "+proj=cass +lat_0=45 +lon_0=10 +datum=WGS84 +type=crs",
      18, 48 },
    { "American polyconic: Brazil", "EPSG:5880", -70, -9 },
    { "New Zealand map grid", "EPSG:27200", 168, -45 },
  };
}

} // namespace skyline

#endif
