import xml.etree.ElementTree

from harness import *

PROJECT = """[cpu]
model = "314C-2 PtP"

[[module]]
slot = "2.2"
name = "Panel"
output = 0

[[plant]]
name = "Oven"
kind = "temperature"
first_time_constant = "1s"
second_time_constant = "0.1s"

[plant.wire]
HEAT = "Panel.DO0"
"""


class Plot(Case):
    def setUp(self):
        super().setUp()
        self.write("merker.toml", PROJECT)
        self.write("a.awl", block("      SET\n      =     A 0.0\n      L     MW 10\n      +     1\n      T     MW 10"))

    def traced(self, *watched):
        self.expect(GOOD, "run", ".", "--for", "2s", "--trace", "t.csv", "--watch", ", ".join(watched))
        return [line.split(",") for line in self.read("t.csv").splitlines()]

    def plot(self, *options):
        """The picture's texts."""
        self.expect(GOOD, "plot", "t.csv", "-o", "t.svg", *options)
        return [element.text for element in xml.etree.ElementTree.fromstring(self.read("t.svg")).iter()
                if element.tag.endswith("text")]

    # PID-SIM-09
    def test_signals_of_plants_are_recorded(self):
        rows = self.traced("plant Oven.PV", "A 0.0", "plant oven.heat")
        self.assertEqual(rows[0], ["0.0000000", "plant Oven.PV", "20"])
        self.assertEqual(rows[1], ["0.0000000", "plant oven.heat", "0"])
        values = [float(value) for _, name, value in rows if name == "plant Oven.PV"]
        self.assertEqual(values, sorted(values))
        self.assertGreater(values[-1], 250)  # 20 + 300 (1 - e^-2) less the second lag
        self.assertLess(values[-1], 280)
        self.assertIn("1", [value for _, name, value in rows if name == "plant oven.heat"])

    def test_a_row_for_each_operand_or_rows_with_names(self):
        self.traced("plant Oven.PV", "A 0.0", "MW 10")
        texts = self.plot()
        self.assertLess(texts.index("plant Oven.PV"), texts.index("A 0.0"))
        self.assertIn("300", texts)
        texts = self.plot("--title", "a < b", "--row", "plant Oven.PV = temperature", "--row", "a 0.0 = heating",
                          "--from", "0.5s", "--to", "1s")
        self.assertEqual([texts[0], texts[-1]], ["a < b", "t / s"])
        self.assertTrue({"temperature", "heating", "0.5", "1"} <= set(texts))
        self.assertNotIn("MW 10", texts)
        self.assertNotIn("1.5", texts)

    def test_the_same_trace_gives_the_same_picture(self):
        self.traced("plant Oven.PV")
        self.plot()
        first = self.read("t.svg")
        self.plot()
        self.assertEqual(self.read("t.svg"), first)

    def test_what_is_wrong_is_said(self):
        self.traced("A 0.0")
        call = self.expect(PROBLEMS, "plot", "t.csv", "-o", "t.svg", "--row", "MW 10")
        self.assertRegex(call.err, r"'?MW 10'?.*A 0\.0.*\[P0991\]")
        self.expect(USAGE, "plot", "t.csv", "-o", "t.svg", "--from", "soon")
        self.assertIn("--from must be before --to", self.expect(USAGE, "plot", "t.csv", "-o", "t.svg", "--from", "9s").err)
        self.expect(UNREADABLE, "plot", "none.csv", "-o", "t.svg")
        self.expect(UNREADABLE, "plot", "t.csv", "-o", "none/t.svg")
        trace = self.read("t.csv")
        for output in ("t.csv", "t.png"):
            self.assertIn("-o FILE.svg", self.expect(USAGE, "plot", "t.csv", "-o", output).err)
        self.assertEqual(self.read("t.csv"), trace)
        for times in ("nan,A 0.0,1\n", "2.0,A 0.0,1\n1.0,A 0.0,0\n"):
            self.write("back.csv", times)
            self.assertIn("[P0990]", self.expect(PROBLEMS, "plot", "back.csv", "-o", "t.svg").err)
        self.write("bad.csv", "1.0,A 0.0,1\nhello\n")
        self.assertRegex(self.expect(PROBLEMS, "plot", "bad.csv", "-o", "t.svg").err, r"bad\.csv:2:1: error: .*\[P0990\]")
        for watched, code in (("plant Stove.PV", "P0986"), ("plant Oven.XY", "P0762"), ("plant Oven", "P0952")):
            call = self.expect(USAGE, "run", ".", "--for", "1s", "--trace", "t.csv", "--watch", f"A 0.0, {watched}")
            self.assertRegex(call.err, rf"--watch:1:8: error: .*\[{code}\]")
