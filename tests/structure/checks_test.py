#!/usr/bin/env python3
"""The checks of the structure can fail: where their tool crashes, and where there is nothing to look at."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent


def run(script, *arguments, folder=None):
    """A check's exit code and output; programs in `folder` stand for the tools of those names."""
    path = os.environ["PATH"] if folder is None else f"{folder}:{os.environ['PATH']}"
    done = subprocess.run(
        [sys.executable, HERE / script, *arguments], env={**os.environ, "PATH": path}, capture_output=True, text=True
    )
    return done.returncode, done.stdout + done.stderr


class Crashes(unittest.TestCase):
    """A tool that ends with a fault of its own and names no file."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        for tool in ("clang-format", "clang-tidy", "nm"):
            path = pathlib.Path(self.folder.name) / tool
            path.write_text("#!/bin/sh\necho stack dump >&2\nexit 139\n")
            path.chmod(0o755)
        self.addCleanup(self.folder.cleanup)

    def refuses(self, script, *arguments):
        code, output = run(script, *arguments, folder=self.folder.name)
        self.assertNotEqual(code, 0, output)
        self.assertIn("139", output)

    def test_format(self):
        self.refuses("format.py")

    def test_tidy(self):
        self.refuses("tidy.py", self.folder.name)

    def test_symbols(self):
        for library in ("core/libspanline_core.a", "hal/libspanline_hal.a"):
            path = pathlib.Path(self.folder.name) / library
            path.parent.mkdir()
            path.touch()
        self.refuses("symbols.py", self.folder.name)


class Emptiness(unittest.TestCase):
    """Libraries without members, firmware without objects, programs without symbols."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def put_object(self, path, text):
        path.parent.mkdir(parents=True, exist_ok=True)
        subprocess.run(["gcc", "-c", "-xc", "-", "-o", path], input=text, text=True, check=True)

    def put_library(self, room, text):
        member, library = self.folder / room / "member.o", self.folder / room / f"libspanline_{room}.a"
        self.put_object(member, text)
        subprocess.run(["ar", "rc", library, *([member] if text else [])], check=True)

    def symbols(self):
        return run("symbols.py", self.folder)

    def test_what_is_as_it_should_be_passes(self):
        self.put_library("core", "int a(void) { return 1; }")
        self.put_library("hal", "int b(void) { return 1; }")
        self.put_object(self.folder / "firmware/app.obj", "int a(void); int main(void) { return a(); }")
        self.assertEqual(self.symbols()[0], 0, self.symbols()[1])

    def test_a_call_of_the_heap_fails(self):
        self.put_library("core", "int a(void) { return 1; }")
        self.put_library("hal", "int b(void) { return 1; }")
        self.put_object(self.folder / "firmware/app.obj", "void free(void*); void f(void* p) { free(p); }")
        self.assertIn("free (heap)", self.symbols()[1])
        self.assertNotEqual(self.symbols()[0], 0)

    def test_an_empty_folder_fails(self):
        self.assertNotEqual(self.symbols()[0], 0)

    def test_firmware_without_objects_fails(self):
        self.put_library("core", "int a(void) { return 1; }")
        self.put_library("hal", "int b(void) { return 1; }")
        self.assertIn("no objects", self.symbols()[1])
        self.assertNotEqual(self.symbols()[0], 0)

    def test_an_empty_library_fails(self):
        self.put_library("core", "")
        self.put_library("hal", "int b(void) { return 1; }")
        self.put_object(self.folder / "firmware/app.obj", "int main(void) { return 0; }")
        self.assertIn("an empty library", self.symbols()[1])
        self.assertNotEqual(self.symbols()[0], 0)

    def test_a_stripped_program_fails(self):
        self.put_object(self.folder / "plain.elf", "")
        self.put_object(self.folder / "rich.elf", "int font(void) { return 1; }")
        code, output = run("unused.py", self.folder, "--plain", "plain.elf", "--rich", "rich.elf")
        self.assertIn("plain.elf: has no symbols", output)
        self.assertNotEqual(code, 0)


if __name__ == "__main__":
    unittest.main()
