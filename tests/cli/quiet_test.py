"""Cycles that are passed over leave nothing behind that cycles which are computed would not: values, counters, traces and
results of scenarios are the same with --no-skip, on both engines."""
import pathlib
import re

from harness import *

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROJECTS = {
    "examples/sorting-plant": "E 0.0, E 0.1, E 0.2, A 1.0, A 1.1, A 1.2, T 1, T 10, plant Belt.GOOD",
    "examples/traffic-light": "AB 0, MB 0, T 1",
    "examples/lift": "EB 0, AB 0, MB 0",
    "examples/garage-door": "EB 0, AB 0",
    "examples/technology/cascade-control": "PEW 752, AB 124, DB41.LMN",
    "examples/technology/valve-control": "terminal Analog.AI0, AB 124",
    "tests/scenario/interrupts": "M 200.0, M 200.5, MW 20, MW 40",
}
QUIET = block("      U     E 0.0\n      L     S5T#500MS\n      SE    T 1\n      U     T 1\n      =     A 0.0")
READS_DATE = block("      L     LB 18\n      T     MB 10")
CALLS_CLOCK = block("      CALL  SFC 64 (RET_VAL := MD 10)")
COUNTS = block("      L     MW 10\n      +     1\n      T     MW 10")

PLANT = """[project]
name = "Plant"

[cpu]
model = "314C-2 PtP"

[[module]]
slot = "2.3"
name = "Analog"
range = "0..10V"

[[plant]]
name = "Process"
kind = "first order"
time_constant = "2s"

[plant.wire]
PV = "Analog.AI0"
"""


class Quiet(Case):
    def outcome(self, *arguments):
        done = self.merker(*arguments)
        trace = pathlib.Path(self.folder) / "trace.csv"
        return done.code, done.out, trace.read_bytes() if trace.exists() else b""

    def test_traces_and_counters_are_the_same(self):
        for project, watched in PROJECTS.items():
            for engine in ("interpreter", "jit"):
                arguments = ["run", str(ROOT / project), "--for", "20s", "--engine", engine, "--json", "--watch", watched,
                             "--trace", "trace.csv"]
                with self.subTest(project, engine=engine):
                    passed_over = self.outcome(*arguments)
                    self.assertEqual(passed_over, self.outcome(*arguments, "--no-skip"))
                    self.assertIn(b",", passed_over[2])

    def test_scenarios_come_to_the_same(self):
        for project in ("examples/sorting-plant", "examples/traffic-light", "examples/step5", "examples/technology/valve-control"):
            with self.subTest(project):
                results = {self.expect(GOOD, "test", str(ROOT / project), "--json", *options).out
                           for options in ([], ["--no-skip"])}
                self.assertEqual(len(results), 1)

    def test_expectations_see_what_moves_beside_quiet_cycles(self):
        self.write("plant/merker.toml", PLANT)
        self.write("plant/main.awl", QUIET)
        self.write("plant/way.scn", 'scenario "on its way"\n  plant Process.LMN = 100\n  expect PEW 752 > 1000 within 60s\n'
                   "  expect PEW 752 < 1100\n  expect plant Process.PV > 8 within 60s\n  expect plant Process.PV < 8.1\n")
        for options in ([], ["--no-skip"]):
            with self.subTest(options=options):
                self.expect(GOOD, "test", "plant", *options)

    def why(self, program):
        out = self.expect(GOOD, "bench", self.write("a.awl", program), "--why", "--for", "2s").out
        cycles, computed, passed = map(int, re.match(r"(\d+) cycles, (\d+) computed, (\d+) passed over", out).groups())
        self.assertEqual(cycles, computed + passed)
        return computed, passed, out

    def test_a_quiet_program_is_passed_over(self):
        computed, passed, _ = self.why(QUIET)
        self.assertGreater(passed, 20 * computed)

    def test_it_says_what_prevented_it(self):
        date = "OB 1 has an instruction that reads its date and time, executed or not, at OB 1 network 1 (a.awl:4)"
        for program, words in ((READS_DATE, date), (CALLS_CLOCK, "OB 1 calls SFC 64, at OB 1 network 1 (a.awl:4)"),
                               (COUNTS, "MB 11 changes; written at OB 1 network 1 (a.awl:6)"),
                               (COUNTS.replace("T     MW 10", "LAR1  P#10.0\n      T     MW [AR1,P#0.0]"),
                                "MB 11 changes; no instruction names it to write it")):
            with self.subTest(words):
                _, passed, out = self.why(program)
                self.assertEqual(passed, 0)
                self.assertIn(words, out)
                self.assertNotIn("outside", out)  # the start is the program's own

    def test_every_computed_cycle_has_a_reason(self):
        for program in (QUIET, READS_DATE, COUNTS):
            computed, _, out = self.why(program)
            told = [int(count) for count in re.findall(r"^ *(\d+) +[0-9.]+ %  ", out, re.MULTILINE)]
            self.assertEqual(sum(told), computed, out)

    def test_a_control_names_what_changes(self):
        self.write("control/merker.toml", '[cpu]\nmodel = "SINUMERIK 820 GA3"\n')
        self.write("control/a.s5", "OB 1\n      L     MW 102\n      L     KF +1\n      +F\n      T     MW 102\n      BE\n")
        out = self.expect(GOOD, "bench", "control", "--why", "--for", "20s").out
        self.assertRegex(out, r"MB 103 changes; written at OB 1 network 1 \(control/a\.s5:5\)")
        self.write("control/a.s5", "OB 1\n      A     DB 10\n      L     DW 1\n      L     KF +1\n      +F\n      T     DW 1\n      BE\n"
                                   "DB 10\n   0 : KH = 1F00\n   1 : KF = +5\n")
        out = self.expect(GOOD, "bench", "control", "--why", "--for", "20s").out
        self.assertIn("DB10.DW 1 changes; written at OB 1", out)


if __name__ == "__main__":
    unittest.main()
