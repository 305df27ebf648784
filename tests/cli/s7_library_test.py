"""libmerker-s7 from C and Python against `merker run --s7` (lib/merker-s7/merker_s7.h, S7-NET-21)."""
import ctypes
import os
import pathlib
import struct
import subprocess

from s7_client import S7Case

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples"
SAMPLE = pathlib.Path(os.environ["MERKER"]).parent / "lib" / "merker-s7" / "s7_vessel"
AREAS = SAMPLE.with_name("s7_areas")
LIBRARY = pathlib.Path(os.environ["MERKER"]).parent / "libmerker-s7.so"
PE, PA, MK, DB, CT, TM = 0x81, 0x82, 0x83, 0x84, 0x1C, 0x1D
BIT, BYTE, WORD, REAL = 1, 2, 4, 8
PORT, RECEIVE_TIMEOUT, PDU = 2, 5, 10
PLANT = """DATA_BLOCK DB 1
STRUCT
  row : ARRAY [0..999] OF BYTE;
END_STRUCT
BEGIN
END_DATA_BLOCK
ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      U     M 10.1
      =     A 4.0
      UN    M 10.2
      L     S5T#5S
      SE    T 3
      U     M 10.3
      L     C#42
      S     Z 7
END_ORGANIZATION_BLOCK
"""


class Item(ctypes.Structure):
    _fields_ = [(name, ctypes.c_int) for name in ("area", "word_len", "result", "db", "start", "amount")]
    _fields_ += [("data", ctypes.c_void_p)]


class Client:
    def __init__(self, port, **parameters):
        self.library = ctypes.CDLL(str(LIBRARY))
        self.library.Cli_Create.restype = ctypes.c_size_t
        self.object = ctypes.c_size_t(self.library.Cli_Create())
        self.set(PORT, ctypes.c_uint16(port))

    def set(self, number, value):
        assert self.call("SetParam", number, ctypes.byref(value)) == 0

    def call(self, name, *arguments):
        return getattr(self.library, "Cli_" + name)(self.object, *arguments)

    def read(self, name, *arguments, size):
        data = ctypes.create_string_buffer(size)
        error = self.call(name, *arguments, data)
        assert error == 0, hex(error)
        return data.raw

    def close(self):
        self.library.Cli_Destroy(ctypes.byref(self.object))


class Library(S7Case):
    def setUp(self):
        super().setUp()
        self.write("plant.awl", PLANT)
        self.process = self.start("plant.awl", "--no-workbench")
        self.plc = self.library()
        self.assertEqual(self.plc.call("ConnectTo", b"127.0.0.1", 0, 2), 0)

    def library(self):
        client = Client(self.port)
        self.addCleanup(client.close)
        return client

    def test_data_blocks_longer_than_a_pdu(self):
        requested, agreed = ctypes.c_int(), ctypes.c_int()
        self.plc.call("GetPduLength", ctypes.byref(requested), ctypes.byref(agreed))
        self.assertEqual((requested.value, agreed.value), (480, 240))
        text = bytes(i * 7 % 256 for i in range(1000))
        self.assertEqual(self.plc.call("DBWrite", 1, 0, 1000, text), 0)
        self.assertEqual(self.plc.read("DBRead", 1, 0, 1000, size=1000), text)
        self.assertEqual(self.plc.read("ReadArea", DB, 1, 995, 1, REAL, size=4), text[995:999])

    def test_every_area(self):
        bit = ctypes.c_uint8(1)
        self.assertEqual(self.plc.call("WriteArea", MK, 0, 81, 1, BIT, ctypes.byref(bit)), 0)
        self.until(lambda: self.plc.read("ABRead", 4, 1, size=1) == b"\1")
        self.assertEqual(self.plc.call("MBWrite", 10, 1, b"\x0a"), 0)  # M 10.1 and M 10.3
        self.until(lambda: self.plc.read("CTRead", 7, 1, size=2) == b"\0\x42")
        self.assertNotEqual(self.plc.read("TMRead", 3, 1, size=2), b"\0\0")
        self.assertEqual(self.plc.read("EBRead", 0, 2, size=2), b"\0\0")
        self.assertEqual(self.plc.read("MBRead", 10, 1, size=1), b"\x0a")

    def test_many_variables_in_one_request(self):
        first, second, third = (ctypes.create_string_buffer(n) for n in (4, 1, 1))
        struct.pack_into(">f", first, 0, 1.5)
        items = (Item * 3)(Item(DB, REAL, -1, 1, 8, 1, ctypes.addressof(first)),
                           Item(MK, BYTE, -1, 0, 30, 1, ctypes.addressof(second)),
                           Item(DB, BYTE, -1, 99, 0, 1, ctypes.addressof(third)))
        self.assertEqual(self.plc.call("WriteMultiVars", items, 3), 0)
        self.assertEqual([item.result for item in items], [0, 0, 0x00C00000])
        first.value = b""
        self.assertEqual(self.plc.call("ReadMultiVars", items, 3), 0)
        self.assertEqual(struct.unpack(">f", first.raw)[0], 1.5)
        self.assertEqual(self.plc.call("ReadMultiVars", items, 21), 0x00400000)

    def test_errors_are_sentences(self):
        text = ctypes.create_string_buffer(100)
        one = ctypes.create_string_buffer(8)
        for error, call in ((0x00C00000, ("DBRead", 2, 0, 4, one)), (0x00900000, ("DBRead", 1, 998, 4, one)),
                            (0x00200000, ("ReadArea", 0x99, 0, 0, 1, BYTE, one)),
                            (0x00500000, ("ReadArea", MK, 0, 0, 2, BIT, one)),
                            (0x00200000, ("MBRead", -1, 1, one)), (0x00200000, ("DBRead", 1, 0, 70000, one))):
            self.assertEqual(self.plc.call(*call), error, call)
            self.plc.library.Cli_ErrorText(error, text, len(text))
            self.assertNotIn(b"unknown", text.value)
        self.plc.library.Cli_ErrorText(0x00C00000, text, 9)
        self.assertEqual(text.value, b"the data")

    DB_BLOCK = 0x41

    def test_blocks(self):
        size, container = ctypes.c_int(4096), ctypes.create_string_buffer(4096)
        self.assertEqual(self.plc.call("FullUpload", self.DB_BLOCK, 1, container, ctypes.byref(size)), 0)
        self.assertEqual(container.raw[:2], b"\x70\x70")
        self.assertEqual(self.plc.call("Download", 9, container, size), 0)
        self.assertEqual(self.plc.call("DBWrite", 9, 998, 2, b"\x12\x34"), 0)
        length = ctypes.c_int(1000)
        values = ctypes.create_string_buffer(1000)
        self.assertEqual(self.plc.call("Upload", self.DB_BLOCK, 9, values, ctypes.byref(length)), 0)
        self.assertEqual((length.value, values.raw[-2:]), (1000, b"\x12\x34"))
        self.assertEqual(self.plc.call("Upload", self.DB_BLOCK, 9, values, ctypes.byref(ctypes.c_int(999))), 0x02200000)
        self.assertEqual(self.plc.call("Delete", self.DB_BLOCK, 9), 0)
        self.assertEqual(self.plc.call("Delete", self.DB_BLOCK, 9), 0x01C00000)
        self.assertEqual(self.plc.call("FullUpload", self.DB_BLOCK, 9, container, ctypes.byref(size)), 0x01500000)
        container[40] = b"\xAA"  # its checksum is wrong
        self.assertEqual(self.plc.call("Download", 9, container, size), 0x01A00000)
        self.assertEqual(self.plc.call("Download", -1, container, 10), 0x01900000)
        self.assertEqual(self.plc.call("Delete", 0x99, 9), 0x01800000)

    def test_directory(self):
        counts = (ctypes.c_int * 7)()  # OB FB FC SFB SFC DB SDB
        self.assertEqual(self.plc.call("ListBlocks", counts), 0)
        self.assertEqual((counts[0], counts[1], counts[5], counts[6]), (1, 0, 1, 2))
        numbers, count = (ctypes.c_uint16 * 8192)(), ctypes.c_int(8192)
        self.assertEqual(self.plc.call("ListBlocksOfType", 0x44, numbers, ctypes.byref(count)), 0)
        self.assertEqual(count.value, counts[4])  # more than a PDU holds
        self.assertIn(51, numbers[:count.value])
        self.assertEqual(self.plc.call("ListBlocksOfType", 0x45, numbers, ctypes.byref(count)), 0x00C00000)
        size, container = ctypes.c_int(4096), ctypes.create_string_buffer(4096)
        self.assertEqual(self.plc.call("FullUpload", self.DB_BLOCK, 1, container, ctypes.byref(size)), 0)
        there, here = (ctypes.create_string_buffer(92) for _ in range(2))
        self.assertEqual(self.plc.call("GetAgBlockInfo", self.DB_BLOCK, 1, there), 0)
        self.assertEqual(struct.unpack_from("10i", there)[:6], (0x0A, 1, 5, 1, 1000, size.value))
        self.assertEqual(there.raw[40:51], b"1984/01/01\0")
        self.assertEqual(self.plc.call("GetPgBlockInfo", container, here, size), 0)
        self.assertEqual(here.raw, there.raw)
        self.assertEqual(self.plc.call("GetPgBlockInfo", container, here, 10), 0x01900000)
        self.assertEqual(self.plc.call("GetAgBlockInfo", self.DB_BLOCK, 7, there), 0x00C00000)

    def test_whole_data_blocks(self):
        self.assertEqual(self.plc.call("DBFill", 1, 0xA5), 0)
        size, values = ctypes.c_int(2000), ctypes.create_string_buffer(2000)
        self.assertEqual(self.plc.call("DBGet", 1, values, ctypes.byref(size)), 0)
        self.assertEqual((size.value, values.raw[:1000]), (1000, b"\xA5" * 1000))
        self.assertEqual(self.plc.call("DBGet", 1, values, ctypes.byref(ctypes.c_int(999))), 0x02200000)
        self.assertEqual(self.plc.call("DBFill", 2, 0), 0x00C00000)

    def test_what_the_cpu_is(self):
        code, cpu, cp, levels = (ctypes.create_string_buffer(size) for size in (24, 135, 16, 10))
        self.assertEqual(self.plc.call("GetOrderCode", code), 0)
        self.assertEqual((code.value, code.raw[21:]), (b"6ES7 314-6BF01-0AB0", b"\2\0\0"))
        self.assertEqual(self.plc.call("GetCpuInfo", cpu), 0)
        self.assertEqual([cpu.raw[at:].split(b"\0")[0] for at in (0, 33, 58, 83, 110)],
                         [b"CPU 314C-2 PtP", b"SIMULATED", b"Merker", b"Merker", b"CPU 314C-2 PtP"])
        self.assertEqual(self.plc.call("GetCpInfo", cp), 0)
        self.assertEqual(struct.unpack("4i", cp), (240, 12, 187500, 0))
        self.assertEqual(self.plc.call("GetProtection", levels), 0)
        self.assertEqual(struct.unpack("5H", levels), (1, 0, 1, 2, 0))
        status = ctypes.c_int()
        for stop, expected in ((False, 8), (True, 4)):
            if stop:
                self.plc.call("PlcStop")
            self.assertEqual(self.plc.call("GetPlcStatus", ctypes.byref(status)), 0)
            self.assertEqual(status.value, expected)

    def test_system_status_lists(self):
        found, size = ctypes.create_string_buffer(0x4000), ctypes.c_int(0x4000)
        self.assertEqual(self.plc.call("ReadSZL", 0x001C, 0, found, ctypes.byref(size)), 0)
        length, records = struct.unpack_from("2H", found)
        self.assertEqual((length, size.value), (34, 4 + 34 * records))
        self.assertGreaterEqual(records, 6)
        self.assertEqual(found.raw[4:8], b"\0\1Me")
        self.assertEqual(self.plc.call("ReadSZL", 0x001C, 0, found, ctypes.byref(ctypes.c_int(size.value - 1))), 0x02200000)
        self.assertEqual(self.plc.call("ReadSZL", 0x0023, 0, found, ctypes.byref(size)), 0x00C00000)
        count = ctypes.c_int(0x1FFE)
        self.assertEqual(self.plc.call("ReadSZLList", found, ctypes.byref(count)), 0)
        self.assertIn(0x0132, struct.unpack_from(f"{count.value}H", found, 4))

    def test_the_clock(self):
        time = (ctypes.c_int * 16)(5, 4, 3, 24, 11, 124, 2)  # Tuesday, 24 December 2024, 03:04:05
        self.assertEqual(self.plc.call("SetPlcDateTime", time), 0)
        read = (ctypes.c_int * 16)()
        self.assertEqual(self.plc.call("GetPlcDateTime", read), 0)
        self.assertEqual(read[2:7], time[2:7])
        time[4] = 12  # there is no such month
        self.assertEqual(self.plc.call("SetPlcDateTime", time), 0x00D00000)
        self.assertEqual(self.plc.call("SetPlcSystemDateTime"), 0)
        self.assertEqual(self.plc.call("GetPlcDateTime", read), 0)
        self.assertGreaterEqual(read[5], 126)

    def test_a_password(self):
        self.end(self.process)
        self.write("plant/merker.toml", '[cpu]\nprotection = 3\npassword = "secret"\n')
        self.write("plant/plant.awl", PLANT)
        self.process = self.start("plant", "--no-workbench")
        plc = self.library()
        self.assertEqual(plc.call("ConnectTo", b"127.0.0.1", 0, 2), 0)
        self.assertEqual(plc.call("ClearSessionPassword"), 0x01F00000)
        self.assertEqual(plc.call("PlcStop"), 0x01D00000)
        self.assertEqual(plc.call("SetSessionPassword", b"other"), 0x01E00000)
        self.assertEqual(plc.call("SetSessionPassword", b"too long for it"), 0x00200000)
        self.assertEqual(plc.call("SetSessionPassword", b"secret"), 0)
        self.assertEqual(plc.call("PlcStop"), 0)
        self.assertEqual(plc.call("ClearSessionPassword"), 0)
        self.assertEqual(plc.call("PlcHotStart"), 0x01D00000)

    def test_control(self):
        self.assertEqual(self.plc.call("Compress", 1000), 0)
        self.assertEqual(self.plc.call("CopyRamToRom", 1000), 0x01100000)
        self.assertEqual(self.plc.call("PlcHotStart"), 0x00F00000)
        self.assertEqual(self.plc.call("PlcStop"), 0)
        self.assertEqual(self.plc.call("PlcStop"), 0x01300000)
        self.assertEqual(self.plc.call("CopyRamToRom", 1000), 0)
        self.assertEqual(self.plc.call("PlcColdStart"), 0x00E00000)
        self.assertEqual(self.plc.call("PlcHotStart"), 0)

    def test_who_is_not_there(self):
        other = self.library()
        one = ctypes.create_string_buffer(1)
        self.assertEqual(other.call("MBRead", 0, 1, one), 9)
        other.set(PORT, ctypes.c_uint16(1))
        self.assertEqual(other.call("ConnectTo", b"127.0.0.1", 0, 2), 3)
        self.process.kill()
        self.process.wait()
        self.assertIn(self.plc.call("MBRead", 0, 1, one), (5, 7, 8))
        self.assertEqual(self.plc.call("MBRead", 0, 1, one), 9)


class Sample(S7Case):
    def test_the_vessel(self):
        self.start(str(EXAMPLES / "vessel-emptying"), "--no-workbench")
        done = subprocess.run([SAMPLE, "127.0.0.1", str(self.port), "3"], capture_output=True, text=True, timeout=60)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("Stop           1\n", done.stdout)
        nobody = subprocess.run([SAMPLE, "127.0.0.1", "1", "1"], capture_output=True, text=True, timeout=60)
        self.assertEqual(nobody.returncode, 1)
        self.assertEqual(nobody.stderr, "connecting: no connection: address not found, or nobody listens at the port\n")

    def test_areas_by_their_operands(self):
        self.start(str(EXAMPLES / "vessel-emptying"), "--no-workbench")
        call = lambda *operands: subprocess.run([AREAS, "127.0.0.1", str(self.port), *operands], capture_output=True, text=True, timeout=60)
        done = call("MW200=513", "M200.1", "MB201", "E0.1", "T1", "Z1=0x123")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(done.stdout.splitlines(), ["MW200 = 513 (16#0201)", "M200.1 = 1 (16#01)", "MB201 = 1 (16#01)",
                                                    "E0.1 = 1 (16#01)", "T1 = 0 (16#0000)", "Z1 = 291 (16#0123)"])
        self.assertEqual(call("DB99.DBW0").stderr, "DB99.DBW0: the data block, block or system status list does not exist\n")
        self.assertEqual(call("X5").returncode, 2)
