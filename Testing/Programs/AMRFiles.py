# SPDX-License-Identifier: BSD-3-Clause
"""Writes small data sets to damage: an AMReX plotfile, an Enzo hierarchy and a .vthb, all with the same cells.

8^3 cells, of which the middle ones are refined once more, in two boxes. Nothing but Python is needed.
"""

import base64
import pathlib
import struct
import zlib

BOXES = [[((0, 0, 0), (7, 7, 7))], [((4, 4, 4), (7, 11, 11)), ((8, 4, 4), (11, 11, 11))]]  # of each level
WIDTH = 0.125


def values(level, box):
    """Of each cell of a box, x fastest."""
    lo, hi = box
    width = WIDTH / 2**level
    return [1.0 + width * (x + 0.5 + 2.0 * (y + 0.5) * width * (z + 0.5))
            for z in range(lo[2], hi[2] + 1) for y in range(lo[1], hi[1] + 1) for x in range(lo[0], hi[0] + 1)]


def size(box):
    return [hi - lo + 1 for lo, hi in zip(*box)]


def write_plotfile(folder):
    """One of AMReX; returns its path, the folder."""
    folder = pathlib.Path(folder)
    text = lambda box: "({} {} (0,0,0))".format(*("(" + ",".join(map(str, corner)) + ")" for corner in box))
    header = ["HyperCLaw-V1.1", "1", "density", "3", "0.5", "1", "0 0 0", "1 1 1", "2",
              text(((0, 0, 0), (7, 7, 7))) + " " + text(((0, 0, 0), (15, 15, 15))), "3 6",
              "0.125 0.125 0.125", "0.0625 0.0625 0.0625", "0", "0"]
    for level, boxes in enumerate(BOXES):
        width = WIDTH / 2**level
        header += [f"{level} {len(boxes)} 0.5", "3"]
        header += [f"{lo[axis] * width} {(hi[axis] + 1) * width}" for lo, hi in boxes for axis in range(3)]
        header.append(f"Level_{level}/Cell")
        place = folder / f"Level_{level}"
        place.mkdir(parents=True)
        data, offsets = b"", []
        for box in boxes:
            offsets.append(len(data))
            data += ("FAB ((8, (64 11 52 0 1 12 0 1023)),(8, (8 7 6 5 4 3 2 1)))" + text(box) + " 1\n").encode()
            cells = values(level, box)
            data += struct.pack(f"<{len(cells)}d", *cells)
        (place / "Cell_D_00000").write_bytes(data)
        lines = ["1", "1", "1", "0", f"({len(boxes)} 0", *map(text, boxes), ")", str(len(boxes))]
        lines += [f"FabOnDisk: Cell_D_00000 {offset}" for offset in offsets]
        lines += ["", f"{len(boxes)},1", *["1.0,"] * len(boxes), "", f"{len(boxes)},1", *["2.0,"] * len(boxes), ""]
        (place / "Cell_H").write_text("\n".join(lines))
    (folder / "Header").write_text("\n".join(header) + "\n")
    return folder


class HDF5Writer:
    """A file of groups, each with sets of doubles: as old versions of HDF5 write it, and Enzo still."""

    def __init__(self):
        self.data = bytearray(96)  # the superblock, which is written last

    def add(self, data):
        self.data += b"\0" * (-len(self.data) % 8)
        self.data += data
        return len(self.data) - len(data)

    def add_object(self, messages):
        """Its header, with each message's type and data."""
        messages = [(kind, data + b"\0" * (-len(data) % 8)) for kind, data in messages]
        body = b"".join(struct.pack("<HHB3x", kind, len(data), 0) + data for kind, data in messages)
        return self.add(struct.pack("<BxHII4x", 1, len(messages), 1, len(body)) + body)

    def add_doubles(self, cells, shape):
        place = self.add(struct.pack(f"<{len(cells)}d", *cells))
        return self.add_object([
            (1, struct.pack(f"<BBB5x{len(shape)}Q", 1, len(shape), 0, *shape)),
            (3, struct.pack("<B3BIHHBBBBI", 0x11, 0x20, 63, 0, 8, 0, 64, 52, 11, 0, 52, 1023)),
            (8, struct.pack("<BBQQ", 3, 1, place, 8 * len(cells)))])

    def add_group(self, members):
        """Of eight members at most; `members`: their names, in order, and places."""
        names, offsets = bytearray(8), []
        for name in members:
            offsets.append(len(names))
            names += name.encode() + b"\0" * (8 - len(name) % 8)
        heap = self.add(struct.pack("<4sB3xQQQ", b"HEAP", 0, len(names), 1, self.add(bytes(names))))
        table = b"".join(struct.pack("<QQII16x", offset, place, 0, 0) for offset, place in zip(offsets, members.values()))
        node = self.add(struct.pack("<4sBBH", b"SNOD", 1, 0, len(members)) + table.ljust(8 * 40, b"\0"))
        none = 2**64 - 1
        tree = struct.pack("<4sBBHQQQQQ", b"TREE", 0, 0, 1, none, none, 0, node, offsets[-1])
        tree = self.add(tree.ljust(24 + 8 * 65, b"\0"))
        return self.add_object([(17, struct.pack("<QQ", tree, heap))])

    def write(self, path, root):
        none = 2**64 - 1
        self.data[:96] = struct.pack("<8s8BHHIQQQQQQII16x", b"\x89HDF\r\n\x1a\n", 0, 0, 0, 0, 0, 8, 8, 0, 4, 16, 0,
                                     0, none, len(self.data), none, 0, root, 0, 0)
        path.write_bytes(bytes(self.data))


def write_enzo(folder):
    """One of Enzo, with its grids in two files; returns the path of its hierarchy."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True)
    grids = [(level, box) for level, boxes in enumerate(BOXES) for box in boxes]
    files = [{}, {}]
    lines = []
    for number, (level, box) in enumerate(grids, 1):
        width, cells, file = WIDTH / 2**level, size(box), int(number == 3)
        row = lambda numbers: " ".join(f"{number:g}" for number in numbers)
        lines += ["", f"Grid = {number}", f"Task              = {file}", "GridRank          = 3",
                  "GridDimension     = " + row(n + 6 for n in cells), "GridStartIndex    = 3 3 3",
                  "GridEndIndex      = " + row(n + 2 for n in cells),
                  "GridLeftEdge      = " + row(width * lo for lo in box[0]),
                  "GridRightEdge     = " + row(width * (hi + 1) for hi in box[1]), "Time              = 0.5",
                  "SubgridsAreStatic = 0", "NumberOfBaryonFields = 1", "FieldType = 0",
                  f"BaryonFileName = ./DD0003/data0003.cpu000{file}", "CourantSafetyNumber    = 0.300000",
                  f"NumberOfParticles   = {int(number == 2)}"]
        lines += [f"ParticleFileName = ./DD0003/data0003.cpu000{file}"] * (number == 2)
        lines += ["GravityBoundaryType = 0", f"Pointer: Grid[{number}]->NextGridThisLevel = {3 if number == 2 else 0}"]
        lines += ["Pointer: Grid[1]->NextGridNextLevel = 2"] if number == 1 else []
        files[file][number] = (values(level, box), cells[::-1])
    lines += ["Pointer: Grid[3]->NextGridNextLevel = 0", "Pointer: Grid[2]->NextGridNextLevel = 0", ""]
    path = folder / "data0003.hierarchy"
    path.write_text("\n".join(lines))
    (folder / "data0003").write_text("\n".join([
        "InitialCycleNumber  = 3", "InitialTime         = 0.5", "", "TopGridRank         = 3", "TopGridDimensions   = 8 8 8",
        "RefineBy               = 2", "DomainLeftEdge         = 0 0 0", "DomainRightEdge        = 1 1 1", "",
        "DataLabel[0]              = Density", "#DataCGSConversionFactor[0] = 0.25", "", "VersionNumber              = 2.6", ""]))
    for file, members in enumerate(files):
        hdf = HDF5Writer()
        groups = {f"Grid{number:08}": hdf.add_group({"Density": hdf.add_doubles(*grid)}) for number, grid in members.items()}
        hdf.write(folder / f"data0003.cpu000{file}", hdf.add_group(groups))
    return path


ENCODINGS = ("raw", "compressed", "base64", "base64 compressed", "binary", "binary compressed", "ascii")


def encode(cells, encoding, text=False):
    """An array's data; of compressed ones in parts of 1000 bytes."""
    data = struct.pack(f"<{len(cells)}d", *cells)
    code = base64.b64encode if text else bytes
    if "compressed" not in encoding:
        return code(struct.pack("<I", len(data)) + data)
    parts = [zlib.compress(data[begin:begin + 1000]) for begin in range(0, len(data), 1000)]
    head = struct.pack(f"<{3 + len(parts)}I", len(parts), 1000, len(data) % 1000, *map(len, parts))
    return code(head) + code(b"".join(parts))


def write_vti(path, level, box, encoding):
    width, cells = WIDTH / 2**level, size(box)
    extent = " ".join(f"0 {n}" for n in cells)
    inline = encoding.startswith(("binary", "ascii"))
    arrays, appended = [], b""
    for name, factor in (("density", 1.0), ("pressure", 2.0)):
        numbers = [factor * value for value in values(level, box)]
        attributes = f'type="Float64" Name="{name}"'
        if inline:
            data = " ".join(map(repr, numbers)) if encoding == "ascii" else encode(numbers, encoding, True).decode()
            arrays.append(f'        <DataArray {attributes} format="{encoding.split()[0]}">\n          {data}\n        </DataArray>')
        else:
            arrays.append(f'        <DataArray {attributes} format="appended" offset="{len(appended)}"/>')
            appended += encode(numbers, encoding, encoding.startswith("base64"))
    compressor = ' compressor="vtkZLibDataCompressor"' if "compressed" in encoding else ""
    origin = " ".join(f"{width * lo:g}" for lo in box[0])
    lines = [f'<VTKFile type="ImageData" version="0.1" byte_order="LittleEndian" header_type="UInt32"{compressor}>',
             f'  <ImageData WholeExtent="{extent}" Origin="{origin}" Spacing="{width} {width} {width}">',
             f'    <Piece Extent="{extent}">', "      <PointData>", "      </PointData>", "      <CellData>", *arrays,
             "      </CellData>", "    </Piece>", "  </ImageData>"]
    data = "\n".join(lines).encode()
    if not inline:
        data += f'\n  <AppendedData encoding="{"base64" if encoding.startswith("base64") else "raw"}">\n   _'.encode()
        data += appended + b"\n  </AppendedData>"
    path.write_bytes(data + b"\n</VTKFile>\n")


def write_vthb(folder, encoding="raw"):
    """One of VTK, with the data encoded in one of the ENCODINGS; returns the path of its .vthb."""
    folder = pathlib.Path(folder)
    (folder / "data").mkdir(parents=True)
    lines = ['<VTKFile type="vtkOverlappingAMR" version="1.1" byte_order="LittleEndian" header_type="UInt32">',
             '  <vtkOverlappingAMR origin="0 0 0" grid_description="XYZ">']
    count = 0
    for level, boxes in enumerate(BOXES):
        width = WIDTH / 2**level
        lines.append(f'    <Block level="{level}" spacing="{width} {width} {width}">')
        for index, box in enumerate(boxes):
            numbers = " ".join(f"{lo} {hi}" for lo, hi in zip(*box))
            file = f"data/data_{count}.vti"
            lines.append(f'      <DataSet index="{index}" amr_box="{numbers}" file="{file}"/>')
            write_vti(folder / file, level, box, encoding)
            count += 1
        lines.append("    </Block>")
    time = base64.b64encode(struct.pack("<Id", 8, 0.5)).decode()
    lines += ["  </vtkOverlappingAMR>", "  <FieldData>",
              '    <DataArray type="Float64" Name="TimeValue" NumberOfTuples="1" format="binary">', f"      {time}",
              "    </DataArray>", "  </FieldData>", "</VTKFile>", ""]
    path = folder / "data.vthb"
    path.write_text("\n".join(lines))
    return path
