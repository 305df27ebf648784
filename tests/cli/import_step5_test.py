"""merker import of program files of STEP 5 (docs/formats/s5d.md)."""
import zipfile

from harness import *

LISTING = """OB 1
NETZWERK 1 Größe
 U -START ! Taster
 SPB FB 7
NAME : VENTIL
EIN : E 2.0
 BE
FB 7 VENTIL
BEZ : EIN E BI
M9 : U =EIN
 = A 3.0
 SPB =M9
 BE
DB 10
 0: KF +5 ! Zahl
 1: KS 'HALLO'
"""


class ImportStep5(Case):
    def setUp(self):
        super().setUp()
        self.write("p.s5", LISTING)
        self.write("pZ0.SEQ", "\tE 1.0\tSTART\tTür\r\n\tFB 7\tVENTIL7\r\n".encode("cp437"))
        self.write("old/readme.txt", "1994")
        self.expect(GOOD, "export", "p.s5", "-o", "old/PUMPE@ST.S5D")

    def code(self, path):
        return [block["code"] for block in self.expect(GOOD, "list", path, "--code", "--json").json["blocks"]]

    def test_a_program_comes_in_as_it_went_out(self):
        out = self.expect(GOOD, "import", "old", "-o", "new").out
        self.assertIn("3 blocks of STEP 5 as listings, with 3 comments and titles", out)
        self.assertIn("2 symbols", out)
        self.assertTrue((self.folder / "new/import-report.txt").is_file())
        self.expect(GOOD, "check", "new")
        self.assertEqual(self.code("new"), self.code("p.s5"))
        text = (self.folder / "new/OB1.s5").read_text(encoding="utf-8")
        self.assertIn("NETZWERK 1 Größe", text)
        self.assertIn("U     -START", text)
        self.assertIn("KS 'HALLO '", (self.folder / "new/DB10.s5").read_text(encoding="utf-8"))
        self.expect(GOOD, "run", "new", "--for", "1s")
        self.expect(GOOD, "export", "new", "-o", "PUMPE@ST.S5D")
        first, second = ((self.folder / name).read_bytes() for name in ("old/PUMPE@ST.S5D", "PUMPE@ST.S5D"))
        self.assertEqual(first, second)

    def test_a_zip_with_two_programs(self):
        data = (self.folder / "old/PUMPE@ST.S5D").read_bytes()
        with zipfile.ZipFile(self.folder / "plant.zip", "w") as plant:
            plant.writestr("a/PUMPE@ST.S5D", data)
            plant.writestr("a/pumpe@z0.seq", b"  E 1.0     START     Taster\r\n")
            plant.writestr("b/BAND@@ST.S5D", data)
            plant.writestr("b/BAND@@Z0.INI", b"\0\1")
        out = self.expect(PROBLEMS, "import", "plant.zip").out
        self.assertIn("BAND@@Z0.INI: the compiled assignment list; it is not read", out)
        self.assertIn("-START", (self.folder / "plant/PUMPE/OB1.s5").read_text(encoding="utf-8"))
        self.assertIn("E 1.0", (self.folder / "plant/BAND/OB1.s5").read_text(encoding="utf-8"))
        self.expect(GOOD, "check", "plant/PUMPE")
        self.expect(GOOD, "import", "plant.zip", "-o", "one", "--program", "pumpe")
        self.assertTrue((self.folder / "one/OB1.s5").is_file())

    def test_damage_and_deleted_blocks_are_reported(self):
        data = bytearray((self.folder / "old/PUMPE@ST.S5D").read_bytes())
        at = data.index(b"pp\x10\x01")
        data[at + 2 * (data[at + 8] * 256 + data[at + 9]) - 2] = 0
        section = data.index(b"PUMPE@ST", 128) - 8
        data[section + 22] -= 2  # DB 10 and DK 10
        (self.folder / "old/PUMPE@ST.S5D").write_bytes(data)
        out = self.expect(PROBLEMS, "import", "old", "-o", "new").out
        self.assertIn("OB 1: it does not end with BE", out)
        self.assertIn("DB 10: a deleted version of it was found; it is in deleted/DB10.s5.txt", out)
        self.assertIn("KH", (self.folder / "new/deleted/DB10.s5.txt").read_text(encoding="utf-8"))
        self.assertFalse((self.folder / "new/OB1.s5").exists())

    def test_the_code_page(self):
        self.write("q.s5", "PB 1\n BE ! 5 × 5\n")
        self.expect(GOOD, "export", "q.s5", "-o", "QST.S5D", "--code-page", "850")
        self.expect(GOOD, "import", "QST.S5D", "-o", "q", "--code-page", "850")
        self.assertIn("5 × 5", (self.folder / "q/PB1.s5").read_text(encoding="utf-8"))

    def test_a_single_file_has_its_assignment_list_beside_it(self):
        for name in ("PUMPE@Z0.SEQ", "Pumpe@z0.seq"):
            for file in (self.folder / "old").glob("*.[sS][eE][qQ]"):
                file.unlink()
            self.write("old/" + name, "\tE 1.0\tTÜR\r\n".encode("cp437"))
            self.write("old/ANDERSZ0.SEQ", "\tE 1.0\tANDERS\r\n")
            self.write("old/below/PUMPE@Z0.INI", "")
            out = self.expect(GOOD, "import", "old/PUMPE@ST.S5D", "-o", "of" + name).out
            self.assertIn("1 symbol", out)
            self.assertIn("-TÜR", self.read("of" + name + "/OB1.s5"))
        (self.folder / "PUMPE@ST.S5D").write_bytes((self.folder / "old/PUMPE@ST.S5D").read_bytes())
        out = self.expect(GOOD, "import", "PUMPE@ST.S5D", "-o", "alone").out
        self.assertIn("there is no assignment list", out)
        self.write("PUMPE@Z0.SEQ", "\tE 1.0\tHIER\r\n")
        self.expect(GOOD, "import", "PUMPE@ST.S5D", "-o", "here")
        self.assertIn("-HIER", self.read("here/OB1.s5"))

    def test_a_damaged_first_record_costs_no_block(self):
        data = (self.folder / "old/PUMPE@ST.S5D").read_bytes()
        for length in (16, 128):
            for fill in (0xFF, 0x00, 0x01, 0x20):
                name = f"D{length}X{fill}ST.S5D"
                (self.folder / name).write_bytes(bytes([fill]) * length + data[length:])
                out = self.expect(GOOD, "import", name, "-o", name + ".d").out
                self.assertIn("3 blocks of STEP 5 as listings", out)
                self.assertEqual(self.code(name + ".d"), self.code("p.s5"))

    def test_an_assignment_list_is_in_the_code_page_of_its_program(self):
        self.write("old/PUMPE@Z0.SEQ", b"\tE 1.0\tT\xdcR\r\n")
        self.expect(GOOD, "import", "old", "-o", "new")
        self.assertIn("T▄R", self.read("new/symbols.sym"))


class ImportListings(Case):
    def code(self, path):
        return [block["code"] for block in self.expect(GOOD, "list", path, "--code", "--json").json["blocks"]]

    def setUp(self):
        super().setUp()
        self.write("p.s5", LISTING)
        self.write("pZ0.SEQ", "\tE 1.0\tSTART\tTür\r\n".encode("cp437"))

    def test_a_listing_is_imported_as_it_was_exported(self):
        for flags in ((), ("--symbols",)):
            name = f"l{len(flags)}"
            self.expect(GOOD, "export", "p.s5", "-o", name + ".s5", *flags)
            self.expect(GOOD, "import", name + ".s5", "-o", name)
            self.expect(GOOD, "check", name)
            self.assertEqual(self.code(name), self.code("p.s5"))
            self.assertIn("SINUMERIK", self.read(name + "/merker.toml"))
            self.assertEqual((self.folder / name / (name + "Z0.seq")).is_file(), bool(flags))

    def test_an_export_with_symbols_has_its_list(self):
        self.expect(GOOD, "export", "p.s5", "-o", "out.s5", "--symbols")
        self.assertIn("-START", self.read("out.s5"))
        self.assertIn(b"\tE 1.0\tSTART", (self.folder / "outZ0.SEQ").read_bytes())
        self.expect(GOOD, "check", "out.s5")
        self.expect(GOOD, "export", "p.s5", "-o", "plain.s5")
        self.assertFalse((self.folder / "plainZ0.SEQ").exists())

    def test_a_folder_of_listings_and_a_list_alone(self):
        self.write("in/p.s5", LISTING)
        self.write("in/pZ0.SEQ", "  E 1.0     START     Taster\r\n")
        self.write("in/p.scn", "at 1s stop\n")
        out = self.expect(GOOD, "import", "in", "-o", "new").out
        for name in ("p.s5", "pZ0.seq", "p.scn"):
            self.assertIn(f"{name} is copied as it is", out)
        self.assertEqual(self.code("new"), self.code("p.s5"))
        self.expect(GOOD, "import", "pZ0.SEQ", "-o", "list")
        self.assertIn("SINUMERIK", self.read("list/merker.toml"))

    def test_families_do_not_mix(self):
        self.write("in/p.s5", LISTING)
        self.write("in/a.awl", "FUNCTION FC 1 : VOID\nBEGIN\nEND_FUNCTION\n")
        out = self.expect(PROBLEMS, "import", "in", "-o", "new").out
        self.assertIn("p.s5 is of STEP 5 and the rest of STEP 7; import it on its own", out)
        self.assertTrue((self.folder / "new/a.awl").is_file())
        self.assertFalse((self.folder / "new/p.s5").exists())
