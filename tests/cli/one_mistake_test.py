"""A mistake in merker.toml is one problem: nothing is said of what only follows from it."""
import pathlib
import shutil

from harness import *

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples" / "networks"
SECOND_SUBNET = '\n[[subnet]]\nname = "DP(2)"\nkind = "profibus"\nnodes = [ {station = "Warehouse", address = 2, master = true} ]\n'


class OneMistake(Case):
    # The example with `old` replaced in one of its files; what it has to say.
    # `models`: CPUs of stations that are no part of the mistake.
    def mistake(self, example, old, new, file="merker.toml", models=()):
        folder = self.folder / example
        shutil.copytree(EXAMPLES / example, folder, dirs_exist_ok=True)
        text = (EXAMPLES / example / file).read_text(encoding="utf-8")
        self.assertIn(old, text)
        (folder / file).write_text(text.replace(old, new), encoding="utf-8")
        for station, model in models:
            text = (folder / station / "merker.toml").read_text(encoding="utf-8")
            (folder / station / "merker.toml").write_text(text.replace("314C-2 PtP", model), encoding="utf-8")
        err = self.expect(PROBLEMS, "check", example).err
        self.assertEqual(err.count(": error: ") + err.count(": warning: "), 1, err)
        return err

    def test_the_examples_are_good(self):
        for example in "production-line", "positioning-drive":
            self.expect(GOOD, "check", EXAMPLES / example)

    def test_kinds(self):
        for kind in "valve", "speed drive", "sorting plant":
            self.assertIn("plant kind 'vavle' not found", self.mistake("production-line", f'kind = "{kind}"', 'kind = "vavle"'))
        self.assertIn("'station' must be the name of a [[station]]: Desk", self.mistake(
            "production-line", 'kind = "speed drive"\nstation = "Belt"', 'kind = "speed drive"\nstation = "Bel"'))
        self.assertIn("'kind' must be one of", self.mistake("production-line", 'kind = "profibus"', 'kind = "profibuz"'))
        self.assertIn("'kind' must be \"profibus\": a project of one station",
                      self.mistake("positioning-drive", 'kind = "profibus"', 'kind = "profibuz"'))
        self.assertIn("needs kind", self.mistake("positioning-drive", 'kind = "profibus"\n', ""))

    def test_slaves(self):
        drive = 'type = "Standard telegram 9"'
        self.assertIn("'type' must be the telegram of the drive", self.mistake("positioning-drive", drive, 'type = "Standard telegram 7"'))
        self.assertIn("unknown key 'telegram'", self.mistake("positioning-drive", drive, "telegram = 7"))
        self.assertIn("'type' must be the telegram of the drive", self.mistake("positioning-drive", drive, "type = 7"))
        self.assertIn("unknown key 'module'", self.mistake("positioning-drive", "modules =", "module ="))
        self.assertIn("'type' must be one of", self.mistake("positioning-drive", '"PROFIdrive"', '"PROFIdriv"'))
        self.assertIn("unknown key 'typ'", self.mistake("production-line", 'type = "Standard telegram 1"', 'typ = "Standard telegram 1"'))
        self.assertIn("'address' must be", self.mistake("positioning-drive", "address = 6", "address = 0"))

    def test_a_second_subnet(self):
        end = 'SLIDER_SMALL = "Sorter/Sliders.DO0"\n'
        err = self.mistake("production-line", end, end + SECOND_SUBNET, models=[("warehouse", "314C-2 DP")])
        self.assertIn("'[[slave]]' needs subnet = \"PROFIBUS(1)\": there are several PROFIBUS subnets", err)

    def test_a_station_that_cannot_be_read(self):
        self.assertIn("belt/merker.toml:5:9: error: ", self.mistake("production-line", "model =", "model = =", "belt/merker.toml"))
        self.assertIn("CPU model '314C-2 D' not found", self.mistake("production-line", "314C-2 DP", "314C-2 D", "belt/merker.toml"))
        self.assertIn("unknown key 'modl'", self.mistake("production-line", "slot = 4", "slot = 4\nmodl = 1", "sorter/merker.toml"))

    # The same of its folder alone.
    def test_a_project_that_cannot_be_read(self):
        for text, what in ("[cpu]\nmodel = = 1\n", "merker.toml:2:9: error: "), ('[cpu]\nmodel = "314C-2 D"\n', "CPU model '314C-2 D' not found"):
            self.write("p/merker.toml", text)
            self.write("p/main.awl", block("      L     PEW 700") + block("      NOP   0", 86))
            err = self.expect(PROBLEMS, "check", "p").err
            self.assertIn(what, err)
            self.assertEqual(err.count(": error: "), 1, err)

    # A mistake of the program is one of its own.
    def test_two_mistakes(self):
        self.write("p/merker.toml", "[cpu]\nmodel = = 1\n")
        self.write("p/main.awl", block("      L     MV 700"))
        self.assertEqual(self.expect(PROBLEMS, "check", "p").err.count(": error: "), 2)


if __name__ == "__main__":
    unittest.main()
