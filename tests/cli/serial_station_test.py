"""X27 of two stations of one project (PTP-LINE-03): each protocol from 314C to 314C in virtual time, exact to the nanosecond, the
same in every run and with both engines; their operands in scenarios; what is wrong with such a project."""
import csv
import struct

from harness import *

PROJECT = """[cpu]
model = "314C-2 PtP"

[[module]]
slot = "2.1"
diagnostics = true

[module.serial]
{settings}
"""
CONNECTED = PROJECT + """
[[station]]
name = "Press"
folder = "../press"

[serial]
X27 = "station:Press"
"""

# M 0.0 sends MW 30 bytes of DB 20; MW 20, MW 22 count what was sent and received, MW 24 errors, MW 26 is the last one.
PROGRAM = """DATA_BLOCK DB 20
STRUCT
  D : ARRAY [0 .. 1023] OF BYTE;
END_STRUCT
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 21
STRUCT
  D : ARRAY [0 .. 1023] OF BYTE;
END_STRUCT
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 60 SFB 60
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 61 SFB 61
BEGIN
END_DATA_BLOCK
FUNCTION FC 1 : VOID
VAR_INPUT
  HAPPENED : BOOL;
END_VAR
VAR_IN_OUT
  COUNT : INT;
END_VAR
BEGIN
NETWORK
      U     #HAPPENED
      BEBN
      L     #COUNT
      +     1
      T     #COUNT
END_FUNCTION
ORGANIZATION_BLOCK OB 82
BEGIN
NETWORK
      L     MW 40
      +     1
      T     MW 40
END_ORGANIZATION_BLOCK
ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      CALL  SFB 60, DB 60 (REQ := M 0.0, R := FALSE, LADDR := W#16#3FF, DONE := M 1.0, ERROR := M 1.1, STATUS := MW 4, SD_1 := P#DB20.DBX0.0 BYTE 1, LEN := MW 30)
      CALL  FC 1 (HAPPENED := M 1.0, COUNT := MW 20)
      CALL  SFB 61, DB 61 (EN_R := TRUE, R := FALSE, LADDR := W#16#3FF, NDR := M 1.2, ERROR := M 1.3, STATUS := MW 6, RD_1 := P#DB21.DBX0.0 BYTE 1, LEN := MW 32)
      CALL  FC 1 (HAPPENED := M 1.2, COUNT := MW 22)
      CALL  FC 1 (HAPPENED := M 1.1, COUNT := MW 24)
      L     MW 4
      L     0
      ==I
      SPB   good
      L     MW 4
      T     MW 26
good: NOP   0
END_ORGANIZATION_BLOCK
""".replace("      BEBN\n", "      NOT\n      BEB\n")

BOTH_WAYS = """scenario "both ways"
  wait 500ms
  set DB20.DBD 0 = DW#16#01021003, MW 30 = 4, Press/DB20.DBD 0 = DW#16#AABBCCDD, Press/MW 30 = 4
  set M 0.0 = 1, Press/M 0.0 = 1
  expect Press/DB21.DBD 0 = DW#16#01021003 within 2s
  expect DB21.DBD 0 = DW#16#AABBCCDD within 2s
  wait 200ms
  expect MW 20 = 1
  expect MW 22 = 1
  expect MW 24 = 0
  expect Press/MW 20 = 1
  expect Press/MW 22 = 1
  expect Press/MW 24 = 0
  expect serial X27 received nothing
"""

STATES = """
scenario "the other station stops, is switched off, and comes back"
  wait 100ms
  partner stop
  expect partner mode = STOP
  partner power off
  wait 100ms
  expect MW 40 = 1
  partner power on
  partner run
  expect partner mode = RUN
  wait 100ms
  expect MW 40 = 2
  serial X27 cut at partner
  expect Press/MW 40 = 1 within 100ms
  serial X27 connect at partner
  expect Press/MW 40 = 2 within 100ms
  set MW 30 = 2, DB20.DBW 0 = W#16#1234, M 0.0 = 1
  expect Press/DB21.DBW 0 = W#16#1234 within 1s
"""

PROTOCOLS = {
    "ASCII": ("", ""),
    "ASCII over two wires": ('mode = "RS485"\n', 'mode = "RS485"\n'),
    "3964R": ('priority = "low"\n', 'priority = "high"\n'),
    "RK512": ('priority = "low"\n', 'priority = "high"\n'),
}
# RK 512: the same flags, by SEND_RK and SERVE_RK.
LINK = (PROGRAM.replace("DB 60 SFB 60", "DB 63 SFB 63").replace("DB 61 SFB 61", "DB 65 SFB 65")
        .replace("CALL  SFB 60, DB 60 (REQ", "CALL  SFB 63, DB 63 (SYNC_DB := 50, R_CPU := 1, R_TYPE := 'D', R_DBNO := 21, R_OFFSET := 0, R_CF_BYT := 255, R_CF_BIT := 0, REQ")
        .replace("CALL  SFB 61, DB 61 (EN_R", "CALL  SFB 65, DB 65 (SYNC_DB := 50, L_TYPE := MB 50, L_DBNO := MW 52, L_OFFSET := MW 54, L_CF_BYT := MW 56, L_CF_BIT := MW 58, EN_R")
        .replace("RD_1 := P#DB21.DBX0.0 BYTE 1, ", "")
        + "DATA_BLOCK DB 50\nSTRUCT\n  S : ARRAY [0 .. 239] OF BYTE;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n")


class Stations(Case):
    def pair(self, protocol, scenario=BOTH_WAYS):
        own, other = PROTOCOLS[protocol]
        name = f'protocol = "{protocol.split()[0]}"\n'
        program = LINK if name.startswith('protocol = "RK') else PROGRAM
        for folder, text in (("cell", CONNECTED.format(settings=name + own)), ("press", PROJECT.format(settings=name + other))):
            self.write(f"{folder}/merker.toml", text)
            self.write(f"{folder}/main.awl", program)
        self.write("cell/cell.scn", scenario)

    def line(self, name):
        self.expect(GOOD, "monitor", "serial", "cell", "--scenario", "cell/cell.scn", "--csv", name)
        return (self.folder / name).read_text()

    def test_both_send_and_receive_with_each_protocol_and_engine(self):
        for protocol in PROTOCOLS:
            if protocol.endswith("wires"):
                continue  # both at once collide there
            with self.subTest(protocol):
                self.pair(protocol)
                for engine in ("interpreter", "jit"):
                    self.expect(GOOD, "test", "cell", "--engine", engine)

    def test_two_wires_have_one_sender_at_a_time(self):
        self.pair("ASCII over two wires", BOTH_WAYS.replace(", Press/M 0.0 = 1", "")
                  .replace("  expect DB21.DBD 0 =", "  wait 100ms\n  set Press/M 0.0 = 1\n  expect DB21.DBD 0 ="))
        self.expect(GOOD, "test", "cell")
        self.pair("ASCII over two wires")
        self.assertIn("expected Press/DB21.DBD 0", self.expect(PROBLEMS, "test", "cell").out)

    def test_the_states_of_the_one_are_seen_by_the_other(self):
        self.pair("ASCII", STATES)
        for engine in ("interpreter", "jit"):
            self.expect(GOOD, "test", "cell", "--engine", engine)

    def test_characters_follow_each_other_to_the_nanosecond_and_every_run_is_the_same(self):
        self.pair("3964R")
        first = self.line("first.csv")
        self.assertEqual(first, self.line("second.csv"))
        rows = list(csv.DictReader(first.splitlines()))
        bits = lambda count: (2 * count * 10 ** 9 + 9600) // (2 * 9600)
        for row in rows:
            self.assertAlmostEqual(int(row["end_ns"]) - int(row["begin_ns"]), bits(11), delta=1)
        answers = [(before, row) for before, row in zip(rows, rows[1:]) if row["from"] != before["from"] and row["character"] == "10"]
        self.assertGreater(len(answers), 3)
        for before, row in answers:  # DLE begins when the character before has been received: in the middle of its stop bit or at its end
            self.assertLessEqual(abs(int(row["begin_ns"]) - int(before["end_ns"])), bits(1))

    def test_a_trace_is_the_same_with_both_engines(self):
        self.pair("RK512")
        self.write("cell/more.awl", "")
        traces = []
        for engine in ("interpreter", "jit"):
            self.expect(GOOD, "run", "cell", "--for", "2s", "--engine", engine, "--set", "M 0.0=1, MW 30=100", "--watch",
                        "MW 20, Press/MW 22, Press/M 1.2", "--trace", f"{engine}.csv", "--print", "Press/MW 22")
            traces.append((self.folder / f"{engine}.csv").read_text())
        self.assertEqual(traces[0], traces[1])
        self.assertIn("Press/MW 22,W#16#0001", traces[0])

    # PTP-LINE-11: read by the format of the file and of the link type alone
    def test_a_capture_file_has_the_same_characters(self):
        self.pair("3964R")
        rows = list(csv.DictReader(self.line("line.csv").splitlines()))
        self.expect(GOOD, "monitor", "serial", "cell", "--scenario", "cell/cell.scn", "--pcap", "line.pcap")
        data = (self.folder / "line.pcap").read_bytes()
        magic, major, minor, _, _, _, link = struct.unpack_from("<IHHiIII", data)
        self.assertEqual((magic, major, minor, link), (0xA1B23C4D, 2, 4, 250))
        place, seen, sides = 24, [], {1: "X27", 2: "partner"}
        while place < len(data):
            seconds, rest, length, whole = struct.unpack_from("<IIII", data, place)
            self.assertEqual(length, whole)
            again, micro, event, lines, footer = struct.unpack_from(">IIBBH", data, place + 16)
            self.assertEqual((again, micro, lines, footer), (seconds, rest // 1000, 0, 0))
            first = rows[len(seen)]
            self.assertEqual(int(first["begin_ns"]), seconds * 10 ** 9 + rest)
            seen += [(sides[event], f"{one:02X}") for one in data[place + 28:place + 16 + length]]
            place += 16 + length
        self.assertEqual(seen, [(row["from"], row["character"]) for row in rows])

    # PTP-LINE-07
    def test_without_pacing_characters_take_no_time_and_timers_theirs(self):
        sends = """scenario "1000 bytes"
  wait 100ms
  set MW 30 = 1000, M 0.0 = 1
  expect Press/MW 22 = {}
scenario "nobody answers"
  wait 100ms
  serial X27 cut at partner
  set MW 30 = 4, M 0.0 = 1
  expect MW 24 = 0 for 11s
  expect MW 24 = 1 within 2s
"""
        for pacing, result in (("unlimited", "1 within 60ms"), ("rate", "0 for 1.1s")):
            self.pair("3964R", sends.format(result))
            path = self.folder / "cell/merker.toml"
            path.write_text(path.read_text() + f'pacing = "{pacing}"\n')
            self.expect(GOOD, "test", "cell")
        path.write_text(path.read_text().replace('"rate"', '"quick"'))
        self.assertIn("'pacing' must be", self.expect(PROBLEMS, "check", "cell").err)

    def test_what_is_wrong_is_told(self):
        def fails(change, text, scenario="  expect M 0.0 = 0\n", code=PROBLEMS):
            self.pair("ASCII", scenario)
            path = self.folder / "cell/merker.toml"
            path.write_text(change(path.read_text()))
            call = self.expect(code, "test", "cell")
            self.assertIn(text, call.out + call.err)
        same = lambda text: text
        fails(lambda text: text.replace('"../press"', '"nowhere"'), "cannot read cell/nowhere")
        fails(lambda text: text.replace("station:Press", "partner"), "'name' must be one station that X27 is connected to")
        fails(lambda text: text.replace("station:Press", "station:Belt"), "must be")
        fails(lambda text: text.replace('name = "Press"', 'name = "The Press"'), "'name' must be at most 32 letters")
        fails(lambda text: text.replace('name = "Press"\n', ""), "'[[station]]' needs name")
        fails(lambda text: text.replace('protocol = "ASCII"', 'protocol = "ASCII"\nmode = "RS485"'), "both with mode = \"RS485\"")
        fails(same, "'Belt' must be the name of a [[station]]: Press", "  expect Belt/M 0.0 = 0\n")
        fails(same, "X27 is connected to another station", '  serial X27 send "A"\n')
        fails(same, "X27 is connected to another station", '  expect serial X27 received "A"\n')
        fails(same, "M 4711.0", "  expect Press/M 4711.0 = 0\n")
        self.pair("ASCII")
        self.write("press/merker.toml", '[cpu]\nmodel = "314C-2 PtP"\n')
        self.assertIn("'folder' must be a project with a serial interface", self.expect(PROBLEMS, "check", "cell").err)
        self.write("press/merker.toml", '[cpu]\nmodel = "SINUMERIK 810 GA3"\n')
        self.assertIn("'folder' must be the project folder of a SIMATIC S7", self.expect(PROBLEMS, "check", "cell").err)
        self.pair("ASCII")
        self.write("press/main.awl", block("      L     MW 300"))
        self.assertIn("press/main.awl:4", self.expect(PROBLEMS, "check", "cell").err)

    def test_the_command_line_connects_something_else(self):
        self.pair("ASCII")
        self.assertIn("with [[station]]", self.expect(USAGE, "run", "cell", "--for", "1s", "--serial", "station:Press").err)
        call = self.expect(USAGE, "run", "cell", "--for", "1s", "--serial", "partner", "--print", "Press/MW 22")
        self.assertIn("'Press' is not a valid operand", call.err)


if __name__ == "__main__":
    unittest.main()
