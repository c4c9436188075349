# SPDX-License-Identifier: BSD-3-Clause
"""Files and names that refer to other places: no connection or outside access without an option.

Run as `python3 TestUntrusted.py`.

All connections would go to a listener on 127.0.0.1, which counts them. All local secrets are rasters that
GDAL can open, so that a hostile file that is not stopped gives a result. The tests can fail: with the
options that allow it, the reader does connect, and does read them.
"""
import os
import shutil
import socket
import sys
import tempfile
import threading
import unittest
import warnings
import zipfile

import numpy as np
import skyline

try:
    from osgeo import gdal
except ImportError as missing:
    print("skipped:", missing, "(install python3-gdal)")
    sys.exit(77)

gdal.UseExceptions()

SIZE = 12  # posts per side


class Listener:
    """Counts connections, and answers none."""

    def __init__(self):
        self.server = socket.create_server(("127.0.0.1", 0))
        self.port = self.server.getsockname()[1]
        self.count = 0
        threading.Thread(target=self.serve, daemon=True).start()

    def serve(self):
        while True:
            try:
                connection, _ = self.server.accept()
            except OSError:
                return
            self.count += 1
            connection.close()


def vrt(source, before="", band="", kind="Float64"):
    return (f"<VRTDataset rasterXSize='{SIZE}' rasterYSize='{SIZE}'>{before}"
            f"<GeoTransform>500000,30,0,5100000,0,-30</GeoTransform>"
            f"<VRTRasterBand dataType='{kind}' band='1' {band}>{source}</VRTRasterBand></VRTDataset>")


def source(name, kind="SimpleSource", relative=0):
    name = name.replace("&", "&amp;").replace("<", "&lt;")
    return (f"<{kind}><SourceFilename relativeToVRT='{relative}'>{name}</SourceFilename>"
            f"<SourceBand>1</SourceBand></{kind}>")


def raw(name, before=""):
    return vrt(f"<SourceFilename relativeToVRT='0'>{name}</SourceFilename><ImageOffset>0</ImageOffset>"
               f"<PixelOffset>1</PixelOffset><LineOffset>{SIZE}</LineOffset>", before,
               "subClass='VRTRawRasterBand'", "Byte")


def servers(port):
    """Names of a raster on a server, in all forms that GDAL supports."""
    url = f"http://127.0.0.1:{port}"
    return {
        "http": f"{url}/dem.tif",
        "curl": f"/vsicurl/{url}/dem.tif",
        "curl with options": f"/vsicurl?url={url}/dem.tif",
        "curl streaming": f"/vsicurl_streaming/{url}/dem.tif",
        "s3": "/vsis3/bucket/dem.tif",
        "s3 streaming": "/vsis3_streaming/bucket/dem.tif",
        "gs": "/vsigs/bucket/dem.tif",
        "gs streaming": "/vsigs_streaming/bucket/dem.tif",
        "azure": "/vsiaz/bucket/dem.tif",
        "azure streaming": "/vsiaz_streaming/bucket/dem.tif",
        "azure lake": "/vsiadls/bucket/dem.tif",
        "oss": "/vsioss/bucket/dem.tif",
        "swift": "/vsiswift/bucket/dem.tif",
        "webhdfs": f"/vsiwebhdfs/{url}/webhdfs/v1/dem.tif",
        "zip": f"/vsizip//vsicurl/{url}/a.zip/dem.tif",
        "tar": f"/vsitar//vsicurl/{url}/a.tar/dem.tif",
        "gzip": f"/vsigzip//vsicurl/{url}/dem.tif.gz",
        "subfile": f"/vsisubfile/0_1000,/vsicurl/{url}/dem.tif",
        "vrt name": f"vrt:///vsicurl/{url}/dem.tif?bands=1",
        "derived": f"DERIVED_SUBDATASET:AMPLITUDE:/vsicurl/{url}/dem.tif",
        "tiff directory": f"GTIFF_DIR:1:/vsicurl/{url}/dem.tif",
        "netcdf by dap": f'NETCDF:"{url}/dem.nc":z',
        "netcdf by dap, bare": f"{url}/dem.nc#mode=dap",
        "netcdf by curl": f'NETCDF:"/vsicurl/{url}/dem.nc":z',
        "hdf5": f'HDF5:"/vsicurl/{url}/dem.h5"://z',
        "zarr": f'ZARR:"/vsicurl/{url}/dem.zarr"',
        "wmts": f"WMTS:{url}/wmts",
        "wcs": f"WCS:{url}/wcs?coverage=dem",
        "wms": f"WMS:{url}/wms?LAYERS=dem&SRS=EPSG:4326&BBOX=0,0,1,1",
        "postgres": f"PG:host=127.0.0.1 port={port} dbname=d table=t connect_timeout=2",
        "ogc api": f"OGCAPI:{url}/",
        "stacta": f'STACTA:"{url}/x.json"',
        "stacit": f'STACIT:"{url}/x.json"',
        "earth engine": "EEDAI:dem",
        "planet": "PLMosaic:mosaic=x,api_key=y",
        "nextgis": f"NGW:{url}/resource/1",
    }


def services(port):
    """Texts that describe rasters on a server."""
    url = f"http://127.0.0.1:{port}"
    return {
        "wms": f"<GDAL_WMS><Service name='TMS'><ServerUrl>{url}/${{z}}/${{x}}/${{y}}.png</ServerUrl>"
               f"</Service><DataWindow><UpperLeftX>0</UpperLeftX><UpperLeftY>360</UpperLeftY>"
               f"<LowerRightX>360</LowerRightX><LowerRightY>0</LowerRightY><SizeX>{SIZE}</SizeX>"
               f"<SizeY>{SIZE}</SizeY></DataWindow><BlockSizeX>{SIZE}</BlockSizeX>"
               f"<BlockSizeY>{SIZE}</BlockSizeY><BandsCount>1</BandsCount></GDAL_WMS>",
        "wcs": f"<WCS_GDAL><ServiceURL>{url}/wcs?</ServiceURL><Version>1.0.0</Version>"
               f"<CoverageName>dem</CoverageName></WCS_GDAL>",
        "wmts": f"<GDAL_WMTS><GetCapabilitiesUrl>{url}/c.xml</GetCapabilitiesUrl></GDAL_WMTS>",
        "mrf": f"<MRF_META><CachedSource><Source>/vsicurl/{url}/x.tif</Source></CachedSource>"
               f"<Raster><Size x='{SIZE}' y='{SIZE}'/></Raster></MRF_META>",
    }


class Untrusted(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="skyline-untrusted-")
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        before = os.getcwd()
        os.chdir(self.folder)
        self.addCleanup(os.chdir, before)
        self.listener = Listener()
        self.addCleanup(self.listener.server.close)
        self.mine = self.path("mine")
        os.mkdir(self.mine)
        self.secret = self.path("secret.tif")
        y, x = np.mgrid[0:SIZE, 0:SIZE]
        skyline.write(self.secret, 100.0 + 3.0 * x + 7.0 * y, crs="EPSG:32610",
                      transform=(500000.0, 30.0, 0.0, 5100000.0, 0.0, -30.0))
        shutil.copy(self.secret, self.inside("good.tif"))
        self.give_credentials()

    def give_credentials(self):
        """Each attempt to connect reaches the listener."""
        place = f"127.0.0.1:{self.listener.port}"
        given = {
            "AWS_S3_ENDPOINT": place, "AWS_HTTPS": "NO", "AWS_VIRTUAL_HOSTING": "FALSE",
            "AWS_NO_SIGN_REQUEST": "YES", "GS_NO_SIGN_REQUEST": "YES",
            "CPL_GS_ENDPOINT": f"http://{place}/", "AZURE_NO_SIGN_REQUEST": "YES",
            "AZURE_STORAGE_ACCOUNT": "a", "CPL_AZURE_ENDPOINT": f"http://{place}",
            "AZURE_STORAGE_SAS_TOKEN": "t", "OSS_ENDPOINT": place, "OSS_HTTPS": "NO",
            "OSS_ACCESS_KEY_ID": "k", "OSS_SECRET_ACCESS_KEY": "s", "SWIFT_AUTH_TOKEN": "t",
            "SWIFT_STORAGE_URL": f"http://{place}/s", "EEDA_BEARER": "t",
            "EEDA_URL": f"http://{place}/", "PL_URL": f"http://{place}/"}
        for name, value in given.items():
            gdal.SetConfigOption(name, value)
            self.addCleanup(gdal.SetConfigOption, name, None)

    def path(self, name):
        return os.path.join(self.folder, name)

    def inside(self, name):
        return os.path.join(self.mine, name)

    def write(self, name, text):
        with open(self.inside(name), "w") as file:
            file.write(text)
        return self.inside(name)

    def stopped(self, name, says="", **options):
        """The reader must refuse in one line and must not connect."""
        with self.assertRaises(skyline.Error) as refusal:
            skyline.read(name, **options)
        self.assertEqual(self.listener.count, 0, "a connection was opened")
        line = str(refusal.exception)
        self.assertNotIn("\n", line)
        self.assertIn(says, line)
        return line

    def passes(self, name, **options):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            image = skyline.read(name, **options)
        self.assertEqual(image.GetDimensions()[:2], (SIZE, SIZE))
        self.assertEqual(self.listener.count, 0, "a connection was opened")

    def connects(self, name, **options):
        """The listener runs and can be reached."""
        before = self.listener.count
        try:
            skyline.read(name, **options)
        except skyline.Error:
            pass  # there is no answer
        self.assertGreater(self.listener.count, before, name)

    def test_names_of_servers(self):
        for kind, name in servers(self.listener.port).items():
            with self.subTest(kind=kind):
                self.stopped(name)
        self.assertIn("allow_network=True", self.stopped(servers(self.listener.port)["http"]))
        self.assertIn("allow_network=True", self.stopped(servers(self.listener.port)["s3"]))

    def test_virtual_rasters_over_servers(self):
        for kind, name in servers(self.listener.port).items():
            with self.subTest(kind=kind):
                self.stopped(self.write("dem.tif", vrt(source(name))))

    def test_other_references_of_virtual_rasters(self):
        url = f"/vsicurl/http://127.0.0.1:{self.listener.port}/dem.tif"
        for away, option in ((url, "allow_network=True"), (self.secret, "allow_elsewhere=True")):
            good = source(self.inside("good.tif"))
            texts = {
                "complex source": vrt(source(away, "ComplexSource")),
                "averaged source": vrt(source(away, "AveragedSource")),
                "filtered source": vrt(source(away, "KernelFilteredSource")),
                "raw band": raw(away),
                "raw band, relative": raw(away).replace("relativeToVRT='0'", "relativeToVRT='1'"),
                "mask": vrt(good, "<MaskBand><VRTRasterBand dataType='Byte'>" + source(away) +
                            "</VRTRasterBand></MaskBand>"),
                "warped": f"<VRTDataset rasterXSize='{SIZE}' rasterYSize='{SIZE}' "
                          "subClass='VRTWarpedDataset'><VRTRasterBand dataType='Float64' band='1' "
                          "subClass='VRTWarpedRasterBand'/><GDALWarpOptions><SourceDataset "
                          f"relativeToVRT='0'>{away}</SourceDataset><BandList><BandMapping src='1' "
                          "dst='1'/></BandList></GDALWarpOptions></VRTDataset>",
                "pansharpened": "<VRTDataset subClass='VRTPansharpenedDataset'><PansharpeningOptions>"
                                f"<PanchroBand><SourceFilename>{away}</SourceFilename></PanchroBand>"
                                f"<SpectralBand dstBand='1'><SourceFilename>{away}</SourceFilename>"
                                "</SpectralBand></PansharpeningOptions></VRTDataset>",
                "pixel function": vrt(source(away) + "<PixelFunctionType>sqrt</PixelFunctionType>",
                                      band="subClass='VRTDerivedRasterBand'"),
                "vrt in a name": vrt(source(vrt(source(away)))),
                "vrt name": vrt(source(f"vrt://{away}?bands=1")),
                "sparse": vrt(source("/vsisparse/" + self.write(
                    "sparse.xml", "<VSISparseFile><Length>9000</Length><SubfileRegion><Filename>"
                    f"{away}</Filename><DestinationOffset>0</DestinationOffset><SourceOffset>0"
                    "</SourceOffset><RegionLength>9000</RegionLength></SubfileRegion>"
                    "</VSISparseFile>"))),
            }
            for kind, text in texts.items():
                # GDAL may remember sources that failed, and not try them again.
                text = text.replace("/dem.tif", f"/{kind.replace(' ', '-')}.tif")
                with self.subTest(kind=kind, away=away):
                    line = self.stopped(self.write("dem.tif", text))
                    if kind != "pansharpened":  # for which GDAL reports the error itself
                        self.assertIn(option, line)

    def test_services(self):
        for kind, text in services(self.listener.port).items():
            with self.subTest(kind=kind):
                line = self.stopped(self.write("dem.tif", text))
                self.assertIn(f"drivers=['{kind.upper()}']", line)
                self.write("service.xml", text)
                self.stopped(self.write("dem.vrt", vrt(source("service.xml", relative=1))))

    def test_crs_of_a_server(self):
        url = f"http://127.0.0.1:{self.listener.port}/crs"
        good = source(self.inside("good.tif"))
        for text in (url, "urn:ogc:def:crs:EPSG::999999", self.secret, "/etc/hostname"):
            with self.subTest(text=text):
                self.stopped(self.write("dem.vrt", vrt(good, f"<SRS>{text}</SRS>")))

    def test_side_files(self):
        hostile = dict(services(self.listener.port))
        flags = "<Metadata><MDI key='INTERNAL_MASK_FLAGS_1'>2</MDI></Metadata>"
        hostile["vrt"] = vrt(source(self.secret), flags, kind="Byte")
        hostile["raw"] = raw("/etc/passwd")
        for kind, text in hostile.items():
            with self.subTest(kind=kind):
                self.write("good.tif.msk", text)
                self.stopped(self.inside("good.tif"))
        os.remove(self.inside("good.tif.msk"))
        away = f"/vsicurl/http://127.0.0.1:{self.listener.port}/x.tif"
        for name in (away, self.secret):
            self.write("good.tif.aux.xml", "<PAMDataset><Metadata domain='OVERVIEWS'><MDI "
                       f"key='OVERVIEW_FILE'>{name}</MDI></Metadata><Metadata domain='Mask'><MDI "
                       f"key='MASK_FILE'>{name}</MDI></Metadata></PAMDataset>")
            try:
                skyline.read(self.inside("good.tif"))  # GDAL may not need it
            except skyline.Error as refusal:
                self.assertIn("allow_", str(refusal))
            self.assertEqual(self.listener.count, 0)

    def test_files_elsewhere(self):
        os.symlink(self.secret, self.inside("link.tif"))
        with zipfile.ZipFile(self.path("outside.zip"), "w") as archive:
            archive.write(self.secret, "secret.tif")
        gdal.Translate(self.path("outside.nc"), self.secret, format="netCDF")
        gdal.Translate(self.path("outside.asc"), self.secret, format="AAIGrid")
        names = {
            "absolute": self.secret,
            "upwards": "../secret.tif",
            "upwards and down": "../mine/../secret.tif",
            "link": "link.tif",
            "zip": f"/vsizip/{self.path('outside.zip')}/secret.tif",
            "subfile": f"/vsisubfile/0_9000,{self.secret}",
            "grid": self.path("outside.asc"),
            "directory of a tiff": f"GTIFF_DIR:1:{self.secret}",
            "netcdf": f'NETCDF:"{self.path("outside.nc")}":Band1',
            "netcdf, bare": f'NETCDF:{self.path("outside.nc")}:Band1',
            "hdf5": f'HDF5:"{self.path("outside.nc")}"://Band1',
            "derived": f"DERIVED_SUBDATASET:AMPLITUDE:{self.secret}",
            "written": f"/vsiskyline{self.secret}",
            "standard input": "/vsistdin/",
        }
        for kind, name in names.items():
            for text in (vrt(source(name, relative=1)), vrt(source(name))):
                if kind.startswith("upwards") or kind == "link":
                    text = vrt(source(name, relative=1))
                with self.subTest(kind=kind):
                    self.stopped(self.write("dem.vrt", text), says="allow_elsewhere=True")
        for name in ("/etc/passwd", "/proc/self/environ", "/proc/self/maps", "/dev/zero"):
            with self.subTest(name=name):
                device = name.startswith("/dev/")
                self.stopped(self.write("dem.tif", raw(name)),
                             says="a pipe or a device" if device else "allow_elsewhere=True")
                self.stopped(self.write("dem.tif", vrt(source(name))))

    def test_detached_headers(self):
        """Formats whose header names the file with the heights."""
        size = f"{SIZE}"
        headers = {
            "dem.lbl": "PDS_VERSION_ID = PDS3\r\nRECORD_TYPE = FIXED_LENGTH\r\nRECORD_BYTES = 12\r\n"
                       f"FILE_RECORDS = 12\r\n^IMAGE = \"{self.secret}\"\r\nOBJECT = IMAGE\r\n"
                       f" LINES = {size}\r\n LINE_SAMPLES = {size}\r\n SAMPLE_TYPE = UNSIGNED_INTEGER"
                       "\r\n SAMPLE_BITS = 8\r\nEND_OBJECT = IMAGE\r\nEND\r\n",
            "dem.ers": f"DatasetHeader Begin\n Version = \"6.0\"\n DataFile = \"{self.secret}\"\n"
                       " DataSetType = ERStorage\n DataType = Raster\n ByteOrder = LSBFirst\n"
                       " RasterInfo Begin\n  CellType = Unsigned8BitInteger\n"
                       f"  NrOfLines = {size}\n  NrOfCellsPerLine = {size}\n  NrOfBands = 1\n"
                       " RasterInfo End\nDatasetHeader End\n",
        }
        for name, text in headers.items():
            with self.subTest(name=name):
                self.stopped(self.write(name, text))

    def test_what_is_asked_for(self):
        """Shows that the tests above can fail."""
        url = f"/vsicurl/http://127.0.0.1:{self.listener.port}/dem.tif"
        self.connects(url, allow_network=True)
        self.connects(f"http://127.0.0.1:{self.listener.port}/dem.tif", allow_network=True)
        self.connects(self.write("dem.vrt", vrt(source(url + "f"))), allow_network=True)
        service = self.write("service.xml", services(self.listener.port)["wms"])
        self.connects(service, drivers=["WMS"], allow_network=True)
        self.listener.count = 0
        self.stopped(service, "WMS", allow_network=True)
        self.stopped(service, "allow_network=True", drivers=["WMS"])
        self.stopped(self.secret, "NoSuch", drivers=["NoSuch"])
        self.passes(self.write("far.vrt", vrt(source(self.secret))), allow_elsewhere=True)
        for wrong in ("WMS", [3], [""]):
            with self.assertRaises(TypeError):
                skyline.read(self.secret, drivers=wrong)

    def test_only_while_reading(self):
        """Other code that uses GDAL in the same process can open any file."""
        hostile = self.write("dem.vrt", vrt(source(self.secret)))
        self.stopped(hostile)
        self.assertEqual(gdal.Open(hostile).ReadAsArray().shape, (SIZE, SIZE))
        self.stopped(hostile)

    def test_a_server_that_never_answers(self):
        server = socket.create_server(("127.0.0.1", 0))
        self.addCleanup(server.close)
        gdal.SetConfigOption("GDAL_HTTP_LOW_SPEED_TIME", "2")
        self.addCleanup(gdal.SetConfigOption, "GDAL_HTTP_LOW_SPEED_TIME", None)
        with self.assertRaises(skyline.Error):
            skyline.read(f"/vsicurl/http://127.0.0.1:{server.getsockname()[1]}/dem.tif",
                         allow_network=True)

    def test_files_that_belong_together(self):
        """None of these needs an option."""
        os.mkdir(self.inside("tiles"))
        shutil.copy(self.secret, self.inside("tiles/tile.tif"))
        self.passes(self.write("a.vrt", vrt(source("good.tif", relative=1))))
        self.passes(self.write("b.vrt", vrt(source("tiles/tile.tif", relative=1))))
        self.passes(self.write("c.vrt", vrt(source(self.inside("tiles/tile.tif")))))
        self.passes(self.write("d.vrt", vrt(source("c.vrt", relative=1))))
        os.symlink(self.inside("a.vrt"), self.path("link.vrt"))
        self.passes(self.path("link.vrt"))
        self.passes("mine/a.vrt")
        self.passes(f"vrt://{self.secret}?bands=1")
        self.passes(f"GTIFF_DIR:1:{self.secret}")
        self.passes(vrt(source(self.secret)))  # named by the user with its full path
        with zipfile.ZipFile(self.inside("a.zip"), "w") as archive:
            archive.write(self.inside("a.vrt"), "a.vrt")
            archive.write(self.secret, "good.tif")
        self.passes(f"/vsizip/{self.inside('a.zip')}/a.vrt")
        self.passes("/vsizip/mine/a.zip/good.tif")
        gdal.Translate(self.inside("a.nc"), self.secret, format="netCDF")
        self.passes(self.inside("a.nc"))
        self.passes(f'NETCDF:"{self.inside("a.nc")}":Band1')
        for kind, ending in (("AAIGrid", "asc"), ("ENVI", "bin"), ("EHdr", "flt"), ("HFA", "img"),
                             ("SAGA", "sdat"), ("XYZ", "xyz"), ("GSBG", "grd"), ("BT", "bt")):
            with self.subTest(kind=kind):
                path = self.inside("kind." + ending)
                small = gdal.Translate("", self.secret, format="MEM", outputType=(
                    gdal.GDT_Int16 if kind == "BT" else gdal.GDT_Float32))
                try:
                    gdal.Translate(path, small, format=kind)
                except RuntimeError:
                    continue  # this GDAL cannot write it
                self.passes(path)
        raster = gdal.Open(self.inside("good.tif"))
        with_mask = gdal.Translate(self.inside("mask.tif"), raster)
        with_mask.CreateMaskBand(gdal.GMF_PER_DATASET)
        with_mask.GetRasterBand(1).GetMaskBand().WriteArray(np.full((SIZE, SIZE), 255, np.uint8))
        with_mask = None
        self.assertTrue(os.path.exists(self.inside("mask.tif.msk")))
        self.passes(self.inside("mask.tif"))


if __name__ == "__main__":
    unittest.main()
