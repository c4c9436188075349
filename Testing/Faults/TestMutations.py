# SPDX-License-Identifier: BSD-3-Clause
"""Damaged files of six formats and their variants are read, or refused with a reason, in time, without a
crash and without a connection.

SKYLINE_TEST_FOUND: a folder in which the files that failed are kept.
"""
import collections
import os
import random
import shutil
import subprocess
import sys

from Faults import RUNS, SEED, sanitized
import Program
import ReadFiles
from Mutator import mutate
from Program import UTM10, gdal, hills, make

# Number of files that are on disk at a time.
BATCH = 250

RGBE_ROW = bytes([2, 2, 0, 16]) + bytes([0x90, 128]) * 2 + bytes([0x90, 64, 0x90, 129])

RAW_VRT = """<VRTDataset rasterXSize="9" rasterYSize="8">
  <SRS>EPSG:32610</SRS><GeoTransform>500000, 30, 0, 5100000, 0, -30</GeoTransform>
  <VRTRasterBand dataType="Int16" band="1" subClass="VRTRawRasterBand">
    <SourceFilename relativeToVRT="1">%s</SourceFilename>
    <ImageOffset>0</ImageOffset><PixelOffset>2</PixelOffset><LineOffset>18</LineOffset>
    <ByteOrder>LSB</ByteOrder><NoDataValue>-9999</NoDataValue>
  </VRTRasterBand>
</VRTDataset>
"""


class Seed:
    """A valid file: its format, the file that is damaged, and the files that belong beside it."""

    def __init__(self, format_, path, beside=()):
        self.format = format_
        self.kind = "light" if format_ == "light map" else "raster"
        self.path = path
        self.suffix = os.path.splitext(path)[1]
        with open(path, "rb") as file:
            self.content = file.read()
        self.beside = {}
        for other in beside:
            with open(other, "rb") as file:
                self.beside[os.path.splitext(other)[1]] = file.read()

    def put(self, folder, name, content):
        """Writes the content in place of the seed, and returns the file to read."""
        for suffix, other in self.beside.items():
            with open(os.path.join(folder, name + suffix), "wb") as file:
                file.write(other)
        path = os.path.join(folder, name + self.suffix)
        with open(path, "wb") as file:
            file.write(content)
        # The header is damaged, and the data file beside it is opened.
        return os.path.join(folder, name + ".img") if self.suffix == ".hdr" and self.beside else path


class Mutations(Program.ToolTest):
    def setUp(self):
        super().setUp()
        if not ReadFiles.PROGRAM:
            self.skipTest("SKYLINE_READ_FILES names no program")

    def copy(self, source, name, driver, *options):
        path = self.path(name)
        gdal.GetDriverByName(driver).CreateCopy(path, gdal.Open(source), options=list(options))
        return path

    def degrees(self, columns, rows, step):
        """Heights on regular posts of latitude and longitude, as DTED and SRTM tiles require."""
        path = make(self.path("degrees%d.tif" % columns), hills(rows, columns), step=(step, step),
                    corner=(-123.0 - step / 2, 46.0 - step / 2), epsg=4326, kind=gdal.GDT_Int16)
        return path

    def seeds(self):
        plain = make(self.path("plain.tif"), hills(8, 9), epsg=UTM10, nodata=-9999.0,
                     kind=gdal.GDT_Int16, unit="m")
        floats = make(self.path("floats.tif"), hills(40, 41), epsg=UTM10, kind=gdal.GDT_Float32)
        tiled = self.copy(floats, "tiled.tif", "GTiff", "TILED=YES", "BLOCKXSIZE=16",
                          "BLOCKYSIZE=16", "COMPRESS=DEFLATE", "PREDICTOR=3")
        packed = self.copy(floats, "packed.tif", "GTiff", "COMPRESS=LZW", "BIGTIFF=YES")
        cloud = self.copy(floats, "cloud.tif", "COG", "BLOCKSIZE=128", "COMPRESS=ZSTD")
        seeds = [Seed("GeoTIFF", path) for path in [plain, tiled, packed, cloud]]
        seeds += [Seed("AAIGrid", self.copy(path, "grid%d.asc" % k, "AAIGrid"))
                  for k, path in enumerate([plain, floats])]
        vrt = self.copy(plain, "source.vrt", "VRT")
        with open(self.path("raw.bin"), "wb") as file:
            file.write(bytes(range(144)))
        with open(self.path("raw.vrt"), "w") as file:
            file.write(RAW_VRT % "raw.bin")
        seeds += [Seed("VRT", vrt), Seed("VRT", self.path("raw.vrt"))]
        envi = self.copy(plain, "envi.img", "ENVI")
        seeds.append(Seed("ENVI and tiles", self.path("envi.hdr"), [envi]))
        if gdal.GetDriverByName("DTED"):
            seeds.append(Seed("ENVI and tiles", self.copy(
                self.degrees(121, 121, 1.0 / 120), "tile.dt0", "DTED")))
        if gdal.GetDriverByName("netCDF"):
            seeds += [Seed("netCDF", self.copy(plain, "classic.nc", "netCDF", "FORMAT=NC")),
                      Seed("netCDF", self.copy(plain, "hdf5.nc", "netCDF", "FORMAT=NC4"))]
        with open(self.path("sky.hdr"), "wb") as file:
            file.write(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=1\n\n-Y 8 +X 16\n" + 8 * RGBE_ROW)
        exr = self.path("sky.exr")
        subprocess.run([Program.PROGRAM, "shade", make(self.path("wide.tif"), hills(8, 16)),
                        "-o", exr, "--azimuths", "8"], check=True, capture_output=True)
        seeds += [Seed("light map", self.path("sky.hdr")), Seed("light map", exr)]
        return seeds

    def mutations(self, seeds, count):
        """(seed, number, content), with the formats in turn. The same number and SEED give the same
        content."""
        by_format = collections.defaultdict(list)
        for seed in seeds:
            by_format[seed.format].append(seed)
        formats = list(by_format)
        for number in range(count):
            rng = random.Random("%d %d" % (SEED, number))
            same = by_format[formats[number % len(formats)]]
            seed = rng.choice(same)
            yield seed, number, mutate(rng, seed.content, [other.content for other in same])

    def keep(self, path, number):
        folder = os.environ.get("SKYLINE_TEST_FOUND")
        if folder:
            os.makedirs(folder, exist_ok=True)
            base = os.path.splitext(path)[0]
            for name in os.listdir(os.path.dirname(path)):
                if name.startswith(os.path.basename(base) + "."):
                    shutil.copy(os.path.join(os.path.dirname(path), name), folder)

    def test_good_files_are_read(self):
        seeds = self.seeds()
        files = [(seed.kind, seed.put(self.folder, "good%d" % k, seed.content))
                 for k, seed in enumerate(seeds)]
        for seed, verdict in zip(seeds, ReadFiles.read_files(files)):
            with self.subTest(format=seed.format, file=os.path.basename(seed.path)):
                self.assertEqual(verdict.word, "read", verdict)

    def test_spoilt_files(self):
        seeds = self.seeds()
        log = self.path("connections")
        folder = self.path("spoilt")
        words, findings, slowest, largest = collections.Counter(), [], 0.0, 0.0
        left = list(self.mutations(seeds, RUNS))
        while left:
            os.mkdir(folder)
            # The sources of a VRT.
            for name in ["plain.tif", "raw.bin"]:
                shutil.copy(self.path(name), folder)
            batch, left = left[:BATCH], left[BATCH:]
            files = [(seed.kind, seed.put(folder, "spoilt%d" % number, content))
                     for seed, number, content in batch]
            for (seed, number, _), (_, path), verdict in zip(
                    batch, files, ReadFiles.read_files(files, log)):
                words[seed.format, verdict.word] += 1
                slowest = max(slowest, verdict.seconds)
                largest = max(largest, verdict.megabytes)
                large = verdict.word == "too large" and not sanitized(ReadFiles.PROGRAM)
                if verdict.word in ["wrong", "crashed"] or large:
                    findings.append("%s, seed %d, number %d, %s: %s" % (
                        seed.format, SEED, number, os.path.basename(path), verdict))
                    self.keep(path, number)
            shutil.rmtree(folder)
        print("\nMutations:", ", ".join("%s: %d %s" % (key[0], n, key[1]) for key, n in sorted(words.items())),
              "; slowest %.1f s, largest %.0f MB" % (slowest, largest))
        sys.stdout.flush()
        if os.path.exists(log):
            with open(log) as file:
                findings += ["a connection: " + line.strip() for line in file
                             if not line.startswith("open")]
        self.assertEqual(findings, [], "\n" + "\n".join(findings))


if __name__ == "__main__":
    Program.main()
