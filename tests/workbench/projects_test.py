import os
import pathlib
import subprocess
import unittest

from served import Served

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Projects(Served):
    command = "workbench"

    def target(self):
        return []

    def prepare(self):
        super().prepare()
        self.workspace = self.folder / "work"
        self.arguments = ("--workspace", str(self.workspace), "--examples", str(ROOT / "examples"))

    def test_without_a_path_it_begins_with_the_list(self):
        browser = self.browser()
        browser.until(lambda b: "project" in b.state)
        self.assertIsNone(browser.state["project"])
        self.assertEqual(browser.problems("cpu.stop"), ["P1315"])
        listed = browser.call("projects.list")
        titles = {row["id"]: row["title"] for row in listed["examples"]}
        self.assertEqual(titles["sorting-plant"], "The sorting plant")
        self.assertIn("314C-2 PtP", listed["models"])

    def test_an_example_is_a_copy(self):
        browser = self.browser()
        browser.call("projects.open", example="sorting-plant")
        browser.until(lambda b: b.state.get("mode") == "RUN" and b.state["project"]["example"])
        files = {row["path"] for row in browser.call("files.list")["files"]}
        self.assertIn("merker.toml", files)
        self.assertTrue((self.workspace / "sorting-plant" / "merker.toml").is_file())
        browser.call("projects.close")
        browser.until(lambda b: b.state["project"] is None)
        browser.call("projects.open", folder="sorting-plant")
        browser.until(lambda b: b.state["project"] is not None)

    def test_a_copy_of_the_open_project_and_the_way_back_to_an_untouched_example(self):
        browser = self.browser()
        browser.call("projects.open", example="sorting-plant")
        browser.until(lambda b: b.state.get("project"))
        settings = self.workspace / "sorting-plant" / "merker.toml"
        (self.workspace / "sorting-plant" / "old.bak").write_text("x")
        settings.write_text(settings.read_text() + "# mine\n")
        made = browser.call("projects.copy", name="Second one")
        self.assertEqual(made["left"], ["old.bak"])
        copy = self.workspace / "Second one"
        self.assertEqual(made["folder"], str(copy))
        self.assertTrue((copy / "merker.toml").read_text().endswith("# mine\n"))
        self.assertEqual(made["files"], sum(1 for path in copy.rglob("*") if path.is_file()))
        self.assertEqual(browser.problems("projects.copy", name="Second one"), ["P1312"])
        self.assertEqual(browser.problems("projects.copy", name="../out"), ["P1317"])
        browser.call("projects.open", example="sorting-plant", fresh=True)
        browser.until(lambda b: b.state["project"]["folder"].endswith("sorting-plant 2"))
        self.assertFalse((self.workspace / "sorting-plant 2" / "merker.toml").read_text().endswith("# mine\n"))
        listed = browser.call("projects.list")
        self.assertEqual([name for name in listed["projects"] if name.startswith("s")], ["sorting-plant", "sorting-plant 2"])
        self.assertIn("Second one", listed["projects"])
        self.assertTrue(next(row for row in listed["examples"] if row["id"] == "sorting-plant")["copied"])

    def test_each_browser_knows_how_many_there_are(self):
        browser = self.browser()
        browser.until(lambda b: b.state.get("browsers") == 1)
        other = self.browser()
        browser.until(lambda b: b.state["browsers"] == 2)
        other.close()
        browser.until(lambda b: b.state["browsers"] == 1)

    def test_the_wizard_makes_a_project_whose_cpu_waits_for_its_program(self):
        """S7-MGR-01; S7-SIM-08, -09: a new CPU is empty and in STOP until somebody loads and turns its switch."""
        browser = self.browser()
        browser.call("projects.new", name="First one", model="313C", template="errors", mnemonics="international", ob="OB 35")
        browser.until(lambda b: (b.state.get("project") or {}).get("name") == "First one")
        self.assertEqual((browser.state["mode"], browser.state["switch"]), ("STOP", "STOP"))
        self.assertTrue(browser.state["project"]["empty"])
        self.assertEqual(browser.state["project"]["changed"], ["main.awl", "symbols.sym"])
        self.assertEqual(browser.call("program.blocks", side="online")["blocks"], [])
        browser.call("program.load")
        browser.until(lambda b: not b.state["project"]["empty"] and not b.state["project"]["changed"])
        self.assertEqual(browser.state["mode"], "STOP")
        browser.call("cpu.switch", position="RUN-P")
        browser.until(lambda b: b.state.get("mode") == "RUN")
        self.assertEqual(browser.state["project"]["model"], "CPU 313C")
        blocks = {row["id"] for row in browser.call("program.blocks", side="online")["blocks"]}
        self.assertLessEqual({"OB 1", "OB 35", "OB 100", "OB 121"}, blocks)
        self.assertEqual(browser.problems("projects.new", name="First one", model="313C"), ["P1312"])
        browser.call("projects.new", name="Übung 1 - Größe", model="313C")
        for name in ("", "../x", "a/b", ".x", "x" * 65, " x", "a\u202eb", "a\u00d7b", "a\u2028"):
            self.assertEqual(browser.problems("projects.new", name=name, model="313C"), ["P1317"], name)
        self.assertEqual(browser.problems("projects.new", name="x", model="999"), ["P0705"])

    def test_german_copies_of_examples_are_right_and_pass_their_scenarios(self):
        """What they must say is looked at by tests/documents/german.py; here, that they still run."""
        browser = self.browser()
        listed = [row["id"] for row in browser.call("projects.list")["examples"]]
        self.assertGreater(len(listed), 50)
        for example in listed:
            browser.call("projects.open", example=example, language="german")
            self.assertEqual(browser.call("program.check")["problems"], [], example)
        left = [path for path in self.workspace.rglob("*") if path.name == "german.txt"]
        self.assertEqual(left, [])
        text = (self.workspace / "sorting-plant" / "sorting.awl").read_text()
        self.assertIn("TITLE = Welche Größe war es?", text)
        self.assertNotIn("\"Slider", text)
        tested = subprocess.run([os.environ["MERKER"], "test", str(self.workspace), "-j", "2"], capture_output=True, text=True)
        self.assertEqual(tested.returncode, 0, tested.stdout + tested.stderr)

    def test_stations_of_a_pair_are_copied_together(self):
        browser = self.browser()
        browser.call("projects.open", example="technology/two-stations/filling")
        browser.until(lambda b: b.state.get("mode") == "RUN")
        pair = self.workspace / "technology-two-stations"
        self.assertEqual(browser.state["project"]["folder"], str(pair / "filling"))
        self.assertTrue((pair / "store" / "merker.toml").is_file())
        browser.call("projects.open", example="technology/two-stations/filling", fresh=True)
        browser.until(lambda b: b.state["project"]["folder"] == str(self.workspace / "technology-two-stations 2" / "filling"))

    def test_several_projects_have_a_plc_each(self):
        one, other = self.browser(), self.browser()
        one.call("projects.open", example="lift")
        one.until(lambda b: b.state.get("mode") == "RUN")
        other.call("plcs.enter", plc=2)
        other.until(lambda b: b.state["plcs"]["here"] == 2 and b.state["project"] is None)
        self.assertEqual(other.problems("projects.open", example="lift"), ["P1308"])
        other.call("projects.open", example="garage-door")
        other.until(lambda b: b.state.get("mode") == "RUN")
        one.until(lambda b: b.state["plcs"]["count"] == 2)
        self.assertEqual(one.state["project"]["name"], "Lift")
        other.call("cpu.stop")
        other.until(lambda b: b.state["mode"] == "STOP")
        rows = one.call("plcs.list")["plcs"]
        self.assertEqual([(row["project"], row["mode"], row["browsers"]) for row in rows],
                         [("Lift", "RUN", 1), ("Garage door", "STOP", 1), ("", "", 0), ("", "", 0)])
        time = one.state["time"]
        one.until(lambda b: b.state["time"] > time)
        self.assertEqual(one.problems("plcs.enter", plc=5), ["P1305"])

    def test_no_folder_outside_is_opened(self):
        browser = self.browser()
        for folder in ("/etc", "..", "../plant", str(self.project), str(ROOT / "examples" / "sorting-plant"), "\0", ""):
            self.assertEqual(browser.problems("projects.open", folder=folder), ["P1318"], folder)
        self.workspace.mkdir(exist_ok=True)
        os.symlink(self.project, self.workspace / "way")
        self.assertEqual(browser.problems("projects.open", folder="way"), ["P1318"])
        self.assertEqual(browser.problems("projects.open", example="../../plant"), ["P1316"])
        self.assertEqual(browser.problems("projects.open", folder="none"), ["P0101"])


class Relative(Served):
    command = "workbench"
    arguments = ("--workspace", "work/x")

    def target(self):
        return []

    def test_what_is_made_in_a_relative_workspace_is_opened_by_its_path(self):
        """A SINUMERIK takes no single blocks: loading opens the project again."""
        browser = self.browser()
        for model in ("SINUMERIK 810 GA3", "313C"):
            browser.call("projects.new", name=model, model=model)
            browser.until(lambda b: (b.state.get("project") or {}).get("name") == model)
            folder = browser.state["project"]["folder"]
            browser.call("projects.open", folder=folder)
            self.assertEqual(folder, str((self.folder / "work" / "x" / model).resolve()))


class Linked(Served):
    command = "workbench"
    arguments = ("--workspace", "link")

    def target(self):
        return ["link/given"]

    def prepare(self):
        (self.folder / "real" / "given").mkdir(parents=True)
        (self.folder / "real" / "given" / "merker.toml").write_text('[project]\nname = "Given"\n', encoding="utf-8")
        os.symlink(self.folder / "real", self.folder / "link")

    def test_a_folder_behind_a_link_is_listed_once(self):
        browser = self.browser()
        browser.until(lambda b: (b.state.get("project") or {}).get("name") == "Given")
        browser.call("projects.new", name="Made", model="313C")
        browser.until(lambda b: (b.state.get("project") or {}).get("name") == "Made")
        browser.call("projects.open", folder="Made")
        browser.call("projects.open", folder="given")
        listed = browser.call("projects.list")
        real = (self.folder / "real").resolve()
        self.assertEqual(listed["folder"], str(real))
        self.assertEqual(sorted(listed["projects"]), ["Made", "given"])
        self.assertEqual(sorted(listed["recent"]), [str(real / "Made"), str(real / "given")])


LISTING = "OB 1\nNETZWERK 1\n : U    E 0.0\n : =    A 0.0\n : BE\n"
DATA = "DB 10\n   0 : KF = +1\n"


class Listing(Served):
    command = "workbench"

    def prepare(self):
        self.project.mkdir()
        (self.project / "merker.toml").write_text(
            '[project]\nname = "Plant"\n\n[cpu]\nmodel = "SINUMERIK 810 GA3"\n', encoding="utf-8")
        (self.project / "main.s5").write_text(LISTING + DATA, encoding="utf-8")

    def states(self, browser):
        return {row["id"]: (row["state"], row["where"]) for row in browser.call("program.compare")["blocks"]}

    def test_blocks_of_project_and_plc_are_compared_with_their_sources(self):
        browser = self.browser()
        browser.until(lambda b: b.state.get("mode") == "RUN")
        self.assertEqual(self.states(browser), {"OB 1": ("same", ""), "DB 10": ("same", "")})
        read = browser.call("files.read", path="main.s5")
        changed = LISTING.replace(" : =", " : UN   E 0.1\n : =") + DATA.replace("+1", "+2") + "PB 7\n : BE\n"
        browser.call("files.write", path="main.s5", text=changed, revision=read["revision"])
        self.assertEqual(self.states(browser), {"OB 1": ("different", "code from word 1"), "DB 10": ("different", "values"),
                                                "PB 7": ("onlyOffline", "")})
        sources = [{block["id"]: block["source"] for block in browser.call("projects.look", side=side)["blocks"]}
                   for side in ("online", "offline")]
        self.assertEqual(sources[0], {"OB 1": LISTING, "DB 10": DATA})
        self.assertEqual(sources[1]["OB 1"], LISTING.replace(" : =", " : UN   E 0.1\n : ="))
        self.assertEqual(sources[1]["PB 7"], "PB 7\n : BE\n")


class Given(Served):
    command = "workbench"

    def test_a_project_with_errors_is_opened_and_mended(self):
        browser = self.browser()
        browser.until(lambda b: b.state.get("mode") == "RUN")
        read = browser.call("files.read", path="main.awl")
        broken = browser.call("files.write", path="main.awl", text="FUNCTION FC 1\n", revision=read["revision"])
        self.assertEqual(browser.ask("program.load")["problems"][0]["file"], "main.awl")
        browser.call("projects.open", folder=browser.state["project"]["folder"])
        browser.until(lambda b: b.state.get("mode") == "STOP")
        browser.call("files.write", path="main.awl", text=read["text"], revision=broken["revision"])
        browser.call("program.load")
        browser.call("cpu.start", kind="warm")
        browser.until(lambda b: b.state.get("mode") == "RUN")


if __name__ == "__main__":
    unittest.main()
