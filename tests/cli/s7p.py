"""A small STEP 7 project as files (docs/formats/s7p.md), for the tests of `merker import`."""
import io
import struct
import zipfile


def table(columns, rows):
    length = 1 + sum(size for _, _, size in columns)
    out = b"\x03\x18\x01\x01" + struct.pack("<IHH", len(rows), 33 + 32 * len(columns), length) + bytes(20)
    for name, kind, size in columns:
        out += name.encode().ljust(11, b"\0") + kind.encode() + bytes(4) + bytes([size]) + bytes(15)
    out += b"\r"
    for row in rows:
        out += b" "
        for name, kind, size in columns:
            value = row.get(name, b"")
            value = value if isinstance(value, bytes) else str(value).encode()
            out += value[:size].ljust(size) if kind == "C" else value[:size].rjust(size)
    return out + b"\x1a"


class Memo:
    def __init__(self):
        self.bytes = bytes(20) + struct.pack("<H", 512) + bytes(490)

    def add(self, content):
        number = len(self.bytes) // 512
        self.bytes += b"\xff\xff\x08\0" + struct.pack("<I", len(content) + 8) + content
        self.bytes += bytes(-len(self.bytes) % 512)
        return number


BLOCK = [("OBJECTID", "N", 11), ("BLKLANG", "C", 5), ("SUBBLKTYP", "C", 5), ("BLKNUMBER", "C", 5), ("ATTRIBUTE", "N", 3),
         ("MC5LEN", "N", 11), ("SSBLEN", "N", 11), ("ADDLEN", "N", 11), ("LOCDATALEN", "N", 5), ("TIMESTAMP1", "C", 6),
         ("PASSWORD", "N", 11), ("VERSION", "N", 3), ("CHECKSUM", "N", 5), ("MC5CODE", "M", 10), ("SSBPART", "M", 10),
         ("ADDINFO", "M", 10)]
OB, FC = 8, 12
NO_INTERFACE = b"\x01\0\0\0\0\0\0\0"


def blocks(parts):
    """SUBBLK.DBF and .DBT of (type, number, machine code, attributes of the row)."""
    memo, rows = Memo(), []
    for object_id, (kind, number, code, more) in enumerate(parts, 1):
        rows.append({"OBJECTID": object_id, "BLKLANG": "00001", "SUBBLKTYP": f"{kind:05}", "BLKNUMBER": f"{number:05}",
                     "ATTRIBUTE": 1, "MC5LEN": len(code), "MC5CODE": memo.add(code), "SSBLEN": len(NO_INTERFACE),
                     "SSBPART": memo.add(NO_INTERFACE), "LOCDATALEN": 20, "VERSION": 1, **more})
    return table(BLOCK, rows), memo.bytes


def project(parts, symbols=(), page="1252"):
    dbf, dbt = blocks(parts)
    links = bytes(512) + struct.pack("<4I", 512, 0, 2, 0) + struct.pack("<6I", 0, 0, 0x116001, 1, 30, 0) + \
        struct.pack("<6I", 0, 0, 0x113001, 7, 24, 0)
    return {"Plant.s7p": bytes(4) + b"\x05Plant" + bytes(4),
            "Global/Language": f"0\r\n1031\r\n204\r\n{page}\r\n850\r\n".encode(),
            "hrs/S7RESOFF.DBF": table([("ID", "N", 11), ("NAME", "C", 24), ("RSRVD4_L", "N", 11)],
                                      [{"ID": 1, "NAME": "Line 1", "RSRVD4_L": 512}]),
            "hrs/linkhrs.lnk": links.ljust(1024, b"\0"),
            "OMBSTX/offline/00000001/SUBBLK.DBF": dbf, "ombstx/offline/00000001/subblk.dbt": dbt,
            "YDBs/7/SYMLIST.DBF": table([("_SKZ", "C", 24), ("_OPHIST", "C", 12), ("_DATATYP", "C", 10),
                                         ("_COMMENT", "C", 80)], list(symbols))}


def zipped(files):
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(name, content)
    return out.getvalue()
