#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Where exabricks-render writes to: files, symbolic links, devices, FIFOs and open descriptors.

Usage: TestRenderOutput.py PROGRAM rt_medium.vthb   (with a display, or under xvfb-run)
"""

import json
import os
import stat
import subprocess
import sys
import tempfile
import threading
import unittest

PROGRAM, DATA = "", ""

FINE, RENDERING_FAILED, OUTPUT_UNWRITABLE = 0, 1, 4


@unittest.skipIf(sys.platform == "win32", "symbolic links, FIFOs and devices of POSIX")
class RenderOutputTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.png = self.path("picture.png")

    def tearDown(self):
        self.folder.cleanup()

    def path(self, *names):
        return os.path.join(self.folder.name, *names)

    def make_folder(self, name):
        os.mkdir(self.path(name))
        return self.path(name)

    def run_program(self, statistics, **keywords):
        """Draws one level, with its statistics into a place of some kind."""
        return subprocess.run(
            [PROGRAM, DATA, self.png, "--stats", statistics, "--levels", "1", "--size", "32x32", "--quiet"],
            stderr=subprocess.PIPE, text=True, timeout=300, check=False, **keywords
        )

    def written(self, statistics, **keywords):
        done = self.run_program(statistics, **keywords)
        self.assertEqual(done.returncode, FINE, done.stderr)
        self.no_temporary_file()
        return done

    def refused(self, words, statistics, **keywords):
        """Refused before anything was drawn."""
        done = self.run_program(statistics, **keywords)
        self.assertEqual(done.returncode, OUTPUT_UNWRITABLE, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertFalse(os.path.exists(self.png))
        self.no_temporary_file()

    def no_temporary_file(self):
        for _, _, files in os.walk(self.folder.name):
            self.assertEqual([name for name in files if ".part" in name], [])

    def holds_statistics(self, path):
        with open(path, encoding="utf-8") as file:
            self.assertEqual(json.load(file)["data"]["levels"], 1)

    # Files and symbolic links

    def test_file_that_is_replaced_keeps_its_permissions(self):
        path = self.path("a.json")
        with open(path, "w", encoding="ascii") as file:
            file.write("what was there")
        os.chmod(path, 0o640)
        before = os.stat(path)
        self.written(path)
        self.holds_statistics(path)
        after = os.stat(path)
        self.assertEqual(stat.S_IMODE(after.st_mode), 0o640)
        self.assertNotEqual(after.st_ino, before.st_ino, "replaced whole, not written over")

    @unittest.skipUnless(hasattr(os, "geteuid") and os.geteuid() == 0, "only root may give files away")
    def test_file_that_root_replaces_keeps_its_owner(self):
        path = self.path("a.json")
        with open(path, "w", encoding="ascii"):
            pass
        os.chown(path, 12345, 23456)
        self.written(path)
        self.assertEqual((os.stat(path).st_uid, os.stat(path).st_gid), (12345, 23456))

    def test_link_stays_and_its_target_is_replaced(self):
        other = self.make_folder("other")
        with open(os.path.join(other, "a.json"), "w", encoding="ascii") as file:
            file.write("what was there")
        os.symlink(os.path.join("other", "a.json"), self.path("second"))  # from the link's own folder
        os.symlink(self.path("second"), self.path("first"))
        self.written(self.path("first"), cwd="/")
        self.assertTrue(os.path.islink(self.path("first")))
        self.assertTrue(os.path.islink(self.path("second")))
        self.holds_statistics(os.path.join(other, "a.json"))
        self.assertEqual(os.listdir(other), ["a.json"])

    def test_picture_through_a_link(self):
        other = self.make_folder("other")
        os.symlink(os.path.join(other, "a.png"), self.png)
        self.written(self.path("a.json"))
        self.assertTrue(os.path.islink(self.png))
        with open(os.path.join(other, "a.png"), "rb") as file:
            self.assertEqual(file.read(4), b"\x89PNG")

    def test_link_that_leads_to_no_file_makes_it(self):
        other = self.make_folder("other")
        os.symlink(os.path.join(other, "a.json"), self.path("link"))
        self.written(self.path("link"))
        self.assertTrue(os.path.islink(self.path("link")))
        self.holds_statistics(os.path.join(other, "a.json"))

    def test_link_into_a_folder_that_is_not_there(self):
        os.symlink(self.path("none", "a.json"), self.path("link"))
        self.refused(["link", self.path("none"), "Make it first"], self.path("link"))

    def test_links_in_a_circle(self):
        os.symlink("second", self.path("first"))
        os.symlink("first", self.path("second"))
        self.refused(["first", "circle"], self.path("first"))
        self.assertTrue(os.path.islink(self.path("first")))

    def test_link_to_a_folder(self):
        os.symlink(self.make_folder("other"), self.path("link"))
        self.refused(["link", "folder"], self.path("link"))

    # Devices, FIFOs, descriptors

    def test_device_stays_a_device(self):
        null = self.path("null")
        try:
            os.mknod(null, 0o666 | stat.S_IFCHR, os.makedev(1, 3))
            with open(null, "wb"):
                pass
        except OSError as error:
            self.skipTest("no device can be made here: %s" % error)
        os.symlink(null, self.path("link"))
        for path in (null, self.path("link")):
            with self.subTest(path):
                self.written(path)
                status = os.lstat(null)
                self.assertTrue(stat.S_ISCHR(status.st_mode))
                self.assertEqual(status.st_rdev, os.makedev(1, 3))
        self.assertTrue(os.path.islink(self.path("link")))

    def test_fifo_is_written_to(self):
        fifo, link = self.path("fifo"), self.path("link")
        os.mkfifo(fifo)
        os.symlink(fifo, link)
        for path in (fifo, link):
            with self.subTest(path):
                received = []

                def read():
                    with open(fifo, encoding="utf-8") as file:
                        received.append(file.read())

                reader = threading.Thread(target=read, daemon=True)
                reader.start()
                self.written(path)
                reader.join(60)
                self.assertEqual(json.loads(received[0])["data"]["levels"], 1)
                self.assertTrue(stat.S_ISFIFO(os.lstat(fifo).st_mode))

    def test_fifo_that_nobody_reads_is_not_waited_for_before_the_work(self):
        os.mkfifo(self.path("fifo"))
        done = subprocess.run(
            [PROGRAM, DATA, self.png, "--stats", self.path("fifo"), "--device", "no such device"],
            capture_output=True, text=True, timeout=60, check=False
        )
        self.assertEqual(done.returncode, RENDERING_FAILED, done.stderr)
        self.assertIn("no such device", done.stderr)

    @unittest.skipUnless(os.path.exists("/dev/fd/1"), "the system names no open descriptors")
    def test_open_descriptors(self):
        # What /dev/stdout is on Linux, but here: a program that errs must not replace the real one.
        os.symlink("/dev/fd/1", self.path("stdout"))
        for name in (self.path("stdout"), "/dev/fd/1"):
            # A file too: it is not replaced, or what the program prints would go to the one before.
            with self.subTest(name), open(self.path("out"), "w+", encoding="utf-8") as out:
                out.write("what came before\n")
                out.flush()
                self.written(name, stdout=out)
                out.seek(0)
                self.assertEqual(out.readline(), "what came before\n")
                self.assertEqual(json.loads(out.read())["data"]["levels"], 1)
        with self.subTest("a pipe"):
            done = self.written(self.path("stdout"), stdout=subprocess.PIPE)
            self.assertEqual(json.loads(done.stdout)["data"]["levels"], 1)
        self.assertTrue(os.path.islink(self.path("stdout")))

    @unittest.skipUnless(os.path.exists("/dev/fd/1"), "the system names no open descriptors")
    def test_descriptor_that_is_not_open(self):
        self.refused(["/dev/fd/87"], "/dev/fd/87")

    @unittest.skipUnless(os.path.exists("/dev/fd/1"), "the system names no open descriptors")
    def test_pipe_that_nobody_reads_any_more(self):
        read, write = os.pipe()
        os.close(read)
        done = self.run_program("/dev/fd/%d" % write, pass_fds=[write])
        os.close(write)
        self.assertEqual(done.returncode, OUTPUT_UNWRITABLE, done.stderr)
        self.assertIn("Broken pipe", done.stderr)


if __name__ == "__main__":
    PROGRAM, DATA = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
