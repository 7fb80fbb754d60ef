#!/usr/bin/env python3
"""The scripts leave nothing among the sources: what they import of Python is not compiled there."""

import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Leftovers(unittest.TestCase):
    def test_a_script_that_takes_a_screenshot(self):
        with tempfile.TemporaryDirectory() as folder:
            copy = pathlib.Path(folder)
            for part in ("script", "tests/qemu"):
                shutil.copytree(ROOT / part, copy / part, ignore=shutil.ignore_patterns("__pycache__"))
            boards = "firmware/boards/boards.json"
            (copy / boards).parent.mkdir(parents=True)
            shutil.copy(ROOT / boards, copy / boards)
            before = sorted(copy.rglob("*"))
            (copy / "script/shot").write_text(
                'source "$(dirname "$0")/lib.sh"\npython3 tests/qemu/screenshot.py --help >/dev/null\n'
            )
            environment = {"PATH": "/usr/local/bin:/usr/bin:/bin"}
            subprocess.run(["bash", copy / "script/shot"], env=environment, check=True)
            (copy / "script/shot").unlink()
            self.assertEqual(sorted(copy.rglob("*")), before)

    def test_every_script_goes_by_what_they_share(self):
        for path in sorted((ROOT / "script").iterdir()):
            if not path.is_file() or path.name == "lib.sh" or not path.read_bytes().startswith(b"#!/usr/bin/env bash"):
                continue
            with self.subTest(path.name):
                self.assertIn('source "$(dirname "$0")/lib.sh"', path.read_text())


if __name__ == "__main__":
    unittest.main()
