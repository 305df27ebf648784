"""Plants in a project of several stations: wired to terminals of their own station, of its DP and AS-i slaves, and of other stations
(S7-MGR-13, S7-NET-10, S7-NET-17)."""
from harness import *

STATIONS = """[[station]]
name = "Line"
folder = "line"

[[station]]
name = "Press"
folder = "press"

[[subnet]]
name = "DP"
kind = "profibus"
nodes = [ {station = "Line", address = 2, master = true} ]

[[slave]]
name = "Remote"
address = 4
type = "ET 200M"
modules = [
  {slot = 4, type = "SM 321 DI16xDC24V", input = 20, name = "Buttons"},
  {slot = 5, type = "SM 322 DO16xDC24V/0.5A", output = 20},
  {slot = 6, type = "SM 331 AI2x12bit", input = 300, name = "Analog"},
]

"""
VALVE = '[[plant]]\nname = "Valve"\nkind = "valve"\nstation = "Line"\ntravel_time = "1s"\n\n[plant.wire]\n'
# Up at the slave, down at the AS-i slave of the press; the end switches of either station.
WIRES = ('UP = "A 20.1"\nDOWN = "Press/Motor.DO1"\nLMNR_HS = "Press/E 257.4"\nLMNR_LS = "Buttons.DI3"\n'
         'POSITION = { to = "Press/PEW 288", low = 0, high = 100 }\n')
# MW 10 counts cycles, so that a trace shows each one.
CODE = "      U     M 0.0\n      =     A {up}\n      U     E {end}\n      =     M 1.0\n      L     MW 10\n      +     1\n      T     MW 10"
ERRORS = "".join(block("      NOP   0", ob) for ob in (82, 86, 122))


class StationPlants(Case):
    def lab(self, wires=WIRES, more=""):
        self.write("merker.toml", STATIONS + VALVE + wires + more)
        self.write("line/merker.toml", '[cpu]\nmodel = "314C-2 DP"\n')
        self.write("line/main.awl", block(CODE.format(up="20.1", end="20.3")) + ERRORS)
        self.write("press/merker.toml", """[cpu]
model = "314C-2 PtP"
[[module]]
slot = 4
type = "CP 343-2"
input = 256
output = 256
slave = [ {address = 1, name = "Motor", profile = "S-8.0"}, {address = 2, name = "Switches", profile = "S-0.0"} ]
[[module]]
slot = 5
type = "SM 331 AI8x12bit"
input = 288
""")
        self.write("press/main.awl", block(CODE.format(up="256.1", end="0.0").replace("E 0.0", "M 9.0").replace("A 256.1", "M 2.1") +
                                           "\n      L     MB 2\n      T     PAB 256\n      L     PEB 257\n      T     MB 3\n      L     PEW 288\n      T     MW 6")
                   + block("      NOP   0", 82))

    def refused(self, message, wires, more=""):
        self.lab(wires, more)
        err = self.expect(PROBLEMS, "check", ".").err
        self.assertIn(message, err)
        self.assertEqual(err.count(": error: "), 1, err)

    def test_wires_end_at_slaves_and_other_stations(self):
        self.lab()
        self.write("main.scn", """scenario "up by the line, down by the press"
  expect Line/E 20.3 = 1 within 10ms
  set Line/M 0.0 = 1
  expect Press/M 3.4 = 1 within 1100ms
  expect Line/E 20.3 = 0
  expect plant Valve.LMNR_HS = 1
  expect Press/MW 6 = 27648 within 500ms
  station Press
  expect terminal Switches.DI0 = 1
  station Line
  set Line/M 0.0 = 0
  set Press/M 0.0 = 1
  expect Line/M 1.0 = 1 within 1100ms
  expect Press/M 3.4 = 0
  expect Press/MW 6 = -27648 within 500ms

scenario "a slave that is switched off does not move it"
  set Line/M 0.0 = 1
  wait 500ms
  fault Remote power
  wait 1s
  expect plant Valve.POSITION < 60
  expect Press/M 3.4 = 0
  fault Remote power off
  expect Press/M 3.4 = 1 within 1100ms

scenario "STOP of the other station switches its outputs off"
  set Line/M 0.0 = 1
  wait 1100ms
  set Line/M 0.0 = 0
  set Press/M 0.0 = 1
  wait 300ms
  station Press
  stop
  wait 1s
  station Line
  expect plant Valve.POSITION > 60
  plant Valve.LMNR_HS stuck 1
  wait 10ms
  station Press
  expect terminal Switches.DI0 = 1
  run
  expect Line/M 1.0 = 1 within 1100ms
  expect Press/M 3.4 = 1
""")
        self.expect(GOOD, "test", ".")

    # Each step of the valve brings another amount; the module measures it once in each of its own cycles all the same.
    def test_an_amount_is_measured_while_it_changes(self):
        self.lab()
        self.write("main.scn", """scenario "beside the cycle of the module"
  wait 1us
  set Line/M 0.0 = 1
  wait 700ms
  expect Press/MW 6 > -20000
  expect Press/MW 6 < 27648
""")
        self.expect(GOOD, "test", ".")

    # A contact that is closed when time begins is there in the first cycle.
    def test_what_wires_show_before_time_begins(self):
        self.lab(WIRES.replace("LMNR_HS", "X").replace("LMNR_LS", "LMNR_HS").replace("X", "LMNR_LS"))
        self.write("press/main.awl", block("      L     PEB 257\n      T     MB 3", 100) + block("      NOP   0"))
        self.write("main.scn", 'scenario "closed"\n  expect Press/MB 3 = 2#1_0000\n')
        self.expect(GOOD, "test", ".")

    def test_threads_and_pauses_change_nothing(self):
        self.lab()
        traces = set()
        for options in *(["--threads", n] for n in "1248"), ["--no-skip"], ["--no-skip", "--threads", "2"]:
            self.expect(GOOD, "run", ".", "--for", "700ms", "--set", "Line/M 0.0 = 1, Press/M 0.0 = 0",
                        "--watch", "plant Line/Valve.POSITION, Press/MW 6, Line/M 1.0, Press/MB 3, Press/MW 10, Line/MW 10", "--trace", "t.csv", *options)
            traces.add((self.folder / "t.csv").read_text())
        self.assertEqual(len(traces), 1)
        self.assertGreater(traces.pop().count("Press/MW 6"), 2)

    def test_what_is_wrong_with_a_wire(self):
        self.refused("'UP' must be a terminal of a station: Line, Press; there is no station Pres", 'UP = "Pres/A 0.0"\n')
        self.refused("'UP' must be a terminal of a station: Line, Press; there is no station Pres", 'UP = "Pres/Motor.DO0"\n')
        self.refused("'DP4/9.DO0' is neither", 'UP = "DP4/9.DO0"\n')
        self.refused("the name 'up' is already used for another wire of UP", 'UP = "A 20.1"\nup = "A 20.2"\n')
        self.refused("the hardware configuration has no terminal at Press/A 300.0", 'UP = "Press/A 300.0"\n')
        self.refused("cannot be wired to Press/E 257.4; it needs a digital output terminal, DO", 'UP = "Press/E 257.4"\n')
        self.refused("Press/Switches.DO0; with the profile S-0.0 of the slave this bit is no output", 'UP = "Press/Switches.DO0"\n')
        self.refused("Press/E 257.4 is already wired to Line/Valve.LMNR_HS", WIRES,
                     VALVE.replace('"Valve"', '"Other"') + 'LMNR_HS = "Press/E 257.4"\n')
        self.refused("Switches.DI0 is already wired to Line/Valve.LMNR_HS", WIRES,
                     VALVE.replace('"Valve"', '"Other"').replace("Line", "Press") + 'LMNR_HS = "Switches.DI0"\n')
        self.refused("that is a plant of the station Line; plants feed only those of their own station", WIRES,
                     VALVE.replace('"Valve"', '"Other"').replace("Line", "Press") + 'UP = "Valve.LMNR_HS"\n')
        self.refused("that is a plant of the station Line; plants feed only those of their own station", WIRES,
                     VALVE.replace('"Valve"', '"Other"').replace("Line", "Press") + 'UP = "line/Valve.LMNR_HS"\n')
        self.refused("a plant cannot feed itself", 'UP = "Valve.LMNR_LS"\n')
        self.refused("fast signals need a terminal of the plant's own station", "",
                     '[[plant]]\nname = "P"\nkind = "pulse train"\nstation = "Line"\n[plant.wire]\nPULSES = "Press/Switches.DI0"\n')
        self.refused("'station' must be the name of a [[station]]: Line, Press", "", VALVE.replace('"Valve"', '"V"').replace('"Line"', '"Lin"'))
        self.refused("a [[plant]] needs 'station'", "", VALVE.replace('"Valve"', '"V"').replace('station = "Line"\n', ""))
        self.refused("the name 'Valve' is already used for another plant", "", VALVE)

    # A plant of the station's own merker.toml has the terminals of that station.
    def test_wires_of_a_station_end_there(self):
        self.lab("")
        own = VALVE.replace('station = "Line"\n', "").replace('"Valve"', '"Own"')
        self.write("line/merker.toml", '[cpu]\nmodel = "314C-2 DP"\n' + own + 'UP = "Press/Motor.DO1"\n')
        for project in ".", "line":
            err = self.merker("check", project).err
            self.assertIn("'UP' must be a terminal of this station; a plant with a wire to another one, Press, stands in the merker.toml of the "
                          "project that names the stations", err)

    def test_data_of_a_slave_have_no_terminals(self):
        drive = '[[slave]]\nname = "Drive"\naddress = 6\ntype = "PROFIdrive"\nmodules = [ {type = "Standard telegram 1", input = 60, output = 60} ]\n\n'
        self.lab()
        self.write("merker.toml", STATIONS + drive + VALVE + 'LMNR_HS = "E 60.0"\n')
        err = self.expect(PROBLEMS, "check", ".").err
        self.assertIn("cannot be wired to E 60.0; there are data of the DP slave Drive without terminals", err)

    # They stand beside each other in scenarios and on the command line.
    def test_names_of_plants(self):
        for name in "a/b", "a,b", "a:b", "a.b", "a b", "a\\u0007b", "a\\u007Fb", "":
            self.refused("'name' must be a word without blanks, control characters and . , : / = \"", "", VALVE.replace('"Valve"', f'"{name}"'))


if __name__ == "__main__":
    unittest.main()
