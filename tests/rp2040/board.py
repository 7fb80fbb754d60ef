"""Runs the Pico's images in rp2040js and looks at what its display showed."""

import json
import pathlib
import subprocess
import sys
from dataclasses import dataclass

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/qemu"))
import png  # noqa: E402
from machine import Failure  # noqa: E402
from screenshot import require_equal  # noqa: E402

IMAGES = ROOT / "build/firmware/pico"
# The end of the line that a turntable writes when its last frame is on the display.
SHOWN = " of 4096\n"


@dataclass
class Tools:
    """Programs of the host build."""

    panel_trace: str
    turntable_host: str


def run(image, trace, *options, timeout=100):
    """Runs an image and returns frames.mjs's report."""
    path = IMAGES / f"{image}.elf"
    if not path.is_file():
        raise Failure(f"no image {path}: run script/build first")
    command = ["node", ROOT / "tests/rp2040/frames.mjs", path, "--trace", trace, *options]
    done = subprocess.run(command, capture_output=True, text=True, timeout=timeout)
    if done.returncode != 0:
        raise Failure(f"{image} did not do what was expected of it:\n{done.stderr}\n{done.stdout}")
    return json.loads(done.stdout)


def shown(tools, panel, trace, prefix):
    """The files of the pictures that the display showed, in order. Fails where the panel's model finds fault, or warns of anything but
    an ILI9341's clock, which everybody runs above its rating."""
    for old in pathlib.Path(prefix).parent.glob(f"{pathlib.Path(prefix).name}*.png"):
        old.unlink()
    done = subprocess.run([tools.panel_trace, panel, trace, "--pictures", prefix], capture_output=True, text=True)
    count, *complaints = done.stdout.splitlines() or ["0"]
    if done.returncode != 0 or [c for c in complaints if not (panel == "ili9341" and "clock_above_rating" in c)]:
        raise Failure(f"the panel's model complains:\n{done.stdout}{done.stderr}")
    return [pathlib.Path(f"{prefix}{i}.png") for i in range(int(count.split()[0]))]


def require_frames(tools, panel, pictures, frames, folder, model="bunny", shading="gouraud"):
    """Each picture is the one that the simulator draws of the frame with that number, on the same panel."""
    if len(pictures) != len(frames):
        raise Failure(f"the display showed {len(pictures)} pictures, expected {len(frames)}")
    wanted = pathlib.Path(folder) / "wanted.png"
    for picture, frame in zip(pictures, frames):
        subprocess.run([tools.turntable_host, panel, str(frame), wanted, model, shading], check=True)
        if picture.read_bytes() == wanted.read_bytes():
            continue
        try:
            require_equal(png.read_png(picture), png.read_png(wanted))
        except Failure as difference:
            raise Failure(f"frame {frame}: {difference}") from None
