# SPDX-License-Identifier: BSD-3-Clause
"""Each option of each command has an effect or is refused or warned of; each wrong value is refused.

The tables have a line for each option. An option in ACTS must change the output. One in IDLE must be refused
where it has no effect. One in WARNS is accepted, with a warning, where only the data make it useless. The
test takes the options from the help, so that a new option needs a line.
"""
import os
import re

import Program
from Program import UTM10, ToolTest, hills, make, np

TIME = "2026-06-21T14:00Z"  # the sun is low at the DEM
SUN = ["--sun", "200,12"]
FEW = ["--azimuths", "8"]
WIDE = ["--sun-radius", "9"]  # a disc of which many posts see a part
MAP = "MAP"    # a light map
LAMP = "LAMP"  # a lamp above the DEM

ROWS, COLUMNS = 110, 120

# Options that do not change the result: the amount of messages, and the use of the machine.
NEUTRAL = {"--help", "--quiet", "--verbose", "--threads",
           "--nodata", "--driver", "--allow-network", "--allow-elsewhere"}  # these have their own tests

WRITERS = {"horizon": ["out.tif", *FEW], "sky-view": ["out.tif", *FEW], "sun": ["out.tif", *SUN],
           "shadow-height": ["out.tif", *SUN], "irradiance": ["out.tif", *FEW],
           "shade": ["out.tif", *FEW]}

# command: option and value, and the further options with which it has an effect. "-": the command
# without -o.
ACTS = {
    "horizon": [
        (["--band", "2"],), (["--cloud-optimized"],), (["--azimuths", "9"],), (["--method", "sweep"],),
        (["--method", "pyramid"],), (["--surface", "bilinear"],),
        (["--surface", "bilinear"], "--method", "fast"), (["--flat"],), (["--refraction", "0.5"],),
        (["--tolerance", "5"],)],
    "sky-view": [
        (["--band", "2"],), (["--cloud-optimized"],), (["--azimuths", "9"],), (["--method", "sweep"],),
        (["--surface", "bilinear"],), (["--flat"],), (["--refraction", "-3"],), (["--tolerance", "5"],),
        (["--quantity", "SkyViewFactor"],),
        (["--edge-distance", "500"], "--quantity", "EdgeTrust")],
    "sun": [
        (["--band", "2"],), (["--cloud-optimized"],), (["--method", "sweep"],),
        (["--surface", "bilinear"], *WIDE), (["--flat"], *WIDE), (["--refraction", "0.9"], *WIDE),
        (["--tolerance", "5"], *WIDE), (["--sun-radius", "9"],), (["--limb-darkening"], *WIDE),
        (["--time", TIME], "-"), (["--sun", "10,20"], "-"), (["--sun-radius", "2"], "-"),
        (["--band", "2"], "-")],
    "shadow-height": [
        (["--band", "2"],), (["--cloud-optimized"],), (["--method", "sweep"],), (["--flat"],),
        (["--refraction", "0.9"],), (["--soft"],), (["--sun-radius", "2"], "--soft"),
        (["--time", TIME],), (["--sun", "10,20"],)],
    "irradiance": [
        (["--band", "2"],), (["--cloud-optimized"],), (["--azimuths", "9"],), (["--horizon", "sweep"],),
        (["--surface", "bilinear"],), (["--flat"],), (["--refraction", "-3"],), (["--tolerance", "5"],),
        (["--environment", MAP],), (["--environment", "cie:1"],), (["--environment", "cie:12"], *SUN),
        (["--environment", "perez:500,100"], *SUN), (["--rotation", "90"], "--environment", MAP),
        (["--rotation", "90"], "--environment", "cie:12", *SUN, "--sun-irradiance", "0"),
        (["--time", TIME],), (SUN,), (["--sun-irradiance", "2"], *SUN),
        (["--sun-irradiance", "2"], "--environment", "perez:500,100", *SUN),
        (["--sun-radius", "2"], *SUN), (["--limb-darkening"], *SUN, "--sun-radius", "3"), (["--lamp", LAMP],),
        (["--method", "sh"],), (["--horizontal"],), (["--quadrature", "linear"],),
        (["--no-refinement"], "--environment", MAP),
        (["--bands", "6"], "--method", "sh", "--environment", "cie:12", *SUN),
        (["--azimuths", "9"], *SUN, "--sun-radius", "10"), (["--azimuths", "9"], "--method", "sh"),
        (["--surface", "bilinear"], "--lamp", LAMP)],
    "shade": [
        (["--band", "2"],), (["--cloud-optimized"],), (["--azimuths", "16"],), (["--method", "pyramid"],),
        (["--surface", "bilinear"],), (["--flat"],), (["--refraction", "-90"],),
        (["--tolerance", "20"],), (["--time", TIME],), (SUN,), (["--sun-radius", "20"],),
        (["--limb-darkening"], "--sun-radius", "20"), (["--environment", "none"],),
        (["--environment", "cie:1"],), (["--environment", MAP],), (["--rotation", "90"], "--environment", MAP),
        (["--sun-irradiance", "5"],), (["--sun-irradiance", "0"],),
        (["--sun-irradiance", "5"], "--environment", "cie:1"),
        (["--sun-irradiance", "5"], "--environment", "cie:12"),
        (["--sun-irradiance", "5"], "--environment", "none", "--exposure", "0"),
        (["--sun-irradiance", "5"], "--environment", MAP, *SUN), (["--lamp", LAMP],),
        (["--colors", "ocean"],), (["--exposure", "1"],), (["--exaggeration", "2"],)],
}

# Options of a perspective view, which needs OpenGL: they have no line in ACTS.
ELSEWHERE = {"shade": {"--view", "--from", "--size"}}

# command, further options, the option that has no effect with them, and a part of the message.
IDLE = [
    *[(command, [method, "sweep"], ["--tolerance", "1"], "exact")
      for command, method in [("horizon", "--method"), ("sky-view", "--method"), ("sun", "--method"),
                              ("irradiance", "--horizon"), ("shade", "--method")]],
    ("horizon", ["--method", "fast"], ["--tolerance", "1"], "exact"),
    ("horizon", ["--method", "sweep"], ["--surface", "bilinear"], "sweep"),
    ("horizon", ["--method", "pyramid"], ["--surface", "bilinear"], "pyramid"),
    *[(command, ["--flat"], ["--refraction", "0.2"], "--flat") for command in WRITERS],
    ("sun", [], ["--limb-darkening", "--sun-radius", "0"], "point"),
    ("sun", ["--sun", "1,2"], ["--time", TIME], "--sun"),
    *[("sun", ["-"], option, "without -o")
      for option in (["--method", "exact"], ["--surface", "bilinear"], ["--flat"],
                     ["--refraction", "0.2"], ["--tolerance", "1"], ["--cloud-optimized"],
                     ["--limb-darkening"])],
    ("shadow-height", [], ["--sun-radius", "1"], "--soft"),
    ("irradiance", ["--lamp", LAMP], ["--method", "sh"], ""),
    *[("irradiance", ["--method", "sh", *SUN], option, "")
      for option in (["--quadrature", "linear"], ["--no-refinement"], ["--limb-darkening"])],
    ("irradiance", [], ["--bands", "6"], "method sh"),
    ("sky-view", [], ["--edge-distance", "500"], "EdgeTrust"),
    *[(command, ["--environment", MAP], option, "no sun shines")
      for command in ("irradiance", "shade")
      for option in (["--sun-irradiance", "2"], ["--sun-radius", "1"], ["--limb-darkening"])],
    ("irradiance", [], ["--sun-irradiance", "2"], "no sun shines"),
    ("irradiance", [*SUN, "--sun-radius", "5"], ["--limb-darkening"], "key light"),
    ("irradiance", [*SUN, "--sun-radius", "0"], ["--limb-darkening"], "point"),
    ("shade", ["--environment", "none"], ["--azimuths", "9"], "black sky"),
    ("shade", [], ["--size", "90x90"], "--view perspective"),
    ("shade", [], ["--from", "1,2"], "--view perspective"),
    *[("shade", ["-o", "out." + kind], ["--cloud-optimized"], "GeoTIFF") for kind in ("png", "exr")],
    ("shade", ["-o", "out.exr"], ["--exposure", "1"], "before exposure"),
    *[(command, [], ["--environment", "perez:500,100"], "perez") for command in ("irradiance", "shade")],
]

# The same where the result is right without the option: a warning.
WARNED = [
    *[("irradiance", SUN, [option, *value], "azimuths")
      for option, value in (("--azimuths", ["9"]), ("--quadrature", ["blend"]), ("--no-refinement", []))],
    *[("irradiance", ["--lamp", LAMP], option, "")
      for option in (["--azimuths", "9"], ["--horizon", "fast"], ["--tolerance", "1"],
                     ["--quadrature", "blend"])],
    ("irradiance", [], ["--no-refinement"], "bright all around"),
    ("irradiance", ["--method", "sh"], ["--bands", "6"], "first band"),
    ("shadow-height", ["--sun-radius", "0"], ["--soft"], "middle"),
    *[(command, ["--environment", sky], ["--rotation", "90"], "same all around")
      for command in ("irradiance", "shade") for sky in ("uniform", "cie:5", "cie:16")],
    ("shade", ["--environment", "none"], ["--rotation", "90"], "same all around"),
]

# Values that no numeric option of any command accepts. test_messages has the other types.
NO_NUMBERS = ["", "0x1"]

# option: the commands that have it, and further values out of range.
NUMBERS = {
    "--azimuths": ("horizon", ["0", "-1", "3601", "99999999999", "1.5", "1,5"]),
    "--band": ("horizon", ["0", "-1", "99999999999", "1.5"]),
    "--threads": ("horizon", ["-1", "4097", "99999999999"]),
    "--refraction": ("horizon", ["1", "2", "-1e30", "0,13"]),
    "--tolerance": ("horizon", ["-0.1", "90.1", "-1", "0,5"]),
    "--sun-radius": ("sun", ["-1", "-0.5", "90", "91", "0,5"]),
    "--sun": ("sun", ["1", "1,2,3", "0,90.001", "0,-91", "nan,45", "0,", ",0", "1;2", "1e999,2"]),
    "--time": ("sun", ["noon", "2026-13-01T00:00Z", "2026-02-30T00:00Z", "2026-06-21T25:00Z",
                       "2026-06-21 06:00 please", "06:00", "1850-06-21T06:00Z", "2500-06-21T06:00Z",
                       "0001-01-01T00:00Z", "2026-06-21T06:00+24:00"]),
    "--bands": ("irradiance", ["1", "9", "-1"]),
    "--rotation": ("irradiance", ["90deg", "1,5"]),
    "--edge-distance": ("sky-view", ["-1", "1e10", "5m"]),
    "--sun-irradiance": ("irradiance", ["-1", "1,2", "1,2,3,4", "1,-1,1"]),
    "--lamp": ("irradiance", ["1,2,3", "1,2,3,0", "1,2,3,4,5", "1,2,3,-1", "1,2,3,4,5,6,-7",
                              "1,2,3,nan", "1,2,,4"]),
    "--exaggeration": ("shade", ["0", "-1", "1001"]),
    "--exposure": ("shade", ["Auto", "1001"]),
    "--size": ("shade", ["0x5", "5x9000", "-1x4", "5", "5x", "5x5x5", "1.5x2", "0x10x10"]),
    "--from": ("shade", ["1", "1,91", "1,-1", "1,2,3"]),
    "--budget": ("benchmark", ["-1", "1e7"]),
    "--sizes": ("benchmark", ["31", "4097", "64,x", "64.5"]),
}

NAMES = {
    "--method": ("horizon", ["", "exat", "EXACT"], "exact"),
    "--surface": ("horizon", ["", "triangle"], "triangles"),
    "--quantity": ("sky-view", ["", "SkyviewFactor"], "SkyViewFactor"),
    "--environment": ("irradiance", ["", "unifrom"], "uniform"),
    "--quadrature": ("irradiance", ["", "blendd"], "blend"),
    "--horizon": ("irradiance", ["", "fst"], "fast"),
    "--colors": ("shade", ["", "viridid"], "viridis"),
    "--view": ("shade", ["", "perspectiv"], "perspective"),
    "--scenes": ("benchmark", ["hils"], "hills"),
    "--methods": ("benchmark", ["exat"], "exact"),
    "--quantities": ("benchmark", ["horizn"], "horizon"),
}


class Options(ToolTest):
    def setUp(self):
        super().setUp()
        # Posts far apart, so that curvature has an effect, with hills of a few hundred metres.
        heights = hills(ROWS, COLUMNS, relief=4000.0)
        self.dem = make(self.path("dem.tif"), heights, step=(400.0, 400.0), epsg=UTM10)
        raster = Program.gdal.Open(self.dem)
        two = Program.gdal.GetDriverByName("GTiff").Create(
            self.path("two.tif"), COLUMNS, ROWS, 2, Program.gdal.GDT_Float64)
        two.SetGeoTransform(raster.GetGeoTransform())
        two.SetProjection(raster.GetProjection())
        two.GetRasterBand(1).WriteArray(heights[::-1])
        two.GetRasterBand(2).WriteArray(0.5 * heights)
        raster = two = None
        os.replace(self.path("two.tif"), self.dem)
        self.words = {MAP: os.path.join(Program.DATA, "light-maps", "sunset_128.hdr"),
                      LAMP: "503600,5103200,9000,1000"}

    def arguments(self, command, further, option):
        """The words of a command. Its defaults are replaced if `further` or `option` contain them."""
        words = [self.words.get(word, word) for word in further if word != "-"]
        option = [self.words.get(word, word) for word in option]
        if "-" in further:
            return [command, self.dem, *words, *option]
        if command == "benchmark":
            return [command, "-o", "report", *words, *option]
        out, *usual = WRITERS[command]
        given = {word for word in words + option if word.startswith("--")}
        if usual and (usual[0] in given or {"--sun", "--time"} & {usual[0]} and {"--time"} & given):
            usual = []
        sky = {"--environment", "--method"} & given
        if command == "irradiance" and {"--sun", "--time", "--lamp"} & given and not sky:
            usual = []
        if command == "shade" and "none" in words + option:
            usual = []
        output = [] if "-o" in words else ["-o", out]
        return [command, self.dem, *output, *usual, *words, *option]

    def result(self, command, further, option):
        """The bytes of the file, or of the output."""
        done = self.run_program(*self.arguments(command, further, option))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr, "")
        if "-" in further:
            return done.stdout
        with open(self.path(WRITERS[command][0]), "rb") as file:
            return file.read()

    def test_options_act(self):
        without = {}
        for command, lines in ACTS.items():
            for option, *further in lines:
                with self.subTest(command=command, option=option, further=further):
                    # Compared with the same command without the option, or with its default value.
                    base = tuple(self.arguments(command, further, []))
                    if base not in without:
                        without[base] = self.result(command, further, [])
                    self.assertTrue(without[base] != self.result(command, further, option),
                                    "the same bytes as without the option")

    def test_every_option_has_a_line(self):
        for command, lines in ACTS.items():
            known = {option[0] for option, *_ in lines} | NEUTRAL | ELSEWHERE.get(command, set())
            text = self.succeed(command, "--help").stdout
            offered = set(re.findall(r"^ +(?:-\w,)?(--[a-z-]+)", text, re.MULTILINE)) - {"--output"}
            self.assertGreater(len(offered), 5)
            self.assertEqual(offered - known, set(), command)

    def usage(self, says, option, *arguments):
        """Exit 2, and one line that names the option once and the command with further help."""
        line = self.refused(2, *arguments, says=says)
        reason, see = line.rsplit(" (see ", 1)
        self.assertEqual(see, f"skyline {arguments[0]} --help)")
        said = reason.split(", as in ")[0]
        self.assertEqual(len(re.findall(re.escape(option) + r"(?![\w-])", said)), 1, line)
        return line

    def test_options_that_cannot_act_are_refused(self):
        for command, further, option, says in IDLE:
            with self.subTest(command=command, option=option, further=further):
                words = self.arguments(command, further, option)
                self.usage(says, option[0], *words)
        for command, further, option, says in WARNED:
            with self.subTest(command=command, option=option, further=further):
                done = self.run_program(*self.arguments(command, further, option))
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertRegex(done.stderr, f"^warning: {option[0]} .*{says}.*; assuming ")

    def test_wrong_values(self):
        for option, (command, values) in NUMBERS.items():
            for value in NO_NUMBERS + values:
                with self.subTest(option=option, value=value):
                    self.usage("", option, *self.arguments(command, [], [f"{option}", value])[:-2],
                               *([f"{option}={value}"] if value else [option, ""]))
        for option, (command, values, near) in NAMES.items():
            for value in values:
                with self.subTest(option=option, value=value):
                    line = self.usage(near if value else "empty", option,
                                      *self.arguments(command, [], [option, value]))
                    if value and not value.isupper():
                        self.assertIn(f"; did you mean {near}?", line)

    def test_messages_name_what_is_wrong(self):
        for value, says in [("-inf", "is not a number"), ("nan", "is not a number"), ("1 ", "is not a number"),
                            ("one", "is not a number"),
                            ("0,5", "write 0.5, with a point"), ("5deg", "leave deg out"),
                            ("1e999", "1e999 is too large or too small for a number"),
                            ("95", "out of range; give 0 to 90 degrees")]:
            self.usage(says, "--tolerance", "horizon", self.dem, "-o", "out.tif", "--tolerance", value)

    def test_empty_values_are_unset_variables(self):
        out = ["-o", "out.tif"]
        for name, words in [
                ("--time", ["sun", self.dem, "--time", ""]), ("--time", ["sun", self.dem, "--time="]),
                ("--sun", ["sun", self.dem, "--sun", ""]), ("--output", ["sun", self.dem, "-o", ""]),
                ("--output", ["horizon", self.dem, "-o", ""]), ("DEM", ["horizon", "", *out]),
                ("--environment", ["irradiance", self.dem, *out, "--environment", ""]),
                ("--environment", ["irradiance", self.dem, *out, "--environment=", "uniform"]),
                ("--environment", ["shade", self.dem, "-o", "out.png", "--environment", ""]),
                ("--lamp", ["irradiance", self.dem, *out, "--lamp", ""]),
                ("--output", ["shade", self.dem, "-o", ""]),
                ("--scenes", ["benchmark", "-o", "report", "--scenes", ""])]:
            with self.subTest(words=words):
                self.usage("the value is empty", name, *words)

    def test_options_given_twice(self):
        for twice in [["-o", "a.tif", "-o", "b.tif"], ["-o", "a.tif", "--output", "b.tif"],
                      ["-o", "a.tif", "--azimuths", "4", "--azimuths", "8"]]:
            self.refused(2, "horizon", self.dem, *twice)
        self.refused(2, "sun", self.dem, "--sun", "1,2", "--sun", "3,4")

    def test_did_you_mean(self):
        for words, says in [
                (["skyview", self.dem, "-o", "x.tif"],
                 "there is no command skyview; did you mean sky-view? (see skyline --help)"),
                (["horizons"], "did you mean horizon?"),
                (["frobnicate"], "there is no command frobnicate (see"),
                (["shade", self.dem, "-o", "x.png", "--colours", "gray"],
                 "--colours is no option of shade; did you mean --colors? (see skyline shade --help)"),
                (["shade", self.dem, "--colours=gray"], "did you mean --colors?"),
                (["horizon", self.dem, "-o", "x.tif", "--azimuth", "4"], "did you mean --azimuths?"),
                (["horizon", self.dem, "--ouput", "x.tif"], "did you mean --output?"),
                (["horizon", self.dem, "-o", "x.tif", "--frobnicate"],
                 "--frobnicate is no option of horizon (see skyline horizon --help)"),
                (["horizon", self.dem, "more.tif", "-o", "x.tif"], "more.tif is one word too many")]:
            with self.subTest(words=words):
                self.refused(2, *words, says=says)

    def test_names_of_files(self):
        for name in ["out.gif", "out", "png"]:
            self.refused(2, "shade", self.dem, "-o", self.path(name), says=".png, .exr or .tif")
        for command in ["horizon", "sky-view", "sun", "shadow-height", "irradiance"]:
            light = SUN if command in ("sun", "shadow-height") else []
            self.refused(2, command, self.dem, "-o", self.path("out.png"), *light,
                         says="a raster is written as GeoTIFF; end its name in .tif")

    def test_help_offers_what_is_taken(self):
        for command in ACTS:
            text = self.succeed(command, "--help").stdout
            option = "--horizon" if command == "irradiance" else "--method"
            option_text = re.search(rf"^  {option} .*?(?=^  -)", text, re.MULTILINE | re.DOTALL)
            self.assertIsNotNone(option_text, command)
            for method in ["exact", "fast", "sweep", "pyramid"]:
                with self.subTest(command=command, method=method):
                    offered = method + ":" in option_text.group()
                    done = self.run_program(*self.arguments(command, [], [option, method]))
                    self.assertEqual(done.returncode, 0 if offered else 2, done.stderr)


class Doubts(ToolTest):
    """Options that have no effect because of the data, and doubtful values, cause a warning and are
    used."""

    def warns(self, says, *arguments):
        done = self.run_program(*arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = done.stderr.splitlines()
        self.assertEqual(len(lines), 1, done.stderr)
        self.assertRegex(lines[0], "^warning: " + says)
        self.assertEqual(self.run_program(*arguments, "--quiet").stderr, "")

    def test_refraction_off_the_earth(self):
        bare = make(self.path("bare.tif"), hills(5, 6))
        self.warns("--refraction has an effect on the Earth only.*no CRS.*; assuming no refraction$",
                   "horizon", bare, "-o", self.path("out.tif"), "--refraction", "0.2")
        moon = 'GEOGCS["Moon",DATUM["Moon",SPHEROID["Moon",1737400,0]],PRIMEM["Reference",0],' \
               'UNIT["degree",0.0174532925199433]]'
        dem = make(self.path("moon.tif"), hills(5, 6), step=(0.01, 0.01), corner=(3.0, 20.0), wkt=moon)
        for command, out in [("sky-view", "out.tif"), ("shade", "out.png")]:
            self.warns("--refraction has an effect on the Earth only.*another body", command, dem, "-o",
                       self.path(out), "--refraction", "0.2")

    def test_time_without_a_zone(self):
        dem = make(self.path("dem.tif"), hills(5, 6), epsg=UTM10)
        for time, utc in [("2026-06-21T16:00", "2026-06-21T16:00:00Z"),
                          ("2026-06-21 16:00:00", "2026-06-21T16:00:00Z"),
                          ("2026-06-21", "2026-06-21T00:00:00Z")]:
            self.warns(f"the time {time} has no time zone; assuming UTC; use --time {utc} to say otherwise$",
                       "sun", dem, "--time", time)

    def test_sky_of_a_sun_that_is_not_given(self):
        dem = make(self.path("dem.tif"), hills(5, 6), epsg=UTM10)
        self.warns("the sky cie:12 is brighter around the sun, and no sun is given; assuming its sun at "
                   "azimuth 315, elevation 45; use --sun AZ,EL to say otherwise$",
                   "irradiance", dem, "-o", self.path("out.tif"), "--environment", "cie:12")

    def test_sky_turned_from_its_sun(self):
        dem = make(self.path("dem.tif"), hills(5, 6), epsg=UTM10)
        for command, out in [("irradiance", "out.tif"), ("shade", "out.png")]:
            self.warns("--rotation turns the sky cie:12", command, dem, "-o", self.path(out),
                       "--environment", "cie:12", "--sun", "10,20", "--rotation", "90")

    def test_sun_that_is_down(self):
        dem = make(self.path("dem.tif"), hills(5, 6), epsg=UTM10)
        self.warns("--sun-irradiance is given, and the sun is below the horizon; assuming no light",
                   "shade", dem, "-o", self.path("out.png"), "--sun", "10,-20", "--sun-irradiance", "5")

    def test_shadow_heights_have_no_faster_method(self):
        dem = make(self.path("dem.tif"), hills(5, 6), epsg=UTM10)
        self.warns("no method finds shadow heights faster than exact; assuming --method exact",
                   "shadow-height", dem, "-o", self.path("out.tif"), "--method", "fast")

    def test_turns_of_any_number(self):
        # 1e20 degrees are exactly 280 modulo 360.
        dem = make(self.path("dem.tif"), hills(5, 6), epsg=UTM10)
        sky = ["--environment", os.path.join(Program.DATA, "light-maps", "sunset_128.hdr")]
        for turn, out in [("1e20", "a.tif"), ("280", "b.tif")]:
            self.succeed("irradiance", dem, "-o", self.path(out), *sky, "--rotation", turn)
        a, b = Program.read(self.path("a.tif")), Program.read(self.path("b.tif"))
        self.assertTrue(np.array_equal(a, b))
        self.assertGreater(a.min(), 0.0)
        self.assertEqual(self.succeed("sun", dem, "--sun", "1e20,10").stdout,
                         self.succeed("sun", dem, "--sun", "280,10").stdout)


if __name__ == "__main__":
    Program.main()
