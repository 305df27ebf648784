from harness import *

MODULES = """[[module]]
slot = 4
type = "6ES7 321-1BH02-0AA0"
[[module]]
slot = 5
type = "6ES7 322-1BH01-0AA0"
"""
ONE_RACK = "[project]\nname = \"Line\"\n[hardware]\n" + MODULES


class Hardware(Case):
    def project(self, settings, instructions="      NOP   0"):
        self.write("p/merker.toml", settings)
        self.write("p/main.awl", block(instructions))
        return "p"

    # S7-HWCFG-01, S7-HWCFG-02, S7-HW-31: components on racks, addresses assigned by the slot
    def test_drawing(self):
        lines = self.expect(GOOD, "hw", self.project(ONE_RACK)).lines
        self.assertEqual(lines[0], "Line: CPU 314C-2 PtP")
        self.assertIn("│ E 0.0..1.7 │ A 4.0..5.7", "\n".join(lines))
        self.assertIn("backplane bus: 90 of 1200 mA", lines)
        boxes = [line for line in lines if line and line[0] in "┌│└"]
        self.assertEqual(len({len(line) for line in boxes}), 1)

    def test_json(self):
        document = self.expect(GOOD, "hw", self.project(ONE_RACK), "--json").json
        rack = document["racks"][0]
        self.assertEqual(rack["bus_current_mA"], 90)
        module = [m for m in rack["modules"] if m["slot"] == "4"][0]
        self.assertEqual(module["inputs"], {"first": 0, "last": 1})
        self.assertIsNone(module["outputs"])
        self.assertEqual(module["order_number"], "6ES7 321-1BH02-0AA0")
        self.assertTrue(document["configured"])

    # S7-VIS-17: the sorting plant lives on one module of digital inputs and one of digital outputs
    def test_the_sorting_plant_needs_digital_modules_alone(self):
        project = pathlib.Path(__file__).resolve().parents[2] / "examples" / "sorting-plant"
        modules = self.expect(GOOD, "hw", str(project), "--json").json["racks"][0]["modules"]
        plugged = {m["name"]: m for m in modules if m["slot"] in ("4", "5")}
        self.assertEqual(len([m for m in modules if "." not in m["slot"]]), 3, modules)
        self.assertEqual(plugged["Barriers"]["inputs"], {"first": 0, "last": 1})
        self.assertEqual(plugged["Sliders"]["outputs"], {"first": 1, "last": 2})
        for name, order in (("Barriers", "6ES7 321"), ("Sliders", "6ES7 322")):
            self.assertTrue(plugged[name]["order_number"].startswith(order))

    # S7-HW-12: the CPU stands in slot 2, with and without something on board
    def test_the_cpu_is_a_module(self):
        for cpu, order in (("314C-2 PtP", "6ES7 314-6BF01-0AB0"), ("318-2", "6ES7 318-2AJ00-0AB0"), ("generic", "")):
            with self.subTest(cpu):
                power = "[[module]]\nslot = 1\ntype = \"PS 307 5A\"\n"
                document = self.expect(GOOD, "hw", self.project(power + MODULES), "--json", "--cpu", cpu).json
                modules = document["racks"][0]["modules"]
                self.assertEqual([m["slot"] for m in modules if "." not in m["slot"]], ["1", "2", "4", "5"])
                self.assertEqual(modules[1]["type"], document["cpu"])
                self.assertEqual(modules[1]["order_number"], order)

    # S7-HW-19
    def test_mounting(self):
        self.assertIn("0 to 60 °C", self.expect(GOOD, "hw", self.project("[hardware]\n")).out)
        vertical = self.project("[hardware]\nmounting = \"vertical\"\n")
        self.assertIn("0 to 40 °C", self.expect(GOOD, "hw", vertical).out)

    # S7-CPU-23: 85 % of the work memory
    def test_no_expansion_reserve(self):
        self.project("[hardware]\n")
        self.assertNotIn("reserve", self.expect(GOOD, "hw", "p").out)
        for number in (1, 2, 3):
            self.write(f"p/data{number}.awl", f"DATA_BLOCK DB {number}\nSTRUCT\n  a : ARRAY [1..14000] OF BYTE;\n"
                       "END_STRUCT\nBEGIN\nEND_DATA_BLOCK\n")
        self.assertRegex(self.expect(GOOD, "hw", "p").out, r"work memory +420\d\d of +49152 bytes +85 %  no expansion")

    # S7-HW-01, S7-HW-05, S7-HW-06, S7-HW-08, S7-HW-09
    def test_catalogue(self):
        out = self.expect(GOOD, "hw", "--catalogue").out
        for name in ("PS 307", "IM 360", "SM 321", "SM 322", "SM 323", "SM 331", "SM 332", "SM 334", "SM 338", "FM 351",
                     "CP 342-5"):
            self.assertIn(name, out)
        self.assertIn("address space only", out)

    # S7-HWCFG-07: a problem names slot and cause, the line stands below it
    def test_problem_with_its_line(self):
        call = self.expect(PROBLEMS, "check", self.project("[[module]]\nslot = 4\ntype = \"PS 307 5A\"\n"))
        self.assertIn("p/merker.toml:2:8: error: PS 307 5A cannot be plugged into slot 4; a power supply must be in slot 1",
                      call.err)
        self.assertIn("slot = 4\n       ^", call.err)

    # S7-OPEN-32: three settings
    # S7-MGR-06: an address is accepted if a module is behind it
    def test_addresses_without_module(self):
        program = "      U     E 8.0\n      =     A 4.0\n      L     PEW 300\n      T     MW 0"
        for setting, code, words in (("standard", PROBLEMS, ("warning: E 8.0", "error: PEW 300")),
                                     ("warning", GOOD, ("warning: E 8.0", "warning: PEW 300")),
                                     ("error", PROBLEMS, ("error: E 8.0", "error: PEW 300")),
                                     ("off", GOOD, ())):
            with self.subTest(setting):
                project = self.project(f"[hardware]\ncheck_addresses = \"{setting}\"\n" + MODULES, program)
                call = self.expect(code, "check", project)
                for word in words:
                    self.assertIn(word, call.err)
                self.assertNotIn("A 4.0", call.err)

    # S7-HW-29: with its address the module moves to another slot and the program behaves the same
    def test_a_moved_module_keeps_its_address(self):
        for slot in (4, 5):
            filler = "[[module]]\nslot = 4\ntype = \"SM 338\"\n" if slot == 5 else ""
            project = self.project(f"{filler}[[module]]\nslot = {slot}\ntype = \"SM 323 DI8/DO8xDC24V/0.5A\"\n"
                                   "input = 0\noutput = 0\n", "      U     E 0.3\n      =     A 0.5")
            out = self.expect(GOOD, "run", project, "--cycles", "3", "--set", "E 0.3 = 1", "--print", "A 0.5").out
            self.assertEqual(out, "A 0.5 = 1\n")

    # S7-HW-02, S7-CPU-21: another CPU, other limits
    def test_the_cpu_decides_what_a_program_may_be(self):
        project = self.project("", "      L     S5T#1S\n      SE    T 64\n      U     Z 32")
        self.expect(GOOD, "check", project)
        call = self.expect(PROBLEMS, "check", project, "--cpu", "312 IFM")
        self.assertIn("64 is outside 0..63 of CPU 312 IFM", call.err)
        self.assertIn("32 is outside 0..31 of CPU 312 IFM", call.err)

    def test_models_bring_their_own_io(self):
        project = self.project("[hardware]\n")
        self.assertIn("DI10/DO6", self.expect(GOOD, "hw", project, "--cpu", "312C").out)
        self.assertIn("E 136.0..138.7", self.expect(GOOD, "hw", project, "--cpu", "314C-2 PN/DP").out)
        self.assertNotIn("2.2", self.expect(GOOD, "hw", project, "--cpu", "318-2").out)


if __name__ == "__main__":
    unittest.main()
