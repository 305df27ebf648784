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
    "tests/scenario/interrupts": "M 200.0, M 200.5, MW 20, MW 40",
}
QUIET = block("      U     E 0.0\n      L     S5T#500MS\n      SE    T 1\n      U     T 1\n      =     A 0.0")
READS_DATE = block("      L     LB 18\n      T     MB 10")
CALLS_CLOCK = block("      CALL  SFC 64 (RET_VAL := MD 10)")
COUNTS = block("      L     MW 10\n      +     1\n      T     MW 10")


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
        for project in ("examples/sorting-plant", "examples/traffic-light", "examples/step5"):
            with self.subTest(project):
                results = {self.expect(GOOD, "test", str(ROOT / project), "--json", *options).out
                           for options in ([], ["--no-skip"])}
                self.assertEqual(len(results), 1)

    def why(self, program):
        out = self.expect(GOOD, "bench", self.write("a.awl", program), "--why", "--for", "2s").out
        cycles, computed, passed = map(int, re.match(r"(\d+) cycles, (\d+) computed, (\d+) passed over", out).groups())
        self.assertEqual(cycles, computed + passed)
        return computed, passed, out

    def test_a_quiet_program_is_passed_over(self):
        computed, passed, _ = self.why(QUIET)
        self.assertGreater(passed, 20 * computed)

    def test_it_says_what_prevented_it(self):
        for program, words in ((READS_DATE, "OB 1 reads the date and time of OB 1 (a.awl:4)"),
                               (CALLS_CLOCK, "OB 1 calls SFC 64 (a.awl:4)"), (COUNTS, "MB 11 changes")):
            with self.subTest(words):
                _, passed, out = self.why(program)
                self.assertEqual(passed, 0)
                self.assertIn(words, out)


if __name__ == "__main__":
    unittest.main()
