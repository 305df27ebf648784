"""merker export: files of STEP 7, and that they come back (docs/formats/export.md)."""
import pathlib

from harness import GOOD, PROBLEMS, UNREADABLE, USAGE, Case

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples"
CALLER = """ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
 U "Schütz"
 CALL FC 5
  EIN := E 0.1
END_ORGANIZATION_BLOCK
"""
CALLED = """FUNCTION FC 5 : VOID
VAR_INPUT
  EIN : BOOL;
END_VAR
BEGIN
NETWORK
 U #EIN; // Größe
 = A 4.0;
END_FUNCTION
"""


class ExportStep7(Case):
    def data(self, path):
        return (self.folder / path).read_bytes()

    def plant(self):
        self.write("plant/merker.toml", '[project]\nname = "plant"\n')
        self.write("plant/a.awl", CALLER)
        self.write("plant/b.awl", CALLED)
        self.write("plant/s.sym", '"Schütz"  E 0.0  BOOL  // K1\n"Lampe"  A 4.0  BOOL\n')
        return "plant"

    def test_a_source_that_step_7_imports(self):
        self.expect(GOOD, "export", self.plant(), "-o", "p.awl")
        text = self.data("p.awl").decode("cp1252")
        self.assertEqual(text.count("\n"), text.count("\r\n"))
        self.assertLess(text.index("FUNCTION FC 5"), text.index("ORGANIZATION_BLOCK OB 1"))
        self.assertIn(" U E 0.0;\r\n CALL FC 5 (\r\n  EIN := E 0.1);\r\n", text)
        self.assertIn("// Größe", text)
        self.assertTrue(self.data("p.sdf").startswith('"Schütz   '.encode("cp1252")))
        self.expect(GOOD, "export", "plant", "-o", "q.awl", "--symbols")
        text = self.data("q.awl").decode("cp1252")
        self.assertIn('U "Schütz";', text)
        self.assertIn('= "Lampe";', text)

    def test_symbol_tables(self):
        self.plant()
        for extension in ("sdf", "asc", "dif", "seq"):
            self.expect(GOOD, "export", "plant", "-o", "t." + extension)
            folder = "back-" + extension
            self.write(f"{folder}/merker.toml", '[project]\nname = "back"\n')
            self.write(f"{folder}/x.awl", CALLER)
            self.write(f"{folder}/y.awl", CALLED)
            self.write(f"{folder}/t.{extension}", self.data(f"t.{extension}"))
            self.expect(GOOD, "export", folder, "-o", folder + ".awl", "--symbols")
            self.assertIn('= "Lampe";', self.data(folder + ".awl").decode("cp1252"))

    def test_what_the_code_page_does_not_have_is_named(self):
        self.write("p.awl", CALLED.replace("Größe", "жук"))
        err = self.expect(GOOD, "export", "p.awl", "-o", "out.awl", "--code-page", "1252").err
        self.assertIn("p.awl:7:13: warning: 'ж' is not in code page 1252 and is written as '?' (1 time)", err)
        self.assertIn(b"// ???", self.data("out.awl"))

    def test_the_code_page_is_that_of_the_characters(self):
        self.write("p.awl", CALLED.replace("Größe", "жук"))
        err = self.expect(GOOD, "export", "p.awl", "-o", "out.awl").err
        self.assertIn("out.awl: texts are in code page 1251", err)
        self.assertIn("// жук".encode("cp1251"), self.data("out.awl"))
        self.expect(GOOD, "import", "out.awl", "-o", "back")
        self.assertIn("// жук", self.data("back/out.awl").decode())

    def test_machine_code_goes_into_a_wld_file_only(self):
        self.plant()
        self.expect(GOOD, "export", "plant", "-o", "p.wld")
        self.write("code/merker.toml", '[project]\nname = "code"\n')
        self.write("code/p.mc7", self.data("p.wld"))
        self.write("code/c.awl", "FUNCTION FC 1 : VOID\nBEGIN\nCALL FC 5\nIN0 := M 1.0\nEND_FUNCTION\n")
        call = self.expect(GOOD, "export", "code", "-o", "code.awl")
        self.assertIn("FC 5 has machine code and no source: it is in code.wld", call.err)
        self.assertNotIn(b"FC 5 :", self.data("code.awl"))
        self.assertEqual(self.data("code.wld"), self.data("p.wld"))
        (self.folder / "code/c.awl").unlink()
        self.expect(GOOD, "export", "code", "-o", "code.wld", "--force")
        self.assertEqual(self.data("code.wld"), self.data("p.wld"))

    # A protected block: its declaration has names, its container has none. What calls it must compile with the container.
    def test_calls_of_machine_code_come_back(self):
        self.plant()
        self.expect(GOOD, "export", "plant", "-o", "p.wld")
        (self.folder / "plant/b.awl").write_text(CALLED.replace(" U #EIN; // Größe\n = A 4.0;\n", ""))
        protected = bytearray(self.data("p.wld"))
        protected[protected.index(b"pp\1\1\1\x0c") + 15] = 3
        self.write("plant/FC5.mc7", bytes(protected[protected.index(b"pp\1\1\1\x0c"):]))
        self.expect(GOOD, "check", "plant")
        (self.folder / "x").mkdir()
        for option in ([], ["--symbols"]):
            with self.subTest(option=option):
                err = self.expect(GOOD, "export", "plant", "-o", "x/x.awl", "--force", *option).err
                self.assertIn("calls of these blocks use IN0, OUT0 ...", err)
                self.assertIn(b"IN0 := E 0.1", self.data("x/x.awl"))
                self.expect(GOOD, "export", "plant", "-o", "all.wld", "--force")
                self.assertEqual(self.again("x", "back" + "".join(option)), self.data("all.wld"))

    # SE is another instruction in each of the two; without it both could be compiled as one.
    def test_sources_in_both_mnemonics(self):
        for delay in ("L S5T#1S\nSE T 1\n", ""):
            with self.subTest(delay=delay):
                self.both_mnemonics(delay)

    def test_both_mnemonics_in_a_source(self):
        self.write("p.awl", "FUNCTION FC 1 : VOID\nBEGIN\nU E 0.0\nA I 0.0\nEND_FUNCTION\n")
        self.assertIn("the source uses both mnemonics", self.expect(GOOD, "export", "p.awl", "-o", "x.awl").err)

    def both_mnemonics(self, delay):
        self.write("p/merker.toml", '[project]\nname = "p"\n')
        self.write("p/a.awl", "FUNCTION FC 1 : VOID\nBEGIN\nU E 0.0\n" + delay + "END_FUNCTION\n")
        self.write("p/b.awl", "FUNCTION FC 2 : VOID\nBEGIN\nA I 0.0\n" + delay + "END_FUNCTION\n")
        self.assertIn("written in international ones", self.expect(GOOD, "export", "p", "-o", "x.awl", "--force").err)
        self.assertEqual(self.data("x.awl").count(b"A I 0.0;"), 2)
        self.assertEqual(self.data("x.awl").count(b"SD T 1;"), 1 if delay else 0)

    # The type of an instance follows from nothing else; that of a flag from its address.
    def test_types_that_a_format_does_not_have(self):
        self.write("p/merker.toml", '[project]\nname = "p"\n')
        self.write("p/a.sym", '"Motor data" DB 7 FB 3\n"Lamp" A 4.0 BOOL\n')
        self.write("p/a.awl", "FUNCTION_BLOCK FB 3\nBEGIN\nNETWORK\nEND_FUNCTION_BLOCK\nDATA_BLOCK DB 7\nFB 3\nBEGIN\nEND_DATA_BLOCK\n")
        err = self.expect(GOOD, "export", "p", "-o", "x.seq").err
        self.assertIn("x.seq: warning: the type of Motor data (FB 3) is lost: .seq has no types; .sdf keeps it", err)
        self.assertNotIn("Lamp", err)
        self.assertEqual(self.expect(GOOD, "export", "p", "-o", "x.sdf").err, "")

    def test_what_cannot_be_written_is_told(self):
        self.plant()
        self.assertIn("write one of .awl, .wld, .sdf, .asc, .dif, .seq",
                      self.expect(USAGE, "export", "plant", "-o", "p.s5d").err)
        self.write("p.sdf", "mine")
        self.assertIn("p.sdf already exists", self.expect(UNREADABLE, "export", "plant", "-o", "p.awl").err)
        self.assertFalse((self.folder / "p.awl").exists())
        self.assertIn("plant.awl", self.expect(GOOD, "export", "--help").out)

    # Issue: export -> import is the identity
    def test_every_example_comes_back(self):
        for project in sorted(p.parent for p in EXAMPLES.glob("*/merker.toml")):
            name = project.name
            self.expect(GOOD, "export", project, "-o", f"{name}.wld")
            machine = self.data(f"{name}.wld")
            for option in ([], ["--symbols"]):
                with self.subTest(name=name, option=option):
                    source = name + "".join(option)
                    (self.folder / source).mkdir()
                    self.assertEqual(self.expect(GOOD, "export", project, "-o", f"{source}/p.awl", *option).err, "")
                    self.assertEqual(self.again(source, source + ".back"), machine)
            with self.subTest(name=name, option="WLD"):
                self.assertEqual(self.again(f"{name}.wld", name + ".code"), machine)

    # Issue: values of a user-defined type came back where no source can have them
    def test_values_of_a_type_stay_with_the_type(self):
        self.write("t.awl", "TYPE UDT 1 STRUCT a : INT := 5; END_STRUCT END_TYPE\n"
                   "FUNCTION FC 1 : VOID VAR_INPUT i : UDT 1; END_VAR VAR_TEMP x : UDT 1; END_VAR\n"
                   "BEGIN NETWORK L #i.a; T #x.a; END_FUNCTION\n"
                   "FUNCTION_BLOCK FB 1 VAR_INPUT i : UDT 1; END_VAR VAR_IN_OUT io : UDT 1; n : INT := 6; END_VAR\n"
                   "BEGIN NETWORK L #n; L #i.a; END_FUNCTION_BLOCK\n")
        self.expect(GOOD, "export", "t.awl", "-o", "t.wld")
        self.assertEqual(self.again("t.wld", "tb"), self.data("t.wld"))
        self.expect(GOOD, "check", "tb")
        self.assertIn(":= 6", self.data("tb/FB1.awl").decode())

    # Issue: a start area of 20 bytes was put in front of the variables
    def test_short_start_information_begins_at_zero(self):
        self.write("o.awl", "ORGANIZATION_BLOCK OB 1 VAR_TEMP OB1_EV_CLASS : BYTE; x : INT; END_VAR\n"
                   "BEGIN NETWORK L #x; T MW 0; END_ORGANIZATION_BLOCK\n"
                   "ORGANIZATION_BLOCK OB 35 VAR_TEMP OB35_EV_CLASS : BYTE; s : STRUCT a : INT; END_STRUCT; END_VAR\n"
                   "BEGIN NETWORK L P##s; LAR1; L #s.a; T MW 0; END_ORGANIZATION_BLOCK\n"
                   "ORGANIZATION_BLOCK OB 100 VAR_TEMP own : INT; END_VAR\n"
                   "BEGIN NETWORK L #own; END_ORGANIZATION_BLOCK\n")
        self.expect(GOOD, "export", "o.awl", "-o", "o.wld")
        self.assertEqual(self.again("o.wld", "ob"), self.data("o.wld"))
        self.assertIn("OB1_TEMP0 : BYTE", self.data("ob/OB1.awl").decode())

    # The machine code of what an import makes of `path`.
    def again(self, path, folder):
        self.expect(GOOD, "import", path, "-o", folder)
        self.expect(GOOD, "export", folder, "-o", folder + ".wld")
        return self.data(folder + ".wld")
