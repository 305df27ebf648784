import pathlib

from harness import *

ROOT = pathlib.Path(__file__).resolve().parents[2]

LISTING = """OB 1
      U     E 0.0
      =     A 0.0
      L     MW 102
      L     KF +1
      +F
      T     MW 102
      U     E 0.7
      SPB   PB 5
      BE
PB 5
      SPA   PB 9
      BE
DB 10
   0 : KH = 1F00
   1 : KF = +5
"""

TOML = """[cpu]
model = "SINUMERIK 820 GA3"
[machine_data]
2 = 2
[plc]
alarms = "MB 100"
[alarm_texts]
6003 = "Coolant missing"
"""


class Step5(Case):
    def setUp(self):
        super().setUp()
        self.write("a.s5", LISTING)

    def test_runs(self):
        """S5-OPC-07: a single listing runs on an 810 GA3."""
        out = self.expect(GOOD, "run", "a.s5", "--for", "590ms", "--set", "E 0.0 = 1, DB10.DW 1 = KF -2",
                          "--print", "A 0.0, MW 102, DB10.DW 0, DB10.DL 0, DB10.D 0.8, DB10.DW 1").out
        self.assertEqual(out.splitlines(), ["A 0.0 = 1", "MW 102 = W#16#000A", "DB10.DW 0 = W#16#1F00", "DB10.DL 0 = B#16#1F",
                                            "DB10.D 0.8 = 1", "DB10.DW 1 = W#16#FFFE"])

    def test_a_fault_is_an_alarm(self):
        """S5-ERR-07"""
        call = self.expect(FAULT, "run", "a.s5", "--for", "1s", "--set", "E 0.7 = 1")
        self.assertIn("6105", call.err)

    def test_diag(self):
        """S5-ERR-06, S5-ERR-08, S5-ERR-10"""
        out = self.expect(FAULT, "diag", "a.s5", "--for", "1s", "--set", "E 0.7 = 1").out
        for words in ("6105", "PB 5", "OB 1", "SAZ", "Neustart"):
            self.assertIn(words, out)
        document = self.expect(FAULT, "diag", "a.s5", "--for", "1s", "--set", "E 0.7 = 1", "--json").json
        self.assertIn(6105, [alarm["number"] for alarm in document["alarms"]])

    def test_an_alarm_has_its_number_once(self):
        out = self.expect(FAULT, "diag", "a.s5", "--for", "1s", "--set", "E 0.7 = 1").lines
        alarms = out[out.index("Alarms and messages") + 1:out.index("History, newest first") - 1]
        self.assertEqual([(line.count("6105"), line.split(" s  ")[1]) for line in alarms],
                         [(0, "3 PLC-Stop"), (1, "6105 Fehlender MC5-Baustein (MC5 block missing)")])

    def test_the_text_of_an_alarm_has_a_limit(self):
        """docs/safety.md: 200 of them are kept, and sent to each browser that looks."""
        self.write("p/a.s5", LISTING)
        for length, code in ((200, GOOD), (201, PROBLEMS)):
            self.write("p/merker.toml", TOML.replace("Coolant missing", "x" * length))
            call = self.expect(code, "check", "p")
        self.assertIn("merker.toml:8:8: error: '6003' must be a text of at most 200 bytes [P0704]", call.err)

    def test_list_and_back(self):
        """S5-OPC-01"""
        out = self.expect(GOOD, "list", "a.s5", "--code").out
        self.assertIn("0000: C000             U     E 0.0", out)
        self.write("b.s5", self.expect(GOOD, "list", "a.s5", "--listing").out)
        again = self.expect(GOOD, "list", "b.s5", "--code").out
        self.assertEqual(out, again)
        self.assertEqual(self.expect(GOOD, "list", "a.s5", "--json").json["blocks"][0]["block"], "OB 1")

    def test_parameters_are_no_instructions(self):
        """S5-FB-06, 4.3.2: the jump over a parameter list is not shown, nobody's labels are not printed."""
        manual = str(ROOT / "examples/step5/09-formal-operands")
        code = self.expect(GOOD, "list", manual, "--code").out
        ob1 = code[code.index("OB 1 "):code.index("\nFB 201")]
        for line in ("SPA   FB 201", "NAME : ANTRIEB", "EIN  : E 20.0", "BERT : T 17", "Z1   : KH 7F0A", "Z2   : DW 20"):
            self.assertIn(line, ob1)
        for word in ("SPA   =", "LC ", "illegal", "KH C"):
            self.assertNotIn(word, ob1)
        listing = self.expect(GOOD, "list", manual, "--listing").out
        self.assertNotRegex(listing, r"M0\d\d")
        changer = self.expect(GOOD, "list", str(ROOT / "examples/step5/tool-changer"), "--listing").out
        self.assertNotRegex(changer, r"(?m)^M\d\d\d .*BE$")

    def test_block_addresses(self):
        """S5-MEM-07, 9.1.2: the block directory shows addresses."""
        rows = {line[:10].strip(): line.split()[-1] for line in self.expect(GOOD, "list", "a.s5").lines[1:]}
        self.assertEqual(int(rows["PB 5"], 16) - int(rows["OB 1"], 16), 15)
        blocks = self.expect(GOOD, "list", "a.s5", "--json").json["blocks"]
        self.assertEqual(blocks[0]["address"], rows["OB 1"])

    def test_comments_and_texts_stay(self):
        self.write("c.s5", "! the plant\nOB 1\n U E 0.0 ! start button\n BE\nDB 10\n 0: KS 'TEXT A'\n")
        out = self.expect(GOOD, "list", "c.s5", "--listing").out
        for words in ("! the plant", "! start button", "KS 'TEXT A'"):
            self.assertIn(words, out)

    def test_timers_as_lc_loads_them(self):
        """docs/formats/listing.md: beside KT a timer is what LC loads, beside KZ a counter."""
        self.write("t.s5", "OB 1\n U E 0.0\n L KT 500.1\n SI T 2\n BE\n")
        self.write("t.scn", "set T 1 = KT 500.1, Z 1 = KZ 12, Z 2 = 7\n  expect T 1 = KT 500.1\n  expect T 1 <> KT 050.2\n"
                   "  expect T 1 <= KT 050.2\n  expect T 1 = S5T#50S\n  expect Z 1 = KZ 12\n  expect Z 1 = 12\n"
                   "  expect Z 2 = KZ 7\n  wait 1s\n  expect T 1 < KT 500.1\n  expect T 1 > KT 480.1\n")
        self.expect(GOOD, "test", "t.s5")
        self.write("t.scn", "set T 1 = KT 500.1\n  expect T 1 = KT 400.1\n")
        self.assertIn("expected T 1 = KT 400.1, T 1 is KT 500.1", self.expect(PROBLEMS, "test", "t.s5").out)
        self.write("t.scn", "set Z 1 = KZ 12\n  expect Z 1 = KZ 13\n")
        self.assertIn("Z 1 is KZ 12", self.expect(PROBLEMS, "test", "t.s5").out)
        self.write("t.scn", "set T 1 = 500\n  expect T 1 = KT 400.1\n")
        self.assertIn("T 1 needs value and base, for example KT 500.1 (50 s), not 500", self.expect(PROBLEMS, "test", "t.s5").out)
        out = self.expect(GOOD, "run", "t.s5", "--for", "10ms", "--set", "T 1 = KT 500.1, Z 1 = KZ 12", "--print", "T 1, Z 1").out
        self.assertEqual(out.splitlines(), ["T 1 = KT 500.1", "Z 1 = KZ 12"])

    def test_stacks_in_scenarios(self):
        """S5-ERR-06, S5-ERR-08, S5-ERR-10, S5-ERR-15: the screens of any STOP, 6162 among them."""
        self.write("late.s5", "OB 1\n A DB 10\n L KF +7\n U E 0.0\n SPB PB 5\n BE\nPB 5\n L KH 1234\n SPA PB 9\n BE\n"
                   "DB 10\n 0: KH 0000\n")
        self.write("late.scn", """scenario "second edge"
  wait 1s
  expect ustack TIEFE <> 01 for 100ms
scenario "missing block"
  wait 1s
  set E 0.0 = 1
  expect ustack TIEFE = 01 within 1s
  expect ustack XX-NR. = PB 5
  expect ustack YY-NR = OB 1
  expect ustack DB-NR = DB 10
  expect ustack BEF-REG = 7509
  expect ustack REL-SAZ = 3
  expect ustack FEHLCODE = 69
  expect ustack ALARM = 6105
  expect ustack XXX3 = 0009
  expect ustack AKKU1 = 0000 1234
  expect ustack AKKU2 = KH 7
  expect ustack VKE = 1
  expect ustack RUFBST = 1
  expect ustack NAU = 0
  expect bstack ENTRIES = 1
  expect bstack 1 = OB 1
  expect bstack 1 DB = DB 10
  expect bstack 1 REL = 5
  expect bstack 2 = -
""")
        out = self.expect(PROBLEMS, "test", "late.s5").out
        self.assertIn("FAILED  late.scn: second edge", out)
        self.assertIn("the PLC is not in STOP, which the USTACK needs", out)
        self.assertIn("ok      late.scn: missing block", out)
        self.write("late.scn", "set E 0.0 = 1\n  wait 1s\n")
        self.assertIn("FEHLCODE 0069, BEF-REG 7509", self.expect(PROBLEMS, "test", "late.s5").out)
        self.write("late.scn", "set E 0.0 = 1\n  wait 1s\n  expect ustack TIEFFE = 1\n")
        self.assertIn("no field 'TIEFFE'; valid: TIEFE BEF-REG", self.expect(PROBLEMS, "test", "late.s5").out)
        self.write("s7.awl", PROGRAM)
        self.write("s7.scn", "expect ustack TIEFE = 01\n")
        self.assertIn("has no USTACK", self.expect(PROBLEMS, "test", "s7.awl").out)

    def test_processing_delay_has_its_stack(self):
        """S5-OB-11, S5-ERR-11: 6162 with zob2, after an edge while OB 2 runs."""
        self.write("ob2.s5", "OB 1\n BE\nOB 2\n" + " +G\n" * 60 + " BE\n")
        self.write("ob2.scn", "wait 100ms\n  set E 7.0 = 1\n  wait 6ms\n  set E 7.0 = 0\n  expect ustack ALARM = 6162 within 1s\n"
                   "  expect ustack ZOB2 = 1\n  expect ustack XXX1 = 2\n  expect ustack XX-NR = OB 2\n  expect ustack WECKFE = 1\n")
        self.expect(GOOD, "test", "ob2.s5")
        self.write("long.s5", "OB 1\n BE\nOB 2\n" + " +G\n" * 12 + " BE\n")
        self.write("long.scn", "wait 100ms\n  set E 7.0 = 1\n  expect ustack FEHLCODE = A0 within 1s\n  expect ustack WECKFE = 1\n")
        self.expect(GOOD, "test", "long.s5")

    def test_diag_after_a_scenario(self):
        self.write("late.s5", "OB 1\n U E 0.0\n SPB PB 5\n U E 0.1\n SPB PB 6\n BE\n")
        self.write("late.scn", "scenario \"first\"\n  wait 200ms\n  set E 0.0 = 1\n  wait 100ms\n  set E 0.0 = 0\n  warm restart\n"
                   "scenario \"other\"\n  set E 0.1 = 1\n  wait 100ms\n")
        out = self.expect(FAULT, "diag", "late.s5", "--scenario", "late.scn").out
        for words in ("BEF-REG: 5505", "F004 0005  xxx3"):
            self.assertIn(words, out)
        self.assertIn("F004 0006  xxx3", self.expect(FAULT, "diag", "late.s5", "--scenario", "late.scn", "--name", "other").out)
        self.assertIn("RUN after", self.expect(GOOD, "diag", "late.s5", "--scenario", "late.scn", "--line", "2").out)
        self.assertIn("no scenario of late.scn", self.expect(USAGE, "diag", "late.s5", "--scenario", "late.scn", "--name", "x").err)
        self.expect(UNREADABLE, "diag", "late.s5", "--scenario", "none.scn")

    def test_system_blocks_take_no_values(self):
        """S5-DB-12, 3.1: only the trigger DW 9 of DB 1."""
        for operand in ("DB1.DW 0", "DB36.DW 2", "DB1.DD 9"):
            err = self.expect(USAGE, "run", "a.s5", "--for", "1s", "--set", f"{operand} = 5").err
            self.assertIn("belongs to the system", err)
        self.expect(GOOD, "run", "a.s5", "--for", "1s", "--set", "DB1.DW 9 = KH 8000")

    def test_an_endless_start(self):
        self.write("loop.s5", "OB 1\n BE\nOB 20\n SPA FB 1\nNAME : LOOP\n BE\nFB 1\nNAME : LOOP\nM1 : SPA =M1\n BE\n")
        call = self.expect(PROBLEMS, "run", "loop.s5", "--for", "1s", "--json")
        self.assertEqual(call.json["mode"], "STARTUP")
        self.assertAlmostEqual(call.json["seconds"], 1.0, places=3)
        self.assertIn("still in STARTUP", call.err)
        self.assertAlmostEqual(self.expect(PROBLEMS, "diag", "loop.s5", "--for", "1s", "--json").json["seconds"], 1.0, places=3)

    def test_symbols_of_an_assignment_list(self):
        """docs/formats/listing.md: -NAME, tabs or fixed columns, upper and lower case alike."""
        self.write("s.s5", "OB 1\n SPA -FOLGE\n BE\nPB 5\n U -start\n O -1S3\n = \"Motor\"\n L -SOLL\n BE\n")
        err = self.expect(PROBLEMS, "check", "s.s5").err
        self.assertIn('s.s5:5:4: error: symbol "start" is not in the symbol table [P0303]', err)
        self.assertEqual(err.count("P0303"), 5)
        self.write("sZ0.SEQ", "; Pumpe\n\tE 1.0\tSTART\tTaster\n\tE 1.1\t1S3\n\tA 2.0\tMOTOR\n\tPB 5\tFOLGE\n\tDB 20\tDATEN\n"
                              "\tMW 30\tSOLL\n")
        self.expect(GOOD, "check", "s.s5")
        self.write("sZ0.SEQ", "  E 1.0     START     Taster\n  E 1.1     1S3\n  A 2.0     MOTOR\n  PB 5      FOLGE\n"
                              "  MW 30     SOLL\n")
        self.expect(GOOD, "check", "s.s5")
        out = self.expect(GOOD, "run", "s.s5", "--for", "1s", "--set", "-START = 1", "--print", "-MOTOR, \"motor\", A 2.0").out
        self.assertEqual(out, "-MOTOR = 1\n\"motor\" = 1\nA 2.0 = 1\n")
        self.assertIn('symbol "NIE" is not in the symbol table',
                      self.expect(USAGE, "run", "s.s5", "--for", "1s", "--print", "-NIE").err)
        self.write("s.scn", 'scenario "symbols"\n  set -START = 1\n  wait 2 cycles\n  expect -MOTOR = 1\n  set -SOLL = KF +7\n'
                            '  expect MW 30 = -SOLL\n')
        self.expect(GOOD, "test", "s.scn")
        self.assertIn("START", self.expect(GOOD, "xref", "s.s5").out)
        listing = self.expect(GOOD, "list", "s.s5", "--listing", "--symbols").out
        self.assertIn("SPA   -FOLGE", listing)
        self.assertIn("U     -START", listing)
        self.assertIn("U     E 1.0", self.expect(GOOD, "list", "s.s5", "--listing").out)

    def test_wrong_assignments_are_told_with_their_place(self):
        self.write("a.s5", LISTING)
        self.write("aZ0.SEQ", "\tE 1.0\tEIN\n\tE 1.1\tein\n\tFX 3\tFERN\n")
        err = self.expect(PROBLEMS, "check", "a.s5").err
        self.assertIn("aZ0.SEQ:2:8: error: symbol 'ein' already exists (aZ0.SEQ:1) [P0807]", err)
        self.assertIn("aZ0.SEQ:3:2: error: 'FX 3' is not a valid operand [P1104]", err)

    def test_jumps_are_for_function_blocks(self):
        self.write("j.s5", "PB 1\n SPA =X\n BE\n")
        self.assertIn("SPA =X is a supplementary operation", self.expect(PROBLEMS, "check", "j.s5").err)

    def test_a_project_names_its_assignment_list(self):
        """docs/formats/listing.md"""
        self.write("p/a.s5", LISTING + "\nPB 77\n U -START\n = -ENDE\n BE\n")
        self.write("p/lists/p.seq", "  E 1.0     START     Taster\n  A 1.7  ENDE\n")
        self.write("p/merker.toml", TOML + '[program]\nsymbols = ["lists/*.seq"]\n')
        self.expect(GOOD, "check", "p")
        self.write("p/merker.toml", TOML + '[program]\nsymbols = []\n')
        self.assertEqual(self.expect(PROBLEMS, "check", "p").err.count("P0303"), 2)

    def test_help_speaks_of_listings(self):
        self.assertIn("*.s5", self.expect(GOOD, "--help").out)

    def test_machine_code(self):
        self.assertEqual(self.expect(GOOD, "assemble", "--mc5", text="P D 205.10\n").out, "7046 CACD\n")
        self.assertIn("P     D 205.10", self.expect(GOOD, "disassemble", "--mc5", text="7046 CACD").out)
        self.assertIn("illegal", self.expect(GOOD, "disassemble", "--mc5", text="7007").out)

    def test_disassembly_comes_back(self):
        """S5-OPC-01: whatever words there are, assembling their disassembly gives them again."""
        words = "30B0 ABCD 30C1 ABCD 30F5 BEEF 7007 3010 4142 3001 FFFF C000 6500"
        text = self.expect(GOOD, "disassemble", "--mc5", text=words).out
        self.assertEqual(self.expect(GOOD, "assemble", "--mc5", text=text).out.split(), words.split())
        self.assertEqual(self.expect(GOOD, "assemble", "--mc5", text="SPA 5\nSPB -5\n").out, "2D05\nFAFB\n")
        words = "3D05 2D03 3040 C002 C000 6500"  # parameters behind a call
        text = self.expect(GOOD, "disassemble", "--mc5", text=words).out
        self.assertIn("KH 3040", text)
        self.assertEqual(self.expect(GOOD, "assemble", "--mc5", text=text).out.split(), words.split())
        text = self.expect(GOOD, "disassemble", "--mc7", text="FF07 C000 65").out
        self.assertEqual(self.expect(GOOD, "assemble", "--mc7", text=text).out.split(), ["FF07", "C000", "65"])

    def test_memory_full(self):
        """S5-SCHED-13, S5-DB-16, S5-MEM-08: what finds no room is a problem, not a block that is missing."""
        data = "".join(f"DB {n}\n" + " KH 0\n" * 1019 for n in (10, 11, 12))
        self.write("a.s5", "OB 1\n : BE\n" + data)
        self.assertIn("segment 6 (user data): 3072 of 3072 words used, 0 free", self.expect(GOOD, "list", "a.s5").out)
        self.assertEqual(self.expect(GOOD, "list", "a.s5", "--json").json["memory"][0],
                         {"segment": 5, "used": 6, "words": 8192})
        self.write("a.s5", "OB 1\n : BE\n" + data + "DB 13\n KH 0\n")
        for command in (("check",), ("run", "--for", "1s"), ("test",)):
            call = self.expect(PROBLEMS, command[0], "a.s5", *command[1:])
            self.assertIn("P1144", call.err)
            self.assertIn("memory full: DB 13 needs 6 words", call.err)
        block = "".join(f"PB {n}\n" + " : NOP 0\n" * 4000 + " : BE\n" for n in (1, 2))
        self.write("a.s5", "OB 1\n : BE\n" + block)
        self.expect(GOOD, "check", "a.s5")
        self.assertIn("PB 2", self.expect(PROBLEMS, "check", "a.s5", "--cpu", "SINUMERIK 810 GA3 COP").err)

    def test_fine_error_coding(self):
        """S5-ERR-11, S5-ERR-12, S5-MEM-05: the pseudo addresses of the programmer."""
        arguments = ("diag", "a.s5", "--for", "1s", "--set", "E 0.7 = 1")
        out = self.expect(FAULT, *arguments).out
        for line in ("F000 0069  FEHLCODE", "F001 6105  alarm", "F004 0009  xxx3", "F00E "):
            self.assertIn(line, out)
        self.assertIn("Block stack (BSTACK)", out)
        rows = self.expect(FAULT, *arguments, "--json").json["fine_error_code"]
        self.assertEqual((rows["F001"], rows["F004"], len(rows)), ("6105", "0009", 11))
        self.assertNotEqual(rows["F00C"], rows["F011"])

    def test_places_of_alarm_bits(self):
        """OP-55, S5-DB-08: what merker.toml names must be there."""
        for line, words in (("alarms = \"MB 250\"", "MB 248"), ("alarms = \"DB10.DW 0\"", "P1153"),
                            ("messages = \"DB 9.DW 0\"", "P1153"), ("eprom_data_blocks = [300]", "DB 300 is outside")):
            self.write("merker.toml", f"[cpu]\nmodel = \"SINUMERIK 820 GA3\"\n[plc]\n{line}\n")
            call = self.expect(PROBLEMS, "check", ".")
            self.assertIn("merker.toml:4:", call.err)
            self.assertIn(words, call.err)
        self.write("merker.toml", "[cpu]\nmodel = \"SINUMERIK 820 GA3\"\n[plc]\nalarms = \"MB 248\"\n")
        self.expect(GOOD, "check", ".")

    def test_project(self):
        """S5-MD-01, S5-ERR-04: machine data, alarms and their texts stand in merker.toml."""
        self.write("merker.toml", TOML)
        self.assertIn("Coolant missing", self.expect(GOOD, "diag", ".", "--for", "1s", "--set", "M 100.3 = 1").out)
        cycles = self.expect(GOOD, "run", ".", "--for", "800ms", "--json").json["cycles"]
        self.assertEqual(cycles, 20)  # MD 2 = 2: every 40 ms
        for wrong, place in (("3000 = 1", "3:1"), ("2 = 70000", "3:5"), ("155 = \"x\"", "3:7")):
            self.write("merker.toml", f"[cpu]\nmodel = \"SINUMERIK 820 GA3\"\n{wrong}\n".replace(
                "GA3\"\n", "GA3\"\n[machine_data]\n"))
            call = self.expect(PROBLEMS, "check", ".")
            self.assertIn(f"merker.toml:{int(place[0]) + 1}:{place[2:]}", call.err)

    def test_families_do_not_mix(self):
        self.assertIn("P0707", self.expect(PROBLEMS, "check", "a.s5", "--cpu", "314C-2 PtP").err)
        self.write("a.awl", PROGRAM)
        self.assertIn("P0711", self.expect(PROBLEMS, "check", "a.awl", "--cpu", "SINUMERIK 810 GA3").err)
        self.assertIn("SIMATIC S7", self.expect(USAGE, "hw", "a.s5").err)

    def test_cross_reference(self):
        """S7-EDIT-22 for STEP 5: the same list with its filters."""
        out = self.expect(GOOD, "xref", "a.s5").out
        self.assertRegex(out, r"E 0\.0 +R +OB 1 +1 +1 +U +E 0\.0 +a\.s5:2")
        self.assertRegex(out, r"MW 102 +R +OB 1 +1 +3 .*\n +W +OB 1 +1 +6 +T +MW 102 +a\.s5:7")
        self.assertRegex(out, r"PB 9 +- +PB 5 +1 +1 +SPA +PB 9 +a\.s5:12")
        rows = self.expect(GOOD, "xref", "a.s5", "--operand", "MB 103", "--json").json["references"]
        self.assertEqual([row["use"] for row in rows], ["R", "W"])
        self.assertEqual(rows[1]["place"], {"block": "OB 1", "offset": 6, "file": "a.s5", "line": 7, "network": 1})
        self.assertIn("QQ", self.expect(USAGE, "xref", "a.s5", "--operand", "QQ 1").err)

    def test_cross_reference_of_a_project(self):
        """S5-FB-16: actual operands as the function block uses them; S5-DB-06: data of the open block."""
        manual = str(ROOT / "examples/step5/09-formal-operands")
        uses = {(row["operand"], row["use"], row["instruction"])
                for row in self.expect(GOOD, "xref", manual, "--json").json["references"]}
        for use in (("T 17", "RW", "SPA   FB 203"), ("M 105.0", "W", "SPA   FB 202"), ("DB10.DW 20", "R", "SPA   FB 206"),
                    ("Z 15", "RW", "SPA   FB 204"), ("=BERT", "W", "SSV   =BERT")):
            self.assertIn(use, uses)
        assignment = self.expect(GOOD, "xref", manual, "--assignment", "--json").json
        self.assertEqual((assignment["timers"], assignment["counters"]), ([16, 17, 18], [15]))
        self.assertIn("EB 20     . . . . X X X X", self.expect(GOOD, "xref", manual, "--assignment").out)
        self.assertIn("E 20.0", self.expect(GOOD, "xref", manual, "--unused").out)

    def test_both_engines_give_the_same(self):
        for engine in ("interpreter", "jit"):
            self.expect(GOOD, "run", "a.s5", "--for", "1s", "--set", "E 0.0 = 1", "--engine", engine,
                        "--watch", "A 0.0, MW 102", "--trace", f"{engine}.csv")
        self.assertEqual(self.read("interpreter.csv"), self.read("jit.csv"))
        for example in ("09-basic-operations", "tool-changer"):
            self.expect(GOOD, "test", str(ROOT / "examples/step5" / example), "--engine", "jit")

    def test_scenarios(self):
        self.write("a.scn", "scenario \"follows\"\n  set E 0.0 = 1\n  wait 2 cycles\n  expect A 0.0 = 1\n"
                            "  expect MW 102 > KH 0001\n  power off\n  power on\n  expect mode = RUN within 1s\n"
                            "scenario \"stops\"\n  set E 0.7 = 1\n  expect mode = STOP within 1s\n"
                            "  expect diagnostics contains \"6105\"\n"
                            "scenario \"no LED\"\n  expect LED SF = on\n")
        call = self.expect(PROBLEMS, "test", "a.s5")
        self.assertIn("2 passed, 1 failed", call.out)
        self.assertIn("SINUMERIK 810 GA3 has no LEDs", call.out)

    def test_bench(self):
        for engine in ("interpreter", "jit"):
            values = self.expect(GOOD, "bench", "a.s5", "--for", "50ms", "--json", "--engine", engine).json
            self.assertEqual(set(values), {"instructions_per_second", "cycles_per_second", "translation_seconds"})
            self.assertAlmostEqual(values["instructions_per_second"] / values["cycles_per_second"], 9, delta=0.5)
        self.write("stops.s5", "OB 1\n : SPA PB 9\n : BE\n")
        self.assertIn("6105", self.expect(FAULT, "bench", "stops.s5", "--for", "50ms").err)
        self.write("loop.s5", "OB 1\n : SPA FB 20\nNAME : LOOP\n : BE\nFB 20\nNAME : LOOP\nM001 : SPA =M001\n : BE\n")
        self.assertIn("did not end", self.expect(GOOD, "bench", "loop.s5", "--for", "50ms", timeout=60).err)
        self.write("none.s5", "PB 1\n : BE\n")
        self.assertIn("no OB 1", self.expect(PROBLEMS, "bench", "none.s5").err)
