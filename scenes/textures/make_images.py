#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the images of scenes/, which are in the public domain: textures/letter.png and lights/sky.hdr.

letter.png: an F in 16 x 16 texels, so that every turn and mirror image of it looks different.
sky.hdr: a sky of 64 x 33 texels (Radiance RGBE), blue above, brown below, a sun of 20,000 in one texel.
"""
import math
import pathlib
import struct
import zlib

SCENES = pathlib.Path(__file__).resolve().parents[1]

LETTER = """
................
.XXXXXXXXXX.....
.XXXXXXXXXX.....
.XXX............
.XXX............
.XXX............
.XXXXXXXX.......
.XXXXXXXX.......
.XXX............
.XXX............
.XXX............
.XXX............
.XXX............
.XXX............
.XXX............
................
""".split()


def letter_png():
    rows = b""
    for y, line in enumerate(LETTER):
        rows += b"\0"
        for x, mark in enumerate(line):
            ground = (250 - 4 * x, 205 - 6 * y, 120 + 6 * x)
            rows += bytes((20, 40, 110) if mark == "X" else ground)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", 16, 16, 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) +
            chunk(b"IEND", b""))


def rgbe(rgb):
    most = max(rgb)
    exponent = math.frexp(most)[1]
    return bytes(int(math.ldexp(c, 8 - exponent)) for c in rgb) + bytes([exponent + 128])


def sky_hdr():
    width, height = 64, 33
    texels = b""
    for y in range(height):
        up = math.cos(math.pi * y / (height - 1))
        for x in range(width):
            if (x, y) == (20, 9):
                texels += rgbe((20000, 17000, 13000))
                continue
            if up < 0:
                colour = [0.16, 0.12, 0.08]
            else:
                glow = 0.8 * math.exp(-((x - 20) ** 2 + (y - 9) ** 2) / 20)
                colour = [0.9 - 0.7 * up + glow, 0.95 - 0.5 * up + 0.8 * glow, 1.0 - 0.2 * up + 0.5 * glow]
            texels += rgbe(colour)
    return b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n" % (height, width) + texels


def main():
    (SCENES / "textures" / "letter.png").write_bytes(letter_png())
    (SCENES / "lights" / "sky.hdr").write_bytes(sky_hdr())


if __name__ == "__main__":
    main()
