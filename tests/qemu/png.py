"""8-bit pictures as rows of bytes: reads and writes PNG, reads the PPM that QEMU's screendump gives. Grey, RGB and RGBA
PNGs without interlacing; everything comes out as RGB."""

import struct
import zlib
from dataclasses import dataclass

SIGNATURE = b"\x89PNG\r\n\x1a\n"


@dataclass
class Picture:
    width: int
    height: int
    rgb: bytes

    def pixel(self, x, y):
        at = 3 * (y * self.width + x)
        return self.rgb[at : at + 3]

    def shrunk(self, factor):
        """Every factor-th pixel; ValueError unless the picture is made of blocks of that size."""
        small = Picture(
            self.width // factor,
            self.height // factor,
            b"".join(
                self.pixel(x, y) for y in range(0, self.height, factor) for x in range(0, self.width, factor)
            ),
        )
        if small.grown(factor).rgb != self.rgb:
            raise ValueError(f"the picture is not made of blocks of {factor} by {factor} pixels")
        return small

    def grown(self, factor):
        rows = []
        for y in range(self.height):
            row = b"".join(self.pixel(x, y) * factor for x in range(self.width))
            rows.append(row * factor)
        return Picture(self.width * factor, self.height * factor, b"".join(rows))


def read_ppm(path):
    with open(path, "rb") as file:
        magic, size, depth, rgb = file.read().split(b"\n", 3)
    if magic != b"P6" or depth != b"255":
        raise ValueError(f"{path} is not an 8-bit PPM")
    width, height = map(int, size.split())
    return Picture(width, height, rgb)


def write_png(path, picture):
    write_rows(path, picture.width, picture.height, picture.rgb, 3)


def write_png_rgba(path, width, height, rgba):
    """Four bytes a pixel, alpha not premultiplied."""
    write_rows(path, width, height, rgba, 4)


def write_rows(path, width, height, pixels, channels):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    stride = width * channels
    rows = b"".join(b"\0" + pixels[y * stride : (y + 1) * stride] for y in range(height))
    header = struct.pack(">IIBBBBB", width, height, 8, {3: 2, 4: 6}[channels], 0, 0, 0)
    with open(path, "wb") as file:
        file.write(SIGNATURE + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def read_png(path):
    with open(path, "rb") as file:
        data = file.read()
    if not data.startswith(SIGNATURE):
        raise ValueError(f"{path} is not a PNG")
    at, packed = len(SIGNATURE), b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at : at + 8])
        body = data[at + 8 : at + 8 + length]
        if kind == b"IHDR":
            width, height, depth, colour, _, _, interlaced = struct.unpack(">IIBBBBB", body)
        elif kind == b"IDAT":
            packed += body
        at += length + 12
    channels = {0: 1, 2: 3, 6: 4}.get(colour)
    if depth != 8 or channels is None or interlaced:
        raise ValueError(f"{path} is a kind of PNG that this program does not read")
    pixels = unfilter(zlib.decompress(packed), width * channels, height, channels)
    if channels == 1:
        pixels = bytes(value for value in pixels for _ in range(3))
    elif channels == 4:
        pixels = b"".join(pixels[i : i + 3] for i in range(0, len(pixels), 4))
    return Picture(width, height, pixels)


def unfilter(raw, stride, height, channels):
    """Undoes the row filters of the PNG specification, section 9."""
    previous, rows = bytes(stride), []
    for y in range(height):
        kind, *line = raw[y * (stride + 1) : (y + 1) * (stride + 1)]
        for i in range(stride):
            left = line[i - channels] if i >= channels else 0
            up = previous[i]
            corner = previous[i - channels] if i >= channels else 0
            guess = (0, left, up, (left + up) // 2, paeth(left, up, corner))[kind]
            line[i] = (line[i] + guess) & 255
        previous = bytes(line)
        rows.append(previous)
    return b"".join(rows)


def paeth(left, up, corner):
    estimate = left + up - corner
    distances = (abs(estimate - left), abs(estimate - up), abs(estimate - corner))
    return (left, up, corner)[distances.index(min(distances))]
