import csv
import os
import pathlib
import shlex
import shutil
import signal
import sqlite3
import subprocess
import time
import xml.etree.ElementTree

from harness import *

EXAMPLE = pathlib.Path(__file__).resolve().parents[2] / "examples" / "vessel-emptying"
# Quick enough to be run again and again.
SWEEP = """[campaign]
name = "Vessel"
for = "1s"
repeat = 20
[campaign.vary]
"set.E 0.0" = 1
"plant.Vessel.stroke" = [0.4, 0.6, 0.8, 16]
"plant.Vessel.start" = {normal = 80, sigma = 6}
[campaign.measure]
open = "time A 1.0"
rest = "last plant.Vessel.LEVEL"
[campaign.require]
rest = "< 20"
"""
RUNS = 80


class Campaign(Case):
    def setUp(self):
        super().setUp()
        for name in ("merker.toml", "vessel.awl", "vessel.sym", "vessel.scn"):
            shutil.copy(EXAMPLE / name, self.folder)
        self.write("sweep.toml", SWEEP)

    def campaign(self, code, *options, **more):
        return self.expect(code, "campaign", "sweep.toml", *options, **more)

    def rows(self, name="sweep.sqlite"):
        """All of the table, by id; the file is sound."""
        with sqlite3.connect(self.folder / name) as results:
            self.assertEqual(results.execute("PRAGMA integrity_check").fetchall(), [("ok",)])
            return results.execute("SELECT * FROM run ORDER BY id").fetchall()

    def test_every_run_has_a_row(self):
        call = self.campaign(PROBLEMS)  # a vessel of 16 s has more than 20 % left
        self.assertIn("60 passed, 20 failed; results in sweep.sqlite", call.out)
        self.assertIn("... and 10 more", call.out)
        with sqlite3.connect(self.folder / "sweep.sqlite") as results:
            table = results.execute(
                'SELECT "plant.Vessel.stroke", count(*), count(DISTINCT "plant.Vessel.start"), min(open), max(rest), sum(passed) '
                "FROM run GROUP BY 1 ORDER BY 1").fetchall()
        self.assertEqual([(stroke, count, levels) for stroke, count, levels, *_ in table], [(s, 20, 20) for s in (0.4, 0.6, 0.8, 16)])
        for stroke, _, _, shortest, rest, passed in table[:3]:
            self.assertGreater(shortest, (80 - 4 * 6 - 5) / 100 * stroke)  # from the lowest filling to 5 %
            self.assertLess(rest, 5)
            self.assertEqual(passed, 20)
        self.assertEqual(table[3][5], 0)

    def test_results_are_the_same_however_they_are_shared(self):
        self.campaign(PROBLEMS, "-j", "1", "--csv", "one.csv")
        one = self.rows()
        self.assertEqual(len(one), RUNS)
        self.campaign(PROBLEMS, "-j", "5", "-o", "five.sqlite")
        self.assertEqual(self.rows("five.sqlite"), one)
        for count in (2, 16):
            for shard in range(1, count + 1):
                self.merker("campaign", "sweep.toml", "--shard", f"{shard}/{count}")
            parts = [f"sweep-{shard}of{count}.sqlite" for shard in range(1, count + 1)]
            self.assertEqual([len(self.rows(part)) for part in parts], [RUNS // count] * count)
            self.campaign(PROBLEMS, "--merge", *parts, "-o", f"all{count}.sqlite", "--csv", f"all{count}.csv")
            self.assertEqual(self.rows(f"all{count}.sqlite"), one)
            self.assertEqual(self.read(f"all{count}.csv"), self.read("one.csv"))

    def test_both_engines_measure_the_same(self):
        self.write("sweep.toml", SWEEP.replace("[campaign.measure]", '"cpu.engine" = ["interpreter", "jit"]\n[campaign.measure]')
                   .replace("repeat = 20", "repeat = 2"))
        self.merker("campaign", "sweep.toml", "--csv", "a.csv")
        with open(self.folder / "a.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        engines = [[[row[name] for name in ("open", "rest", "cycles")] for row in rows if row["cpu.engine"] == engine]
                   for engine in ("interpreter", "jit")]
        self.assertEqual(len(engines[0]), 8)
        self.assertEqual(engines[0], engines[1])

    def test_runs_are_forked_from_a_common_start(self):
        text = """[campaign]
for = "2s"
start = "20s"
[campaign.vary]
"set.E 0.0" = [0, 1]
[campaign.measure]
open = "time A 1.0"
cycles_of_it = "cycles"
"""
        self.write("sweep.toml", text)
        self.campaign(GOOD)
        apart = {row[1]: row[2:] for row in self.rows()}
        for row in apart.values():
            self.assertEqual(round(row[3]), 22)
            self.assertLess(row[-1], row[4] / 8)  # the measure begins behind the start
        self.assertLess(sorted(row[5] for row in apart.values())[0], 0.1)
        for number in ("1", "2"):  # each alone, from its own start
            self.campaign(GOOD, "--job", number, "-o", "single.sqlite")
        self.assertEqual(self.rows("single.sqlite"), self.rows())

    # At several instants. What is there stays, what is missing is run, nothing twice.
    def test_a_killed_campaign_is_resumed(self):
        self.campaign(PROBLEMS, "-o", "whole.sqlite")
        seen = set()
        for wanted in (1, 20, 50):
            process = subprocess.Popen([os.environ["MERKER"], "campaign", "sweep.toml", "--resume", "-j", "2"],
                                       cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            while process.poll() is None and self.count() < wanted:
                time.sleep(0.002)
            process.kill()
            process.wait()
            there = {row[0] for row in self.rows()}
            self.assertLessEqual(seen, there)
            seen = there
        self.campaign(PROBLEMS, "--resume")
        self.assertEqual(self.rows(), self.rows("whole.sqlite"))

    def count(self):
        try:
            with sqlite3.connect(f"file:{self.folder / 'sweep.sqlite'}?mode=ro", uri=True) as results:
                return results.execute("SELECT count(*) FROM run").fetchone()[0]
        except sqlite3.OperationalError:
            return 0

    def test_ctrl_c_keeps_what_is_done(self):
        self.write("sweep.toml", SWEEP.replace("repeat = 20", "repeat = 20000"))
        process = subprocess.Popen([os.environ["MERKER"], "campaign", "sweep.toml"], cwd=self.folder, start_new_session=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        while self.count() < 5:
            time.sleep(0.005)
        os.killpg(process.pid, signal.SIGINT)
        out, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, PROBLEMS)
        self.assertIn("--resume goes on", err)
        self.assertGreaterEqual(len(self.rows()), 5)
        self.assertLess(len(self.rows()), 80000)
        while self.running(process.pid):  # no child is left
            time.sleep(0.005)

    @staticmethod
    def running(group):
        """Processes of a group that are not dead."""
        found = []
        for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
            try:
                state, _, owner = stat.read_text(encoding="utf-8", errors="replace").rpartition(")")[2].split()[:3]
            except OSError:
                continue
            if int(owner) == group and state != "Z":
                found.append(stat)
        return found

    def test_a_campaign_can_grow_but_not_change(self):
        self.campaign(PROBLEMS)
        before = self.rows()
        call = self.campaign(USAGE)
        self.assertIn("sweep.sqlite exists; --resume goes on", call.err)
        self.write("sweep.toml", SWEEP.replace("repeat = 20", "repeat = 21"))
        self.campaign(PROBLEMS, "--resume")
        self.assertEqual(len(self.rows()), RUNS + 4)
        self.assertLess(set(before), set(self.rows()))
        self.write("vessel.awl", self.read("vessel.awl") + "// changed\n")
        call = self.campaign(USAGE, "--resume")
        self.assertIn("84 of its 84 runs are of another campaign, project or version", call.err)
        self.assertEqual(len(self.rows()), RUNS + 4)

    def test_a_list_of_command_lines(self):
        self.write("sweep.toml", SWEEP.replace("repeat = 20", "repeat = 2"))
        lines = self.campaign(GOOD, "--list").lines
        self.assertEqual(len(lines), 8)
        self.assertFalse((self.folder / "sweep.sqlite").exists())
        for line in lines:
            self.merker(*shlex.split(line)[1:])
        listed = self.rows()
        self.merker("campaign", "sweep.toml", "-o", "b.sqlite")
        self.assertEqual(listed, self.rows("b.sqlite"))
        self.assertEqual(self.campaign(GOOD, "--list", "--shard", "3/4", "-o", "part {}.sqlite").lines,
                         [f"merker campaign sweep.toml --job {job} -o 'part {job}.sqlite'" for job in (3, 7)])

    def test_csv_and_junit_for_others(self):
        self.campaign(PROBLEMS, "--csv", "a.csv", "--junit", "a.xml")
        with open(self.folder / "a.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), RUNS)
        self.assertEqual([row["run"] for row in rows], [str(i + 1) for i in range(RUNS)])
        self.assertEqual({len(row) for row in rows}, {12})
        self.assertEqual([row["set.E 0.0"] for row in rows[:2]], ["1", "1"])
        self.assertEqual({(row["passed"], row["message"] == "") for row in rows}, {("1", True), ("0", False)})
        suites = xml.etree.ElementTree.fromstring(self.read("a.xml"))
        self.assertEqual((suites.get("tests"), suites.get("failures")), ("80", "20"))
        cases = list(suites.iter("testcase"))
        self.assertEqual(cases[0].get("classname"), "Vessel")
        self.assertRegex(cases[0].get("name"), r"^set\.E 0\.0=1, plant\.Vessel\.stroke=0\.4, plant\.Vessel\.start=[0-9.]+, seed=1$")
        self.assertRegex(next(suites.iter("failure")).get("message"), r"^rest is [0-9.]+, required is < 20$")

    def test_a_summary_in_json(self):
        self.write("sweep.toml", SWEEP.replace("repeat = 20", "repeat = 1"))
        document = self.campaign(PROBLEMS, "--json").json
        self.assertEqual([document[key] for key in ("runs", "passed", "failed", "missing")], [4, 3, 1, 0])
        self.assertEqual(document["failures"][0]["run"], 4)

    def test_a_run_without_end_or_too_large_is_told(self):
        self.write("sweep.toml", '[campaign]\nfor = "876000h"\ntime_limit = "1s"\n[campaign.vary]\n"set.MW 10" = [1, 2]\n'
                                 '[campaign.measure]\nlevel = "max plant.Vessel.LEVEL"\n')
        call = self.campaign(PROBLEMS)
        self.assertIn("run 1 (set.MW 10=1) has no result: it needs more than 1 s of processor time (time_limit)", call.err)
        self.assertIn("0 passed, 0 failed, 2 missing", call.out)

    def test_pictures_are_drawn(self):
        self.campaign(PROBLEMS)
        self.expect(GOOD, "plot", "sweep.sqlite", "-o", "a.svg", "--x", "plant.Vessel.stroke", "--y", "open")
        self.expect(GOOD, "plot", "sweep.sqlite", "-o", "b.svg", "--heat", "rest", "--x", "plant.Vessel.start", "--y", "plant.vessel.stroke")
        for name in ("a.svg", "b.svg"):
            texts = [one.text for one in xml.etree.ElementTree.fromstring(self.read(name)).iter() if one.tag.endswith("text")]
            self.assertEqual(texts[0], "Vessel")
        call = self.expect(USAGE, "plot", "sweep.sqlite", "-o", "c.svg", "--x", "stroke")
        self.assertIn("the results have no parameter 'stroke'; valid: set.E 0.0, plant.Vessel.stroke", call.err)
        call = self.expect(USAGE, "plot", "sweep.sqlite", "-o", "c.svg", "--x", "plant.Vessel.stroke", "--by", "plant.vessel.stroke")
        self.assertIn("--x and --by must be two different parameters, not 'plant.Vessel.stroke' twice", call.err)
        call = self.expect(USAGE, "plot", "sweep.sqlite", "-o", "c.svg", "--heat", "rest", "--x", "seed", "--y", "seed")
        self.assertIn("--x and --y must be two different parameters, not 'seed' twice", call.err)
        self.write("bare.toml", '[campaign]\nfor = "1s"\n')
        self.merker("campaign", "bare.toml")
        self.assertIn("they have no measure", self.expect(USAGE, "plot", "bare.sqlite", "-o", "c.svg").err)
        self.assertIn("are for a trace", self.expect(USAGE, "plot", "sweep.sqlite", "-o", "c.svg", "--from", "1s").err)
        self.write("t.csv", "0.0000000,MW 10,1\n1.0000000,MW 10,2\n")
        self.assertIn("are for a campaign", self.expect(USAGE, "plot", "t.csv", "-o", "c.svg", "--x", "seed").err)

    def test_what_is_wrong_is_said_at_its_place(self):
        self.write("sweep.toml", SWEEP.replace('"plant.Vessel.stroke" = [0.4', '"plant.Vessel.stroke" = ["fast"'))
        call = self.campaign(PROBLEMS)
        self.assertTrue(call.err.startswith("sweep.toml:7:26: error: 'plant.Vessel.stroke' must be a duration from "), call.err)
        self.assertIn('"plant.Vessel.stroke" = ["fast", 0.6, 0.8, 16]\n', call.err)
        self.assertFalse((self.folder / "sweep.sqlite").exists())
        self.write("sweep.toml", SWEEP.replace("[campaign]\n", '[campaign]\nproject = "none"\n'))
        self.assertTrue(self.campaign(PROBLEMS).err.startswith("sweep.toml:2:11: error: 'project' must be the folder of a project"))
        self.assertEqual(self.merker("campaign", "none.toml").code, UNREADABLE)

    def vary(self, line, repeat=1):
        self.write("sweep.toml", f'[campaign]\nfor = "1s"\nrepeat = {repeat}\n[campaign.vary]\n{line}\n'
                                 '[campaign.measure]\nmean = "mean plant.Vessel.LEVEL"\nheld = "time MW 10 <> 0"\n')

    # Two runs of the same would be one row, and several lines of CSV.
    def test_each_value_is_listed_once(self):
        for line, column, name, value in (
                ('"set.MW 10" = [3, 4, 3]', 22, "set.MW 10", "3"),
                ('"set.MW 10" = [3, "W#16#3"]', 19, "set.MW 10", "W#16#3"),
                ('"plant.Vessel.stroke" = [4, "4s"]', 29, "plant.Vessel.stroke", "4s"),
                ('"plant.Vessel.stroke" = { from = 4, to = 4, steps = 3 }', 1, "plant.Vessel.stroke", "4"),
                ('"plant.Vessel.HAND_FILL" = [0, 1, 0]', 35, "plant.Vessel.HAND_FILL", "0"),
                ('"cpu.engine" = ["jit", "jit"]', 24, "cpu.engine", "jit")):
            with self.subTest(line):
                self.vary(line)
                call = self.campaign(PROBLEMS)
                self.assertTrue(call.err.startswith(f"sweep.toml:5:{column}: error: '{name}' has the value {value} twice; "), call.err)
                self.assertEqual(call.err.count("[P0788]"), 1)
                self.assertFalse((self.folder / "sweep.sqlite").exists())

    def test_a_value_that_cannot_be_set_is_refused_or_has_no_measures(self):
        for line, words in (('"set.Z 1" = [999, 1000]', "sweep.toml:5:19: error: '1000' cannot be set: Z 1 cannot be set: it takes 0 to 999"),
                            ('"set.T 1" = 5', "sweep.toml:5:13: error: '5' cannot be set: T 1 cannot be set: only the program starts a timer")):
            with self.subTest(line):
                self.vary(line)
                self.assertTrue(self.campaign(PROBLEMS).err.startswith(words))
        self.vary('"set.MW 10" = { uniform = [40000, 50000] }')  # what is drawn is known when it runs
        self.assertIn("0 passed, 1 failed", self.campaign(PROBLEMS).out)
        with sqlite3.connect(self.folder / "sweep.sqlite") as results:
            self.assertEqual(results.execute("SELECT passed, mean, held FROM run").fetchall(), [(0, None, None)])

    # Sums of times are exact, and a mean is one of its values where they are all the same.
    def test_the_mean_of_a_value_that_stays_is_this_value(self):
        self.vary('"set.MW 10" = 1\n"plant.Vessel.start" = { from = 10.1, to = 13.7, steps = 7 }')
        self.campaign(GOOD)
        with sqlite3.connect(self.folder / "sweep.sqlite") as results:
            rows = results.execute('SELECT "plant.Vessel.start", mean, held FROM run').fetchall()
        self.assertEqual([(mean, held) for _, mean, held in rows], [(start, 1) for start, _, _ in rows])

    def test_all_that_is_unknown_is_told(self):
        self.write("sweep.toml", SWEEP.replace('name = "Vessel"', 'scenario = "none.scn"')
                   .replace('"plant.Vessel.start"', '"plant.Vessel.end"').replace('"time A 1.0"', '"time Q"').replace("LEVEL", "HEIGHT")
                   .replace("[campaign.measure]", '"cpu.model" = ["314C-2 PtP", "999"]\n[campaign.measure]'))
        call = self.campaign(PROBLEMS)
        for words in ("none.scn", "'999'", "'end'", "'Q'", "'HEIGHT'"):
            self.assertIn(words, call.err)

    def test_wrong_options_are_refused(self):
        for options in (["--shard", "3/2"], ["--shard", "x"], ["--job", "81"], ["--job", "0"], ["-j", "0"],
                        ["--list", "--job", "1"], ["--merge", "a.sqlite", "--job", "1"]):
            self.campaign(USAGE, *options)
        self.write("other.sqlite", b"x" * 5000)
        self.assertIn("other.sqlite", self.campaign(UNREADABLE, "-o", "other.sqlite", "--resume").err)
        self.assertEqual(self.read("other.sqlite"), "x" * 5000)
        self.assertIn("there is no such file", self.campaign(UNREADABLE, "--merge", "none.sqlite").err)

    def test_the_example_runs(self):
        call = self.expect(GOOD, "campaign", str(EXAMPLE / "emptying.toml"), "-o", "example.sqlite")
        self.assertIn("140 passed, 0 failed", call.out)
        self.assertEqual(len(self.rows("example.sqlite")), 140)
