"""Connections of a CP 343-1 (S7-SFB-10): AG_SEND and AG_RECV over TCP, ISO on TCP and UDP with partners outside, whose sockets are
real; the codes of wrong calls; whose block FC 5 is; the same trace on any number of threads."""
import shutil

from s7_client import *

# M 0.i starts a job on connection i + 1 of MW 40 bytes from DB 1; each result is counted in MB 10 + i, an error in MW 20 + 2i.
# AG_RECV of connection i + 1 puts up to MW of RECV bytes into DB 2 and counts in MB 30 + i.
def calls(index, room):
    send = (f"CALL FC 5 (ACT := M 0.{index}, ID := {index + 1}, LADDR := W#16#100, SEND := P#DB1.DBX 0.0 BYTE 8192, LEN := MW 40,\n"
            f" DONE := M 1.0, ERROR := M 1.1, STATUS := MW 50);\n"
            f" U M 1.0; SPBN d{index}; L MB {10 + index}; + 1; T MB {10 + index}; R M 0.{index};\n"
            f"d{index}: U M 1.1; SPBN e{index}; L MW 50; T MW {20 + 2 * index}; R M 0.{index};\ne{index}: NOP 0;\n")
    return send + (f"CALL FC 6 (ID := {index + 1}, LADDR := W#16#100, RECV := P#DB2.DBX {index * 2048}.0 BYTE {room},\n"
                   f" NDR := M 1.2, ERROR := M 1.3, STATUS := MW {52 + 2 * index}, LEN := MW {60 + 2 * index});\n"
                   f" U M 1.2; SPBN r{index}; L MB {30 + index}; + 1; T MB {30 + index}; L MW {60 + 2 * index}; T MW {70 + 2 * index};\nr{index}: NOP 0;\n")


BLOCKS = "".join(f"DATA_BLOCK DB {number}\nSTRUCT\n a : ARRAY [0..8191] OF BYTE;\nEND_STRUCT\nBEGIN\n{first}END_DATA_BLOCK\n"
                 for number, first in ((1, " a[0] := B#16#A1; a[9] := B#16#B2; a[8191] := B#16#C3;\n"), (2, "")))
PROGRAM = BLOCKS + block(calls(0, 10) + calls(1, 2048) + calls(2, 2048))
CP = '[[module]]\nslot = 4\ntype = "6GK7 343-1EX30-0XE0"\n'
ISO = bytes.fromhex("0300001914E00000000500C1055443502D31C2055443502D32")  # calling TCP-1, called TCP-2


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


class Outside(S7Case):
    def setUp(self):
        super().setUp()
        self.udp = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.udp.bind(("127.0.0.1", 0))
        self.udp.settimeout(20)
        self.tcp = socket.create_server(("127.0.0.1", 0))
        self.tcp.settimeout(20)
        self.addCleanup(self.udp.close)
        self.addCleanup(self.tcp.close)
        self.iso_port, self.udp_port = free_ports(2)
        self.write("plant/a.awl", PROGRAM)
        self.write("plant/merker.toml", f"""[cpu]
model = "314C-2 DP"
{CP}
[[connection]]
kind = "tcp"
id = 1
partner = "tcp://127.0.0.1:{self.tcp.getsockname()[1]}"
[[connection]]
kind = "iso-on-tcp"
id = 2
partner = "tcp://127.0.0.1"
active = false
local_port = {self.iso_port}
local_tsap = "TCP-2"
partner_tsap = "54.43.50.2D.31"
[[connection]]
kind = "udp"
id = 3
partner = "udp://127.0.0.1:{self.udp.getsockname()[1]}"
local_port = {self.udp_port}
""")

    def flag(self, client, byte, value, count=1):
        self.until(lambda: client.read(FLAGS, byte, count) == value)

    def send(self, client, index, length):
        self.flag(client, 0, b"\0")  # the program resets ACT with the result of the last job
        client.write(FLAGS, 40, struct.pack(">H", length))
        client.write(FLAGS, 0, bytes([1 << index]))

    def test_tcp(self):
        process = self.start("plant", "--no-workbench")
        client = self.client(3)
        partner, _ = self.tcp.accept()
        self.flag(client, 52, b"\x81\x80", 2)  # connected, no data
        partner.sendall(b"12345")
        self.flag(client, 52, b"\x81\x81", 2)  # RECV has room for ten
        partner.sendall(b"6789abcde")
        self.flag(client, 30, b"\x01")
        self.assertEqual(client.read(DATA_AREA, 0, 10, BYTE, 2), b"123456789a")
        partner.sendall(b"fghij-----")  # four wait
        self.flag(client, 30, b"\x02")
        self.assertEqual(client.read(DATA_AREA, 0, 10, BYTE, 2), b"bcdefghij-")
        self.send(client, 0, 8192)
        data = b""
        while len(data) < 8192:
            data += partner.recv(8192)
        self.assertEqual((data[0], data[9], data[8191], len(data)), (0xA1, 0xB2, 0xC3, 8192))
        self.flag(client, 10, b"\x01")
        partner.close()
        self.flag(client, 52, b"\x81\x81", 2)  # four bytes are still there
        again, _ = self.tcp.accept()  # it calls again
        again.sendall(b"......")
        self.flag(client, 30, b"\x03")
        again.close()
        self.tcp.close()
        self.flag(client, 52, b"\x83\x04", 2)
        self.send(client, 0, 1)
        self.flag(client, 20, b"\x83\x04", 2)
        self.end(process)

    # A partner that sends on and on: what the program does not take waits in front of the PLC, which works on.
    def test_a_partner_that_sends_too_much(self):
        process = self.start("plant", "--no-workbench")
        client = self.client(3)
        partner, _ = self.tcp.accept()
        partner.settimeout(2)
        with self.assertRaises(TimeoutError):
            for _ in range(2000):  # 125 MB
                partner.sendall(bytes(65536))
        before = client.read(FLAGS, 30)
        self.until(lambda: client.read(FLAGS, 30) != before)
        self.assertLess(int(re.search(r"VmRSS:\s+(\d+)", pathlib.Path(f"/proc/{process.pid}/status").read_text())[1]), 600_000)
        partner.close()
        self.end(process)

    def test_iso_on_tcp(self):
        process = self.start("plant", "--no-workbench")
        client = self.client(3)
        for wrong in (ISO.replace(b"TCP-1", b"TCP-9"), b"GET / HTTP/1.1\r\n\r\n"):
            with socket.create_connection(("127.0.0.1", self.iso_port), timeout=20) as stranger:
                stranger.sendall(wrong)
                while stranger.recv(100):
                    pass
        partner = Client.__new__(Client)
        partner.socket = socket.create_connection(("127.0.0.1", self.iso_port), timeout=20)
        partner.socket.sendall(ISO)
        self.assertEqual(partner.tpdu()[1:2], b"\xD0")
        self.flag(client, 54, b"\x81\x80", 2)
        partner.send(b"a block of data")
        partner.socket.sendall(bytes.fromhex("0300000A02F000") + b"two" + bytes.fromhex("0300000C02F080") + b"parts")
        self.flag(client, 31, b"\x02")
        with socket.create_connection(("127.0.0.1", self.iso_port), timeout=20) as stranger:  # who says nothing takes nobody's place
            self.send(client, 1, 1)
            self.assertEqual(partner.hear(), b"\xA1")
        self.flag(client, 11, b"\x01")
        self.assertEqual(client.read(FLAGS, 72, 2), b"\x00\x08")
        self.assertEqual(client.read(DATA_AREA, 2048, 15, BYTE, 2), b"twopartsof data")
        self.send(client, 1, 300)
        self.assertEqual(partner.hear()[:10], b"\xA1" + bytes(8) + b"\xB2")
        self.flag(client, 11, b"\x02")
        partner.send(bytes(3000))  # more than RECV: it stays, and so does what is behind it
        self.flag(client, 54, b"\x81\x85", 2)
        partner.socket.close()
        self.end(process)

    def test_udp(self):
        process = self.start("plant", "--no-workbench")
        client = self.client(3)
        self.flag(client, 56, b"\x81\x80", 2)
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stranger:
            stranger.sendto(b"not me", ("127.0.0.1", self.udp_port))
        self.udp.sendto(b"a datagram", ("127.0.0.1", self.udp_port))
        self.flag(client, 32, b"\x01")
        self.assertEqual(client.read(DATA_AREA, 4096, 10, BYTE, 2), b"a datagram")
        self.send(client, 2, 2048)
        self.assertEqual(len(self.udp.recv(4096)), 2048)
        self.send(client, 2, 2049)
        self.flag(client, 24, b"\x81\x85", 2)
        self.end(process)


class Inside(Case):
    def call(self, text, module=CP, more=""):
        self.write("plant/merker.toml", f'[cpu]\nmodel = "314C-2 DP"\n{module}{more}')
        self.write("plant/a.awl", BLOCKS + block(text))
        return self.merker("run", "plant", "--for", "1s", "--print", "MW 50, M 1.0, M 1.1, M 2.0")

    def send(self, **changed):
        values = {"ID": "1", "LADDR": "W#16#100", "SEND": "P#DB1.DBX 0.0 BYTE 100", "LEN": "100"} | changed
        text = "CALL FC 5 (ACT := TRUE, " + ", ".join(f"{k} := {v}" for k, v in values.items())
        return text + ", DONE := M 1.0, ERROR := M 1.1, STATUS := MW 50); U BIE; = M 2.0;"

    UDP = '[[connection]]\nkind = "udp"\nid = 1\npartner = "udp://127.0.0.1:9"\nlocal_port = 9\n'

    def test_wrong_calls(self):
        for code, text, module, more in (
                ("8186", self.send(ID="17"), CP, self.UDP), ("8186", self.send(ID="0"), CP, self.UDP),
                ("8183", self.send(ID="2"), CP, self.UDP), ("8090", self.send(LADDR="W#16#110"), CP, self.UDP),
                ("8304", self.send(), CP, self.UDP)):
            call = self.call(text, module, more)
            self.assertEqual(call.lines, [f"MW 50 = W#16#{code}", "M 1.0 = 0", "M 1.1 = 1", "M 2.0 = 0"], call.err)

    # Between two stations UDP is there from the second cycle on: lengths and areas alone decide.
    def test_wrong_data(self):
        for code, changed in (("8185", {"LEN": "101"}), ("8F22", {"LEN": "0"}), ("8F22", {"LEN": "-1"}), ("8F3A", {"SEND": "P#DB9.DBX 0.0 BYTE 100"}),
                              ("8184", {"SEND": "P#DB1.DBX 0.0 BOOL 1"}), ("8185", {"SEND": "P#DB1.DBX 0.0 BYTE 3000", "LEN": "3000"}),
                              ("8F22", {"SEND": "P#DB1.DBX 8000.0 BYTE 1000", "LEN": "1000"})):
            self.pair("udp")
            self.write("lab/a/a.awl", BLOCKS + block(self.send(**changed)))
            call = self.merker("run", "lab", "--for", "100ms", "--print", "A/MW 50")
            self.assertEqual(call.out, f"A/MW 50 = W#16#{code}\n", call.err)

    def pair(self, kind):
        self.write("lab/merker.toml", f"""[[station]]
name = "A"
folder = "a"
[[station]]
name = "B"
folder = "b"
[[subnet]]
name = "Net"
kind = "ethernet"
nodes = [ {{station = "A", address = "10.0.0.1"}}, {{station = "B", address = "10.0.0.2"}} ]
[[connection]]
kind = "{kind}"
id = 1
local = "A"
partner = "B"
partner_id = 1
""")
        for name in "ab":
            self.write(f"lab/{name}/merker.toml", f'[cpu]\nmodel = "314C-2 DP"\n{CP}')
            self.write(f"lab/{name}/a.awl", BLOCKS + block("NOP 0;"))

    def test_the_blocks_of_an_s7_connection(self):
        self.pair("s7")
        text = self.read("lab/merker.toml").replace("partner_id = 1\n", "")
        self.write("lab/merker.toml", text)
        get = ("DATA_BLOCK DB 14\nFB 14\nBEGIN\nEND_DATA_BLOCK\n" + block(
            "CALL FB 14, DB 14 (REQ := M 0.0, ID := W#16#1, NDR := M 1.0, ERROR := M 1.1, STATUS := MW 50, ADDR_1 := P#M 20.0 BYTE 2, "
            "RD_1 := P#M 30.0 BYTE 2); UN M 0.0; = M 0.0;"))
        self.write("lab/a/a.awl", get)
        call = self.merker("run", "lab", "--for", "500ms", "--set", "B/MW 20 = 1234", "--print", "A/MW 30")
        self.assertEqual(call.out, "A/MW 30 = W#16#04D2\n", call.err)

    def both_engines(self, printed, expected):
        for engine in ("interpreter", "jit"):
            call = self.merker("run", "lab", "--for", "500ms", "--engine", engine, "--print", printed)
            self.assertEqual((call.code, call.lines), (GOOD, expected), f"{engine}\n{call.err}")

    def test_sending_receiving_and_writing_over_an_s7_connection(self):
        self.pair("s7")
        instances = "".join(f"DATA_BLOCK DB {number}\nFB {number}\nBEGIN\nEND_DATA_BLOCK\n" for number in (12, 13, 15))
        self.write("lab/a/a.awl", BLOCKS + instances + block(
            "L 100; T MW 60; CALL FB 12, DB 12 (REQ := M 0.0, R := M 5.0, ID := W#16#1, R_ID := DW#16#5, DONE := M 1.0, ERROR := M 1.1, "
            "STATUS := MW 50, SD_1 := P#DB1.DBX 0.0 BYTE 100, LEN := MW 60); CALL FB 15, DB 15 (REQ := M 0.0, ID := W#16#1, DONE := M 1.2, "
            "ERROR := M 1.3, STATUS := MW 52, ADDR_1 := P#M 40.0 BYTE 2, SD_1 := P#M 60.0 BYTE 2); UN M 0.0; = M 0.0;"))
        self.write("lab/b/a.awl", BLOCKS + instances + block(
            "SET; = M 0.3; CALL FB 13, DB 13 (EN_R := M 0.3, ID := W#16#1, R_ID := DW#16#5, NDR := M 1.0, ERROR := M 1.1, STATUS := MW 50, "
            "RD_1 := P#DB2.DBX 0.0 BYTE 100, LEN := MW 62); U M 1.0; S M 2.0;"))
        self.both_engines("B/MW 40, B/DB2.DBB 0, B/DB2.DBB 9, B/M 2.0",
                          ["B/MW 40 = W#16#0064", "B/DB2.DBB 0 = B#16#A1", "B/DB2.DBB 9 = B#16#B2", "B/M 2.0 = 1"])

    # FB 8 and 9 have one area each.
    def test_uncoordinated_sending_over_an_s7_connection(self):
        self.pair("s7")
        instances = "".join(f"DATA_BLOCK DB {number}\nFB {number}\nBEGIN\nEND_DATA_BLOCK\n" for number in (8, 9))
        self.write("lab/a/a.awl", BLOCKS + instances + block(
            "CALL FB 8, DB 8 (REQ := M 0.0, ID := W#16#1, R_ID := DW#16#5, DONE := M 1.0, ERROR := M 1.1, STATUS := MW 50, "
            "SD_1 := P#DB1.DBX 0.0 BYTE 10); U M 1.0; S M 2.0; UN M 0.0; = M 0.0;"))
        self.write("lab/b/a.awl", BLOCKS + instances + block(
            "SET; = M 0.3; CALL FB 9, DB 9 (EN_R := M 0.3, ID := W#16#1, R_ID := DW#16#5, NDR := M 1.0, ERROR := M 1.1, STATUS := MW 50, "
            "RD_1 := P#DB2.DBX 0.0 BYTE 20); U M 1.0; S M 2.0;"))
        self.both_engines("A/M 2.0, B/DB2.DBB 0, B/DB2.DBB 9, B/M 2.0",
                          ["A/M 2.0 = 1", "B/DB2.DBB 0 = B#16#A1", "B/DB2.DBB 9 = B#16#B2", "B/M 2.0 = 1"])
        self.write("lab/a/a.awl", self.read("lab/a/a.awl").replace("BYTE 10)", "BYTE 10, SD_2 := P#M 9.0 BYTE 1)"))
        self.assertIn("'SD_2' is not a parameter of FB 8", self.expect(PROBLEMS, "check", "lab").err)

    # A project of STEP 7 brings these blocks along, here without their code: those of Merker run, and the project is told.
    def test_copied_blocks_of_the_library(self):
        head = "TITLE = x\nAUTHOR : SIMATIC\nFAMILY : {}\nNAME : {}\n"
        send = ("FUNCTION FC 5 : VOID\n" + head + "VAR_INPUT\n ACT : BOOL;\n ID : INT;\n LADDR : WORD;\n SEND : ANY;\n LEN : INT;\nEND_VAR\n"
                "VAR_OUTPUT\n DONE : BOOL;\n ERROR : BOOL;\n STATUS : WORD;\nEND_VAR\nBEGIN\nNETWORK\n SET; = #DONE;\nEND_FUNCTION\n")
        receive = ("FUNCTION_BLOCK FB 13\n" + head + "VAR_INPUT\n EN_R : BOOL;\n ID : WORD;\n R_ID : DWORD;\nEND_VAR\nVAR_OUTPUT\n NDR : BOOL;\n "
                   "ERROR : BOOL;\n STATUS : WORD;\nEND_VAR\nVAR_IN_OUT\n RD_1 : ANY;\n LEN : WORD;\nEND_VAR\nVAR\n own : ARRAY [0..99] OF BYTE;\n"
                   "END_VAR\nBEGIN\nNETWORK\n SET; = #NDR;\nEND_FUNCTION_BLOCK\n")
        call = "DATA_BLOCK DB 13\nFB 13\nBEGIN\nEND_DATA_BLOCK\n" + BLOCKS + block(
            "CALL FC 5 (ACT := M 0.0, ID := 9, LADDR := W#16#100, SEND := P#M 0.0 BYTE 1, LEN := 1, DONE := M 1.0, ERROR := M 1.1, STATUS := MW 50);"
            "SET; = M 0.3; CALL FB 13, DB 13 (EN_R := M 0.3, ID := W#16#9, R_ID := DW#16#5, NDR := M 1.2, ERROR := M 1.3, STATUS := MW 52, "
            "RD_1 := P#M 60.0 BYTE 1, LEN := MW 62);")
        for module, family, names, notes, printed in (
                (CP, "CP_300", ("AG_SEND", "BRCV"), 2, "8183 0001"), (CP, "CP300", ("AG_SEND", "OTHER"), 1, "8183 0000"),
                (CP, "MINE", ("AG_SEND", "BRCV"), 0, "0000 0000"), ("", "CP_300", ("AG_SEND", "BRCV"), 0, "0000 0000")):
            self.write("plant/merker.toml", f'[cpu]\nmodel = "314C-2 DP"\n{module}')
            self.write("plant/a.awl", send.format(family, names[0]) + receive.format(family, names[1]) + call)
            ran = self.expect(GOOD, "run", "plant", "--for", "50ms", "--print", "MW 50, MW 52")
            self.assertEqual([line[-4:] for line in ran.lines], printed.split(), ran.err)
            self.assertEqual(ran.err.count("of SIMATIC_NET_CP, whose code needs a real CP"), notes, ran.err)

    def test_the_long_blocks(self):
        for kind in ("tcp", "udp"):
            self.pair(kind)
            self.write("lab/a/a.awl", BLOCKS + block(
                "CALL FC 50 (ACT := M 0.0, ID := 1, LADDR := W#16#100, SEND := P#DB1.DBX 0.0 BYTE 2048, LEN := 2048, DONE := M 1.0, "
                "ERROR := M 1.1, STATUS := MW 50); UN M 0.0; = M 0.0;"))
            self.write("lab/b/a.awl", BLOCKS + block(
                "CALL FC 60 (ID := 1, LADDR := W#16#100, RECV := P#DB2.DBX 0.0 BYTE 2048, NDR := M 1.0, ERROR := M 1.1, STATUS := MW 50, "
                "LEN := MW 62); U M 1.0; SPBN none; L MW 62; T MW 64; none: NOP 0;"))
            self.both_engines("B/MW 64, B/DB2.DBB 9", ["B/MW 64 = W#16#0800", "B/DB2.DBB 9 = B#16#B2"])

    # FC 5 is a block of two libraries.
    def test_whose_block_it_is(self):
        text = "CALL FC 5 (I := L#1234, RET_VAL := #t);"
        iec = "ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n i : ARRAY [0..19] OF BYTE;\n t : STRING;\nEND_VAR\nBEGIN\nNETWORK\n" + text + "\nEND_ORGANIZATION_BLOCK\n"
        for module, libraries, source, said in (
                ("", "", iec, ""), (CP, "", iec, "FC 5 is AG_SEND of SIMATIC_NET_CP here"),
                (CP, '[program]\nlibraries = ["Standard Library"]\n', iec, ""),
                ("", "", BLOCKS + block(self.send()), "FC 5 is DI_STRNG of Standard Library here"),
                (CP, "", BLOCKS + block(self.send()), ""),
                (CP, '[program]\nlibraries = ["SIMATIC_NET"]\n', iec, "a list of \"Standard Library\" and \"SIMATIC_NET_CP\"")):
            self.write("plant/merker.toml", f'{libraries}[cpu]\nmodel = "314C-2 DP"\n{module}')
            self.write("plant/a.awl", source)
            call = self.merker("check", "plant")
            self.assertIn(said, call.err + call.out)
            self.assertEqual(call.code, GOOD if not said else PROBLEMS, call.err)

    def test_wrong_connections(self):
        for wrong, said in (
                (self.UDP.replace("id = 1", "id = 17"), "'id' must be"), (self.UDP * 2, "another one than those of the CP's connections above"),
                (self.UDP.replace("local_port = 9\n", ""), "the port of this station"), (self.UDP.replace(":9\"", "\""), "an address and a port"),
                (self.UDP.replace('"udp"', '"iso-on-tcp"').replace("udp://", "tcp://"), "1 to 16 characters"),
                (self.UDP.replace('"udp"', '"tls"'), "one of \"s7\", \"tcp\", \"iso-on-tcp\", \"udp\"")):
            call = self.call("NOP 0;", more=wrong)
            self.assertEqual((call.code, said in call.err), (PROBLEMS, True), call.err)
        self.assertIn("the station needs a CP 343-1", self.call("NOP 0;", module="", more=self.UDP).err)
        self.pair("tcp")
        self.write("lab/b/merker.toml", '[cpu]\nmodel = "314C-2 PN/DP"\n')
        self.assertIn("a station with a CP 343-1", self.merker("check", "lab").err)

    def test_the_same_on_any_number_of_threads(self):
        shutil.copytree(pathlib.Path(__file__).parents[2] / "examples" / "networks" / "send-receive", self.folder / "lab")
        traces = set()
        for threads in 1, 2, 4, 8:
            self.expect(GOOD, "run", "lab", "--for", "1s", "--threads", str(threads), "--trace", "t.csv", "--set", "Press/E 124.0 = 1, Press/E 124.1 = 1",
                        "--watch", "Press/MW 20, Press/MW 22, Office/MW 10, Office/MW 24, Office/MW 30")
            traces.add(self.read("t.csv"))
        self.assertEqual(len(traces), 1)
        self.assertGreater(traces.pop().count("\n"), 20)


if __name__ == "__main__":
    unittest.main()
