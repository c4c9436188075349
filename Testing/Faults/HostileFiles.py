# SPDX-License-Identifier: BSD-3-Clause
"""Files and names that try to reach more than heights: network addresses, files in other folders, or the
memory of the whole machine. The function in each row of a table writes into a folder and returns the name
to open.

Beside the folder is `private/secret.bin`, which must not be read. `server` is an address that must not be
contacted; it need not exist.
"""
import os
import struct
import zlib

SERVER = "127.0.0.1:9"  # the discard port: no answer
URL = "http://" + SERVER + "/heights.tif"

REFUSED = "refused"  # exit 1 or 2, and no output
SAFE = "safe"        # refused, or the heights of the file without its hostile part

VRT = """<VRTDataset rasterXSize="%s" rasterYSize="%s">
  <SRS>EPSG:32610</SRS><GeoTransform>500000, 30, 0, 5100000, 0, -30</GeoTransform>
  %s
</VRTDataset>
"""
SIMPLE = """<VRTRasterBand dataType="Float32" band="1"><SimpleSource>
    <SourceFilename relativeToVRT="%d">%s</SourceFilename><SourceBand>1</SourceBand>
    <SrcRect xOff="0" yOff="0" xSize="16" ySize="16"/><DstRect xOff="0" yOff="0" xSize="16" ySize="16"/>
  </SimpleSource></VRTRasterBand>"""
RAW = """<VRTRasterBand dataType="Byte" band="1" subClass="VRTRawRasterBand">
    <SourceFilename relativeToVRT="%d">%s</SourceFilename>
    <ImageOffset>0</ImageOffset><PixelOffset>1</PixelOffset><LineOffset>16</LineOffset>
  </VRTRasterBand>"""
PYTHON = """<VRTRasterBand dataType="Float32" band="1" subClass="VRTDerivedRasterBand">
    <PixelFunctionLanguage>Python</PixelFunctionLanguage><PixelFunctionType>run</PixelFunctionType>
    <PixelFunctionCode><![CDATA[
def run(in_ar, out_ar, *args, **kwargs):
    open("%s", "w").write("was here")
    out_ar[:] = 1
]]></PixelFunctionCode></VRTRasterBand>"""

WMS = """<GDAL_WMS><Service name="TMS"><ServerUrl>http://%s/${z}/${x}/${y}.png</ServerUrl></Service>
  <DataWindow><UpperLeftX>-20037508</UpperLeftX><UpperLeftY>20037508</UpperLeftY>
  <LowerRightX>20037508</LowerRightX><LowerRightY>-20037508</LowerRightY><TileLevel>2</TileLevel>
  <TileCountX>1</TileCountX><TileCountY>1</TileCountY><YOrigin>top</YOrigin></DataWindow>
  <Projection>EPSG:3857</Projection><BlockSizeX>16</BlockSizeX><BlockSizeY>16</BlockSizeY>
  <BandsCount>1</BandsCount><Cache/></GDAL_WMS>""" % SERVER
WMS_SERVICE = """<GDAL_WMS><Service name="WMS"><Version>1.1.1</Version><ServerUrl>http://%s/?</ServerUrl>
  <SRS>EPSG:4326</SRS><Layers>heights</Layers></Service><DataWindow><UpperLeftX>-180</UpperLeftX>
  <UpperLeftY>90</UpperLeftY><LowerRightX>180</LowerRightX><LowerRightY>-90</LowerRightY><SizeX>16</SizeX>
  <SizeY>16</SizeY></DataWindow><BandsCount>1</BandsCount></GDAL_WMS>""" % SERVER
WCS = """<WCS_GDAL><ServiceURL>http://%s/?</ServiceURL><CoverageName>heights</CoverageName>
  </WCS_GDAL>""" % SERVER
WMTS = """<GDAL_WMTS><GetCapabilitiesUrl>http://%s/wmts.xml</GetCapabilitiesUrl><Layer>heights</Layer>
  </GDAL_WMTS>""" % SERVER
PLMOSAIC = """<PLMosaicDataset><BaseURL>http://%s/</BaseURL></PLMosaicDataset>""" % SERVER
MRF = """<MRF_META><CachedSource><Source>/vsicurl/%s</Source></CachedSource>
  <Raster><Size x="16" y="16" c="1"/><PageSize x="16" y="16" c="1"/><Compression>NONE</Compression>
  <DataType>Float32</DataType></Raster></MRF_META>""" % URL
STACTA = """{"type":"Feature","stac_version":"1.0.0","stac_extensions":
  ["https://stac-extensions.github.io/tiled-assets/v1.0.0/schema.json"],"id":"x","geometry":null,
  "properties":{"tiles:tile_matrix_sets":{"a":{"url":"http://%s/tms.json"}},
  "tiles:tile_matrix_links":{"a":{"url":"http://%s/tms.json"}}},
  "asset_templates":{"h":{"href":"http://%s/{TileMatrix}/{TileRow}/{TileCol}.tif"}}}
  """ % (SERVER, SERVER, SERVER)
STAC = """{"type":"FeatureCollection","stac_version":"1.0.0","features":[{"type":"Feature",
  "stac_version":"1.0.0","id":"x","geometry":null,"properties":{"proj:epsg":32610},"assets":{"h":{
  "href":"%s","proj:shape":[16,16],"proj:transform":[30,0,500000,0,-30,5100000]}}}]}""" % URL
RPF_INDEX = """<?xml version="1.0"?><Dimap_Document><Metadata_Id><METADATA_FORMAT version="1.1">DIMAP
  </METADATA_FORMAT></Metadata_Id><Raster_Dimensions><NROWS>16</NROWS><NCOLS>16</NCOLS><NBANDS>1</NBANDS>
  </Raster_Dimensions><Data_Access><Data_File><DATA_FILE_PATH href="/vsicurl/%s"/></Data_File>
  </Data_Access></Dimap_Document>""" % URL
SIDE_FILE = """<PAMDataset><SRS>%s</SRS><PAMRasterBand band="1"><Description>x</Description>
  </PAMRasterBand></PAMDataset>"""


def put(folder, name, content):
    path = os.path.join(folder, name)
    with open(path, "wb") as file:
        file.write(content if isinstance(content, bytes) else content.encode())
    return path


def secret(folder):
    return os.path.join(os.path.dirname(folder), "private", "secret.bin")


def text(name, content):
    """Writes a file with this name, whose content is the text."""
    return lambda folder: put(folder, name, content)


def beside(suffix, content):
    """The valid raster heights.tif with another file beside it."""
    def write(folder):
        put(folder, "heights.tif" + suffix, content)
        return os.path.join(folder, "heights.tif")
    return write


def vrt(band, columns=16, rows=16, name="hostile.vrt"):
    return text(name, VRT % (columns, rows, band))


def names(name):
    return lambda folder: name


def of_secret(band):
    return lambda folder: put(folder, "hostile.vrt", VRT % (16, 16, band % (0, secret(folder))))


def relative_secret(folder):
    return put(folder, "hostile.vrt", VRT % (16, 16, RAW % (1, "../private/secret.bin")))


def linked_secret(folder):
    """A symbolic link in the folder, as an archive can contain one."""
    os.symlink(secret(folder), os.path.join(folder, "data.bin"))
    return put(folder, "hostile.vrt", VRT % (16, 16, RAW % (1, "data.bin")))


def cycle(folder):
    put(folder, "one.vrt", VRT % (16, 16, SIMPLE % (1, "two.vrt")))
    return put(folder, "two.vrt", VRT % (16, 16, SIMPLE % (1, "one.vrt")))


def chain(folder):
    """A VRT of a VRT of a VRT, whose last source is on the network."""
    source = "/vsicurl/" + URL
    for k in range(20):
        source = os.path.basename(put(folder, "link%d.vrt" % k, VRT % (
            16, 16, SIMPLE % (0 if k == 0 else 1, source))))
    return os.path.join(folder, source)


def python_function(folder):
    return put(folder, "hostile.vrt", VRT % (16, 16, PYTHON % os.path.join(folder, "was-here")))


def deep(folder):
    depth = 100000
    return put(folder, "hostile.vrt",
               '<VRTDataset rasterXSize="1" rasterYSize="1">' + depth * "<a>" + depth * "</a>" +
               "</VRTDataset>")


def pipe(folder):
    """A pipe without a writer."""
    path = os.path.join(folder, "hostile.tif")
    os.mkfifo(path)
    return path


def pipe_in_vrt(folder):
    os.mkfifo(os.path.join(folder, "data.bin"))
    return put(folder, "hostile.vrt", VRT % (16, 16, RAW % (1, "data.bin")))


def huge_tiff(folder):
    """A GeoTIFF of 200 bytes that claims 100000 x 100000 floats, all of them omitted."""
    tags = [(256, 4, 1, 100000), (257, 4, 1, 100000), (258, 3, 1, 32), (259, 3, 1, 1), (262, 3, 1, 1),
            (273, 4, 1, 0), (277, 3, 1, 1), (278, 4, 1, 100000), (279, 4, 1, 0), (339, 3, 1, 3)]
    directory = struct.pack("<H", len(tags)) + b"".join(
        struct.pack("<HHII", *tag) for tag in tags) + struct.pack("<I", 0)
    return put(folder, "hostile.tif", b"II*\0" + struct.pack("<I", 8) + directory)


def huge_exr(folder):
    """An EXR of two kB that claims 20000 x 10000 pixels."""
    def attribute(name, kind, value):
        return name + b"\0" + kind + b"\0" + struct.pack("<I", len(value)) + value
    box = struct.pack("<4i", 0, 0, 19999, 9999)
    channels = b"".join(name + b"\0" + struct.pack("<iBxxxii", 2, 0, 1, 1) for name in [b"B", b"G", b"R"])
    header = (attribute(b"channels", b"chlist", channels + b"\0") +
              attribute(b"compression", b"compression", b"\0") +
              attribute(b"dataWindow", b"box2i", box) + attribute(b"displayWindow", b"box2i", box) +
              attribute(b"lineOrder", b"lineOrder", b"\0") +
              attribute(b"pixelAspectRatio", b"float", struct.pack("<f", 1.0)) +
              attribute(b"screenWindowCenter", b"v2f", struct.pack("<2f", 0.0, 0.0)) +
              attribute(b"screenWindowWidth", b"float", struct.pack("<f", 1.0)) + b"\0")
    put(folder, "hostile.exr", b"\x76\x2f\x31\x01" + struct.pack("<I", 2) + header + bytes(1024))
    return os.path.join(folder, "hostile.exr")


def huge_hdr(folder):
    return put(folder, "hostile.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 10000 +X 20000\n")


def bomb(folder):
    """A compressed raw file that expands a thousand times."""
    packer = zlib.compressobj(9, zlib.DEFLATED, 31)
    data = packer.compress(bytes(1 << 26)) + packer.flush()
    put(folder, "data.bin.gz", data)
    return put(folder, "hostile.vrt", VRT % (1 << 16, 1 << 16, RAW % (1, "/vsigzip/data.bin.gz")))


# A description, the allowed outcome, and the function that makes the file.
RASTERS = [
    ("TMS in a .tif", REFUSED, text("hostile.tif", WMS)),
    ("WMS in a .tif", REFUSED, text("hostile.tif", WMS_SERVICE)),
    ("WCS in a .tif", REFUSED, text("hostile.tif", WCS)),
    ("WMTS in a .tif", REFUSED, text("hostile.tif", WMTS)),
    ("Planet mosaic in a .tif", REFUSED, text("hostile.tif", PLMOSAIC)),
    ("cached MRF in a .tif", REFUSED, text("hostile.tif", MRF)),
    ("tiled STAC in a .json", REFUSED, text("hostile.json", STACTA)),
    ("STAC in a .json", REFUSED, text("hostile.json", STAC)),
    ("DIMAP over the network", REFUSED, text("hostile.xml", RPF_INDEX)),
    ("VRT over the network", REFUSED, vrt(SIMPLE % (0, "/vsicurl/" + URL))),
    ("VRT over the network in a .tif", REFUSED, vrt(SIMPLE % (0, "/vsicurl/" + URL), name="hostile.tif")),
    ("VRT over S3", REFUSED, vrt(SIMPLE % (0, "/vsis3/bucket/heights.tif"))),
    ("VRT over a URL", REFUSED, vrt(SIMPLE % (0, URL))),
    ("VRT over an archive on the network", REFUSED,
     vrt(SIMPLE % (0, "/vsizip//vsicurl/http://%s/a.zip/heights.tif" % SERVER))),
    ("VRT over WMS text", REFUSED,
     vrt(SIMPLE % (0, WMS.replace("<", "&lt;").replace(">", "&gt;")))),
    ("VRT over a database", REFUSED, vrt(SIMPLE % (0, "PG:host=127.0.0.1 port=9 dbname=x table=y"))),
    ("raw band over the network", REFUSED, vrt(RAW % (0, "/vsicurl/" + URL))),
    ("raw band of a file elsewhere", REFUSED, of_secret(RAW)),
    ("raw band of a file elsewhere, relative", REFUSED, relative_secret),
    ("raw band of a link elsewhere", REFUSED, linked_secret),
    ("raw band of /etc/passwd", REFUSED, vrt(RAW % (0, "/etc/passwd"))),
    ("raw band of /dev/zero", REFUSED, vrt(RAW % (0, "/dev/zero"))),
    ("raw band of a pipe", REFUSED, pipe_in_vrt),
    ("cycle of VRTs", REFUSED, cycle),
    ("chain of VRTs to the network", REFUSED, chain),
    ("pixel function in Python", REFUSED, python_function),
    ("nested 100000 deep", REFUSED, deep),
    ("2e9 x 1e9 posts", REFUSED, vrt(SIMPLE % (1, "heights.tif"), 2000000000, 1000000000)),
    ("2^31 columns", REFUSED, vrt(SIMPLE % (1, "heights.tif"), 2147483648, 2)),
    ("sizes below 0", REFUSED, vrt(SIMPLE % (1, "heights.tif"), -5, -5)),
    ("100000 x 100000 posts in 200 bytes", REFUSED, huge_tiff),
    ("gzip that grows a thousand times", REFUSED, bomb),
    ("pipe that nobody writes", REFUSED, pipe),
    ("mask over the network", SAFE, beside(".msk", VRT % (16, 16, SIMPLE % (0, "/vsicurl/" + URL)))),
    ("mask of WMS", SAFE, beside(".msk", WMS)),
    ("overviews over the network", SAFE, beside(".ovr", WMS)),
    ("side file with a grid on the network", SAFE,
     beside(".aux.xml", SIDE_FILE % ("+proj=utm +zone=10 +nadgrids=http://%s/x.tif" % SERVER))),
    ("side file with overviews on the network", SAFE,
     beside(".aux.xml", '<PAMDataset><Metadata domain="OVERVIEWS"><MDI key="OVERVIEW_FILE">/vsicurl/' +
            URL + "</MDI></Metadata></PAMDataset>")),
    ("side file with a mask on the network", SAFE,
     beside(".aux.xml", '<PAMDataset><Metadata domain="MASK"><MDI key="MASK_FILE">/vsicurl/' +
            URL + "</MDI></Metadata></PAMDataset>")),
]

# Names instead of files, as a list or a form may contain them.
NAMES = [
    URL,
    "/vsicurl/" + URL,
    "/vsicurl_streaming/" + URL,
    "/vsis3/bucket/heights.tif",
    "/vsiaz/bucket/heights.tif",
    "/vsigs/bucket/heights.tif",
    "/vsiswift/bucket/heights.tif",
    "/vsiwebhdfs/http://" + SERVER + "/heights.tif",
    "/vsizip//vsicurl/http://" + SERVER + "/a.zip/heights.tif",
    "/vsisubfile/0_100,/vsicurl/" + URL,
    "/vsicached?file=/vsicurl/" + URL,
    "vrt:///vsicurl/" + URL,
    "WMS:http://%s/?SERVICE=WMS&LAYERS=x&SRS=EPSG:4326&BBOX=0,0,1,1" % SERVER,
    "WCS:http://%s/" % SERVER,
    "WMTS:http://%s/wmts.xml" % SERVER,
    "PG:host=127.0.0.1 port=9 dbname=x table=y",
    "EEDAI:image",
    "PLMOSAIC:mosaic=x,api_key=y",
    "DAAS:http://%s/x" % SERVER,
    "OGCAPI:http://%s/" % SERVER,
    'ZARR:"/vsicurl/http://%s/x.zarr"' % SERVER,
    'NETCDF:"/vsicurl/%s":z' % URL,
    'HDF5:"/vsicurl/%s"://z' % URL,
    "GTIFF_DIR:1:/vsicurl/" + URL,
    'STACIT:"http://%s/x.json"' % SERVER,
    "STACTA:http://%s/x.json" % SERVER,
    "DERIVED_SUBDATASET:LOGAMPLITUDE:/vsicurl/" + URL,
    WMS,
    VRT % (16, 16, SIMPLE % (0, "/vsicurl/" + URL)),
]

LIGHTS = [
    ("EXR of 20000 x 10000 pixels in two kB", REFUSED, huge_exr),
    ("HDR of 20000 x 10000 pixels in 60 bytes", REFUSED, huge_hdr),
    ("light map that is WMS", REFUSED, text("hostile.exr", WMS)),
    ("light map that is a pipe", REFUSED, lambda folder: os.rename(
        pipe(folder), os.path.join(folder, "hostile.exr")) or os.path.join(folder, "hostile.exr")),
    ("light map by a URL", REFUSED, names("http://%s/sky.exr" % SERVER)),
]

# Cases that are not yet refused, with the reason. They are skipped, so that they stay visible.
UNMENDED = {
    "gzip that grows a thousand times": "each row beyond its end unpacks all of it again",
}
