#!/usr/bin/env python3
"""The scripts under tools/: which test a number belongs to, and the timing diagram."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

TOOLS = pathlib.Path(__file__).resolve().parents[2] / "tools"
sys.path.insert(0, str(TOOLS))
from named_tests import named_tests, shown  # noqa: E402  (the path above)

CPP = """// Timers, S7-TMR-01.
#include <gtest/gtest.h>

namespace {
// S7-TMR-10, S7-TMR-11: a pulse
TEST(Pulse, endsEarly) {
  run();  // S7-STW-03
}

TEST(Pulse, other) { EXPECT_TRUE(true); }  // S7-STW-04
}
"""
SCN = """# about the plant S7-VIS-07

scenario "a box (S7-VIS-12)"
  wait 1s                 # S7-VIS-10

# S7-VIS-13
scenario "another"
"""


class NamedTests(unittest.TestCase):
    def test_cpp(self):
        found = named_tests(pathlib.Path("a.cpp"), CPP)
        self.assertEqual(found, [("S7-TMR-01", ""), ("S7-TMR-10", "Pulse.endsEarly"), ("S7-TMR-11", "Pulse.endsEarly"),
                                 ("S7-STW-03", "Pulse.endsEarly"), ("S7-STW-04", "Pulse.other")])

    def test_scenario(self):
        found = dict(named_tests(pathlib.Path("a.scn"), SCN))
        self.assertEqual(found["S7-VIS-12"], "a box (S7-VIS-12)")
        self.assertEqual(found["S7-VIS-10"], "a box (S7-VIS-12)")
        self.assertEqual(found["S7-VIS-13"], "another")

    def test_other_files_count_as_a_whole(self):
        self.assertEqual(named_tests(pathlib.Path("a.awl"), "// S7-FC-01\n// S7-FC-01\n"), [("S7-FC-01", "")])


class Shown(unittest.TestCase):
    """A number counts where something can fail."""

    def shown(self, name, text, beside=None):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / name
            if beside:
                (path.parent / beside).touch()
            return [number for number, _ in shown(path, text)]

    def test_only_beside_a_test(self):
        self.assertEqual(self.shown("a_test.cpp", CPP), ["S7-TMR-10", "S7-TMR-11", "S7-STW-03", "S7-STW-04"])

    def test_a_program_that_checks_itself(self):
        self.assertEqual(self.shown("a.awl", "// S7-FC-01\n L 1; //= AKKU1 = 1\n"), ["S7-FC-01"])
        self.assertEqual(self.shown("a.s5", "// S5-BLK-01\n X  //! error\n"), ["S5-BLK-01"])
        self.assertEqual(self.shown("a.awl", "// S7-FC-01\n"), [])

    def test_a_scenario_beside_it(self):
        self.assertEqual(self.shown("a.awl", "// S7-FC-01\n", beside="a.scn"), ["S7-FC-01"])
        self.assertEqual(self.shown("a.awl", "// S7-FC-01\n", beside="b.scn"), [])

    def test_files_of_tests_and_others(self):
        self.assertEqual(self.shown("a.spec.mjs", "// S7-VIS-01\n"), ["S7-VIS-01"])
        self.assertEqual(self.shown("a_test.py", '"""S7-VIS-01"""\n'), ["S7-VIS-01"])
        for other in ("README.md", "merker.toml", "rig.h", "rig.cpp"):
            self.assertEqual(self.shown(other, "S7-VIS-01"), [], other)


class Timeline(unittest.TestCase):
    def draw(self, trace, *options):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "trace.csv"
            path.write_text(trace, encoding="utf-8")
            done = subprocess.run([sys.executable, "-B", str(TOOLS / "timeline"), str(path), *options],
                                  capture_output=True, encoding="utf-8", env={"PYTHONIOENCODING": "utf-8"}, check=False)
        return done.returncode, done.stdout.splitlines()

    def test_curve(self):
        code, lines = self.draw("time,operand,value\n0.5,E 0.0,1\n1.25,E 0.0,0\n", "--step", "250ms", "--to", "2")
        self.assertEqual(code, 0)
        self.assertEqual(lines[0].split(), ["0"])
        self.assertEqual(lines[2], "E 0.0  ▁▁███▁▁▁")

    def test_a_short_pulse_is_not_lost(self):
        _, lines = self.draw("0.01,A 1.0,1\n0.02,A 1.0,0\n", "--step", "100ms", "--to", "0.3")
        self.assertEqual(lines[2], "A 1.0  █▁▁")

    def test_rows_order_and_silent_operands(self):
        _, lines = self.draw("0.1,A 1.0,1\n", "--rows", "E 0.0, A 1.0", "--step", "100ms", "--to", "0.2")
        self.assertEqual(lines[2:], ["E 0.0  ··", "A 1.0  ▁█"])

    def test_an_empty_trace_is_an_error(self):
        self.assertNotEqual(self.draw("time,operand,value\n")[0], 0)


unittest.main()
