"""PROFIBUS-DP in projects: slaves from GSD files and of the catalogue, what is wrong with them, a station that fails at any instant."""
import os
import pathlib
import random
import re

from harness import *

EXAMPLE = pathlib.Path(__file__).resolve().parents[2] / "examples" / "networks" / "profibus"
SUBNET = '[[subnet]]\nname = "DP"\nkind = "profibus"\nnodes = [ {address = 2, master = true} ]\n'
SLAVE = '[[slave]]\nname = "V"\naddress = 4\ngsd = "v.gsd"\nmodules = [ {type = "8 sensors", input = 10}, {type = "8 valves", output = 10} ]\n'
AREAS = ("modules = [ {input = 20, local = 30, length = 2}, {output = 20, local = 30, length = 2},\n"
         '            {input = 300, local = 300, length = 8, consistency = "all"} ]\n')
UNPLUGS = int(os.environ.get("MERKER_UNPLUGS", "300"))
COUNTING = block("      NOP   0") + block(
    "      L     LB 0\n      L     B#16#39\n      ==I\n      SPBN  back\n      L     MD 100\n      +     1\n      T     MD 100\n"
    "      BEA\nback: L     MD 104\n      +     1\n      T     MD 104", 86)


class Profibus(Case):
    def setUp(self):
        super().setUp()
        self.write("p/v.gsd", (EXAMPLE / "gsd" / "valves.gsd").read_bytes())
        self.write("p/main.awl", COUNTING)

    def project(self, text, model="314C-2 DP"):
        self.write("p/merker.toml", f'[cpu]\nmodel = "{model}"\n{text}')

    def refused(self, text, message, model="314C-2 DP"):
        self.project(text, model)
        self.assertIn(message, self.expect(PROBLEMS, "check", "p").err)

    def test_values_of_slaves_are_set_and_shown(self):
        self.project(SUBNET + SLAVE)
        run = self.expect(GOOD, "run", "p", "--for", "1s", "--set", "E 10.3 = 1, PAB 10 = 5", "--print", "EB 10, PEB 10")
        self.assertEqual(run.lines[:2], ["EB 10 = B#16#08", "PEB 10 = B#16#08"])
        hardware = self.expect(GOOD, "hw", "p").out
        self.assertIn("PROFIBUS-DP: master 2, 1500 kbit/s, bus cycle 0.426 ms\n", hardware)
        self.assertIn("    4 V (Valve island), diagnostic address 1022\n", hardware)
        self.assertRegex(hardware, r"DP4/1 +8 sensors +E 10")

    # S7-NET-04, S7-NET-05, S7-NET-06, S7-NET-10, S7-NET-25
    def test_rules_of_the_bus(self):
        self.refused(SUBNET, "[[subnet]]' needs a [[slave]]")
        self.refused(SLAVE, "'slave' must be on a [[subnet]] with kind = \"profibus\"")
        self.refused(SUBNET + SLAVE.replace("address = 4", "address = 126"), "'address' must be 1 to 125: 126 is for slaves that have no address yet")
        self.refused(SUBNET + SLAVE.replace("address = 4", "address = 0"), "'address' must be 1 to 125: 0 is the programming device's")
        self.refused(SUBNET + SLAVE.replace('"V"', '" "'), "'name' must be a name, or left out")
        self.refused(SUBNET + SLAVE.replace("address = 4", "address = 2"), "'address' must be unique on the subnet; 2 is another node's")
        self.refused(SUBNET + SLAVE + SLAVE.replace('"V"', '"W"').replace("10", "12"), "4 is another node's")
        self.refused(SUBNET + "highest = 3\n" + SLAVE, "at most the highest address of the subnet, 3")
        self.refused(SUBNET + 'baud = "12M"\n' + SLAVE, "a baud rate that Valve island knows; 12M is none")
        self.refused(SUBNET + 'baud = "31.25k"\n' + SLAVE, "'baud' must be one of 9.6k")
        self.refused(SUBNET.replace("{address = 2, master = true}", "") + SLAVE, "one station, the DP master")
        # S7-NET-24
        self.refused(SUBNET + SLAVE, "CPU 314C-2 PtP has no DP interface", "314C-2 PtP")

    def test_rules_of_the_slave(self):
        self.refused(SUBNET + SLAVE.replace("8 sensors", "9 sensors"), 'the name of a module in the GSD file: "8 valves", "8 sensors"')
        self.refused(SUBNET + SLAVE.replace("input = 10", "output = 10"), "'output' must be omitted; the module has no such bytes")
        self.refused(SUBNET + SLAVE.replace("input = 10", "input = 124"), "overlap")
        self.refused(SUBNET + SLAVE.replace("input = 10", "slot = 7").replace("output = 10", "slot = 7"), "'slot' must be unique in the slave")
        five = ", ".join(['{type = "8 valves"}'] * 5)
        self.refused(SUBNET + re.sub(r"modules = .*", f"modules = [ {five} ]", SLAVE), "at most 4 modules; these are 5")
        three = ", ".join(['{type = "Scale, 8 bytes"}'] * 3)
        self.refused(SUBNET + re.sub(r"modules = .*", f"modules = [ {three} ]", SLAVE), "at most 16 bytes of inputs; these are 24")
        self.refused(SUBNET + SLAVE.replace("v.gsd", "w.gsd"), "p/w.gsd cannot be read")
        self.refused(SUBNET + SLAVE.replace("v.gsd", "main.awl"), "a GSD file; this one has no line #Profibus_DP")
        self.refused(SUBNET + SLAVE.replace('gsd = "v.gsd"', ""), "needs gsd = ")
        self.refused(SUBNET + SLAVE.replace('name = "V"', 'name = "V"\ncolour = 1'), "colour")

    # S7-OBI-11: plugs, supplies and shorts of three slaves come and go at random instants, also while others are there.
    # MERKER_UNPLUGS=10000 tries so many.
    def test_stations_fail_at_any_instant(self):
        self.project(SUBNET + SLAVE + "".join(f'[[slave]]\nname = "R{i}"\naddress = {i}\ntype = "ET 200M"\n' for i in (5, 6)))
        names, kinds = ("V", "R5", "R6"), ("line break", "power", "short circuit")
        chance, faults, answers = random.Random(20260), set(), [True] * 3
        steps, failures, returns = [], 0, 0

        def present(i):
            broken = any((names[k], "line break") in faults for k in range(i + 1))
            return not broken and (names[i], "power") not in faults and not any(kind == "short circuit" for _, kind in faults)

        for _ in range(UNPLUGS):
            fault = chance.choice(sorted(faults)) if faults and chance.random() < 0.6 else (chance.choice(names), chance.choice(kinds))
            steps.append(f"  wait {chance.randrange(1, 3_000_000) / 1e6:.6f}ms\n  fault {fault[0]} {fault[1]}{' off' if fault in faults else ''}\n")
            faults ^= {fault}
            before, answers = answers, [present(i) for i in range(3)]
            failures += sum(was and not now for was, now in zip(before, answers))
            returns += sum(now and not was for was, now in zip(before, answers))
        self.write("p/main.scn", 'scenario "at any instant"\n' + "".join(steps) +
                   f"  wait 10ms\n  expect MD 100 = L#{failures}\n  expect MD 104 = L#{returns}\n  expect mode = RUN\n")
        self.expect(GOOD, "test", "p")

    # S7-NET-22
    def test_a_drive_and_what_is_wrong_with_it(self):
        drive = '[[slave]]\nname = "D"\naddress = 6\ntype = "PROFIdrive"\nmodules = [ {type = "Standard telegram 9", input = 256, output = 256} ]\n'
        axis = '[[plant]]\nname = "Axis"\nkind = "positioning drive"\n[plant.wire]\nBUS = "D"\n'
        self.project(SUBNET + drive + axis)
        self.assertIn("  6  D, PROFIdrive\n", self.expect(GOOD, "network", "p").out)
        run = self.expect(GOOD, "run", "p", "--for", "100ms", "--set", "PAW 256 = W#16#406", "--print", "PEW 256, PED 262")
        self.assertEqual(run.lines[0], "PEW 256 = W#16#2331")  # ready, no OFF2, no OFF3, no deviation, control requested, standstill
        self.refused(SUBNET + drive.replace("telegram 9", "telegram 8") + axis, '\'type\' must be the telegram of the drive: "Standard telegram 1"')
        self.refused(SUBNET + drive.replace("telegram 9", "telegram 1") + axis, "'BUS' must be the name of a [[slave]] of type PROFIdrive")
        self.refused(SUBNET + drive + axis.replace('"D"', '"E"'), "'BUS' must be the name of a [[slave]] of type PROFIdrive")
        self.refused(SUBNET + drive + axis + axis.replace("Axis", "Other"), "D is already wired to Axis")
        self.refused(SUBNET + drive + axis.replace("[plant.wire]", "low_switch = 400000\n[plant.wire]"),
                     "'low_switch' must be so that low_switch is below high_switch")
        self.refused(SUBNET + drive + axis.replace('[plant.wire]\nBUS = "D"', ""), "a [[plant]] needs 'BUS'")
        self.project(SUBNET + drive + axis)
        self.write("p/main.scn", 'scenario "a word"\n  plant Axis.ZSW1 stuck 70000\n')
        self.assertIn("it is a word: a whole number from -32768 to 65535", self.expect(PROBLEMS, "test", "p").err)
        self.assertNotIn("Standard telegram 9 \"", self.expect(GOOD, "hw", "p", "--json").out)
        self.refused(SUBNET + drive.replace("modules", "#"), "needs modules = ")
        self.refused(SUBNET + drive.replace("} ]", '}, {type = "Standard telegram 1"} ]'), "at most 1 module;")
        self.refused(SUBNET + drive.replace("type = \"PROFIdrive\"", "type = \"PROFIdrive\"\ngsd = \"x.gsd\"") + axis, "'gsd' must be omitted; the slave has type")

    def test_a_master_among_several_stations(self):
        self.write("lab/merker.toml", '[[station]]\nname = "A"\nfolder = "../p"\n[[station]]\nname = "B"\nfolder = "../p"\n' +
                   SUBNET.replace("{address", '{station = "B", address') + SLAVE.replace("v.gsd", "../p/v.gsd"))
        self.project("")
        self.write("lab/main.scn", 'scenario "B has the slaves"\n  set B/E 10.0 = 1\n  expect B/PEB 10 = 1 within 10ms\n')
        self.expect(GOOD, "test", "lab")
        traces = []
        for threads in "1", "2", "4", "8":
            self.expect(GOOD, "run", "lab", "--for", "300ms", "--set", "B/E 10.0 = 1", "--watch", "B/PEB 10, A/MD 100", "--trace", "t.csv",
                        "--threads", threads)
            traces.append((self.folder / "t.csv").read_text())
        self.assertEqual(len(set(traces)), 1)

    # Intelligent slaves: CPU 31xC and CPU 31x: Installation, tables 11-8 and 11-11 (S7-NET-10, S7-OBI-09, S7-OBI-11, S7-SFC-07).
    def two_stations(self, areas=AREAS, slave='station = "Press"\n'):
        counting = "".join(
            block(f"      L     LB 0\n      L     B#16#39\n      ==I\n      SPBN  back\n      L     MD {at}\n      +     1\n      T     MD {at}\n"
                  f"      L     LW 6\n      T     MW {at + 8}\n      L     LB 10\n      T     MB {at + 10}\n      BEA\n"
                  f"back: L     MD {at + 4}\n      +     1\n      T     MD {at + 4}", ob) for ob, at in ((82, 100), (86, 120)))
        line = ("      L     MB 10\n      T     AB 20\n      L     EB 20\n      T     MB 11\n      CALL  SFC 14 (LADDR := W#16#12C,\n"
                "           RET_VAL := MW 12, RECORD := P#M 200.0 BYTE 8)")
        press = ("      L     EB 30\n      +     1\n      T     AB 30\n      L     MW 20\n      +     1\n      T     MW 20\n      T     MW 200\n"
                 "      T     MW 206\n      CALL  SFC 15 (LADDR := W#16#12C, RECORD := P#M 200.0 BYTE 8,\n           RET_VAL := MW 12)")
        for folder, code in ("line", line), ("press", press):
            self.write(f"{folder}/merker.toml", '[cpu]\nmodel = "314C-2 DP"\n')
            self.write(f"{folder}/main.awl", block(code) + counting + block("      NOP   0", 122))
        self.write("merker.toml", '[[station]]\nname = "Line"\nfolder = "line"\n[[station]]\nname = "Press"\nfolder = "press"\n' +
                   SUBNET.replace("{address", '{station = "Line", address') + f'[[slave]]\nname = "Slave"\n{slave}address = 5\n{areas}')

    def test_an_intelligent_slave(self):
        self.two_stations()
        self.write("main.scn", """scenario "bytes go both ways"
  set Line/MB 10 = 5
  expect Press/EB 30 = 5 within 10ms
  expect Line/MB 11 = 6 within 10ms
  expect Line/MW 12 = 0
  expect Press/MW 12 = 0
  expect Line/MW 200 > 0

scenario "STOP of the slave"
  set Line/MB 10 = 5
  wait 20ms
  station Press
  stop
  expect Line/MD 100 = 1 within 10ms
  expect Line/MW 108 = 1022
  expect Line/MB 110 = 4
  expect Line/MB 11 = 0
  expect Line/MD 120 = 0
  run
  expect Line/MD 104 = 1 within 10ms
  expect Line/MB 11 = 6 within 20ms

scenario "over a broken line nothing is heard"
  wait 20ms
  station Press
  stop
  expect Line/MD 100 = 1 within 10ms
  station Line
  fault Slave line break
  expect Line/MD 120 = 1 within 10ms
  station Press
  run
  wait 50ms
  expect Line/MD 104 = 0
  station Line
  fault Slave line break off
  expect Line/MD 124 = 1 within 10ms
  expect Line/MD 104 = 1 within 10ms
  expect Line/MD 100 = 1

scenario "the slave without power"
  wait 20ms
  station Press
  power off
  expect Line/MD 120 = 1 within 10ms
  expect Line/MD 100 = 0
  expect Line/MW 12 = W#16#80A0
  power on
  expect Line/MD 124 = 1 within 20ms
  wait 20ms
  expect Line/MD 100 = 0
  expect Line/MW 12 = 0

scenario "STOP of the master"
  set Line/MB 10 = 5
  wait 20ms
  station Line
  stop
  expect Press/MD 100 = 1 within 10ms
  expect Press/MB 110 = 4
  expect Press/EB 30 = 0 within 10ms
  run
  expect Press/MD 104 = 1 within 10ms
  power off
  expect Press/MD 120 = 1 within 10ms

scenario "the plug is pulled"
  set Line/MB 10 = 5
  wait 20ms
  station Line
  fault Slave line break
  expect Line/MD 120 = 1 within 10ms
  expect Press/MD 120 = 1 within 10ms
  expect Press/MW 12 = W#16#80A1
  fault Slave line break off
  expect Line/MD 124 = 1 within 10ms
  expect Press/MD 124 = 1 within 10ms
  expect Line/MB 11 = 6 within 20ms
  expect Press/MW 12 = 0 within 10ms
""")
        self.expect(GOOD, "test", ".")
        drawn = self.expect(GOOD, "network", ".").out
        self.assertIn("    2  Line, DP master\n    5  Press, intelligent slave \"Slave\"\n", drawn)

    # Each side counts each failure and each return, in whatever state the bus cycle is.
    def test_an_intelligent_slave_is_unplugged_at_any_instant(self):
        self.two_stations()
        chance, steps = random.Random(20261), []
        for i in range(UNPLUGS):
            steps.append(f"  wait {chance.randrange(1, 2_000_000) / 1e6:.6f}ms\n  fault Slave line break{' off' if i % 2 else ''}\n")
        if UNPLUGS % 2:
            steps.append("  fault Slave line break off\n")
        times = (UNPLUGS + 1) // 2
        self.write("main.scn", 'scenario "at any instant"\n  station Line\n' + "".join(steps) + "  wait 20ms\n" + "".join(
            f"  expect {station}/MD {at} = L#{times}\n" for station in ("Line", "Press") for at in (120, 124)) +
            "  expect Line/MD 100 = 0\n  expect Press/MW 12 = 0\n  expect mode = RUN\n")
        self.expect(GOOD, "test", ".")

    def test_two_stations_on_dp_do_not_depend_on_threads(self):
        self.two_stations()
        traces = set()
        for threads in "1", "2", "4", "8":
            self.expect(GOOD, "run", ".", "--for", "200ms", "--set", "Line/MB 10 = 7", "--watch", "Line/MB 11, Line/MW 200, Line/MW 206, Press/EB 30",
                        "--trace", "t.csv", "--threads", threads)
            traces.add((self.folder / "t.csv").read_text())
        self.assertEqual(len(traces), 1)
        self.assertGreater(traces.pop().count("Line/MW 200"), 10)

    def test_rules_of_an_intelligent_slave(self):
        def refused(message, **what):
            self.two_stations(**what)
            self.assertIn(message, self.expect(PROBLEMS, "check", ".").err)
        refused("'station' must be the name of a [[station]]: Line, Press", slave='station = "Pres"\n')
        refused("'station' must be a station whose DP interface is free", slave='station = "Line"\n')
        refused("overlap", areas="modules = [ {input = 20, local = 30, length = 8}, {input = 24, local = 40, length = 8} ]\n")
        refused("overlap", areas="modules = [ {input = 20, local = 30, length = 8}, {input = 40, local = 34, length = 8} ]\n")
        refused("'length' must be", areas="modules = [ {input = 20, local = 30, length = 33} ]\n")
        refused("'length' must be", areas='modules = [ {input = 20, local = 30, length = 17, unit = "word"} ]\n')
        refused("needs input or output of the master", areas="modules = [ {local = 30, length = 8} ]\n")
        refused("at most 244 bytes of inputs; these are 256",
                areas="modules = [ " + ", ".join(f"{{input = {300 + 32 * i}, local = {300 + 32 * i}, length = 32}}" for i in range(8)) + " ]\n")
        refused("at most 32 areas; these are 33",
                areas="modules = [ " + ", ".join(f"{{input = {300 + i}, local = {300 + i}}}" for i in range(33)) + " ]\n")
        refused("needs modules = ", areas="")
        refused("'local' must be wholly inside or outside the process image, bytes 0 to 127: the area is consistent",
                areas='modules = [ {input = 300, local = 124, length = 8, consistency = "all"} ]\n')

    # SFC 11: outputs of a group are held until the next SYNC or UNSYNC; FREEZE does the same with inputs.
    def test_sync_and_freeze(self):
        self.project(SUBNET + SLAVE.replace("address = 4", "address = 4\ngroups = [1]"))
        self.write("p/main.awl", COUNTING.split("ORGANIZATION_BLOCK OB 86")[0].replace(
            "      NOP   0",
            "      L     MB 8\n      T     PAB 10\n      CALL  SFC 11 (REQ := M 0.0, LADDR := W#16#3FF, GROUP := MB 3, MODE := MB 2,\n"
            "                RET_VAL := MW 4, BUSY := M 0.1)"))
        command = "  set MB 2 = {}\n  set M 0.0 = 1\n  wait 2 cycles\n  set M 0.0 = 0\n  wait 10ms\n"
        self.write("p/main.scn", 'scenario "held"\n  set MB 3 = 1\n  set MB 8 = 1\n  wait 10ms\n  expect PAB 10 = 1\n' +
                   command.format("16#20") + "  set MB 8 = 2\n  wait 10ms\n  expect PAB 10 = 1\n" +
                   command.format("16#10") + "  expect PAB 10 = 2\n" +
                   command.format("16#08") + "  set PEB 10 = 7\n  wait 10ms\n  expect EB 10 = 0\n" +
                   command.format("16#04") + "  expect EB 10 = 7\n  set MB 3 = 2\n  set M 0.0 = 1\n  wait 1 cycles\n"
                   "  expect MW 4 = W#16#7001 within 5ms\n  expect MW 4 = W#16#80B0 within 5ms\n"
                   "  set MB 2 = 16#30\n  expect MW 4 = W#16#8425 within 5ms\n")
        self.expect(GOOD, "test", "p")
