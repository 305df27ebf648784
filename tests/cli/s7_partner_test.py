"""Configured connections of the built program: a partner that calls, what diag says of them, and what Wireshark says of BSEND."""
from s7_client import *
from wireshark import BAD, Capture, Recorded

# M 0.0: BSEND of 400 bytes, R_ID 9; BRCV for R_ID 7 all the time. M 0.1: USEND, R_ID 11; URCV for R_ID 12.
BLOCKS = """DATA_BLOCK DB 1
STRUCT
 a : ARRAY [0..999] OF BYTE;
END_STRUCT
BEGIN
 a[0] := B#16#A1; a[399] := B#16#B2;
END_DATA_BLOCK
DATA_BLOCK DB 12
SFB 12
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 13
SFB 13
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 8
SFB 8
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 9
SFB 9
BEGIN
END_DATA_BLOCK
ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
 CALL SFB 8, DB 8 (REQ := M 0.1, ID := W#16#2, R_ID := DW#16#B, DONE := M 1.1, SD_1 := P#DB1.DBX 0.0 BYTE 3, SD_2 := P#M 30.0 WORD 1);
 U M 1.1; SPBN d; L MB 21; + 1; T MB 21;
d: CALL SFB 9, DB 9 (EN_R := TRUE, ID := W#16#2, R_ID := DW#16#C, NDR := M 1.2, RD_1 := P#M 40.0 BYTE 4, RD_2 := P#M 45.3 BOOL 1);
 U M 1.2; SPBN n; L MB 22; + 1; T MB 22;
n: NOP 0;
 L 400; T MW 10;
 CALL SFB 12, DB 12 (REQ := M 0.0, ID := W#16#2, R_ID := DW#16#9, STATUS := MW 12, SD_1 := P#DB1.DBX 0.0 BYTE 1000, LEN := MW 10);
 CALL SFB 13, DB 13 (EN_R := TRUE, ID := W#16#2, R_ID := DW#16#7, NDR := M 1.0, STATUS := MW 14, RD_1 := P#DB1.DBX 500.0 BYTE 500, LEN := MW 16);
 U M 1.0; SPBN e; L MB 20; + 1; T MB 20;
e: NOP 0;
END_ORGANIZATION_BLOCK
"""
PROJECT = """[cpu]
model = "generic"
[[connection]]
id = "W#16#1"
partner = "tcp://192.0.2.1:102"
[[connection]]
id = "W#16#2"
partner = "tcp://127.0.0.1"
active = false
partner_tsap = "11.00"
"""
CALL = bytes.fromhex("0300001611E00000000500C0010AC1021100C2021002")


class Peer(Client):
    """The partner of W#16#2."""
    def __init__(self, port, record=lambda socket: socket):
        self.socket = record(socket.create_connection(("127.0.0.1", port), timeout=20))
        self.number = 1
        self.socket.sendall(CALL)
        assert self.tpdu()[1:2] == b"\xD0"
        self.pdu = struct.unpack(">H", self.ask(SETUP)[-2:])[0]

    def segment(self, data, rid=7, sequence=0, unit=0, last=True, total=None):
        spec = bytes([0x12, 6, 0x13, 0]) + struct.pack(">I", rid)
        spec += b"" if total is None else struct.pack(">H", total)
        item = struct.pack(">BBH", 0xFF, 9, len(spec + data)) + spec + data
        self.number += 1
        head = struct.pack(">BBHHHH", 0x32, 7, 0, self.number, 12, len(item))
        return head + bytes([0, 1, 0x12, 8, 0x12, 0x46, 1, sequence, unit, int(not last), 0, 0]) + item

    def acknowledge(self, segment, sequence):
        self.send(bytes.fromhex("32070000") + segment[4:6] + bytes.fromhex("000C0004") +
                  bytes([0, 1, 0x12, 8, 0x12, 0x86, 1, sequence, 0, 0, 0, 0]) + b"\x0A\0\0\0")


class Partners(S7Case):
    def setUp(self):
        super().setUp()
        self.write("plant/merker.toml", PROJECT)
        self.write("plant/a.awl", BLOCKS)

    def received(self, client, count):
        self.until(lambda: client.read(FLAGS, 20) == bytes([count]))

    # S7-SFB-10: three segments, and one; a wrong R_ID; both judged by Wireshark.
    def test_bsend_both_ways(self):
        for engine in ("interpreter", "jit"):
            with self.subTest(engine):
                self.both_ways(engine)

    def both_ways(self, engine):
        process = self.start("plant", "--no-workbench", "--engine", engine)
        capture = Capture(self.folder / "s7.pcap")
        self.addCleanup(capture.close)
        peer = Peer(self.port, lambda socket: Recorded(socket, capture))
        client = self.client(3)
        self.until(lambda: client.read(FLAGS, 14, 1, WORD) == b"\0\x19")  # BRCV has the connection
        first = peer.ask(peer.segment(b"\x01" * 200, unit=1, last=False, total=450))
        sequence = first[17]
        self.assertEqual((first[15], first[20:22], sequence != 0), (0x86, b"\0\0", True))
        peer.ask(peer.segment(b"\x02" * 200, sequence=sequence, unit=2, last=False))
        self.until(lambda: client.read(FLAGS, 14, 2, WORD) == b"\0\x11\x01\x90")  # STATUS 17, LEN 400
        peer.ask(peer.segment(b"\x03" * 50, sequence=sequence, unit=3))
        self.received(client, 1)
        self.assertEqual(client.read(DATA_AREA, 700, 200, BYTE, 1), b"\x02" * 200)
        self.assertEqual(client.read(DATA_AREA, 900, 60, BYTE, 1), b"\x03" * 50 + bytes(10))
        self.assertEqual(peer.ask(peer.segment(b"\x04", rid=8, total=1))[20:22].hex(), "8701")
        client.write(FLAGS, 0, b"\x01")
        pieces = b""
        for number in range(2):
            segment = peer.hear()
            peer.acknowledge(segment, 5)
            pieces += segment[36 if number == 0 else 34:]
        self.assertEqual(len(pieces), 400)
        self.assertEqual((pieces[0], pieces[399]), (0xA1, 0xB2))
        self.assertEqual(peer.read(DATA_AREA, 0, 1, BYTE, 1), b"\xA1")  # the same partner as a client
        peer.close()
        self.assertEqual(capture.ask(BAD), [])
        self.assertEqual(len(capture.ask("s7comm.pbc.req.bsend.r_id == 7")), 3)
        self.assertEqual(len(capture.ask("s7comm.pbc.req.bsend.r_id == 9")), 2)
        self.until(lambda: client.read(FLAGS, 14, 1, WORD) == b"\0\x01")  # the connection is lost
        self.end(process)

    # S7-SFB-10: USEND and URCV; nobody answers. Judged by Wireshark, which knows the frame.
    def test_usend_both_ways(self):
        process = self.start("plant", "--no-workbench")
        capture = Capture(self.folder / "s7.pcap")
        self.addCleanup(capture.close)
        peer = Peer(self.port, lambda socket: Recorded(socket, capture))
        client = self.client(3)
        self.until(lambda: client.read(FLAGS, 14, 1, WORD) == b"\0\x19")
        client.write(FLAGS, 30, b"\x12\x34")
        client.write(FLAGS, 0, b"\x02")
        notice = peer.hear()
        self.assertEqual(notice[10:].hex(" "), "00 01 12 06 13 00 00 00 00 0b ff 00 00 02 00 04 00 18 a1 00 00 00 00 04 00 10 12 34")
        self.until(lambda: client.read(FLAGS, 21) == b"\x01")
        data = bytes.fromhex("FF000002 00040018010203 00 0003000101")
        sent = bytes.fromhex("320700000009 000A") + struct.pack(">H", len(data)) + bytes.fromhex("00011206130000 00000C") + data
        for rid in b"\x0D", b"\x0C":  # nobody receives the first one
            peer.send(sent[:19] + rid + sent[20:])
        self.until(lambda: client.read(FLAGS, 22) == b"\x01")
        self.assertEqual(client.read(FLAGS, 40, 6), b"\x01\x02\x03\x00\x00\x08")
        self.assertEqual(peer.read(DATA_AREA, 0, 1, BYTE, 1), b"\xA1")  # it is there as before
        peer.close()
        self.assertEqual(capture.ask(BAD), [])
        self.end(process)

    # S7-NETPRO-08, S7-LIM-05: who is there and who is not; they take connections of the CPU.
    def test_the_table_of_connections(self):
        said = {}
        for form in ("--json", "--cpu=generic"):
            command = [os.environ["MERKER"], "diag", "plant", "--s7", "127.0.0.1:0", "--for", "2s", form]
            process = subprocess.Popen(command, cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            self.addCleanup(lambda: (process.kill(), process.communicate()))
            self.port = int(process.stderr.readline().rsplit(":", 1)[1])
            peer = Peer(self.port)  # it stays until the end
            said[form], _ = process.communicate(timeout=60)
            peer.close()
        self.assertEqual(json.loads(said["--json"])["communication"]["partners"], [
            {"id": "W#16#1", "host": "192.0.2.1", "port": 102, "active": True, "state": "outside", "pdu": 0},
            {"id": "W#16#2", "host": "127.0.0.1", "port": 0, "active": False, "state": "connected", "pdu": 240}])
        text = said["--cpu=generic"]
        self.assertRegex(text, r"\d: 2 of 64 connections in use;")
        self.assertRegex(text, r"W#16#1 +192\.0\.2\.1:102 +yes +not called +0\n")
        self.assertRegex(text, r"W#16#2 +127\.0\.0\.1 +no +connected +240\n")

    # Two that call as the same partner: the second one is a client.
    def test_a_second_call(self):
        process = self.start("plant", "--no-workbench")
        peer = Peer(self.port)
        other = Peer(self.port)
        self.assertEqual(other.ask(other.segment(b"\x04", total=1))[20:22].hex(), "8104")
        client = self.client(3)
        self.until(lambda: client.read(FLAGS, 14, 1, WORD) == b"\0\x19")
        self.assertEqual(peer.ask(peer.segment(b"\x04", total=1))[20:22].hex(), "0000")
        self.received(client, 1)
        self.end(process)

    # What is no partner loses its connection, and only that.
    def test_nonsense(self):
        process = self.start("plant", "--no-workbench")
        peer = Peer(self.port)
        with self.assertRaises(ConnectionError):
            peer.acknowledge(bytes(10), 1)
            peer.hear()
        peer = Peer(self.port)
        self.assertEqual(peer.ask(peer.segment(b"", total=1))[20:22].hex(), "8500")
        self.assertRegex(self.end(process), "1 broken off")


