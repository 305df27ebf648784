import os
import signal
import subprocess
import xml.etree.ElementTree

from harness import *

CHECKED = block("      L     32767\n      L     1\n      +I                 //= AKKU1 = W#16#8000, A1 = 0, A0 = 1, OV = 1, OS = 1\n      CALL  SFC 46")


class Test(Case):
    def last(self, call):
        return call.lines[-1]

    def test_a_self_checking_program(self):
        self.write("a.awl", CHECKED)
        self.assertEqual(self.last(self.expect(GOOD, "test", "a.awl")), "1 passed, 0 failed")

    def test_a_failing_check_names_its_line(self):
        self.write("a.awl", CHECKED.replace("W#16#8000", "W#16#7FFF"))
        call = self.expect(PROBLEMS, "test", "a.awl")
        self.assertEqual(self.last(call), "0 passed, 1 failed")
        self.assertIn("a.awl:6:", call.out)
        self.assertIn("AKKU1 = W#16#7FFF", call.out)
        self.assertIn("8000", call.out)

    def test_both_engines_judge_alike(self):
        for program in (CHECKED, CHECKED.replace("W#16#8000", "W#16#7FFF")):
            self.write("a.awl", program)
            interpreted, compiled = (self.merker("test", "a.awl", "--engine", e) for e in ("interpreter", "jit"))
            self.assertEqual(interpreted.out, compiled.out)
            self.assertEqual(interpreted.code, compiled.code)

    # Results, their order and what was counted do not depend on how many run at the same time.
    def test_several_at_the_same_time(self):
        self.write("plant/a.awl", block("      U     E 0.0\n      =     A 0.0"))
        steps = "scenario \"number {0}\"\n  set E 0.0 = {1}\n  run 100ms\n  check A 0.0 = {2}\n"
        self.write("plant/a.scn", "".join(steps.format(i, i % 2, int(i % 7 == 0)) for i in range(40)))
        self.write("plant/b.scn", steps.format(40, 1, 1) + steps.format(41, "nonsense", 1) + steps.format(42, 0, 0))
        said = {}
        for jobs in ("1", "2", "8"):
            call = self.merker("test", "plant", "-j", jobs, "--coverage", jobs)
            self.assertEqual(call.code, PROBLEMS)
            said[jobs] = (call.out, call.err, self.read(jobs))
        self.assertEqual(said["2"], said["1"])
        self.assertEqual(said["8"], said["1"])
        self.assertIn("number 41", said["1"][0])

    def test_every_check_must_be_reached(self):
        self.write("a.awl", block("      SPA   over\n      L     5   //= AKKU1 = 5\nover: CALL  SFC 46"))
        call = self.expect(PROBLEMS, "test", "a.awl")
        self.assertIn("a.awl:5:", call.out)

    def test_a_fault_fails_also_when_all_checks_held(self):
        self.write("a.awl", block("      L     W#16#FFFF   //= AKKU1 = W#16#FFFF\n      BTI"))
        call = self.expect(PROBLEMS, "test", "a.awl")
        self.assertIn("STOP", call.out)

    def test_a_program_that_never_stops_is_judged_after_10_s(self):
        self.write("a.awl", block("      L     5   //= AKKU1 = 5"))
        self.assertEqual(self.last(self.expect(GOOD, "test", "a.awl")), "1 passed, 0 failed")

    def test_checks_change_nothing_for_other_commands(self):
        self.write("a.awl", CHECKED)
        self.write("b.awl", CHECKED.split("//=")[0] + "\n      CALL  SFC 46\nEND_ORGANIZATION_BLOCK\n")
        self.assertEqual(self.expect(GOOD, "list", "a.awl", "--code").out, self.expect(GOOD, "list", "b.awl", "--code").out)

    def test_scenarios(self):
        self.write("a.awl", PROGRAM)
        self.write("a.scn", "scenario \"good\"\n  set E 0.0 = 1\n  expect A 0.1 = 1 within 2.1s\n\n"
                            "scenario \"bad\"\n  wait 50ms\n  expect A 0.0 = 1   # E 0.0 is 0\n")
        call = self.expect(PROBLEMS, "test", "a.scn")
        self.assertEqual(self.last(call), "1 passed, 1 failed")
        self.assertIn("ok      a.scn: good", call.lines)
        self.assertIn("FAILED  a.scn: bad", call.lines)
        self.assertRegex(call.out, r"a\.scn:7: at 0\.05\d* s: expected A 0\.0 = 1, A 0\.0 is 0")

    def test_a_scenario_without_end_is_ended_by_ctrl_c(self):
        """docs/safety.md: steps that take no time are repeated as often as the file says, until somebody ends them."""
        self.write("a.awl", PROGRAM)
        self.write("a.scn", "scenario \"short\"\n  wait 50ms\n\nscenario \"endless\"\n"
                            "  repeat 1000000000\n    repeat 1000000000\n      set E 0.0 = 1\n    end\n  end\n")
        process = subprocess.Popen([os.environ["MERKER"], "test", "a.scn"], cwd=self.folder, text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(lambda: (process.kill(), process.communicate()))
        self.assertEqual(process.stdout.readline(), "ok      a.scn: short\n")
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.communicate(timeout=60), ("", ""))
        self.assertEqual(process.returncode, -signal.SIGINT)

    def test_filter_picks_scenarios(self):
        self.write("a.awl", PROGRAM)
        self.write("a.scn", "scenario \"good one\"\n  wait 1s\nscenario \"bad one\"\n  expect A 0.0 = 1\n")
        self.assertEqual(self.last(self.expect(GOOD, "test", "a.awl", "--filter", "Good")), "1 passed, 0 failed")
        call = self.expect(PROBLEMS, "test", "a.awl", "--filter", "nothing")
        self.assertEqual(self.last(call), "0 passed, 0 failed")
        self.assertIn("'nothing' (--filter)", call.err)

    def test_nothing_to_test_is_no_success(self):
        self.write("plain.awl", PROGRAM)
        self.write("t/plain.awl", PROGRAM)
        self.write("p/merker.toml", "")
        (self.folder / "empty").mkdir()
        for path in ("plain.awl", "t", "empty"):
            self.assertIn("no scenario", self.expect(PROBLEMS, "test", path).err)
        self.assertIn("P0708", self.expect(PROBLEMS, "test", "p").err)

    def test_a_broken_source_without_tests_is_told(self):
        self.write("a.awl", CHECKED)
        self.write("bad.awl", block("      FLY"))
        self.assertIn("bad.awl:4:", self.expect(PROBLEMS, "test", "bad.awl").err)
        self.assertIn("bad.awl:4:", self.expect(PROBLEMS, "test", "a.awl", "bad.awl").err)

    def test_all_problems_of_a_file_in_one_pass_and_the_good_scenarios_run(self):
        self.write("a.awl", PROGRAM)
        self.write("a.scn", "scenario \"bad\"\n  sett E 0.0 = 1\n  expect XY 5 = 1\n  expect MB 1 = 2 for ever\n"
                            "scenario \"good\"\n  wait 1s\nscenario \"missing\"\n  expect DB7.DBW 0 = 1\n")
        call = self.expect(PROBLEMS, "test", "a.scn")
        for place in ("2:3", "3:10", "4:23", "8:10"):
            self.assertIn(f"a.scn:{place}: error:", call.err)
        self.assertEqual([line.split()[0] for line in call.lines if "a.scn: " in line], ["FAILED", "ok", "FAILED"])
        self.assertIn("a.scn:8: ", call.out)
        self.assertIn("there is no DB 7", call.out)

    def test_a_failing_check_has_the_time_of_its_judgement(self):
        self.write("a.awl", block("      L     5   //= AKKU1 = 6"))
        self.assertRegex(self.expect(PROBLEMS, "test", "a.awl").out, r"a\.awl:4: at 0\.0\d* s")

    def test_problems_of_a_scenario(self):
        self.write("a.awl", PROGRAM)
        self.write("a.scn", "  sett E 0.0 = 1\n  expect XY 5 = 1\n  expect encoder 1 = 1\n")
        call = self.expect(PROBLEMS, "test", "a.scn")
        self.assertRegex(call.err, r"(?m)^a\.scn:1:3: error: .*\[P0950\]$")
        self.assertRegex(call.err, r"(?m)^a\.scn:3:3: error: .*\[P0951\]$")
        self.assertEqual(self.last(call), "0 passed, 1 failed")
        self.write("a.scn", "  expect XY 5 = 1\n")
        self.assertIn("a.scn:1:10: error:", self.expect(PROBLEMS, "test", "a.scn").err)

    def test_a_source_that_does_not_compile_fails_its_tests(self):
        self.write("a.awl", block("      FLY"))
        self.write("a.scn", "scenario \"x\"\n  wait 1s\nscenario \"y\"\n  wait 1s\n")
        call = self.expect(PROBLEMS, "test", "a.scn")
        self.assertEqual(self.last(call), "0 passed, 2 failed")
        self.assertIn("a.awl:4:", call.err)

    def test_a_tree_of_programs(self):
        self.write("t/p/merker.toml", "")
        self.write("t/p/main.awl", PROGRAM)
        self.write("t/p/tests/one.scn", "expect mode = RUN\n")
        self.write("t/loose/a.awl", CHECKED)
        self.write("t/loose/plain.awl", block("      NOP   0"))
        self.write("t/loose/plain.scn", "wait 3 cycles\n")
        self.assertEqual(self.last(self.expect(GOOD, "test", "t")), "3 passed, 0 failed")
        self.assertEqual(self.last(self.expect(GOOD, "test", "t/p", "t/loose/a.awl")), "2 passed, 0 failed")

    def test_two_runs_print_the_same(self):
        self.write("a.awl", PROGRAM)
        self.write("a.scn", "set E 0.0 = 1\nexpect A 0.1 = 1 within 3s\nexpect MW 20 = 0\n")
        self.assertEqual(self.merker("test", "a.scn").out, self.merker("test", "a.scn").out)


class Reports(Case):
    def setUp(self):
        super().setUp()
        self.write("a.awl", PROGRAM)
        self.write("a.scn", "scenario \"good\"\n  wait 1s\nscenario \"bad <1>\"\n  expect A 0.0 = 1\n")

    def test_junit(self):
        self.expect(PROBLEMS, "test", "a.scn", "--junit", "r.xml")
        root = xml.etree.ElementTree.parse(self.folder / "r.xml").getroot()
        self.assertEqual((root.get("tests"), root.get("failures")), ("2", "1"))
        cases = root.findall("./testsuite/testcase")
        self.assertEqual([case.get("name") for case in cases], ["good", "bad <1>"])
        self.assertIn("expected A 0.0 = 1", cases[1].find("failure").get("message"))

    def test_coverage(self):
        self.expect(PROBLEMS, "test", "a.scn", "--coverage", "c.info")
        text = self.read("c.info")
        counts = dict(line[3:].split(",") for line in text.splitlines() if line.startswith("DA:"))
        self.assertIn("SF:a.awl", text)
        self.assertGreater(int(counts["6"]), 0)
        self.assertEqual((counts["17"], counts["18"]), ("0", "0"))

    def test_json(self):
        results = self.expect(PROBLEMS, "test", "a.scn", "--json").json
        self.assertEqual((results["passed"], results["failed"]), (1, 1))
        self.assertEqual(results["results"][1]["failures"][0]["line"], 4)
