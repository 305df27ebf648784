import os
import pty
import re
import select
import subprocess
import termios
import time

from harness import *

# Line 5 begins FC 1, line 11 OB 1; E 0.7 leads to a fault in line 15.
SOURCE = """FUNCTION FC 1 : INT
VAR_INPUT in : INT; END_VAR
BEGIN
NETWORK
      L     #in
      L     7
      +I
      T     #RET_VAL
END_FUNCTION
ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      CALL  FC 1 (in := MW 10, RET_VAL := MW 12)
      U     E 0.7
      SPBN  good
      AUF   DB 99
good: NOP   0
END_ORGANIZATION_BLOCK
"""


# DB 1 holds a STRING and a DT; FB 1 a multiple instance; FC 2 takes both by reference.
DATA = """DATA_BLOCK DB 1
STRUCT
  s : STRING [5] := 'abc';
  d : DT := DT#1999-01-02-03:04:05.678;
END_STRUCT
BEGIN
END_DATA_BLOCK
FUNCTION_BLOCK FB 1
VAR_INPUT q : BOOL; END_VAR
VAR
  t1 : SFB 4;
  n : STRING [4] := 'xy';
END_VAR
VAR_TEMP x : INT; END_VAR
BEGIN
NETWORK
      L     #x
      CALL  #t1 (IN := #q, PT := T#5S)
END_FUNCTION_BLOCK
FUNCTION FC 2 : VOID
VAR_INPUT d : DT; b : STRING; k : INT; END_VAR
BEGIN
NETWORK
      L     #k
END_FUNCTION
DATA_BLOCK DB 10 FB 1
BEGIN
END_DATA_BLOCK
ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      CALL  FB 1, DB 10 (q := M 0.0)
      CALL  FC 2 (d := DB1.d, b := DB1.s, k := MW 20)
END_ORGANIZATION_BLOCK
"""


class Debug(Case):
    def setUp(self):
        super().setUp()
        self.write("a.awl", SOURCE)

    def debug(self, *commands, code=GOOD):
        return self.expect(code, "debug", "a.awl", text="".join(line + "\n" for line in commands)).out

    def test_a_breakpoint_is_halt_with_registers(self):
        """S7-STATE-07"""
        out = self.debug("set MW 10 = 5", "break FC1:7", "run", "registers", "where")
        self.assertIn("breakpoint 1 at FC 1 byte", out)
        self.assertIn("HALT at breakpoint 1", out)
        self.assertIn("AKKU1 DW#16#00000007 (7)  AKKU2 DW#16#00000005 (5)", out)
        self.assertRegex(out, r"0  FC 1 byte \d+ \(a.awl:7\)")
        self.assertRegex(out, r"1  OB 1 byte \d+ \(a.awl:13\)")

    def test_places(self):
        for place in ("FC1:7", "FC 1:7", "a.awl:7", "7"):
            self.assertIn("(a.awl:7)", self.debug("break " + place), place)
        self.assertIn("(a.awl:13)", self.debug("break OB 1 network 1"))

    def test_steps(self):
        out = self.debug("b 13", "run", "delete 1", "s", "s", "next", "out")
        at = re.findall(r"^=>.\s+(\d+) ", out, re.MULTILINE)
        self.assertEqual(at, ["13", "5", "6", "7", "14"])

    def test_program_status(self):
        """S7-EDIT-21"""
        out = self.debug("set MW 10 = 5", "status on FC 1", "run 100ms", "status", "status all", "status off")
        self.assertRegex(out, r"\n +7 +\d +\d +0000000C +\+I")
        self.assertIn("AR1", out)
        self.assertIn("error: program status is off", self.debug("status", code=PROBLEMS))

    def test_cycle_and_until(self):
        """S7-SIM-13"""
        out = self.debug("restart", "cycle 3", "info", "until 2s")
        self.assertIn("cycles 3 ", out)
        self.assertRegex(out, r"RUN, 2\.\d+ s")

    def test_values(self):
        """S7-SIM-12"""
        out = self.debug("set MW 10 = 00FF HEX, E 1.0 = 1", "print MW 10, MW 10 DEC, MW 10 BIN", "watch MW 12 DEC", "restart", "set E 1.0 = 1", "cycle 2",
                         "force E 1.1 = 1", "force", "cycle 2", "p E 1.1, E 1.0", "unforce", "force")
        self.assertIn("MW 10 = W#16#00FF\nMW 10 = 255\nMW 10 = 2#0000_0000_1111_1111\n", out)
        self.assertIn("1: MW 12 = 262", out)
        self.assertIn("E 1.1 = 1\n", out)
        self.assertTrue(out.endswith("no forces\n"))

    def test_a_fault(self):
        """S7-DIAG-01, S7-DIAG-04"""
        out = self.debug("set E 0.7 = 1", "run", "where", "stack", "diag 2")
        self.assertIn("STOP: ", out)
        self.assertRegex(out, r"=>.\s+16 +AUF +DB 99")
        self.assertIn("I stack\nOB 1, priority 1", out)
        self.assertRegex(out, r"1  \d{4}-\d\d-\d\d .* 16#4562")
        self.assertRegex(out, r"2  \d{4}-\d\d-\d\d .* 16#253A")

    def test_strings_and_dates(self):
        """S7-SIM-12, S7-TYPES-18, S7-TYPES-19"""
        self.write("a.awl", DATA)
        out = self.debug("set DB1.s = 'xyz', DB1.d = DT#2001-02-03-04:05:06.700", "print DB1.s, DB1.d, DB1.DBB 0", "watch DB1.s")
        self.assertIn("DB1.s = 'xyz'\nDB1.d = DT#2001-02-03-04:05:06.700\nDB1.DBB 0 = B#16#05\n", out)
        self.assertIn("1: DB1.s = 'xyz'", out)
        for wrong, number in (("set DB1.s = 'toolong'", "P0961"), ("set DB1.s = 5", "P0960"), ("print DB1.d HEX", "P1209")):
            self.assertIn(number, self.debug(wrong, code=PROBLEMS))

    def test_variables_of_the_running_block(self):
        """S7-SIM-12, S7-PAR-10"""
        self.write("a.awl", DATA)
        out = self.debug("break FB 1", "run", "locals", "set #x = 12, #n = 'hi', #q = 1", "print #x, #n, #q, DB10.n, #t1.ET",
                         "watch #x", "break FC 2", "continue", "locals", "set #k = 55", "print MW 20")
        self.assertRegex(out, r"STAT +#t1\.PT +TIME +T#0MS\n")
        self.assertIn("#x = 12\n#n = 'hi'\n#q = 1\nDB10.n = 'hi'\n#t1.ET = T#0MS\n", out)
        self.assertIn("1: #x = 12\n", out)
        self.assertRegex(out, r"IN +#d +DATE_AND_TIME +DT#1999-01-02-03:04:05.678\nIN +#b +STRING \[254\] +'abc'\n")
        self.assertIn("1: #x = ?\n", out)
        self.assertTrue(out.endswith("MW 20 = W#16#0037\n"))
        self.assertIn("P1216", self.debug("set #x = 1", code=PROBLEMS))
        self.assertIn("P1218", self.debug("break FB 1", "run", "xref #x", code=PROBLEMS))

    def test_all_or_nothing(self):
        """S7-SIM-12"""
        out = self.debug("set MW 10 = 5, DB99.DBW 0 = 1", "print MW 10", "force E 0.0 = 1, M 0.0 = 1", "force",
                         "watch MW 10, DB99.DBW 0", "watch", "force E 0.0 = 1, A 0.0 = 1", "unforce E 0.0, A 0.1", "force", code=PROBLEMS)
        self.assertIn("MW 10 = W#16#0000\n", out)
        self.assertIn("P1211", out)
        self.assertIn("no forces\n", out)
        self.assertIn("nothing is watched", out)
        self.assertTrue(out.endswith("E 0.0 = 1\nA 0.0 = 1\n"))

    def test_says_why_a_value_is_refused(self):
        """S7-SIM-03"""
        for line, text in (("set T 1 = 1000 DEC", "T 1 cannot be set: it takes S5T#0MS to S5T#2H46M30S [P0988]"),
                           ("set T 1 = W#16#FFFF", "P0988"), ("set Z 1 = W#16#FFFF", "Z 1 cannot be set: it takes 0 to 999 [P0988]"),
                           ("set MW 10 = 5, Z 1 = FFFF HEX", "P0988"), ("force A 0.1 = 1, A 0.1 = 0", "A 0.1 cannot be set: the list names it twice")):
            out = self.debug(line, "print MW 10", code=PROBLEMS)
            self.assertIn(text, out)
            self.assertTrue(out.endswith("MW 10 = W#16#0000\n"), out)  # it goes on

    def test_a_forced_output_is_not_set(self):
        """S7-SIM-12, S7-CPU-31"""
        for line in ("set A 0.0 = 0", "set AW 0 = 0", "set MW 10 = 1, AB 0 = 0"):
            out = self.debug("force A 0.0 = 1", line, "print A 0.0, MW 10", code=PROBLEMS)
            self.assertIn("P1217", out, line)
            self.assertTrue(out.endswith("A 0.0 = 1\nMW 10 = W#16#0000\n"), line)
        self.debug("force A 0.0 = 1, E 0.0 = 1", "set A 0.1 = 1, E 0.0 = 0")

    def test_nothing_goes_on_from_stop(self):
        """S7-STATE-08"""
        for line in ("continue", "step", "next", "out", "stepi", "cycle", "until 5s"):
            out = self.debug("run 1s", "stop", line, "info", code=PROBLEMS)
            self.assertIn("error: the CPU is in STOP; `run` or `restart` starts it", out)
            self.assertIn("CPU 314C-2 PtP  STOP", out)

    def test_stop_is_that_of_a_programming_device(self):
        """S7-DIAG-02"""
        self.assertRegex(self.debug("run 1s", "stop", "diag 1"), r"16#4304  STOP by programming device")
        self.assertNotIn("16#4303", self.debug("run 1s", "run 1s", "diag 20"))

    def test_status_shows_each_statement(self):
        """S7-EDIT-21"""
        self.write("a.awl", block("      U E 0.0; = A 0.0; L 1;\n      L     2;"))
        out = self.debug("status on OB 1", "status", "run 100ms", "status")
        self.assertIn("OB 1 has not been called", out)
        self.assertRegex(out, r"[0-9A-F]{8} +U E 0\.0; *\n.*[0-9A-F]{8} += A 0\.0; *\n.*[0-9A-F]{8} +L 1;\n.*[0-9A-F]{8} +L     2;\n")

    def test_the_end_of_a_block(self):
        """S7-EDIT-22"""
        self.assertIn("at the end of FC 1", self.debug("break 8", "run", "step"))

    def test_cross_reference(self):
        """S7-EDIT-22"""
        out = self.debug("x DB 99", "x DBW 0", "x MW 10")
        self.assertRegex(out, r"DB 99 +- +AUF +DB 99")
        self.assertIn("no instruction uses it\n", out)
        self.assertRegex(out, r"MW 10 +R +CALL  FC 1")

    def test_cross_reference_by_the_symbol_of_a_block(self):
        """S7-EDIT-22"""
        self.write("a.sym", '"Count boxes"  FC 1\n')
        self.write("merker.toml", '[project]\nname = "a"\n')
        out = self.expect(GOOD, "debug", ".", "-x", 'x "Count boxes"', "-x", "quit").out
        self.assertRegex(out, r"FC 1 +- +CALL  FC 1")

    def test_status_says_that_other_calls_came(self):
        """S7-EDIT-21"""
        out = self.debug("status on FC 1 db 7", "run 100ms", "status")
        self.assertRegex(out, r"FC 1 has been called, but not under the conditions of its program status\n")

    def test_a_list_is_read_to_its_end_first(self):
        """S7-SIM-12"""
        for line, said in (("print MW 10,", "error: "), ("print MW 10, MW 12 FOO", "'FOO' is not a valid format"),
                           ("watch MW 12 FOO", "'FOO' is not a valid format"), ("set MW 10 =", "a value is expected behind 'MW 10 ='")):
            out = self.debug(line, code=PROBLEMS)
            self.assertIn(said, out, line)
            self.assertNotIn("MW 10 = W", out, line)

    def test_arguments_that_nobody_reads(self):
        for line in ("step 3", "next 2", "info foo", "stop now", "where 1", "blocks 1"):
            self.assertIn(" takes no argument: ", self.debug("run 100ms", line, code=PROBLEMS), line)
        self.assertIn("'0' is not a valid number of entries", self.debug("diag 0", code=PROBLEMS))
        for line in ("delete", "enable", "disable"):
            self.assertIn("the number of a breakpoint or 'all' is expected", self.debug(line, code=PROBLEMS), line)
        self.assertIn("breakpoint '7' not found", self.debug("delete 7", code=PROBLEMS))

    def test_cycles_have_a_limit_of_time(self):
        self.write("a.awl", block("      CALL  SFC 47 (WT := 30000);\n" * 4))
        out = self.debug("restart", "cycle 900")
        self.assertRegex(out, r"the limit of 60\S* s is reached; \d+ cycles are left\n")
        self.assertNotIn("the limit of", self.debug("restart", "cycle 2"))

    def test_all_breakpoints(self):
        out = self.debug("break 5", "break 13", "disable all", "break", "run 100ms", "enable all", "continue")
        self.assertEqual(out.count(", disabled"), 2)
        self.assertIn("HALT at breakpoint 2", out)

    def test_an_access_error_is_told_once(self):
        """S7-DIAG-02"""
        self.write("a.awl", block("      L PEW 400"))
        self.assertRegex(self.debug("run", "diag 2"), r"  2  .*16#2942  I/O access error when reading: PEW 400\n")

    def test_mistakes_are_told(self):
        for line, word in (("fly", "P1215"), ("break FC 9", "P1206"), ("break nonsense", "P1201"), ("print QQ", "P0"),
                           ("set MW 10", "OPERAND = VALUE"), ("print MW 10 REAL", "P1209"), ("until soon", "P0953"),
                           ("delete 5", "not found"), ("cycle x", "not a valid number of cycles"), ("cycle -1", "not a valid number"),
                           ("cycle 99999999999999999999", "not a valid number"),
                           ("diag -1", "not a valid number"), ("locals -1", "not a valid depth"), ("status maybe", "use status"),
                           ("unforce E 0.0", "P1214"), ("restart hot", "'warm' or 'cold'"), ("help me", "P1215")):
            out = self.debug(line, code=PROBLEMS)
            self.assertIn("error: ", out, line)
            self.assertIn(word, out, line)

    def test_every_command_is_in_the_document(self):
        page = (pathlib.Path(__file__).parents[2] / "docs" / "debug.md").read_text(encoding="utf-8")
        for line in self.debug("help").splitlines():
            if line[:1].strip():
                self.assertIn("`" + line.split()[0], page)

    def test_commands_of_the_command_line(self):
        out = self.expect(GOOD, "debug", "a.awl", "-x", "restart", "-x", "cycle 1", "-x", "print MW 12").out
        self.assertTrue(out.endswith("MW 12 = W#16#0007\n"))

    def test_problems_of_the_source(self):
        self.write("bad.awl", block("      FLY"))
        self.expect(PROBLEMS, "debug", "bad.awl")
        self.expect(UNREADABLE, "debug", "none.awl")


class Terminal(Case):
    """The same through a terminal: prompt, editing, Ctrl-C."""

    def setUp(self):
        super().setUp()
        self.write("a.awl", SOURCE)
        master, slave = pty.openpty()
        self.terminal, self.shown = master, ""
        self.process = subprocess.Popen([os.environ["MERKER"], "debug", "a.awl"], cwd=self.folder, stdin=slave, stdout=slave,
                                        stderr=slave, start_new_session=True, env=dict(os.environ, TERM="xterm"),
                                        preexec_fn=lambda: self.control(slave))
        os.close(slave)
        self.addCleanup(os.close, master)
        self.addCleanup(self.process.wait)
        self.addCleanup(self.process.kill)

    @staticmethod
    def control(slave):
        import fcntl
        fcntl.ioctl(slave, termios.TIOCSCTTY, 0)

    def until(self, text, longest=60):
        """What the terminal shows up to and with this text."""
        end = time.monotonic() + longest
        while text not in self.shown:
            self.assertLess(time.monotonic(), end, f"{text!r} does not come: {self.shown!r}")
            if select.select([self.terminal], [], [], 0.2)[0]:
                self.shown += os.read(self.terminal, 4096).decode(errors="replace")
        seen, found, self.shown = self.shown.partition(text)
        return seen + found

    def prompt(self):
        """The library shows the prompt a moment before it reads keys; what is typed in between can be lost."""
        seen = self.until("(merker) ")
        self.lines(False)
        return seen

    def lines(self, wanted, longest=60):
        """Until the terminal gives the program whole lines (while a command works) or each key (while it waits for one)."""
        end = time.monotonic() + longest
        while bool(termios.tcgetattr(self.terminal)[3] & termios.ICANON) != wanted:
            self.assertLess(time.monotonic(), end, "the terminal does not change its mode")
            time.sleep(0.01)

    def interrupt(self, text):
        """Ctrl-C, again while nothing happens, until the terminal shows this text."""
        for _ in range(30):
            self.type("\x03")
            try:
                return self.until(text, 1)
            except AssertionError:
                continue
        self.fail(f"Ctrl-C does not lead to {text!r}: {self.shown!r}")

    def type(self, text):
        os.write(self.terminal, text.encode())

    def test_prompt_and_editing(self):
        self.assertIn("in STOP", self.prompt())
        self.type("set MW 10 = 6\x7f5\n")  # backspace: 5
        self.prompt()
        self.type("restart\n")
        self.prompt()
        self.type("cycle 1\n")
        self.until("RUN")
        self.prompt()
        self.type("print MW 12 DEC\n")
        self.until("MW 12 = 12")
        self.prompt()
        self.type("\x1b[A\n")  # arrow up: the same line again
        self.until("MW 12 = 12")
        self.prompt()
        self.type("wat\tMW 10\n")  # completion
        self.until("1: MW 10 = ")
        self.prompt()
        self.type("quit\n")
        self.assertEqual(self.process.wait(60), GOOD)

    def test_ctrl_c_drops_the_line(self):
        self.prompt()
        self.type("quit")
        self.until("quit")
        self.interrupt("(merker) ")
        self.type("print MW 10 DEC\n")
        self.until("MW 10 = 0")

    def test_ctrl_c_stands_the_program_still(self):
        self.prompt()
        self.type("run 100000m\n")
        self.until("100000m")
        self.lines(True)
        self.interrupt("HALT")
        self.prompt()
        self.type("where\n")
        self.until("OB 1 byte")
        self.prompt()
        self.type("\x04")  # end of input
        self.assertEqual(self.process.wait(60), GOOD)


class Diag(Case):
    def setUp(self):
        super().setUp()
        self.write("a.awl", SOURCE)

    def test_shows_state_buffer_and_stacks(self):
        """S7-DIAG-01, S7-DIAG-04"""
        call = self.expect(FAULT, "diag", "a.awl", "--for", "1s", "--set", "E 0.7 = 1")
        for text in ("STOP", "Diagnostic buffer, newest first\n  1  ", "16#4562", "16#253A", "(a.awl:16)", "B stack", "I stack",
                     "L stack", "Load OB 121"):
            self.assertIn(text, call.out)

    def test_json(self):
        document = self.expect(FAULT, "diag", "a.awl", "--for", "1s", "--set", "E 0.7 = 1", "--json").json
        self.assertEqual(document["module"]["mode"], "STOP")
        self.assertEqual(document["diagnostics"][0]["event"], "16#4562")
        self.assertEqual(document["diagnostics"][1]["place"]["line"], 16)
        self.assertEqual(document["stacks"]["blocks"][0]["place"]["block"], "OB 1")
        self.assertEqual(document["stacks"]["interrupts"][0]["ob"], 1)

    def test_a_healthy_program(self):
        call = self.expect(GOOD, "diag", "a.awl", "--for", "1s")
        self.assertIn("RUN", call.out)
        self.assertNotIn("B stack", call.out)
        self.expect(USAGE, "diag", "a.awl", "--for", "long")
        self.expect(USAGE, "diag", "a.awl", "--set", "QQ = 1")

    def test_a_program_without_ob_1(self):
        self.write("fc.awl", SOURCE.split("ORGANIZATION_BLOCK")[0])
        call = self.expect(FAULT, "diag", "fc.awl")
        self.assertIn("OB 1", call.out)


class Xref(Case):
    """S7-EDIT-22"""

    def setUp(self):
        super().setUp()
        self.write("a.awl", SOURCE)
        self.write("a.sym", "\"Fault\" E 0.7 BOOL\n\"Spare\" E 7.0 BOOL\n")

    def test_lists_every_use(self):
        out = self.expect(GOOD, "xref", "a.awl").out
        self.assertRegex(out, r"E 0\.7 +Fault +R +OB 1 +1 +2 +U +E 0\.7 +a\.awl:14")
        self.assertRegex(out, r"MW 12 +W +OB 1")
        self.assertRegex(out, r"FC 1 +- +OB 1")

    def test_filter_and_json(self):
        rows = self.expect(GOOD, "xref", "a.awl", "--operand", "MB 11", "--json").json["references"]
        self.assertEqual([row["operand"] for row in rows], ["MW 10"])
        self.assertEqual(rows[0]["place"], {"block": "OB 1", "offset": rows[0]["place"]["offset"], "file": "a.awl", "line": 13,
                                            "network": 1})
        self.expect(USAGE, "xref", "a.awl", "--operand", "QQ")

    def test_assignment_and_unused(self):
        out = self.expect(GOOD, "xref", "a.awl", "--assignment").out
        self.assertIn("EB 0      X . . . . . . .", out)
        self.assertRegex(out, r"MB 11 +\. \. \. \. \. \. \. \.  +\. \| \.")
        document = self.expect(GOOD, "xref", "a.awl", "--unused", "--json").json
        self.assertEqual(document["unused_symbols"], ["Spare"])
        self.assertIn("MW 10", document["operands_without_symbol"])

    def test_international_mnemonics(self):
        out = self.expect(GOOD, "xref", "a.awl", "--mnemonics", "en").out
        self.assertRegex(out, r"I 0\.7 .* A +I 0\.7")
