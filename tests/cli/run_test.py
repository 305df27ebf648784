import os
import signal
import subprocess

from harness import *


class Run(Case):
    def setUp(self):
        super().setUp()
        self.write("a.awl", PROGRAM + DATA)

    def test_prints_in_the_documented_form(self):
        call = self.expect(GOOD, "run", "a.awl", "--for", "3s", "--set", "E 0.0=1, MW 10=W#16#0005, MB 30=200",
                           "--print", "MW 10, MB 30, MD 40, A 0.0, A 0.1, I 0.0, DB1.DBW 0, DB1.count, DB1.level, DB1.pause, DB1.list[2], DB1.on")
        self.assertEqual(call.lines, [
            "MW 10 = W#16#0005", "MB 30 = B#16#C8", "MD 40 = DW#16#00000000", "A 0.0 = 1", "A 0.1 = 1", "I 0.0 = 1",
            "DB1.DBW 0 = W#16#0005", "DB1.count = 5", "DB1.level = 1.500000e+000", "DB1.pause = T#5S",
            "DB1.list[2] = W#16#0002", "DB1.on = 1"])
        self.assertEqual(call.err, "")

    def test_dates_and_texts_in_their_own_notation(self):
        call = self.expect(GOOD, "run", "a.awl", "--cycles", "1", "--print", "DB1.start, DB1.text")
        self.assertEqual(call.lines, ["DB1.start = DT#1998-04-14-17:53:17.333", "DB1.text = 'ab$'c'"])
        setting = "DB1.start = DT#2005-03-01-08:00:00, DB1.text = 'grün, 5'"
        call = self.expect(GOOD, "run", "a.awl", "--cycles", "1", "--set", setting, "--print", "DB1.start, DB1.text")
        self.assertEqual(call.lines, ["DB1.start = DT#2005-03-01-08:00:00.000", "DB1.text = 'grün, 5'"])
        values = self.expect(GOOD, "run", "a.awl", "--cycles", "1", "--json", "--print", "DB1.start, DB1.text").json
        self.assertEqual((values["DB1.start"], values["DB1.text"]), ("DT#1998-04-14-17:53:17.333", "ab'c"))
        for wrong in ("DB1.text = 5", "DB1.text = '123456789'", "DB1.start = 'a'", "DB1.start = DT#1998-02-30-00:00:00"):
            self.expect(USAGE, "run", "a.awl", "--cycles", "1", "--set", wrong)

    def test_the_periphery_has_two_sides(self):
        self.write("p.awl", block("      L     PEB 2\n      T     PAB 3"))
        call = self.expect(GOOD, "run", "p.awl", "--cycles", "3", "--set", "EB 2 = 5", "--print", "PEB 2, PAB 2, PEB 3, PAB 3")
        self.assertEqual(call.lines, ["PEB 2 = B#16#05", "PAB 2 = B#16#00", "PEB 3 = B#16#00", "PAB 3 = B#16#05"])

    def test_what_does_not_exist_is_said_before_the_run(self):
        for option, text, why in (("--print", "MW 10, DB9.DBW 0", "there is no DB 9"), ("--print", "DB1.DBW 100", "DB 1 has 36 bytes"),
                                  ("--print", "PEW 300", "no module"), ("--set", "DB9.DBW 0 = 1", "there is no DB 9")):
            call = self.expect(PROBLEMS, "run", "a.awl", "--cycles", "1", option, text)
            self.assertRegex(call.err, r"(?m)^" + option + r":1:\d+: error: .* does not exist: " + why + r".* \[P0962\]$")
            self.assertEqual(call.out, "")

    def test_data_blocks_of_the_program_may_come_later(self):
        create = ("      CALL  SFC 22 (LOW_LIMIT := W#16#9, UP_LIMIT := W#16#9, COUNT := W#16#4, RET_VAL := MW 40, DB_NUMBER := MW 42)\n"
                  "      CALL  SFC 46")
        self.write("c.awl", block(create))
        call = self.expect(GOOD, "run", "c.awl", "--for", "1s", "--print", "DB9.DBW 0, MW 42")
        self.assertEqual(call.lines, ["DB9.DBW 0 = W#16#0000", "MW 42 = W#16#0009"])
        call = self.expect(PROBLEMS, "run", "c.awl", "--for", "1s", "--print", "DB8.DBW 0, MW 42")
        self.assertEqual(call.lines, ["DB8.DBW 0 = ?", "MW 42 = W#16#0009"])
        self.assertIn("--print: DB8.DBW 0 does not exist: there is no DB 8", call.err)

    def test_timers_show_their_time(self):
        call = self.expect(GOOD, "run", "a.awl", "--for", "500ms", "--set", "E 0.0 = 1", "--print", "T 1, A 0.1")
        self.assertRegex(call.lines[0], r"^T 1 = S5T#1S(4|5)\d0MS$")
        self.assertEqual(call.lines[1], "A 0.1 = 0")

    def test_symbols(self):
        self.write("a.sym", "\"Start, now\" E 0.0 BOOL\n\"Motor\" A 0.0 BOOL\n\"Number\" MW 10 INT\n")
        call = self.expect(GOOD, "run", "a.awl", "--for", "1s", "--set", "\"Start, now\" = TRUE, \"Number\" = -5",
                           "--print", "\"Motor\", \"Number\"")
        self.assertEqual(call.lines, ["\"Motor\" = 1", "\"Number\" = -5"])

    def test_json(self):
        call = self.expect(GOOD, "run", "a.awl", "--for", "3s", "--set", "E 0.0 = 1", "--json",
                           "--print", "A 0.0, MW 10", "--print", "DB1.count, DB1.level, T 1")
        values = call.json
        self.assertIs(values["A 0.0"], True)
        self.assertEqual((values["MW 10"], values["DB1.count"], values["DB1.level"], values["T 1"]), (0, 5, 1.5, 0))
        self.assertEqual(values["mode"], "RUN")
        self.assertIs(values["fault"], False)
        self.assertAlmostEqual(values["seconds"], 3.0, places=2)
        self.assertGreater(values["cycles"], 100)
        self.assertGreater(values["instructions"], 1000)

    def test_cycles(self):
        call = self.expect(GOOD, "run", "a.awl", "--cycles", "7", "--print", "MW 20")
        self.assertEqual(call.lines, ["MW 20 = W#16#0007"])
        self.assertEqual(self.expect(GOOD, "run", "a.awl", "--cycles", "0", "--print", "MW 20").lines, ["MW 20 = W#16#0000"])

    def test_lengths_of_time(self):
        for text in ("1500ms", "1.5s", "T#1S500MS", "S5T#1S500MS"):
            seconds = self.expect(GOOD, "run", "a.awl", "--for", text, "--json").json["seconds"]
            self.assertAlmostEqual(seconds, 1.5, places=2, msg=text)

    def test_a_fault_is_3_with_its_cause(self):
        call = self.expect(FAULT, "run", "a.awl", "--for", "1s", "--set", "E 0.7 = 1", "--print", "MW 20")
        self.assertIn("STOP", call.err)
        self.assertIn("OB 1", call.err)
        self.assertEqual(call.lines, ["MW 20 = W#16#0001"])
        values = self.expect(FAULT, "run", "a.awl", "--for", "1s", "--set", "E 0.7 = 1", "--json").json
        self.assertEqual((values["mode"], values["fault"]), ("STOP", True))
        self.assertIn("OB 1", values["stop_reason"])

    def test_a_program_that_stops_itself_is_good(self):
        self.write("s.awl", block("      CALL  SFC 46"))
        self.assertEqual(self.expect(GOOD, "run", "s.awl", "--for", "1s", "--json").json["mode"], "STOP")
        self.expect(GOOD, "run", "s.awl", "--cycles", "5")

    def test_an_endless_loop_is_a_fault(self):
        self.write("loop.awl", block("here: SPA   here"))
        self.assertIn("STOP", self.expect(FAULT, "run", "loop.awl", "--for", "1s").err)

    def test_a_startup_without_end_is_said(self):
        self.write("loop.awl", block("      NOP   0") + block("here: SPA   here", 100))
        self.assertIn("STARTUP", self.expect(PROBLEMS, "run", "loop.awl", "--cycles", "100000").err)
        self.assertIn("STARTUP", self.expect(GOOD, "run", "loop.awl", "--for", "1s").err)

    def test_a_program_without_ob_1(self):
        self.write("fc.awl", "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\n      NOP   0\nEND_FUNCTION\n")
        self.assertIn("P0710", self.expect(PROBLEMS, "run", "fc.awl", "--for", "1s").err)

    def test_problems_in_the_source(self):
        self.write("bad.awl", block("      FLY"))
        call = self.expect(PROBLEMS, "run", "bad.awl", "--for", "1s", "--json")
        self.assertEqual(call.json["problems"][0]["line"], 4)
        self.assertIn("bad.awl:4:", call.err)

    def test_a_day_of_virtual_time_costs_seconds(self):
        self.write("s.awl", block("      L     DW#16#0\n      T     MD 10"))
        self.expect(GOOD, "run", "s.awl", "--for", "10m")


class Trace(Case):
    def trace(self, name):
        self.write("a.awl", PROGRAM)
        self.expect(GOOD, "run", "a.awl", "--for", "3s", "--set", "E 0.0=1", "--trace", name, "--watch", "E 0.0, A 0.0, A 0.1, T 1")
        return self.read(name)

    def test_one_line_per_change(self):
        rows = [line.split(",") for line in self.trace("t.csv").splitlines()]
        changes = [(operand, value) for _, operand, value in rows]
        self.assertEqual(changes[:2], [("E 0.0", "1"), ("A 0.0", "1")])
        self.assertEqual(sorted(changes[2:]), [("A 0.1", "1"), ("T 1", "1")])
        self.assertLess(float(rows[0][0]), 0.1)
        self.assertAlmostEqual(float(rows[-1][0]), 2.0, delta=0.05)

    # An output that a channel drives does not show in the image of outputs.
    def test_terminals_are_traced_and_printed(self):
        self.write("merker.toml", '[project]\nname = "t"\n[[module]]\nslot = "2.4"\n[[module.channel]]\nnumber = 0\nmode = "pwm"\n'
                                  'time_base = "1ms"\nperiod = 200\n[[module]]\nslot = "2.2"\nname = "D"\n')
        self.write("a.awl", "DATA_BLOCK DB 49\nSFB 49\nBEGIN\nEND_DATA_BLOCK\n" + block(
            "      CALL  SFB 49, DB 49 (LADDR := W#16#300, CHANNEL := 0, SW_EN := TRUE, OUTP_VAL := 500)"))
        names = "terminal D.DO0, terminal D.DI3, A 124.0"
        call = self.expect(GOOD, "run", ".", "--for", "150ms", "--trace", "t.csv", "--watch", names, "--print", names)
        rows = [line.split(",") for line in self.read("t.csv").splitlines()]
        values = [value for _, name, value in rows if name == "terminal D.DO0"]
        self.assertEqual(values, ["0", "1", "0"])
        self.assertEqual([value for _, name, value in rows if name == "A 124.0"], [])
        self.assertEqual(call.out, "A 124.0 = 0\nterminal D.DO0 = 0\nterminal D.DI3 = 0\n")
        self.expect(GOOD, "plot", "t.csv", "-o", "t.svg", "--row", "terminal D.DO0 = pulses")
        self.assertIn("P0984", self.expect(USAGE, "run", ".", "--for", "1s", "--print", "terminal D.DO99").err)
        self.assertIn("P0981", self.expect(USAGE, "run", ".", "--for", "1s", "--trace", "t.csv", "--watch", "terminal X.DO0").err)

    # The way of an axis to the pulse, and beyond; small values in four digits
    def test_a_position_is_traced_to_the_pulse(self):
        places = {"200003": "200003", "1234567": "1234567", "-999": "-999"}
        plants = [f'[[plant]]\nname = "A{i}"\nkind = "axis"\nstart = {place}\n' for i, place in enumerate(places)]
        self.write("merker.toml", '[project]\nname = "t"\n' + "".join(plants) + '[[plant]]\nname = "F"\nkind = "first order"\nstart = 12.34567\n')
        self.write("a.awl", PROGRAM)
        watched = ", ".join(f"plant A{i}.POSITION" for i in range(len(places))) + ", plant F.PV"
        self.expect(GOOD, "run", ".", "--for", "10ms", "--trace", "t.csv", "--watch", watched)
        values = [line.split(",")[2] for line in self.read("t.csv").splitlines()]
        self.assertEqual(values[:4], [*places.values(), "12.35"])

    def test_two_runs_are_the_same_byte_for_byte(self):
        self.assertEqual(self.trace("1.csv"), self.trace("2.csv"))


class RealTime(Case):
    def start(self, *arguments, program=PROGRAM):
        self.write("a.awl", program)
        # Signals that come before the program is ready for them stay pending.
        held = lambda: signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT, signal.SIGTERM})
        return subprocess.Popen([os.environ["MERKER"], "run", "a.awl", "--no-workbench", *arguments], cwd=self.folder, text=True,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, preexec_fn=held)

    def end(self, process, number):
        process.send_signal(number)
        out, err = process.communicate(timeout=60)
        self.assertEqual((process.returncode, err), (GOOD, ""))
        return out

    def test_ctrl_c_ends_it_and_prints(self):
        os.mkfifo(self.folder / "trace")
        for number in (signal.SIGINT, signal.SIGTERM):
            process = self.start("--set", "E 0.0 = 1", "--json", "--print", "A 0.0", "--trace", "trace", "--watch", "A 0.1")
            with open(self.folder / "trace", encoding="utf-8") as trace:
                self.assertIn("A 0.1", trace.readline())  # two seconds after E 0.0
                values = json.loads(self.end(process, number))
            self.assertIs(values["A 0.0"], True)
            self.assertGreaterEqual(values["seconds"], 2)

    def test_a_cycle_without_end_is_not_waited_for(self):
        process = self.start("--json", "--print", "M 0.0", program="ORGANIZATION_BLOCK OB 1\nBEGIN\nm1: CALL SFC 43; SPA m1;\nEND_ORGANIZATION_BLOCK\n")
        # of the PLC's time: one second at most, and what passed until the signal came
        self.assertLess(json.loads(self.end(process, signal.SIGINT))["seconds"], 30)

    def test_a_fault_ends_it_at_once(self):
        process = self.start("--set", "E 0.7 = 1")
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, FAULT)
