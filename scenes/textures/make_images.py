#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the images of scenes/, which are in the public domain: those of textures/, and lights/sky.hdr.

rivets.png: normals of four round bumps in 64 x 64 texels, x -> (x + 1) / 2.
waves.png: heights of rings around the middle, in 64 x 64 texels of 16 bits.
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


def png(width, height, bits, colour, rows):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, bits, colour, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) +
            chunk(b"IEND", b""))


def rivets_png():
    rows = b""
    for y in range(64):
        rows += b"\0"
        for x in range(64):
            # From the middle of the bump, in its radii.
            along, across = ((x % 32) - 15.5) / 12, ((y % 32) - 15.5) / 12
            distance = math.hypot(along, across)
            steepness = 0.8 * distance if distance < 1 else 0
            normal = (steepness * along / distance, steepness * across / distance, math.sqrt(1 - steepness ** 2))
            rows += bytes(round(127.5 * (c + 1)) for c in normal)
    return png(64, 64, 8, 2, rows)


def waves_png():
    rows = b""
    for y in range(64):
        rows += b"\0"
        for x in range(64):
            distance = math.hypot(x - 31.5, y - 31.5) / 31.5
            height = 0.5 + 0.5 * math.cos(6 * math.pi * distance) if distance < 1 else 1
            rows += struct.pack(">H", round(65535 * height))
    return png(64, 64, 16, 0, rows)


def letter_png():
    rows = b""
    for y, line in enumerate(LETTER):
        rows += b"\0"
        for x, mark in enumerate(line):
            ground = (250 - 4 * x, 205 - 6 * y, 120 + 6 * x)
            rows += bytes((20, 40, 110) if mark == "X" else ground)
    return png(16, 16, 8, 2, rows)


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
    for name, image in ("letter", letter_png()), ("rivets", rivets_png()), ("waves", waves_png()):
        (SCENES / "textures" / f"{name}.png").write_bytes(image)
    (SCENES / "lights" / "sky.hdr").write_bytes(sky_hdr())


if __name__ == "__main__":
    main()
