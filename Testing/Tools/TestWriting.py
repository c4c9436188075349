# SPDX-License-Identifier: BSD-3-Clause
"""How results are written: no source is destroyed, no file is left over, links and permissions are kept."""
import errno
import fcntl
import gzip
import os
import shutil
import signal
import stat
import subprocess
import time
import zipfile

import Program
from Program import ToolTest, UTM10, gdal, hills, make, np

# Seconds in which a signal must end the program: half a second is the delay of Tools/Shared/Interrupt.h,
# the rest is for a busy machine.
SOON = 10.0


class WritingTest(ToolTest):
    def setUp(self):
        super().setUp()
        make(self.path("dem.tif"), hills(40, 50), epsg=UTM10)

    def bytes_of(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def horizon(self, *arguments, **options):
        return self.run_program("horizon", *arguments, "--azimuths", "4", **options)


class Sources(WritingTest):
    def kept(self, source, dem, out, command="horizon", options=("--azimuths", "4")):
        before = self.bytes_of(source)
        with self.subTest(dem=dem, out=out, command=command):
            self.refused(1, command, dem, "-o", out, *options, says="part of the input")
            self.assertEqual(self.bytes_of(source), before)

    def test_spellings_and_links(self):
        os.symlink("dem.tif", self.path("link.tif"))
        os.link(self.path("dem.tif"), self.path("hard.tif"))
        os.symlink(self.folder, self.path("here"))
        for out in ["dem.tif", "./dem.tif", "here/dem.tif", "link.tif", "hard.tif",
                    os.path.join(os.path.dirname(self.folder), ".",
                                 os.path.basename(self.folder), "dem.tif")]:
            self.kept("dem.tif", "dem.tif", out)
        self.kept("dem.tif", "link.tif", "dem.tif")
        self.kept("dem.tif", "hard.tif", "dem.tif")
        with open(self.path("dem.tif"), "ab") as file:  # the shell's >>
            done = self.horizon("dem.tif", "-o", "/dev/stdout", stdout=file)
            self.assertEqual(done.returncode, 1)

    def run_program(self, *arguments, **options):
        if "stdout" not in options:
            return super().run_program(*arguments, **options)
        return subprocess.run([Program.PROGRAM, *map(str, arguments)], stdin=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, timeout=300, cwd=self.folder, **options)

    def test_names_that_hold_the_file(self):
        self.kept("dem.tif", "GTIFF_DIR:1:dem.tif", "dem.tif")
        self.kept("dem.tif", "vrt://dem.tif?bands=1", "dem.tif")
        with zipfile.ZipFile(self.path("zip.tif"), "w") as archive:
            archive.write(self.path("dem.tif"), "in.tif")
        self.kept("zip.tif", "/vsizip/{zip.tif}/in.tif", "zip.tif")
        self.kept("zip.tif", "/vsizip/{" + self.path("zip.tif") + "}/in.tif", "zip.tif")
        with open(self.path("dem.tif"), "rb") as plain, gzip.open(self.path("gz.tif"), "wb") as packed:
            shutil.copyfileobj(plain, packed)
        self.kept("gz.tif", "/vsigzip/gz.tif", "gz.tif")
        if gdal.GetDriverByName("netCDF"):
            gdal.Translate(self.path("nc.tif"), self.path("dem.tif"), format="netCDF")
            self.kept("nc.tif", 'NETCDF:"nc.tif":Band1', "nc.tif")

    def test_virtual_rasters(self):
        gdal.BuildVRT(self.path("one.vrt"), [self.path("dem.tif")])
        gdal.Translate(self.path("two.vrt"), self.path("one.vrt"), format="VRT")
        os.makedirs(self.path("sub"))
        shutil.copy(self.path("dem.tif"), self.path("sub/far.tif"))
        gdal.BuildVRT(self.path("sub/far.vrt"), [self.path("sub/far.tif")])  # relative to the VRT
        self.kept("dem.tif", "one.vrt", "dem.tif")
        self.kept("dem.tif", "two.vrt", "dem.tif")
        self.kept("sub/far.tif", "sub/far.vrt", "sub/far.tif")
        self.kept("one.vrt", "one.vrt", "one.vrt")
        with open(self.path("one.vrt")) as file:
            self.kept("dem.tif", file.read(), "dem.tif")

    def test_side_files(self):
        # The raster `flat` has a header file without an extension that reveals its format.
        gdal.Translate(self.path("flat"), self.path("dem.tif"), format="ENVI")
        self.kept("flat.hdr", "flat", "flat.hdr")
        # A new out.tif removes the overviews beside the old one. Here the file of that name is a
        # DEM itself.
        shutil.copy(self.path("dem.tif"), self.path("out.tif.ovr"))
        shutil.copy(self.path("dem.tif"), self.path("out.tif"))
        self.kept("out.tif.ovr", "out.tif.ovr", "out.tif")

    def test_light_maps(self):
        with open(self.path("sky.hdr"), "wb") as file:  # 8 x 4 pixels of light 1
            file.write(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 8\n" + b"\x80\x80\x80\x81" * 32)
        shutil.copy(self.path("sky.hdr"), self.path("sky.tif"))
        os.symlink("sky.hdr", self.path("map.tif"))
        self.kept("sky.hdr", "dem.tif", "map.tif", "irradiance", ("--environment", "sky.hdr"))
        os.rename(self.path("map.tif"), self.path("map.png"))
        self.kept("sky.hdr", "dem.tif", "map.png", "shade", ("--environment", "sky.hdr"))


class Places(WritingTest):
    def test_a_dangling_link_is_filled_and_a_loop_refused(self):
        os.makedirs(self.path("real"))
        os.symlink("real/out.tif", self.path("dangling.tif"))
        self.succeed("horizon", "dem.tif", "-o", "dangling.tif", "--azimuths", "4")
        self.assertTrue(os.path.islink(self.path("dangling.tif")))
        self.assertEqual(os.listdir(self.path("real")), ["out.tif"])
        self.assertEqual(Program.read(self.path("dangling.tif")).shape, (4, 40, 50))
        os.symlink("loop.tif", self.path("loop.tif"))
        self.refused(1, "horizon", "dem.tif", "-o", "loop.tif", says="symbolic links")

    def test_standard_output_that_is_a_file_is_appended_to(self):
        self.succeed("horizon", "dem.tif", "-o", "whole.tif", "--azimuths", "4")
        for mode in ["ab", "wb"]:
            with self.subTest(mode=mode), open(self.path("log"), mode) as file:
                file.write(b"before")
                file.flush()
                done = subprocess.run(
                    [Program.PROGRAM, "horizon", "dem.tif", "-o", "/dev/stdout", "--azimuths", "4"],
                    stdout=file, stderr=subprocess.PIPE, cwd=self.folder)
                self.assertEqual(done.returncode, 0, done.stderr)
                file.write(b"after")
            self.assertEqual(self.bytes_of("log"), b"before" + self.bytes_of("whole.tif") + b"after")
            os.remove(self.path("log"))

    def test_a_closed_pipe_leaves_nothing(self):
        make(self.path("dem.tif"), hills(300, 280), epsg=UTM10)
        os.makedirs(self.path("tmp"))
        for ignored in [False, True]:
            reader, writer = os.pipe()
            running = subprocess.Popen(
                [Program.PROGRAM, "horizon", "dem.tif", "-o", "/dev/stdout", "--azimuths", "16"],
                stdout=writer, stderr=subprocess.PIPE, text=True, cwd=self.folder,
                restore_signals=not ignored, env=dict(os.environ, TMPDIR=self.path("tmp")))
            os.close(writer)
            os.read(reader, 100)
            os.close(reader)
            _, text = running.communicate(timeout=60)
            if ignored:
                self.assertEqual(running.returncode, 1)
                self.assertIn("Broken pipe", text)
            else:
                self.assertEqual(running.returncode, -signal.SIGPIPE)
            self.assertEqual(os.listdir(self.path("tmp")), [])

    def test_rights(self):
        out = self.path("out.tif")
        run = lambda **options: self.succeed(
            "horizon", "dem.tif", "-o", "out.tif", "--azimuths", "4", **options)
        mode = lambda: stat.S_IMODE(os.stat(out).st_mode)
        run(umask=0o027)
        self.assertEqual(mode(), 0o640)
        for given, wanted in [(0o600, 0o600), (0o664, 0o664), (0o6755, 0o755)]:
            os.chmod(out, given)
            run(umask=0o077)
            self.assertEqual(mode(), wanted)
        if os.geteuid() == 0:
            os.chown(out, 65534, 65534)
            run()
            self.assertEqual((os.stat(out).st_uid, os.stat(out).st_gid), (65534, 65534))

    def test_a_link_of_someone_else_in_a_sticky_folder_is_not_followed(self):
        with open("/proc/sys/fs/protected_symlinks") as file:
            if os.geteuid() != 0 or file.read().strip() != "1":
                self.skipTest("needs root, and a system that protects links")
        os.makedirs(self.path("sticky"))
        os.chmod(self.path("sticky"), 0o1777)
        os.symlink("../victim.tif", self.path("sticky/out.tif"))
        os.lchown(self.path("sticky/out.tif"), 65534, 65534)
        self.refused(1, "horizon", "dem.tif", "-o", "sticky/out.tif", says="Permission denied")
        self.assertFalse(os.path.exists(self.path("victim.tif")))


class Leftovers(WritingTest):
    def start(self, *arguments, **options):
        return subprocess.Popen([Program.PROGRAM, *arguments], stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True, cwd=self.folder, **options)

    def temporaries(self):
        return [name for name in self.files() if name.startswith(".skyline")]

    def size_of(self, name):
        try:
            return os.path.getsize(self.path(name))
        except FileNotFoundError:
            return 0

    def begin_writing(self):
        """A process that has a temporary file in the folder, because it is writing."""
        running = self.start("horizon", "big.tif", "-o", "out.tif", "--azimuths", "360")
        end = time.monotonic() + 60
        # The first temporary file is only a test of the folder. The one with content is the output.
        while not any(self.size_of(name) for name in self.temporaries()):
            self.assertIsNone(running.poll(), "it was finished before it was seen")
            self.assertLess(time.monotonic(), end)
            time.sleep(0.002)
        return running

    def test_killed_processes_are_swept_and_living_ones_are_not(self):
        make(self.path("big.tif"), hills(300, 280), epsg=UTM10)
        running = self.begin_writing()
        running.send_signal(signal.SIGKILL)
        running.communicate()
        self.assertNotEqual(self.temporaries(), [])
        # A file of the same type that another process holds.
        living = self.path(".skyline-held-1-1.part.tif")
        with open(living, "w") as held:
            fcntl.flock(held, fcntl.LOCK_EX)
            open(living + ".aux.xml", "w").close()
            self.succeed("horizon", "dem.tif", "-o", "other.tif", "--azimuths", "4")
            self.assertEqual(self.temporaries(),
                             [os.path.basename(living), os.path.basename(living) + ".aux.xml"])
        self.succeed("horizon", "dem.tif", "-o", "other.tif", "--azimuths", "4")
        self.assertEqual(self.files(), ["big.tif", "dem.tif", "other.tif"])

    def test_signals_end_it_and_leave_nothing(self):
        make(self.path("big.tif"), hills(300, 280), epsg=UTM10)
        for number in [signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT, signal.SIGABRT,
                       signal.SIGXCPU]:
            with self.subTest(signal=number):
                running = self.begin_writing()
                sent = time.monotonic()
                running.send_signal(number)
                running.communicate(timeout=60)
                self.assertEqual(running.returncode, -number)
                self.assertLess(time.monotonic() - sent, SOON)
                self.assertEqual(self.temporaries(), [])

    def test_ignored_signals_stay_ignored(self):
        make(self.path("big.tif"), hills(300, 280), epsg=UTM10)

        def ignore():
            for number in [signal.SIGHUP, signal.SIGINT, signal.SIGQUIT]:
                signal.signal(number, signal.SIG_IGN)

        running = self.start("horizon", "big.tif", "-o", "out.tif", "--azimuths", "360",
                             preexec_fn=ignore)
        for number in [signal.SIGHUP, signal.SIGINT, signal.SIGQUIT]:
            time.sleep(0.2)
            self.assertIsNone(running.poll(), "it was finished before the signal")
            running.send_signal(number)
        _, text = running.communicate(timeout=120)
        self.assertEqual((running.returncode, text), (0, ""))

    def test_a_shell_stops_its_loop(self):
        make(self.path("big.tif"), hills(700, 600), epsg=UTM10)
        loop = subprocess.Popen(
            ["bash", "-c", "for i in 1 2 3; do \"$0\" sky-view big.tif -o $i.tif --azimuths 3600; done; "
             "echo went on", Program.PROGRAM], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
            text=True, cwd=self.folder, start_new_session=True)
        time.sleep(1.5)
        os.killpg(loop.pid, signal.SIGINT)  # as the terminal does
        out, _ = loop.communicate(timeout=60)
        self.assertNotIn("went on", out)


class Threads(WritingTest):
    def test_no_thread_will_do_and_one_that_is_refused_late_is_told(self):
        preload = os.environ.get("SKYLINE_FAIL_CALLS", "")
        if not os.path.exists(preload):
            self.skipTest("the library that makes threads fail was not built")
        self.skip_if_sanitized()
        make(self.path("dem.tif"), hills(600, 700), epsg=UTM10)
        ways = [("horizon", "a.tif", "--azimuths", "8"),
                ("horizon", "b.tif", "--azimuths", "4", "--cloud-optimized"),
                ("shade", "e.tif", "--azimuths", "8")]

        def limited(first):
            """Makes this thread of those that the program starts, and all later ones, fail."""
            return dict(os.environ, LD_PRELOAD=preload, SKYLINE_FAULT_CALL="thread",
                        SKYLINE_FAULT_NUMBER=str(first), SKYLINE_FAULT_ERROR=str(errno.EAGAIN),
                        SKYLINE_FAULT_LASTING="1")

        for command, out, *options in ways:
            self.succeed(command, "dem.tif", "-o", out, *options)
            whole = self.bytes_of(out)
            for first in [1, 2, 3]:
                with self.subTest(command=command, out=out, first=first):
                    os.remove(self.path(out))
                    before = self.files()
                    done = self.run_program(command, "dem.tif", "-o", out, *options, "--threads", "4",
                                            env=limited(first))
                    # The program first tries to start one thread per processor. If TBB then fails
                    # to start a thread that existed in this test, the run ends.
                    if first > 1 and done.returncode == 1:
                        self.assertIn(os.strerror(errno.EAGAIN), done.stderr)
                        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
                        self.assertEqual(self.files(), before)
                        self.succeed(command, "dem.tif", "-o", out, *options)
                    else:
                        self.assertEqual((done.returncode, done.stderr), (0, ""))
                    self.assertEqual(self.bytes_of(out), whole)
        for out in ["c.png", "d.exr"]:
            with self.subTest(out=out):
                arguments = ["shade", "dem.tif", "-o", out, "--azimuths", "8", "--threads", "4"]
                self.refused(1, *arguments, says="OpenImageIO needs 4 threads", env=limited(1))
                self.succeed(*arguments)


if __name__ == "__main__":
    Program.main()
