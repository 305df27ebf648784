import re

from harness import *

# OB 1 counts its cycles in MW 120; E 0.7 leads to alarm 6103 in line 25.
LISTING = """OB 1
      L     MW 120
      L     KF +1
      +F
      T     MW 120
      SPA   FB 5
NAME  : VENTIL
EIN   : E 1.0
      SPA   PB 5
      U     E 0.7
      SPB   PB 6
      BE
PB 5
      A     DB 10
      L     DW 1
      L     KF +4
      +F
      T     MW 110
      U     E 0.6
      BEB
      T     MW 114
      BE
PB 6
      L     KF +1
      T     DW 2
      BE
FB 5
NAME  : VENTIL
BEZ   : EIN  E/A/D/B/T/Z: E  BI/BY/W/D: BI
      U     =EIN
      =     M 101.0
      BE
OB 20
      L     KH 1234
      T     MW 150
      BE
DB 10
   0 : KH = 1F00
   1 : KF = +5
"""

S7_ONLY = ("DI ", "MCR", "L stack", "priority", "AR1", "BIE", "clock", "load memory", "local data", "W#16#00", "1990-")


class Step5Debug(Case):
    """merker debug over a SINUMERIK"""

    def setUp(self):
        super().setUp()
        self.write("a.s5", LISTING)

    def debug(self, *commands, code=GOOD):
        return self.expect(code, "debug", "a.s5", text="".join(line + "\n" for line in commands)).out

    def shown(self, *commands):
        """The lines at which the program stood."""
        return re.findall(r"^=>.\s+(\d+) ", self.debug(*commands), re.MULTILINE)

    def test_a_breakpoint_is_halt_with_registers(self):
        """S7-STATE-07 as docs/compatibility.md has it for a SINUMERIK"""
        out = self.debug("break PB 5:17", "run", "registers", "where")
        self.assertIn("breakpoint 1 at PB 5 word 4 (a.s5:17), network 1\n", out)
        self.assertIn("HALT at breakpoint 1, ", out)
        self.assertIn("AKKU1 0000 0004 (KF +4)  AKKU2 0000 0005 (KF +5)\n"
                      "ANZ1 1  ANZ0 0  OVFL 0  OVFLS 0  ODER 0  STATUS 0  VKE 0  ERAB 0\nDB 10\n", out)
        self.assertRegex(out, r"  0  PB 5 word 4 \(a\.s5:17\) +DB 10\n  1  OB 1 word 9 \(a\.s5:10\) +DB -\n")

    def test_nothing_of_an_s7_is_shown(self):
        out = self.debug("break FB 5", "run", "where", "registers", "stack", "info", "diag", "delete all", "set E 0.7 = 1", "continue",
                         "where", "registers", "stack", "info", "diag")
        for words in S7_ONLY:
            self.assertNotIn(words, out)
        self.assertIn("I stack\nOB 1, at FB 5 word 0 (a.s5:30)\n", out)
        self.assertIn("brackets 0\n", out)

    def test_places(self):
        for place in ("PB5:17", "PB 5:17", "a.s5:17", "17", "PB 5 word 4"):
            self.assertIn("(a.s5:17)", self.debug("break " + place), place)
        self.assertIn("(a.s5:14)", self.debug("break PB 5 network 1"))
        self.assertIn("PB 5 word 6", self.debug("break nonsense", code=PROBLEMS))

    def test_steps(self):
        self.assertEqual(self.shown("b 6", "run", "delete 1", "s", "s", "s", "s", "next", "next", "next", "next"),
                         ["6", "30", "31", "32", "9", "10", "11", "12", "2"])
        self.assertEqual(self.shown("b PB 5:15", "run", "delete 1", "out", "out"), ["15", "10", "2"])
        self.assertEqual(self.shown("b 6", "run", "si", "si"), ["6", "30", "31"])
        self.assertEqual(self.shown("b OB 20", "run", "s", "s"), ["34", "35", "36"])

    def test_program_status(self):
        out = self.debug("status on PB 5", "set E 0.6 = 1", "run 100ms", "status", "status all", "status off")
        self.assertRegex(out, r"\n   17   \d   \d  00000009 +\+F\n")
        self.assertRegex(out, r"\n   20   1   1  00000009 +BEB\n   21 {25,}T     MW 114\n")
        self.assertRegex(out, r" 10 +- +L     DW 1\n")  # DB, no DI
        self.assertIn("program status is off\n", out)

    def test_list_and_inspect(self):
        out = self.debug("break 17", "run", "list", "blocks", "xref MW 110, DB 10", "locals")
        self.assertIn("=>*   17        +F\n", out)
        self.assertRegex(out, r"FB 5 +VENTIL +3 words\n")
        self.assertRegex(out, r"MW 110 +W +T     MW 110 +PB 5 word 5 \(a\.s5:18\), network 1\n")
        self.assertRegex(out, r"DB 10 +- +A     DB 10 ")
        self.assertIn("no declared variables here\n", out)

    def test_a_fault(self):
        """S5-ERR-08: the place is the instruction; the text names the step counter behind it."""
        out = self.debug("set E 0.7 = 1", "run", "where", "diag 1")
        self.assertIn("STOP: 6103 Transfer in fehlenden DB (transfer to missing DB), PB 6 word 3, ", out)
        self.assertRegex(out, r"=>.\s+25 +T +DW 2")
        self.assertRegex(out, r"  0  PB 6 word 2 \(a\.s5:25\) +DB -\n")
        self.assertRegex(out, r"  1  \d\.\d+ s  STOP: 6103 .*, PB 6 word 3\n       at PB 6 word 2 \(a\.s5:25\)\n")

    def test_information(self):
        out = self.debug("info", "restart", "cycle 3", "info")
        self.assertIn("SINUMERIK 810 GA3  STOP\ntime 0.000 s\ncycles 0  instructions 0  cycle monitoring 70 ms\nblocks 6  work memory ", out)
        self.assertRegex(out, r"cycles 3  instructions \d+  every 0\.060 s  program 0\.\d+ s in the last one \(0\.\d %\)  "
                              r"cycle monitoring \d+ ms\n")

    def test_values(self):
        out = self.debug("set MW 110 = KF -2, DB10.DW 1 = KH 00FF, nc.R 5 = 3, T 5 = KT 010.2",
                         "print MW 110 DEC, DB10.DW 1, nc.R 5, T 5", "watch MW 120 DEC", "restart", "cycle 2")
        self.assertIn("MW 110 = -2\nDB10.DW 1 = W#16#00FF\nnc.R 5 = 3\nT 5 = KT 10.2\n", out)
        self.assertIn("1: MW 120 = 2", out)

    def test_forces(self):
        out = self.debug("force E 0.6 = 1, M 130.0 = 1", "force", "set E 0.6 = 0", "restart", "cycle 2", "print E 0.6, M 130.0",
                         "unforce", "force")
        self.assertIn("E 0.6 = 1\nM 130.0 = 1\n", out)
        self.assertTrue(out.endswith("E 0.6 = 1\nM 130.0 = 1\nno forces\n"))
        for line, number in (("set M 130.0 = 0", "P1217"), ("set MB 130 = 0", "P1217"), ("force MB 130 = 0", "P1219"),
                             ("force DB10.DW 1 = 1", "P1211"), ("force T 1 = 1", "P1211"), ("set DB1.DW 0 = 1", "P0988"),
                             ("set DB99.DW 0 = 1", "P1213"), ("print #x", "P1216"), ("break FC 1", "P1201")):
            self.assertIn(number, self.debug("restart", "force M 130.0 = 1", line, code=PROBLEMS), line)

    def test_names_of_the_assignment_list(self):
        """S7-EDIT-22 for STEP 5: a name is written as listings write it."""
        self.write("aZ0.SEQ", "\tPB 5\tPUMPE\r\n\tDB 10\tDATEN\r\n\tDW 1\tANZAHL\r\n\tE 0.7\tENDE\r\n")
        for place in ("-PUMPE", "-PUMPE:17", '"PUMPE"', "-PUMPE network 1", "-PUMPE word 4"):
            self.assertIn("breakpoint 1 at PB 5 word", self.debug("break " + place), place)
        self.assertIn("P1201", self.debug("break -DATEN", "break -NICHTS", code=PROBLEMS))
        self.assertIn("program status of PB 5 is on", self.debug("status on -PUMPE"))
        for name, row in (("-PUMPE", "PB 5 +-"), ('"PUMPE"', "PB 5 +-"), ("-DATEN", "DB10.DW 1 +R"), ("-ANZAHL", "DB10.DW 1 +R"), ("-ENDE", "E 0.7 +R")):
            self.assertRegex(self.debug("xref " + name), row, name)
        unused = self.expect(GOOD, "xref", "a.s5", "--unused").out
        self.assertNotIn("ANZAHL", unused.split("operands without symbol")[0])

    def test_there_is_no_di(self):
        self.assertIn("this PLC has no DI register", self.debug("status on PB 5 di 3", code=PROBLEMS))
        out = self.debug("status on PB 5 db 7", "run 100ms", "status")
        self.assertRegex(out, r"PB 5 has been called, but not under the conditions of its program status\n")

    def test_a_word_behind_the_end(self):
        self.assertIn("error: PB 5 word 1000: PB 5 has 10 words", self.debug("break PB 5 word 1000", code=PROBLEMS))

    def test_cycles_have_a_limit_of_time(self):
        self.assertRegex(self.debug("restart", "cycle 2000"), r"the limit of 60\S* s is reached; \d+ cycles are left\n")

    def test_says_why_a_value_is_refused(self):
        """S5-TIMER-11, S5-NUM-04; docs/formats/nc.md"""
        for line, text in (("set nc.R 5 = 123456789", "nc.R 5 cannot be set: it takes numbers of at most eight digits"),
                           ("set nc.alarm 3016 = 5", "it takes whole numbers from 0 to 1"), ("set T 1 = 1000 DEC", "it takes KT 000.0 to KT 999.3"),
                           ("set Z 1 = FFFF HEX", "it takes KZ 000 to KZ 999"), ("print E 0.8", "bit 8 is outside 0..7"),
                           ("force EB 130 = 0", "number 130 is outside 0..127"), ("set MD 100 = 4294967296", "(32 bits)"),
                           ("force A 0.1 = 1, A 0.1 = 0", "A 0.1 cannot be set: the list names it twice")):
            out = self.debug(line, "print MW 120", code=PROBLEMS)
            self.assertIn(text, out)
            self.assertTrue(out.endswith("MW 120 = W#16#0000\n"), out)  # it goes on

    def test_two_bytes_are_one_value(self):
        """S5-NUM-05: the comma of KY"""
        out = self.debug("set MW 110 = KY 1,2, MW 112 = KY 003,4", "force MW 114 = KY 5,6", "print MW 110, MW 112, MW 114")
        self.assertTrue(out.endswith("MW 110 = W#16#0102\nMW 112 = W#16#0304\nMW 114 = W#16#0506\n"), out)

    def test_restarts(self):
        """S5-OB-02, S5-OB-03: a warm restart keeps the flags; `run` and `restart` are Neustart."""
        for command, kept, name in (("restart warm", "7", "Wiederanlauf"), ("restart cold", "0", "Neustart"), ("restart", "0", "Neustart")):
            out = self.debug("restart", "cycle 1", "set MW 130 = 7", command, "cycle 1", "print MW 130 DEC", "diag")
            self.assertIn(f"MW 130 = {kept}\n", out, command)
            self.assertRegex(out, rf"  2  \S+ s  {name}")

    def test_breakpoints_survive_stop_and_restart(self):
        out = self.debug("break 17", "run", "stop", "where", "run", "break")
        self.assertEqual(out.count("HALT at breakpoint 1"), 2)
        self.assertRegex(out, r"STOP\n  0  PB 5 word 4 \(a\.s5:17\)")
        self.assertIn("2 hits", out)


class Step5Diag(Case):
    def setUp(self):
        super().setUp()
        self.write("a.s5", LISTING)

    def test_shows_what_the_monitor_shows(self):
        """S5-ERR-06, S5-ERR-08, S5-ERR-10"""
        out = self.expect(FAULT, "diag", "a.s5", "--for", "1s", "--set", "E 0.7 = 1").out
        for text in ("STOP: 6103", "History, newest first\n", "PB 6 word 2 (a.s5:25)\n",
                     "\nB stack\n  0  PB 6 word 2 (a.s5:25)", "\nI stack\nOB 1, at PB 6 word 2", "\nControl bits\n", "TIEFE: 01"):
            self.assertIn(text, out)
        for words in S7_ONLY:
            self.assertNotIn(words, out)

    def test_json(self):
        document = self.expect(FAULT, "diag", "a.s5", "--for", "1s", "--set", "E 0.7 = 1", "--json").json
        self.assertEqual((document["module"]["mode"], document["module"]["clock"], document["module"]["load_memory"]), ("STOP", None, None))
        self.assertEqual(document["module"]["cycle_ms"]["raster"], 60)
        self.assertEqual((document["mode"], document["diagnostics"][-1]["event"]), ("STOP", 6103))
        self.assertEqual([(entry["place"]["block"], entry["di"]) for entry in document["stacks"]["blocks"]], [("PB 6", None), ("OB 1", None)])
        self.assertEqual((document["stacks"]["interrupts"][0]["ob"], document["stacks"]["interrupts"][0]["mcr"]), (1, None))
        self.assertIn("TIEFE: 01", document["interrupt_stack"])
        self.assertEqual([alarm["number"] for alarm in document["alarms"]][-1], 6103)
