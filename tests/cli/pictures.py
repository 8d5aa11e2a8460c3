"""Readers of picture files, written from the formats' own descriptions, to check what the program
writes: PNG, PPM, PFM, BMP, TGA (uncompressed and RLE), HDR and EXR (scan lines, none or ZIP).
"""
import struct
import zlib


class Png:
    """An 8-bit RGB PNG without interlace."""

    def __init__(self, data):
        assert data[:8] == b"\x89PNG\r\n\x1a\n"
        self.text, packed, position = {}, b"", 8
        kind = b""
        while kind != b"IEND":
            length, kind = struct.unpack(">I4s", data[position:position + 8])
            body = data[position + 8:position + 8 + length]
            crc, = struct.unpack(">I", data[position + 8 + length:position + 12 + length])
            assert crc == zlib.crc32(kind + body), kind
            position += 12 + length
            if kind == b"IHDR":
                self.width, self.height, depth, color, _, _, interlace = struct.unpack(">IIBBBBB",
                                                                                       body)
                assert (depth, color, interlace) == (8, 2, 0)
            elif kind == b"IDAT":
                packed += body
            elif kind == b"iTXt":
                key, rest = body.split(b"\0", 1)
                assert rest[:2] == b"\0\0"
                self.text[key.decode()] = rest[2:].split(b"\0", 2)[2].decode()
            elif kind == b"tEXt":
                key, value = body.split(b"\0", 1)
                self.text[key.decode("latin-1")] = value.decode("latin-1")
        assert position == len(data)
        self.pixels = self._unfilter(zlib.decompress(packed))

    def _unfilter(self, raw):
        stride = 3 * self.width
        assert len(raw) == (stride + 1) * self.height
        above, out = bytearray(stride), bytearray()
        for y in range(self.height):
            kind, line = raw[y * (stride + 1)], bytearray(
                raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
            for i in range(stride):
                a = line[i - 3] if i >= 3 else 0
                b = above[i]
                c = above[i - 3] if i >= 3 else 0
                guess = [0, a, b, (a + b) // 2, paeth(a, b, c)][kind]
                line[i] = (line[i] + guess) & 255
            out += line
            above = line
        return bytes(out)


def paeth(a, b, c):
    p = a + b - c
    distances = (abs(p - a), abs(p - b), abs(p - c))
    return (a, b, c)[distances.index(min(distances))]


class Ppm:
    """P3 or P6, maximum 255."""

    def __init__(self, data):
        self.kind, self.comments = data[:2].decode(), []
        position, numbers = 2, []
        while len(numbers) < 3:
            byte = data[position:position + 1]
            if byte == b"#":
                end = data.index(b"\n", position)
                self.comments.append(data[position + 1:end].decode().strip())
                position = end
            elif byte.isspace():
                position += 1
            else:
                end = position
                while data[end:end + 1].isdigit():
                    end += 1
                numbers.append(int(data[position:end]))
                position = end
        self.width, self.height, maximum = numbers
        assert maximum == 255
        body = data[position + 1:]
        self.pixels = body if self.kind == "P6" else bytes(map(int, body.split()))
        assert len(self.pixels) == 3 * self.width * self.height


class Pfm:
    """RGB float; pixels top row first."""

    def __init__(self, data):
        kind, size, scale, body = data.split(b"\n", 3)
        assert kind == b"PF" and float(scale) < 0
        self.width, self.height = map(int, size.split())
        assert len(body) == 12 * self.width * self.height
        rows = [body[y * 12 * self.width:(y + 1) * 12 * self.width] for y in range(self.height)]
        self.bytes = b"".join(reversed(rows))
        self.values = struct.unpack(f"<{3 * self.width * self.height}f", self.bytes)


class Bmp:
    """24 bits, uncompressed; pixels as RGB, top row first."""

    def __init__(self, data):
        magic, size, offset = data[:2], *struct.unpack("<I4xI", data[2:14])
        assert magic == b"BM" and size == len(data)
        self.width, height, planes, bits, packing = struct.unpack("<iiHHI", data[18:34])
        assert (planes, bits, packing) == (1, 24, 0)
        self.height = abs(height)
        stride = (3 * self.width + 3) // 4 * 4
        rows = [data[offset + y * stride:offset + y * stride + 3 * self.width]
                for y in range(self.height)]
        if height > 0:
            rows.reverse()
        self.pixels = rgb_of_bgr(b"".join(rows))


class Tga:
    """24 bits, plain or run-length; pixels as RGB, top row first."""

    def __init__(self, data):
        kind = data[2]
        assert kind in (2, 10)
        self.width, self.height, bits, descriptor = struct.unpack("<HHBB", data[12:18])
        assert bits == 24
        self.comment = data[18:18 + data[0]].decode()
        body, pixels = data[18 + data[0]:], b""
        count = self.width * self.height
        if kind == 2:
            pixels = body[:3 * count]
        while len(pixels) < 3 * count:
            packet, length = body[0], (body[0] & 127) + 1
            if packet & 128:
                pixels += body[1:4] * length
                body = body[4:]
            else:
                pixels += body[1:1 + 3 * length]
                body = body[1 + 3 * length:]
        stride = 3 * self.width
        rows = [pixels[y * stride:(y + 1) * stride] for y in range(self.height)]
        if not descriptor & 0x20:
            rows.reverse()
        self.pixels = rgb_of_bgr(b"".join(rows))


def rgb_of_bgr(data):
    out = bytearray(data)
    out[0::3], out[2::3] = data[2::3], data[0::3]
    return bytes(out)


class Hdr:
    """Radiance RGBE, flat or run-length; values as RGB floats."""

    def __init__(self, data):
        assert data.startswith(b"#?")
        header, body = data.split(b"\n\n", 1)
        self.header = header.decode()
        size, body = body.split(b"\n", 1)
        sign_y, height, sign_x, width = size.split()
        assert (sign_y, sign_x) == (b"-Y", b"+X")
        self.width, self.height = int(width), int(height)
        self.values = []
        for _ in range(self.height):
            row, body = self._row(body)
            for r, g, b, e in zip(*row):
                scale = 2.0 ** (e - 136) if e else 0.0
                self.values += [r * scale, g * scale, b * scale]
        assert not body

    def _row(self, body):
        if body[:2] != b"\x02\x02" or not 8 <= self.width < 32768:
            flat = body[:4 * self.width]
            return [flat[c::4] for c in range(4)], body[4 * self.width:]
        assert struct.unpack(">H", body[2:4])[0] == self.width
        body, planes = body[4:], []
        for _ in range(4):
            plane = bytearray()
            while len(plane) < self.width:
                count = body[0]
                if count > 128:
                    plane += body[1:2] * (count - 128)
                    body = body[2:]
                else:
                    plane += body[1:1 + count]
                    body = body[1 + count:]
            planes.append(plane)
        return planes, body


class Exr:
    """Scan lines, 32-bit channels, no or ZIP compression. `channels` has each as bytes, top row
    first; `attributes` the text ones."""

    def __init__(self, data):
        assert data[:4] == b"\x76\x2f\x31\x01" and data[4] == 2
        position, self.attributes, header = 8, {}, {}
        while data[position]:
            name, position = self._text(data, position)
            kind, position = self._text(data, position)
            size, = struct.unpack("<i", data[position:position + 4])
            value = data[position + 4:position + 4 + size]
            position += 4 + size
            header[name] = value
            if kind == "string":
                self.attributes[name] = value.decode()
        x0, y0, x1, y1 = struct.unpack("<4i", header["dataWindow"])
        self.width, self.height = x1 - x0 + 1, y1 - y0 + 1
        compression = header["compression"][0]
        lines = {0: 1, 2: 1, 3: 16}[compression]
        self.types = self._channel_list(header["channels"])
        blocks = (self.height + lines - 1) // lines
        offsets = struct.unpack(f"<{blocks}Q", data[position + 1:position + 1 + 8 * blocks])
        rows = {name: [b""] * self.height for name in self.types}
        for offset in offsets:
            y, size = struct.unpack("<ii", data[offset:offset + 8])
            block = data[offset + 8:offset + 8 + size]
            count = min(lines, y1 + 1 - y)
            raw_size = count * self.width * 4 * len(self.types)
            if compression and size < raw_size:
                block = self._unzip(block)
            assert len(block) == raw_size
            for line in range(count):
                for name in sorted(self.types):
                    rows[name][y - y0 + line], block = block[:4 * self.width], block[
                        4 * self.width:]
        self.channels = {name: b"".join(parts) for name, parts in rows.items()}

    def floats(self, name):
        return struct.unpack(f"<{self.width * self.height}f", self.channels[name])

    def integers(self, name):
        return struct.unpack(f"<{self.width * self.height}I", self.channels[name])

    @staticmethod
    def _text(data, position):
        end = data.index(b"\0", position)
        return data[position:end].decode(), end + 1

    def _channel_list(self, data):
        types, position = {}, 0
        while data[position]:
            name, position = self._text(data, position)
            types[name], = struct.unpack("<i", data[position:position + 4])
            assert types[name] in (0, 2), "only 32-bit channels"
            position += 16
        return types

    @staticmethod
    def _unzip(block):
        raw = bytearray(zlib.decompress(block))
        for i in range(1, len(raw)):
            raw[i] = (raw[i - 1] + raw[i] - 128) & 255
        half = (len(raw) + 1) // 2
        out = bytearray(len(raw))
        out[0::2], out[1::2] = raw[:half], raw[half:]
        return bytes(out)


def exr_bytes(width, height, rgb):
    """An OpenEXR file without compression; `rgb` are floats, row by row, NaN and infinity too."""
    def attribute(name, kind, value):
        return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<I", len(value)) + value

    channels = b"".join(name + b"\0" + struct.pack("<IIII", 2, 0, 1, 1) for name in (b"B", b"G", b"R"))
    window = struct.pack("<iiii", 0, 0, width - 1, height - 1)
    head = b"\x76\x2f\x31\x01\x02\0\0\0" + b"".join([
        attribute("channels", "chlist", channels + b"\0"), attribute("compression", "compression", b"\0"),
        attribute("dataWindow", "box2i", window), attribute("displayWindow", "box2i", window),
        attribute("lineOrder", "lineOrder", b"\0"),
        attribute("pixelAspectRatio", "float", struct.pack("<f", 1)),
        attribute("screenWindowCenter", "v2f", struct.pack("<ff", 0, 0)),
        attribute("screenWindowWidth", "float", struct.pack("<f", 1))]) + b"\0"
    row_bytes = 8 + 12 * width
    start = len(head) + 8 * height
    offsets = b"".join(struct.pack("<Q", start + y * row_bytes) for y in range(height))
    rows = b""
    for y in range(height):
        row = rgb[3 * width * y:3 * width * (y + 1)]
        rows += struct.pack("<iI", y, 12 * width)
        rows += b"".join(struct.pack(f"<{width}f", *row[c::3]) for c in (2, 1, 0))
    return head + offsets + rows
