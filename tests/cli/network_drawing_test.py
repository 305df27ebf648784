"""merker network: stations, subnets, global data and connections of a project as text, JSON and drawing, with what is inconsistent; the rules
of a subnet's cable."""
import xml.etree.ElementTree

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

[[subnet]]
name = "MPI(1)"
kind = "mpi"
baud = "187.5k"
highest = 15
nodes = [ {station = "Belt", address = 3}, {station = "Press", address = 2} ]

[[global_data]]
circle = 1
from = "Press/MB 100:8"
to = ["Belt/MB 120"]
"""

# An ungrounded machine behind a repeater.
CABLE = LAB.replace('"Belt", address = 3}', '"Belt", address = 3, grounded = false}').replace("\n[[global", """repeaters = ["R1"]
segments = [
  {length = "40m", nodes = ["Press", "R1"], terminated = ["Press", "R1"]},
  {length = "1000m", nodes = ["R1", "Belt"], terminated = ["Belt", "R1"]},
]

[[global""")


class Drawing(Case):
    def lab(self, settings=LAB):
        self.write("lab/merker.toml", settings)
        self.write("lab/press/merker.toml", '[cpu]\nmodel = "314C-2 PtP"\n[[connection]]\nid = "W#16#1"\npartner = "tcp://127.0.0.1:10102"\n')
        self.write("lab/belt/merker.toml", '[cpu]\nmodel = "312C"\n')
        self.write("lab/mill/merker.toml", '[cpu]\nmodel = "SINUMERIK 810 GA3"\n')
        for name in "press", "belt":
            self.write(f"lab/{name}/main.awl", block("      NOP   0"))
        self.write("lab/mill/main.s5", "OB 1\n      BE\n")

    def test_as_text(self):
        # S7-NETPRO-02, S7-NETPRO-07, S7-NETPRO-08
        self.lab(CABLE)
        self.assertEqual(self.expect(GOOD, "network", "lab").out, """Lab: 3 stations
  Press  CPU 314C-2 PtP      press
  Belt   CPU 312C            belt
  Mill   SINUMERIK 810 GA3   mill  (on no subnet)

MPI(1): MPI, 187.5 kbit/s, highest address 15
    2  Press
    3  Belt
  segment 1, 40 m: Press - R1
  segment 2, 1000 m: R1 - Belt

global data
  GD circle 1, every 8 cycles: Press/MB 100:8 → Belt/MB 120

connections
  Press S7 connection W#16#1 calls 127.0.0.1:10102
""")

    def test_as_json(self):
        self.lab(CABLE)
        plan = self.expect(GOOD, "network", "lab", "--json").json
        self.assertEqual(plan["stations"][1], {"name": "Belt", "folder": "belt", "cpu": "CPU 312C"})
        subnet = plan["subnets"][0]
        self.assertEqual(subnet["nodes"], [{"station": "Press", "address": 2}, {"station": "Belt", "address": 3}])
        self.assertEqual(subnet["segments"][1], {"length_m": 1000, "nodes": ["R1", "Belt"]})
        self.assertEqual(plan["global_data"][0]["to"], ["Belt/MB 120"])
        self.assertEqual(plan["connections"], [{"station": "Press", "kind": "s7", "id": 1, "active": True, "partner": "127.0.0.1:10102"}])
        self.assertEqual(plan["problems"], [])

    def test_as_drawing(self):
        self.lab(LAB.replace("MPI(1)", "MPI <1> & more"))
        self.expect(GOOD, "network", "lab", "--svg", "lab.svg")
        texts = [one.text for one in xml.etree.ElementTree.fromstring(self.read("lab.svg")).iter("{http://www.w3.org/2000/svg}text")]
        for text in "Press", "CPU 312C", "2", "3", "MPI <1> & more", "187.5 kbit/s":
            self.assertIn(text, texts)
        self.assertIn("cannot write no/where.svg", self.expect(UNREADABLE, "network", "lab", "--svg", "no/where.svg").err)

    def test_what_is_inconsistent(self):
        # S7-NETPRO-01: the same problem as check has, and still all that could be read
        self.lab(LAB.replace("address = 3", "address = 2"))
        call = self.expect(PROBLEMS, "network", "lab", "--json")
        self.assertEqual(call.err, self.expect(PROBLEMS, "check", "lab").err)
        self.assertEqual([one["line"] for one in call.json["problems"]], [21])
        self.assertEqual(call.json["subnets"][0]["nodes"], [{"station": "Belt", "address": 2}])
        self.lab(LAB.replace('"belt"', '"nowhere"'))
        self.assertIn("Belt   (not readable)", self.expect(PROBLEMS, "network", "lab").out)

    # A DP master alone is a network, too.
    def test_one_station(self):
        self.lab()
        dp = pathlib.Path(__file__).parents[2] / "examples" / "networks" / "profibus"
        text = self.expect(GOOD, "network", dp).out
        self.assertIn("PROFIBUS(1): PROFIBUS, 1.5 Mbit/s, highest address 126\n    2  PROFIBUS-DP, DP master\n    4  Valves, ", text)
        self.assertIn("\n    5  Remote, ET 200M\n", text)
        subnet = self.expect(GOOD, "network", dp, "--json").json["subnets"][0]
        self.assertEqual((subnet["kind"], [one["address"] for one in subnet["slaves"]]), ("profibus", [4, 5]))
        self.expect(GOOD, "network", dp, "--svg", "dp.svg")
        texts = [one.text for one in xml.etree.ElementTree.fromstring(self.read("dp.svg")).iter("{http://www.w3.org/2000/svg}text")]
        self.assertLessEqual({"PROFIBUS(1)", "Valves", "Remote", "ET 200M"}, set(texts))
        self.assertIn("1 station\n", self.expect(GOOD, "network", "lab/press").out)
        self.expect(UNREADABLE, "network", "nowhere")

    def wrong(self, what, *changes):
        text = CABLE
        for old, new in changes:
            self.assertIn(old, text)
            text = text.replace(old, new, 1)
        self.lab(text)
        self.assertIn(what, self.expect(PROBLEMS, "check", "lab").err)

    def test_a_good_cable(self):
        # S7-NET-09, S7-NET-11, S7-HW-11: a repeater couples a grounded and an ungrounded segment
        self.lab(CABLE)
        self.expect(GOOD, "check", "lab")

    def test_32_nodes_in_a_segment(self):
        # S7-NET-08, S7-NET-09
        def many(first, cables):
            names = [f"S{i}" for i in range(33)]
            stations = "".join(f'[[station]]\nname = "{name}"\nfolder = "press"\n' for name in names)
            nodes = ", ".join(f'{{station = "{name}", address = {i + 2}}}' for i, name in enumerate(names))
            rows = []
            for cable in cables:
                places = [names[i] if isinstance(i, int) else i for i in cable]
                rows.append(f"{{nodes = {places}, terminated = ['{places[0]}', '{places[-1]}']}}".replace("'", '"'))
            return f'{stations}[[subnet]]\nkind = "mpi"\nhighest = 63\nnodes = [{nodes}]\n{first}segments = [{", ".join(rows)}]\n'
        self.lab(many("", [range(33)]))
        self.assertIn("'nodes' must be at most 32 with the repeaters", self.expect(PROBLEMS, "check", "lab").err)
        self.lab(many('repeaters = ["R"]\n', [[*range(31), "R"], ["R", 31, 32]]))
        self.expect(GOOD, "check", "lab")

    def test_length(self):
        # S7-NET-25
        self.wrong("lab/merker.toml:25:13: error: 'length' must be at most 1000 m at 187.5 kbit/s", ('"1000m"', '"1001m"'))
        for length in "40", "40 m", "-1m", "0m", "", "99999999999m":
            self.wrong("'length' must be a length in metres", ('"40m"', f'"{length}"'))

    def test_terminators(self):
        # S7-NET-12
        for on in '"R1"', '"Press", "R1", "Belt"', '"Press", "Belt"', "":
            self.wrong('\'terminated\' must be ["Press", "R1"]: the resistors are on at both ends', ('terminated = ["Press", "R1"]', f"terminated = [{on}]"))

    def test_grounding(self):
        # S7-NET-11
        self.wrong("'nodes' must be all grounded or all ungrounded", ('repeaters = ["R1"]\n', ""),
                   ('  {length = "40m", nodes = ["Press", "R1"], terminated = ["Press", "R1"]},\n', ""),
                   ('["R1", "Belt"], terminated = ["Belt", "R1"]', '["Press", "Belt"], terminated = ["Belt", "Press"]'))

    def test_everybody_is_connected_once(self):
        # S7-NET-08, S7-NET-09
        self.wrong("'Belt' must be in the nodes of one segment", ('["R1", "Belt"], terminated = ["Belt", "R1"]', '["R1"], terminated = ["R1"]'))
        self.wrong("'Press' must be in the nodes of one segment", ('["R1", "Belt"]', '["R1", "Press", "Belt"]'))
        self.wrong("'Mill' must be a station or a repeater of this subnet", ('["R1", "Belt"]', '["R1", "Mill", "Belt"]'))
        self.wrong("'segments' must be coupled to one tree by repeaters", ('["R1", "Belt"], terminated = ["Belt", "R1"]', '["Belt"], terminated = ["Belt"]'))
        self.wrong("'segments' must be coupled to one tree by repeaters", ('["R1"]', '["R1", "R2"]'), ('["Press", "R1"], terminated = ["Press", "R1"]', '["R2", "Press", "R1"], terminated = ["R2", "R1"]'),
                   ('["R1", "Belt"], terminated = ["Belt", "R1"]', '["R1", "Belt", "R2"], terminated = ["R1", "R2"]'))
        self.wrong("'Press' must be a name that no station", ('repeaters = ["R1"]', 'repeaters = ["R1", "Press"]'))


if __name__ == "__main__":
    unittest.main()
