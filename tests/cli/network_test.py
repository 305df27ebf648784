"""A project of several stations (S7-MGR-13): checked, run and tested as one, with their operands by name, the same on any number of
threads; what is wrong with such a project; one station of it alone."""
import csv
import signal
import subprocess
import time

from harness import *

LAB = """[project]
name = "Lab"

[[station]]
name = "Press"
folder = "press"

[[station]]
name = "Belt"
folder = "belt"

[[station]]
name = "Mill"
folder = "mill"
"""

# MW 20 counts cycles, MW 22 every 10 ms (OB 35).
STATION = block("      U     E 0.0\n      =     A 0.0\n      L     MW 20\n      +     1\n      T     MW 20\n      UN    E 0.7\n      SPB   good\n"
                "      L     W#16#FFFF\n      BTI\ngood: NOP   0") + block("      L     MW 22\n      +     1\n      T     MW 22", 35)
LISTING = "OB 1\n      L     MW 100\n      L     KF +1\n      +F\n      T     MW 100\n      BE\n"


class Network(Case):
    def lab(self, settings=LAB):
        self.write("lab/merker.toml", settings)
        for name, interval in ("press", 10), ("belt", 20):
            self.write(f"lab/{name}/merker.toml", f'[cpu]\nmodel = "314C-2 PtP"\n[cpu.OB35]\ninterval = "{interval}ms"\n')
            self.write(f"lab/{name}/main.awl", STATION)
        self.write("lab/mill/merker.toml", '[cpu]\nmodel = "SINUMERIK 810 GA3"\n')
        self.write("lab/mill/main.s5", LISTING)

    def run_lab(self, *options, code=GOOD):
        return self.expect(code, "run", "lab", "--for", "1s", *options)

    def test_all_run_in_one_time(self):
        self.lab()
        call = self.run_lab("--set", "Press/E 0.0 = 1, Belt/MW 20 = 100", "--print", "Press/A 0.0, Belt/A 0.0, press/MW 22, Belt/MW 22")
        self.assertEqual(call.lines[:2], ["Press/A 0.0 = 1", "Belt/A 0.0 = 0"])
        self.assertEqual(call.lines[2:], ["Press/MW 22 = W#16#0064", "Belt/MW 22 = W#16#0032"])
        values = self.run_lab("--json", "--print", "Belt/MW 20, Mill/MW 100").json
        self.assertEqual(list(values["stations"]), ["Press", "Belt", "Mill"])
        self.assertGreater(values["Mill/MW 100"], 10)
        self.assertEqual(values["stations"]["Belt"]["cycles"], values["Belt/MW 20"])
        self.assertTrue(all(1 <= one["seconds"] < 1.1 for one in values["stations"].values()), values)

    def test_in_real_time_until_ctrl_c(self):
        self.lab()
        process = subprocess.Popen([os.environ["MERKER"], "run", "lab", "--json", "--print", "Belt/MW 20", "--watch", "Belt/MW 20",
                                    "--trace", "t.csv"], cwd=self.folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(lambda: (process.kill(), process.communicate()))
        self.assertIn("--station NAME", process.stderr.readline())
        trace = self.folder / "t.csv"
        while not trace.exists() or trace.read_text().count("\n") < 9:  # it is written while they run
            self.assertIsNone(process.poll())
            time.sleep(0.02)
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, GOOD, err)
        values = json.loads(out)
        self.assertEqual(values["stations"]["Belt"]["cycles"], values["Belt/MW 20"])
        self.assertEqual([one["mode"] for one in values["stations"].values()], ["RUN", "RUN", "RUN"])

    def test_each_runs_as_alone(self):
        self.lab()
        for place in "lab/press", "lab/belt":
            alone = self.expect(GOOD, "run", place, "--for", "1s", "--json", "--print", "MW 20, MW 22").json
            name = place[4:].capitalize()
            both = self.run_lab("--json", "--print", f"{name}/MW 20, {name}/MW 22").json
            self.assertEqual([alone["MW 20"], alone["MW 22"]], [both[f"{name}/MW 20"], both[f"{name}/MW 22"]])
            self.assertEqual(alone["instructions"], both["stations"][name]["instructions"])

    def test_the_same_on_any_number_of_threads(self):
        self.lab()
        traces = set()
        for threads in "1", "2", "3", "8":
            self.run_lab("--threads", threads, "--trace", "t.csv", "--watch", "Press/MW 20, Belt/MW 22, Mill/MW 100")
            traces.add(self.read("t.csv"))
        self.assertEqual(len(traces), 1)
        rows = list(csv.reader(traces.pop().splitlines()))
        self.assertEqual({row[1] for row in rows}, {"Press/MW 20", "Belt/MW 22", "Mill/MW 100"})
        times = [float(row[0]) for row in rows]
        self.assertEqual(times, sorted(times))
        self.assertEqual(sum(row[1] == "Belt/MW 22" for row in rows), 49)

    def test_both_engines(self):
        self.lab()
        for engine in "interpreter", "jit":
            self.assertIn("W#16#0064", self.run_lab("--engine", engine, "--print", "Press/MW 22").out)

    def test_a_fault_of_one(self):
        self.lab()
        call = self.run_lab("--set", "Belt/E 0.7 = 1", "--print", "Press/MW 22", code=FAULT)
        self.assertIn("the CPU of Belt went to STOP: STOP by programming error (OB 121 not loaded): BCD conversion error", call.err)
        self.assertEqual(call.out, "Press/MW 22 = W#16#0064\n")

    def test_check(self):
        self.lab()
        self.assertEqual(self.expect(GOOD, "check", "lab").out, "lab: 3 stations, 5 blocks, 0 errors, 0 warnings\n")
        self.write("lab/belt/main.awl", block("      L     MW 300"))
        self.assertIn("lab/belt/main.awl:4:13: error: flag byte 301", self.expect(PROBLEMS, "check", "lab").err)
        self.assertIn("error: flag byte 301", self.expect(PROBLEMS, "run", "lab", "--for", "1s").err)

    SCENARIO = """scenario "each by its name"
  set Press/E 0.0 = 1
  wait 100ms
  expect Press/A 0.0 = 1
  expect Belt/A 0.0 = 0
  expect Press/MW 22 > Belt/MW 22
  station Belt
  set E 0.0 = 1
  wait 2 cycles
  expect A 0.0 = 1
  repeat 2
    station Press
    stop
    expect mode = STOP
    run
  end
  expect mode = RUN
  expect Press/MW 22 < MW 22
  station Mill
  expect MW 100 > 1
  force Press/A 0.1 = 1
  force A 0.1 = 1
  unforce
  force AB 0 = 3
"""

    def test_scenarios(self):
        self.lab()
        self.write("lab/lab.scn", self.SCENARIO)
        self.write("lab/belt/belt.scn", "expect A 0.0 = 0\n")
        call = self.expect(GOOD, "test", "lab")
        self.assertEqual(call.lines, ["ok      lab/lab.scn: each by its name", "ok      lab/belt/belt.scn: belt", "2 passed, 0 failed"])
        self.write("lab/lab.scn", 'scenario "a fault"\n  set Belt/E 0.7 = 1\n  wait 1s\n')
        self.assertIn("lab/lab.scn:3", self.expect(PROBLEMS, "test", "lab").out)
        self.assertIn("expected no fault, the CPU of Belt went to STOP", self.expect(PROBLEMS, "test", "lab").out)
        self.write("lab/lab.scn", "set Belt/E 0.7 = 1\nwait 1s\nstation Belt\nexpect mode = STOP\n")
        self.expect(GOOD, "test", "lab")

    def test_memory_of_a_station_without_power(self):
        self.lab()
        self.write("lab/lab.scn", "station Belt\npower off\nset Press/MW 100 = 5\nexpect Press/MW 100 = 5\nset Belt/E 0.0 = 1\n")
        self.expect(GOOD, "test", "lab")
        self.write("lab/lab.scn", "station Belt\npower off\nstation Press\nset Belt/MW 100 = 5\n")
        self.assertIn("lab/lab.scn:4: at 0.000 s: set Belt/MW 100 = 5: the CPU is switched off", self.expect(PROBLEMS, "test", "lab").out)

    def test_wrong_scenarios(self):
        self.lab()
        for text, what in (("set Foo/E 0.0 = 1", "1:5: error: 'Foo' must be the name of a [[station]]: Press, Belt, Mill"),
                           ("station Foo", "1:9: error: 'Foo' must be the name of a [[station]]: Press, Belt, Mill"),
                           ("station", "the name of a station is expected here")):
            self.write("lab/lab.scn", text + "\n")
            self.assertIn(what, self.expect(PROBLEMS, "test", "lab").err)
        self.write("lab/belt/belt.scn", "station Press\n")
        self.assertIn("the project has one station only", self.expect(PROBLEMS, "test", "lab/belt").err)

    def test_wrong_operands(self):
        self.lab()
        for option, text, what in (("--print", "MW 10", "'MW 10' must be written with its station: Press/MW 10; stations are Press, Belt, Mill"),
                                   ("--print", "Foo/MW 10", "'Foo' must be the name of a [[station]]: Press, Belt, Mill"),
                                   ("--print", "Press/MW 300", "flag byte 301"), ("--set", "E 0.0 = 1", "written with its station")):
            self.assertIn(what, self.run_lab(option, text, code=USAGE).err)

    def wrong(self, settings, what):
        self.lab(settings)
        self.assertIn(what, self.expect(PROBLEMS, "check", "lab").err)

    def test_wrong_projects(self):
        twice = '[[station]]\nname = "A"\nfolder = "press"\n[[station]]\nname = "a"\nfolder = "belt"\n'
        self.wrong(twice, "merker.toml:5:8: error: the name 'a' is already used for another station above")
        # S7-HWCFG-06
        self.wrong('[[station]]\nname = "A"\nfolder = "nowhere"\n', "merker.toml:3:10: error: lab/nowhere is not a project folder")
        for folder in ".", "../lab", "press/..":
            self.wrong(f'[[station]]\nname = "A"\nfolder = "{folder}"\n', "'folder' must be the folder of a project of one station")
        self.wrong('[[station]]\nname = "A/B"\nfolder = "press"\n', "'name' must be at most 32 letters")
        self.wrong('[[station]]\nname = "A"\n', "'[[station]]' needs name")
        self.wrong(LAB + '[cpu]\nmodel = "312C"\n', "a project of several stations has no [cpu]")
        self.wrong("".join(f'[[station]]\nname = "S{i}"\nfolder = "press"\n' for i in range(1001)), "there are more than 1000 [[station]]")
        self.wrong('[[station]]\nname = "A"\nfolder = "belt"\nfoo = 1\n', "unknown key 'foo'")

    def test_stations_of_one_folder(self):
        self.lab("".join(f'[[station]]\nname = "S{i}"\nfolder = "press"\n' for i in range(20)))
        call = self.run_lab("--set", "S7/E 0.0 = 1", "--print", "S7/A 0.0, S8/A 0.0, S19/MW 22")
        self.assertEqual(call.lines, ["S7/A 0.0 = 1", "S8/A 0.0 = 0", "S19/MW 22 = W#16#0064"])

    MPI = LAB + """
[[subnet]]
name = "MPI(1)"
kind = "mpi"
baud = "187.5k"
highest = 15
nodes = [ {station = "Press", address = 2}, {station = "Belt", address = 3} ]

[[global_data]]
circle = 1
from = "Press/MB 100:8"
to = ["Belt/MB 120"]
rate = 2
status = ["Belt/MD 130"]
group_status = ["Belt/MD 134"]
"""

    def test_global_data(self):
        # S7-NET-27: MW 100 of one CPU is MW 120 of the other one
        self.lab(self.MPI)
        call = self.run_lab("--set", "Press/MW 100 = 4711, Press/MB 107 = 8, Press/MB 108 = 9", "--print", "Belt/MW 120, Belt/MD 126, Belt/MD 130, Belt/MD 134")
        self.assertEqual(call.lines, ["Belt/MW 120 = W#16#1267", "Belt/MD 126 = DW#16#00080000", "Belt/MD 130 = DW#16#80000800", "Belt/MD 134 = DW#16#80000800"])

    def test_two_cpus_exchange_76_bytes(self):
        # S7-SFC-23
        self.lab(self.MPI)
        data = "DATA_BLOCK DB 1\nSTRUCT\n  d : ARRAY [1..76] OF BYTE;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n"
        self.write("lab/press/main.awl", data + block(
            "      CALL  SFC 65 (REQ := M 0.0, CONT := FALSE, DEST_ID := W#16#3, REQ_ID := DW#16#7, SD := P#DB1.DBX0.0 BYTE 76, "
            "RET_VAL := MW 10, BUSY := M 0.1)"))
        self.write("lab/belt/main.awl", data + block(
            "      CALL  SFC 66 (EN_DT := TRUE, RET_VAL := MW 10, REQ_ID := MD 12, NDA := M 0.1, RD := P#DB1.DBX0.0 BYTE 76)\n"
            "      U     M 0.1\n      SPBN  none\n      L     MW 10\n      T     MW 20\n      L     MD 12\n      T     MD 22\nnone: NOP   0"))
        self.write("lab/lab.scn", """scenario "76 bytes"
  set Press/DB1.DBB 0 = 17, Press/DB1.DBB 75 = 34, Press/M 0.0 = 1
  expect Belt/MW 20 = 76 within 100ms
  expect Belt/MD 22 = 7
  expect Belt/DB1.DBB 75 = 34
  expect Belt/DB1.DBB 0 = 17
  expect Press/MW 10 = 0 within 100ms
scenario "the partner is in STOP"
  station Belt
  stop
  station Press
  set M 0.0 = 1
  expect Press/MW 10 = W#16#80B5 within 100ms
""")
        self.assertEqual(self.expect(GOOD, "test", "lab").lines[-1], "2 passed, 0 failed")

    def test_wrong_subnets(self):
        # S7-NET-02, S7-NET-05, S7-NET-06, S7-NET-25, S7-NETPRO-01
        for old, new, what in (("address = 3", "address = 2", "'address' must be unique on the subnet; 2 has another station"),
                               ("address = 3", "address = 16", "'address' must be at most the highest address of the subnet, 15"),
                               ("address = 3", "address = 1", "'address' must be a whole number from 2 to 126"),
                               ("address = 3", "address = 127", "'address' must be a whole number from 2 to 126"),
                               (", address = 3", "", "needs address = 3"), ("highest = 15", "highest = 20", "'highest' must be 15, 31, 63 or 126"),
                               ('{station = "Belt"', '{station = "Foo"', "'station' must be the name of a [[station]]: Press, Belt, Mill"),
                               ('{station = "Belt"', '{station = "Press"', "a CPU has one MPI interface"),
                               ('{station = "Belt"', '{station = "Mill"', "a SINUMERIK has no MPI interface"),
                               ('"187.5k"', '"12M"', "'baud' must be one of"), ('kind = "mpi"\n', "", 'needs kind = "mpi"'),
                               ('"mpi"', '"modbus"', "'kind' must be one of"), ("highest = 15", "foo = 1", "unknown key 'foo'")):
            self.wrong(self.MPI.replace(old, new, 1), what)

    def test_wrong_global_data(self):
        # S7-LIM-02: 22 bytes
        for old, new, what in (("100:8", "100:23", "must be at most 22 bytes long"), ("MB 120", "MB 120:4", "must be 8 bytes long"),
                               ("MB 100:8", "M 100.0", "must be a byte, word or double word"), ("MB 100:8", "MB 300", "flag byte 300"),
                               ("100:8", "100:x", "written with a whole number behind the colon"), ("Belt/MB 120", "Mill/MB 120", "on the MPI subnet of the sender"),
                               ("Belt/MB 120", "Foo/MB 120", "'Foo' must be the name of a [[station]]"), ("MD 130", "MW 130", "must be a double word"),
                               ("rate = 2", "rate = 256", "'rate' must be a whole number from 1 to 255"), ("circle = 1", "circle = 17", "from 1 to 16"),
                               ('"Belt/MB 120"', '"Belt/MB 120", "Belt/MB 140"', "Belt takes one packet of a circle"), ("circle = 1\n", "", "needs circle = 1")):
            self.wrong(self.MPI.replace(old, new, 1), what)
        circles = "".join(f'[[global_data]]\ncircle = {i}\nfrom = "Press/MB 100"\nto = ["Belt/MB 120"]\n' for i in range(2, 6))
        self.wrong(self.MPI + circles, "Press sends 4 packets at most")

    def test_one_mistake_is_one_problem(self):
        tables = ('[cpu]\nmodel = "312C"\nmpi_address = 3\n[cpu.OB35]\ninterval = "10ms"\n', '[hardware]\nmounting = "vertical"\n',
                  '[[module]]\nslot = 4\ntype = "SM 321 DI16xDC24V"\n')
        mistakes = [(self.MPI + table, "must be left out: a project of several stations has no [") for table in tables] + [
            (self.MPI.replace('"mpi"', '"token ring"'), "'kind' must be one of"),
            (self.MPI + '[[slave]]\naddress = 4\n[[subnet]]\nkind = "profbus"\n', "'kind' must be one of"),
            (self.MPI + '[[subnet]]\nname = "mpi(1)"\nkind = "ethernet"\n', "the name 'mpi(1)' is already used for another subnet above"),
            (self.MPI.replace('["Belt/MB 120"]', "[]"), "'to' must be at least one operand"),
            (self.MPI.replace("Belt/MB 120", "Press/MB 120"), "'Press/MB 120' must be of another station than the sender's"),
            (self.MPI.replace("[[subnet]]", '[[station]]\nname = "Extra"\nfolder = "belt"\n\n[[subnet]]').replace("Belt/MD 130", "Extra/MD 130"),
             "'Extra/MD 130' must be of a station that sends or takes this packet"),
        ]
        for settings, what in mistakes:
            self.lab(settings)
            err = self.expect(PROBLEMS, "check", "lab").err
            self.assertIn(what, err)
            self.assertEqual(err.count(": error: "), 1, err)

    def test_hardware_of_each_station(self):
        self.lab(self.MPI)
        out = self.expect(GOOD, "hw", "lab").out
        self.assertEqual([line for line in out.splitlines() if line.startswith("station ")], ["station Press", "station Belt", "station Mill"])
        self.assertEqual(out.count("CPU 314C-2 PtP"), 4)
        stations = self.expect(GOOD, "hw", "lab", "--json").json["stations"]
        self.assertEqual({name: one["cpu"] for name, one in stations.items()}, {"Press": "CPU 314C-2 PtP", "Belt": "CPU 314C-2 PtP"})

    def test_one_station_alone(self):
        self.lab()
        self.assertEqual(self.run_lab("--station", "belt", "--print", "MW 22").out, "MW 22 = W#16#0032\n")
        self.assertIn("lab/belt has one station only", self.expect(USAGE, "run", "lab/belt", "--station", "Belt", "--for", "1s").err)
        self.assertIn("OB 35", self.expect(GOOD, "list", "lab", "--station", "Belt").out)

    # In real time, too, no page opens and no station runs.
    def test_a_station_that_there_is_not(self):
        self.lab()
        for command in ("run",), ("run", "--for", "1s"), ("hw",), ("check",), ("test",), ("list",), ("xref",), ("diag", "--for", "1s"):
            call = self.expect(USAGE, *command, "lab", "--station", "Foo")
            self.assertEqual(call.err.splitlines()[0], "--station: there is no station 'Foo' in lab; its stations are Press, Belt, Mill", command)
            self.assertEqual(call.out, "", command)
        self.write("lab/merker.toml", LAB + "x = = 1\n")
        err = self.expect(PROBLEMS, "check", "lab", "--station", "Foo").err
        self.assertEqual(err.count("error: "), 1, err)

    # Those of its folder; the scenarios of the project speak of several stations.
    def test_tests_of_one_station(self):
        self.lab()
        self.write("lab/lab.scn", 'scenario "of all"\n  set Press/E 0.0 = 1\n  wait 2 cycles\n  expect Press/A 0.0 = 1\n')
        for name in "press", "belt":
            self.write(f"lab/{name}/own.scn", f'scenario "of {name}"\n  set E 0.0 = 1\n  wait 2 cycles\n  expect A 0.0 = 1\n')
        self.assertEqual(self.expect(GOOD, "test", "lab").lines[-1], "3 passed, 0 failed")
        self.assertEqual(self.expect(GOOD, "test", "lab", "--station", "Belt").out, "ok      lab/belt/own.scn: of belt\n1 passed, 0 failed\n")

    # S7-NETPRO-08: what is wrong with connections and Ethernet subnets.
    LINKS = LAB + """
[[subnet]]
name = "MPI(1)"
kind = "mpi"
nodes = [ {station = "Press", address = 2}, {station = "Belt", address = 3} ]

[[subnet]]
name = "Net"
kind = "ethernet"
nodes = [ {station = "Press", address = "192.168.0.1"}, {station = "Belt", address = "192.168.0.2"} ]

[[connection]]
id = "W#16#1"
local = "Press"
partner = "Belt"
"""

    def linked(self, settings=LINKS, press="generic", belt="314C-2 PN/DP", more=""):
        self.lab(settings)
        self.write("lab/press/merker.toml", f'[cpu]\nmodel = "{press}"\n{more}')
        self.write("lab/belt/merker.toml", f'[cpu]\nmodel = "{belt}"\n')
        return self.merker("check", "lab")

    def test_wrong_connections(self):
        self.assertEqual(self.linked().code, GOOD)
        link = self.LINKS[self.LINKS.index("[[connection]]"):]
        for old, new, what in (
                ('id = "W#16#1"', 'id = "W#16#0"', "merker.toml:27:6: error: 'id' must be the local ID as blocks name it"),
                ('local = "Press"', 'local = "Pres"', "merker.toml:28:9: error: 'local' must be the name of a [[station]]: Press, Belt, Mill"),
                ('local = "Press"\n', "", "merker.toml:26:1: error: '[[connection]]' needs id = "),
                ('partner = "Belt"\n', 'partner = "press"\n', "'partner' must be another station than local"),
                ('partner = "Belt"\n', 'partner = "Mill"\n', "'partner' must be on a subnet of Press; Mill is on none of them, and no CPU routes a connection"),
                ('partner = "Belt"\n', 'partner = "Belt"\nsubnet = "Lan"\n', "'subnet' must be a subnet of both stations: MPI(1), Net"),
                ('partner = "Belt"\n', 'partner = "Belt"\nport = 1\n', "unknown key 'port'"),
                ('partner = "Belt"\n', 'partner = "Belt"\n' + link, "'id' must be another one: Press has a connection W#16#1 above"),
                ('"192.168.0.2"', '"192.168.0.1"', "'address' must be unique on the subnet; 192.168.0.1 has another station"),
                ('"192.168.0.2"', '"10.0.0.2"', "'address' must be of the subnet of the others: 192.168.0.1 to 192.168.0.254"),
                ('"192.168.0.2"', '"192.168.0.256"', "'address' must be an IP address"),
                ('"192.168.0.2"', "2", "'address' must be an IP address"),
                ('kind = "ethernet"', 'kind = "ethernet"\nbaud = "1G"', "'baud' must be")):
            self.assertIn(old, self.LINKS)
            self.assertIn(what, self.linked(self.LINKS.replace(old, new)).err)
        self.assertEqual(self.linked(press="314C-2 PN/DP").code, GOOD)  # FB 12 to 15 over its own interface
        mpi = self.LINKS.replace('partner = "Belt"\n', 'partner = "Belt"\nsubnet = "MPI(1)"\n').replace('"Press"', '"Belt"', 0)
        self.assertIn("SFB 12 to 15, or with a CP 343-1", self.linked(mpi[:mpi.index("[[subnet]]\nname = \"Net\"")] + mpi[mpi.index("[[connection]]"):], press="314C-2 DP").err)
        self.assertIn("'station' must be a station with an Ethernet interface; the CPU 314C-2 DP has none", self.linked(belt="314C-2 DP").err)
        own = '[[connection]]\nid = 1\npartner = "tcp://127.0.0.1:1"\n'
        self.assertIn("Press has a connection W#16#1 in its own merker.toml", self.linked(more=own).err)
        many = "".join(link.replace("W#16#1", f"W#16#{i:X}") for i in range(1, 12))
        self.assertIn("'connection' must be left out: Belt has 12 connections, of which 2 are kept",
                      self.linked(self.LINKS.replace(link, many)).err)

    def test_a_processor_brings_an_ethernet_interface(self):
        self.linked(belt="314C-2 DP")
        self.write("lab/belt/merker.toml", '[cpu]\nmodel = "314C-2 DP"\n[[module]]\nslot = 4\ntype = "CP 343-1"\n')
        self.assertEqual(self.merker("check", "lab").err.count("Ethernet interface"), 0)

    def test_connections_are_shown(self):
        self.linked(self.LINKS.replace('partner = "Belt"\n', 'partner = "Belt"\nsubnet = "net"\n'))
        text = self.expect(GOOD, "network", "lab").out
        self.assertIn("Net: Ethernet, 100 Mbit/s\n  192.168.0.1  Press\n  192.168.0.2  Belt\n", text)
        self.assertIn("connections\n  Press S7 connection W#16#1 calls Belt (Net)\n", text)
        document = self.expect(GOOD, "network", "lab", "--json").json
        self.assertEqual(document["subnets"][1]["nodes"][0], {"station": "Press", "address": "192.168.0.1"})
        self.assertEqual(document["connections"], [{"station": "Press", "kind": "s7", "id": 1, "active": True, "partner": "Belt (Net)"}])

    def test_commands_of_one_station(self):
        self.lab()
        for command in (("list",), ("xref",), ("bench", "--for", "1s"), ("diag", "--for", "1s"), ("debug",), ("tags",),
                        ("export", "-o", "x"), ("monitor", "serial")):
            call = self.merker(*command, "lab")
            self.assertNotIn(call.code, (GOOD, FAULT), f"{command} {call.out}")
            self.assertIn("needs --station NAME, or the folder of a station, here: NAME is one of Press, Belt, Mill", call.err, command)
        for option in ("--cpu", "312C"), ("--card", "card"), ("--serial", "partner"):
            self.assertIn(f"{option[0]} is for one station: name it with --station", self.run_lab(*option, code=USAGE).err)
        self.assertIn("--cycles is for one station", self.expect(USAGE, "run", "lab", "--cycles", "5").err)
        self.assertIn("--threads is for a project of several stations",
                      self.expect(USAGE, "run", "lab/press", "--for", "1s", "--threads", "2").err)


if __name__ == "__main__":
    unittest.main()
